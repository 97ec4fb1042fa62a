// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** Motors many times as strong as what they drive is heavy, and the stops in their way. */
class SteppedDriveTest {
    private static final double BOUND = 0.5;
    private static final double SPEED = 2;

    /** What drives an arm of mass 2 and length 1 has to bear at most, and a slide of mass 2. */
    private static final double LOAD = 2 * Stepped.G * 0.5;

    private static final double WEIGHT = 2 * Stepped.G;

    private static Body arm(PhysicsEngine engine, double x) {
        Body arm = engine.add(new Body(new Rectangle(1, 0.1)).at(x, 0));
        arm.setMass(2);
        return arm;
    }

    private static PhysicsEngine heavy(int substeps) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
        engine.setSleepAllowed(false);
        engine.add(new Gravity(0, -Stepped.G));
        return engine;
    }

    /** A motor and the stops in its way, of which one is added first. */
    private static void drive(PhysicsEngine engine, Motor motor, Limit stop, boolean isStopFirst) {
        if (isStopFirst) {
            engine.add(stop);
        }
        engine.add(motor);
        if (!isStopFirst) {
            engine.add(stop);
        }
    }

    private static double torque(PhysicsEngine engine, Constraint constraint) {
        return engine.getReaction(constraint).torque();
    }

    /**
     * An arm is turned against one of its stops by a motor of up to 1,000 times the torque that it needs. Such a stop was passed by 0.3 rad with 50
     * times that torque. How far it gives way is up to the arm's weight.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 4, 16})
    void aStopHoldsWhateverAMotorPresses(int substeps) {
        double most = substeps == 1 ? 6e-3 : substeps == 4 ? 4e-4 : 3e-5;
        for (int side : new int[] {1, -1}) {
            double first = Double.NaN;
            for (double ratio : new double[] {10, 50, 1000}) {
                PhysicsEngine engine = heavy(substeps);
                Body arm = arm(engine, 0.5);
                engine.add(new PinJoint(arm, 0, 0));
                Motor motor = Motor.turning(arm, null, side * SPEED, ratio * LOAD);
                Limit stop = Limit.angle(arm, null, -BOUND, BOUND);
                drive(engine, motor, stop, ratio == 50);
                Stepped.run(engine, 120);
                assertThat(arm.getAngle()).isCloseTo(side * BOUND, within(most));
                assertThat(arm.getAngle()).isCloseTo(Double.isNaN(first) ? arm.getAngle() : first, within(1e-6 * BOUND));
                first = arm.getAngle();
                double weight = LOAD * Math.cos(arm.getAngle());
                assertThat(torque(engine, motor)).isCloseTo(side * ratio * LOAD, within(1e-9 * ratio * LOAD));
                assertThat(torque(engine, stop)).isCloseTo(weight - side * ratio * LOAD, within(1e-6 * ratio * LOAD));
                assertThat(Stepped.fastest(engine)).isLessThan(1e-6);
            }
        }
    }

    /** Nor is it passed on the way there by more than a tenth of what is gone in a substep, whichever of the two was added first. */
    @Test
    void aSlideGoesToItsStopAndNoFarther() {
        for (int substeps : new int[] {1, 4, 16}) {
            for (int side : new int[] {1, -1}) {
                double[] places = new double[2];
                for (int way = 0; way < 2; way++) {
                    PhysicsEngine engine = heavy(substeps);
                    Body slide = engine.add(new Body(new Rectangle(1, 0.5)));
                    slide.setMass(2);
                    SliderJoint rail = engine.add(new SliderJoint(slide, null, 0, 0, 1, 0));
                    Motor motor = Motor.sliding(rail, side * SPEED, 50 * WEIGHT);
                    drive(engine, motor, Limit.travel(rail, -BOUND, BOUND), way == 0);
                    double farthest = 0;
                    for (int k = 0; k < 60; k++) {
                        engine.step();
                        farthest = Math.max(farthest, side * slide.getX());
                    }
                    assertThat(farthest).isCloseTo(BOUND, within(0.1 * SPEED / 60 / substeps));
                    assertThat(side * slide.getX()).isCloseTo(BOUND, within(1e-9));
                    places[way] = slide.getX();
                }
                assertThat(places[0]).isEqualTo(places[1]);
            }
        }
    }

    /** Arms on arms, all at their stops, come to rest there; their motors were strong enough to turn them about by radians. */
    @ParameterizedTest
    @ValueSource(ints = {1, 4, 16})
    void armsOnArmsRestAtTheirStops(int substeps) {
        for (int side : new int[] {1, -1}) {
            PhysicsEngine engine = heavy(substeps);
            Body[] arms = new Body[3];
            for (int k = 0; k < 3; k++) {
                Body before = k == 0 ? null : arms[k - 1];
                arms[k] = arm(engine, k + 0.5);
                engine.add(k == 0 ? new PinJoint(arms[k], 0, 0) : new PinJoint(before, arms[k], k, 0));
                engine.add(Motor.turning(arms[k], before, side * SPEED, 50 * (3 - k) * (3 - k) * LOAD));
                engine.add(Limit.angle(arms[k], before, -BOUND, BOUND));
            }
            Stepped.run(engine, 300);
            double most = 0.15 / substeps / substeps; // as the weight of the three arms makes any stop give way
            for (int k = 0; k < 3; k++) {
                assertThat(arms[k].getAngle() - (k == 0 ? 0 : arms[k - 1].getAngle())).isCloseTo(side * BOUND, within(most));
            }
            assertThat(Stepped.fastest(engine)).isLessThan(1e-2);
        }
    }

    /** A coordinate seen from its other body, and one against a fixed body in place of the world: they are the same. */
    @Test
    void aStopHoldsAMotorThatIsSeenFromTheOtherBody() {
        PhysicsEngine engine = heavy(1);
        Body post = engine.add(Body.fixed(new Rectangle(0.1, 0.1)));
        Body arm = arm(engine, 0.5);
        engine.add(new PinJoint(arm, 0, 0));
        engine.add(Motor.turning(post, arm, -SPEED, 50 * LOAD));
        engine.add(Limit.angle(arm, null, -BOUND, BOUND));
        Stepped.run(engine, 120);
        assertThat(arm.getAngle()).isCloseTo(BOUND, within(6e-3));
    }

    /** A motor that has pressed against a stop turns round in the step in which it is told to. It went on to press for as many steps as it was strong. */
    @Test
    void aMotorLeavesItsStopAtOnce() {
        for (int substeps : new int[] {1, 4, 16}) {
            for (double ratio : new double[] {50, 1000}) {
                PhysicsEngine engine = heavy(substeps);
                Body slide = engine.add(new Body(new Rectangle(1, 0.5)));
                slide.setMass(2);
                SliderJoint rail = engine.add(new SliderJoint(slide, null, 0, 0, 1, 0));
                Motor motor = engine.add(Motor.sliding(rail, SPEED, ratio * WEIGHT));
                engine.add(Limit.travel(rail, -10, BOUND));
                Stepped.run(engine, 60);
                motor.setSpeed(-SPEED);
                engine.step();
                assertThat(slide.getVelocityX()).isCloseTo(-SPEED, within(1e-9));
                motor.setSpeed(SPEED);
                Stepped.run(engine, 60);
                assertThat(slide.getX()).isCloseTo(BOUND, within(1e-9));
            }
        }
    }
}
