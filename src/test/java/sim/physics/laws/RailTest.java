// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.constraint.Curve;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Motors along a rail give their force and no more; a rail ends where it says. */
class RailTest {
    private static final double MASS = 2;
    private static final double WEIGHT = 20;

    private PhysicsEngine engine;

    @BeforeEach
    void setUp() {
        engine = new PhysicsEngine();
        engine.setTimeStep(1 / 64.0);
    }

    private void run(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    /** A load on a vertical rail in the world, pulled down by its weight. */
    private SliderJoint lift() {
        engine.add(new Gravity(0, -WEIGHT / MASS));
        Body load = engine.add(new Body(new Rectangle(1, 1)).at(3, 5, 0.3));
        load.setMass(MASS, 1);
        return engine.add(new SliderJoint(load, null, 3.2, 5.1, 0, 7));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 0.3, 1 / 64.0})
    void aMotorLiftsALoadAtItsSpeed(double step) {
        SliderJoint rail = lift();
        engine.setTimeStep(step);
        Motor motor = engine.add(Motor.sliding(rail, 0.5, 30));
        double reached = 0.5 / ((30 - WEIGHT) / MASS); // when it has its speed
        engine.step();
        engine.step();
        assertThat(rail.getBodyA().getVelocityY()).isCloseTo(0.5 * Math.min(1, engine.getTime() / reached), within(1e-12));
        run(5);
        while (engine.getTime() < 10) {
            engine.step();
            assertThat(rail.getBodyA().getVelocityY()).isCloseTo(0.5, within(1e-12));
            assertThat(rail.getTravel()).isCloseTo(0.5 * (engine.getTime() - 0.5 * reached), within(1e-11));
            assertThat(engine.getReaction(motor).forceY()).isCloseTo(WEIGHT, within(1e-9));
            assertThat(engine.getReaction(motor).forceX()).isCloseTo(0, within(1e-12));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1e-3, -1e-8, 1e-8, 1e-3})
    void itStallsAtItsLimit(double more) {
        SliderJoint rail = lift();
        engine.add(Motor.sliding(rail, 0.5, WEIGHT * (1 + more)));
        run(64);
        double a = more * WEIGHT / MASS; // what is left of the force, and no friction
        assertThat(rail.getBodyA().getVelocityY()).isCloseTo(a, within(1e-12));
        assertThat(rail.getTravel()).isCloseTo(0.5 * a, within(1e-12));
    }

    @Test
    void aBrakeHoldsWhatItCan() {
        SliderJoint rail = lift();
        Motor brake = engine.add(Motor.sliding(rail, 0, WEIGHT * (1 + 1e-9)));
        run(200);
        assertThat(rail.getTravel()).isCloseTo(0, within(1e-13));
        brake.setLimit(WEIGHT / 2);
        run(64);
        assertThat(rail.getTravel()).isCloseTo(-0.5 * 0.5 * WEIGHT / MASS, within(1e-12));
        brake.setLimit(2 * WEIGHT);
        run(64);
        assertThat(rail.getTravel()).isCloseTo(-0.5 * WEIGHT / MASS * 0.5 * 1.5, within(1e-12)); // braked as it was let fall, and twice that
    }

    @Test
    void aMotorBetweenTwoBodiesKeepsTheirMomenta() {
        Body frame = engine.add(new Body(new Rectangle(4, 0.5)).at(0, 0, 0.4).moving(0.3, -0.1, 1.5));
        Body slug = engine.add(new Body(new Circle(0.3)).at(0.5, 0.6));
        slug.setVelocity(0.3 - 1.5 * 0.6, -0.1 + 1.5 * 0.5);
        slug.setAngularVelocity(1.5);
        SliderJoint rail = engine.add(new SliderJoint(slug, frame, 0.5, 0.6, 1, 0.2));
        engine.add(Motor.sliding(rail, -0.7, 0.9));
        engine.setAudited(true);
        double[] before = momenta(frame, slug);
        double energy = engine.kineticEnergy();
        double travel = 0;
        for (int k = 0; k < 200; k++) {
            double last = rail.getTravel();
            engine.step();
            travel = rail.getTravel() - last;
        }
        assertThat(travel).isCloseTo(-0.7 / 64, within(1e-10)); // constant against the turning rail
        double[] after = momenta(frame, slug);
        for (int k = 0; k < 3; k++) {
            assertThat(after[k]).isCloseTo(before[k], within(1e-7)); // the order of RK4
        }
        assertThat(engine.getRunReport().work()).isCloseTo(engine.kineticEnergy() - energy, within(1e-6));
    }

    private static double[] momenta(Body... bodies) {
        double[] sum = new double[3];
        for (Body b : bodies) {
            sum[0] += b.getMass() * b.getVelocityX();
            sum[1] += b.getMass() * b.getVelocityY();
            sum[2] += b.getMass() * (b.getX() * b.getVelocityY() - b.getY() * b.getVelocityX())
                    + b.getInertia() * b.getAngularVelocity();
        }
        return sum;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void aRailHasAnEnd(double restitution) {
        SliderJoint rail = lift();
        engine.setTimeStep(0.7);
        engine.add(Limit.travel(rail, -1.25, 4, restitution)); // falls for half a second, down to 5 times that
        engine.step();
        double after = 0.7 - 0.5;
        double way = restitution * 5 * after - (restitution > 0 ? 0.5 * 10 * after * after : 0);
        assertThat(rail.getTravel()).isCloseTo(-1.25 + way, within(1e-10));
        engine.setTimeStep(1 / 64.0);
        run(1000);
        double energy = engine.kineticEnergy() + WEIGHT * (rail.getTravel() + 1.25);
        assertThat(energy).isCloseTo(restitution < 1 ? 0 : WEIGHT * 1.25, within(1e-7));
    }

    @Test
    void theUpperEndBearsAsWell() {
        SliderJoint rail = lift();
        engine.add(Motor.sliding(rail, 2, 30));
        Limit end = engine.add(Limit.travel(rail, Double.NEGATIVE_INFINITY, 1.5));
        run(128);
        assertThat(rail.getTravel()).isCloseTo(1.5, within(1e-10));
        assertThat(rail.getBodyA().getVelocityY()).isCloseTo(0, within(1e-12));
        assertThat(engine.getReaction(end).forceY()).isCloseTo(WEIGHT - 30, within(1e-9)); // the motor pushes with all it has
    }

    /** A bead on an arm that a motor turns evenly is thrown outwards: r″ = ω² r. */
    @Test
    void anArmThrowsABeadAgainstItsEnd() {
        Body arm = engine.add(new Body(new Rectangle(8, 0.2)).at(0, 0));
        engine.add(new PinJoint(arm, 0, 0));
        Body bead = engine.add(new Body(new Circle(0.1)).at(0.5, 0));
        bead.setMass(MASS, 1e-3);
        arm.setAngularVelocity(1.5);
        bead.setVelocity(0, 0.75);
        bead.setAngularVelocity(1.5);
        engine.add(Motor.turning(arm, null, 1.5, 1e6));
        SliderJoint rail = engine.add(new SliderJoint(bead, arm, 0.5, 0, 1, 0));
        Limit end = engine.add(Limit.travel(rail, -10, 3));
        run(64);
        assertThat(rail.getTravel() + 0.5).isCloseTo(0.5 * StrictMath.cosh(1.5), within(1e-6));
        run(128);
        assertThat(rail.getTravel()).isCloseTo(3, within(1e-9));
        engine.step();
        assertThat(engine.getReaction(end).force()).isCloseTo(MASS * 1.5 * 1.5 * 3.5, within(1e-6));
    }

    @Test
    void elasticEndsKeepTheEnergyOfFreeBodies() {
        Body frame = engine.add(new Body(new Rectangle(4, 0.5)).moving(0.3, -0.1));
        Body slug = engine.add(new Body(new Circle(0.3)).at(0.5, 0.6).moving(2.3, -0.1));
        SliderJoint rail = engine.add(new SliderJoint(slug, frame, 0.5, 0.6, 1, 0));
        engine.add(Limit.travel(rail, -1, 1, 1));
        double energy = engine.kineticEnergy();
        double[] before = momenta(frame, slug);
        for (int k = 0; k < 2000; k++) {
            engine.step();
            assertThat(Math.abs(rail.getTravel())).isLessThan(1 + 1e-10);
        }
        assertThat(engine.kineticEnergy()).isCloseTo(energy, within(1e-9 * energy));
        double[] after = momenta(frame, slug);
        assertThat(after[0]).isCloseTo(before[0], within(1e-9));
        assertThat(after[1]).isCloseTo(before[1], within(1e-9));
    }

    /** What a lift carries lies on it, and goes up with it. */
    @Test
    void aLiftOnTheGroundCarriesABox() {
        SliderJoint rail = lift();
        engine.add(Body.fixed(new Rectangle(50, 1)).at(0, 3)); // the ground, a unit below the load
        Body plate = rail.getBodyA();
        plate.setAngle(0);
        engine.remove(rail);
        rail = engine.add(new SliderJoint(plate, null, 3, 5, 0, 1));
        plate.setRestitution(0);
        plate.setFriction(0.5);
        Body box = engine.add(new Body(new Rectangle(0.5, 0.5)).at(3.1, 5.75));
        box.setMass(1, 0.1);
        box.setRestitution(0);
        box.setFriction(0.5);
        Motor motor = engine.add(Motor.sliding(rail, 0.4, 60));
        engine.add(Limit.travel(rail, -0.5, 1));
        run(64);
        assertThat(plate.getVelocityY()).isCloseTo(0.4, within(1e-7));
        assertThat(box.getY() - plate.getY()).isCloseTo(0.75, within(1e-4));
        run(128);
        assertThat(rail.getTravel()).isCloseTo(1, within(1e-5));
        motor.setSpeed(-1);
        motor.setLimit(5);
        run(200);
        assertThat(rail.getTravel()).isCloseTo(-0.5, within(1e-5)); // at the lower end, just above the ground
        assertThat(box.getY() - plate.getY()).isCloseTo(0.75, within(1e-4));
    }

    @Test
    void aCheckpointContinues() {
        SliderJoint rail = lift();
        engine.add(Motor.sliding(rail, 0.5, 30));
        engine.add(Limit.travel(rail, -1, 1, 0.5));
        run(20);
        PhysicsEngine copy = Checkpoint.copy(engine);
        run(300);
        for (int k = 0; k < 300; k++) {
            copy.step();
        }
        assertThat(Scenes.hash(copy)).isEqualTo(Scenes.hash(engine));
    }

    /** Directions are of any length, also where their squares are no numbers: a power of two changes no bit. */
    @ParameterizedTest
    @ValueSource(doubles = {0x1p-1060, 0x1p-700, 0x1p10, 0x1p700, 0x1p1020})
    void directionsOfAnyLength(double factor) {
        Body load = new Body(new Rectangle(1, 1)).at(3, 5, 0.3);
        assertThat(slide(new SliderJoint(load, null, 3.2, 5.1, 3 * factor, 4 * factor)))
                .isEqualTo(slide(new SliderJoint(new Body(new Rectangle(1, 1)).at(3, 5, 0.3), null, 3.2, 5.1, 3, 4)));
        double[] one = new double[6];
        double[] other = new double[6];
        Curve.line(1, 2, 3 * factor, 4 * factor).evaluate(7, 3, one);
        Curve.line(1, 2, 3, 4).evaluate(7, 3, other);
        assertThat(one).isEqualTo(other);
    }

    private static double slide(SliderJoint rail) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.125);
        engine.add(new Gravity(0, -1));
        engine.add(rail.getBodyA());
        engine.add(rail);
        for (int k = 0; k < 8; k++) {
            engine.step();
        }
        assertThat(rail.getTravel()).isCloseTo(-0.4, within(1e-12)); // half of the part of gravity along 3, 4
        return rail.getTravel();
    }

    @Test
    void badInputIsRefused() {
        SliderJoint rail = lift();
        assertThatNullPointerException().isThrownBy(() -> Motor.sliding(null, 1, 1)).withMessage("rail");
        assertThatNullPointerException().isThrownBy(() -> Limit.travel(null, 0, 1)).withMessage("rail");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Motor.sliding(rail, Double.NaN, 1))
                .withMessageContaining("speed is NaN");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Motor.sliding(rail, 1, 0))
                .withMessageContaining("limit is 0.0");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Limit.travel(rail, 2, 1))
                .withMessageContaining("lower is 2.0: it must be less than upper, 1.0");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Limit.travel(rail, 0, 1, 1.5))
                .withMessageContaining("restitution is 1.5");
    }
}
