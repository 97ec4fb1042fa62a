// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.motion.State;

/**
 * What motors and stops give at most in a step. What holds a coordinate where it is gives nothing, whatever its force; a motor that is not strong enough
 * pushes with its limit, and no other one does more than that along its way.
 */
final class SwitchedWork implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Island island;
    private final Switched[] rows;
    private final int[] nodes;

    /** By row: the angles of both bodies at the start of the step, and the force with which it pushed. */
    private final double[] angles;

    private final double[] pushed;

    SwitchedWork(Island island, Switched[] rows, int[] nodes) {
        this.island = island;
        this.rows = rows;
        this.nodes = nodes;
        angles = new double[2 * rows.length];
        pushed = new double[rows.length];
    }

    /** Notes the start of a step; false if a row may give what is not known in the end, as it acts along a way that is no angle. */
    boolean begin(double[] x) {
        boolean isKnown = true;
        for (int k = 0; k < rows.length && isKnown; k++) {
            Switched s = rows[k];
            isKnown = isIdle(s) || s.isOn && s.target() == 0 || s.isAngle(0);
            angles[2 * k] = angle(x, island.blockA[nodes[k]]);
            angles[2 * k + 1] = angle(x, island.blockB[nodes[k]]);
            pushed[k] = s.isOn ? 0 : s.force;
        }
        return isKnown;
    }

    private static boolean isIdle(Switched s) {
        return !s.isOn && s.force == 0;
    }

    private static double angle(double[] x, int block) {
        return block < 0 ? 0 : x[block + State.THETA];
    }

    /** Whether some row acts or pushes, or did at the start, so that the energy may become less than forces and joints say. */
    boolean acts() {
        boolean yes = false;
        for (int k = 0; k < rows.length; k++) {
            yes |= !isIdle(rows[k]) || pushed[k] != 0;
        }
        return yes;
    }

    /**
     * The energy that it may take to close the gaps which stops may have when they begin to act, against forces and motors that push.
     *
     * @param torque what forces give at the arms of the bodies, in sum
     */
    double leeway(double torque) {
        double turn = 0;
        double most = torque;
        for (Switched s : rows) {
            double arm = s.isAngle(0) ? 1 : island.leastSize;
            turn += s.isOn ? s.leeway() / arm : 0;
            most += s.isOn ? 0 : Math.abs(s.force) * arm;
        }
        return turn * most * island.bodies.size;
    }

    /** Whether some row keeps a speed, which is not to be changed. */
    boolean keepsSpeed() {
        boolean yes = false;
        for (int k = 0; k < rows.length; k++) {
            yes |= rows[k].isOn && rows[k].target() != 0;
        }
        return yes;
    }

    /** What they have given at most; where a row has begun to act along a way that is no angle, anything. */
    double most(double[] x) {
        double sum = 0;
        for (int k = 0; k < rows.length; k++) {
            Switched s = rows[k];
            if (isIdle(s) && pushed[k] == 0 || s.isOn && s.target() == 0) {
                continue;
            }
            if (!s.isAngle(0)) {
                return Double.POSITIVE_INFINITY;
            }
            double a = angle(x, island.blockA[nodes[k]]) - angles[2 * k];
            double b = angle(x, island.blockB[nodes[k]]) - angles[2 * k + 1];
            double turn = s.turn(a, b);
            sum += !s.isOn && s.force == pushed[k] ? s.force * turn : s.target() == 0 ? 0 : s.greatest() * Math.abs(turn);
        }
        return sum;
    }
}
