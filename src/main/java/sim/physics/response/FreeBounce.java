// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * The elastic impact of two free bodies at one point, without friction: what a gas is made of. It is (16)–(24) with e = 1 and
 * nothing else, written from the bodies' values to the bodies' values, to the bits of {@link TwoBodyImpulse}.
 *
 * <pre>
 *   j = −2 v·n / K,   K = 1/mA + 1/mB + (rA⊥·n)²/IA + (rB⊥·n)²/IB
 * </pre>
 */
final class FreeBounce implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Trajectories trajectories;

    FreeBounce(State state, Trajectories trajectories) {
        this.state = state;
        this.trajectories = trajectories;
    }

    /** Gives two bodies at their anchors the velocities after the impact, and lists those of them that are not fixed. */
    void solve(int a, int b, Manifold m, IntList changed) {
        double[] w = state.w().values();
        double[] d = trajectories.data();
        int oa = a * Trajectories.STRIDE;
        int ob = b * Trajectories.STRIDE;
        double nx = m.nx;
        double ny = m.ny;
        double leverA = m.roundA ? 0 : m.rAx[0] * ny - m.rAy[0] * nx;
        double leverB = m.roundB ? 0 : m.rBx[0] * ny - m.rBy[0] * nx;
        double wA = w[State.BLOCK * a];
        double wB = w[State.BLOCK * b];
        double iA = w[State.BLOCK * a + State.THETA];
        double iB = w[State.BLOCK * b + State.THETA];
        double vAx = d[oa + Trajectories.VX];
        double vAy = d[oa + Trajectories.VY];
        double omegaA = d[oa + Trajectories.OMEGA];
        double vBx = d[ob + Trajectories.VX];
        double vBy = d[ob + Trajectories.VY];
        double omegaB = d[ob + Trajectories.OMEGA];
        double approach = (vBx - vAx) * nx + (vBy - vAy) * ny + (omegaB * leverB - omegaA * leverA);
        double mobility = (wA + wB) + (iA * leverA * leverA + iB * leverB * leverB);
        double j = -2 * approach / mobility;
        if (wA != 0) {
            d[oa + Trajectories.VX] = vAx - wA * (j * nx);
            d[oa + Trajectories.VY] = vAy - wA * (j * ny);
            d[oa + Trajectories.OMEGA] = omegaA - iA * (j * leverA);
            changed.add(a);
        }
        if (wB != 0) {
            d[ob + Trajectories.VX] = vBx + wB * (j * nx);
            d[ob + Trajectories.VY] = vBy + wB * (j * ny);
            d[ob + Trajectories.OMEGA] = omegaB + iB * (j * leverB);
            changed.add(b);
        }
    }
}
