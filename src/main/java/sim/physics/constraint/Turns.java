// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Trig;
import sim.physics.motion.State;

/** Where the bodies of an island were evaluated last, and the cosines and sines of their orientations there. */
final class Turns implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Island island;

    /** Whether some anchor of a body is off its centre. */
    private final boolean[] isNeeded;

    /** Positions at the last evaluation, 3 per body; angles of the cosines and sines. */
    private final double[] place;

    private final double[] angle;

    /** Whether the last evaluation took account of what rounding has left of the positions. */
    private boolean isCarried;

    /** Cosine and sine of each body. */
    final double[] turn;

    Turns(Island island) {
        this.island = island;
        int n = island.bodies.size;
        isNeeded = new boolean[n];
        place = new double[State.BLOCK * n];
        angle = new double[n];
        turn = new double[2 * n];
        Arrays.fill(place, Double.NaN);
        Arrays.fill(angle, Double.NaN);
    }

    /** Notes that a body's cosine and sine will be asked for. */
    void need(int body) {
        isNeeded[body] = true;
    }

    /**
     * Whether the bodies are within a step of a method that carries what rounding leaves of their positions, where
     * constraints are evaluated with that.
     */
    boolean isCarried() {
        return isCarried;
    }

    /** Goes to where the bodies are; false if they have not moved. */
    boolean follow(State state) {
        double[] x = state.x();
        boolean moved = isCarried;
        isCarried = state.carry() != null && state.carry().isHeld(island.bodies.values[0]);
        moved |= isCarried;
        for (int k = 0, m = 0; k < angle.length; k++, m += State.BLOCK) {
            int s = State.BLOCK * island.bodies.values[k];
            double theta = x[s + State.THETA];
            moved |= x[s] != place[m] | x[s + 1] != place[m + 1] | theta != place[m + 2];
            place[m] = x[s];
            place[m + 1] = x[s + 1];
            place[m + 2] = theta;
            if (theta != angle[k] && isNeeded[k]) {
                angle[k] = theta;
                Trig.sinCos(theta, turn, 2 * k);
            }
        }
        return moved;
    }

    /** A copy of the angles, and of the cosines and sines that go with them. */
    double[][] keep() {
        return new double[][] {angle.clone(), turn.clone()};
    }

    /** Puts them back. What was evaluated of them since is none of theirs. */
    void putBack(double[][] kept) {
        System.arraycopy(kept[0], 0, angle, 0, angle.length);
        System.arraycopy(kept[1], 0, turn, 0, turn.length);
        Arrays.fill(place, Double.NaN);
    }

    /** Takes note of a tiny move of the bodies: turns the cosines and sines by its angles instead of finding them anew. */
    void nudge(double[] x, double[] move) {
        for (int k = 0; k < angle.length; k++) {
            int s = State.BLOCK * island.bodies.values[k] + State.THETA;
            double d = move[s];
            double cos = turn[2 * k];
            double sin = turn[2 * k + 1];
            angle[k] = x[s];
            turn[2 * k] = cos - d * (sin + 0.5 * d * cos);
            turn[2 * k + 1] = sin + d * (cos - 0.5 * d * sin);
        }
    }
}
