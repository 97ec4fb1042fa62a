// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import sim.physics.collision.CollisionDetection;
import sim.physics.collision.broad.BruteForce;
import sim.physics.collision.broad.CellGrid;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;
import sim.physics.scenes.SceneData;

/**
 * A step with nothing in it but what a gas needs: free flight, the search for impacts, and the elastic impulse (16)–(24) of
 * two bodies at one point. No forces, integrators, constraints, friction, restitution, rest, listeners, filters of authors,
 * changes by authors, audit, threads, queries: what {@code PhysicsEngine} takes more is the price of all that unused.
 */
final class BareStep {
    /** As in the engine. */
    private static final int CROWD = 50;

    private final State state = new State();
    private final Trajectories trajectories = new Trajectories();
    private final CollisionDetection detection;
    private final Manifold contact = new Manifold();
    private final double h;
    private long steps;
    private long impacts;

    BareStep(SceneData scene) {
        h = scene.dt();
        for (Body body : OwnRunner.bodies(scene)) {
            state.add(body);
        }
        detection = new CollisionDetection(
                state, trajectories, state.bodyCount() < CROWD ? new BruteForce() : new CellGrid());
        trajectories.begin(0, h);
        detection.begin(0, h);
        trajectories.ensure(state.size());
        for (int body = 0; body < state.size(); body++) {
            trajectories.anchor(body, 0, state);
            detection.add(body, 0);
        }
    }

    long impacts() {
        return impacts;
    }

    double kineticEnergy() {
        double sum = 0;
        for (int body = 0; body < state.size(); body++) {
            sum += state.body(body).isFixed() ? 0 : state.body(body).kineticEnergy();
        }
        return sum;
    }

    void step() {
        state.settle(false);
        if (steps > 0) {
            trajectories.begin(steps, h);
            detection.begin(steps, h);
        }
        detection.look();
        while (detection.hasEvent()) {
            double tau = detection.nextTime();
            IntList touching = detection.nextImpacts(null); // nothing is driven
            for (int k = 0; k < touching.size; k++) {
                collide(touching.values[k], tau);
            }
        }
        state.lag(trajectories); // as in the engine, nobody reads the vectors
        steps++;
    }

    private void collide(int pair, double tau) {
        int a = detection.pairs().first(pair);
        int b = detection.pairs().second(pair);
        trajectories.bring(a, tau);
        trajectories.bring(b, tau);
        detection.narrowPhase().contact(pair, tau, contact);
        impacts++;
        for (int point = 0; point < contact.count; point++) {
            bounce(a, b, point);
        }
        boolean both = !state.body(a).isFixed() && !state.body(b).isFixed();
        if (!state.body(a).isFixed()) {
            detection.moved(a, tau, false, -1);
        }
        if (!state.body(b).isFixed()) {
            detection.moved(b, tau, false, both ? pair : -1);
        }
    }

    private void bounce(int a, int b, int point) {
        double[] w = state.w().values();
        double[] m = trajectories.data();
        int oa = a * Trajectories.STRIDE + Trajectories.VX;
        int ob = b * Trajectories.STRIDE + Trajectories.VX;
        double nx = contact.nx;
        double ny = contact.ny;
        double leverA = contact.roundA ? 0 : contact.rAx[point] * ny - contact.rAy[point] * nx;
        double leverB = contact.roundB ? 0 : contact.rBx[point] * ny - contact.rBy[point] * nx;
        double speed = (m[ob] - m[oa]) * nx + (m[ob + 1] - m[oa + 1]) * ny + (m[ob + 2] * leverB - m[oa + 2] * leverA);
        double wA = w[State.BLOCK * a];
        double wB = w[State.BLOCK * b];
        double iA = w[State.BLOCK * a + State.THETA];
        double iB = w[State.BLOCK * b + State.THETA];
        if (speed >= 0) {
            return;
        }
        double j = -2 * speed / ((wA + wB) + (iA * leverA * leverA + iB * leverB * leverB));
        m[oa] -= wA * j * nx;
        m[oa + 1] -= wA * j * ny;
        m[oa + 2] -= iA * j * leverA;
        m[ob] += wB * j * nx;
        m[ob + 1] += wB * j * ny;
        m[ob + 2] += iB * j * leverB;
    }
}
