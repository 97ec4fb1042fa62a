// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import demos.robots.Robots;
import java.util.Arrays;
import java.util.Locale;

/**
 * Steps a second of the robots demo through MASON's schedule, warmed: {@code RobotsRun [rounds robots cans]}. A round is 40 seeds
 * of up to 2,000 steps, after half a minute to warm up; counted is the CPU time of the stepping thread, not the making of a model.
 */
public final class RobotsRun {
    private static final double WARM_UP = 30;
    private static final int SEEDS = 40;
    private static final int STEPS = 2000;

    private RobotsRun() {}

    public static void main(String[] args) {
        int rounds = args.length > 0 ? Integer.parseInt(args[0]) : 12;
        int robots = args.length > 1 ? Integer.parseInt(args[1]) : 2;
        int cans = args.length > 2 ? Integer.parseInt(args[2]) : 4;
        WarmUp.run(WARM_UP, () -> round(robots, cans));
        double[] rates = new double[rounds];
        for (int k = 0; k < rounds; k++) {
            rates[k] = round(robots, cans);
        }
        Arrays.sort(rates);
        System.out.printf(
                Locale.ROOT, "%d robots, %d cans: median %,.0f steps/s of %d rounds, %,.0f to %,.0f%n", robots, cans,
                rates[rounds / 2], rounds, rates[0], rates[rounds - 1]);
    }

    private static double round(int robots, int cans) {
        long nanos = 0;
        long steps = 0;
        for (int seed = 1; seed <= SEEDS; seed++) {
            Robots model = new Robots(seed);
            model.setRobots(robots);
            model.setCans(cans);
            model.start();
            nanos += CpuTime.of(() -> run(model), 1);
            steps += model.physics.getSteps();
        }
        return steps * 1e9 / nanos;
    }

    private static void run(Robots model) {
        for (int k = 0; k < STEPS && !model.isDone(); k++) {
            model.schedule.step(model);
        }
    }
}
