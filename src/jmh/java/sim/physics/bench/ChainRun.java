// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import org.dyn4j.dynamics.joint.RevoluteJoint;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.Vector2;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
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
    private ChainRun() {}

    /**
     * Runs the comparison.
     *
     * @param args rounds, numbers of links
     */
    public static void main(String[] args) {
        Chains.compare(args, "link", ChainRun::own, ChainRun::jbox2d, ChainRun::dyn4j);
    }

    /** Our chain. */
    static Runnable own(int n) {
        PhysicsEngine engine = Chains.engine();
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
        World world = Chains.jbox2d();
        org.jbox2d.dynamics.Body last = world.createBody(new BodyDef());
        for (int k = 0; k < n; k++) {
            PolygonShape shape = new PolygonShape();
            shape.setAsBox(0.5f, 0.01f);
            org.jbox2d.dynamics.Body rod = Chains.add(world, shape, 50, k + 0.5f);
            RevoluteJointDef joint = new RevoluteJointDef();
            joint.initialize(last, rod, new Vec2(k, 0));
            world.createJoint(joint);
            last = rod;
        }
        return () -> world.step((float) Chains.STEP, 8, 3);
    }

    private static Runnable dyn4j(int n) {
        org.dyn4j.world.World<org.dyn4j.dynamics.Body> world = Chains.dyn4j();
        org.dyn4j.dynamics.Body last = Chains.add(world, Geometry.createCircle(0.01), 0, 0);
        for (int k = 0; k < n; k++) {
            org.dyn4j.dynamics.Body rod = Chains.add(world, Geometry.createRectangle(1, 0.02), 50, k + 0.5);
            world.addJoint(new RevoluteJoint<>(last, rod, new Vector2(k, 0)));
            last = rod;
        }
        return () -> world.step(1);
    }
}
