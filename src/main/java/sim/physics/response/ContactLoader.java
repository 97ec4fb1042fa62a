// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.util.Objects;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.narrow.Manifold;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;
import sim.physics.response.lasting.ContactPoint;
import sim.physics.response.lasting.ContactPoints;

/** Loads what an impact's equations need of one point of a manifold: masses, velocities, levers, coefficients. */
final class ContactLoader implements ContactPoints {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Trajectories trajectories;
    private final CollisionDetection detection;
    private final Impact impact = new Impact();
    private final Listeners listeners;
    private PairRule restitutionRule = PairRule.MINIMUM;
    private PairRule frictionRule = PairRule.GEOMETRIC_MEAN;

    /** One for an engine whose listeners are asked and told of impacts. */
    ContactLoader(State state, Trajectories trajectories, CollisionDetection detection, Listeners listeners) {
        this.state = state;
        this.trajectories = trajectories;
        this.detection = detection;
        this.listeners = listeners;
    }

    @Override
    public boolean areForeseen() {
        return listeners.isEmpty();
    }

    void setRules(PairRule restitution, PairRule friction) {
        Objects.requireNonNull(restitution, "restitution");
        Objects.requireNonNull(friction, "friction");
        restitutionRule = restitution;
        frictionRule = friction;
    }

    /** Loads a point of two bodies at their anchors. */
    void load(Manifold m, int a, int b, int point, Impact c) {
        double[] w = state.w().values();
        double[] d = trajectories.data();
        int oa = a * Trajectories.STRIDE;
        int ob = b * Trajectories.STRIDE;
        c.wA = w[State.BLOCK * a];
        c.wB = w[State.BLOCK * b];
        c.iA = w[State.BLOCK * a + State.THETA];
        c.iB = w[State.BLOCK * b + State.THETA];
        c.vAx = d[oa + Trajectories.VX];
        c.vAy = d[oa + Trajectories.VY];
        c.omegaA = d[oa + Trajectories.OMEGA];
        c.vBx = d[ob + Trajectories.VX];
        c.vBy = d[ob + Trajectories.VY];
        c.omegaB = d[ob + Trajectories.OMEGA];
        c.nx = m.nx;
        c.ny = m.ny;
        c.rAx = m.rAx[point];
        c.rAy = m.rAy[point];
        c.rBx = m.rBx[point];
        c.rBy = m.rBy[point];
        c.setLevers(m.roundA, m.roundB);
        c.restitution = restitution(a, b);
        c.friction = friction(a, b);
        c.belt = belt(a, b);
        c.allowance = 0;
    }

    /** What sticks is held by friction without bounds. */
    @Override
    public void load(Manifold m, int pair, int k, ContactPoint point) {
        load(m, detection.pairs().first(pair), detection.pairs().second(pair), k, impact);
        impact.describe(point);
        if (detection.marks().isSticky(pair)) {
            point.friction = RoughImpact.STICKS;
        }
    }

    @Override
    public double restitution(int a, int b) {
        return restitutionRule.of(state.restitution(a), state.restitution(b));
    }

    /** The coefficient of friction of a contact of two bodies. */
    double friction(int a, int b) {
        return frictionRule.of(state.friction(a), state.friction(b));
    }

    /** Both run counter-clockwise: A's surface along the tangent n⊥, B's against it. */
    double belt(int a, int b) {
        return 0 - (state.beltSpeed(a) + state.beltSpeed(b));
    }
}
