// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import java.io.Serializable;
import sim.physics.motion.State;

/**
 * The energy of a held tree of pins under a uniform field, which a step need not lose or gain: pins do no work. Velocities are
 * made longer or shorter, which is the way to the nearest ones of that energy in the metric of the masses, and pins allow them
 * then as before (Hairer, Lubich, Wanner: Geometric Numerical Integration, IV.4). The order of the method stays what it is.
 */
final class TreeEnergy implements Serializable {
    private static final long serialVersionUID = 1L;

    /** What a step may be off by, relative to the kinetic energy; one that is off by more was too long. */
    private static final double WRONG = 0.05;

    private final PinTree tree;

    TreeEnergy(PinTree tree) {
        this.tree = tree;
    }

    /**
     * Gives the tree the energy of the start of a step back.
     *
     * @param state at the start, while the links are at the end
     * @param gx the field
     * @param gy the field
     * @return false if it is off by too much; then nothing is changed
     */
    boolean restore(State state, double gx, double gy) {
        double[] l = tree.link;
        double[] x = state.x();
        double[] v = state.v();
        double kinetic = 0;
        double growth = 0;
        for (int k = 0, o = 0; k < tree.links; k++, o += PinTree.STRIDE) {
            int b = tree.block[k];
            double m = l[o + PinTree.MASS];
            double u = l[o + PinTree.U];
            double w = l[o + PinTree.V];
            double omega = l[o + PinTree.OMEGA];
            double inertia = l[o + PinTree.INERTIA];
            kinetic += m * (u * u + w * w) + inertia * omega * omega;
            growth += m * ((u - v[b]) * (u + v[b]) + (w - v[b + 1]) * (w + v[b + 1]))
                    + inertia * (omega - v[b + 2]) * (omega + v[b + 2])
                    - 2 * m * (gx * (l[o + PinTree.X] - x[b]) + gy * (l[o + PinTree.Y] - x[b + 1]));
        }
        if (!(Math.abs(growth) <= WRONG * kinetic)) {
            return false;
        }
        double scale = Math.sqrt(1 - growth / kinetic);
        for (int o = 0; kinetic > 0 && o < l.length; o += PinTree.STRIDE) {
            l[o + PinTree.U] *= scale;
            l[o + PinTree.V] *= scale;
            l[o + PinTree.OMEGA] *= scale;
            l[o + PinTree.TURNING] *= scale;
        }
        return true;
    }
}
