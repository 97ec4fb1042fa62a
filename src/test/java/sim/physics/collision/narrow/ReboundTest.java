// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import sim.physics.motion.Trajectories;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** For as long as bodies that touch are said to stay apart they do, by their distance at many instants. */
class ReboundTest {
    private static final int INSTANTS = 400;
    private static final double LONG = 20;

    private final Random random = new Random(5);
    private final ShapeTable shapes = new ShapeTable();
    private final Trajectories trajectories = new Trajectories();
    private final Pose pose = new Pose(shapes, trajectories);
    private final ClosestFeatures features = new ClosestFeatures(pose);
    private final SeparatingLine line = new SeparatingLine(shapes, trajectories, pose, features);

    private double between(double low, double high) {
        return low + (high - low) * random.nextDouble();
    }

    private Shape shape(int kind) {
        double size = between(0.2, 2);
        return switch (kind) {
            case 0 -> new Circle(size);
            case 1 -> new Rectangle(size, between(0.05, 3));
            default -> new Polygon(new double[] {-size, -0.3, size, -0.5, 0.2, size});
        };
    }

    private void place(int body, Shape shape, double x, double y) {
        shapes.set(body, shape);
        double[] m = trajectories.data();
        int o = body * Trajectories.STRIDE;
        m[o] = x;
        m[o + 1] = y;
        m[o + Trajectories.THETA0] = between(-3, 3);
        m[o + Trajectories.STEP] = 0;
        m[o + Trajectories.OFFSET] = 0;
        push(body, 3);
    }

    private void push(int body, double spin) {
        double[] m = trajectories.data();
        int o = body * Trajectories.STRIDE;
        m[o + Trajectories.VX] = between(-4, 4);
        m[o + Trajectories.VY] = between(-4, 4);
        m[o + Trajectories.OMEGA] = spin * between(-1, 1);
    }

    /** Moves a body on to an instant, as an impact does. */
    private void bring(int body, double tau) {
        double[] m = trajectories.data();
        int o = body * Trajectories.STRIDE;
        for (int c = 0; c < 3; c++) {
            m[o + c] += tau * m[o + Trajectories.VX + c];
        }
        m[o + Trajectories.OFFSET] = tau;
    }

    private double gap(double tau) {
        pose.load(0, 1);
        pose.moveTo(tau);
        pose.turn();
        features.find(ClosestFeatures.NO_FEATURES);
        return features.gap;
    }

    @Test
    void bodiesDoNotTouchForAsLongAsItSays() {
        trajectories.begin(0, 1);
        trajectories.ensure(2);
        int contacts = 0;
        int known = 0;
        int forGood = 0;
        for (int k = 0; k < 12_000; k++) {
            place(0, shape(k % 3), 0, 0);
            place(1, shape(1 + k % 2), between(-4, 4), between(-4, 4));
            if (gap(0) <= 0) {
                continue;
            }
            double tau = line.search(0, 1, 0, 1, ClosestFeatures.NO_FEATURES);
            if (!line.touching) {
                continue;
            }
            contacts++;
            bring(0, tau);
            bring(1, tau);
            double spin = k % 5 == 0 ? 30 : k % 7 == 0 ? 0 : 2;
            push(0, spin);
            push(1, spin);
            gap(tau);
            double time = Rebound.time(pose, features, trajectories.data(), 0, Trajectories.STRIDE);
            known += time > 0 ? 1 : 0;
            forGood += time == Double.POSITIVE_INFINITY ? 1 : 0;
            double until = Math.min(time, LONG);
            for (int i = 1; i <= INSTANTS && time > 0; i++) {
                double part = (double) i / INSTANTS; // more of the instants lie at the beginning
                assertThat(gap(tau + until * part * part)).as("pair %d at %d of %s", k, i, time).isGreaterThan(-1e-12);
            }
        }
        assertThat(contacts).isGreaterThan(1500);
        assertThat(known).isGreaterThan(contacts / 3);
        assertThat(forGood).isGreaterThan(contacts / 20);
    }

    @Test
    void aDiscLeavesAWallForGood() {
        trajectories.begin(0, 1);
        trajectories.ensure(2);
        place(0, new Rectangle(20, 2), 0, -1);
        trajectories.data()[Trajectories.THETA0] = 0;
        place(1, new Circle(1), 3, 1);
        double[] m = trajectories.data();
        m[Trajectories.VX] = 0;
        m[Trajectories.VY] = 0;
        m[Trajectories.OMEGA] = 0;
        m[Trajectories.STRIDE + Trajectories.VY] = 0.5;
        gap(0);
        assertThat(Rebound.time(pose, features, m, 0, Trajectories.STRIDE)).isEqualTo(Double.POSITIVE_INFINITY);
        m[Trajectories.STRIDE + Trajectories.VY] = -0.5;
        assertThat(Rebound.time(pose, features, m, 0, Trajectories.STRIDE)).isZero();
    }
}
