// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import sim.physics.scenes.SceneData;

/** A batch of fresh scenes of one kind in one engine: what is timed, warmed up in the same way for all engines. */
final class Batch {
    private final Runner[] runners;
    private final int steps;
    private final long expectedBodies;
    private double sink;

    /**
     * Builds a batch.
     *
     * @param engine one of {@link Engines#NAMES}
     * @param scene the kind of scene
     * @param n bodies in each
     * @param seed equal seeds give equal scenes for all engines
     */
    Batch(String engine, BenchScene scene, int n, long seed) {
        runners = new Runner[scene.copies(n)];
        steps = scene.steps(n);
        expectedBodies = (long) n * runners.length;
        for (int c = 0; c < runners.length; c++) {
            SceneData data = scene.make(n, 1000 * seed + c);
            runners[c] = Engines.create(engine, data);
        }
    }

    /** Builds and runs batches, not timed, for a number of seconds; short runs of Java engines are cold. */
    static void warmUp(String engine, BenchScene scene, int n, boolean read, double seconds) {
        long[] seed = {0};
        WarmUp.run(seconds, () -> new Batch(engine, scene, n, --seed[0]).run(read));
    }

    /** {@return the steps that {@link #run} makes, over all scenes} */
    long steps() {
        return (long) steps * runners.length;
    }

    /** Steps every scene, one after the other; with {@code read} all poses are read after each step. */
    double run(boolean read) {
        for (Runner runner : runners) {
            for (int s = 0; s < steps; s++) {
                runner.step();
                if (read) {
                    sink += runner.readPoses();
                }
            }
        }
        return sink;
    }

    /** {@return the kinetic energy of all scenes} */
    double kineticEnergy() {
        double sum = 0;
        for (Runner runner : runners) {
            sum += runner.kineticEnergy();
        }
        return sum;
    }

    /** {@return the moving bodies that were put into all scenes} */
    long expectedBodies() {
        return expectedBodies;
    }

    /** {@return the moving bodies that the engines hold} */
    long bodies() {
        long sum = 0;
        for (Runner runner : runners) {
            sum += runner.bodies();
        }
        return sum;
    }
}
