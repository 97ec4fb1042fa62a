// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.Locale;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.constraint.PinJoint;
import sim.physics.internal.Team;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * Compares steps that several threads share with those of one thread: two engines with the same scene take turns in one JVM,
 * step by step, and change who begins. Printed are quantiles of the time of a step by the clock, and the medians of its CPU
 * time in the stepping thread.
 *
 * <p>On a machine that others use too the median by the clock favours many threads, which get a larger share of it, and so
 * may say anything. The least twentieth are steps that nobody disturbed, if there were some. What a second thread can do on
 * the machine in these minutes is shown by the scene "loop": arithmetic that takes no memory.
 *
 * <pre>
 * ThreadRun seconds threads scene n [scene n …]        ThreadRun 12 2 gas 10000 chains 1000 rods 1000 forces 10000
 * </pre>
 */
public final class ThreadRun {
    private static final int FEWEST_STEPS = 20;
    private static final int MOST_STEPS = 20_000;

    private ThreadRun() {}

    /** Arithmetic of about a microsecond an item. */
    private static final class Loop implements Team.Work {
        private final double[] results = new double[1 << 16];

        @Override
        public void work(int worker, int item) {
            double x = item + 1;
            for (int k = 0; k < 200; k++) {
                x = Math.sqrt(x + k);
            }
            results[item & 0xffff] = x;
        }
    }

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
     * @param args seconds to measure, threads, then scenes and their sizes
     */
    public static void main(String[] args) {
        for (int k = 2; k + 1 < args.length; k += 2) {
            compare(args[k], Integer.parseInt(args[k + 1]), Integer.parseInt(args[1]), Double.parseDouble(args[0]));
        }
    }

    private static void compare(String scene, int n, int threads, double seconds) {
        Runnable[] runners = new Runnable[2];
        PhysicsEngine[] engines = new PhysicsEngine[2];
        for (int e = 0; e < 2 && !scene.equals("loop"); e++) {
            engines[e] = make(scene, n);
            runners[e] = engines[e]::step;
        }
        if (scene.equals("loop")) {
            Team team = new Team(threads, true);
            Team.Work work = new Loop();
            runners[0] = () -> alone(work, n);
            runners[1] = () -> team.run(work, n);
        } else {
            engines[1].setThreads(threads);
        }
        measure(runners, seconds / 2); // to warm up
        double[][][] times = measure(runners, seconds);
        int steps = times[0][0].length;
        String same = engines[0] == null ? "" : ", same places " + same(engines);
        System.out.printf(Locale.ROOT, "%s %d, %d steps%s%n", scene, n, steps, same);
        print("clock, least 1/20", times[0], 0.05, threads);
        print("clock, median", times[0], 0.5, threads);
        print("CPU, median", times[1], 0.5, threads);
    }

    private static void alone(Team.Work work, int items) {
        for (int k = 0; k < items; k++) {
            work.work(0, k);
        }
    }

    private static void print(String what, double[][] times, double part, int threads) {
        double alone = quantile(times[0], part);
        double shared = quantile(times[1], part);
        System.out.printf(
                Locale.ROOT, "    %-18s 1 thread %9.1f us, %d threads %9.1f us, ratio %.2f%n",
                what, alone, threads, shared, alone / shared);
    }

    /** Times of steps in µs: by the clock and of CPU, by engine. */
    private static double[][][] measure(Runnable[] engines, double seconds) {
        double[][][] times = new double[2][2][MOST_STEPS];
        long begun = System.nanoTime();
        int step = 0;
        while (step < FEWEST_STEPS || step < MOST_STEPS && System.nanoTime() - begun < seconds * 1e9) {
            for (int turn = 0; turn < 2; turn++) {
                int e = (step + turn) % 2;
                double[] time = step(engines[e]);
                times[0][e][step] = time[0];
                times[1][e][step] = time[1];
            }
            step++;
        }
        for (double[][] kind : times) {
            kind[0] = Arrays.copyOf(kind[0], step);
            kind[1] = Arrays.copyOf(kind[1], step);
        }
        return times;
    }

    private static double[] step(Runnable engine) {
        ThreadMXBean thread = ManagementFactory.getThreadMXBean();
        long cpu = thread.getCurrentThreadCpuTime();
        long clock = System.nanoTime();
        engine.run();
        double micros = (System.nanoTime() - clock) * 1e-3;
        return new double[] {micros, (thread.getCurrentThreadCpuTime() - cpu) * 1e-3};
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
            case "gas" -> Scenes.s3(n, 1);
            case "chains" -> chains(n, true, 60);
            case "rods" -> chains(n, false, 240);
            case "forces" -> forces(n);
            default -> throw new IllegalArgumentException("scene is " + scene + ": gas, chains, rods or forces");
        };
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
