// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.Locale;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.scenes.Gas;
import sim.physics.scenes.SceneData;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * Compares steps that several threads share with those of one thread: two engines with the same scene take turns in one JVM,
 * a batch of steps each, and change who begins. Printed are medians of the rounds: µs per step by the clock, µs of CPU time
 * of the stepping thread and of the whole process, and the medians of the rounds' ratios.
 *
 * <p>On a machine that others use too the clock favours many threads, which get a larger share of it; the stepping thread's
 * CPU time does not count what it waits for others. The truth lies between, and only a quiet machine shows it.
 *
 * <pre>
 * ThreadRun rounds threads scene n [scene n …]        ThreadRun 21 2 gas 10000 chains 1000 rods 1000 forces 10000
 * </pre>
 */
public final class ThreadRun {
    private static final double BATCH_SECONDS = 0.2;
    private static final double WARM_UP_SECONDS = 6;

    private ThreadRun() {}

    /** Keeps each body near where it is, as an author would write it. */
    private static final class Lattice implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            double m = body.getMass();
            double x = body.getX() - 3 * Math.rint(body.getX() / 3);
            double y = body.getY() - 3 * Math.rint(body.getY() / 3);
            forces.add(body, -4 * m * x * (1 - x * x), -4 * m * y * (1 - y * y));
            forces.addTorque(body, -0.1 * body.getInertia() * body.getAngularVelocity());
        }

        @Override
        public boolean isConcurrent() {
            return true;
        }
    }

    /**
     * Runs the comparison.
     *
     * @param args rounds, threads, then scenes and their sizes
     */
    public static void main(String[] args) {
        for (int k = 2; k + 1 < args.length; k += 2) {
            compare(args[k], Integer.parseInt(args[k + 1]), Integer.parseInt(args[1]), Integer.parseInt(args[0]));
        }
    }

    private static void compare(String scene, int n, int threads, int rounds) {
        PhysicsEngine[] engines = {make(scene, n), make(scene, n)};
        engines[1].setThreads(threads);
        long begun = System.nanoTime();
        int warm = 0;
        for (; warm < 20 || System.nanoTime() - begun < WARM_UP_SECONDS * 1e9; warm++) {
            engines[0].step();
            engines[1].step();
        }
        int steps = (int) Math.max(1, warm * BATCH_SECONDS / WARM_UP_SECONDS);
        double[][][] times = new double[3][2][rounds];
        for (int round = 0; round < rounds; round++) {
            for (int turn = 0; turn < 2; turn++) {
                int e = (round + turn) % 2;
                double[] time = batch(engines[e], steps);
                for (int kind = 0; kind < 3; kind++) {
                    times[kind][e][round] = time[kind];
                }
            }
        }
        System.out.printf(Locale.ROOT, "%s %d, %d steps a batch, same places %b%n", scene, n, steps, same(engines));
        String[] names = {"clock", "stepping thread", "process"};
        for (int kind = 0; kind < 3; kind++) {
            double[] ratios = new double[rounds];
            for (int round = 0; round < rounds; round++) {
                ratios[round] = times[kind][0][round] / times[kind][1][round];
            }
            System.out.printf(
                    Locale.ROOT, "    %-16s 1 thread %9.1f us, %d threads %9.1f us, ratio %.2f [%.2f, %.2f]%n",
                    names[kind], quantile(times[kind][0], 0.5), threads, quantile(times[kind][1], 0.5),
                    quantile(ratios, 0.5), quantile(ratios, 0.25), quantile(ratios, 0.75));
        }
    }

    private static double[] batch(PhysicsEngine engine, int steps) {
        ThreadMXBean thread = ManagementFactory.getThreadMXBean();
        OperatingSystemMXBean process = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        long[] begun = {System.nanoTime(), thread.getCurrentThreadCpuTime(), process.getProcessCpuTime()};
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
        long[] ended = {System.nanoTime(), thread.getCurrentThreadCpuTime(), process.getProcessCpuTime()};
        double[] micros = new double[3];
        Arrays.setAll(micros, k -> (ended[k] - begun[k]) * 1e-3 / steps);
        return micros;
    }

    private static boolean same(PhysicsEngine[] engines) {
        boolean same = engines[0].getNarrowPhaseEvaluations() == engines[1].getNarrowPhaseEvaluations();
        for (int k = 0; k < engines[0].bodies().size(); k += 97) {
            same &= engines[0].bodies().get(k).getX() == engines[1].bodies().get(k).getX();
        }
        return same;
    }

    private static double quantile(double[] values, double part) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[(int) (part * (sorted.length - 1))];
    }

    private static PhysicsEngine make(String scene, int n) {
        return switch (scene) {
            case "gas" -> gas(n);
            case "chains" -> chains(n, true, 60);
            case "rods" -> chains(n, false, 240);
            case "forces" -> forces(n);
            default -> throw new IllegalArgumentException("scene is " + scene + ": gas, chains, rods or forces");
        };
    }

    private static PhysicsEngine gas(int n) {
        SceneData data = Gas.s3(n, 1);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(data.dt());
        for (SceneData.Box wall : data.walls()) {
            engine.add(Body.fixed(new Rectangle(wall.width(), wall.height())).at(wall.x(), wall.y()));
        }
        for (int k = 0; k < n; k++) {
            boolean isCircle = data.kind()[k] == SceneData.Kind.CIRCLE;
            Body body = new Body(isCircle ? new Circle(data.sizeA()[k]) : new Rectangle(data.sizeA()[k], data.sizeB()[k]));
            engine.add(body.at(data.x()[k], data.y()[k], data.theta()[k])
                    .moving(data.vx()[k], data.vy()[k], data.omega()[k]));
        }
        return engine;
    }

    /** Chains of ten rods under gravity. */
    private static PhysicsEngine chains(int n, boolean collide, double rate) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / rate);
        engine.add(new Gravity(0, -9.81));
        for (int c = 0; c < n; c++) {
            double x = 25 * (c % 32);
            double y = 25 * (c / 32);
            Body last = null;
            for (int k = 0; k < 10; k++) {
                Body body = engine.add(new Body(new Rectangle(1, 0.2)).at(x + k + 0.5, y));
                if (!collide) {
                    body.setCollisionGroup(1, 0);
                }
                engine.add(k == 0 ? new PinJoint(body, x, y) : new PinJoint(last, body, x + k, y));
                last = body;
            }
        }
        return engine;
    }

    /** Bodies that swing about the points of a lattice. */
    private static PhysicsEngine forces(int n) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new Lattice());
        for (int k = 0; k < n; k++) {
            engine.add(new Body(new Circle(0.3)).at(3 * (k % 100), 3 * (k / 100)).moving(0.3, 0.01 * (k % 50), 1));
        }
        return engine;
    }
}
