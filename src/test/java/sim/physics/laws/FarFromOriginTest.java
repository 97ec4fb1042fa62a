// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** What lies lies as well where coordinates are rounded to more than the depth that heaps have: some 10⁵ sizes and more from the origin. */
class FarFromOriginTest {
    private static PhysicsEngine engine(double away, double restitution, Body ground, Body... bodies) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -10));
        engine.add(ground);
        for (Body body : bodies) {
            engine.add(body);
        }
        for (Body body : engine.bodies()) {
            body.setPosition(body.getX() + away, body.getY() + 2 * away);
            body.setFriction(0.5);
            body.setRestitution(restitution);
        }
        return engine;
    }

    private static void compare(PhysicsEngine here, PhysicsEngine there, double away, double bound) {
        for (int k = 0; k < 150; k++) {
            here.step();
            there.step();
        }
        for (int k = 0; k < here.bodies().size(); k++) {
            Body one = here.bodies().get(k);
            Body other = there.bodies().get(k);
            assertThat(other.getX() - away).isCloseTo(one.getX(), within(bound));
            assertThat(other.getY() - 2 * away).isCloseTo(one.getY(), within(bound));
            assertThat(other.getAngle()).isCloseTo(one.getAngle(), within(bound));
        }
        assertThat(there.getWork()).isLessThan(10 * here.getWork() + 10_000);
    }

    /** A box falls askew onto the ground, slides, falls over and lies: it went through the ground at 10⁵. */
    @ParameterizedTest
    @CsvSource({"1e4", "1e5", "3e5", "1e6", "1e7"})
    void aBoxLands(double away) {
        compare(landing(0), landing(away), away, 1e-5);
    }

    private static PhysicsEngine landing(double away) {
        Body ground = Body.fixed(new Rectangle(40, 2)).at(0, -1);
        return engine(away, 0.3, ground, new Body(new Rectangle(1, 0.6)).at(0, 1.5, 0.3).moving(4, 0, 1));
    }

    /** A board that is put too far over the end of a post falls over it: it went through the post at 10⁶. */
    @ParameterizedTest
    @CsvSource({"1e5", "1e6", "3e6", "1e7"})
    void aBoardFallsOverAnEdge(double away) {
        compare(tipping(0), tipping(away), away, 1e-5);
    }

    private static PhysicsEngine tipping(double away) {
        Body post = Body.fixed(new Rectangle(1, 1)).at(0, -0.5);
        return engine(away, 0, post, new Body(new Rectangle(2, 0.5)).at(0.6, 0.25));
    }

    /** Three boxes on one another, one of which is pushed, stand. */
    @ParameterizedTest
    @CsvSource({"1e5", "1e6"})
    void aStackStands(double away) {
        PhysicsEngine stack = engine(
                away, 0, Body.fixed(new Rectangle(40, 2)).at(0, -1),
                new Body(new Rectangle(1, 1)).at(0, 0.5), new Body(new Rectangle(1, 1)).at(0, 1.5), new Body(new Rectangle(1, 1)).at(0, 2.5));
        for (int k = 0; k < 60; k++) {
            stack.bodies().get(1).addForce(14, 0);
            stack.step();
        }
        for (int k = 1; k <= 3; k++) {
            assertThat(stack.bodies().get(k).getX()).isCloseTo(away, within(1e-6));
            assertThat(stack.bodies().get(k).getY() - 2 * away).isCloseTo(k - 0.5, within(1e-7));
        }
    }
}
