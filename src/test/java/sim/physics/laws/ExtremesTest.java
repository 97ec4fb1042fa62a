// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.collision.broad.BroadPhase;
import sim.physics.collision.broad.BruteForce;
import sim.physics.collision.broad.CellGrid;
import sim.physics.collision.broad.SortAndSweep;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.ViscousFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Numbers at the ends of what doubles can hold, and bodies by the million (hard cases G12, G13, G15, G16). */
class ExtremesTest {
    private static void run(PhysicsEngine engine, int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e100, 1e150, 1e-150, 1e-300, Double.MIN_VALUE})
    void nothingPassesThroughAWallAtAnySpeed(double speed) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(Body.fixed(new Rectangle(1, 100)).at(50, 0));
        Body disc = engine.add(new Body(new Circle(1)).moving(speed, 0));
        Body rod = engine.add(new Body(new Rectangle(4, 1)).at(0, 20).moving(speed, 0));
        run(engine, 3);
        assertThat(disc.getX()).isLessThan(49);
        assertThat(rod.getX()).isLessThan(48);
        assertThat(Math.abs(disc.getVelocityX())).isEqualTo(speed);
    }

    private static final class Ear implements CollisionListener {
        private static final long serialVersionUID = 1L;
        private double impulse;

        @Override
        public void collided(Contact contact) {
            impulse = contact.impulse();
        }
    }

    /** Two discs of mass 1 that change their speeds give one another 2 m v. Of what is slow enough, as after an inelastic collapse, 0 was told. */
    @ParameterizedTest
    @CsvSource({"0, 1e-170", "0, 1e-290", "4, 1e-170", "4, 1e-200"})
    void impulsesAreToldWhoseSquaresUnderflow(int substeps, double speed) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStepping(substeps);
        Ear ear = new Ear();
        engine.addListener(ear);
        for (int k = 0; k < 2; k++) {
            Body disc = engine.add(new Body(new Circle(0.5)).at(k, 0).moving((1 - 2 * k) * speed, 0));
            disc.setMass(1);
            disc.setFriction(0.5);
        }
        run(engine, 1);
        assertThat(ear.impulse / speed).isCloseTo(2, within(1e-9));
    }

    @Test
    void speedsWhoseSquaresOverflowAreRefused() {
        Body body = new Body(new Circle(1));
        assertThatThrownBy(() -> body.setVelocity(1e200, 0)).hasMessageContaining("vx is 1.0E200");
        assertThatThrownBy(() -> body.moving(0, 0, -1e200)).hasMessageContaining("angular velocity is -1.0E200");
        assertThatThrownBy(() -> body.setVelocity(0, Double.NaN)).hasMessageContaining("vy is NaN");
        body.setMass(1e-100);
        assertThatThrownBy(() -> body.addImpulseAt(1e100, 0, 0, 0)).isInstanceOf(IllegalArgumentException.class);
        assertThat(body.getVelocityX()).isZero();
    }

    @Test
    void forcesThatWouldGiveSuchSpeedsAreRefusedAtOnce() {
        Body body = new Body(new Circle(1));
        body.setMass(1, 0.5);
        assertThatThrownBy(() -> body.addTorque(1e200)).hasMessageContaining("torque over the moment of inertia is 2.0E200");
        assertThatThrownBy(() -> body.addForce(0, -1e200)).hasMessageContaining("fy over the mass is -1.0E200");
        assertThatThrownBy(() -> body.addForceAt(1, 1e100, 1e100, 0)).hasMessageContaining("torque");
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStepping(4);
        engine.add(body);
        run(engine, 3);
        assertThat(body.kineticEnergy()).as("nothing of it was applied").isZero();
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e300, 1e-300})
    void aMassBesideWhichTheOtherIsNothingKeepsMomentumAndEnergy(double mass) {
        PhysicsEngine engine = new PhysicsEngine();
        Body a = engine.add(new Body(new Circle(1)).moving(1, 0));
        a.setMass(mass);
        Body b = engine.add(new Body(new Circle(1)).at(5, 0));
        run(engine, 10);
        assertThat(a.getVelocityX()).isCloseTo(mass > 1 ? 1 : -1, within(1e-15));
        assertThat(b.getVelocityX()).isCloseTo(mass > 1 ? 2 : 0, within(1e-15));
    }

    @Test
    void dragThatNearlyStopsBodiesLeavesNumbers() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(new ViscousFriction(1));
        Body a = engine.add(new Body(new Circle(1)).moving(1, 0, 1));
        a.setSurfaceFriction(1);
        run(engine, 2000); // e^−2000 is below the least number
        assertThat(a.getX()).isCloseTo(1, within(0.02));
        assertThat(Math.abs(a.getVelocityX())).isLessThan(1e-300);
    }

    /** Drag has nearly stopped a disc, and another one comes: they meet. The disc's box had been no number. */
    @ParameterizedTest
    @ValueSource(doubles = {0, Double.MIN_VALUE, 1e-320, 1e-310, 1e-300, 1e-160})
    void whatHardlyMovesUnderForcesIsMet(double speed) {
        for (BroadPhase broadPhase : new BroadPhase[] {new BruteForce(), new SortAndSweep(), new CellGrid()}) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(0.1);
            engine.setBroadPhase(broadPhase);
            engine.add(new ViscousFriction(1));
            Body slow = engine.add(new Body(new Circle(1)).moving(speed, 0));
            slow.setSurfaceFriction(0.01);
            run(engine, 3);
            slow.setPosition(0, 0);
            slow.setVelocity(speed, 0);
            Body fast = engine.add(new Body(new Circle(1)).at(4, 0).moving(-5, 0));
            run(engine, 20);
            assertThat(engine.getImpacts()).isEqualTo(1);
            assertThat(fast.getX()).as("like discs exchange their speeds").isCloseTo(2, within(0.1));
            assertThat(slow.getX()).isLessThan(-4);
        }
    }

    /** Bodies that fit no cell of the grid are where cells have no numbers any more: a step had never ended. */
    @Test
    @Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void largeBodiesMeetFarAway() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setBroadPhase(new CellGrid());
        for (int k = 0; k < 400; k++) {
            engine.add(new Body(new Circle(0.1)).at(k, 0));
        }
        Body large = engine.add(new Body(new Circle(5)).at(1e12, 0).moving(1, 0));
        Body other = engine.add(new Body(new Circle(5)).at(1e12 + 20, 0));
        run(engine, 20);
        assertThat(engine.getImpacts()).isEqualTo(1);
        assertThat(other.getX() - large.getX()).isCloseTo(20, within(0.01));
    }

    @Test
    void aMillionBodiesComeAndGoInTheRoomOfAThousand() {
        assertThat(replaced(1000)).isLessThan(2 * replaced(10));
    }

    /** Bytes of an engine whose thousand bodies have been replaced so many times. */
    private static int replaced(int times) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(new Gravity(0, -1));
        Body[] bodies = new Body[1000];
        for (int round = 0; round < times; round++) {
            for (int k = 0; k < bodies.length; k++) {
                if (bodies[k] != null) {
                    engine.remove(bodies[k]);
                }
                bodies[k] = engine.add(new Body(new Circle(1)).at(3 * (k % 40), 3 * (k / 40)));
            }
            engine.step();
        }
        assertThat(engine.bodies()).hasSize(1000);
        return Checkpoint.bytes(engine).length;
    }

    @Test
    void anEmptyEngineAndOneOfOneBodyStep() {
        PhysicsEngine engine = new PhysicsEngine();
        run(engine, 10);
        assertThat(engine.getTime()).isEqualTo(10);
        Body body = engine.add(new Body(new Circle(1)).moving(1, 0));
        run(engine, 10);
        assertThat(body.getX()).isEqualTo(10);
    }
}
