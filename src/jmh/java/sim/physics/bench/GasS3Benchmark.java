// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/**
 * Scene S3 of the comparison of peers: half disks, half boxes, area fraction 0.2, e = 1, no friction, dt = 1/60.
 *
 * <p>The score of {@link #fresh} is µs of wall time per step over the first 600 steps of fresh scenes: fresh, because
 * several engines lose or gain energy, and a gas that stands still is cheap. To beat: 1/8 of dyn4j's best setting, 1/15
 * of JBox2D. {@link PairedRun} gives thread CPU time, interleaved, with the energy.
 */
public class GasS3Benchmark extends GasBenchmark {
    private static final int STEPS = 600;

    /** A scene that is new in each invocation; an invocation is long enough for JMH's clock around it. */
    public static class Fresh extends Scene {
        /** Number of bodies. */
        @Param({"100", "1000"})
        public int n;

        /** One of {@link Engines#NAMES}. */
        @Param({"own", "dyn4j", "dyn4j-noccd", "jbox2d", "jbox2d-noccd"})
        public String engine;

        /** Whether all poses are read after each step. */
        @Param("false")
        public boolean read;

        /** Builds the next scene. */
        @Setup(Level.Invocation)
        public void build() {
            next(BenchScene.S3, engine, n);
        }
    }

    /** One scene that goes on. */
    public static class Continued extends Scene {
        /** Number of bodies. */
        @Param({"100", "1000"})
        public int n;

        /** One of {@link Engines#NAMES}; only engines that keep the energy stay comparable. */
        @Param("own")
        public String engine;

        /** Builds the scene. */
        @Setup(Level.Trial)
        public void build() {
            next(BenchScene.S3, engine, n);
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
