// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/** The workspace of methods that choose their steps: coordinates of a group of bodies without gaps, at most 3 per body. */
final class Stages implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of what is free of an error that counts at least, however small that was in the steps before. */
    private static final double PLAIN = 0.5;

    /**
     * The largest error of an angle, however coarse the tolerance; and of a place, over the lengths in which ties bend its way.
     * An error of a velocity counts for a step, so what is wrong by an angle α in each gains or loses some α of its energy, and
     * takes shorter steps the more it has: after some α⁻² steps it may have any energy and make any number of steps.
     */
    private static final double COARSEST = 2e-3;

    /** The same of an angle where friction takes the energy. */
    private static final double COARSEST_TO_REST = 0.125;

    /** Positions and velocities at the start of the step. */
    double[] x0 = {};

    double[] v0 = {};

    /** Accelerations at the start of the step. */
    double[] a0 = {};

    /** Coordinates, rates and accelerations of a stage. */
    double[] x = {};

    double[] v = {};
    double[] a = {};

    /** One over the error that a coordinate of a body may have, 3 per body. */
    double[] weight = {};

    /** Changes whose {@link #norm} is asked for, and what they do to the bodies. */
    double[] offX = {};

    double[] offV = {};
    private double[] byX = {};
    private double[] byV = {};

    /** Accelerations of the stages, or rows of an extrapolation, as a method lays them out. */
    double[] work = {};

    /** Velocities with which bodies began, 3 per body of the group. */
    double[] before = {};

    /** Accelerations of the stages that dense output has beyond these, and the end of the step. */
    double[] more = {};

    double[] endX = {};
    double[] endV = {};

    /** The method that has made the last step. */
    AdaptiveIntegrator maker;

    /** What is integrated. */
    transient Coordinates coordinates;

    final BodyCoordinates bodyCoordinates = new BodyCoordinates();

    /** Number of coordinates. */
    int size;

    /** Number of the bodies' own. */
    private int places;

    /** By how much the next step should be longer. */
    double factor;

    /** Whether the step was tried before, longer. */
    boolean isRetry;

    /** Whether the next step, if it cannot be short enough, is none: who asks for it can go on otherwise. */
    boolean mayGiveUp;

    /** Whether ties make far more of rounding where the next step begins than it is. */
    boolean isBlurred;

    /** The length in which ties bend the bodies' ways, for the next step alone; else infinite. */
    double bend = Double.POSITIVE_INFINITY;

    /** Whether friction brings the bodies to rest, so that errors cannot wind them up. */
    boolean isToRest;

    /** Whether it is much shorter than the method wants and than the one before: what is left of the engine's step. */
    boolean isCut;

    /** How much longer it would be if what is fast did not grow then; 1 if it is as long as its error lets it be. */
    double held;

    /** The time in which velocities change as much as they are: for so long an error of a velocity counts. */
    double time;

    /** How fast the accelerations change from one place to another, over their distance. */
    double rate;

    /** The part of errors that ties let pass, in the mean (of logarithms) of the steps of late; 0: not known. */
    double freedom;

    /** The same of the last error; 0 if that was not asked for, or nothing ties the bodies. */
    private double share;

    /** How much longer than this one steps were before, if much; else 1. */
    double haste;

    /** By how much it can be longer at most. */
    double most;

    /** What rows of an extrapolation propose, by their number: how much longer the step, at what cost. */
    double[] longer = {};

    double[] cost = {};

    /** Rows that an extrapolation aims at, by the first body of a group; 0: not known. */
    private int[] rows = {};

    /** The same for steps that need not end where the engine's does. */
    private int[] openRows = {};

    /** Whether this is such a step. */
    boolean isOpen;

    /** What an implicit method keeps, by the first body of a group. */
    private Implicit[] implicit = {};

    Stages() {
        // grows with the groups
    }

    /**
     * Takes the state of a group, in some coordinates.
     *
     * @param rounding of a coordinate; of the size of a body, if that is larger
     */
    void load(Coordinates c, State state, IntList bodies, double tolerance, double rounding) {
        coordinates = c;
        size = c.size();
        ensure(bodies);
        c.read(x0, v0);
        double coarsest = isToRest ? COARSEST_TO_REST : COARSEST;
        double coarse = Math.min(tolerance, COARSEST * bend);
        bend = Double.POSITIVE_INFINITY;
        for (int k = 0, m = 0; k < bodies.size; k++, m += State.BLOCK) {
            int b = State.BLOCK * bodies.values[k];
            double radius = state.body(bodies.values[k]).getShape().boundingRadius();
            double place = Math.max(radius, Math.max(Math.abs(state.x()[b]), Math.abs(state.x()[b + 1])));
            weight[m] = 1 / Math.max(coarse, rounding * place);
            weight[m + 1] = weight[m];
            double angle = Math.max(1, Math.abs(state.x()[b + 2]));
            weight[m + 2] = 1 / Math.max(Math.min(tolerance / radius, coarsest), rounding * angle);
        }
    }

    /** Whether coordinates are those of ties, and not the bodies' own. */
    boolean isTied() {
        return coordinates != bodyCoordinates;
    }

    /** Makes room for a group, in whatever coordinates. */
    void ensure(IntList bodies) {
        places = State.BLOCK * bodies.size;
        if (x0.length < places) {
            x0 = new double[places];
            v0 = new double[places];
            a0 = new double[places];
            x = new double[places];
            v = new double[places];
            a = new double[places];
            weight = new double[places];
            offX = new double[places];
            offV = new double[places];
            byX = new double[places];
            byV = new double[places];
        }
    }

    /** The largest of some changes in units of what is allowed: of places, and of velocities times a time. */
    double norm(double[] changeX, double[] changeV, double time) {
        boolean isSpread = coordinates.spread(changeX, changeV, byX, byV);
        double[] dx = isSpread ? byX : changeX;
        double[] dv = isSpread ? byV : changeV;
        double most = 0;
        for (int m = 0; m < places; m++) {
            most = Math.max(most, weight[m] * Math.max(Math.abs(dx[m]), Math.abs(time * dv[m])));
        }
        return most;
    }

    /**
     * The {@link #norm} of an error as it is, times the part of errors that ties let pass, {@link #freedom}. It is that in the
     * mean of late: what is free of a single estimate vanishes now and then where what is free of the error does not, and
     * steps had better go by all of it. Near a pose in which ties depend on one another the part is larger, at once.
     *
     * @param errorX of the end, where accelerations were asked for last, or near to it; changed
     * @param errorV of the rates; changed
     */
    double left(double[] errorX, double[] errorV, double time) {
        double all = norm(errorX, errorV, time);
        if (!(all > 0 && all < Double.POSITIVE_INFINITY) || !coordinates.pass(errorX)) {
            return all;
        }
        coordinates.pass(errorV);
        share = Math.min(1, norm(errorX, errorV, time) / all);
        return all * (freedom > 0 ? Math.max(freedom, PLAIN * share) : share);
    }

    /** Begins an attempt, in which it may be that nobody asks what ties let pass. */
    void forgetShare() {
        share = 0;
    }

    /** The mean part that ties let pass, with that of the step that was just made; 0 if it is not known. */
    double freedom() {
        if (share == 0 || freedom == 0) {
            return Math.max(share, freedom);
        }
        return freedom * Math.sqrt(Math.sqrt(Math.sqrt(share / freedom))); // counts for an eighth
    }

    /** The same of places alone. */
    double norm(double[] changeX) {
        double[] dx = coordinates.spread(changeX, null, byX, byV) ? byX : changeX;
        double most = 0;
        for (int m = 0; m < places; m++) {
            most = Math.max(most, weight[m] * Math.abs(dx[m]));
        }
        return most;
    }

    /** The greatest speed of a group that is where the state vectors have it, or another vector of that kind. */
    double most(IntList bodies, double[] byBlock) {
        double most = 0;
        for (int k = 0, m = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++, m++) {
                most = Math.max(most, weight[m] * Math.abs(byBlock[b]));
            }
        }
        return most;
    }

    /** The workspace of an implicit method for a group. */
    Implicit implicit(IntList bodies) {
        int first = bodies.values[0];
        if (implicit.length <= first) {
            implicit = Arrays.copyOf(implicit, first + first / 2 + 1);
        }
        implicit[first] = implicit[first] == null ? new Implicit() : implicit[first];
        implicit[first].ensure(size);
        return implicit[first];
    }

    /** Makes room for some values per coordinate. */
    void ensureWork(int perCoordinate) {
        if (work.length < perCoordinate * size) {
            work = new double[perCoordinate * size];
        }
    }

    /** Makes room for the velocities with which bodies began. */
    void ensureBefore(int values) {
        if (before.length < values) {
            before = new double[values];
        }
    }

    /** Makes room for stages of dense output, and keeps the end of the step, which the state vectors hold. */
    void ensureMore(int perCoordinate) {
        if (more.length < perCoordinate * size) {
            more = new double[perCoordinate * size];
        }
        if (endX.length < size) {
            endX = new double[x0.length];
            endV = new double[x0.length];
        }
        coordinates.read(endX, endV);
    }

    /** Puts the bodies back to the end of the step. */
    void putEnd() {
        coordinates.put(endX, endV);
    }

    /** The cubics from the start to where the bodies are now. */
    void join(State state, IntList bodies, double h, Path path) {
        for (int k = 0, m = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++, m++) {
                path.cubic(b, (state.x()[b] - x0[m]) / h, v0[m], state.v()[b], h);
            }
        }
    }

    /** Makes room for the rows of an extrapolation. */
    void ensureRows(int first, int most) {
        if (rows.length <= first) {
            rows = Arrays.copyOf(rows, 2 * first + 8);
            openRows = Arrays.copyOf(openRows, rows.length);
        }
        if (longer.length <= most) {
            longer = new double[most + 1];
            cost = new double[most + 1];
        }
    }

    int[] rows() {
        return isOpen ? openRows : rows;
    }

    /** Finds the accelerations at the start. */
    void begin(double t, Path path) {
        coordinates.accelerate(x0, v0, t, a0);
        coordinates.accelerations(x0, v0, a0, path.first);
        path.knowsFirst = true;
    }
}
