// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;

/** Bodies that start flush or corner to corner and move off in any way: none gets into another one. */
class FlushStartTest {
    private static final double[] SIZES = {0.5, 1, 2};

    /** Depth that heaps of bodies that bounce no more may have. */
    private static final double DEEPEST = 1e-6;

    private static double depth(PhysicsEngine engine) {
        return engine.overlaps().stream().mapToDouble(Overlap::depth).max().orElse(0);
    }

    /** A regular polygon on one of its edges. */
    private static Polygon regular(int n, double radius) {
        double[] xy = new double[2 * n];
        for (int k = 0; k < n; k++) {
            double angle = -0.5 * StrictMath.PI + (2 * k + 1) * StrictMath.PI / n;
            xy[2 * k] = radius * StrictMath.cos(angle);
            xy[2 * k + 1] = radius * StrictMath.sin(angle);
        }
        return new Polygon(xy);
    }

    private static double pick(SplittableRandom random) {
        return SIZES[random.nextInt(SIZES.length)];
    }

    private static double speed(SplittableRandom random, double most) {
        return random.nextInt(4) == 0 ? 0 : most * (2 * random.nextDouble() - 1);
    }

    private static PhysicsEngine pair(SplittableRandom random) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        if (random.nextInt(3) == 0) {
            engine.add(new Gravity(0, -9.81));
        }
        double width = pick(random);
        double height = pick(random);
        double size = pick(random);
        int corners = new int[] {4, 6, 8}[random.nextInt(3)];
        double rise = pick(random);
        double half = corners == 4 ? 0.5 * size : size * StrictMath.sin(StrictMath.PI / corners);
        double up = corners == 4 ? 0.5 * rise : size * StrictMath.cos(StrictMath.PI / corners);
        double[] shifts = {
            0.5 * width + half, -0.5 * width - half, 0.5 * width - half, half, 0, random.nextDouble() * (0.5 * width + half)
        };
        Body a = new Body(new Rectangle(width, height));
        Body b = new Body(corners == 4 ? new Rectangle(size, rise) : regular(corners, size));
        b.at(shifts[random.nextInt(shifts.length)], 0.5 * height + up);
        double most = random.nextBoolean() ? 1 : 5;
        double restitution = 0.5 * random.nextInt(3);
        double friction = 0.5 * random.nextInt(2);
        for (Body body : new Body[] {a, b}) {
            body.moving(speed(random, most), speed(random, most), speed(random, 2 * most));
            body.setRestitution(restitution);
            body.setFriction(friction);
            engine.add(body);
        }
        return engine;
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void pairsDoNotMeetUnseen(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        for (int k = 0; k < 500; k++) {
            PhysicsEngine engine = pair(random);
            double first = depth(engine);
            for (int step = 0; step < 60; step++) {
                engine.step();
                assertThat(depth(engine)).as("seed %s, pair %s, step %s", seed, k, step).isLessThan(DEEPEST + 2 * first);
            }
        }
    }

    /** Unit squares on a lattice that they may fill, elastic, with speeds that are whole numbers. */
    private static PhysicsEngine lattice(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        if (seed % 4 != 0) {
            engine.add(new Gravity(0, -9.81));
        }
        engine.add(Body.fixed(new Rectangle(40, 1)).at(0, -0.5));
        double spacing = new double[] {1, 1, 1.25, 1.5}[random.nextInt(4)];
        Set<Integer> taken = new HashSet<>();
        for (int k = 2 + random.nextInt(24); k > 0; k--) {
            int place = random.nextInt(36);
            if (taken.add(place)) {
                Body square = new Body(new Rectangle(1, 1)).at((place % 6 - 3) * spacing, 0.5 + place / 6 * spacing);
                square.setFriction(0.5 * random.nextInt(2));
                square.moving(random.nextInt(5) - 2, random.nextInt(5) - 2, random.nextInt(5) - 2);
                engine.add(square);
            }
        }
        return engine;
    }

    private static void latticesStayApart(int seeds) {
        for (long seed = 0; seed < seeds; seed++) {
            PhysicsEngine engine = lattice(seed);
            for (int step = 0; step < 120; step++) {
                engine.step();
                assertThat(depth(engine)).as("seed %s, step %s", seed, step).isLessThan(DEEPEST);
            }
        }
    }

    @Test
    void latticesStayApart() {
        latticesStayApart(40);
    }

    @Test
    @Tag("soak")
    void manyLatticesStayApart() {
        latticesStayApart(1000);
    }
}
