// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;

/** A ball that is a hundred times as heavy as a knot falls into a net of rods between two hooks: its steps cost too much by events. */
class BallInNetTest {
    private static final double PITCH = 0.3;

    private final PhysicsEngine engine = new PhysicsEngine();
    private Body ball;

    private void build(int columns, int rows, double nearer, double mass) {
        engine.setTimeStep(1 / 60.0);
        engine.setWorkLimit(200_000);
        engine.add(new Gravity(0, -9.81));
        Body[][] knots = new Body[columns][rows];
        for (int i = 0; i < columns; i++) {
            for (int j = 0; j < rows; j++) {
                knots[i][j] = body(0.1, PITCH * (1 - nearer) * i, -PITCH * j, 0.05);
            }
        }
        engine.add(new PinJoint(knots[0][0], knots[0][0].getX(), 0));
        engine.add(new PinJoint(knots[columns - 1][0], knots[columns - 1][0].getX(), 0));
        for (int i = 0; i < columns; i++) {
            for (int j = 0; j < rows; j++) {
                if (i + 1 < columns) {
                    tie(knots[i][j], knots[i + 1][j]);
                }
                if (j + 1 < rows) {
                    tie(knots[i][j], knots[i][j + 1]);
                }
            }
        }
        ball = body(0.3, 0.5 * PITCH * (columns - 1) + 0.07, 3, mass);
    }

    private Body body(double radius, double x, double y, double mass) {
        Body body = engine.add(new Body(new Circle(radius)).at(x, y));
        body.setMass(mass);
        body.setRestitution(0);
        body.setFriction(0.3);
        return body;
    }

    private void tie(Body a, Body b) {
        engine.add(new RodJoint(a, a.getX(), a.getY(), b, b.getX(), b.getY()));
    }

    private double energy() {
        double sum = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            sum += 9.81 * body.getMass() * body.getY();
        }
        return sum;
    }

    /** Joints that stand open under the load are not closed into the ball, step by step, until it is through. */
    @ParameterizedTest
    @CsvSource({"6, 1, 0, 5", "6, 1, 0.03, 5", "4, 2, 0, 5", "6, 2, 0.03, 5"})
    void theNetHoldsTheBall(int columns, int rows, double nearer, double mass) {
        build(columns, rows, nearer, mass);
        for (int k = 0; k < 300; k++) {
            double before = energy();
            engine.step();
            assertThat(energy() - before).as("energy gained in step %d", k).isLessThan(0.05); // of 150
            double deepest = engine.overlaps().stream().mapToDouble(Overlap::depth).max().orElse(0);
            assertThat(deepest).as("depth after step %d", k).isLessThan(0.01);
        }
        assertThat(ball.getY()).isGreaterThan(0);
    }

    /** What is tied as a taut net moves on as it must, by impulses that take energy: events end while the net is straight to 10⁻⁷. */
    @Test
    void whatABlowLeavesOnATautNetGivesNoEnergy() {
        build(6, 6, 0, 5);
        engine.setWorkLimit(10_000_000);
        double most = 0;
        for (int k = 0; k < 60; k++) {
            double before = energy();
            engine.step();
            most = Math.max(most, energy() - before);
        }
        assertThat(most).isLessThan(0.1);
    }
}
