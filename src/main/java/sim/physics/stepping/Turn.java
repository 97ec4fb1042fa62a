// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import sim.physics.constraint.TieRows;
import sim.physics.internal.Softness;
import sim.physics.motion.SpringRows;
import sim.physics.motion.State;
import sim.physics.motion.SteppedForces;
import sim.physics.motion.SurfaceRows;

/** Solves friction with the plane, stiff springs, joints and contacts one after the other: once, and where something is new some times more. */
final class Turn implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Solutions of a substep where something is new, of whose impulses nothing is known. */
    private static final int COLD = 8;

    private final SurfaceRows surface;
    private final SpringRows springs;
    private final TieRows ties;
    private final ContactRows rows;
    private final ContactSolver contacts;
    private final PressingContacts pressing;
    private final Newcomers newcomers;

    /** Whether there are joints, and whether friction with the plane acts on a body. */
    private boolean isTied;

    private boolean isRubbed;

    Turn(State state, Poses poses, SteppedForces forces, TieRows ties, ContactRows rows, ContactSolver contacts, Newcomers newcomers) {
        surface = forces.surface();
        springs = forces.springs();
        this.ties = ties;
        this.rows = rows;
        this.contacts = contacts;
        pressing = new PressingContacts(state, poses, ties.trees().pressed(), rows);
        this.newcomers = newcomers;
    }

    /** Begins a step. */
    void begin(boolean isTied) {
        this.isTied = isTied;
        isRubbed = !surface.isEmpty();
        contacts.pinned().find(isTied);
        if (isTied) {
            pressing.begin();
        }
        if (newcomers.any()) {
            newcomers.find(rows, ties, springs);
        }
    }

    /** Takes note of how bodies move before a substep, in which nothing has acted. */
    void note() {
        if (isRubbed) {
            surface.note();
        }
    }

    /** Gives the bodies the impulses of the substep before. */
    void start(double[] sudden, double d) {
        if (isRubbed) {
            surface.start(d);
        }
        springs.start();
        if (isTied) {
            ties.start();
        }
        contacts.start(sudden);
    }

    /**
     * Solves all.
     *
     * @param joint how the places of joints are regained
     * @param contact how depths are
     * @param d substep
     */
    void solve(Softness joint, Softness contact, boolean regains, double d) {
        if (isRubbed) {
            surface.solve(d, regains);
        }
        springs.solve();
        if (isTied) {
            pressing.note();
            ties.solve(joint, d);
        }
        contacts.solve(contact, regains, d);
        if (isTied) {
            pressing.solve(joint, d);
        }
        for (int m = 1; newcomers.any() && m < COLD; m++) {
            solveNew(joint, contact, regains, d);
        }
    }

    private void solveNew(Softness joint, Softness contact, boolean regains, double d) {
        boolean[] marks = newcomers.marks;
        surface.solve(marks, d);
        springs.solve(marks);
        if (isTied) {
            ties.solveAll(marks, joint, d);
        }
        contacts.solve(newcomers.pairs, marks, contact, regains, d);
    }
}
