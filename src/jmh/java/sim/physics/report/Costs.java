// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What a given error costs on a curve, and how the curves of a suite compare. */
final class Costs {
    static final double[] ERRORS = {1e-3, 1e-6, 1e-9, 1e-12};

    private Costs() {}

    /** The least cost from which on an error is not exceeded, interpolated in logarithms; infinite if never. */
    static double at(double error, List<Point> curve) {
        double least = Double.POSITIVE_INFINITY;
        Point before = null;
        for (Point p : curve) {
            if (p.error() <= error) {
                double cost = p.cost();
                if (before != null && before.error() > error && before.error() < 1e3 && before.cost() < p.cost()) {
                    double share = Math.log(before.error() / error)
                            / Math.log(before.error() / Math.max(1e-17, p.error()));
                    cost = before.cost() * Math.pow(p.cost() / before.cost(), share);
                }
                least = Math.min(least, cost);
            }
            before = p;
        }
        return least;
    }

    /** By contender: its costs of all tasks, an error in a scene each, over the best one's, ascending. */
    static Map<String, double[]> ratios(Map<Scene, List<Point>> scenes) {
        Map<String, double[]> ratios = new LinkedHashMap<>();
        int tasks = scenes.size() * ERRORS.length;
        int task = 0;
        for (List<Point> points : scenes.values()) {
            Map<String, List<Point>> curves = Plots.curves(points);
            for (double error : ERRORS) {
                double best = curves.values().stream().mapToDouble(c -> at(error, c)).min().orElse(1);
                int now = task++;
                curves.forEach((label, curve) -> {
                    double[] all = ratios.computeIfAbsent(label, k -> {
                        double[] none = new double[tasks];
                        Arrays.fill(none, Double.POSITIVE_INFINITY);
                        return none;
                    });
                    double cost = at(error, curve);
                    all[now] = cost < Double.POSITIVE_INFINITY ? cost / best : cost;
                });
            }
        }
        ratios.values().forEach(Arrays::sort);
        return ratios;
    }
}
