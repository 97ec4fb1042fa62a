// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.Reaction;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.Wheel;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Rattle;
import sim.physics.motion.RungeKutta4;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Wheels of bodies that are seen from above, ideal ones and such that skid, by events and by time stepping. */
class WheelTest {
    private static final double MASS = 5;
    private static final double TRACK = 0.3;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final Body robot = engine.add(new Body(new Circle(0.2)).at(0, 0));

    private void begin(int substeps, double step) {
        engine.setTimeStep(step);
        engine.setTimeStepping(substeps);
        robot.setMass(MASS);
        robot.setRestitution(0);
    }

    private void run(double time) {
        int steps = (int) Math.round(time / engine.getTimeStep());
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    /** A wheel to the left of the robot's centre, or with −1 to the right. */
    private Wheel wheel(int side) {
        return new Wheel(robot, 0, 0.5 * side * TRACK);
    }

    private static double energy(Body body) {
        double square = body.getVelocityX() * body.getVelocityX() + body.getVelocityY() * body.getVelocityY();
        return 0.5 * (body.getMass() * square + body.getInertia() * body.getAngularVelocity() * body.getAngularVelocity());
    }

    private static double speed(Body body) {
        return Math.hypot(body.getVelocityX(), body.getVelocityY());
    }

    /** x′ = v cos θ, y′ = v sin θ, θ′ = (vR − vL) / d, with wheels that never slip and with such that could. */
    @ParameterizedTest
    @CsvSource({"0, 1e-9, true", "0, 1e-9, false", "4, 1e-5, true", "4, 1e-5, false"})
    void aRobotOnTwoWheelsIsAUnicycle(int substeps, double error, boolean isIdeal) {
        begin(substeps, 0.02);
        double left = 0.4;
        double right = 0.6;
        for (int side = -1; side <= 1; side += 2) {
            Wheel wheel = wheel(side);
            engine.add(isIdeal ? wheel : Motor.gripping(wheel, 20));
            engine.add(Motor.rolling(wheel, side > 0 ? left : right, 100));
        }
        double v = 0.5 * (left + right);
        double omega = (right - left) / TRACK;
        robot.setVelocity(v, 0);
        robot.setAngularVelocity(omega);
        run(3);
        assertThat(robot.getAngle()).isCloseTo(3 * omega, within(error));
        assertThat(robot.getX()).isCloseTo(v / omega * StrictMath.sin(3 * omega), within(error));
        assertThat(robot.getY()).isCloseTo(v / omega * (1 - StrictMath.cos(3 * omega)), within(error));
    }

    /** Four wheels are two more equations than a rigid car can obey, but for axles whose lines meet in one point. */
    @ParameterizedTest
    @CsvSource({"0, 1e-9", "4, 2e-5"})
    void aCarWithFourWheelsTurnsAboutThePointWhereItsAxlesMeet(int substeps, double error) {
        double radius = 5;
        double length = 1.6;
        double half = 0.4;
        begin(substeps, 0.02);
        engine.remove(robot);
        Body car = engine.add(new Body(new Rectangle(2, 1)).at(0.5 * length, 0));
        double v = 1.5;
        double omega = v / radius;
        for (int side = -1; side <= 1; side += 2) {
            Wheel rear = engine.add(new Wheel(car, -0.5 * length, side * half));
            engine.add(Motor.rolling(rear, v - omega * side * half, 100));
            engine.add(new Wheel(car, 0.5 * length, side * half, StrictMath.atan(length / (radius - side * half))));
        }
        car.setVelocity(v, 0.5 * length * omega);
        car.setAngularVelocity(omega);
        run(4);
        double sin = StrictMath.sin(4 * omega);
        double cos = StrictMath.cos(4 * omega);
        assertThat(car.getAngle()).isCloseTo(4 * omega, within(error));
        assertThat(car.getX()).isCloseTo(radius * sin + 0.5 * length * cos, within(error));
        assertThat(car.getY()).isCloseTo(radius * (1 - cos) + 0.5 * length * sin, within(error));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void wheelsThatContradictOneAnotherHoldTheBody(int substeps) {
        begin(substeps, 0.02);
        for (int k = 0; k < 6; k++) {
            engine.add(new Wheel(robot, 0.1 * StrictMath.cos(k), 0.1 * StrictMath.sin(k), 0.3 * k * k));
        }
        robot.setVelocity(1, 2);
        robot.setAngularVelocity(3);
        for (int k = 0; k < 50; k++) {
            robot.addForce(10, -7);
            engine.step();
        }
        assertThat(Math.hypot(robot.getX(), robot.getY()) + Math.abs(robot.getAngle())).isLessThan(1e-4);
        assertThat(energy(robot)).isLessThan(1e-20);
    }

    /** What is closed has places, and wheels have none: they may be pushed to any place sideways. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void jointsAreClosedAsIfThereWereNoWheels(int substeps) {
        begin(substeps, 0.02);
        engine.add(new Wheel(robot, 0, 0, 0));
        engine.add(new Wheel(robot, 0, 0, 1));      // it can only turn on the spot
        PinJoint pin = PinJoint.bodyPoints(robot, 0, 0, null, 0.3, 0.4);
        engine.assemble(pin);
        assertThat(robot.getX()).isCloseTo(0.3, within(1e-12));
        assertThat(robot.getY()).isCloseTo(0.4, within(1e-12));
        robot.setAngularVelocity(3);
        run(10);
        assertThat(robot.getAngle()).isCloseTo(30, within(1e-9));
        robot.setPosition(-1, 2);
        engine.step();
        assertThat(robot.getX()).isCloseTo(0.3, within(1e-12));
        assertThat(robot.getAngularVelocity()).isCloseTo(3, within(1e-12));
    }

    /**
     * The wheel and its brake say all that the pin says, and are asked first. So which rows are redundant changes as the body turns; that costs
     * Rattle some accuracy, with other motors, too.
     */
    @ParameterizedTest
    @CsvSource({"RK4, 1e-6", "Rattle, 1e-2"})
    void aBodyTurnsAboutAPinOnItsWheel(String method, double error) {
        begin(0, 0.02);
        engine.setIntegrator(method.equals("RK4") ? new RungeKutta4() : new Rattle(4));
        Wheel wheel = engine.add(new Wheel(robot, 0, 0.1, 0.3));
        engine.add(Motor.rolling(wheel, 0, 1));
        engine.add(PinJoint.bodyPoints(robot, 0, 0.1, null, 0, 0.1));
        double omega = 0;
        for (int k = 0; k < 1000; k++) {
            double torque = 0.3 * StrictMath.cos(0.02 * k);
            robot.addTorque(torque);
            engine.step();
            omega += 0.02 * torque / (robot.getInertia() + MASS * 0.01);
            assertThat(robot.getAngularVelocity()).isCloseTo(omega, within(error));
            assertThat(Math.hypot(robot.worldX(0, 0.1), robot.worldY(0, 0.1) - 0.1)).isLessThan(1e-14);
        }
    }

    /** A trailer of length L behind what goes straight on: tan(φ/2) falls as e^(−v t/L). */
    @ParameterizedTest
    @CsvSource({"0, 1e-9", "4, 1e-5"})
    void aTrailerFollowsItsHitch(int substeps, double error) {
        begin(substeps, 0.02);
        double v = 0.5;
        double length = 0.6;
        double angle = 1.2;
        for (int side = -1; side <= 1; side += 2) {
            engine.add(Motor.rolling(engine.add(wheel(side)), v, 100));
        }
        double sin = StrictMath.sin(angle);
        double cos = StrictMath.cos(angle);
        Body trailer = engine.add(new Body(new Rectangle(0.3, 0.2)).at(-length * cos, -length * sin));
        trailer.setAngle(angle);
        engine.add(PinJoint.bodyPoints(robot, 0, 0, trailer, length, 0));
        engine.add(new Wheel(trailer, 0, 0));
        robot.setVelocity(v, 0);
        trailer.setVelocity(v * cos * cos, v * cos * sin);
        trailer.setAngularVelocity(-v / length * sin);
        run(3);
        double expected = 2 * StrictMath.atan(StrictMath.tan(0.5 * angle) * StrictMath.exp(-3 * v / length));
        assertThat(trailer.getAngle()).isCloseTo(expected, within(error));
        assertThat(robot.getX()).isCloseTo(3 * v, within(error));
    }

    /** What slides against a force F stops after m v² / (2 F). */
    @ParameterizedTest
    @CsvSource({"0, 1e-12", "4, 1e-4"})
    void aWheelSkidsAsFarAsItsGripLetsIt(int substeps, double error) {
        begin(substeps, 0.02);
        double grip = 6.3;
        Wheel left = wheel(1);
        engine.add(Motor.gripping(left, grip));
        Motor right = engine.add(Motor.gripping(wheel(-1), grip));
        robot.setVelocity(0, 2);
        engine.step();
        assertThat(left.getSlip()).isCloseTo(2 - 2 * grip / MASS * 0.02, within(1e-12));
        assertThat(engine.getReaction(right).forceY()).isCloseTo(-grip, within(1e-12));
        run(1);
        assertThat(robot.getY()).isCloseTo(0.5 * MASS * 4 / (2 * grip), within(error));
        assertThat(left.getSlip()).isZero();
        for (int k = 0; k < 50; k++) {
            robot.addForce(0, 1.9 * grip); // less than both hold
            engine.step();
        }
        assertThat(robot.getY()).isCloseTo(0.5 * MASS * 4 / (2 * grip), within(error));
        for (int k = 0; k < 50; k++) {
            robot.addForce(0, 3 * grip);
            engine.step();
        }
        assertThat(robot.getVelocityY()).isCloseTo(grip / MASS, within(1e-9));
    }

    /** The wall's impulse goes through the wheels: what has one way to go comes back on it. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void anElasticRobotBouncesBackAlongItsDirection(int substeps) {
        begin(substeps, 0.01);
        robot.setRestitution(1);
        Body wall = engine.add(Body.fixed(new Rectangle(1, 20)).at(1.5, 0));
        wall.setRestitution(1);
        robot.setAngle(0.5);
        engine.add(wheel(1));
        engine.add(wheel(-1));
        double cos = StrictMath.cos(0.5);
        double sin = StrictMath.sin(0.5);
        robot.setVelocity(cos, sin);
        run(2);
        assertThat(robot.getVelocityX()).isCloseTo(-cos, within(1e-12));
        assertThat(robot.getVelocityY()).isCloseTo(-sin, within(1e-12));
        assertThat(robot.getAngularVelocity()).isCloseTo(0, within(1e-12));
        double way = 2 * 0.8 / cos - 2; // to where it touches and back, along its direction
        assertThat(robot.getX()).isCloseTo(way * cos, within(substeps == 0 ? 1e-12 : 5e-3));
    }

    /** Oblique to a box on a rail, with a force F along its direction: (m + M cos² φ) u′ = F. */
    @ParameterizedTest
    @CsvSource({"0, true, 1e-7", "0, false, 1e-7", "4, true, 2e-6", "4, false, 2e-6"})
    void aRobotPushesWhatIsInItsWay(int substeps, boolean isIdeal, double error) {
        begin(substeps, 0.02);
        robot.setAngle(0.3);
        for (int side = -1; side <= 1; side += 2) {
            Wheel wheel = wheel(side);
            engine.add(isIdeal ? wheel : Motor.gripping(wheel, 1000));
            engine.add(Motor.rolling(wheel, 50, 2));
        }
        Body box = engine.add(new Body(new Rectangle(0.4, 3)).at(0.4, 0));
        box.setMass(3);
        box.setRestitution(0);
        engine.add(new SliderJoint(box, null, 0.4, 0, 1, 0));
        run(2);
        double cos = StrictMath.cos(0.3);
        double u = 2 * 4 / (MASS + 3 * cos * cos);
        assertThat(speed(robot)).isCloseTo(u, within(error));
        assertThat(box.getVelocityX()).isCloseTo(u * cos, within(error));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void motorsDriveAndBrakeWithABoundedForce(int substeps) {
        begin(substeps, 0.02);
        Wheel wheel = engine.add(new Wheel(robot, 0, 0));
        Motor drive = engine.add(Motor.rolling(wheel, 3, 10));
        run(1);
        assertThat(wheel.getRollingSpeed()).isCloseTo(10 / MASS, within(1e-12));
        run(1);
        assertThat(wheel.getRollingSpeed()).isCloseTo(3, within(1e-12));
        drive.setSpeed(0);
        drive.setLimit(5);
        run(1);
        assertThat(wheel.getRollingSpeed()).isCloseTo(2, within(1e-12));
        engine.remove(drive);
        run(1);
        assertThat(wheel.getRollingSpeed()).isCloseTo(2, within(1e-12));
        assertThat(drive.getCoordinate()).isSameAs(wheel);
        assertThat(drive.getValue()).isZero();
    }

    /** Steered at once it loses what is across its new direction, as by an impact; its centre stands on the wheel. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aWheelCanBeSteeredAtAnyTime(int substeps) {
        begin(substeps, 0.02);
        Wheel wheel = engine.add(new Wheel(robot, 0, 0));
        robot.setVelocity(2, 0);
        run(0.1);
        double x = robot.getX();
        wheel.setSteering(0.4);
        run(0.5);
        double u = 2 * StrictMath.cos(0.4);
        assertThat(wheel.getSteering()).isEqualTo(0.4);
        assertThat(wheel.getRollingSpeed()).isCloseTo(u, within(1e-12));
        assertThat(robot.getX()).isCloseTo(x + 0.5 * u * StrictMath.cos(0.4), within(1e-12));
        assertThat(robot.getY()).isCloseTo(0.5 * u * StrictMath.sin(0.4), within(1e-12));
        assertThat(robot.getAngle()).isZero();
    }

    /** A wheel on a body of its own is steered by a torque, which does work, and nothing is lost to jumps. */
    @Test
    void anAxleThatAMotorTurnsLosesNoEnergy() {
        begin(0, 0.01);
        engine.setAudited(true);
        Body axle = engine.add(new Body(new Rectangle(0.1, 0.3)).at(0.2, 0));
        engine.add(new PinJoint(robot, axle, 0.2, 0));
        engine.add(new Wheel(axle, 0, 0));
        engine.add(new Wheel(robot, -0.1, 0));
        Motor steering = engine.add(Motor.turning(axle, robot, 0.5, 50));
        Limit stops = engine.add(Limit.angle(axle, robot, -0.6, 0.6));
        robot.setVelocity(1, 0);
        axle.setVelocity(1, 0);
        run(3);
        assertThat(stops.getValue()).isCloseTo(0.6, within(1e-9));
        assertThat(steering.getSpeed()).isEqualTo(0.5);
        assertThat(engine.getRunReport().unresolved()).isZero();
        assertThat(engine.getRunReport().drift()).isCloseTo(0, within(1e-8));
        double radius = 0.3 / StrictMath.tan(0.6); // of the rear wheel
        assertThat(speed(robot) / Math.abs(robot.getAngularVelocity())).isCloseTo(Math.hypot(radius, 0.1), within(1e-9));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aCopyDoesTheSame(int substeps) {
        begin(substeps, 0.02);
        for (int side = -1; side <= 1; side += 2) {
            Wheel wheel = wheel(side);
            engine.add(Motor.gripping(wheel, 3));
            engine.add(Motor.rolling(wheel, side, 5));
        }
        engine.add(new Wheel(robot, -0.1, 0, 0.1));
        robot.setVelocity(1, 2);
        run(0.2);
        PhysicsEngine copy = Checkpoint.copy(engine);
        run(1);
        for (int k = 0; k < 50; k++) {
            copy.step();
        }
        Checkpoint.assertSameBodies(engine, copy);
    }

    @Test
    void aRobotThatSleepsWakesWhenItIsSteeredOrDriven() {
        begin(4, 0.02);
        Wheel wheel = engine.add(new Wheel(robot, 0.1, 0));
        Motor drive = engine.add(Motor.rolling(wheel, 0, 5));
        run(10);
        assertThat(engine.isAsleep(robot)).isTrue();
        wheel.setSteering(1);
        engine.step();
        assertThat(engine.isAsleep(robot)).isFalse();
        run(10);
        assertThat(engine.isAsleep(robot)).isTrue();
        drive.setSpeed(1);
        run(1);
        assertThat(wheel.getRollingSpeed()).isGreaterThan(0.5);
    }

    /** On a slope, seen from above: a wheel across it bears its share, and one along it runs down. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aWheelBearsWhatIsAcrossIt(int substeps) {
        begin(substeps, 0.02);
        engine.add(new Gravity(0, -2));
        Wheel wheel = engine.add(new Wheel(robot, 0, 0, 0.7));
        run(1);
        double sin = StrictMath.sin(0.7);
        double cos = StrictMath.cos(0.7);
        assertThat(wheel.getRollingSpeed()).isCloseTo(-2 * sin, within(1e-12));
        assertThat(wheel.getSlip()).isCloseTo(0, within(1e-12));
        Reaction load = engine.getReaction(wheel);
        assertThat(load.forceX()).isCloseTo(-2 * MASS * cos * sin, within(1e-9));
        assertThat(load.forceY()).isCloseTo(2 * MASS * cos * cos, within(1e-9));
    }

    @Test
    void whatIsNoWheelIsRefused() {
        Wheel wheel = new Wheel(robot, 0, 0.1);
        assertThatThrownBy(() -> new Wheel(robot, Double.NaN, 0)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Wheel(robot, 0, 0, Double.POSITIVE_INFINITY)).hasMessageContaining("steering");
        assertThatThrownBy(() -> wheel.setSteering(Double.NaN)).hasMessageContaining("steering").hasMessageContaining("NaN");
        assertThat(wheel.getSteering()).isZero();
        assertThatThrownBy(() -> new Motor(wheel, 0, 1)).hasMessageContaining("Motor.rolling");
        assertThatThrownBy(() -> new Limit(wheel, 0, 1, 0)).hasMessageContaining("wheel");
        assertThatThrownBy(() -> Motor.gripping(wheel, 0)).hasMessageContaining("limit");
        assertThatThrownBy(() -> Motor.gripping(wheel, Double.POSITIVE_INFINITY)).hasMessageContaining("limit");
        assertThatThrownBy(() -> Motor.rolling(null, 0, 1)).isInstanceOf(NullPointerException.class);
        Body fixed = engine.add(Body.fixed(new Circle(1)).at(9, 9));
        assertThatThrownBy(() -> engine.add(new Wheel(fixed, 0, 0))).hasMessageContaining("none of its bodies");
    }
}
