// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.internal.Trig;
import sim.physics.motion.State;

/** Cosines and sines of the bodies that have an arm to a pin, once for all of their pins. */
final class ArmTurns implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int BLOCK = State.BLOCK;

    /** Turn in a substep from which on cosines are found anew. */
    private static final double LARGE = 0.25;

    /** Terms of the series of sine and cosine: 1/n!. */
    private static final double S3 = 1.0 / 6;

    private static final double C4 = 1.0 / 24;
    private static final double S5 = 1.0 / 120;
    private static final double C6 = 1.0 / 720;
    private static final double S7 = 1.0 / 5_040;
    private static final double C8 = 1.0 / 40_320;
    private static final double S9 = 1.0 / 362_880;
    private static final double C10 = 1.0 / 3_628_800;
    private static final double S11 = 1.0 / 39_916_800;

    private final State state;

    /** Bodies with a pin beside their centre; the angles at which their cosines and sines hold. */
    private final IntList bodies = new IntList();

    private double[] angles = {};

    /** [cos θ, sin θ] by body; NaN where it is not found yet. */
    double[] values = {};

    ArmTurns(State state) {
        this.state = state;
    }

    /** Begins with none. */
    void clear() {
        bodies.clear();
        values = new double[2 * state.size()];
    }

    /** A body has such an arm, unless it ends at its centre. */
    void need(int block, double x, double y) {
        if (block >= 0 && (x != 0 || y != 0) && !Double.isNaN(values[2 * (block / BLOCK)])) {
            values[2 * (block / BLOCK)] = Double.NaN;
            bodies.add(block / BLOCK);
        }
    }

    /** All are to be found anew. */
    void forget() {
        if (angles.length != bodies.size) {
            angles = new double[bodies.size];
        }
        Arrays.fill(angles, Double.NaN);
    }

    /** Finds them where the bodies are: turned on by what the angles have changed since the last substep, with series for small turns. */
    void follow() {
        double[] x = state.x();
        for (int k = 0; k < bodies.size; k++) {
            int body = bodies.values[k];
            double theta = x[BLOCK * body + State.THETA];
            double by = theta - angles[k];
            angles[k] = theta;
            if (!(Math.abs(by) < LARGE)) {
                Trig.sinCos(theta, values, 2 * body);
            } else if (by != 0) {
                double s = by * by;
                double sin = by * (1 - s * (S3 - s * (S5 - s * (S7 - s * (S9 - s * S11)))));
                double cos = 1 - s * (0.5 - s * (C4 - s * (C6 - s * (C8 - s * C10))));
                double c = values[2 * body];
                double t = values[2 * body + 1];
                values[2 * body] = c * cos - t * sin;
                values[2 * body + 1] = t * cos + c * sin;
            }
        }
    }
}
