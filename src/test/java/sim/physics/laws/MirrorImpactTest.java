// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;

/**
 * A ball rolls into the middle of ten pins: what is its own mirror image stays so. The pins that it strikes at once are struck a few units in the
 * last place of a time one after the other, as friction has turned the ball by rounding.
 */
class MirrorImpactTest {
    private static final double SPACING = 0.305;

    @ParameterizedTest
    @CsvSource({"false, 0.65", "false, 1", "true, 0.65", "true, 1"})
    void pinsFallInPairs(boolean isRubbed, double restitution) {
        for (double at : new double[] {0, 3, 18.29, 100, 1000}) {
            for (int rate : new int[] {100, 240, 600}) {
                assertThat(asymmetry(isRubbed, restitution, at, 1.0 / rate)).as("at %s, steps of 1/%d", at, rate).isLessThan(1e-12);
            }
        }
    }

    /** By how much places after a second are no mirror image of one another. */
    private static double asymmetry(boolean isRubbed, double restitution, double at, double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        if (isRubbed) {
            engine.add(new SurfaceFriction(9.81));
        }
        Body[][] pins = new Body[4][];
        for (int row = 0; row < 4; row++) {
            pins[row] = new Body[row + 1];
            for (int k = 0; k <= row; k++) {
                pins[row][k] = add(engine, new Body(new Circle(0.0605)).at(at + 0.264 * row, SPACING * (k - 0.5 * row)), 1.5, restitution, 0.3);
            }
        }
        add(engine, new Body(new Circle(0.108)).at(at - 3, 0).moving(8, 0), 7, restitution, 0.04);
        for (int k = 0; k * step < 1; k++) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isGreaterThan(5);
        double most = 0;
        for (Body[] row : pins) {
            for (int k = 0; k < row.length; k++) {
                Body other = row[row.length - 1 - k];
                most = Math.max(most, Math.hypot(row[k].getX() - other.getX(), row[k].getY() + other.getY()));
            }
        }
        return most;
    }

    /** Two balls of five go on in a cradle, though they meet the others at one instant but for rounding: only their impacts are apart. */
    @Test
    void twoBallsGoOnInACradle() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 240);
        engine.add(new Gravity(0, -9.81));
        Body[] balls = new Body[5];
        for (int k = 0; k < 5; k++) {
            double angle = k < 2 ? -0.4 : 0;
            balls[k] = engine.add(new Body(new Circle(0.1)).at(0.2 * k + Math.sin(angle), -Math.cos(angle)));
            balls[k].setMass(1);
            engine.add(new PinJoint(balls[k], 0.2 * k, 0));
        }
        int swings = 0;
        boolean isOut = false;
        for (int k = 0; k < 9751; k++) { // twenty periods
            engine.step();
            boolean isNowOut = balls[4].getX() - 0.8 > 0.05;
            swings += isNowOut && !isOut ? 1 : 0;
            isOut = isNowOut;
        }
        assertThat(swings).isEqualTo(20);
    }

    private static Body add(PhysicsEngine engine, Body body, double mass, double restitution, double onPlane) {
        body.setMass(mass);
        body.setRestitution(restitution);
        body.setFriction(0.1);
        body.setSurfaceFriction(onPlane);
        return engine.add(body);
    }
}
