// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.Check;
import sim.physics.internal.IntList;

/**
 * A method that takes a tolerance instead of a step. It chooses its steps so that the error of a position in each of them is
 * about the tolerance, in units of length. The error of an angle is about that of the body's rim, but never more than 2 · 10⁻³.
 *
 * <p>The engine's time step then only says when the state is published and when agents act. Where forces and joints depend on the
 * state alone, steps that would be much longer go on beyond the engine's step, and the state is read from their dense output.
 * Elsewhere they end with the engine's step, so that step had better be long.
 *
 * <p>The error at the end of a run is the tolerance times the factor by which the scene amplifies a small change on its way. That
 * factor is about the time in units of the step for a pendulum, and more where motion is chaotic.
 */
public abstract sealed class AdaptiveIntegrator implements Integrator
        permits DormandPrince853, GraggBulirschStoer, RadauIIA, Automatic {
    private static final long serialVersionUID = 1L;

    /** Part of the steps before from which a step is one that something sudden asks for. */
    private static final double SUDDEN = 1.0 / 8;

    /** What an estimate may be too small by where forces jump. */
    private static final double CAUTION = 24;

    /** How long the steps before count, in their lengths. */
    private static final double MEMORY = 2;

    /** Number of short steps after which it is not a jump that makes them short, but forces that are rough throughout. */
    private static final int MOST_HASTY = 100;

    /** Part of what the greatest speed and acceleration were that is forgotten in the time that they tell. */
    private static final double FORGET = 0.2;

    /** The most steps for which an error of a velocity counts. */
    private static final double LONGEST = 200;

    private static final double SMALLEST = 0x1p-50;

    private static final double WORTHWHILE = 1.5;

    private static final double SHARE_OF_STOP = 0.5;

    /** Part of the step that a method wants, and of the last one, below which one is cut short by where the engine's ends. */
    private static final double CUT = 0.5;

    /** Rounding of a coordinate, or of a body's size, below which no step is made smaller. */
    private static final double ROUNDING = 2 * 0x1p-52;

    /** The same beside a singular pose, where ties make far more of it: a tolerance that asks for less ends in steps of next to no length. */
    private static final double BLURRED = 0x1p12 * ROUNDING;

    private final double tolerance;

    AdaptiveIntegrator(double tolerance) {
        this.tolerance = Check.positive("tolerance", tolerance);
    }

    /**
     * Returns the error of a position that a step may make.
     *
     * @return length
     */
    public final double getTolerance() {
        return tolerance;
    }

    @Override
    public final boolean isAdaptive() {
        return true;
    }

    @Override
    public final double advance(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path) {
        return h == 0 ? 0 : advance(own(equations, state, bodies, path), equations, state, bodies, t, h, false, path);
    }

    /** The bodies' own coordinates. */
    private static Coordinates own(EquationsOfMotion equations, State state, IntList bodies, Path path) {
        return path.stages.bodyCoordinates.of(equations, state, bodies, path);
    }

    /**
     * Advances the blocks of some bodies by a step that need not end where the engine's does.
     *
     * @param wanted the step
     * @return the time advanced
     */
    final double goOn(EquationsOfMotion equations, State state, IntList bodies, double t, double wanted, Path path) {
        return advance(own(equations, state, bodies, path), equations, state, bodies, t, wanted, true, path);
    }

    /** Whether a group may be moved in the coordinates of its ties. */
    boolean takesTiedCoordinates(IntList bodies, Path path) {
        return false;
    }

    /**
     * Advances a group in some coordinates, which have begun where the state vectors have it.
     *
     * @param isOpen whether the step need not end where the engine's does
     * @return the time advanced; 0 if no step is short enough, and it may give up
     */
    final double advance(
            Coordinates coordinates, EquationsOfMotion equations, State state, IntList bodies, double t, double h, boolean isOpen,
            Path path) {
        path.ensure(State.BLOCK * state.size());
        Stages stages = path.stages;
        boolean mayGiveUp = stages.mayGiveUp;
        stages.mayGiveUp = false;
        stages.load(coordinates, state, bodies, tolerance, stages.isBlurred ? BLURRED : ROUNDING);
        stages.isBlurred = false;
        stages.isOpen = isOpen;
        stages.begin(t, path);
        int first = bodies.values[0];
        stages.freedom = path.freedom[first];
        double wanted = path.next[first];
        double length = wanted > 0 && wanted < Math.abs(h) ? fit(wanted, Math.abs(h)) : Math.abs(h);
        double longest = coordinates.longest();
        length = longest < length ? fit(longest, Math.abs(h)) : length;
        length = hold(state, bodies, path, t, h, length, 0);
        double time = time(state, bodies, path, length);
        int rejections = 0;
        while (true) {
            stages.most = stages.held > 1 ? 1 : isOpen ? Double.MAX_VALUE : Math.max(1, Math.abs(h) / length);
            stages.haste = haste(path, first, t, length);
            stages.forgetShare();
            stages.isCut = !stages.isTied() && length < CUT * Math.min(wanted, path.made[first]);
            stages.time = Math.max(length, time);
            boolean done = attempt(equations, state, bodies, t, h < 0 ? -length : length, path);
            double proposal = length * stages.factor;
            if (done) {
                if (!stages.isTied()) {
                    stages.join(state, bodies, h < 0 ? -length : length, path);
                }
                path.freedom[first] = stages.freedom();
                path.made[first] = length;
                path.proposed[first] = proposal;
                path.next[first] = length == Math.abs(h) && !isOpen ? Math.max(wanted, proposal) : proposal;
                remember(path, first, t, isOpen ? proposal : Math.min(proposal, Math.abs(h)));
                return length == Math.abs(h) ? h : h < 0 ? -length : length;
            }
            rejections++;
            length = hold(state, bodies, path, t, h, Math.min(proposal, 0.9 * length), rejections);
            wanted = 0;
            if (!(length > SMALLEST * Math.abs(h)) && rejections > 8) {
                if (mayGiveUp) {
                    return 0;
                }
                throw failure(t);
            }
        }
    }

    /** What there is to say where no step is short enough. */
    final IllegalStateException failure(double t) {
        return new IllegalStateException("tolerance is " + tolerance + ": " + this
                + " cannot meet it at time " + t + ", where the forces are not smooth or not finite");
    }

    /** Shortens a step in which something would grow that vibrates and is not followed. */
    private double hold(State state, IntList bodies, Path path, double t, double h, double length, int rejections) {
        path.stages.isRetry = rejections > 0;
        path.stages.held = 1;
        double reach = reach(bodies, path);
        if (reach == Double.POSITIVE_INFINITY) {
            return length;
        }
        double stable = path.stable.shorten(bodies, path, state, t, reach, length);
        if (stable < length) {
            path.stages.held = length / stable;
            return fit(stable, Math.abs(h));
        }
        return length;
    }

    /** The time in which velocities change as much as they are: their greatest of late over that of the accelerations. */
    private static double time(State state, IntList bodies, Path path, double length) {
        int first = bodies.values[0];
        double speed = path.stages.most(bodies, state.v());
        double push = path.stages.most(bodies, path.first);
        double before = path.speed[first] / path.push[first];
        double kept = before > 0 ? before / (before + FORGET * length) : 0;
        path.speed[first] = Math.max(speed, kept * path.speed[first]);
        path.push[first] = Math.max(push, kept * path.push[first]);
        return path.push[first] > 0 ? Math.min(path.speed[first] / path.push[first], LONGEST * length) : length;
    }

    /**
     * An error of a velocity is multiplied by the step, as the next one may correct it. What a force that jumps leaves is
     * never corrected: in a step that was made short for it, the velocity counts as in the steps before.
     */
    private static double haste(Path path, int first, double t, double length) {
        double pace = path.pace[first];
        boolean counts = length < SUDDEN * pace && path.hasty[first] < MOST_HASTY && Math.abs(path.paceTime[first] - t) <= MEMORY * pace;
        return counts ? CAUTION * pace / length : 1;
    }

    private static void remember(Path path, int first, double t, double length) {
        double pace = path.pace[first];
        if (!(length < pace && Math.abs(path.paceTime[first] - t) <= MEMORY * pace)) {
            path.pace[first] = length;
            path.paceTime[first] = t;
            path.hasty[first] = 0;
        } else if (length < SUDDEN * pace) {
            path.hasty[first]++;
        }
    }

    /** The next step: not much less than what is left, and no tiny one after it. */
    private static double fit(double wanted, double left) {
        return left < 1.02 * wanted ? left : left < 2 * wanted ? 0.5 * left : wanted;
    }

    /**
     * Tries a step from what was loaded, whose accelerations are those of the first stage.
     *
     * @return whether its error is small enough; the state vectors then hold its end. The stages' factor says by how much
     *     the next step should be longer.
     */
    abstract boolean attempt(EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path);

    /** The step times the frequency of a vibration up to which the method damps it, however small; with room for its estimate. */
    double reach(IntList bodies, Path path) {
        return Double.POSITIVE_INFINITY;
    }

    /**
     * How much longer than the engine's a step must be for dense output to pay, and not to end there: what it costs, and what
     * is read, against errors that are smaller than asked for.
     */
    double worthwhile() {
        return WORTHWHILE;
    }

    /** Whether what steps that end with the engine's say of longer ones is all there is to know. */
    boolean hasFixedOrder() {
        return true;
    }

    /** Part of the time to the rest of a sliding body that is integrated at once, if the tolerance allows it. */
    double shareOfStop() {
        return SHARE_OF_STOP;
    }

    /** The same at most, if the estimates of the parts before allow it. */
    double mostOfStop() {
        return shareOfStop();
    }

    /**
     * Makes the dense output of the step that was just made, whose end the state vectors hold, and keeps them.
     *
     * @return false if it would not be as accurate as the step
     */
    abstract boolean makeDense(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path, DenseOutput out);
}
