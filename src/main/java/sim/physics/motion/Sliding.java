// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;

/**
 * Advances one body under surface friction, up to the instant at which it comes to rest.
 *
 * <p>The directions of friction depend on the ratio of sliding to spinning, which changes ever faster in time as the
 * body comes to rest. So the step is divided: each part is a small share of the time that the body has left, and the
 * last, negligible one is at constant deceleration and ends exactly at rest.
 */
final class Sliding implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of the time to rest that is integrated at once; smaller: more accurate near the stop, and slower. */
    private static final double SHARE = 1.0 / 16;

    /** The same, and the next, for bodies that others press on: the forces that do so are of first order themselves. */
    private static final double PRESSED_SHARE = 0.5;

    private static final double PRESSED_LAST = 1e-4;

    /** What an even deceleration may be off by its estimate, which is two to five times what it is off, in tolerances. */
    private static final double EVEN = 2;

    /** Time to rest, relative to the step, from which the deceleration is taken as constant. */
    private static final double LAST = 1e-7;

    /** Time to rest, relative to the step, that rounding does not tell from none. */
    private static final double NOTHING = 1e-15;

    /** Parts of a way until they get longer. */
    private static final int PATIENCE = 500;

    private static final int SET_OFF_ITERATIONS = 20;

    private final Motion motion;
    private final State state;
    private final Path path;
    private final double[] start = new double[2 * State.BLOCK];

    Sliding(Motion motion, State state, Path path) {
        this.motion = motion;
        this.state = state;
        this.path = path;
    }

    /** Returns the time advanced: all of it, or less if the body comes to rest and is held there. */
    double advance(Body body, SurfaceFriction surface, IntList group, double t, double length, boolean isPressed) {
        int b = State.BLOCK * body.index();
        System.arraycopy(state.x(), b, start, 0, State.BLOCK);
        System.arraycopy(state.v(), b, start, State.BLOCK, State.BLOCK);
        path.ensure(State.BLOCK * state.size());
        if (body.kineticEnergy() == 0 && stop(body, surface, group, 0, t)) {
            standStill(b);
            return length;
        }
        if (body.kineticEnergy() == 0) {
            setOff(group, b, t, LAST * LAST * length);
        }
        if (timeToRest(body, group, t) <= NOTHING * motion.step() && stop(body, surface, group, 0, t)) {
            standStill(b); // so slow that the instant of its rest is this one, where it would never arrive
            return length;
        }
        double done = 0;
        double share = isPressed ? PRESSED_SHARE : motion.getIntegrator() instanceof AdaptiveIntegrator chosen ? chosen.shareOfStop() : SHARE;
        double last = (isPressed ? PRESSED_LAST : LAST) * motion.step();
        double least = share * last;
        for (int parts = 0; done < length; parts++) {
            least *= parts < PATIENCE ? 1 : 2; // it creeps: neither held, nor set in motion
            double rest = timeToRest(body, group, t + done);
            if ((rest <= last || rest <= length - done && isEven(body, rest)) && stop(body, surface, group, Math.min(rest, length - done), t + done)) {
                done += Math.min(rest, length - done);
                break;
            }
            double left = length - done;
            double part = Math.min(left, Math.max(share * rest, least));
            path.stages.isToRest = true;
            try {
                DrivenMotion.cover(motion, state, group, t + done, part, path);
            } finally {
                path.stages.isToRest = false;
            }
            done = part == left ? length : done + part;
            if (!isPressed && rest < Double.POSITIVE_INFINITY && motion.getIntegrator() instanceof AdaptiveIntegrator chosen) {
                // what is left is the same motion on a smaller scale: what was allowed of the rest is allowed again
                share = Math.max(share, Math.min(chosen.mostOfStop(), path.proposed[group.values[0]] / rest));
            }
        }
        for (int c = 0; c < State.BLOCK; c++) {
            double mean = (state.x()[b + c] - start[c]) / done;
            path.cubic(b + c, mean, start[State.BLOCK + c], state.v()[b + c], done);
        }
        return done;
    }

    /**
     * Sets a body that was at rest and is not held any more in motion by a negligible velocity along its first
     * acceleration, so that friction has a direction: a = W (load + friction along a).
     */
    private void setOff(IntList group, int b, double t, double instant) {
        double[] v = state.v();
        for (int k = 0; k < SET_OFF_ITERATIONS; k++) {
            motion.acceleration(group, t, path.stage);
            for (int c = 0; c < State.BLOCK; c++) {
                v[b + c] = instant * path.stage[b + c];
            }
        }
    }

    private void standStill(int b) {
        for (int c = 0; c < State.BLOCK; c++) {
            path.straight(b + c);
        }
    }

    /** The time in which the present power of all forces would use up the kinetic energy: 2 E / P. */
    private double timeToRest(Body body, IntList group, double t) {
        int b = State.BLOCK * body.index();
        double[] v = state.v();
        double energy = body.kineticEnergy();
        if (energy == 0) {
            return Double.POSITIVE_INFINITY; // at rest and not held: it begins to move
        }
        motion.acceleration(group, t, path.stage);
        double power = body.getMass() * (path.stage[b] * v[b] + path.stage[b + 1] * v[b + 1])
                + body.getInertia() * path.stage[b + 2] * v[b + 2];
        return power >= 0 ? Double.POSITIVE_INFINITY : -2 * energy / power;
    }

    /**
     * Whether an even deceleration brings the body to rest to what the integrator may be off. By the accelerations that it has
     * now its velocity would not quite be zero at the end: half the way of that is what the places differ by.
     */
    private boolean isEven(Body body, double rest) {
        if (!(motion.getIntegrator() instanceof AdaptiveIntegrator chosen)) {
            return false;
        }
        int b = State.BLOCK * body.index();
        double left = 0;
        for (int c = 0; c < State.BLOCK; c++) {
            double v = Math.abs(state.v()[b + c] + rest * path.stage[b + c]);
            left = Math.max(left, c == State.THETA ? body.getShape().boundingRadius() * v : v);
        }
        return 0.5 * rest * left <= EVEN * chosen.getTolerance();
    }

    /** Brings the body to rest in a time, if static friction can hold it then. */
    private boolean stop(Body body, SurfaceFriction surface, IntList group, double rest, double t) {
        int b = State.BLOCK * body.index();
        double[] x = state.x();
        double[] v = state.v();
        double vx = v[b];
        double vy = v[b + 1];
        double omega = v[b + 2];
        v[b] = 0;
        v[b + 1] = 0;
        v[b + 2] = 0;
        motion.acceleration(group, t, path.stage); // friction is zero at rest: these are the other forces
        double mass = body.getMass();
        double load = body.getInertia() * path.stage[b + 2];
        if (!surface.holds(body, mass * path.stage[b], mass * path.stage[b + 1], load)) {
            v[b] = vx;
            v[b + 1] = vy;
            v[b + 2] = omega;
            return false;
        }
        x[b] += 0.5 * rest * vx;
        x[b + 1] += 0.5 * rest * vy;
        x[b + 2] += 0.5 * rest * omega;
        return true;
    }
}
