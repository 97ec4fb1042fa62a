// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import org.dyn4j.collision.CategoryFilter;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.dynamics.joint.DistanceJoint;
import org.dyn4j.dynamics.joint.PrismaticJoint;
import org.dyn4j.dynamics.joint.RevoluteJoint;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.Mass;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;

/**
 * A scene in dyn4j 6.0.0: as delivered, but without sleeping and with the largest translation and rotation per step raised
 * out of reach; or tuned, with 20 and 10 iterations and no restitution threshold.
 */
final class Dyn4jWorld implements World {
    private final org.dyn4j.world.World<Body> world = new org.dyn4j.world.World<>();
    private final Body[] bodies;
    private final double dt;
    private final double torque;
    private final double push;

    Dyn4jWorld(Model model, double dt, boolean tuned) {
        this.dt = dt;
        torque = model.torque;
        push = model.push;
        world.setGravity(model.across, -model.gravity);
        world.getSettings().setAtRestDetectionEnabled(false);
        world.getSettings().setStepFrequency(dt);
        world.getSettings().setMaximumTranslation(1e6);
        world.getSettings().setMaximumRotation(1e6);
        if (tuned) {
            world.getSettings().setVelocityConstraintSolverIterations(20);
            world.getSettings().setPositionConstraintSolverIterations(10);
        }
        bodies = new Body[model.parts.size()];
        for (int k = 0; k < bodies.length; k++) {
            bodies[k] = body(model.parts.get(k), model.friction, tuned);
            world.addBody(bodies[k]);
        }
        Body ground = new Body();
        ground.addFixture(Geometry.createCircle(0.01)).setFilter(new CategoryFilter(1, 0));
        ground.setMass(MassType.INFINITE);
        world.addBody(ground);
        for (Model.Pin pin : model.pins) {
            Body other = pin.b() < 0 ? ground : bodies[pin.b()];
            world.addJoint(new RevoluteJoint<>(other, bodies[pin.a()], new Vector2(pin.x(), pin.y())));
        }
        for (Model.Rod rod : model.rods) {
            Vector2 centre = bodies[rod.a()].getWorldCenter();
            world.addJoint(new DistanceJoint<>(ground, bodies[rod.a()], new Vector2(rod.x(), rod.y()), centre));
        }
        for (Model.Slide slide : model.slides) {
            world.addJoint(new PrismaticJoint<>(ground, bodies[slide.a()], bodies[slide.a()].getWorldCenter(), new Vector2(1, 0)));
        }
        for (Model.Elastic s : model.springs) {
            DistanceJoint<Body> joint = new DistanceJoint<>(
                    ground, bodies[s.a()], new Vector2(s.x(), s.y()), new Vector2(s.px(), s.py()));
            joint.setRestDistance(s.length());
            joint.setSpringEnabled(true);
            joint.setSpringStiffness(s.stiffness());
            joint.setSpringDamperEnabled(s.damping() > 0);
            double critical = 2 * Math.sqrt(s.stiffness() * model.parts.get(s.a()).mass());
            joint.setSpringDampingRatio(Math.max(1e-9, Math.min(1, s.damping() / critical)));
            world.addJoint(joint);
        }
    }

    private static Body body(Model.Part part, double friction, boolean tuned) {
        double[] size = part.size();
        Convex shape = switch (part.kind()) {
            case DISC -> Geometry.createCircle(size[0]);
            case BOX -> Geometry.createRectangle(size[0], size[1]);
            case POLYGON -> {
                double[][] corners = Model.corners(part);
                Vector2[] all = new Vector2[corners.length];
                for (int k = 0; k < all.length; k++) {
                    all[k] = new Vector2(corners[k][0], corners[k][1]);
                }
                yield Geometry.createPolygon(all);
            }
        };
        BodyFixture fixture = new BodyFixture(shape);
        // of two coefficients the geometric mean counts
        fixture.setFriction(friction);
        // of two coefficients the larger one counts there
        fixture.setRestitution(part.fixed() ? 0 : part.e());
        if (tuned) {
            fixture.setRestitutionVelocity(0);
        }
        // a filter of another class than the other's lets everything pass: all have one
        fixture.setFilter(new CategoryFilter(1, part.collides() ? 1 : 0));
        Body body = new Body();
        body.addFixture(fixture);
        if (part.fixed()) {
            body.setMass(MassType.INFINITE);
        } else {
            body.setMass(new Mass(new Vector2(0, 0), part.mass(), part.inertia()));
        }
        body.setLinearDamping(0);
        body.setAngularDamping(0);
        double[] s = part.start();
        body.rotate(s[2]);
        body.translate(s[0], s[1]);
        body.setLinearVelocity(s[3], s[4]);
        body.setAngularVelocity(s[5]);
        return body;
    }

    @Override
    public void step() {
        if (torque != 0) {
            bodies[0].applyTorque(torque);
        }
        if (push != 0) {
            bodies[0].applyForce(new Vector2(push, 0));
        }
        world.step(1, dt);
    }

    @Override
    public void read(double[] state) {
        for (int k = 0; k < bodies.length; k++) {
            int b = Model.BLOCK * k;
            state[b] = bodies[k].getTransform().getTranslationX();
            state[b + 1] = bodies[k].getTransform().getTranslationY();
            state[b + 2] = bodies[k].getTransform().getRotationAngle();
            state[b + 3] = bodies[k].getLinearVelocity().x;
            state[b + 4] = bodies[k].getLinearVelocity().y;
            state[b + 5] = bodies[k].getAngularVelocity();
        }
    }
}
