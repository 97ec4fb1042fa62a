// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/** The workspace of methods that choose their steps: coordinates of a group of bodies without gaps, 3 per body. */
final class Stages implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Positions and velocities at the start of the step. */
    double[] x0 = {};

    double[] v0 = {};

    /** Accelerations at the start of the step. */
    double[] a0 = {};

    /** One over the error that a coordinate may have. */
    double[] weight = {};

    /** Accelerations of the stages, or rows of an extrapolation, as a method lays them out. */
    double[] work = {};

    /** Accelerations of the stages that dense output has beyond these, and the end of the step. */
    double[] more = {};

    double[] endX = {};
    double[] endV = {};

    /** The method that has made the last step. */
    AdaptiveIntegrator maker;

    /** Number of coordinates. */
    int size;

    /** By how much the next step should be longer. */
    double factor;

    /** Whether the step was tried before, longer. */
    boolean isRetry;

    /** The time in which velocities change as much as they are: for so long an error of a velocity counts. */
    double time;

    /** How fast the accelerations change from one place to another, over their distance. */
    double rate;

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

    /** Takes the state of a group. */
    void load(State state, IntList bodies, double tolerance, double rounding) {
        size = State.BLOCK * bodies.size;
        if (x0.length < size) {
            x0 = new double[size];
            v0 = new double[size];
            a0 = new double[size];
            weight = new double[size];
        }
        for (int k = 0, m = 0; k < bodies.size; k++, m += State.BLOCK) {
            int b = State.BLOCK * bodies.values[k];
            for (int c = 0; c < State.BLOCK; c++) {
                x0[m + c] = state.x()[b + c];
                v0[m + c] = state.v()[b + c];
            }
            double radius = state.body(bodies.values[k]).getShape().boundingRadius();
            double place = Math.max(Math.abs(x0[m]), Math.abs(x0[m + 1]));
            weight[m] = 1 / Math.max(tolerance, rounding * place);
            weight[m + 1] = weight[m];
            weight[m + 2] = 1 / Math.max(tolerance / radius, rounding * Math.abs(x0[m + 2]));
        }
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

    /** Makes room for stages of dense output, and keeps the end of the step. */
    void ensureMore(int perCoordinate, IntList bodies, State state) {
        if (more.length < perCoordinate * size) {
            more = new double[perCoordinate * size];
        }
        if (endX.length < size) {
            endX = new double[size];
            endV = new double[size];
        }
        for (int k = 0, m = 0; k < bodies.size; k++, m += State.BLOCK) {
            System.arraycopy(state.x(), State.BLOCK * bodies.values[k], endX, m, State.BLOCK);
            System.arraycopy(state.v(), State.BLOCK * bodies.values[k], endV, m, State.BLOCK);
        }
    }

    /** Puts the bodies back to the end of the step. */
    void putEnd(IntList bodies, State state) {
        for (int k = 0, m = 0; k < bodies.size; k++, m += State.BLOCK) {
            System.arraycopy(endX, m, state.x(), State.BLOCK * bodies.values[k], State.BLOCK);
            System.arraycopy(endV, m, state.v(), State.BLOCK * bodies.values[k], State.BLOCK);
        }
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

    /** Takes the accelerations at the start. */
    void keepFirst(IntList bodies, Path path) {
        for (int k = 0, m = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++, m++) {
                a0[m] = path.stage[b];
                path.first[b] = path.stage[b];
            }
        }
        path.knowsFirst = true;
    }
}
