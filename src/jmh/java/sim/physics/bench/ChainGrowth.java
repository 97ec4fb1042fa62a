// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.Arrays;
import java.util.Locale;

/**
 * The time per link of chains of some lengths, this engine alone: the first steps of the fall of {@link ChainRun}'s chains, so that
 * all of them do the same. Lengths take turns.
 *
 * <pre>
 * ChainGrowth rounds n n …     ChainGrowth 9 10 100 1000 10000 100000
 * </pre>
 */
public final class ChainGrowth {
    private static final int STEPS = 100;

    /** Steps of a link that a round makes at least. */
    private static final int LINK_STEPS = 2_000_000;

    private static final double WARM_UP = 10;

    private ChainGrowth() {}

    /**
     * Measures.
     *
     * @param args rounds, numbers of links
     */
    public static void main(String[] args) {
        int[] lengths = Arrays.stream(args).skip(1).mapToInt(Integer::parseInt).toArray();
        double[][] times = new double[lengths.length][Integer.parseInt(args[0])];
        WarmUp.run(WARM_UP, () -> Arrays.stream(lengths).forEach(ChainGrowth::timePerLink));
        for (int round = 0; round < times[0].length; round++) {
            for (int k = 0; k < lengths.length; k++) {
                times[k][round] = timePerLink(lengths[k]);
            }
        }
        double[] medians = Arrays.stream(times).mapToDouble(all -> Arrays.stream(all).sorted().toArray()[all.length / 2]).toArray();
        for (int k = 0; k < lengths.length; k++) {
            System.out.printf(Locale.ROOT, "%6d: %.0f ns a link and step%n", lengths[k], medians[k]);
        }
        double least = Arrays.stream(medians).min().orElseThrow();
        double most = Arrays.stream(medians).max().orElseThrow();
        System.out.printf(
                Locale.ROOT, "%.0f ns with %.0f %% more or less%n", (most + least) / 2, 100 * (most - least) / (most + least));
    }

    private static double timePerLink(int n) {
        int repeats = Math.max(1, LINK_STEPS / (STEPS * n));
        double time = 0;
        for (int k = 0; k < repeats; k++) {
            Runnable step = ChainRun.own(n);
            step.run(); // makes the island, once
            step.run();
            time += CpuTime.of(step, STEPS);
        }
        return time / ((double) repeats * STEPS * n);
    }
}
