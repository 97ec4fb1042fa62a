// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;

/**
 * Compares engines on the machines of {@link Machine}, jointed bodies with motors and stops on the ground: 600 steps of 1/60 s.
 * Engines take turns in one JVM with fresh machines; times are CPU times of the stepping thread, medians of rounds after ten and 25 s that do not
 * count (after 3,000 steps our engine still takes twice as long as when all of it is compiled). Then each
 * engine's errors are printed, found in a run of their own.
 *
 * <pre>
 * MachineRun rounds [machines …]        MachineRun 5
 * </pre>
 */
public final class MachineRun {
    private static final int STEPS = 600;
    private static final double WARM_UP = 25;
    private static final int LEAST_WARM_UP = 10;
    private static final String[] ENGINES = {"ours", "stepped", "JBox2D", "dyn4j"};
    private static final List<Supplier<MachineWorld>> MAKERS =
            List.of(OwnMachine::new, () -> new OwnMachine(4), JBox2DMachine::new, Dyn4jMachine::new);

    private MachineRun() {}

    /**
     * Runs the comparison.
     *
     * @param args rounds, and names of machines; none: all
     */
    public static void main(String[] args) {
        int rounds = Integer.parseInt(args[0]);
        List<String> names = args.length > 1
                ? List.of(args).subList(1, args.length)
                : new ArrayList<>(Machine.ALL.keySet());
        for (String name : names) {
            double[][] times = times(name, rounds);
            for (int e = 0; e < ENGINES.length; e++) {
                print(name, e, times);
            }
        }
    }

    private static double[][] times(String name, int rounds) {
        double[][] times = new double[ENGINES.length][rounds];
        for (int round = 0; round < LEAST_WARM_UP; round++) {
            runAll(name);
        }
        WarmUp.run(WARM_UP, () -> runAll(name));
        for (int round = 0; round < rounds; round++) {
            double[] all = runAll(name);
            for (int e = 0; e < ENGINES.length; e++) {
                times[e][round] = all[e];
            }
        }
        for (double[] time : times) {
            Arrays.sort(time);
        }
        return times;
    }

    /** Times of a step, of all engines in turn. */
    private static double[] runAll(String name) {
        double[] times = new double[ENGINES.length];
        for (int e = 0; e < ENGINES.length; e++) {
            MachineWorld world = MAKERS.get(e).get();
            times[e] = run(new Machine(name, world), world);
        }
        return times;
    }

    /** Time of a step in µs. */
    private static double run(Machine machine, MachineWorld world) {
        ThreadMXBean clock = ManagementFactory.getThreadMXBean();
        long begun = clock.getCurrentThreadCpuTime();
        for (int step = 0; step < STEPS; step++) {
            machine.control(step);
            world.step();
        }
        return (clock.getCurrentThreadCpuTime() - begun) * 1e-3 / STEPS;
    }

    private static void print(String name, int e, double[][] times) {
        JudgedMachine judged = new JudgedMachine(MAKERS.get(e).get());
        Machine machine = new Machine(name, judged);
        for (int step = 0; step < STEPS; step++) {
            machine.control(step);
            judged.step();
        }
        double[] time = times[e];
        int middle = time.length / 2;
        System.out.printf(
                Locale.ROOT,
                "%-8s %-7s %8.1f us/step [%.1f, %.1f] %5.2f x; depth %.1e m, gap %.1e m, stop %.1e rad; x %.4f, y %.6f, vx %.9f%n",
                name, ENGINES[e], time[middle], time[0], time[time.length - 1], times[0][middle] / time[middle],
                judged.depth, judged.gap, judged.over, judged.x(machine.main), judged.y(machine.main),
                judged.vx(machine.main));
    }
}
