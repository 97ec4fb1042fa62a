// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.Locale;
import org.dyn4j.collision.CategoryFilter;
import org.dyn4j.dynamics.ContinuousDetectionMode;
import org.dyn4j.dynamics.joint.RevoluteJoint;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/**
 * Compares engines on chains of pinned rods of 1 m and 1 kg, let go from the horizontal, at a step of 1/240, without
 * collisions: ours with RK4, JBox2D with 8 and 3 iterations, dyn4j with its own. Batches of steps take turns in one JVM; times
 * are CPU times of the stepping thread.
 *
 * <pre>
 * ChainRun rounds n n …        ChainRun 9 2 10 100
 * </pre>
 */
public final class ChainRun {
    private static final double STEP = 1 / 240.0;
    private static final int LINK_STEPS = 100_000;
    private static final int WARM_UP = 4;

    private ChainRun() {}

    /**
     * Runs the comparison.
     *
     * @param args rounds, numbers of links
     */
    public static void main(String[] args) {
        int rounds = Integer.parseInt(args[0]);
        for (int k = 1; k < args.length; k++) {
            compare(Integer.parseInt(args[k]), rounds);
        }
    }

    private static void compare(int n, int rounds) {
        Runnable[] engines = {own(n), jbox2d(n), dyn4j(n)};
        double[][] times = new double[engines.length][rounds];
        ThreadMXBean clock = ManagementFactory.getThreadMXBean();
        int steps = Math.max(1, LINK_STEPS / n);
        for (int round = -WARM_UP; round < rounds; round++) {
            for (int e = 0; e < engines.length; e++) {
                long begun = clock.getCurrentThreadCpuTime();
                for (int step = 0; step < steps; step++) {
                    engines[e].run();
                }
                if (round >= 0) {
                    times[e][round] = (clock.getCurrentThreadCpuTime() - begun) * 1e-3 / steps;
                }
            }
        }
        for (double[] time : times) {
            Arrays.sort(time);
        }
        double own = times[0][rounds / 2];
        System.out.printf(
                Locale.ROOT,
                "%6d links: ours %.2f us/step (%.0f ns/link), JBox2D %.2f (%.2f x), dyn4j %.2f (%.2f x)%n",
                n, own, 1000 * own / n, times[1][rounds / 2], times[1][rounds / 2] / own,
                times[2][rounds / 2], times[2][rounds / 2] / own);
    }

    private static Runnable own(int n) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(STEP);
        engine.add(new Gravity(0, -9.81));
        Body last = null;
        for (int k = 0; k < n; k++) {
            Body rod = engine.add(new Body(new Rectangle(1, 0.02)).at(k + 0.5, 0));
            rod.setMass(1, 1 / 12.0);
            rod.setCollisionGroup(1, 0);
            engine.add(last == null ? new PinJoint(rod, 0, 0) : new PinJoint(last, rod, k, 0));
            last = rod;
        }
        return engine::step;
    }

    private static Runnable jbox2d(int n) {
        World world = new World(new Vec2(0, -9.81f));
        world.setAllowSleep(false);
        org.jbox2d.dynamics.Body last = world.createBody(new BodyDef());
        for (int k = 0; k < n; k++) {
            BodyDef definition = new BodyDef();
            definition.type = BodyType.DYNAMIC;
            definition.position.set(k + 0.5f, 0);
            org.jbox2d.dynamics.Body rod = world.createBody(definition);
            PolygonShape shape = new PolygonShape();
            shape.setAsBox(0.5f, 0.01f);
            FixtureDef fixture = new FixtureDef();
            fixture.shape = shape;
            fixture.density = 50;
            fixture.filter.maskBits = 0;
            rod.createFixture(fixture);
            RevoluteJointDef joint = new RevoluteJointDef();
            joint.initialize(last, rod, new Vec2(k, 0));
            world.createJoint(joint);
            last = rod;
        }
        return () -> world.step((float) STEP, 8, 3);
    }

    private static Runnable dyn4j(int n) {
        org.dyn4j.world.World<org.dyn4j.dynamics.Body> world = new org.dyn4j.world.World<>();
        world.setGravity(0, -9.81);
        world.getSettings().setAtRestDetectionEnabled(false);
        world.getSettings().setStepFrequency(STEP);
        world.getSettings().setContinuousDetectionMode(ContinuousDetectionMode.NONE);
        CategoryFilter nothing = new CategoryFilter(1, 0);
        org.dyn4j.dynamics.Body last = new org.dyn4j.dynamics.Body();
        last.addFixture(Geometry.createCircle(0.01)).setFilter(nothing);
        last.setMass(MassType.INFINITE);
        world.addBody(last);
        for (int k = 0; k < n; k++) {
            org.dyn4j.dynamics.Body rod = new org.dyn4j.dynamics.Body();
            rod.addFixture(Geometry.createRectangle(1, 0.02), 50).setFilter(nothing);
            rod.setMass(MassType.NORMAL);
            rod.translate(k + 0.5, 0);
            world.addBody(rod);
            world.addJoint(new RevoluteJoint<>(last, rod, new Vector2(k, 0)));
            last = rod;
        }
        return () -> world.step(1);
    }
}
