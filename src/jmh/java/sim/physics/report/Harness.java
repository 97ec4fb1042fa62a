// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Measures CPU times of this thread: the median of some runs after warm-up. */
final class Harness {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final int MOST_RUNS = 201;

    private final double seconds;
    private final double patience;
    private boolean failed;

    /**
     * Makes a harness.
     *
     * @param seconds to spend on a point, warm-up and measurement each
     * @param patience the longest single run, after which finer settings are left out
     */
    Harness(double seconds, double patience) {
        this.seconds = seconds;
        this.patience = patience;
    }

    /** Measures a contender at all its settings. */
    List<Point> measure(Scene scene, Contender contender) {
        List<Point> points = new ArrayList<>();
        for (double setting : contender.settings()) {
            Point point = measure(scene, contender, setting);
            points.add(point);
            if (point.cost() * scene.seconds() > patience) {
                break;
            }
        }
        return points;
    }

    private Point measure(Scene scene, Contender contender, double setting) {
        double spent = 0;
        Trial trial = null;
        for (int k = 0; k < 5 && spent < seconds || k == 0; k++) {
            trial = contender.trial().apply(setting);
            spent += time(trial);
        }
        double[] times = new double[MOST_RUNS];
        int runs = 0;
        for (spent = 0; runs < MOST_RUNS && (runs < 3 || spent < seconds) && spent < patience; runs++) {
            trial = contender.trial().apply(setting);
            times[runs] = time(trial);
            spent += times[runs];
        }
        Arrays.sort(times, 0, runs);
        double cost = times[runs / 2] / scene.seconds();
        if (failed) {
            return new Point(scene, contender, setting, cost, Double.POSITIVE_INFINITY, Double.NaN, Double.NaN);
        }
        return new Point(scene, contender, setting, cost, trial.error(), trial.energy(), trial.gap());
    }

    /** CPU time of a run; one that the engine gives up ends there. */
    private double time(Trial trial) {
        long begun = THREADS.getCurrentThreadCpuTime();
        try {
            trial.run();
            failed = false;
        } catch (IllegalStateException | IllegalArgumentException e) {
            failed = true;
        }
        return (THREADS.getCurrentThreadCpuTime() - begun) * 1e-9;
    }
}
