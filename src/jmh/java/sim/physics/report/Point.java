// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.Map;

/** A point of a curve. */
final class Point {
    final double setting;

    /** CPU seconds of the run that is not timed. */
    double spent;

    /** CPU seconds for a simulated second. */
    double cpu;

    double error;
    double energy = Double.NaN;
    double momentum = Double.NaN;
    double gap = Double.NaN;
    double penetration = Double.NaN;
    Map<String, Long> counts = Map.of();

    Point(double setting) {
        this.setting = setting;
    }
}
