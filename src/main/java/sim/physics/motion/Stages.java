// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/** The workspace of methods that choose their steps: coordinates of a group of bodies without gaps, at most 3 per body. */
final class Stages implements Serializable {
    private static final long serialVersionUID = 1L;

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

    /** Whether it had to be much shorter than the method wanted. */
    boolean isCut;

    /** The time in which velocities change as much as they are: for so long an error of a velocity counts. */
    double time;

    /** How fast the accelerations change from one place to another, over their distance. */
    double rate;

    /** The part of an error that counts although ties take it away. */
    private double turn = 1;

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

    /** Takes the state of a group, in some coordinates. */
    void load(Coordinates c, State state, IntList bodies, double tolerance, double rounding) {
        coordinates = c;
        size = c.size();
        ensure(bodies);
        c.read(x0, v0);
        for (int k = 0, m = 0; k < bodies.size; k++, m += State.BLOCK) {
            int b = State.BLOCK * bodies.values[k];
            double radius = state.body(bodies.values[k]).getShape().boundingRadius();
            double place = Math.max(Math.abs(state.x()[b]), Math.abs(state.x()[b + 1]));
            weight[m] = 1 / Math.max(tolerance, rounding * place);
            weight[m + 1] = weight[m];
            weight[m + 2] = 1 / Math.max(tolerance / radius, rounding * Math.abs(state.x()[b + 2]));
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
     * Finds out what part of an error counts although ties take it away again: the directions in which they act turn within
     * a step by an angle δ, so that of what was theirs to take when it arose they leave up to δ at the end, δ / 2 in the mean.
     * That is the part of the way of the step, a chord, that they do not let pass at its end. Near a pose in which ties depend
     * on one another, where directions turn fast, it is all that tells such errors.
     *
     * @param endX coordinates at the end, where accelerations were asked for last, or near to it
     */
    void turn(double[] endX) {
        for (int m = 0; m < size; m++) {
            byX[m] = endX[m] - x0[m];
            byV[m] = byX[m];
        }
        turn = 1;
        if (!coordinates.pass(byV)) {
            return;
        }
        double whole = 0;
        double taken = 0;
        for (int m = 0; m < size; m++) {
            whole = Math.max(whole, weight[m] * Math.abs(byX[m]));
            taken = Math.max(taken, weight[m] * Math.abs(byX[m] - byV[m]));
        }
        turn = taken < whole ? taken / whole : 1;
    }

    /** The {@link #norm} of an error, of what ties let pass of it; it is changed. */
    double passed(double[] errorX, double[] errorV, double time) {
        double all = norm(errorX, errorV, time);
        if (turn == 1) {
            return all;
        }
        coordinates.pass(errorX);
        coordinates.pass(errorV);
        return Math.max(norm(errorX, errorV, time), turn * all);
    }

    /** The same of an error of places, or of velocities, alone. */
    double passed(double[] error) {
        double all = norm(error);
        return turn == 1 || !coordinates.pass(error) ? all : Math.max(norm(error), turn * all);
    }

    /** The largest of some changes of places alone. */
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
