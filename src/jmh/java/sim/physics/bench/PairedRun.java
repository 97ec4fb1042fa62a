// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import com.sun.management.OperatingSystemMXBean;
import com.sun.management.ThreadMXBean;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.io.Writer;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Compares engines on one scene, interleaved: A B C A B C …, so that a noisy machine is noisy for all of them.
 *
 * <p>Each engine has a JVM of its own, which waits while the others run, and a new one every third round, because what the
 * compiler makes of an engine differs from JVM to JVM. Within a round all engines get the same fresh scenes, in an order
 * that moves on by one each round. Printed per engine: µs of the stepping thread's CPU time per step
 * (median, least, largest), µs of the whole process's (with compiler and collector), bytes allocated per step, kinetic
 * energy at the end over that at the start, and the median of the rounds' ratios to the first engine. A ratio of 8
 * means that the first engine is 8 times faster.
 *
 * <pre>
 * PairedRun scene n rounds [engines] [read]
 * PairedRun s3 1000 9 own,dyn4j-noccd,jbox2d
 * PairedRun figure1 100 9 own-euler,jbox2d
 * PairedRun s3 100 5 dyn4j,dyn4j-noccd,jbox2d read
 * </pre>
 *
 * <p>Scenes are s3, circles, figure1 and polygons; with {@code read} all poses are read after each step.
 */
public final class PairedRun {
    private static final double WARM_UP_SECONDS = 6;
    private static final int ROUNDS_PER_JVM = 3;

    private PairedRun() {}

    /**
     * Runs the comparison.
     *
     * @param args scene, number of bodies, rounds, engines with commas between, "read"
     * @throws IOException if an engine's JVM fails
     */
    public static void main(String[] args) throws IOException {
        if (args.length > 0 && args[0].equals("--engine")) {
            serve(args[1], BenchScene.of(args[2]), Integer.parseInt(args[3]), Boolean.parseBoolean(args[4]));
            return;
        }
        if (args.length < 3) {
            System.err.println("arguments: scene n rounds [engines] [read]");
            System.err.println("scenes: s3 circles figure1 polygons; engines: " + Engines.NAMES);
            return;
        }
        BenchScene scene = BenchScene.of(args[0]);
        int n = Integer.parseInt(args[1]);
        int rounds = Integer.parseInt(args[2]);
        String[] engines = (args.length > 3 ? args[3] : "own,dyn4j-noccd,jbox2d").split(",");
        boolean read = args.length > 4 && args[4].equals("read");
        System.out.println(scene.make(n, 1000));
        System.out.printf(
                Locale.ROOT,
                "%d rounds of %d x %d steps, JDK %s, poses %s%n",
                rounds, scene.copies(n), scene.steps(n), Runtime.version(), read ? "read each step" : "not read");
        double[][][] results = interleave(engines, new String[] {args[0], args[1], Boolean.toString(read)}, rounds);
        report(engines, results, scene, n);
    }

    /** Results by engine, then by {@link Column}, then by round. */
    private static double[][][] interleave(String[] engines, String[] scene, int rounds) throws IOException {
        double[][][] results = new double[engines.length][Column.values().length][rounds];
        for (int first = 0; first < rounds; first += ROUNDS_PER_JVM) {
            List<Child> children = new ArrayList<>();
            try {
                for (String engine : engines) {
                    children.add(new Child(engine, scene));
                }
                for (int round = first; round < Math.min(rounds, first + ROUNDS_PER_JVM); round++) {
                    play(round, children, results);
                }
            } finally {
                children.forEach(Child::close);
            }
        }
        return results;
    }

    private static void play(int round, List<Child> children, double[][][] results) throws IOException {
        for (int k = 0; k < children.size(); k++) {
            int e = (round + k) % children.size();
            double[] row = children.get(e).ask(round + 1);
            for (int c = 0; c < row.length; c++) {
                results[e][c][round] = row[c];
            }
        }
    }

    private static void report(String[] engines, double[][][] results, BenchScene scene, int n) {
        System.out.printf(
                "%-18s %12s %21s %12s %12s %10s %10s%n",
                "engine", "us/step", "[least, largest]", "process us", "bytes/step", "KE ratio", "x " + engines[0]);
        for (int e = 0; e < engines.length; e++) {
            double[] cpu = results[e][Column.THREAD.ordinal()];
            double[] ratios = new double[cpu.length];
            Arrays.setAll(ratios, r -> cpu[r] / results[0][Column.THREAD.ordinal()][r]);
            if (e == 0) {
                Arrays.fill(ratios, 1);
            }
            System.out.printf(
                    Locale.ROOT,
                    "%-18s %12.3f [%9.3f,%9.3f] %12.3f %12.0f %10.6f %10.2f",
                    engines[e], median(cpu), Arrays.stream(cpu).min().orElseThrow(),
                    Arrays.stream(cpu).max().orElseThrow(), median(results[e][Column.PROCESS.ordinal()]),
                    median(results[e][Column.BYTES.ordinal()]), median(results[e][Column.ENERGY.ordinal()]), median(ratios));
            System.out.println(scene == BenchScene.FIGURE1 ? original(n, median(cpu)) : "");
        }
    }

    private static String original(int n, double micros) {
        int k = Arrays.binarySearch(Figure1Benchmark.ORIGINAL_BODIES, n);
        if (k < 0) {
            return "";
        }
        double ratio = 1e6 / micros / Figure1Benchmark.ORIGINAL_STEPS_PER_SECOND[k];
        return String.format(Locale.ROOT, "   %.1f x the original", ratio);
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int middle = sorted.length / 2;
        return sorted.length % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
    }

    /** What a round of an engine gives. */
    private enum Column {
        THREAD,
        PROCESS,
        BYTES,
        ENERGY
    }

    /** The engine's side: warms up, then runs one batch for each seed that it is told. */
    private static void serve(String engine, BenchScene scene, int n, boolean read) throws IOException {
        // engines may print; the answers have a stream of their own
        PrintStream answers = System.out;
        System.setOut(System.err);
        Batch.warmUp(engine, scene, n, read, WARM_UP_SECONDS);
        answers.println("ready");
        answers.flush();
        BufferedReader seeds = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String seed = seeds.readLine(); seed != null; seed = seeds.readLine()) {
            answers.println(measure(new Batch(engine, scene, n, Long.parseLong(seed)), read));
            answers.flush();
        }
    }

    private static String measure(Batch batch, boolean read) {
        ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        OperatingSystemMXBean process = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        double energy = batch.kineticEnergy();
        long bytes = thread.getCurrentThreadAllocatedBytes();
        long processNanos = process.getProcessCpuTime();
        long nanos = thread.getCurrentThreadCpuTime();
        batch.run(read);
        nanos = thread.getCurrentThreadCpuTime() - nanos;
        processNanos = process.getProcessCpuTime() - processNanos;
        bytes = thread.getCurrentThreadAllocatedBytes() - bytes;
        if (batch.bodies() != batch.expectedBodies()) {
            throw new IllegalStateException(
                    "the engine holds " + batch.bodies() + " of " + batch.expectedBodies() + " bodies");
        }
        double steps = batch.steps();
        return nanos / steps / 1000 + " " + processNanos / steps / 1000 + " " + bytes / steps + " "
                + batch.kineticEnergy() / energy;
    }

    /** An engine's JVM, as seen from here. */
    private static final class Child {
        private final Process process;
        private final Writer seeds;
        private final BufferedReader answers;

        Child(String engine, String[] scene) throws IOException {
            List<String> command = new ArrayList<>();
            command.add(ProcessHandle.current().info().command().orElse("java"));
            // one stepping thread is compared: a collector that works on the second core would hide its cost
            command.addAll(List.of("-XX:+UseSerialGC", "-Xms512m", "-Xmx512m"));
            command.addAll(List.of("-cp", System.getProperty("java.class.path")));
            command.addAll(List.of(PairedRun.class.getName(), "--engine", engine));
            command.addAll(List.of(scene));
            process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
            seeds = process.outputWriter(StandardCharsets.UTF_8);
            answers = process.inputReader(StandardCharsets.UTF_8);
            String first = answers.readLine();
            if (!"ready".equals(first)) {
                process.destroy();
                throw new IOException("engine " + engine + " did not start: " + first);
            }
        }

        /** Has the engine run the scenes of a seed. */
        double[] ask(long seed) throws IOException {
            seeds.write(seed + "\n");
            seeds.flush();
            String answer = answers.readLine();
            if (answer == null) {
                throw new IOException("an engine's JVM ended in round " + seed);
            }
            return Arrays.stream(answer.split(" ")).mapToDouble(Double::parseDouble).toArray();
        }

        void close() {
            process.destroy();
        }
    }
}
