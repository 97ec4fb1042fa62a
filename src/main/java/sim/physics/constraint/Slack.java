// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.motion.State;

/** How far an island is off its constraints. */
final class Slack {
    private Slack() {}

    /** The largest |C|, in units of the rounding that its coordinates have. */
    static double error(Island island, State state, double rounding) {
        double[] x = state.x();
        double place = 0;
        double angle = 1;
        for (int k = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            place = Math.max(place, Math.max(Math.abs(x[s]), Math.abs(x[s + 1])));
            angle = Math.max(angle, Math.abs(x[s + State.THETA]));
        }
        double most = 0;
        double mostAngle = 0;
        place = Math.max(place, island.mostSize);
        if (island.hasOnlyPins()) {
            for (int k = 0; k < 2 * island.nodes; k++) {
                most = Math.max(most, Math.abs(island.c[k]));
            }
            return most <= Double.MAX_VALUE ? most / (rounding * place) : Double.POSITIVE_INFINITY;
        }
        for (int k = 0; k < 2 * island.nodes; k++) {
            double value = Math.abs(island.c[k]);
            if (!(value <= Double.MAX_VALUE)) {
                return Double.POSITIVE_INFINITY;
            }
            if (island.isAngle[k]) {
                mostAngle = value > mostAngle ? value : mostAngle;
            } else {
                most = value > most ? value : most;
            }
        }
        return Math.max(most / (rounding * place), mostAngle / (rounding * angle));
    }

    /**
     * How far a constraint of an island is open: of its rows that are lengths taken together, or of that between angles.
     *
     * @param isAngle which of the two
     */
    static double gap(Island island, int constraint, boolean isAngle) {
        double sum = 0;
        for (int k = 2 * island.firstNode[constraint]; k < 2 * island.firstNode[constraint + 1]; k++) {
            sum += island.isAngle[k] == isAngle ? island.c[k] * island.c[k] : 0;
        }
        return Math.sqrt(sum);
    }

    /** The same of the one that is farthest open, as bodies see it: lengths relative to the smallest of them. */
    static ConstraintException failure(Island island, int corrections) {
        double most = -1;
        int widest = 0;
        boolean isAngle = false;
        for (int k = 0; k < island.constraints.length; k++) {
            double way = gap(island, k, false) / island.leastSize;
            double turn = gap(island, k, true);
            if (!(Math.max(way, turn) <= most)) {
                most = Math.max(way, turn);
                widest = k;
                isAngle = turn > way;
            }
        }
        return ConstraintException.of(island.inOrder, island.constraints[widest], gap(island, widest, isAngle), isAngle, corrections);
    }

    /** Whether one is open by more than what is added may be. */
    static boolean isOpen(Island island) {
        for (int k = 0; k < island.constraints.length; k++) {
            boolean isNear = gap(island, k, false) <= Admissible.CLOSED * island.constraints[k].getSize();
            if (!isNear || gap(island, k, true) > Admissible.CLOSED) {
                return true;
            }
        }
        return false;
    }

    /** The largest |C| where an island was evaluated last. */
    static double largest(Island island) {
        double most = 0;
        for (int k = 0; k < island.constraints.length; k++) {
            most = Math.max(most, Math.max(gap(island, k, false), gap(island, k, true)));
        }
        return most;
    }

    /** The largest |J ẋ| of {@code right}, as bodies see it, relative to the speed of the bodies' points; 0 for rounding. */
    static double slip(Island island, double[] v, double[] right) {
        double speed = 0;
        double spin = 0;
        for (int k = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            speed = Math.max(speed, Math.max(Math.abs(v[s]), Math.abs(v[s + 1])));
            spin = Math.max(spin, Math.abs(v[s + State.THETA]));
        }
        double most = 0;
        for (int k = 0; k < 2 * island.nodes; k++) {
            double value = Math.abs(right[k]);
            most = Math.max(most, island.isAngle[k] ? island.leastSize * value : value);
        }
        double scale = Math.max(speed, spin * island.leastSize);
        return most <= 2 * 0x1p-52 * scale ? 0 : scale == 0 ? 1 : most / scale;
    }
}
