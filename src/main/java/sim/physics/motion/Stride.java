// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/** A step of an integrator that goes on beyond the engine's, and up to where it has been followed. */
final class Stride implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of a stride that is rounding. */
    private static final double ROUNDING = 1e-12;

    /** Part of the engine's step by which rounding may make the same instant two. */
    private static final double SAME = 1e-9;

    final DenseOutput dense = new DenseOutput();

    /** Whether nothing has happened to its bodies since it was made. */
    boolean isLive;

    /** Whether it was entered last after its beginning. */
    boolean isUnderWay;

    /** Whether its dense output is that of the coordinates of ties. */
    boolean isInTiedCoordinates;

    /** The longest that its dense output lets it be. */
    double longest = Double.MAX_VALUE;

    /** How long the next one should be; 0: not known. */
    double wanted;

    private Integrator maker;
    private int[] bodies = {};

    /** Number of the engine's step in which it begins, where in that, and how long the engine's steps are. */
    private double step;

    private double offset;
    private double h;

    /** Where it ends, where it was entered last and where it was left last: x and v of the group, each without gaps. */
    private double[] end = {};

    private double[] entered = {};
    private double enteredAt;
    private double[] left = {};
    private double leftAt;

    Stride() {
        // until it is begun
    }

    /** Begins: the state vectors hold the end of the step of which there is dense output now. */
    void begin(Integrator by, State state, IntList group, Trajectories trajectories, double tau, boolean isTied) {
        maker = by;
        isInTiedCoordinates = isTied;
        if (bodies.length != group.size) {
            bodies = new int[group.size];
        }
        System.arraycopy(group.values, 0, bodies, 0, group.size);
        step = trajectories.step();
        offset = tau;
        h = trajectories.h();
        int size = 2 * State.BLOCK * group.size;
        if (end.length != size) {
            end = new double[size];
            entered = new double[size];
            left = new double[size];
        }
        take(state, group, end);
        isLive = true;
    }

    /** How long it has gone on at an instant. */
    double time(Trajectories trajectories, double tau) {
        return (trajectories.step() - step) * h + (tau - offset);
    }

    /** Whether a time is that of its end, but for rounding, or later. */
    boolean isOver(double time) {
        return time >= (1 - ROUNDING) * dense.length;
    }

    /** Whether a time is not before its beginning and not after its end, but for rounding. */
    boolean has(double time) {
        return time >= -ROUNDING * dense.length && time <= (1 + ROUNDING) * dense.length;
    }

    /** Whether these bodies, by this method and with these steps of the engine, are where and when they last were on it, to the bit. */
    boolean isFollowed(Integrator by, State state, IntList group, Trajectories trajectories, double time) {
        return isLive
                && maker == by
                && h == trajectories.h()
                && Arrays.equals(bodies, 0, bodies.length, group.values, 0, group.size)
                && (isNow(leftAt, time) && isAt(state, left) || isNow(enteredAt, time) && isAt(state, entered));
    }

    private boolean isNow(double then, double time) {
        return Math.abs(time - then) <= SAME * h;
    }

    private boolean isAt(State state, double[] place) {
        boolean same = true;
        for (int k = 0, m = 0; k < bodies.length; k++) {
            for (int b = State.BLOCK * bodies[k], to = b + State.BLOCK; b < to; b++, m += 2) {
                same &= state.x()[b] == place[m] && state.v()[b] == place[m + 1];
            }
        }
        return same;
    }

    /** Takes note of where it is entered: where the state vectors have the group. */
    void enter(State state, IntList group, double time) {
        enteredAt = time;
        take(state, group, entered);
    }

    /** Takes note of where it is left. */
    void leave(State state, IntList group, double time) {
        leftAt = time;
        take(state, group, left);
    }

    /** Puts the group where it is at a time; at its end, where the integrator has brought it. */
    void put(State state, IntList group, double time) {
        if (!isOver(time)) {
            dense.put(state, group, time / dense.length);
            return;
        }
        for (int k = 0, m = 0; k < group.size; k++) {
            for (int b = State.BLOCK * group.values[k], to = b + State.BLOCK; b < to; b++, m += 2) {
                state.x()[b] = end[m];
                state.v()[b] = end[m + 1];
            }
        }
    }

    private static void take(State state, IntList group, double[] place) {
        for (int k = 0, m = 0; k < group.size; k++) {
            for (int b = State.BLOCK * group.values[k], to = b + State.BLOCK; b < to; b++, m += 2) {
                place[m] = state.x()[b];
                place[m + 1] = state.v()[b];
            }
        }
    }
}
