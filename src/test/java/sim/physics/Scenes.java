// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import sim.physics.collision.narrow.Distance;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.scenes.Gas;
import sim.physics.scenes.SceneData;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Scenes that several tests and benchmarks use. */
public final class Scenes {
    private Scenes() {}

    /** Which bodies a gas has. */
    public enum Kind {
        /** Half circles of radius 5, half rectangles 5 × 10, as in Figure 1 of the write-up. */
        FIGURE_1,
        /** Regular triangles to octagons of circumradius 5. */
        POLYGONS
    }

    /** A gas between four walls: 17 % of the area covered, elastic, no friction. */
    public static PhysicsEngine gas(Kind kind, int bodies, long seed) {
        PhysicsEngine engine = new PhysicsEngine();
        fill(engine, kind, bodies, seed);
        return engine;
    }

    /** The gas S3, half circles and half rectangles, 20 % of the area covered, with its masses by area. */
    public static PhysicsEngine s3(int bodies, long seed) {
        SceneData data = Gas.s3(bodies, seed);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(data.dt());
        for (SceneData.Box wall : data.walls()) {
            engine.add(Body.fixed(new Rectangle(wall.width(), wall.height())).at(wall.x(), wall.y()));
        }
        for (int k = 0; k < bodies; k++) {
            boolean isCircle = data.kind()[k] == SceneData.Kind.CIRCLE;
            Body body = new Body(isCircle ? new Circle(data.sizeA()[k]) : new Rectangle(data.sizeA()[k], data.sizeB()[k]));
            engine.add(body.at(data.x()[k], data.y()[k], data.theta()[k])
                    .moving(data.vx()[k], data.vy()[k], data.omega()[k]));
        }
        return engine;
    }

    /** A chain of thin rods of length and mass 1, pinned at the origin and lying to the right of it; returns the last one. */
    public static Body rods(PhysicsEngine engine, int count, long collidesWith) {
        Body last = null;
        for (int k = 0; k < count; k++) {
            Body rod = engine.add(new Body(new Rectangle(1, 0.01)).at(k + 0.5, 0));
            rod.setMass(1, 1 / 12.0);
            rod.setCollisionGroup(1, collidesWith);
            engine.add(new PinJoint(last == null ? rod : last, last == null ? null : rod, k, 0));
            last = rod;
        }
        return last;
    }

    /** Inner half width of the box of {@link #gas}; its centre is the origin. */
    public static double halfWidth(int bodies) {
        return 0.5 * Math.sqrt(bodies * 64.27 / 0.17);
    }

    private static void fill(PhysicsEngine engine, Kind kind, int bodies, long seed) {
        double half = halfWidth(bodies);
        SplittableRandom random = new SplittableRandom(seed);
        for (int side = -1; side <= 1; side += 2) {
            engine.add(Body.fixed(new Rectangle(2 * half + 12, 6)).at(0, side * (half + 3)));
            engine.add(Body.fixed(new Rectangle(6, 2 * half + 12)).at(side * (half + 3), 0));
        }
        Distance distance = new Distance();
        List<Body> placed = new ArrayList<>(engine.bodies());
        for (int k = 0; k < bodies; k++) {
            Body body = new Body(shape(kind, k));
            do {
                body.at(half * (2 * random.nextDouble() - 1), half * (2 * random.nextDouble() - 1));
                body.setAngle(kind == Kind.FIGURE_1 ? 0 : 6 * random.nextDouble());
            } while (!isFree(body, placed, distance));
            double speed = k % 2 == 0 ? 1 : 2;
            body.moving(speed * component(random), speed * component(random));
            body.setAngularVelocity(kind == Kind.FIGURE_1 ? 0 : 0.1 * component(random));
            placed.add(engine.add(body));
        }
    }

    private static Shape shape(Kind kind, int k) {
        if (kind == Kind.POLYGONS) {
            return Polygon.regular(3 + k % 6, 5);
        }
        return k % 2 == 0 ? new Circle(5) : new Rectangle(5, 10);
    }

    private static boolean isFree(Body body, List<Body> placed, Distance distance) {
        for (Body other : placed) {
            double reach = body.getShape().boundingRadius() + other.getShape().boundingRadius();
            boolean near = Math.hypot(body.getX() - other.getX(), body.getY() - other.getY()) <= reach;
            if (near && distance.between(body, other) <= 0) {
                return false;
            }
        }
        return true;
    }

    private static double component(SplittableRandom random) {
        double magnitude = random.nextDouble();
        return random.nextBoolean() ? magnitude : -magnitude;
    }

    /** The smallest gap between any two bodies of an engine. */
    public static double smallestGap(PhysicsEngine engine) {
        Distance distance = new Distance();
        List<Body> all = engine.bodies();
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < all.size(); i++) {
            for (int j = 0; j < i; j++) {
                Body a = all.get(i);
                Body b = all.get(j);
                double reach = a.getShape().boundingRadius() + b.getShape().boundingRadius();
                boolean near = Math.hypot(a.getX() - b.getX(), a.getY() - b.getY()) <= reach;
                if (near && !(a.isFixed() && b.isFixed())) {
                    least = Math.min(least, distance.between(a, b));
                }
            }
        }
        return least;
    }

    /** A hash of all positions and velocities, to the last bit. */
    public static long hash(PhysicsEngine engine) {
        long hash = 1125899906842597L;
        for (Body b : engine.bodies()) {
            double[] values = {
                b.getX(), b.getY(), b.getAngle(), b.getVelocityX(), b.getVelocityY(), b.getAngularVelocity()
            };
            for (double value : values) {
                hash = 31 * hash + Double.doubleToLongBits(value);
            }
        }
        return hash;
    }

    /** Lets so many threads share the work of an engine's steps, however little there is. */
    public static void share(PhysicsEngine engine, int threads) {
        engine.setThreads(threads, true);
    }
}
