// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** What the benchmarks of gases have in common: µs of wall time per step, and how a scene is set up and run. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 3)
@Measurement(iterations = 5, time = 2)
@Fork(2)
public abstract class GasBenchmark {
    /** A scene in an engine; subclasses say which, by their parameters. */
    @State(Scope.Thread)
    public abstract static class Scene {
        private Runner runner;
        private long seed;

        /** Sets up the next scene of a kind: others of equal kind and number start alike in all engines. */
        final void next(BenchScene kind, String engine, int n) {
            seed++;
            runner = Engines.create(engine, kind.make(n, seed));
        }

        /** Makes one step; with {@code -prof gc}, the bytes of a step and of nothing else. */
        final void step() {
            runner.step();
        }

        /** Makes a number of steps, and reads all poses after each if asked to. */
        final double run(int steps, boolean read) {
            double sum = 0;
            for (int s = 0; s < steps; s++) {
                runner.step();
                if (read) {
                    sum += runner.readPoses();
                }
            }
            return sum;
        }
    }
}
