// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** What falls asleep, and how it is seen that it does. */
final class SleepScenes {
    static final double STEP = 1.0 / 60;

    private SleepScenes() {}

    static PhysicsEngine scene(String name) {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        switch (name) {
            case "stack" -> Stepped.stack(engine, 10);
            case "pyramid" -> pyramid(engine);
            case "heap" -> heap(engine, 1);
            case "ragdoll" -> ragdoll(engine);
            case "bridge" -> bridge(engine);
            default -> throw new IllegalArgumentException(name);
        }
        return engine;
    }

    private static void pyramid(PhysicsEngine engine) {
        engine.add(new Gravity(0, -Stepped.G));
        Stepped.ground(engine);
        for (int row = 0; row < 10; row++) {
            for (int k = 0; k < 10 - row; k++) {
                Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(1.1 * (k + 0.5 * row), 0.5 + row)));
            }
        }
    }

    /** One of many heaps. */
    static PhysicsEngine heap(int seed) {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        heap(engine, seed);
        return engine;
    }

    /** Forty discs, boxes and polygons that fall into a bin. */
    private static void heap(PhysicsEngine engine, int seed) {
        engine.add(new Gravity(0, -Stepped.G));
        SteppedHeapTest.bin(engine, 5);
        SplittableRandom random = new SplittableRandom(seed);
        for (int k = 0; k < 40; k++) {
            Shape shape = k % 3 == 0 ? new Circle(0.5) : k % 3 == 1 ? new Rectangle(1, 0.8) : Polygon.regular(3 + k % 5, 0.6);
            Stepped.rough(engine.add(new Body(shape).at(1.4 * (k % 7) - 4.2, 1.4 * (k / 7) - 4, 6 * random.nextDouble())));
        }
    }

    private static void ragdoll(PhysicsEngine engine) {
        engine.add(new Gravity(0, -Stepped.G));
        Stepped.ground(engine);
        Body trunk = engine.add(new Body(new Rectangle(0.4, 0.8)).at(0, 2));
        Body head = engine.add(new Body(new Circle(0.2)).at(0, 2.6));
        engine.add(new PinJoint(trunk, head, 0, 2.4));
        for (int side = -1; side <= 1; side += 2) {
            Body arm = engine.add(new Body(new Rectangle(0.5, 0.15)).at(0.45 * side, 2.3));
            engine.add(new PinJoint(trunk, arm, 0.2 * side, 2.3));
            Body hand = engine.add(new Body(new Rectangle(0.5, 0.12)).at(0.95 * side, 2.3));
            engine.add(new PinJoint(arm, hand, 0.7 * side, 2.3));
            Body thigh = engine.add(new Body(new Rectangle(0.18, 0.5)).at(0.12 * side, 1.35));
            engine.add(new PinJoint(trunk, thigh, 0.12 * side, 1.6));
            Body shin = engine.add(new Body(new Rectangle(0.15, 0.5)).at(0.12 * side, 0.85));
            engine.add(new PinJoint(thigh, shin, 0.12 * side, 1.1));
        }
        for (Body body : engine.bodies()) {
            Stepped.rough(body);
            if (!body.isFixed()) {
                body.setAngularVelocity(0.3);
            }
        }
    }

    /** Eight planks that hang between two points, with a load. */
    private static void bridge(PhysicsEngine engine) {
        engine.add(new Gravity(0, -Stepped.G));
        Body last = null;
        for (int k = 0; k < 8; k++) {
            Body plank = Stepped.rough(engine.add(new Body(new Rectangle(1, 0.2)).at(k + 0.5, 0)));
            engine.add(last == null ? new PinJoint(plank, 0, 0) : new PinJoint(last, plank, k, 0));
            last = plank;
        }
        engine.add(new PinJoint(last, 8, 0));
        Stepped.rough(engine.add(new Body(new Rectangle(0.8, 0.8)).at(4, 0.5)));
    }

    static List<Body> movable(PhysicsEngine engine) {
        List<Body> all = new ArrayList<>(engine.bodies());
        all.removeIf(Body::isFixed);
        return all;
    }

    static boolean allSleep(PhysicsEngine engine) {
        return movable(engine).stream().allMatch(engine::isAsleep);
    }

    /** Steps until all bodies sleep; false if that takes more than two minutes. */
    static boolean fallAsleep(PhysicsEngine engine) {
        for (int k = 0; k < 120 / engine.getTimeStep() && !allSleep(engine); k++) {
            engine.step();
        }
        return allSleep(engine);
    }

    /** Places and angles of all bodies. */
    static double[] places(PhysicsEngine engine) {
        return engine.bodies().stream()
                .flatMapToDouble(body -> DoubleStream.of(body.getX(), body.getY(), body.getAngle()))
                .toArray();
    }

    static double energy(PhysicsEngine engine) {
        double sum = engine.kineticEnergy();
        for (Body body : movable(engine)) {
            sum += body.getMass() * Stepped.G * body.getY();
        }
        return sum;
    }
}
