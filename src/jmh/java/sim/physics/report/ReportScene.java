// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.function.Function;
import java.util.function.Supplier;

/** A scene of the suite, with its reference. */
final class ReportScene {
    final String id;
    final String title;
    final Model model;
    final double duration;

    /** Number of equally spaced instants at which places are compared; 1: at the end. */
    final int samples;

    /** Steps from one instant to the next at the coarsest setting. */
    final int coarse;

    String reference = "";
    String note = "";

    /** Whether integrators matter here; else bodies follow exact paths between impacts. */
    boolean smooth = true;

    /** Which of our methods are run; null for those that {@link #smooth} says. */
    java.util.List<OwnMethod> methods;

    /** Whether forces depend on places alone. */
    boolean conservative = true;

    /** The unit of error, length. */
    double unit = 1;

    /** Whether no wall holds the bodies, so that momenta are conserved. */
    boolean free;

    /** The unit of energy, or NaN where it is not conserved. */
    double energyUnit = Double.NaN;

    /** Points that are compared: part, and x and y in its own coordinates. */
    double[][] points = {};

    /** For each instant x and y of each point; null where the error is that of energy. */
    Supplier<double[][]> expected;

    /** Why an engine is not in this scene; null if it is. */
    Function<String, String> cannot = engine -> null;

    ReportScene(String id, String title, Model model, double duration, int samples, int coarse) {
        this.id = id;
        this.title = title;
        this.model = model;
        this.duration = duration;
        this.samples = samples;
        this.coarse = coarse;
    }

    double[] times() {
        double[] t = new double[samples];
        for (int k = 0; k < samples; k++) {
            t[k] = duration * (k + 1) / samples;
        }
        return t;
    }

    ReportScene point(int part, double x, double y) {
        points = java.util.Arrays.copyOf(points, points.length + 1);
        points[points.length - 1] = new double[] {part, x, y};
        return this;
    }

    /** The largest distance of a point from where it should be; or the largest relative error of energy. */
    double error(double[][] states, double[][] reference) {
        if (reference == null) {
            return energyError(states);
        }
        double most = 0;
        for (int k = 0; k < samples; k++) {
            for (int p = 0; p < points.length; p++) {
                double[] at = model.local((int) points[p][0], points[p][1], points[p][2], states[k]);
                double d = Math.hypot(at[0] - reference[k][2 * p], at[1] - reference[k][2 * p + 1]) / unit;
                most = d <= most ? most : d;
            }
        }
        return most;
    }

    double energyError(double[][] states) {
        double begun = model.energy(model.start());
        double most = 0;
        for (double[] state : states) {
            double d = Math.abs(model.energy(state) - begun) / energyUnit;
            most = d <= most ? most : d;
        }
        return most;
    }

    double momentumError(double[][] states) {
        if (!free) {
            return Double.NaN;
        }
        double[] begun = model.momentum(model.start());
        double scale = Math.sqrt(energyUnit * model.parts.size());
        double most = 0;
        for (double[] state : states) {
            double[] now = model.momentum(state);
            for (int k = 0; k < 3; k++) {
                most = Math.max(most, Math.abs(now[k] - begun[k]) / scale);
            }
        }
        return most;
    }
}
