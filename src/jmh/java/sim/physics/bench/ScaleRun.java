// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Locale;
import org.openjdk.jol.info.GraphLayout;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.scenes.Gas;
import sim.physics.scenes.SceneData;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * This engine alone, at its ends: what it takes to start, how many disks collide in a second, what a body costs among many.
 *
 * <pre>
 * ScaleRun start 50          an engine is made, 50 bodies are added, and it makes its first step
 * ScaleRun disks 1000        impacts a second of equal disks, by the area that they cover
 * ScaleRun memory 100000 1500  bytes that all objects of an engine take, per body
 * ScaleRun unused 1000 40     a step of the engine against one that lacks what a gas does not use
 * ScaleRun growth 100000 9   time per body and step, a gas of 1000 and one of 100000 bodies in turns
 * </pre>
 */
public final class ScaleRun {
    private static final ThreadMXBean THREAD = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private static final double WARM_UP = 15;

    private ScaleRun() {}

    /**
     * Runs a measurement.
     *
     * @param args which, number of bodies, rounds
     */
    public static void main(String[] args) {
        int n = Integer.parseInt(args[1]);
        switch (args[0]) {
            case "start" -> start(n);
            case "disks" -> disks(n);
            case "growth" -> growth(n, Integer.parseInt(args[2]));
            case "unused" -> unused(n, Integer.parseInt(args[2]));
            case "memory" -> memory(n, Integer.parseInt(args[2]));
            default ->
                throw new IllegalArgumentException("what is " + args[0] + ": it must be start, disks, memory, unused or growth");
        }
    }

    private static void start(int n) {
        SceneData scene = Gas.s3(n, 5);
        int runs = 20_000;
        double[] micros = new double[runs];
        for (int r = 0; r < runs; r++) {
            long begin = System.nanoTime();
            new OwnRunner(scene, false, 0).step();
            micros[r] = (System.nanoTime() - begin) / 1e3;
        }
        double[] warm = Arrays.copyOfRange(micros, runs / 2, runs);
        Arrays.sort(warm);
        System.out.printf(
                Locale.ROOT, "%d bodies: median %.1f us, least %.1f, one in a hundred more than %.1f%n",
                n, warm[warm.length / 2], warm[0], warm[warm.length * 99 / 100]);
    }

    private static void disks(int n) {
        double[] covers = {0.2, 0.4, 0.6, 0.7};
        WarmUp.run(WARM_UP, () -> Arrays.stream(covers).forEach(covered -> CpuTime.of(disks(n, covered)::step, 1000)));
        for (double covered : covers) {
            PhysicsEngine engine = disks(n, covered);
            CpuTime.of(engine::step, 1000);
            double[] perSecond = new double[7];
            double[] nanos = new double[7];
            for (int round = 0; round < 7; round++) {
                long impacts = engine.getImpacts();
                long time = CpuTime.of(engine::step, 500);
                perSecond[round] = (engine.getImpacts() - impacts) * 1e3 / time;
                nanos[round] = time / 500.0 / n;
            }
            Arrays.sort(perSecond);
            Arrays.sort(nanos);
            System.out.printf(
                    Locale.ROOT, "%d disks, %.0f %% covered: %.2f [%.2f, %.2f] million impacts a second, %.0f ns a body and step%n",
                    n, 100 * covered, perSecond[3], perSecond[0], perSecond[6], nanos[3]);
        }
    }

    /** Equal disks on a square lattice between walls, with random velocities. */
    private static PhysicsEngine disks(int n, double covered) {
        SceneData velocities = Gas.s3(n, 3);
        int row = (int) Math.ceil(Math.sqrt(n));
        double pitch = Math.sqrt(Math.PI * 0.25 / covered);
        double side = row * pitch;
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        for (int end = 0; end < 2; end++) {
            engine.add(Body.fixed(new Rectangle(5, side + 10)).at(end * (side + 5) - 2.5, side / 2));
            engine.add(Body.fixed(new Rectangle(side + 10, 5)).at(side / 2, end * (side + 5) - 2.5));
        }
        Circle disk = new Circle(0.5);
        for (int i = 0; i < n; i++) {
            engine.add(new Body(disk)
                    .at((i % row + 0.5) * pitch, (i / row + 0.5) * pitch)
                    .moving(velocities.vx()[i], velocities.vy()[i]));
        }
        return engine;
    }

    /** All that can be reached from an engine with a gas, after some steps. */
    private static void memory(int n, int steps) {
        OwnRunner gas = new OwnRunner(Gas.s3(n, 1001), false, 0);
        for (int k = 0; k < steps; k++) {
            gas.step();
        }
        System.setProperty("jol.magicFieldOffset", "true"); // shapes have records, whose fields else cannot be seen
        GraphLayout layout = GraphLayout.parseInstance(gas.engine());
        System.out.printf(
                Locale.ROOT, "%d bodies, after %d steps: %.1f bytes a body%n", n, steps, layout.totalSize() / (double) n);
    }

    /** Fresh gases, each in the engine and in the bare step, who begins by turns. */
    private static void unused(int n, int rounds) {
        int steps = Math.max(20, 600_000 / n);
        double[] ratios = new double[rounds];
        double[] micros = new double[rounds];
        WarmUp.run(WARM_UP, () -> {
            SceneData scene = Gas.s3(n, 499);
            CpuTime.of(new OwnRunner(scene, false, 0).engine()::step, steps);
            CpuTime.of(new BareStep(scene)::step, steps);
        });
        for (int r = 0; r < rounds; r++) {
            SceneData scene = Gas.s3(n, 500 + r);
            PhysicsEngine engine = new OwnRunner(scene, false, 0).engine();
            BareStep bare = new BareStep(scene);
            boolean first = r % 2 == 0;
            double before = first ? CpuTime.of(engine::step, steps) : 0;
            double without = CpuTime.of(bare::step, steps);
            double with = first ? before : CpuTime.of(engine::step, steps);
            ratios[r] = with / without;
            micros[r] = with / 1e3 / steps;
            if (r == rounds - 1) {
                System.out.printf(
                        Locale.ROOT, "impacts %d and %d, energy %.15g and %.15g%n", engine.getImpacts(), bare.impacts(),
                        engine.kineticEnergy(), bare.kineticEnergy());
            }
        }
        Arrays.sort(ratios);
        Arrays.sort(micros);
        System.out.printf(
                Locale.ROOT, "%d bodies: %.3f us a step, %.3f times the bare step [%.3f, %.3f]%n", n, micros[rounds / 2],
                ratios[rounds / 2], ratios[rounds / 4], ratios[3 * rounds / 4]);
    }

    private static void growth(int n, int rounds) {
        OwnRunner small = new OwnRunner(Gas.s3(1000, 1001), false, 0);
        WarmUp.run(WARM_UP, () -> CpuTime.of(small::step, 1000));
        OwnRunner large = new OwnRunner(Gas.s3(n, 1001), false, 0);
        CpuTime.of(large::step, 60);
        double[][] results = new double[3][rounds];
        int steps = Math.max(1, 2_000_000 / n);
        for (int r = 0; r < rounds; r++) {
            results[0][r] = CpuTime.of(small::step, 2000) / 2e6;
            results[1][r] = CpuTime.of(large::step, steps) / (double) steps / n;
            results[2][r] = results[1][r] / results[0][r];
        }
        Arrays.stream(results).forEach(Arrays::sort);
        int m = rounds / 2;
        System.out.printf(
                Locale.ROOT, "1000 bodies: %.1f ns a body and step, %d: %.1f, %.2f [%.2f, %.2f] times as long%n",
                results[0][m], n, results[1][m], results[2][m], results[2][0], results[2][rounds - 1]);
        CpuTime.of(large::step, 1);
        long bytes = THREAD.getCurrentThreadAllocatedBytes();
        CpuTime.of(large::step, steps);
        System.out.println(
                "allocated in " + steps + " steps: " + (THREAD.getCurrentThreadAllocatedBytes() - bytes) + " bytes; collections"
                        + " so far: " + ManagementFactory.getGarbageCollectorMXBeans().stream()
                                .map(c -> c.getName() + " " + c.getCollectionCount()).toList());
    }
}
