// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/**
 * Friction and inelastic impacts take all energy of a large pile of boxes that hardly bounce: what stands must not be moved by how it is
 * solved. A box that rocks loses most of its energy with each blow, so seconds do.
 */
class PilesComeToRestTest {
    /** How deep pairs of a large heap may be at rest, in sizes of a box. */
    private static final double DEPTH = 1.1e-4;

    private static PhysicsEngine ground(double friction) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -9.81));
        put(engine, Body.fixed(new Rectangle(100, 2)).at(0, -1), friction);
        return engine;
    }

    private static Body put(PhysicsEngine engine, Body body, double friction) {
        body.setFriction(friction);
        body.setRestitution(0);
        return engine.add(body);
    }

    private static boolean stands(PhysicsEngine engine) {
        return engine.bodies().stream()
                .allMatch(b -> b.getVelocityX() == 0 && b.getVelocityY() == 0 && b.getAngularVelocity() == 0);
    }

    private static double secondsUntilItStands(PhysicsEngine engine, double most) {
        while (!stands(engine) || engine.getSteps() == 0) {
            engine.step();
            if (engine.getTime() > most) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return engine.getTime();
    }

    /** Rows fall on one another from a little above. */
    @ParameterizedTest
    @CsvSource({"14, 0.01, 0.5", "16, 0.01, 0.5", "16, 0.05, 0.5", "13, 0.01, 0.2", "20, 0.001, 0.5"})
    void pyramidsStand(int rows, double gap, double friction) {
        PhysicsEngine engine = ground(friction);
        Body top = null;
        for (int row = 0; row < rows; row++) {
            for (int k = 0; k < rows - row; k++) {
                Body box = new Body(new Rectangle(1, 1)).at(1.1 * (k - 0.5 * (rows - row - 1)), 0.5 + gap + row * (1 + gap));
                top = put(engine, box, friction);
            }
        }
        assertThat(secondsUntilItStands(engine, 8)).isFinite();
        assertThat(top.getY()).isBetween(rows - 0.5 - DEPTH * rows, rows - 0.5 + 1e-9);
        assertThat(engine.overlaps()).allMatch(o -> o.depth() < DEPTH);
        double y = top.getY();
        engine.step();
        assertThat(top.getY()).isEqualTo(y);
    }

    /**
     * Boxes of many sizes fall into a bin, where they stand in leaning columns. Columns as slender rock for long, as an impact takes a few
     * hundredths of their energy: of six bins four are to stand within 25 s.
     */
    @Test
    void columnsInABinStand() {
        int standing = 0;
        for (int seed = 1; seed <= 6; seed++) {
            PhysicsEngine engine = bin(seed);
            if (Double.isFinite(secondsUntilItStands(engine, 25))) {
                standing++;
                assertThat(engine.overlaps()).as("seed %s", seed).allMatch(o -> o.depth() < DEPTH);
            }
        }
        assertThat(standing).isGreaterThanOrEqualTo(4);
    }

    private static PhysicsEngine bin(int seed) {
        PhysicsEngine engine = ground(0.5);
        put(engine, Body.fixed(new Rectangle(2, 100)).at(-9.7, 50), 0.5);
        put(engine, Body.fixed(new Rectangle(2, 100)).at(9.7, 50), 0.5);
        SplittableRandom random = new SplittableRandom(seed);
        for (int k = 0; k < 130; k++) {
            Body box = new Body(new Rectangle(random.nextDouble(0.5, 0.9), random.nextDouble(0.5, 0.8)));
            double x = -8 + k % 13 * 1.3 + random.nextDouble(0.05);
            put(engine, box.at(x, 0.8 + k / 13 * 1.2, random.nextDouble(0.3)), 0.5);
        }
        return engine;
    }
}
