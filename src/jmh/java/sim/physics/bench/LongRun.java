// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.Locale;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Rattle;
import sim.physics.motion.RungeKutta4;
import sim.physics.shape.Rectangle;

/**
 * What very long runs do to the energy and the joints of hanging rods: the drift of the smooth mean of the energy, in units of
 * √steps ε E, and the widest gap.
 *
 * <pre>
 *   mvn -q -o -ntp -Pbench test-compile exec:exec -Dbench.main=sim.physics.bench.LongRun -Djmh.args="1 1.5708 0.01 100000000"
 * </pre>
 *
 * <p>Arguments: rods, angle from hanging, step, steps, order of {@link Rattle} (2; 0: {@link RungeKutta4}).
 */
public final class LongRun {
    private static final double G = 9.81;

    /** Steps over which the mean is taken. */
    private static final int WINDOW = 1 << 17;

    /** Steps between two looks at the joints: every look takes longer than a step. */
    private static final int LOOK = 101;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final int rods;
    private double gap;

    private LongRun(int rods, double angle, double step, int order) {
        this.rods = rods;
        engine.setTimeStep(step);
        engine.setIntegrator(order == 0 ? new RungeKutta4() : new Rattle(order));
        engine.add(new Gravity(0, -G));
        double x = StrictMath.sin(angle);
        double y = -StrictMath.cos(angle);
        Body last = null;
        for (int k = 0; k < rods; k++) {
            Body rod = engine.add(new Body(new Rectangle(1, 0.01)).at((k + 0.5) * x, (k + 0.5) * y));
            rod.setAngle(StrictMath.atan2(y, x));
            rod.setMass(1, 1 / 12.0);
            rod.setCollisionGroup(1, 0);
            engine.add(new PinJoint(last == null ? rod : last, last == null ? null : rod, k * x, k * y));
            last = rod;
        }
    }

    /** Above the energy of hanging rods at rest. */
    private double energy() {
        double sum = 0;
        for (int k = 0; k < rods; k++) {
            Body rod = engine.bodies().get(k);
            sum += rod.kineticEnergy() + G * (rod.getY() + (k + 0.5));
        }
        return sum;
    }

    private void look() {
        double x = 0;
        double y = 0;
        for (Body rod : engine.bodies()) {
            double cos = 0.5 * StrictMath.cos(rod.getAngle());
            double sin = 0.5 * StrictMath.sin(rod.getAngle());
            gap = Math.max(gap, Math.max(Math.abs(rod.getX() - cos - x), Math.abs(rod.getY() - sin - y)));
            x = rod.getX() + cos;
            y = rod.getY() + sin;
        }
    }

    /** Mean with a weight that leaves nothing of what swings (Laskar 1993). */
    private double meanEnergy() {
        double sum = 0;
        double weights = 0;
        for (int k = 1; k < WINDOW; k++) {
            engine.step();
            double t = (double) k / WINDOW;
            double weight = StrictMath.exp(-1 / (t * (1 - t)));
            sum += weight * energy();
            weights += weight;
        }
        return sum / weights;
    }

    private void run(long steps) {
        double all = energy();
        double first = meanEnergy();
        long done = WINDOW;
        System.out.printf(Locale.ROOT, "E = %.3f J; steps, drift of the mean (J), in sqrt(steps) eps E, gap, s%n", all);
        long start = System.nanoTime();
        for (long next = Math.max(steps / 100, 2 * WINDOW); done < steps; next = Math.min(2 * next, steps)) {
            for (; done < next; done++) {
                engine.step();
                if (done % LOOK == 0) {
                    look();
                }
            }
            double drift = meanEnergy() - first;
            done += WINDOW;
            double unit = Math.sqrt(done) * 0x1p-52 * all;
            double seconds = 1e-9 * (System.nanoTime() - start);
            System.out.printf(Locale.ROOT, "%.3g %.3g %.3g %.3g %.0f%n", (double) done, drift, drift / unit, gap, seconds);
        }
    }

    /**
     * Runs.
     *
     * @param args rods, angle, step, steps, order
     */
    public static void main(String[] args) {
        int order = args.length > 4 ? Integer.parseInt(args[4]) : 2;
        new LongRun(Integer.parseInt(args[0]), Double.parseDouble(args[1]), Double.parseDouble(args[2]), order)
                .run(Long.parseLong(args[3]));
    }
}
