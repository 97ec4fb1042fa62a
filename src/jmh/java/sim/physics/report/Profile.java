// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Times at fixed error, and Dolan and Moré's profile over them. */
final class Profile {
    static final double[] TARGETS = {1e-3, 1e-6, 1e-9, 1e-12};

    /** Per problem the CPU time of each solver, infinite where it does not get there. */
    private final List<Map<String, Double>> problems = new ArrayList<>();

    /** The least CPU time at which a curve is below an error, interpolated; infinite for never. */
    static double time(List<Point> points, double target) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < points.size(); k++) {
            Point point = points.get(k);
            if (point.error <= target) {
                least = Math.min(least, k > 0 && points.get(k - 1).error > target ? between(points.get(k - 1), point, target) : point.cpu);
            }
        }
        return least;
    }

    private static double between(Point coarse, Point fine, double target) {
        double share = Math.log(coarse.error / target) / Math.log(coarse.error / Math.max(1e-17, fine.error));
        return Math.exp(Math.log(coarse.cpu) + share * Math.log(fine.cpu / coarse.cpu));
    }

    /** Adds the problems of a scene: an error each that at least one solver reaches. */
    void add(Measurement measurement) {
        for (double target : TARGETS) {
            Map<String, Double> times = new LinkedHashMap<>();
            measurement.points.forEach((curve, points) -> {
                double time = time(points, target);
                times.merge(curve.isOwn() ? "ours, any method" : curve.engine(), time, Math::min);
                if (curve.isOwn()) {
                    for (String method : new String[] {"RK4", "DOP853", "GBS"}) {
                        if (curve.method().equals(method) || curve.own().equals(OwnMethod.EXACT_PATHS)) {
                            times.merge("ours, " + method, time, Math::min);
                        }
                    }
                }
            });
            if (times.values().stream().anyMatch(Double::isFinite)) {
                problems.add(times);
            }
        }
    }

    int problems() {
        return problems.size();
    }

    List<String> solvers() {
        Map<String, Boolean> names = new LinkedHashMap<>();
        for (Map<String, Double> problem : problems) {
            problem.keySet().forEach(name -> names.put(name, true));
        }
        return new ArrayList<>(names.keySet());
    }

    private double[] ratios(String solver) {
        double[] ratios = new double[problems.size()];
        for (int k = 0; k < ratios.length; k++) {
            double best = problems.get(k).values().stream().mapToDouble(Double::doubleValue).min().orElseThrow();
            ratios[k] = problems.get(k).getOrDefault(solver, Double.POSITIVE_INFINITY) / best;
        }
        Arrays.sort(ratios);
        return ratios;
    }

    /** Share of the problems that a solver solves within a factor of the least time. */
    double share(String solver, double factor) {
        return Arrays.stream(ratios(solver)).filter(r -> r <= factor * (1 + 1e-12)).count() / (double) problems.size();
    }

    double[][] steps(String solver) {
        List<double[]> corners = new ArrayList<>();
        corners.add(new double[] {1, share(solver, 1)});
        for (double ratio : ratios(solver)) {
            if (Double.isFinite(ratio) && ratio > 1) {
                corners.add(new double[] {ratio, corners.get(corners.size() - 1)[1]});
                corners.add(new double[] {ratio, share(solver, ratio)});
            }
        }
        corners.add(new double[] {1e5, corners.get(corners.size() - 1)[1]});
        double[][] xy = new double[2][corners.size()];
        for (int k = 0; k < corners.size(); k++) {
            xy[0][k] = corners.get(k)[0];
            xy[1][k] = corners.get(k)[1];
        }
        return xy;
    }
}
