// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.GearJoint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Bodies with motors and stops that lie on something: what a wheel gets from the ground and its motor depend on each other. */
class MotorContactTest {
    private static final double GRAVITY = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final List<Motor> motors = new ArrayList<>();
    private Body chassis;

    @BeforeEach
    void floor() {
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -GRAVITY));
        put(Body.fixed(new Rectangle(400, 2)).at(0, -1));
    }

    private Body put(Body body) {
        body.setFriction(0.9);
        body.setRestitution(0);
        return engine.add(body);
    }

    /** A car with a motor at each wheel: it drives to the right with a negative speed. */
    private void car(double torque) {
        chassis = put(new Body(new Rectangle(3, 0.5)).at(0, 0.8));
        for (int side = -1; side <= 1; side += 2) {
            Body wheel = put(new Body(new Circle(0.4)).at(side, 0.4));
            engine.add(new PinJoint(chassis, wheel, side, 0.4));
            drive(wheel, chassis, -8, torque);
        }
    }

    private void drive(Body wheel, Body by, double speed, double torque) {
        Motor motor = Motor.turning(wheel, by, speed, torque);
        engine.add(motor);
        motors.add(motor);
    }

    private void step(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    @Test
    void wheelsThatRollShareTheThrust() {
        car(0.3);
        step(60);
        double wheel = Math.PI * 0.16;
        double a = 2 * 0.3 / 0.4 / (1.5 + 2 * wheel + 2 * wheel / 2); // M a = 2 T / r − 2 (I / r²) a
        assertThat(chassis.getVelocityX()).isEqualTo(a, within(1e-7 * a));
    }

    @Test
    void theCarGetsTheSpeedOfItsMotorsAndDoesNotBounce() {
        car(6);
        step(120);
        assertThat(chassis.getVelocityX()).isEqualTo(3.2, within(1e-9));
        long before = engine.getImpacts();
        step(180);
        assertThat(engine.getImpacts()).isEqualTo(before);
        assertThat(chassis.getVelocityX()).isEqualTo(3.2, within(1e-9));
    }

    @Test
    void brakesHoldItWhereItStops() {
        car(6);
        step(120);
        motors.forEach(m -> m.setSpeed(0));
        step(120);
        double x = chassis.getX();
        step(120);
        assertThat(chassis.getVelocityX()).isEqualTo(0, within(1e-12));
        assertThat(chassis.getX()).isEqualTo(x, within(1e-9));
    }

    @Test
    void springsBearWhatLiesOnThem() {
        chassis = put(new Body(new Rectangle(3, 0.5)).at(0, 1.3));
        for (int side = -1; side <= 1; side += 2) {
            Body wheel = put(new Body(new Circle(0.4)).at(side, 0.4));
            Body hub = put(new Body(new Rectangle(0.2, 0.2)).at(side, 0.4));
            engine.add(new SliderJoint(chassis, hub, side, 0.4, 0, 1));
            engine.add(new PinJoint(hub, wheel, side, 0.4));
            engine.add(new Spring(chassis, side, 0, hub, 0, 0, 1, 400, 20));
            drive(wheel, hub, -8, 5);
        }
        step(480);
        long before = engine.getImpacts();
        step(60);
        double length = 1 - 1.5 * GRAVITY / 2 / 400;
        assertThat(chassis.getY()).isEqualTo(0.4 + length, within(1e-4 * 0.4)); // wheels hover by 1e-4 of their size at most
        assertThat(chassis.getVelocityX()).isEqualTo(3.2, within(1e-6));
        assertThat(engine.getImpacts()).isEqualTo(before);
    }

    /** Two legs of two links each, with motors at the hips and knees. */
    private List<Body> walker() {
        List<Body> links = new ArrayList<>();
        chassis = put(new Body(new Rectangle(1, 0.6)).at(0, 2.3));
        links.add(chassis);
        for (int side = -1; side <= 1; side += 2) {
            links.addAll(leg(chassis, side * 0.3));
        }
        return links;
    }

    /** Thigh and shin below a hip, held by brakes, with stops at the knee. */
    private List<Body> leg(Body hip, double x) {
        Body thigh = put(new Body(new Rectangle(0.2, 1)).at(x, 1.5));
        Body shin = put(new Body(new Rectangle(0.2, 1)).at(x, 0.5));
        engine.add(new PinJoint(hip, thigh, x, 2));
        engine.add(new PinJoint(thigh, shin, x, 1));
        drive(thigh, hip, 0, 40);
        drive(shin, thigh, 0, 30);
        engine.add(Limit.angle(shin, thigh, -1, 1));
        return List.of(thigh, shin);
    }

    /** A motor that gives less than it could has its speed; stops hold; and nothing lies in anything. */
    @Test
    void aWalkerObeysTheLawsOfItsMotorsAndStops() {
        List<Body> links = walker();
        for (int k = 0; k < 600; k++) {
            for (int m = 0; m < motors.size(); m++) {
                motors.get(m).setSpeed(1.5 * Math.sin(k * 0.05 + m * 1.7));
            }
            engine.step();
            for (Overlap overlap : engine.overlaps()) {
                assertThat(overlap.depth()).isLessThan(1e-6);
            }
            for (int side = 0; side < 2; side++) {
                double knee = links.get(2 + 2 * side).getAngle() - links.get(1 + 2 * side).getAngle();
                assertThat(Math.abs(knee)).isLessThan(1 + 5e-3); // one of 40 walkers goes beyond 1e-3, by 4e-3 at most
            }
        }
        assertThat(engine.getImpacts()).isLessThan(600);
    }

    @Test
    void motorsGiveTheirBoundOrHaveTheirSpeed() {
        walker();
        int full = 0;
        int partly = 0;
        for (int k = 0; k < 300; k++) {
            for (int m = 0; m < motors.size(); m++) {
                motors.get(m).setSpeed(1.5 * Math.sin(k * 0.05 + m * 1.7));
            }
            engine.step();
            for (Motor motor : motors) {
                double torque = Math.abs(engine.getReaction(motor).torque());
                assertThat(torque).isLessThanOrEqualTo(motor.getLimit() * (1 + 1e-12));
                double speed = motor.getBodyA().getAngularVelocity() - motor.getBodyB().getAngularVelocity();
                if (torque < 0.999 * motor.getLimit()) {
                    assertThat(speed).isEqualTo(motor.getSpeed(), within(1e-3));
                    partly++;
                } else {
                    full++;
                }
            }
        }
        assertThat(full).isGreaterThan(10);
        assertThat(partly).isGreaterThan(300);
    }

    /** With stops instead of motors it collapses, and lies still in the end, its stops kept. */
    @Test
    void whatHasStopsFallsAndLies() {
        List<Body> links = walker();
        motors.forEach(engine::remove);
        chassis.setAngularVelocity(0.3);
        step(900);
        long before = engine.getImpacts();
        step(60);
        assertThat(engine.getImpacts()).isEqualTo(before);
        for (Body link : links) {
            assertThat(Math.hypot(link.getVelocityX(), link.getVelocityY())).isLessThan(1e-9);
            assertThat(link.getAngularVelocity()).isEqualTo(0, within(1e-9));
        }
        for (int side = 0; side < 2; side++) {
            double knee = links.get(2 + 2 * side).getAngle() - links.get(1 + 2 * side).getAngle();
            assertThat(Math.abs(knee)).isLessThan(1 + 1e-6);
        }
    }

    /** Motors at their speeds, some of which cannot hold it: each gives its bound and lags, or less and keeps it. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8})
    void motorsThatYieldLetOthersHold(int seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Body before = put(Body.fixed(new Rectangle(0.1, 0.1)).at(0, 10));
        for (int k = 0; k < 4; k++) {
            Body link = put(new Body(new Rectangle(1, 0.1)).at(0.55 + k, 10));
            engine.add(new PinJoint(before, link, 0.05 + k, 10));
            drive(link, before, 0, random.nextDouble(0.05, 1));
            before = link;
        }
        engine.setTimeStep(1e-5);
        engine.step();
        int yields = 0;
        for (Motor motor : motors) {
            double torque = engine.getReaction(motor).torque();
            double turned = motor.getBodyA().getAngularVelocity()
                    - (motor.getBodyB() == null || motor.getBodyB().isFixed() ? 0 : motor.getBodyB().getAngularVelocity());
            boolean full = Math.abs(torque) > motor.getLimit() * (1 - 1e-6);
            yields += full ? 1 : 0;
            if (full) {
                assertThat(turned * torque).isLessThanOrEqualTo(1e-12); // it is turned against its torque
            } else {
                assertThat(turned).isEqualTo(0, within(1e-12));
            }
        }
        assertThat(yields).isGreaterThan(0);
    }

    /** Two arms, each an island with a motor of its own, press a box between them: it is pressed, and lies still. */
    @Test
    void fingersPressWithTheirOwnTorques() {
        engine.bodies().forEach(body -> body.setFriction(0.6));
        Body base = put(Body.fixed(new Rectangle(0.5, 0.5)).at(0, 4));
        Body box = put(new Body(new Rectangle(0.8, 0.8)).at(0, 0.4));
        for (int side = -1; side <= 1; side += 2) {
            Body finger = put(new Body(new Rectangle(0.2, 3)).at(side * 0.8, 2.2));
            engine.add(new PinJoint(base, finger, side * 0.8, 3.7));
            drive(finger, base, side * -0.3, 40);
        }
        step(90);
        long before = engine.getImpacts();
        double x = box.getX();
        for (int k = 0; k < 90; k++) {
            step(1);
            for (int side = 0; side < 2; side++) {
                double torque = engine.getReaction(motors.get(side)).torque();
                assertThat(torque).isEqualTo(side == 0 ? 40 : -40, within(1e-6));
            }
        }
        assertThat(engine.getImpacts()).isEqualTo(before);
        assertThat(box.getX()).isEqualTo(x, within(1e-3));
    }

    /** Two strong motors ask one wheel for different speeds: the stronger one gets its own, the other gives its bound. */
    @Test
    void theStrongerOfTwoMotorsHasItsSpeed() {
        engine.bodies().forEach(body -> body.setFriction(0));
        car(1e-3);
        Body wheel = engine.bodies().get(2);
        step(2);
        drive(wheel, chassis, -4, 1e5);
        drive(wheel, chassis, -3, 5e4);
        step(5);
        assertThat(wheel.getAngularVelocity() - chassis.getAngularVelocity()).isEqualTo(-4, within(1e-9));
        assertThat(engine.getReaction(motors.get(3)).torque()).isEqualTo(5e4, within(1e-4));
        assertThat(engine.contacts(wheel)).isNotEmpty();
    }

    @Test
    void aBrakeYieldsFromRest() {
        Body arm = put(new Body(new Rectangle(2, 0.1)).at(1, 5));
        engine.add(new PinJoint(arm, null, 0, 5));
        drive(arm, null, 0, 0.1);
        step(1);
        double inertia = 0.2 * (4 + 0.01) / 12 + 0.2;
        assertThat(arm.getAngularVelocity()).isEqualTo(-(0.2 * GRAVITY - 0.1) / inertia / 60, within(1e-3));
        step(600);
        assertThat(arm.getAngularVelocity()).isFinite();
    }

    /** A leg that stands, held by brakes: what an impact leaves of their speeds is rounding, and no speed that they have to brake. */
    @Test
    void brakesHoldWhatLandsAtRest() {
        Body hip = put(new Body(new Rectangle(1, 0.6)).at(0, 2.3));
        leg(hip, 0);
        step(60);
        assertThat(hip.getY()).isEqualTo(2.3, within(1e-4));
        assertThat(engine.getImpacts()).isLessThan(60);
    }

    /** What two wheels on one axle have between them no impulse can part. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void wheelsOnOneAxleDoNotPart(double restitution) {
        Body rod = put(new Body(new Rectangle(1, 0.1)).at(0, 2));
        rod.setRestitution(restitution);
        for (int k = 0; k < 2; k++) {
            Body wheel = put(new Body(new Circle(0.3)).at(0.5, 2));
            wheel.setRestitution(restitution);
            wheel.setAngularVelocity(k);
            engine.add(new PinJoint(rod, wheel, 0.5, 2));
        }
        step(120);
        assertThat(rod.getY()).isBetween(0.0, 2.0);
    }

    @Test
    void aStopHoldsWhatWasPutBeyondIt() {
        Body arm = put(new Body(new Rectangle(2, 0.1)).at(0, 5));
        engine.add(new PinJoint(arm, null, 0, 5));
        engine.add(Limit.angle(arm, null, -0.5, 0.5));
        step(5);
        arm.setAngle(0.7);
        arm.setAngularVelocity(1);
        step(60);
        assertThat(arm.getAngle()).isEqualTo(0.7, within(1e-9));
        arm.setAngularVelocity(-1);
        step(120);
        assertThat(arm.getAngle()).isEqualTo(-0.5, within(1e-9));
    }

    /** A spring between bodies that joints tie together leaves all others the bits that they have without it. */
    @Test
    void aSpringWithinAnIslandMovesNobodyElse() {
        double[] places = new double[2];
        for (int k = 0; k < 2; k++) {
            PhysicsEngine one = new PhysicsEngine();
            one.setTimeStep(1 / 60.0);
            one.add(new Gravity(0, -GRAVITY));
            Body[] pair = new Body[2];
            for (int m = 0; m < 2; m++) {
                Body upper = one.add(new Body(new Rectangle(1, 0.1)).at(0.5 + 5 * m, 0));
                pair[m] = one.add(new Body(new Rectangle(1, 0.1)).at(1.5 + 5 * m, 0));
                one.add(new PinJoint(upper, null, 5 * m, 0));
                one.add(new PinJoint(upper, pair[m], 1 + 5 * m, 0));
                if (m == 0 && k == 1) {
                    one.add(new Spring(upper, 0, 0, pair[m], 0, 0, 0.5, 20, 0.1));
                }
            }
            for (int n = 0; n < 120; n++) {
                one.step();
            }
            places[k] = pair[1].getX();
        }
        assertThat(places[1]).isEqualTo(places[0]);
    }

    /** An arm on a post on a base, with stops and no friction in its pin, that falls against the lower one. */
    private Body arm(Body base, double restitution) {
        Body post = put(new Body(new Rectangle(0.1, 2)).at(0, 2));
        Body arm = put(new Body(new Rectangle(0.5, 0.1)).at(0.35, 3));
        engine.add(new WeldJoint(base, post, 0, 1));
        engine.add(new PinJoint(post, arm, 0, 3));
        engine.add(new Limit(new GearJoint(arm, post, -1), -1, 2, restitution));
        return arm;
    }

    private double heightOfItsFirstBounce(Body base, double restitution) {
        Body arm = arm(base, restitution);
        double last = 0;
        while (arm.getAngularVelocity() <= 0) {
            engine.step();
        }
        while (arm.getAngularVelocity() > 0) {
            last = arm.getAngle();
            engine.step();
        }
        return last;
    }

    /** Stops have their restitution also where the heap strikes them, within what a body falls in a step. */
    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.5, 0.8, 1})
    void elasticStopsBounceOnWhatLies(double restitution) {
        double exact = heightOfItsFirstBounce(put(Body.fixed(new Rectangle(6, 1)).at(0, 0.5)), restitution);
        engine.bodies().forEach(engine::remove);
        put(Body.fixed(new Rectangle(400, 2)).at(0, -1));
        assertThat(heightOfItsFirstBounce(put(new Body(new Rectangle(6, 1)).at(0, 0.5)), restitution))
                .isEqualTo(exact, within(0.1));
    }

    @Test
    void elasticStopsComeToRestOnWhatLies() {
        Body arm = arm(put(new Body(new Rectangle(6, 1)).at(0, 0.5)), 0.5);
        step(400);
        assertThat(arm.getAngle()).isEqualTo(-1, within(1e-9));
        assertThat(arm.getAngularVelocity()).isEqualTo(0, within(1e-9));
    }

    private Body lightArm(Body base, Body post) {
        Body arm = put(new Body(new Rectangle(0.3, 0.05)).at(0, 1.5));
        engine.add(new WeldJoint(base, post, 0, 0.5));
        engine.add(new PinJoint(post, arm, 0, 1.5));
        engine.add(Limit.angle(arm, post, -0.5, 0.5));
        return arm;
    }

    /** A motor that crosses the whole range within a step does not get past the stops. */
    @ParameterizedTest
    @ValueSource(doubles = {0.02, 0.1, 0.3})
    void stopsAreSeenBeforeMotorsPassThem(double timeStep) {
        engine.setTimeStep(timeStep);
        Body base = put(new Body(new Rectangle(3, 0.5)).at(0, 0.25));
        Body post = put(new Body(new Rectangle(0.2, 1)).at(0, 1));
        Body arm = lightArm(base, post);
        step(20);
        drive(arm, post, 5, 10);
        for (int k = 0; k < 60; k++) {
            step(1);
            assertThat(Math.abs(arm.getAngle() - post.getAngle())).isLessThan(0.5 + 1e-6);
            if (k % 20 == 19) {
                motors.get(0).setSpeed(-motors.get(0).getSpeed());
            }
        }
    }

    /** A strong motor that pushed a light arm against a stop leaves it when it turns back, and the stop lets go at once. */
    @Test
    void aServoTurnsBackFromItsStop() {
        Body base = put(new Body(new Rectangle(3, 0.5)).at(0, 0.25));
        Body post = put(new Body(new Rectangle(0.2, 1)).at(0, 1));
        Body arm = lightArm(base, post);
        drive(arm, post, 5, 100);
        for (int turn = 0; turn < 4; turn++) {
            step(10);
            double way = Math.signum(motors.get(0).getSpeed());
            if (turn > 0) {
                assertThat(arm.getAngularVelocity()).isEqualTo(5 * way, within(1e-3));
                assertThat(engine.getReaction(motors.get(0)).torque()).isEqualTo(0, within(1e-3));
            }
            step(20);
            assertThat(arm.getAngle() - post.getAngle()).isEqualTo(0.5 * way, within(1e-6));
            assertThat(engine.getReaction(motors.get(0)).torque()).isEqualTo(100 * way, within(1e-9));
            assertThat(base.getY()).isEqualTo(0.25, within(1e-5));
            motors.get(0).setSpeed(-motors.get(0).getSpeed());
        }
    }

    /** Engines that are written and read in the middle of a run, with motors and stops that push evenly, go on to the bit. */
    @Test
    void aCheckpointKeepsForcesOfMotorsInContact() {
        walker();
        PhysicsEngine copy = null;
        for (int k = 0; k < 240; k++) {
            aim(engine, k);
            engine.step();
            if (copy != null) {
                aim(copy, k);
                copy.step();
                for (int b = 0; b < engine.bodies().size(); b++) {
                    Body one = engine.bodies().get(b);
                    Body other = copy.bodies().get(b);
                    assertThat(other.getX()).isEqualTo(one.getX());
                    assertThat(other.getAngularVelocity()).isEqualTo(one.getAngularVelocity());
                }
            }
            if (k % 37 == 36) {
                copy = Checkpoint.copy(engine);
            }
        }
    }

    private static void aim(PhysicsEngine one, int step) {
        int m = 0;
        for (Constraint c : one.allConstraints()) {
            if (c instanceof Motor motor) {
                motor.setSpeed(1.5 * Math.cos(step * 0.05 + m++));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {20, 80})
    void aFlywheelLetsWhatBearsItLie(double spin) {
        chassis = put(new Body(new Rectangle(3, 0.5)).at(0, 0.25));
        Body wheel = put(new Body(new Rectangle(0.8, 0.05)).at(0, 1));
        wheel.setAngularVelocity(spin);
        engine.add(new PinJoint(chassis, wheel, 0, 1));
        step(120);
        assertThat(chassis.getY()).isEqualTo(0.25, within(1e-5));
        assertThat(engine.getImpacts()).isLessThan(50);
    }
}
