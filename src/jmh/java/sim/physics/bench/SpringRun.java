// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import org.dyn4j.dynamics.joint.DistanceJoint;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.Vector2;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.DistanceJointDef;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
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
    private static final double DENSITY = 1 / (Math.PI * 0.01);

    private SpringRun() {}

    /**
     * Runs the comparison.
     *
     * @param args rounds, numbers of masses
     */
    public static void main(String[] args) {
        Chains.compare(args, "mass", SpringRun::own, SpringRun::jbox2d, SpringRun::dyn4j);
    }

    private static Runnable own(int n) {
        double omega = 2 * Math.PI * FREQUENCY;
        PhysicsEngine engine = Chains.engine();
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
        World world = Chains.jbox2d();
        org.jbox2d.dynamics.Body last = world.createBody(new BodyDef());
        for (int k = 0; k < n; k++) {
            CircleShape shape = new CircleShape();
            shape.m_radius = 0.1f;
            org.jbox2d.dynamics.Body mass = Chains.add(world, shape, (float) DENSITY, k + 1);
            DistanceJointDef joint = new DistanceJointDef();
            joint.initialize(last, mass, new Vec2(k, 0), new Vec2(k + 1, 0));
            joint.frequencyHz = (float) FREQUENCY;
            joint.dampingRatio = (float) DAMPING;
            world.createJoint(joint);
            last = mass;
        }
        return () -> world.step((float) Chains.STEP, 8, 3);
    }

    private static Runnable dyn4j(int n) {
        org.dyn4j.world.World<org.dyn4j.dynamics.Body> world = Chains.dyn4j();
        org.dyn4j.dynamics.Body last = Chains.add(world, Geometry.createCircle(0.1), 0, 0);
        for (int k = 0; k < n; k++) {
            org.dyn4j.dynamics.Body mass = Chains.add(world, Geometry.createCircle(0.1), DENSITY, k + 1);
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
