// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.Reaction;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Motors along directions that turn: in a step, the coordinate goes the way of their speed. */
class SteppedMotorTest {
    private static final double STEP = 1.0 / 60;

    /** A body goes round the origin at 1 rad/s, on a rope of 6 that a motor winds up, or holds. */
    private static Motor whirl(PhysicsEngine engine, double speed, double limit) {
        Body body = engine.add(new Body(new Circle(0.2)).at(6, 0).moving(speed, 6));
        body.setMass(100);
        return engine.add(new Motor(RodJoint.bodyPoints(body, 0, 0, null, 0, 0, 6), speed, limit));
    }

    private static double length(Body body) {
        return Math.hypot(body.getX(), body.getY());
    }

    private static double spin(Body body) {
        return body.getX() * body.getVelocityY() - body.getY() * body.getVelocityX();
    }

    /** Its length after 5 s, less what it is to be. */
    private static double off(double speed, int substeps) {
        PhysicsEngine engine = Stepped.engine(STEP, substeps);
        Body body = whirl(engine, speed, 1e6).getBodyA();
        Stepped.run(engine, 300);
        assertThat(spin(body)).as("no motor turns it about the origin").isCloseTo(36, within(1e-2));
        return length(body) - (6 + 5 * speed);
    }

    @Test
    void aBrakeHoldsWhatGoesRound() {
        assertThat(off(0, 1)).isCloseTo(0, within(1e-4));
        assertThat(off(0, 4)).isCloseTo(0, within(1e-5));
    }

    @Test
    void aWinchGoesItsWay() {
        double coarse = off(-0.5, 1);
        assertThat(coarse).isCloseTo(0, within(4e-3));
        assertThat(off(-0.5, 4)).isCloseTo(0, within(Math.abs(coarse) / 12));
    }

    @Test
    void aBrakedSlideStaysOnATurntable() {
        for (int substeps : new int[] {1, 4}) {
            PhysicsEngine engine = Stepped.engine(STEP, substeps);
            Body table = engine.add(new Body(new Rectangle(4, 0.2)).moving(0, 0, 2));
            table.setMass(100, 1000);
            engine.add(new PinJoint(table, 0, 0));
            Body slide = engine.add(new Body(new Circle(0.2)).at(1, 0).moving(0, 2));
            SliderJoint rail = engine.add(new SliderJoint(slide, table, 1, 0, 1, 0));
            engine.add(Motor.sliding(rail, 0, 1e6));
            Stepped.run(engine, 600);
            assertThat(rail.getTravel()).isCloseTo(0, within(1e-4));
        }
    }

    /** A brake that is too weak gives its limit, neither more nor less: 100 r̈ = 100 L² / r³ − 200. */
    @Test
    void aBrakeThatYieldsGivesItsLimit() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Motor motor = whirl(engine, 0, 200);
        Body body = motor.getBodyA();
        double r = 6;
        double speed = 0;
        for (int k = 0; k < 60; k++) {
            engine.step();
            Reaction reaction = engine.getReaction(motor);
            assertThat(Math.hypot(reaction.forceX(), reaction.forceY())).isCloseTo(200, within(0.01));
            for (int m = 0; m < 100; m++) { // by the midpoint rule
                double middle = r + 0.5 * STEP / 100 * speed;
                speed += STEP / 100 * (36 * 36 / (middle * middle * middle) - 2);
                r = middle + 0.5 * STEP / 100 * speed;
            }
        }
        assertThat(length(body)).isCloseTo(r, within(1e-3));
    }
}
