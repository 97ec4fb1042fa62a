// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.GearJoint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Scenes with joints as users have them; nothing collides. */
final class Mechanisms {
    static final Map<String, Supplier<PhysicsEngine>> ALL = new LinkedHashMap<>();

    static {
        ALL.put("ring", Mechanisms::ring);
        ALL.put("bridge", Mechanisms::bridge);
        ALL.put("car", Mechanisms::car);
        ALL.put("arm", Mechanisms::arm);
        ALL.put("ragdoll", Mechanisms::ragdoll);
        ALL.put("rods", Mechanisms::rods);
        ALL.put("gears", Mechanisms::gears);
        ALL.put("door", Mechanisms::door);
        ALL.put("crank", Mechanisms::crank);
        ALL.put("snake", Mechanisms::snake);
        ALL.put("welds", Mechanisms::welds);
    }

    private Mechanisms() {}

    private static PhysicsEngine engine() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 240.0);
        engine.add(new Gravity(0, -9.81));
        return engine;
    }

    private static Body box(PhysicsEngine engine, double width, double height, double x, double y) {
        Body body = engine.add(new Body(new Rectangle(width, height)).at(x, y));
        body.setMass(1, (width * width + height * height) / 12);
        body.setCollisionGroup(1, 0);
        return body;
    }

    private static Body disc(PhysicsEngine engine, double radius, double x, double y) {
        Body body = engine.add(new Body(new Circle(radius)).at(x, y));
        body.setMass(1, radius * radius / 2);
        body.setCollisionGroup(1, 0);
        return body;
    }

    /** Six rods pinned to a ring, hung at a corner. */
    private static PhysicsEngine ring() {
        PhysicsEngine engine = engine();
        Body[] rods = new Body[6];
        double radius = Math.sqrt(3) / 2;
        for (int k = 0; k < 6; k++) {
            double angle = Math.PI / 3 * k;
            rods[k] = box(engine, 1, 0.05, radius * StrictMath.cos(angle), radius * StrictMath.sin(angle));
            rods[k].setAngle(angle + Math.PI / 2);
        }
        for (int k = 0; k < 6; k++) {
            double angle = Math.PI / 3 * (k + 0.5);
            engine.add(new PinJoint(rods[k], rods[(k + 1) % 6], StrictMath.cos(angle), StrictMath.sin(angle)));
        }
        engine.add(new PinJoint(rods[0], radius, -0.5));
        return engine;
    }

    /** Twenty links between two walls, hung by a rod. */
    private static PhysicsEngine bridge() {
        PhysicsEngine engine = engine();
        double cos = StrictMath.cos(0.3);
        double sin = StrictMath.sin(0.3);
        Body[] links = new Body[20];
        for (int k = 0; k < 20; k++) {
            double way = k + 0.5;
            links[k] = box(engine, 1, 0.1, way * cos, -sin * Math.min(way, 20 - way));
            links[k].setAngle(k < 10 ? -0.3 : 0.3);
            engine.add(
                    k == 0
                            ? new PinJoint(links[0], 0, 0)
                            : new PinJoint(links[k - 1], links[k], k * cos, -sin * Math.min(k, 20 - k)));
        }
        engine.add(new PinJoint(links[19], 20 * cos, 0));
        engine.add(new RodJoint(links[6], links[6].getX(), links[6].getY(), null, links[6].getX() + 0.5, 3));
        return engine;
    }

    /** A chassis with two hubs on sliders, springs and dampers, and wheels with motors. */
    private static PhysicsEngine car() {
        PhysicsEngine engine = engine();
        Body chassis = box(engine, 2, 0.5, 0, 0);
        chassis.setMass(10, 4);
        for (int side = -1; side <= 1; side += 2) {
            Body hub = box(engine, 0.2, 0.2, side * 0.8, -0.5);
            Body wheel = disc(engine, 0.3, side * 0.8, -0.5);
            engine.add(new SliderJoint(hub, chassis, side * 0.8, -0.5, 0, 1));
            engine.add(new PinJoint(wheel, hub, side * 0.8, -0.5));
            engine.add(new Spring(chassis, side * 0.8, 0, hub, 0, 0, 0.6, 400, 5));
            engine.add(Motor.turning(wheel, chassis, -30, 1.5));
        }
        engine.bodies().forEach(body -> body.setVelocity(5, 3));
        return engine;
    }

    /** Three links with motors and stops. */
    private static PhysicsEngine arm() {
        PhysicsEngine engine = engine();
        Body last = null;
        for (int k = 0; k < 3; k++) {
            Body link = box(engine, 1, 0.1, k + 0.5, 0);
            engine.add(new PinJoint(link, last, k, 0));
            engine.add(Motor.turning(link, last, 0.3 - 0.2 * k, 200));
            engine.add(Limit.angle(link, last, -1.2, 1.2));
            last = link;
        }
        return engine;
    }

    private static void join(PhysicsEngine engine, Body a, Body b, double x, double y, double lower, double upper) {
        engine.add(new PinJoint(a, b, x, y));
        engine.add(Limit.angle(a, b, lower, upper));
    }

    /** Eleven bodies with ten stops, hung by a hand. */
    private static PhysicsEngine ragdoll() {
        PhysicsEngine engine = engine();
        Body torso = box(engine, 0.3, 0.5, 0, 0);
        Body hips = box(engine, 0.3, 0.2, 0, -0.35);
        join(engine, hips, torso, 0, -0.25, -0.5, 0.5);
        join(engine, box(engine, 0.2, 0.2, 0, 0.35), torso, 0, 0.25, -0.6, 0.6);
        Body hand = null;
        for (int side = -1; side <= 1; side += 2) {
            Body upper = box(engine, 0.3, 0.1, side * 0.3, 0.2);
            hand = box(engine, 0.3, 0.1, side * 0.6, 0.2);
            join(engine, upper, torso, side * 0.15, 0.2, -1.5, 1.5);
            join(engine, hand, upper, side * 0.45, 0.2, side > 0 ? -0.1 : -2, side > 0 ? 2 : 0.1);
            Body thigh = box(engine, 0.12, 0.4, side * 0.1, -0.65);
            join(engine, thigh, hips, side * 0.1, -0.45, -0.8, 1.2);
            join(engine, box(engine, 0.1, 0.4, side * 0.1, -1.05), thigh, side * 0.1, -0.85, -1.8, 0.05);
        }
        engine.add(new PinJoint(hand, 0.75, 0.2));
        return engine;
    }

    /** A pendulum of ten discs on rods without mass. */
    private static PhysicsEngine rods() {
        PhysicsEngine engine = engine();
        Body last = null;
        for (int k = 0; k < 10; k++) {
            Body disc = disc(engine, 0.1, k + 1, 0);
            engine.add(new RodJoint(disc, k + 1, 0, last, k, 0));
            last = disc;
        }
        return engine;
    }

    /** Six wheels in a row, the first one driven. */
    private static PhysicsEngine gears() {
        PhysicsEngine engine = engine();
        Body last = null;
        for (int k = 0; k < 6; k++) {
            Body wheel = disc(engine, k % 2 == 0 ? 0.5 : 0.3, 0.8 * k, 0);
            engine.add(new PinJoint(wheel, 0.8 * k, 0));
            engine.add(
                    last == null
                            ? Motor.turning(wheel, null, 8, 3)
                            : new GearJoint(wheel, last, k % 2 == 0 ? 0.6 : 1 / 0.6));
            last = wheel;
        }
        return engine;
    }

    /** A door with a spring, a damper and stops. */
    private static PhysicsEngine door() {
        PhysicsEngine engine = engine();
        Body door = box(engine, 1, 0.05, 0.5, 0);
        join(engine, door, null, 0, 0, -0.01, 2);
        engine.add(new Spring(door, 0.3, 0, null, 0.3, -0.5, 0.5, 20, 1));
        door.setVelocity(0, 1.5);
        door.setAngularVelocity(3);
        return engine;
    }

    /** A crank, its rod and a piston. */
    private static PhysicsEngine crank() {
        PhysicsEngine engine = engine();
        Body crank = box(engine, 0.5, 0.1, 0.25, 0);
        Body rod = box(engine, 1.5, 0.1, 1.25, 0);
        Body piston = box(engine, 0.4, 0.3, 2, 0);
        engine.add(new PinJoint(crank, 0, 0));
        engine.add(new PinJoint(rod, crank, 0.5, 0));
        engine.add(new PinJoint(piston, rod, 2, 0));
        engine.add(new SliderJoint(piston, null, 2, 0, 1, 0));
        crank.setVelocity(0, 1.5);
        crank.setAngularVelocity(6);
        engine.assemble();
        return engine;
    }

    /** Ten pinned rods with springs between them. */
    private static PhysicsEngine snake() {
        PhysicsEngine engine = engine();
        Body last = null;
        for (int k = 0; k < 10; k++) {
            Body rod = box(engine, 1, 0.1, k + 0.5, 0);
            engine.add(new PinJoint(rod, last, k, 0));
            if (last != null) {
                engine.add(new Spring(last, 0, 0.3, rod, 0, 0.3, 1, 300, 3));
            }
            last = rod;
        }
        return engine;
    }

    /** Three pairs of welded rods, pinned. */
    private static PhysicsEngine welds() {
        PhysicsEngine engine = engine();
        Body last = null;
        for (int k = 0; k < 6; k++) {
            Body rod = box(engine, 1, 0.2, k + 0.5, 0);
            engine.add(k % 2 == 1 ? new WeldJoint(rod, last, k, 0) : new PinJoint(rod, last, k, 0));
            last = rod;
        }
        return engine;
    }
}
