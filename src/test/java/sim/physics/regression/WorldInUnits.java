// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.SlotJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.Euler;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.Spring;
import sim.physics.motion.SurfaceFriction;
import sim.physics.motion.SymplecticEuler;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** A world of bodies, joints, motors and springs between walls that is drawn from a seed, and measured in any units. */
final class WorldInUnits {
    private static final int KINDS = 8;

    final PhysicsEngine engine = new PhysicsEngine();
    final List<Body> bodies = new ArrayList<>();
    private final double length;
    private final double time;
    private final double mass;
    private final SplittableRandom random;
    private final double half;
    private final double friction;
    private final double restitution;

    /**
     * Draws a world.
     *
     * @param length how many of its units a metre is, and so on
     */
    WorldInUnits(long seed, double length, double time, double mass) {
        this.length = length;
        this.time = time;
        this.mass = mass;
        random = new SplittableRandom(seed);
        engine.setTimeStep(time / (20 + random.nextInt(220)));
        engine.setIntegrator(method());
        engine.setTimeStepping(random.nextInt(4) == 0 ? 4 : 0);
        int count = 2 + random.nextInt(14);
        half = 2 * Math.sqrt(count) * (1 + random.nextDouble());
        friction = random.nextInt(3) == 0 ? 0 : random.nextDouble();
        restitution = random.nextInt(3) * 0.5;
        double acceleration = length / (time * time);
        if (random.nextInt(4) > 0) {
            engine.add(new Gravity(2 * signed() * acceleration, -10 * random.nextDouble() * acceleration));
        }
        if (random.nextInt(4) == 0) {
            engine.add(new SurfaceFriction(9.81 * acceleration));
        }
        for (int side = -1; side <= 1; side += 2) {
            rub(engine.add(Body.fixed(box(2 * half + 4, 2)).at(0, side * (half + 1) * length)));
            rub(engine.add(Body.fixed(box(2, 2 * half + 4)).at(side * (half + 1) * length, 0)));
        }
        for (int k = 0; k < count; k++) {
            place();
        }
        for (int k = random.nextInt(6); k > 0 && bodies.size() > 1; k--) {
            tie();
        }
    }

    private Integrator method() {
        double tolerance = 1e-6 * length;
        return switch (random.nextInt(7)) {
            case 0 -> new Euler();
            case 1 -> new DormandPrince853(tolerance);
            case 2 -> new GraggBulirschStoer(tolerance);
            case 3 -> new RadauIIA(tolerance);
            case 4 -> new SymplecticEuler();
            default -> new RungeKutta4();
        };
    }

    private double signed() {
        return 2 * random.nextDouble() - 1;
    }

    private Shape box(double width, double height) {
        return new Rectangle(width * length, height * length);
    }

    private void rub(Body body) {
        body.setFriction(friction);
        body.setRestitution(restitution);
    }

    private Shape shape() {
        double size = 0.3 + 0.7 * random.nextDouble();
        switch (random.nextInt(5)) {
            case 0 -> {
                return new Circle(size * length);
            }
            case 1 -> {
                return box(2 * size, size * (0.2 + random.nextDouble()));
            }
            case 2 -> {
                double thick = 0.3 * size * length;
                double arm = size * length;
                return new Compound(Compound.box(0, 0, 2 * arm, thick), Compound.box(0.5 * arm, 0.5 * (thick + arm), thick, arm));
            }
            default -> {
                double[] xy = new double[2 * (3 + random.nextInt(5))];
                for (int k = 0; k < xy.length; k += 2) {
                    double angle = 2 * Math.PI * (k + random.nextDouble()) / xy.length;
                    xy[k] = size * StrictMath.cos(angle) * length;
                    xy[k + 1] = size * StrictMath.sin(angle) * length;
                }
                return new Polygon(xy);
            }
        }
    }

    /** Tries to put a body where it touches nothing. */
    private void place() {
        Shape shape = shape();
        Body body = random.nextInt(9) == 0 ? Body.fixed(shape) : new Body(shape);
        double heavy = random.nextInt(3) == 0 ? StrictMath.pow(10, signed()) : 1;
        boolean moves = random.nextInt(3) > 0;
        double[] velocity = {3 * signed(), 3 * signed(), 3 * signed()};
        double rubs = 0.3 * random.nextDouble();
        for (int tries = 0; tries < 30; tries++) {
            body.at(half * signed() * length, half * signed() * length, 3 * signed());
            if (RandomScene.isFree(engine, body, 1e-3 * length)) {
                if (!body.isFixed()) {
                    body.setMass(heavy * mass);
                    bodies.add(body);
                }
                if (!body.isFixed() && moves) {
                    double speed = length / time;
                    body.moving(velocity[0] * speed, velocity[1] * speed, velocity[2] / time);
                }
                rub(body);
                body.setSurfaceFriction(rubs);
                engine.add(body);
                return;
            }
        }
    }

    private void tie() {
        Body a = bodies.get(random.nextInt(bodies.size()));
        Body b = bodies.get(random.nextInt(bodies.size()));
        int kind = random.nextInt(KINDS);
        double[] drawn = {random.nextDouble(), signed(), random.nextDouble()};
        if (a != b) {
            tie(kind, a, b, drawn);
        }
    }

    private void tie(int kind, Body a, Body b, double[] drawn) {
        double x = 0.5 * (a.getX() + b.getX());
        double y = 0.5 * (a.getY() + b.getY());
        double dx = b.getX() - a.getX();
        double dy = b.getY() - a.getY();
        double apart = Math.sqrt(dx * dx + dy * dy);
        double force = mass * length / (time * time);
        switch (kind) {
            case 0 -> engine.add(new PinJoint(a, b, x, y));
            case 1 -> engine.add(new RodJoint(a, a.getX(), a.getY(), b, b.getX(), b.getY()));
            case 2 -> engine.add(new WeldJoint(a, b, x, y));
            case 3 -> engine.add(new SlotJoint(a, b, x, y, dx / apart, dy / apart));
            case 4 -> slide(engine.add(new SliderJoint(a, b, x, y, dx / apart, dy / apart)), drawn, force);
            case 5 -> engine.add(Limit.rope(a, 0, 0, b, 0, 0, apart + drawn[0] * length));
            case 6 -> {
                engine.add(new PinJoint(a, a.getX(), a.getY()));
                engine.add(Motor.turning(a, null, 3 * drawn[1] / time, 5 * drawn[2] * force * length));
            }
            default -> engine.add(new Spring(
                    a, 0, 0, b, 0, 0, apart * drawn[0], 50 * drawn[2] * force / length, drawn[0] * mass / time));
        }
    }

    private void slide(SliderJoint slider, double[] drawn, double force) {
        if (drawn[0] < 0.5) {
            engine.add(Motor.sliding(slider, 2 * drawn[1] * length / time, 20 * drawn[2] * force));
        }
        if (drawn[0] < 0.3) {
            engine.add(Limit.travel(slider, -drawn[2] * length, drawn[2] * length, restitution));
        }
    }

    /** Places and velocities of all bodies in metres, radians and seconds. */
    double[] plain() {
        double[] all = new double[6 * bodies.size()];
        for (int k = 0; k < bodies.size(); k++) {
            Body body = bodies.get(k);
            all[6 * k] = body.getX() / length;
            all[6 * k + 1] = body.getY() / length;
            all[6 * k + 2] = body.getAngle();
            all[6 * k + 3] = body.getVelocityX() / length * time;
            all[6 * k + 4] = body.getVelocityY() / length * time;
            all[6 * k + 5] = body.getAngularVelocity() * time;
        }
        for (int k = 0; k < all.length; k++) {
            all[k] = Math.abs(all[k]) < Float.MIN_NORMAL ? 0 : all[k]; // squares of what is less than that may be none
        }
        return all;
    }
}
