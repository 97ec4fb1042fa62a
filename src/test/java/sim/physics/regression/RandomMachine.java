// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Bodies, joints, weak motors, springs and shoves that come and go at random between walls. */
final class RandomMachine {
    private static final int MOST_BODIES = 25;

    final PhysicsEngine engine = new PhysicsEngine();
    final List<Body> bodies = new ArrayList<>();
    private final List<Constraint> joints = new ArrayList<>();
    private final Random random;
    private final double restitution;
    private final double friction;
    private final boolean hasCompounds;

    RandomMachine(long seed) {
        this(seed, false);
    }

    /** One in which some bodies have several parts. */
    RandomMachine(long seed, boolean hasCompounds) {
        this.hasCompounds = hasCompounds;
        random = new Random(seed);
        engine.setTimeStep(1 / 60.0);
        if (random.nextInt(5) > 0) {
            engine.add(new Gravity(0, -9.81));
        }
        if (random.nextInt(4) == 0) {
            engine.add(new SurfaceFriction(9.81));
        }
        restitution = random.nextInt(3) * 0.5;
        friction = random.nextInt(3) * 0.4;
        Body ground = engine.add(Body.fixed(new Rectangle(20, 1)).at(0, -0.5));
        ground.setFriction(friction);
        ground.setRestitution(restitution);
        engine.add(Body.fixed(new Rectangle(1, 20)).at(-10, 9));
        engine.add(Body.fixed(new Rectangle(1, 20)).at(10, 9));
        engine.add(Body.fixed(new Rectangle(20, 1)).at(0, 19.5));
    }

    private Shape shape() {
        return switch (random.nextInt(hasCompounds ? 7 : 4)) {
            case 0 -> new Circle(0.2 + random.nextDouble() * 0.4);
            case 1 -> new Rectangle(0.3 + random.nextDouble(), 0.3 + random.nextDouble());
            case 2 -> Polygon.regular(3 + random.nextInt(5), 0.3 + random.nextDouble() * 0.4);
            case 3 -> new Rectangle(0.2, 1.2);
            case 4 -> new Compound(Compound.box(0, 0, 1.4, 0.25), Compound.box(-0.575, 0.4, 0.25, 0.6), Compound.box(0.575, 0.4, 0.25, 0.6));
            case 5 -> new Compound(Compound.disc(0, 0, 0.35), Compound.box(0.55, 0.2, 0.5, 0.12), Compound.box(0.55, -0.2, 0.5, 0.12));
            default -> Compound.outline(0, 0, 1.2, 0, 1.2, 0.3, 0.3, 0.3, 0.3, 0.9, 0, 0.9);
        };
    }

    private void addBody() {
        if (bodies.size() >= MOST_BODIES) {
            return;
        }
        Body body = new Body(shape()).at(-9 + 18 * random.nextDouble(), 1 + 17 * random.nextDouble(), 6 * random.nextDouble());
        body.setFriction(friction);
        body.setRestitution(restitution);
        if (random.nextInt(3) == 0) {
            body.setSurfaceFriction(0.3);
        }
        if (random.nextBoolean()) {
            body.moving(4 * random.nextGaussian(), 4 * random.nextGaussian(), 3 * random.nextGaussian());
        }
        if (engine.queries().within(body.getX(), body.getY(), body.getShape().boundingRadius(), null).isEmpty()) {
            bodies.add(engine.add(body));
        }
    }

    /** Something, and a step. */
    void step() {
        if (random.nextInt(3) == 0) {
            change();
        }
        for (Body body : bodies) {
            if (random.nextInt(20) == 0) {
                body.addForce(10 * random.nextGaussian(), 10 * random.nextGaussian());
            }
        }
        engine.step();
    }

    private void change() {
        int what = random.nextInt(22);
        if (bodies.isEmpty()) {
            addBody();
            return;
        }
        Body a = bodies.get(random.nextInt(bodies.size()));
        Body b = bodies.get(random.nextInt(bodies.size()));
        if (what < 8) {
            addBody();
        } else if (what < 13) {
            tie(what, a, b);
        } else if (what < 19) {
            write(what, a);
        } else if (what < 21 && a != b) {
            double apart = Math.hypot(a.getX() - b.getX(), a.getY() - b.getY());
            if (what == 19) {
                joints.add(engine.add(Limit.rope(a, 0, 0, b, 0, 0, apart + 0.5)));
            } else if (apart > 0.5) {
                joints.add(engine.add(new RodJoint(a, a.getX(), a.getY(), b, b.getX(), b.getY())));
            }
        }
    }

    private void tie(int what, Body a, Body b) {
        boolean areNear = a != b && Math.hypot(a.getX() - b.getX(), a.getY() - b.getY()) < 2;
        if (what == 8) {
            engine.remove(a);
            bodies.remove(a);
            joints.removeIf(joint -> !engine.contains(joint));
        } else if (what == 9 && areNear) {
            joints.add(engine.add(new PinJoint(a, b, (a.getX() + b.getX()) / 2, (a.getY() + b.getY()) / 2)));
        } else if (what == 10 && areNear) {
            WeldJoint weld = new WeldJoint(a, b, (a.getX() + b.getX()) / 2, (a.getY() + b.getY()) / 2);
            weld.setBreakingLoad(50, 50);
            joints.add(engine.add(weld));
        } else if (what == 11) {
            joints.add(engine.add(new PinJoint(a, a.getX(), a.getY())));
            joints.add(engine.add(Motor.turning(a, null, 5 * random.nextGaussian(), 3)));
        } else if (what == 12 && !joints.isEmpty()) {
            Constraint joint = joints.remove(random.nextInt(joints.size()));
            if (engine.contains(joint)) { // or it has broken
                engine.remove(joint);
            }
        }
    }

    private void write(int what, Body a) {
        switch (what) {
            case 13 -> engine.add(new Spring(a, 0, 0, null, a.getX(), a.getY() + 2, 1, 20, 0.5));
            case 14 -> a.addImpulseAt(random.nextGaussian(), random.nextGaussian(), a.getX() + 0.1, a.getY());
            case 15 -> a.setVelocity(5 * random.nextGaussian(), 5 * random.nextGaussian());
            case 16 -> a.setAngularVelocity(5 * random.nextGaussian());
            case 17 -> a.setMass(0.1 + 3 * random.nextDouble());
            default -> a.setRestitution(random.nextDouble());
        }
    }
}
