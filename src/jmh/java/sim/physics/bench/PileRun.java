// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;

/**
 * How time stepping grows with the number of bodies: discs and boxes of different size, half and half, that fall into a bin, 240 steps
 * of 1/60 s in four substeps, and the same in JBox2D and dyn4j, none with sleep. CPU times of a step in each quarter of the run, in
 * which the pile falls together from below.
 *
 * <pre>
 * PileRun engines bodies …        PileRun stepped,JBox2D,dyn4j 1000 10000
 * </pre>
 */
public final class PileRun {
    private static final int QUARTER = 60;
    private static final int SUBSTEPS = 4;
    private static final double WARM_UP = 10;
    private static final int FEW = 300;
    private static final Map<String, Supplier<MachineWorld>> ENGINES = new LinkedHashMap<>();

    static {
        ENGINES.put("stepped", () -> new OwnMachine(SUBSTEPS));
        ENGINES.put("JBox2D", JBox2DMachine::new);
        ENGINES.put("dyn4j", Dyn4jMachine::new);
    }

    private PileRun() {}

    /**
     * Runs the comparison.
     *
     * @param args names of engines with commas between them, and numbers of bodies
     */
    public static void main(String[] args) {
        String[] names = args[0].split(",");
        for (String name : names) {
            WarmUp.run(WARM_UP, () -> times(name, FEW));
        }
        for (int k = 1; k < args.length; k++) {
            int n = Integer.parseInt(args[k]);
            for (String name : names) {
                double[] times = times(name, n);
                System.out.printf(
                        Locale.ROOT, "%6d bodies, %-7s %9.2f %9.2f %9.2f %9.2f ms/step, %5.2f us a body at the end%n",
                        n, name, times[0], times[1], times[2], times[3], 1e3 * times[3] / n);
            }
        }
    }

    /** Times of a step in each quarter, ms. */
    private static double[] times(String name, int n) {
        MachineWorld world = ENGINES.get(name).get();
        Machine machine = new Machine(n, world);
        double[] times = new double[4];
        for (int quarter = 0; quarter < times.length; quarter++) {
            int[] step = {quarter * QUARTER};
            Runnable next = () -> {
                machine.control(step[0]++);
                world.step();
            };
            times[quarter] = CpuTime.of(next, QUARTER) * 1e-6 / QUARTER;
        }
        return times;
    }
}
