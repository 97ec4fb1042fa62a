// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * Lets pairs last and their bodies lie in heaps, with all that these stand on or that stands on them, and so on: depth first, with what
 * is left to do in a list of its own, as rows of thousands of bodies are as many calls deep.
 */
final class Joining implements Serializable {
    private static final long serialVersionUID = 1L;

    /** What is to be done: with a pair, or a body; and two more numbers of it. */
    private static final int ADD = 0;

    private static final int JOIN = 1;
    private static final int BEAR = 2;
    private static final int HOLD = 3;
    private static final int ALONE = 4;
    private static final int MARK = 5;
    private static final int LAST = 6;
    private static final int TASK = 3;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final RestingContacts resting;
    private final HeapBodies by;
    private final Heap heap;
    private final LargeHeaps large;
    private final Standing standing;

    private final IntList members;
    private final IntList dirty;

    /** Tasks that are left, the next one last. */
    private final IntList left = new IntList();

    Joining(
            State state,
            Trajectories trajectories,
            Motion motion,
            CollisionDetection detection,
            RestingContacts resting,
            HeapBodies by,
            Heap heap,
            Standing standing,
            IntList members,
            IntList dirty) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        this.resting = resting;
        this.by = by;
        this.heap = heap;
        this.large = heap.large;
        this.standing = standing;
        this.members = members;
        this.dirty = dirty;
    }

    /** Lets a pair last. */
    void add(int pair) {
        left.clear(); // or an exception has left something
        push(ADD, pair, 0);
        work();
    }

    /** Lets a body lie on all that it stands on or that stands on it: where one support bears it, it would never get to the others. */
    void bear(int body) {
        left.clear();
        push(BEAR, body, 0);
        work();
    }

    /** Lets a body's heap be solved anew. */
    void mark(int body) {
        by.isStill[body] = false;
        if (!by.isDirty[body] && !large.isDone(body)) {
            by.isDirty[body] = true;
            dirty.add(body);
        }
    }

    /** Ends the lasting of a body's pairs: of those that do not pass through one another, or of those that are to do so from now on. */
    void part(int body, boolean isPassing) {
        for (int k = 0; k < detection.pairs().countOf(body); k++) {
            int pair = detection.pairs().of(body, k);
            int other = detection.pairs().other(pair, body);
            if (detection.marks().isLasting(pair) && detection.marks().isIgnored(pair) == isPassing) {
                heap.lasting.end(pair);
                if (by.has(other)) {
                    mark(other);
                }
            }
        }
    }

    private void push(int what, int whom, int more) {
        left.add(more);
        left.add(whom);
        left.add(what);
    }

    private void work() {
        while (left.size > 0) {
            left.size -= TASK;
            int what = left.values[left.size + 2];
            int whom = left.values[left.size + 1];
            int more = left.values[left.size];
            switch (what) {
                case ADD -> begin(whom);
                case JOIN -> join(whom);
                case BEAR -> pushAll(standing.find(whom, heap.lasting));
                case HOLD -> hold(whom, more);
                case ALONE -> lie(whom);
                case MARK -> mark(whom);
                default -> end(whom, more);
            }
        }
    }

    private void pushAll(int[] pairs) {
        for (int k = pairs.length - 1; k >= 0; k--) {
            push(ADD, pairs[k], 0);
        }
    }

    private void begin(int pair) {
        heap.lasting.begin(pair);
        int a = detection.pairs().first(pair);
        int b = detection.pairs().second(pair);
        boolean onA = !by.has(b) && large.isDone(a) && !trajectories.isDriven(b);
        boolean onB = !by.has(a) && large.isDone(b) && !trajectories.isDriven(a);
        if (onA || onB) {
            push(LAST, pair, (onA ? 1 : 0) + (onB ? 2 : 0));
        }
        push(JOIN, b, 0);
        push(JOIN, a, 0);
    }

    /** When both bodies of a pair and all that these stand on have joined: bears that which was in no heap before. */
    private void end(int pair, int on) {
        int a = detection.pairs().first(pair);
        int b = detection.pairs().second(pair);
        boolean onA = (on & 1) != 0 && by.has(b);
        boolean onB = (on & 2) != 0 && by.has(a);
        if (onA || onB) {
            large.bear(onA ? b : a);
        }
    }

    private void join(int body) {
        by.ensure(body);
        if (state.body(body).isImmobile()) {
            return;
        }
        push(MARK, body, 0);
        if (by.lies[body]) {
            return;
        }
        push(ALONE, body, 0);
        if (trajectories.isDriven(body)) {
            IntList group = motion.companions(body);
            for (int k = 0; k < group.size; k++) {
                by.ensure(group.values[k]);
                if (!by.lies[group.values[k]]) {
                    enter(group.values[k]);
                }
            }
            push(BEAR, body, 0);
        }
    }

    private void enter(int body) {
        by.lies[body] = true;
        by.begin(body);
        by.pull[body] = 0;
        members.add(body);
    }

    /** Lets a body lie that does not do so with others. */
    private void lie(int body) {
        if (!by.lies[body]) {
            enter(body);
            push(HOLD, body, 0);
        }
    }

    /** What a body rests on bears it in the heap too: its pairs from one of them on. */
    private void hold(int body, int from) {
        for (int k = from; k < detection.pairs().countOf(body); k++) {
            if (detection.marks().isHeld(detection.pairs().of(body, k))) {
                push(HOLD, body, k + 1);
                push(ADD, detection.pairs().of(body, k), 0);
                return;
            }
        }
        resting.forget(body);
        push(BEAR, body, 0);
    }
}
