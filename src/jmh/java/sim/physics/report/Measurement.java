// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Measures the curves of a scene: each setting once untimed, for errors, invariants and counts; then several rounds in which
 * all points of all engines take turns, and of which the medians count.
 */
final class Measurement {
    private static final long LEAST_NANOS = 1_000_000;
    private static final long WARM_UP_NANOS = 100_000_000;

    private final ReportScene scene;
    private final PythonPeers python;
    private final double cap;
    private final double[][] reference;
    final Map<Curve, List<Point>> points = new LinkedHashMap<>();
    final Map<Curve, String> failures = new LinkedHashMap<>();

    /**
     * A measurement.
     *
     * @param cap the most CPU seconds of a run
     */
    Measurement(ReportScene scene, PythonPeers python, double cap) {
        this.scene = scene;
        this.python = python;
        this.cap = cap;
        reference = scene.expected == null ? null : scene.expected.get();
    }

    void run(int rounds, Progress progress) {
        for (Curve curve : Curve.all(scene, python)) {
            progress.show(scene.id + " " + curve.name());
            points.put(curve, sweep(curve));
        }
        Map<Point, double[]> times = new LinkedHashMap<>();
        for (int round = -1; round < rounds; round++) {
            progress.show(scene.id + " round " + (round + 1) + " of " + rounds);
            for (Map.Entry<Curve, List<Point>> entry : points.entrySet()) {
                if (round < 0) {
                    warmUp(entry.getKey(), entry.getValue());
                    continue;
                }
                for (Point point : entry.getValue()) {
                    times.computeIfAbsent(point, p -> new double[rounds])[round] = time(entry.getKey(), point.setting);
                }
            }
        }
        times.forEach((point, all) -> {
            Arrays.sort(all);
            point.cpu = all[rounds / 2] / scene.duration;
        });
    }

    /** Errors and counts of methods with a tolerance alone. */
    void sweepTolerances() {
        for (Curve curve : Curve.all(scene, python)) {
            if (curve.isAdaptive()) {
                points.put(curve, sweep(curve));
            }
        }
    }

    /** From coarse to fine until a run costs too much, or nothing is gained any more. */
    private List<Point> sweep(Curve curve) {
        List<Point> found = new ArrayList<>();
        double best = Double.POSITIVE_INFINITY;
        int idle = 0;
        for (double setting : curve.settings(scene)) {
            Point point = new Point(setting);
            double spent;
            try {
                spent = accuracy(curve, point);
            } catch (RuntimeException | LinkageError problem) {
                // a coarse step may be too coarse for a method: the finer ones count
                failures.put(curve, brief(problem));
                continue;
            }
            if (Double.isFinite(point.error)) {
                found.add(point);
            }
            idle = point.error < 0.7 * best ? 0 : idle + 1;
            best = Math.min(best, point.error);
            double next = spent * (curve.isAdaptive() ? 1.5 : curve.order() == 1 ? 4 : 2);
            if (next > cap || best < 1e-8 && idle >= 2) {
                break;
            }
        }
        return found;
    }

    private static String brief(Throwable problem) {
        String words = String.valueOf(problem.getMessage());
        return words.length() > 120 ? words.substring(0, 120) + "…" : words;
    }

    private double accuracy(Curve curve, Point point) {
        double[][] states = new double[scene.samples][Model.BLOCK * scene.model.parts.size()];
        double spent;
        if (Curve.isPython(curve.engine())) {
            spent = python.run(curve, scene, point.setting, states);
        } else {
            long begun = cpu();
            try (World world = curve.world(scene, point.setting, true)) {
                int steps = curve.steps(point.setting);
                for (double[] state : states) {
                    for (int k = 0; k < steps; k++) {
                        world.step();
                    }
                    world.read(state);
                    if ((cpu() - begun) * 1e-9 > 4 * cap) {
                        throw new IllegalStateException("stopped, as it took too long at " + point.setting);
                    }
                }
                point.counts = world.counts();
            }
            spent = (cpu() - begun) * 1e-9;
        }
        point.error = scene.error(states, reference);
        point.energy = scene.energyError(states);
        point.momentum = scene.momentumError(states);
        boolean joints = !scene.model.pins.isEmpty() || !scene.model.rods.isEmpty();
        for (double[] state : states) {
            if (joints) {
                point.gap = larger(point.gap, scene.model.gap(state));
            }
            if (!scene.smooth) {
                point.penetration = larger(point.penetration, Math.max(0, scene.model.penetration(state)));
            }
        }
        return spent;
    }

    private static double larger(double a, double b) {
        return a >= b ? a : b;
    }

    private void warmUp(Curve curve, List<Point> all) {
        long begun = cpu();
        if (all.isEmpty() || Curve.isPython(curve.engine())) {
            return;
        }
        while (cpu() - begun < WARM_UP_NANOS) {
            time(curve, all.get(all.size() / 2).setting);
        }
    }

    /** CPU seconds of a run, sampling and building outside the clock. */
    private double time(Curve curve, double setting) {
        if (Curve.isPython(curve.engine())) {
            return python.run(curve, scene, setting, null);
        }
        long spent = 0;
        int runs = 0;
        while (spent < LEAST_NANOS && runs < 200) {
            try (World world = curve.world(scene, setting, false)) {
                int steps = curve.steps(setting) * scene.samples;
                long begun = cpu();
                for (int k = 0; k < steps; k++) {
                    world.step();
                }
                spent += cpu() - begun;
            }
            runs++;
        }
        return spent * 1e-9 / runs;
    }

    private static long cpu() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }
}
