// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * The velocities of a heap's bodies before and after it is solved. When it is solved anew within the time for which it had been,
 * because something has struck it, all that forces and contacts were to give for the time that is left is taken back first: so
 * contacts press as they did, and only those near the impact have to change. Without forces nothing is taken back: contacts have
 * given all at once. Bodies on which that has no effect keep their courses.
 */
final class HeapCourses implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Trajectories trajectories;
    private final HeapBodies by;

    /** Velocities that the bodies have, and without what they are given from now on; 3 per body. */
    private double[] before = {};

    private double[] without = {};

    /** Whether bodies have got others at once, so that all that is known of their courses is out of date. */
    private boolean haveStruck;

    HeapCourses(Trajectories trajectories, HeapBodies by) {
        this.trajectories = trajectories;
        this.by = by;
    }

    /** Begins with a heap. */
    void begin() {
        haveStruck = false;
    }

    /** Gives the bodies of a heap the velocities with which they part from an impact, as those that they had. */
    void strike(IntList heap, double[] v) {
        haveStruck = true;
        for (int k = 0; k < heap.size; k++) {
            System.arraycopy(v, 3 * k, trajectories.data(), heap.values[k] * Trajectories.STRIDE + Trajectories.VX, State.BLOCK);
            System.arraycopy(v, 3 * k, before, 3 * k, State.BLOCK);
        }
    }

    /** Takes in a body's velocity, and gives it to a system; where some is for the time that is left, without that. */
    void enter(int k, int body, double tau, double[] v, boolean isPaid) {
        if (before.length < 3 * k + 3) {
            before = Arrays.copyOf(before, 6 * k + 6);
            without = Arrays.copyOf(without, 6 * k + 6);
        }
        int o = body * Trajectories.STRIDE + Trajectories.VX;
        System.arraycopy(trajectories.data(), o, before, 3 * k, State.BLOCK);
        System.arraycopy(before, 3 * k, without, 3 * k, State.BLOCK);
        if (isPaid) {
            by.unpay(body, tau, without, 3 * k);
        }
        System.arraycopy(without, 3 * k, v, 3 * k, State.BLOCK);
    }

    /** The velocities that the bodies had. */
    double[] before() {
        return before;
    }

    /** {@return the same without what they have been given for the time that is left} */
    double[] without() {
        return without;
    }

    /**
     * Lets a body that has got what forces give it go on as it did, if that is right but for some rounding; it may be so until another time
     * than that for which it was given.
     */
    boolean keeps(int k, int body, double tau, double until, double[] v, double none) {
        boolean keeps = !haveStruck
                && by.paidUntil[body] > tau
                && Math.abs(v[3 * k] - before[3 * k]) <= none
                && Math.abs(v[3 * k + 1] - before[3 * k + 1]) <= none
                && Math.abs(v[3 * k + 2] - before[3 * k + 2]) * trajectories.radius(body) <= none;
        if (keeps && by.paidUntil[body] != until) {
            by.pay(body, tau, without, before, 3 * k);
            by.paidUntil[body] = until;
        }
        return keeps;
    }

    /** Gives a body the velocity that has been found. */
    void set(int k, int body, double tau, double[] v, boolean isHalf) {
        by.pay(body, tau, without, v, 3 * k);
        by.isHalf[body] = isHalf;
        System.arraycopy(v, 3 * k, trajectories.data(), body * Trajectories.STRIDE + Trajectories.VX, State.BLOCK);
    }
}
