// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Compound;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** A corner that meets two at one point, two tiles at their seam or the ground with two of its parts, is one corner: a body tips on it. */
class CornerOnSeamTest {
    /** A hook whose cut goes through the corner on which it lands, or along its arm. */
    private static Shape hook(boolean isMitred) {
        return isMitred
                ? Compound.outline(0, 0, 1.24, 0, 1.24, 0.16, 0.16, 0.16, 0.16, 0.68, 0, 0.68)
                : new Compound(Compound.box(0.62, 0.08, 1.24, 0.16), Compound.box(0.08, 0.42, 0.16, 0.52));
    }

    private static PhysicsEngine world(double step, double friction, double... tiles) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.add(new Gravity(0, -9.81));
        for (int k = 0; k + 1 < tiles.length; k++) {
            double width = tiles[k + 1] - tiles[k];
            Body tile = engine.add(Body.fixed(new Rectangle(width, 1)).at(tiles[k] + width / 2, -0.5));
            tile.setFriction(friction);
            tile.setRestitution(0);
        }
        return engine;
    }

    private static Body drop(PhysicsEngine engine, Shape shape, double x, double y, double tilt, double friction) {
        Body body = engine.add(new Body(shape).at(x, y, tilt));
        body.setFriction(friction);
        body.setRestitution(0);
        return body;
    }

    /** As near as what is struck within a step is: of first order in it. */
    private static void assertSame(Body body, Body that, double within) {
        assertThat(body.getX()).isCloseTo(that.getX(), within(within));
        assertThat(body.getY()).isCloseTo(that.getY(), within(within));
        assertThat(body.getAngle()).isCloseTo(that.getAngle(), within(within));
    }

    private static double depth(PhysicsEngine engine) {
        return engine.overlaps().stream().mapToDouble(Overlap::depth).max().orElse(0);
    }

    @Test
    void aHookTipsOnItsCornerHoweverItIsCut() {
        SplittableRandom random = new SplittableRandom(7);
        for (int k = 0; k < 100; k++) {
            double friction = random.nextDouble();
            double tilt = 0.02 * (2 * random.nextDouble() - 1);
            double down = -10 * random.nextDouble();
            double spin = 15 * (2 * random.nextDouble() - 1);
            PhysicsEngine mitred = world(0.002, friction, -20, 20);
            PhysicsEngine square = world(0.002, friction, -20, 20);
            Body a = drop(mitred, hook(true), 0, 0.25, tilt, friction).moving(0, down, spin);
            Body b = drop(square, hook(false), 0, 0.25, tilt, friction).moving(0, down, spin);
            for (int step = 0; step < 50; step++) {
                mitred.step();
                square.step();
                assertThat(depth(mitred)).as("case %d, step %d", k, step).isLessThan(1e-9);
                assertSame(a, b, 1e-3);
            }
        }
    }

    /** It falls straight, its lowest corner onto the seam; it turns until it lies on one of the two, or across the seam. */
    @ParameterizedTest
    @ValueSource(doubles = {-0.3, -0.01, 0.004, 0.02, 0.2})
    void aBoxTipsOnTheSeamAsOnOneFloor(double tilt) {
        double corner = -Math.signum(tilt) * 0.5 * Math.cos(tilt) + 0.25 * Math.sin(tilt);
        PhysicsEngine tiled = world(0.0002, 0.5, -20, corner, 20);
        PhysicsEngine whole = world(0.0002, 0.5, -20, 20);
        Body a = drop(tiled, new Rectangle(1, 0.5), 0, 0.5, tilt, 0.5).moving(0, -3);
        Body b = drop(whole, new Rectangle(1, 0.5), 0, 0.5, tilt, 0.5).moving(0, -3);
        for (int step = 0; step < 2500; step++) {
            tiled.step();
            whole.step();
            assertThat(depth(tiled)).as("step %d", step).isLessThan(1e-9);
            assertSame(a, b, 1e-4);
        }
        assertThat(a.getY()).isCloseTo(0.25, within(1e-9));
        assertThat(Math.abs(a.getX())).as("friction has moved it").isGreaterThan(1e-4);
    }
}
