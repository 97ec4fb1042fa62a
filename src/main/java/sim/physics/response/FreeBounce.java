// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import sim.physics.collision.narrow.Manifold;
import sim.physics.collision.narrow.NarrowPhase;
import sim.physics.internal.IntList;
import sim.physics.internal.Tolerances;
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
    private final NarrowPhase narrowPhase;
    private final ContactLoader loader;
    private transient Manifold manifold;

    FreeBounce(State state, Trajectories trajectories, NarrowPhase narrowPhase, ContactLoader loader) {
        this.state = state;
        this.trajectories = trajectories;
        this.narrowPhase = narrowPhase;
        this.loader = loader;
    }

    /**
     * Gives two bodies the velocities after their impact.
     *
     * @param pair number of their pair
     * @param a body A, which nothing has ever accelerated
     * @param b body B, likewise
     * @param tau offset in the present step
     * @param changed takes those of them that are not fixed; neither if there is more to the impact, and nothing is solved
     */
    void solve(int pair, int a, int b, double tau, IntList changed) {
        if (loader.restitution(a, b) != 1 || loader.friction(a, b) != 0) {
            return;
        }
        if (manifold == null) {
            manifold = new Manifold();
        }
        trajectories.bring(a, tau);
        trajectories.bring(b, tau);
        narrowPhase.contact(pair, tau, manifold);
        double deepest = -Tolerances.OVERLAP * Math.min(trajectories.radius(a), trajectories.radius(b));
        if (manifold.count == 1 && manifold.gap >= deepest) {
            solve(a, b, manifold, changed);
        }
    }

    /** The gap at the impact that was solved last. */
    double gap() {
        return manifold.gap;
    }

    private void solve(int a, int b, Manifold m, IntList changed) {
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
