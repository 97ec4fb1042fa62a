// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.DoubleStream;
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

    /**
     * An arm on a pin has the speed that its motor is told within the step, or what the motor can do meanwhile: I ω̇ = ±T − m g l cos θ about the pin.
     * Turned about its centre, and then held by its pin, it took six steps of one substep.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 4, 16})
    void anArmHasTheSpeedOfItsMotorWithinTheStep(int substeps) {
        double inertia = 2 * (1 + 0.01) / 12 + 2 * 0.25;
        for (double ratio : new double[] {5, 50, 1000}) {
            PhysicsEngine engine = heavy(substeps);
            Body arm = arm(engine, 0.5);
            engine.add(new PinJoint(arm, 0, 0));
            Motor motor = engine.add(Motor.turning(arm, null, SPEED, ratio * LOAD));
            Stepped.run(engine, 60);
            assertThat(arm.getAngularVelocity()).isCloseTo(SPEED, within(1e-9));
            double most = (ratio * LOAD + LOAD * Math.cos(arm.getAngle() + 0.5 * SPEED / 60)) / inertia / 60;
            motor.setSpeed(-SPEED);
            engine.step();
            assertThat(arm.getAngularVelocity()).isCloseTo(Math.max(-SPEED, SPEED - most), within(1e-2));
            Stepped.run(engine, 10);
            motor.setSpeed(0);
            engine.step();
            assertThat(arm.getAngularVelocity()).isCloseTo(ratio == 5 ? arm.getAngularVelocity() : 0, within(1e-6));
        }
    }

    /** A walker whose four legs, of two links each, are told other speeds every few steps, against their stops, too; all x, y and θ. */
    private static double[] walk(double step, int substeps) {
        PhysicsEngine engine = Stepped.engine(step, substeps);
        engine.add(new Gravity(0, -Stepped.G));
        Stepped.ground(engine);
        Motor[] motors = new Motor[8];
        Body torso = engine.add(new Body(new Rectangle(2, 0.4)).at(0, 1.4));
        for (int k = 0; k < 4; k++) {
            double x = 0.6 * k - 0.9;
            Body thigh = engine.add(new Body(new Rectangle(0.15, 0.6)).at(x, 1));
            Body shin = engine.add(new Body(new Rectangle(0.12, 0.6)).at(x, 0.45));
            engine.add(new PinJoint(thigh, torso, x, 1.3));
            engine.add(new PinJoint(shin, thigh, x, 0.72));
            motors[2 * k] = engine.add(Motor.turning(thigh, torso, 0, 30));
            motors[2 * k + 1] = engine.add(Motor.turning(shin, thigh, 0, 20));
            engine.add(Limit.angle(thigh, torso, -0.8, 0.8));
            engine.add(Limit.angle(shin, thigh, -1, 0.5));
        }
        engine.bodies().stream().filter(body -> !body.isFixed()).forEach(body -> Stepped.rough(body).setCollisionGroup(1, 0));
        for (int k = 0; k < Math.round(1 / step); k++) {
            for (int m = 0; m < 8; m++) {
                motors[m].setSpeed(3 * Math.cos(0.4 * Math.floor(15 * k * step + 1e-9) + m));
            }
            engine.step();
        }
        return engine.bodies().stream().filter(body -> !body.isFixed()).flatMapToDouble(body -> DoubleStream.of(body.getX(), body.getY(), body.getAngle())).toArray();
    }

    /** Its legs did so little of what they were told that a place was off by 0.3 after a second. */
    @Test
    void aWalkerGoesWhereItGoesByEvents() {
        assertThat(walk(1.0 / 60, 4)).containsExactly(walk(1.0 / 480, 0), within(0.05));
    }
}
