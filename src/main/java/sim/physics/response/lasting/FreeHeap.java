// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.internal.IntList;
import sim.physics.motion.Trajectories;

/**
 * Heaps of bodies that nothing drives or ties. Where their solution is not found, points that are hardly open count as closed.
 * Where that does not help, and they are large, they are solved roughly for some steps: then their bodies may be 10⁻⁴ of their
 * size deep in one another, and part again when a solution is found.
 */
final class FreeHeap implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Solutions for which points that are hardly open count as closed, once without that there was none. */
    private static final int RELENTS = 1000;

    /** Times that a heap may not be solved in a step, before little work is spent on it. */
    private static final int FAILURES = 3;

    private final Trajectories trajectories;
    private final CollisionDetection detection;
    private final HeapBodies by;
    private final HeapSystem system;
    private final HeapNotes notes;
    private final BodyScale scales;

    FreeHeap(
            Trajectories trajectories,
            CollisionDetection detection,
            HeapBodies by,
            HeapSystem system,
            HeapNotes notes,
            BodyScale scales) {
        this.trajectories = trajectories;
        this.detection = detection;
        this.by = by;
        this.system = system;
        this.notes = notes;
        this.scales = scales;
    }

    /** Begins to take in the points of a heap. */
    void begin(IntList heap) {
        if (by.isRough(heap, trajectories.step())) {
            system.roughen();
        }
        for (int k = 0; k < heap.size; k++) {
            if (by.failures[heap.values[k]] >= FAILURES) {
                system.spare();
            }
        }
    }

    /** Solves a heap whose points have been taken in; false if the impulses are not right. */
    boolean solve(IntList heap, double scale) {
        int relents = 0;
        for (int k = 0; k < heap.size; k++) {
            relents = Math.max(relents, by.relents[heap.values[k]] - 1);
        }
        if (relents > 0) {
            system.relent();
        }
        boolean done = system.solve(scale, true);
        if (!done && relents <= 0 && !system.isRough() && !system.isSpared()) {
            relents = RELENTS;
            system.again();
            system.relent();
            done = system.solve(scale, true);
        }
        for (int k = 0; k < heap.size; k++) {
            by.relents[heap.values[k]] = relents;
            by.failures[heap.values[k]] += done ? 0 : 1;
        }
        if (!done && !system.isRough() && system.size() > HeapSolver.MANY) {
            by.roughen(heap, trajectories.step());
            notes.roughen(detection, scales);
        }
        return done;
    }
}
