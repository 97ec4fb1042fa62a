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

    /** Part of the most CPU seconds of a run from which runs are timed in fewer rounds. */
    private static final double LONG = 0.1;

    private static final int FEW_ROUNDS = 3;

    /** How much longer than predicted a run may take before it is stopped, and steps after which that is asked. */
    private static final double SURPRISE = 2;

    private static final int LOOK = 256;

    /** How often steps may be divided by four without a smaller error, before a method of first order is taken to be at its end. */
    private static final int IDLE = 3;

    /** Part of the time of a scene that the untimed runs take, for the progress bar. */
    private static final double SWEEPS = 0.3;

    private final ReportScene scene;
    private final PythonPeers python;
    private final double cap;
    private final double[][] reference;
    final Map<Curve, List<Point>> points = new LinkedHashMap<>();
    final Map<Curve, String> failures = new LinkedHashMap<>();

    /** What was not run, since it would take too long: the setting from which on, and how many CPU seconds were predicted. */
    final Map<Curve, double[]> omitted = new LinkedHashMap<>();

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

    /** An estimate of the CPU seconds that {@link #run} takes. */
    static double expected(ReportScene scene, PythonPeers python, double cap, int rounds) {
        double sum = 0;
        for (Curve curve : Curve.all(scene, python)) {
            sum += cap * (curve.isAdaptive() ? 0.3 : curve.order() == 1 ? 1 : 1.5);
        }
        return sum * (1 + Math.min(rounds, FEW_ROUNDS));
    }

    void run(int rounds, Progress progress) {
        List<Curve> curves = Curve.all(scene, python);
        Map<Point, double[]> times = new LinkedHashMap<>();
        double whole = 0;
        for (int k = 0; k < curves.size(); k++) {
            progress.show(scene.id + " " + curves.get(k).name(), SWEEPS * k / curves.size());
            List<Point> found = sweep(curves.get(k));
            points.put(curves.get(k), found);
            for (Point point : found) {
                times.put(point, new double[point.spent > LONG * cap ? Math.min(FEW_ROUNDS, rounds) : rounds]);
                whole += times.get(point).length * point.spent;
            }
        }
        double done = 0;
        for (int round = -1; round < rounds; round++) {
            for (Map.Entry<Curve, List<Point>> entry : points.entrySet()) {
                progress.show(scene.id + " round " + (round + 1) + " of " + rounds, SWEEPS + (1 - SWEEPS) * done / whole);
                if (round < 0) {
                    warmUp(entry.getKey(), entry.getValue());
                    continue;
                }
                for (Point point : entry.getValue()) {
                    if (round < times.get(point).length) {
                        times.get(point)[round] = time(entry.getKey(), point.setting);
                        done += point.spent;
                    }
                }
            }
        }
        times.forEach((point, all) -> {
            Arrays.sort(all);
            point.cpu = all[all.length / 2] / scene.duration;
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

    /** Error and counts of one setting of our own; null if it is too coarse for the method. */
    static Point untimed(ReportScene scene, Curve curve, double setting, double[][] reference) {
        Point point = new Point(setting);
        double[][] states = new double[scene.samples][Model.BLOCK * scene.model.parts.size()];
        try (World world = curve.world(scene, setting, true)) {
            for (double[] state : states) {
                for (int k = 0; k < curve.steps(setting); k++) {
                    world.step();
                }
                world.read(state);
            }
            point.counts = world.counts();
        } catch (RuntimeException problem) {
            return null;
        }
        point.error = scene.error(states, reference);
        return Double.isFinite(point.error) ? point : null;
    }

    /** From coarse to fine until a run would cost too much, or nothing is gained any more. */
    private List<Point> sweep(Curve curve) {
        List<Point> found = new ArrayList<>();
        double best = Double.POSITIVE_INFINITY;
        double predicted = 0;
        int idle = 0;
        for (double setting : curve.settings(scene)) {
            if (predicted > cap) {
                omitted.put(curve, new double[] {setting, predicted});
                break;
            }
            Point point = new Point(setting);
            try {
                accuracy(curve, point);
            } catch (TooLong surprise) {
                omitted.put(curve, new double[] {setting, point.spent});
                break;
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
            predicted = predict(curve, point.spent);
            if (idle >= (best < 1e-8 ? 2 : curve.order() == 1 ? IDLE : Integer.MAX_VALUE)) {
                break;
            }
        }
        return found;
    }

    /** CPU seconds of the next finer setting. */
    private static double predict(Curve curve, double spent) {
        return spent * (curve.isAdaptive() ? 1.5 : curve.order() == 1 ? 4 : 2);
    }

    /** A run takes much longer than was to be expected. */
    private static final class TooLong extends RuntimeException {
        private static final long serialVersionUID = 1L;
    }

    private static String brief(Throwable problem) {
        String words = String.valueOf(problem.getMessage());
        return words.length() > 120 ? words.substring(0, 120) + "…" : words;
    }

    private void accuracy(Curve curve, Point point) {
        double[][] states = new double[scene.samples][Model.BLOCK * scene.model.parts.size()];
        if (Curve.isPython(curve.engine())) {
            point.spent = python.run(curve, scene, point.setting, states);
        } else {
            long begun = cpu();
            try (World world = curve.world(scene, point.setting, true)) {
                int steps = curve.steps(point.setting);
                long all = 0;
                for (double[] state : states) {
                    for (int k = 0; k < steps; k++, all++) {
                        world.step();
                        if (all % LOOK == 0 || k == 0) {
                            lookAtClock(begun, point);
                        }
                    }
                    world.read(state);
                }
                point.counts = world.counts();
            }
            point.spent = (cpu() - begun) * 1e-9;
        }
        point.error = scene.error(states, reference);
        point.energy = scene.energyError(states);
        point.momentum = scene.momentumError(states);
        boolean joints = scene.model.hasJoints();
        for (double[] state : states) {
            if (joints) {
                point.gap = larger(point.gap, scene.model.gap(state));
            }
            if (!scene.smooth) {
                point.penetration = larger(point.penetration, Math.max(0, scene.model.penetration(state)));
            }
        }
    }

    private void lookAtClock(long begun, Point point) {
        point.spent = (cpu() - begun) * 1e-9;
        if (point.spent > SURPRISE * cap) {
            throw new TooLong();
        }
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
