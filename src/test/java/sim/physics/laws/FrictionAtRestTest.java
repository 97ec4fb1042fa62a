// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Coulomb's law on fixed ground: bodies stick, slide, stop and roll as in closed form. */
class FrictionAtRestTest {
    private static final double G = 9.81;
    private static final double SLOPE = StrictMath.atan(0.5);

    private final PhysicsEngine engine = new PhysicsEngine();

    private Body put(Shape shape, double slope, double friction) {
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -G));
        Body ground = engine.add(Body.fixed(new Rectangle(400, 2)));
        ground.setAngle(-slope);
        ground.setFriction(friction);
        ground.setRestitution(0);
        double height = 1.5; // of the centre above that of the ground, along its normal
        Body body = engine.add(
                new Body(shape).at(height * StrictMath.sin(slope), height * StrictMath.cos(slope)));
        body.setAngle(-slope);
        body.setFriction(friction);
        body.setRestitution(0);
        return body;
    }

    /** Way down the slope. */
    private double way(Body body, double slope) {
        double x = body.getX() - 1.5 * StrictMath.sin(slope);
        double y = body.getY() - 1.5 * StrictMath.cos(slope);
        return x * StrictMath.cos(slope) - y * StrictMath.sin(slope);
    }

    private void run(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    @ParameterizedTest
    @CsvSource({"0.6", "0.500001"})
    void aBoxStaysOnASlopeThatFrictionHolds(double friction) {
        Body box = put(new Rectangle(1, 1), SLOPE, friction);
        run(120);
        assertThat(way(box, SLOPE)).isCloseTo(0, within(1e-7));
        double x = box.getX();
        run(600);
        assertThat(box.getX()).isEqualTo(x);
        assertThat(box.kineticEnergy()).isZero();
    }

    @Test
    void aBoxThatSticksAtOnceStaysToo() {
        aBoxStaysOnASlopeThatFrictionHolds(1);
    }

    @ParameterizedTest
    @CsvSource({"0", "0.1", "0.3", "0.49"})
    void aBoxSlidesDownASlopeThatFrictionDoesNotHold(double friction) {
        Body box = put(new Rectangle(1, 0.2), SLOPE, friction);
        box.setPosition(1.1 * StrictMath.sin(SLOPE), 1.1 * StrictMath.cos(SLOPE));
        double start = way(box, SLOPE);
        run(120);
        double a = G * (StrictMath.sin(SLOPE) - friction * StrictMath.cos(SLOPE));
        assertThat(way(box, SLOPE) - start).isCloseTo(2 * a, within(2e-6));
    }

    @ParameterizedTest
    @CsvSource({"0.6", "0.17", "1"})
    void aDiscRollsDownASlope(double friction) {
        Body disc = put(new Circle(0.5), SLOPE, friction);
        run(120);
        double a = 2.0 / 3 * G * StrictMath.sin(SLOPE);
        assertThat(way(disc, SLOPE)).isCloseTo(2 * a, within(1e-11));
        assertThat(disc.getAngle() + SLOPE).isCloseTo(-2 * a / 0.5, within(1e-11));
    }

    @Test
    void aDiscSlipsWhereFrictionIsTooSmallForRolling() {
        Body disc = put(new Circle(0.5), SLOPE, 0.1);
        run(120);
        double a = G * (StrictMath.sin(SLOPE) - 0.1 * StrictMath.cos(SLOPE));
        assertThat(way(disc, SLOPE)).isCloseTo(2 * a, within(1e-11));
        double alpha = 2 * 0.1 * G * StrictMath.cos(SLOPE) / 0.5;
        assertThat(disc.getAngularVelocity()).isCloseTo(-2 * alpha, within(1e-11));
    }

    @Test
    void aDiscThatSlidesEndsRollingAtTwoThirdsOfItsSpeed() {
        Body disc = put(new Circle(0.5), 0, 0.5);
        disc.setVelocity(3, 0);
        run(180);
        double t = 3 / (3 * 0.5 * G);
        assertThat(disc.getVelocityX()).isCloseTo(2, within(1e-11));
        assertThat(disc.getAngularVelocity()).isCloseTo(-4, within(1e-11));
        assertThat(disc.getX()).isCloseTo(3 * t - 0.5 * 0.5 * G * t * t + 2 * (3 - t), within(1e-11));
    }

    /** However long the step is and the way in it: nothing changes while the disc slides, and at the end of the edge all does. */
    @ParameterizedTest
    @CsvSource({"0.01, 0", "0.1, 0", "0.1, 30", "0.7, 0", "0.7, 30"})
    void aDiscThatSlidesOverAnEdgeFallsFromThere(double step, double spin) {
        Body disc = put(new Circle(0.5), 0, 0);
        engine.setTimeStep(step);
        disc.setPosition(195, 1.5);
        disc.setVelocity(3, 0);
        disc.setAngularVelocity(spin);
        double atEdge = 5 / 3.0; // where v²/r > g, so that it does not roll over the corner
        double time = 0;
        while (time < 4) {
            engine.step();
            time = engine.getTime();
            double fallen = Math.max(0, time - atEdge);
            assertThat(disc.getX()).isCloseTo(195 + 3 * time, within(1e-9));
            assertThat(disc.getY()).isCloseTo(1.5 - 0.5 * G * fallen * fallen, within(5e-6));
        }
    }

    @Test
    void aBoxThatSlidesStopsWhereTheClosedFormSays() {
        Body box = put(new Rectangle(2, 1), 0, 0.5);
        box.setVelocity(5, 0);
        run(180);
        assertThat(box.getX()).isCloseTo(25 / (2 * 0.5 * G), within(1e-7));
        assertThat(box.kineticEnergy()).isZero();
    }
}
