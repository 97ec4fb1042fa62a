// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.internal.Freshness;
import sim.physics.internal.IntList;
import sim.physics.internal.OpenGroups;
import sim.physics.internal.Softness;
import sim.physics.motion.State;

/** Solves the constraints of {@link TieRows} in turn, but for pins ({@link PinImpulses}). */
final class TieSolver implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int ROWS = TieEquations.ROWS;

    /** What is kept of one whose velocity is settled: its place, its two bodies, {@link Freshness#FIXED} for what cannot move, and its group. */
    private static final int ENDS = 4;

    private final State state;
    private final TieEquations equations;
    private final TurningRows turning;
    private final StopRows stops;
    private final TieTrees trees;

    /** By row: its impulse; those of {@link TieRows}. */
    private double[] impulse = {};

    /** The joints whose velocities are settled. */
    private final IntList settling = new IntList();

    /** When each was solved last; see {@link Freshness}. */
    private long[] solved = {};

    TieSolver(State state, TieEquations equations, TurningRows turning, StopRows stops, TieTrees trees) {
        this.trees = trees;
        this.state = state;
        this.equations = equations;
        this.turning = turning;
        this.stops = stops;
    }

    /** Takes constraints. */
    void gather(double[] impulse) {
        this.impulse = impulse;
        solved = new long[impulse.length / ROWS];
    }

    /** Solves all of them once that trees have not. */
    void solve(Softness softness, double h) {
        for (int k = 0; k < equations.count(); k++) {
            if (!trees.hasSolved(k)) {
                solve(k, softness, h);
            }
        }
    }

    /** Solves those of some bodies once, or of these only what has a place. */
    void solve(boolean[] marks, boolean placesOnly, Softness softness, double h) {
        for (int k = 0; k < equations.count(); k++) {
            if (equations.isMarked(k, marks) && !trees.hasSolved(k) && (!placesOnly || equations.kinds[k].hasPlace())) {
                solve(k, softness, h);
            }
        }
    }

    private void solve(int k, Softness softness, double h) {
        switch (equations.kinds[k]) {
            case JOINT -> join(k, softness);
            case WHEEL -> roll(k, softness);
            case MOTOR -> drive(k, (Motor) equations.ties[k], softness, h);
            case STOP -> stops.solve(k, softness, h);
        }
    }

    private void join(int k, Softness softness) {
        double[] v = state.v();
        int o = ROWS * k;
        int m = ROWS * o;
        boolean yields = !trees.isStiff(k);
        double mass = softness.mass(yields);
        double back = softness.impulse(yields);
        double bend = softness.rate() > 0 ? 1 : 0; // only where a way is to be gone
        double r0 = equations.speed(k, 0, v) + softness.rate() * equations.c[o] + bend * equations.bend[o];
        if (equations.rows[k] == 1) {
            take(k, 0, -mass * equations.inverse[m] * r0 - back * impulse[o]);
            return;
        }
        double r1 = equations.speed(k, 1, v) + softness.rate() * equations.c[o + 1] + bend * equations.bend[o + 1];
        if (equations.rows[k] == 2) {
            take(k, 0, -mass * (equations.inverse[m] * r0 + equations.inverse[m + 1] * r1) - back * impulse[o]);
            take(k, 1, -mass * (equations.inverse[m + 3] * r0 + equations.inverse[m + 4] * r1) - back * impulse[o + 1]);
            return;
        }
        double r2 = equations.speed(k, 2, v) + softness.rate() * equations.c[o + 2] + bend * equations.bend[o + 2];
        for (int r = 0; r < ROWS; r++, m += ROWS) {
            double by = equations.inverse[m] * r0 + equations.inverse[m + 1] * r1 + equations.inverse[m + 2] * r2;
            take(k, r, -mass * by - back * impulse[o + r]);
        }
    }

    private void take(int k, int row, double by) {
        impulse[ROWS * k + row] += by;
        equations.push(k, row, by);
    }

    /** A wheel takes all that is across it, as it has no place to go back to. */
    private void roll(int k, Softness softness) {
        double speed = equations.speed(k, 0, state.v()) + (softness.rate() > 0 ? equations.bend[ROWS * k] : 0);
        take(k, 0, -equations.inverse[ROWS * ROWS * k] * speed);
    }

    /** A motor has no place to go back to; but where a way is to be gone, it is that of its speed, along a direction that turns meanwhile. */
    private void drive(int k, Motor motor, Softness softness, double h) {
        double most = motor.getLimit() * h;
        double old = impulse[ROWS * k];
        double speed = turning.speed(k, softness.rate() > 0) + (softness.rate() > 0 ? equations.bend[ROWS * k] : 0);
        double asked = old - equations.inverse[ROWS * ROWS * k] * (speed - motor.getSpeed());
        double now = asked > most ? most : asked < -most ? -most : asked; // a branch waits for nothing, Math.min does
        impulse[ROWS * k] = now;
        turning.push(k, now - old);
    }

    /** Finds the joints of marked bodies, whose velocities are to be settled. */
    void keep(int[] groups, boolean[] marks) {
        settling.clear();
        for (int k = 0; k < equations.count(); k++) {
            if (equations.kinds[k].ties() && equations.isMarked(k, marks)) {
                settling.add(k);
                settling.add(equations.end(2 * k));
                settling.add(equations.end(2 * k + 1));
                settling.add(groups[equations.movable(k)]);
            }
        }
    }

    /** Solves joints of groups that have not settled for velocities once more, and says of which some were off. */
    void settle(OpenGroups turns, Freshness fresh) {
        for (int n = 0; n < settling.size; n += ENDS) {
            int k = settling.values[n];
            int first = settling.values[n + 1];
            int second = settling.values[n + 2];
            int group = settling.values[n + 3];
            if (turns.isOpen(group) && fresh.isStale(solved[k], first, second)) {
                boolean wasOff = equations.areOff(k);
                join(k, Softness.EAGER);
                solved[k] = fresh.solve(first, second, wasOff, true);
                turns.change(group, wasOff);
            }
        }
    }
}
