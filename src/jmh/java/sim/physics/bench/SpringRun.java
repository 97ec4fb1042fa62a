// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.Locale;
import org.dyn4j.collision.CategoryFilter;
import org.dyn4j.dynamics.ContinuousDetectionMode;
import org.dyn4j.dynamics.joint.DistanceJoint;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.DistanceJointDef;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;

/**
 * Compares engines on chains of masses of 1 kg on springs of 1 m, let go from the horizontal, at a step of 1/240, without
 * collisions: ours with RK4 and forces, JBox2D with 8 and 3 iterations and dyn4j with its own, both with soft distance joints of the
 * same frequency. Batches of steps take turns in one JVM; times are CPU times of the stepping thread.
 *
 * <pre>
 * SpringRun rounds n n …        SpringRun 5 10 100 1000
 * </pre>
 */
public final class SpringRun {
    /** Of one mass on one spring, Hz, and of its critical damping. */
    private static final double FREQUENCY = 5;

    private static final double DAMPING = 0.01;
    private static final double STEP = 1 / 240.0;
    private static final int MASS_STEPS = 100_000;
    private static final int WARM_UP = 4;

    private SpringRun() {}

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
        int steps = Math.max(1, MASS_STEPS / n);
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
                "%6d masses: ours %.2f us/step (%.0f ns/mass), JBox2D %.2f (%.2f x), dyn4j %.2f (%.2f x)%n",
                n, own, 1000 * own / n, times[1][rounds / 2], times[1][rounds / 2] / own,
                times[2][rounds / 2], times[2][rounds / 2] / own);
    }

    private static Runnable own(int n) {
        double omega = 2 * Math.PI * FREQUENCY;
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(STEP);
        engine.add(new Gravity(0, -9.81));
        Body last = null;
        for (int k = 0; k < n; k++) {
            Body mass = engine.add(new Body(new Circle(0.1)).at(k + 1, 0));
            mass.setMass(1);
            mass.setCollisionGroup(1, 0);
            engine.add(new Spring(mass, 0, 0, last, 0, 0, 1, omega * omega, 2 * DAMPING * omega));
            last = mass;
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
            definition.position.set(k + 1, 0);
            org.jbox2d.dynamics.Body mass = world.createBody(definition);
            CircleShape shape = new CircleShape();
            shape.m_radius = 0.1f;
            FixtureDef fixture = new FixtureDef();
            fixture.shape = shape;
            fixture.density = (float) (1 / (Math.PI * 0.01));
            fixture.filter.maskBits = 0;
            mass.createFixture(fixture);
            DistanceJointDef joint = new DistanceJointDef();
            joint.initialize(last, mass, new Vec2(k, 0), new Vec2(k + 1, 0));
            joint.frequencyHz = (float) FREQUENCY;
            joint.dampingRatio = (float) DAMPING;
            world.createJoint(joint);
            last = mass;
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
        last.addFixture(Geometry.createCircle(0.1)).setFilter(nothing);
        last.setMass(MassType.INFINITE);
        world.addBody(last);
        for (int k = 0; k < n; k++) {
            org.dyn4j.dynamics.Body mass = new org.dyn4j.dynamics.Body();
            mass.addFixture(Geometry.createCircle(0.1), 1 / (Math.PI * 0.01)).setFilter(nothing);
            mass.setMass(MassType.NORMAL);
            mass.translate(k + 1, 0);
            world.addBody(mass);
            DistanceJoint<org.dyn4j.dynamics.Body> joint =
                    new DistanceJoint<>(last, mass, new Vector2(k, 0), new Vector2(k + 1, 0));
            joint.setSpringEnabled(true);
            joint.setSpringFrequency(FREQUENCY);
            joint.setSpringDamperEnabled(true);
            joint.setSpringDampingRatio(DAMPING);
            world.addJoint(joint);
            last = mass;
        }
        return () -> world.step(1);
    }
}
