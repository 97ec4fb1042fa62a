// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import java.util.Random;
import sim.physics.motion.Trajectories;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Two bodies of random shapes in uniform motion, and what looks at them. */
class MovingPair {
    final Random random;
    final ShapeTable shapes = new ShapeTable();
    final Trajectories trajectories = new Trajectories();
    final Pose pose = new Pose(shapes, trajectories);
    final ClosestFeatures features = new ClosestFeatures(pose);
    final SeparatingLine line = new SeparatingLine(shapes, trajectories, pose, features);

    MovingPair(long seed) {
        random = new Random(seed);
    }

    double between(double low, double high) {
        return low + (high - low) * random.nextDouble();
    }

    Shape shape(int kind) {
        double size = between(0.2, 2);
        return switch (kind) {
            case 0 -> new Circle(size);
            case 1 -> new Rectangle(size, between(0.05, 3));
            default -> new Polygon(new double[] {-size, -0.3, size, -0.5, 0.2, size});
        };
    }

    /** Puts a body somewhere at the start of a step, on its way somewhere else. */
    void place(int body, Shape shape, double x, double y, double spin) {
        shapes.set(body, shape);
        double[] m = trajectories.data();
        int o = body * Trajectories.STRIDE;
        m[o] = x;
        m[o + 1] = y;
        m[o + Trajectories.THETA0] = between(-3, 3);
        m[o + Trajectories.STEP] = 0;
        m[o + Trajectories.OFFSET] = 0;
        push(body, spin);
    }

    void push(int body, double spin) {
        double[] m = trajectories.data();
        int o = body * Trajectories.STRIDE;
        m[o + Trajectories.VX] = between(-4, 4);
        m[o + Trajectories.VY] = between(-4, 4);
        m[o + Trajectories.OMEGA] = spin * between(-1, 1);
    }

    double gap(double tau) {
        pose.load(0, 1);
        pose.moveTo(tau);
        pose.turn();
        features.find(ClosestFeatures.NO_FEATURES);
        return features.gap;
    }
}
