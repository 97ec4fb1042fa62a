// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.IntFunction;
import org.dyn4j.collision.CategoryFilter;
import org.dyn4j.dynamics.ContinuousDetectionMode;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.MassType;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Gravity;

/**
 * Chains that hang in the world, let go from the horizontal, without collisions: their worlds in each engine, and who is how
 * fast. Batches of steps take turns in one JVM; times are CPU times of the stepping thread.
 */
final class Chains {
    static final double STEP = 1 / 240.0;
    private static final int BODY_STEPS = 100_000;

    /** Steps of a batch at least, or they are measured before they are compiled. */
    private static final int LEAST_STEPS = 5;

    private static final double WARM_UP = 8;

    private Chains() {}

    /**
     * Compares engines on chains of some lengths.
     *
     * @param args rounds, lengths
     * @param part what a chain is made of
     * @param own makes a step of a chain of some length in our engine
     * @param jbox2d the same in JBox2D
     * @param dyn4j the same in dyn4j
     */
    static void compare(
            String[] args, String part, IntFunction<Runnable> own, IntFunction<Runnable> jbox2d, IntFunction<Runnable> dyn4j) {
        int rounds = Integer.parseInt(args[0]);
        for (int k = 1; k < args.length; k++) {
            int n = Integer.parseInt(args[k]);
            double[] micros = medians(new Runnable[] {own.apply(n), jbox2d.apply(n), dyn4j.apply(n)}, n, rounds);
            System.out.printf(
                    Locale.ROOT,
                    "%6d: ours %.2f us/step (%.0f ns a %s), JBox2D %.2f (%.2f x), dyn4j %.2f (%.2f x)%n",
                    n, micros[0], 1000 * micros[0] / n, part,
                    micros[1], micros[1] / micros[0], micros[2], micros[2] / micros[0]);
        }
    }

    /** Time of a step in µs, by engine. */
    private static double[] medians(Runnable[] engines, int n, int rounds) {
        double[][] times = new double[engines.length][rounds];
        int steps = Math.max(LEAST_STEPS, BODY_STEPS / n);
        WarmUp.run(WARM_UP, () -> Arrays.stream(engines).forEach(engine -> CpuTime.of(engine, steps)));
        for (int round = 0; round < rounds; round++) {
            for (int e = 0; e < engines.length; e++) {
                times[e][round] = CpuTime.of(engines[e], steps) * 1e-3 / steps;
            }
        }
        return Arrays.stream(times).mapToDouble(time -> Arrays.stream(time).sorted().toArray()[rounds / 2]).toArray();
    }

    static PhysicsEngine engine() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(STEP);
        engine.add(new Gravity(0, -9.81));
        return engine;
    }

    static org.jbox2d.dynamics.World jbox2d() {
        org.jbox2d.dynamics.World world = new org.jbox2d.dynamics.World(new Vec2(0, -9.81f));
        world.setAllowSleep(false);
        return world;
    }

    static org.jbox2d.dynamics.Body add(org.jbox2d.dynamics.World world, Shape shape, float density, float x) {
        BodyDef definition = new BodyDef();
        definition.type = BodyType.DYNAMIC;
        definition.position.set(x, 0);
        org.jbox2d.dynamics.Body body = world.createBody(definition);
        FixtureDef fixture = new FixtureDef();
        fixture.shape = shape;
        fixture.density = density;
        fixture.filter.maskBits = 0;
        body.createFixture(fixture);
        return body;
    }

    static org.dyn4j.world.World<org.dyn4j.dynamics.Body> dyn4j() {
        org.dyn4j.world.World<org.dyn4j.dynamics.Body> world = new org.dyn4j.world.World<>();
        world.setGravity(0, -9.81);
        world.getSettings().setAtRestDetectionEnabled(false);
        world.getSettings().setStepFrequency(STEP);
        world.getSettings().setContinuousDetectionMode(ContinuousDetectionMode.NONE);
        return world;
    }

    /** Adds a body of some density at the height of the pins, 0 for a fixed one. */
    static org.dyn4j.dynamics.Body add(
            org.dyn4j.world.World<org.dyn4j.dynamics.Body> world, Convex shape, double density, double x) {
        org.dyn4j.dynamics.Body body = new org.dyn4j.dynamics.Body();
        body.addFixture(shape, density == 0 ? 1 : density).setFilter(new CategoryFilter(1, 0));
        body.setMass(density == 0 ? MassType.INFINITE : MassType.NORMAL);
        body.translate(x, 0);
        world.addBody(body);
        return body;
    }
}
