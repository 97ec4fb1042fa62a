// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;
import sim.physics.shape.Circle;

/** How large bodies are, and how fast they leave the tangents of their contacts. */
final class BodyScale implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Bend that counts at most, relative to the smaller body. */
    private static final double MOST_BEND = 1e-3;

    private final State state;
    private final Trajectories trajectories;

    BodyScale(State state, Trajectories trajectories) {
        this.state = state;
        this.trajectories = trajectories;
    }

    /** How fast two bodies turn and slide on one another, as a rate at which their contact bends out of its tangent. */
    double bending(int a, int b) {
        double[] d = trajectories.data();
        int oa = a * Trajectories.STRIDE;
        int ob = b * Trajectories.STRIDE;
        double vx = d[ob + Trajectories.VX] - d[oa + Trajectories.VX];
        double vy = d[ob + Trajectories.VY] - d[oa + Trajectories.VY];
        double turnA = isRound(a) ? 0 : Math.abs(d[oa + Trajectories.OMEGA]);
        double turn = Math.max(turnA, isRound(b) ? 0 : Math.abs(d[ob + Trajectories.OMEGA]));
        double slide = Math.sqrt(vx * vx + vy * vy) / size(a, b);
        return Math.sqrt(turn * (turn + slide));
    }

    /** Whether a body looks the same when it turns. */
    boolean isRound(int body) {
        return state.body(body).getShape() instanceof Circle;
    }

    /** Radius of the smaller one of two bodies, of which one may be fixed. */
    double size(int a, int b) {
        double first = state.body(a).isImmobile() ? Double.MAX_VALUE : radius(a);
        double second = state.body(b).isImmobile() ? Double.MAX_VALUE : radius(b);
        return Math.min(first, second);
    }

    /** The largest speed of a body's points, nearly, for a velocity. */
    double speed(int body, double[] v, int at) {
        return speed(body, v[at], v[at + 1], v[at + 2]);
    }

    /** The largest speed of a body's points, nearly, for the difference of two velocities. */
    double change(int body, double[] v, double[] from, int at) {
        return speed(body, v[at] - from[at], v[at + 1] - from[at + 1], v[at + 2] - from[at + 2]);
    }

    private double speed(int body, double vx, double vy, double omega) {
        return Math.max(Math.max(Math.abs(vx), Math.abs(vy)), radius(body) * Math.abs(omega));
    }

    /**
     * How large three values of a body are, a turn as a way at its radius of gyration, so that both have one unit.
     *
     * @param w inverse masses and moments of inertia, 2 per body
     * @param u values, 3 per body
     */
    static double largest(double[] w, double[] u, int place) {
        double turn = w[2 * place + 1] > 0 ? Math.sqrt(w[2 * place] / w[2 * place + 1]) * Math.abs(u[3 * place + 2]) : 0;
        return Math.max(turn, Math.max(Math.abs(u[3 * place]), Math.abs(u[3 * place + 1])));
    }

    double radius(int body) {
        return trajectories.radius(body);
    }

    /** What the turning and sliding of a loaded point's bodies may take of their gap in a time. */
    double bend(Manifold manifold, ContactPoint point, int a, int b, double h) {
        double turnA = manifold.roundA ? 0 : h * Math.abs(point.omegaA);
        double turnB = manifold.roundB ? 0 : h * Math.abs(point.omegaB);
        double spinA = manifold.roundA ? point.omegaA * point.armA : 0; // a disc's spin moves no normal
        double spinB = manifold.roundB ? point.omegaB * point.armB : 0;
        double slide = h * Math.abs(point.slip + spinA - spinB);
        return bend(turnA, radius(a), turnB, radius(b), slide, mostBend(a, b));
    }

    /** How far forces take two bodies in a step, relative to their size. */
    double roam(int a, int b, double pull) {
        return trajectories.h() * trajectories.h() * pull / size(a, b);
    }

    /**
     * What turning and sliding may take of a gap beyond what is foreseen where points are followed as their bodies turn: of third order, unless
     * the step is so long that bodies leave their places in it.
     *
     * @param bend what they may take of it where points are not followed
     * @param roam how far they go in the step
     */
    double bendOfTurned(ContactPoint point, double bend, double roam) {
        double turn = trajectories.h() * Math.max(Math.abs(point.omegaA), Math.abs(point.omegaB));
        return Math.min(1, turn + roam) * bend;
    }

    /** The bend of a contact that counts at most. */
    double mostBend(int a, int b) {
        return MOST_BEND * size(a, b);
    }

    /** What the turns of two bodies, rad, and the way that they slide on one another may take of their gap. */
    static double bend(double turnA, double radiusA, double turnB, double radiusB, double slide, double most) {
        double bend = 0.5 * (turnA == 0 ? 0 : turnA * turnA * radiusA) + 0.5 * (turnB == 0 ? 0 : turnB * turnB * radiusB);
        return Math.min(bend + slide * (turnA + turnB), most);
    }

    /** The largest speed of bodies, three velocities for each of them. */
    double fastest(IntList bodies, double[] v) {
        double most = 0;
        for (int k = 0; k < bodies.size; k++) {
            most = Math.max(most, speed(bodies.values[k], v, 3 * k));
        }
        return most;
    }

    /** The same where they are now on their paths. */
    double fastestNow(IntList bodies) {
        double most = 0;
        for (int k = 0; k < bodies.size; k++) {
            int o = bodies.values[k] * Trajectories.STRIDE + Trajectories.VX;
            most = Math.max(most, speed(bodies.values[k], trajectories.data(), o));
        }
        return most;
    }
}
