// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/**
 * Figure 1 of the write-up, at its density, with 10 to 1000 bodies, Euler, dt = 1.
 *
 * <p>The score of {@link #fresh} is µs of wall time per step over the first 1000 steps of fresh scenes. The original made
 * {@link #ORIGINAL_STEPS_PER_SECOND} steps per second of these scenes (the first 300 steps with 1000 bodies), warmed, per
 * second of its thread's CPU time. {@link PairedRun} prints the ratio.
 *
 * <table>
 * <caption>Time per step</caption>
 * <tr><th>bodies</th><th>original, µs</th><th>to beat: times faster</th><th>that is, µs</th></tr>
 * <tr><td>10</td><td>6.10</td><td>5</td><td>1.22</td></tr>
 * <tr><td>30</td><td>32.3</td><td>10</td><td>3.23</td></tr>
 * <tr><td>100</td><td>139</td><td>30</td><td>4.63</td></tr>
 * <tr><td>300</td><td>1087</td><td>100</td><td>10.9</td></tr>
 * <tr><td>1000</td><td>11364</td><td>400</td><td>28.4</td></tr>
 * </table>
 */
public class Figure1Benchmark extends GasBenchmark {
    /** Numbers of bodies of {@link #ORIGINAL_STEPS_PER_SECOND}. */
    static final int[] ORIGINAL_BODIES = {10, 30, 100, 300, 1000};

    /** What the original engine made with Euler; measured before, not in the same run. */
    static final double[] ORIGINAL_STEPS_PER_SECOND = {164_000, 31_000, 7_200, 920, 88};

    private static final int STEPS = 1000;

    /** A scene that is new in each invocation; an invocation is long enough for JMH's clock around it. */
    public static class Fresh extends Scene {
        /** Number of bodies. */
        @Param({"10", "30", "100", "300", "1000"})
        public int n;

        /** One of {@link Engines#NAMES}. */
        @Param({"own-euler", "jbox2d"})
        public String engine;

        /** Whether all poses are read after each step. */
        @Param("false")
        public boolean read;

        /** Builds the next scene. */
        @Setup(Level.Invocation)
        public void build() {
            next(BenchScene.FIGURE1, engine, n);
        }
    }

    /** One scene that goes on. */
    public static class Continued extends Scene {
        /** Number of bodies. */
        @Param({"10", "30", "100", "300", "1000"})
        public int n;

        /** One of {@link Engines#NAMES}; only engines that keep the energy stay comparable. */
        @Param("own-euler")
        public String engine;

        /** Builds the scene. */
        @Setup(Level.Trial)
        public void build() {
            next(BenchScene.FIGURE1, engine, n);
        }
    }

    /** Time per step of fresh scenes. */
    @Benchmark
    @OperationsPerInvocation(STEPS)
    public double fresh(Fresh scene) {
        return scene.run(STEPS, scene.read);
    }

    /** Time per step of a scene that goes on; with {@code -prof gc}, the bytes of a step and of nothing else. */
    @Benchmark
    public void steady(Continued scene) {
        scene.step();
    }
}
