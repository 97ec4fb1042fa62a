// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.internal.IntList;
import sim.physics.motion.Trajectories;

/**
 * Which heaps are large ones, and which of these are solved roughly. If the exact solution of a large heap that moves is hard to find, it is
 * solved once for a whole step from then on, and not to rounding: errors may bring its bodies 10⁻³ of their size into one another,
 * which the next steps regain, and a step of hundreds of bodies costs a twentieth. What may touch within the step is foreseen
 * ({@link Foresight}). Where something happens in it all the same, the heap is solved anew, but not often; from then on what meets takes its
 * impact alone. Every so many steps the exact solution is tried again, by which piles come to rest.
 */
final class LargeHeaps implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Bodies of a large heap at least. */
    private static final int MANY = 32;

    /** Times that it is solved in a step. */
    private static final int MOST = 3;

    /** Steps after which an exact solution is tried again. */
    private static final int PAUSE = 16;

    /** Times that it is solved exactly in a step. */
    private static final int MOST_EXACT = 30;

    /** Part of a fair error that an exact solution may leave. */
    private static final double SMALL = 0.03;

    /** Easy solutions that make up for a hard one; how many of them may be missing, and how many are when it is tried again. */
    private static final int HARD = 5;

    private static final int MOST_HARD = 20;
    private static final int FEWER = 16;

    private final Trajectories trajectories;
    private final HeapBodies by;
    private final Foresight foresight;
    private boolean isDeep;
    private final IntList near = new IntList();

    LargeHeaps(Trajectories trajectories, HeapBodies by, Foresight foresight) {
        this.trajectories = trajectories;
        this.by = by;
        this.foresight = foresight;
    }

    /** Whether a heap of so many bodies is so large that its exact solution may take too long. */
    static boolean isLarge(int bodies) {
        return bodies >= MANY;
    }

    /** Whether a heap is to be solved roughly: not long ago the exact solution of one of its bodies' heap has taken too long. */
    boolean isRough(IntList heap) {
        boolean yes = false;
        for (int k = 0; k < heap.size; k++) {
            yes |= trajectories.step() < by.roughUntil[heap.values[k]];
        }
        return yes; // also of what is left of a large one
    }

    /** Whether the heap of a body is solved roughly, or was when it was solved last. */
    boolean isRough(int body) {
        return by.solvedIn[body] > 0 || trajectories.step() < by.roughUntil[body];
    }

    /** Whether one of some bodies was in a heap that was solved roughly not long ago. */
    boolean wasRough(IntList heap) {
        boolean yes = false;
        for (int k = 0; k < heap.size; k++) {
            double until = by.roughUntil[heap.values[k]];
            yes |= until > 0 && trajectories.step() < until + PAUSE;
        }
        return yes;
    }

    /**
     * Whether pairs of a heap that is solved exactly may be as deep as if it was not, since that was not long ago: what would be regained of their
     * gaps would move a pile that all but stands, and again each time that the exact solution is tried.
     */
    boolean isLax(IntList heap) {
        return isLarge(heap.size) && wasRough(heap);
    }

    /** Judges by an exact solution whether those of a heap take too long from now on, if it is a large one; false if it is not right. */
    boolean judge(IntList heap, HeapSystem system, boolean done, double fastest) {
        if (!isLarge(heap.size)) {
            return true;
        }
        boolean isRight = done && system.tolerance().error() <= SMALL * system.tolerance().fair();
        int effort = isRight && system.wasEasy() ? -1 : fastest <= system.tolerance().fair() ? 1 : HARD;
        boolean goesOn = true;
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            by.exact[body] = by.exactIn[body] == trajectories.step() ? by.exact[body] + 1 : 1;
            by.exactIn[body] = trajectories.step();
            by.hard[body] = Math.max(0, by.hard[body] + effort);
            goesOn &= by.hard[body] <= MOST_HARD && by.exact[body] <= MOST_EXACT;
        }
        for (int k = 0; k < heap.size && !goesOn; k++) {
            by.roughUntil[heap.values[k]] = trajectories.step() + PAUSE;
            by.hard[heap.values[k]] = FEWER;
        }
        return isRight;
    }

    /** Forgets what was hard of a body's heap: another one may get its number. */
    void forget(int body) {
        if (by.knows(body)) {
            by.roughUntil[body] = 0;
            by.hard[body] = 0;
        }
    }

    /** Whether a body was in a large heap that was solved some steps ago; 0: in this one. */
    private boolean wasSolved(int body, int ago) {
        return by.has(body) && by.solvedIn[body] == trajectories.step() + 1 - ago;
    }

    /** Whether a body is in a large heap that is not solved any more in this step. */
    boolean isDone(int body) {
        return wasSolved(body, 0) && by.solutions[body] >= MOST;
    }

    /** Whether one of some bodies is. */
    private boolean isAnyDone(IntList bodies) {
        boolean yes = false;
        for (int k = 0; k < bodies.size; k++) {
            yes |= isDone(bodies.values[k]);
        }
        return yes;
    }

    /** Takes note of the gap of a pair in the heap that is being solved. */
    void meet(double gap, double size) {
        isDeep |= gap < -HeapGaps.fairDepth(size);
    }

    /** Takes note that a heap begins to be solved. */
    void begin() {
        isDeep = false;
    }

    /** Takes note that the heap of a body has been solved, roughly or not; as long as pairs are deep they are to part first. */
    void solved(int body, boolean isRough) {
        if (isRough && isDeep) {
            by.roughUntil[body] = Math.max(by.roughUntil[body], trajectories.step() + 2);
        }
        by.solutions[body] = wasSolved(body, 0) ? by.solutions[body] + 1 : 1;
        by.solvedIn[body] = isRough ? trajectories.step() + 1 : 0;
    }

    /** Lets a body go on as it does until the step is over. */
    void leave(int body) {
        by.solvedIn[body] = trajectories.step() + 1;
        by.solutions[body] = MOST;
        by.isDirty[body] = false;
    }

    /** Lets the bodies of a heap do so if some of them are of one that has been solved for the step. */
    boolean leaves(IntList heap) {
        boolean yes = isAnyDone(heap);
        for (int k = 0; k < heap.size && yes; k++) {
            leave(heap.values[k]);
            by.place[heap.values[k]] = 0;
        }
        return yes;
    }

    /** Lets a body that has just come to lie on a large heap go on with what forces have given it so far: from now on it is borne. */
    void bear(int body) {
        by.paidUntil[body] = trajectories.h();
        by.paidFrom[body] = trajectories.offset(body);
        for (int c = 0; c < 3; c++) {
            by.paid[3 * body + c] = 0;
        }
        leave(body);
    }

    /** Whether a pair that does not touch yet is to be solved with its heap. */
    boolean foresees(int pair) {
        return foresight.has(pair);
    }

    /** The pairs that bodies of large heaps may close in the step that begins; valid until the next call. */
    IntList foresee(IntList bodies) {
        near.clear();
        for (int k = 0; k < bodies.size; k++) {
            if (wasSolved(bodies.values[k], 1)) {
                foresight.look(bodies.values[k], near);
            }
        }
        return near;
    }
}
