// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Boxes that lie on one another slide, and stop sliding within a step: from that instant on friction holds them, or acts the other way. */
class StackOnSlopeTest {
    private static final double G = 9.81;
    private static final double STEP = 1 / 60.0;

    private final PhysicsEngine engine = new PhysicsEngine();

    StackOnSlopeTest() {
        engine.setTimeStep(STEP);
        engine.add(new Gravity(0, -G));
    }

    private Body put(Body body, double friction) {
        body.setFriction(friction);
        body.setRestitution(0);
        return engine.add(body);
    }

    /** A slope steeper than friction holds: up it goes with a deceleration, and down again with another one. */
    @ParameterizedTest
    @CsvSource({"0.3, 0.99", "0.77, 0.99", "1, 0.99", "1.6, 0.99", "2.5, 0.99", "0.77, 0.5", "1.6, 0.5", "2, 0.5"})
    void aStackSlidesUpASteepSlopeAndDownAgain(double speed, double frictionOfTop) {
        double friction = 0.5;
        double sin = Math.sin(Math.PI / 4);
        double cos = Math.cos(Math.PI / 4);
        put(Body.fixed(new Rectangle(60, 2)).at(sin, -cos, Math.PI / 4), friction);
        Body low = put(new Body(new Rectangle(1, 0.5)).at(-0.25 * sin, 0.25 * cos, Math.PI / 4), friction);
        Body top = put(new Body(new Rectangle(0.6, 0.3)).at(-0.65 * sin, 0.65 * cos, Math.PI / 4), frictionOfTop);
        low.moving(speed * cos, speed * sin, 0);
        top.moving(speed * cos, speed * sin, 0);
        double upwards = speed / (G * (sin + friction * cos));
        for (int k = 1; k <= 90; k++) {
            engine.step();
            double down = Math.max(0, k * STEP - upwards);
            double up = k * STEP - down;
            double way = speed * up - 0.5 * G * (sin + friction * cos) * up * up - 0.5 * G * (sin - friction * cos) * down * down;
            assertThat(low.getX() * cos + low.getY() * sin).as("low, step " + k).isCloseTo(way, within(1e-7));
            assertThat(top.getX() * cos + top.getY() * sin).as("top, step " + k).isCloseTo(way, within(1e-7));
        }
    }

    /** The same on one that holds it: there it stays. */
    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.77, 1.6})
    void aStackSlidesUpAGentleSlopeAndStays(double speed) {
        double friction = 0.5;
        double sin = Math.sin(0.4);
        double cos = Math.cos(0.4);
        put(Body.fixed(new Rectangle(60, 2)).at(sin, -cos, 0.4), friction);
        Body low = put(new Body(new Rectangle(1, 0.5)).at(-0.25 * sin, 0.25 * cos, 0.4), friction).moving(speed * cos, speed * sin, 0);
        put(new Body(new Rectangle(0.6, 0.3)).at(-0.65 * sin, 0.65 * cos, 0.4), 0.9).moving(speed * cos, speed * sin, 0);
        for (int k = 0; k < 90; k++) {
            engine.step();
        }
        double way = 0.5 * speed * speed / (G * (sin + friction * cos));
        assertThat(low.getX() * cos + low.getY() * sin).isCloseTo(way, within(1e-7));
        assertThat(low.getVelocityX()).isZero();
    }

    /** A box that is thrown onto a plank which lies still: it slides until it stops there. */
    @Test
    void aBoxStopsOnAPlank() {
        put(Body.fixed(new Rectangle(60, 2)).at(0, -1), 0.1);
        Body plank = put(new Body(new Rectangle(6, 0.2)).at(0, 0.1), 0.4);
        Body box = put(new Body(new Rectangle(0.5, 0.5)).at(-2, 0.45), 0.9).moving(3, 0, 0);
        for (int k = 0; k < 60; k++) {
            engine.step();
        }
        assertThat(box.getX()).isCloseTo(-2 + 9 / (2 * 0.6 * G), within(1e-8)); // sqrt(0.4 · 0.9)
        assertThat(plank.getX()).isCloseTo(0, within(1e-12));
    }

    /** A disc on a plank on ice slides until it rolls; what it loses the plank gets. */
    @Test
    void aDiscComesToRollOnAPlankOnIce() {
        double mu = 0.5;
        double radius = 0.3;
        put(Body.fixed(new Rectangle(60, 2)).at(0, -1), 0);
        Body plank = put(new Body(new Rectangle(12, 0.2)).at(0, 0.1), mu);
        Body disc = put(new Body(new Circle(radius)).at(-2, 0.2 + radius), mu).moving(3, 0, 0);
        for (int k = 0; k < 60; k++) {
            engine.step();
        }
        double a = mu * G;
        double ofPlank = a * disc.getMass() / plank.getMass();
        double slides = 3 / (a + ofPlank + a * disc.getMass() * radius * radius / disc.getInertia());
        double rolls = 60 * STEP - slides;
        assertThat(disc.getX()).isCloseTo(-2 + 3 * slides - 0.5 * a * slides * slides + (3 - a * slides) * rolls, within(1e-8));
        assertThat(plank.getX()).isCloseTo(0.5 * ofPlank * slides * slides + ofPlank * slides * rolls, within(1e-8));
    }
}
