// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Motors and stops tell where their coordinates are, whether they act or not. */
class SwitchedValueTest {
    @Test
    void aTurnIsCountedFromWhereItWasMade() {
        Body a = new Body(new Circle(1)).at(0, 0, 0.25);
        Body b = new Body(new Circle(1)).at(3, 0, 0.5);
        Limit stop = Limit.angle(a, b, -1, 1);
        Motor motor = Motor.turning(a, b, 2, 5);
        a.setAngle(1);
        b.setAngle(0.75);
        assertThat(stop.getValue()).isEqualTo(0.5); // (1 - 0.75) - (0.25 - 0.5)
        assertThat(motor.getValue()).isEqualTo(0.5);
    }

    @Test
    void aRopeTellsHowFarItIsFromTaut() {
        Body a = new Body(new Circle(1)).at(0, 0);
        Body b = new Body(new Circle(1)).at(3, 4);
        assertThat(Limit.rope(a, 0, 0, b, 0, 0, 7).getValue()).isEqualTo(-2);
    }

    @Test
    void anEndOfARailTellsItsTravel() {
        Body block = new Body(new Rectangle(1, 1)).at(0, 0);
        SliderJoint rail = new SliderJoint(block, null, 0, 0, 0.6, 0.8);
        Limit ends = Limit.travel(rail, -1, 5);
        block.setPosition(1.2, 1.6);
        assertThat(ends.getValue()).isEqualTo(rail.getTravel()).isCloseTo(2, within(1e-15));
    }

    /** Against what the value makes of a short step of free bodies. */
    @Test
    void theRateIsThatOfTheValue() {
        double h = 1e-6;
        Body a = new Body(new Rectangle(1, 1)).at(0.3, 0.1, 0.2);
        Body b = new Body(new Rectangle(2, 1)).at(4, -1, -0.7);
        SliderJoint rail = new SliderJoint(a, b, 0.5, 0.2, 3, 4);
        Wheel wheel = new Wheel(a, 0.3, 0.2, 0.4);
        Switched[] all = {
            Limit.angle(a, b, -1, 1), Motor.turning(a, b, 2, 5), Limit.rope(a, 0.2, 0.1, b, 0.3, -0.2, 7), Limit.travel(rail, -1, 5),
            new Limit(PulleyJoint.bodyPoints(a, 0.1, 0, 0, 5, b, 0, 0.2, 4, 6, 2, 20), -1, 1, 0), Motor.turning(b, null, 1, 1)
        };
        a.moving(1, 2, 3);
        b.moving(-2, 0.5, 1);
        double[] before = new double[all.length];
        for (int k = 0; k < all.length; k++) {
            before[k] = all[k].getValue();
        }
        double travel = rail.getTravel();
        double[] rates = Arrays.stream(all).mapToDouble(Switched::getRate).toArray();
        double sliding = rail.getTravelSpeed();
        double rolling = Motor.rolling(wheel, 1, 1).getRate();
        double slipping = Motor.gripping(wheel, 1).getRate();
        assertThat(rolling).isCloseTo(wheel.getRollingSpeed(), within(1e-15));
        assertThat(slipping).isCloseTo(wheel.getSlip(), within(1e-15));
        for (Body body : new Body[] {a, b}) {
            body.at(body.getX() + h * body.getVelocityX(), body.getY() + h * body.getVelocityY(), body.getAngle() + h * body.getAngularVelocity());
        }
        for (int k = 0; k < all.length; k++) {
            assertThat(rates[k]).as("%s", all[k]).isCloseTo((all[k].getValue() - before[k]) / h, within(2e-5)).isNotZero();
        }
        assertThat(sliding).isCloseTo((rail.getTravel() - travel) / h, within(2e-5));
    }

    /** An elastic rope and elastic stops of an angle throw back what reaches them. */
    @Test
    void ropesAndStopsOfAnglesMayBounce() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.1);
        Body ball = engine.add(new Body(new Circle(1)).moving(3, 0));
        engine.add(Limit.rope(ball, 0, 0, null, 0, 0, 1.5, 0.5));
        Body dial = engine.add(new Body(new Circle(1)).at(10, 0).moving(0, 0, 2));
        engine.add(Limit.angle(dial, null, -1, 1, 1));
        for (int k = 0; k < 10; k++) {
            engine.step(); // they get there after half a second
        }
        assertThat(ball.getVelocityX()).isCloseTo(-1.5, within(1e-12));
        assertThat(ball.getX()).isCloseTo(1.5 - 0.75, within(1e-12));
        assertThat(dial.getAngularVelocity()).isCloseTo(-2, within(1e-12));
        assertThat(dial.getAngle()).isCloseTo(0, within(1e-12));
    }

    /** To ask changes no bit of a run. */
    @Test
    void askingChangesNothing() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        engine.add(new Gravity(0, -9.81));
        Body rod = engine.add(new Body(new Rectangle(1, 0.1)).at(0.5, 0));
        engine.add(new PinJoint(rod, null, 0, 0));
        engine.add(Limit.angle(rod, null, -0.5, 0.5));
        PhysicsEngine other = Checkpoint.copy(engine);
        for (int k = 0; k < 100; k++) {
            engine.step();
            other.step();
            for (Constraint one : engine.allConstraints()) {
                if (one instanceof Limit stop) {
                    assertThat(stop.getValue()).isEqualTo(rod.getAngle());
                }
            }
        }
        Checkpoint.assertSameBodies(other, engine);
        assertThat(rod.getAngle()).isCloseTo(-0.5, within(1e-9));
    }
}
