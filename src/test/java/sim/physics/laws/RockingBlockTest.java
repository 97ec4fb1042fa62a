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

/** A block that rocks on its corners, after Housner 1963: nothing acts at the corner that comes down until it is down. */
class RockingBlockTest {
    private static final double G = 9.81;
    private static final double HEIGHT = 1;

    private final PhysicsEngine engine = new PhysicsEngine();

    private Body block(double width, double angle, double step) {
        engine.setTimeStep(step);
        engine.add(new Gravity(0, -G));
        Body ground = engine.add(Body.fixed(new Rectangle(20, 1)).at(0, -0.5));
        double y = width / 2 * StrictMath.sin(angle) + HEIGHT / 2 * StrictMath.cos(angle);
        Body block = engine.add(new Body(new Rectangle(width, HEIGHT)).at(0, y, angle));
        for (Body body : new Body[] {ground, block}) {
            body.setFriction(1);
            body.setRestitution(0);
        }
        return block;
    }

    /**
     * ω² = 3 g / 2 R · (cos(α − θ₀) − cos(α − θ)) until the other corner is down, for half a diagonal R at α from upright. The method halves forces
     * (Verlet's), and x″ = λ² x with λ² = 3 g / 4 R has λ² h² / 8 too much velocity at a place with it.
     */
    @ParameterizedTest
    @CsvSource({"0.2, 0.1, 0.001", "0.3, 0.15, 0.001", "0.5, 0.15, 0.001", "1, 0.1, 0.0002", "0.2, 0.15, 0.01"})
    void keepsItsEnergyUntilTheOtherCornerIsDown(double width, double angle, double step) {
        Body block = block(width, angle, step);
        double r = StrictMath.hypot(width, HEIGHT) / 2;
        double alpha = StrictMath.atan2(width, HEIGHT);
        double fastest = StrictMath.sqrt(1.5 * G / r * (StrictMath.cos(alpha - angle) - StrictMath.cos(alpha)));
        double error = 0.75 * G / r * step * step / 8 * fastest;
        double low = angle;
        while (block.getAngle() > -block.getAngularVelocity() * 2 * step || block.getAngularVelocity() == 0) {
            engine.step();
            double theta = block.getAngle();
            double square = 1.5 * G / r * (StrictMath.cos(alpha - angle) - StrictMath.cos(alpha - theta));
            assertThat(block.getAngularVelocity()).as("at %s rad", theta).isCloseTo(-StrictMath.sqrt(square), within(error));
            low = theta;
        }
        assertThat(low).as("angle before the other corner struck").isLessThan(0.05 * angle + 3 * step);
    }

    /** The impact leaves 1 − 3/2 sin² α of the angular velocity, and with it the next swing has its amplitude, to first order. */
    @ParameterizedTest
    @CsvSource({"0.2, 0.1, 0.002", "0.2, 0.1, 0.0005", "0.5, 0.1, 0.001", "0.5, 0.1, 0.0001"})
    void swingsToTheOtherSideWithWhatTheImpactLeaves(double width, double angle, double step) {
        Body block = block(width, angle, step);
        double alpha = StrictMath.atan2(width, HEIGHT);
        double left = 1 - 1.5 * StrictMath.sin(alpha) * StrictMath.sin(alpha);
        double cosine = StrictMath.cos(alpha) + left * left * (StrictMath.cos(alpha - angle) - StrictMath.cos(alpha));
        do {
            engine.step();
        } while (block.getAngle() > 0 || block.getAngularVelocity() < 0);
        assertThat(-block.getAngle()).isCloseTo(alpha - StrictMath.acos(cosine), within(2 * step));
    }
}
