// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.hipparchus.ode.ODEState;
import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.hipparchus.ode.nonstiff.DormandPrince853Integrator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.ConstraintException;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Drives, fast turns and forces that jump. */
class DriveTest {
    private static final double G = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();

    private Body[] chain(int n) {
        Body[] rods = new Body[n];
        for (int k = 0; k < n; k++) {
            rods[k] = engine.add(new Body(new Rectangle(1, 0.02)).at(k + 0.5, 0));
            rods[k].setMass(1, 1 / 12.0);
            rods[k].setCollisionGroup(1, 0);
            engine.add(k == 0 ? new PinJoint(rods[0], 0, 0) : new PinJoint(rods[k - 1], rods[k], k, 0));
        }
        return rods;
    }

    /** A servo at each joint: a torque towards the angle before plus a set one, and against the rate. */
    private static final class Servos implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final Body[] rods;
        private final double gain;
        private final double set;
        private long evaluations;

        Servos(Body[] rods, double gain, double set) {
            this.rods = rods;
            this.gain = gain;
            this.set = set;
        }

        @Override
        public boolean isCoupled() {
            return true;
        }

        @Override
        public boolean actsOn(Body body) {
            return Arrays.asList(rods).contains(body);
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            evaluations++;
            int k = Arrays.asList(rods).indexOf(body);
            forces.addTorque(body, torque(k) - (k + 1 < rods.length ? torque(k + 1) : 0));
        }

        private double torque(int k) {
            double angle = rods[k].getAngle() - (k == 0 ? 0 : rods[k - 1].getAngle());
            double rate = rods[k].getAngularVelocity() - (k == 0 ? 0 : rods[k - 1].getAngularVelocity());
            return gain * (set - angle) - 0.5 * gain * rate;
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e4, 1e6, 1e9})
    void stiffServosBringAChainWhereItIsWanted(double gain) {
        engine.setTimeStep(0.5);
        engine.setIntegrator(new RadauIIA(1e-6));
        engine.add(new Gravity(0, -G));
        Body[] rods = chain(10);
        Servos servos = new Servos(rods, gain, 0.1);
        engine.add(servos);
        for (int k = 0; k < 20; k++) {
            engine.step();
        }
        double most = 0;
        double speed = 0;
        for (int k = 0; k < 10; k++) {
            double angle = rods[k].getAngle() - (k == 0 ? 0 : rods[k - 1].getAngle());
            most = Math.max(most, Math.abs(angle - 0.1));
            speed = Math.max(speed, Math.abs(rods[k].getAngularVelocity()));
        }
        assertThat(most).isLessThan(600 / gain + 1e-6); // the weight of ten rods, over the gain
        assertThat(speed).isLessThan(1e-5);
        assertThat(servos.evaluations / 10).isLessThan(40_000);
    }

    /** A bob on a stiff spring; returns evaluations and how far it is from the bob on a rod. */
    private static double[] onStiffSpring(Integrator method, double stiffness) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.5);
        engine.setIntegrator(method);
        engine.add(new Gravity(0, -G));
        Body anchor = engine.add(Body.fixed(new Circle(0.01)));
        Body bob = engine.add(new Body(new Circle(0.01)).at(1, 0));
        bob.setMass(1);
        bob.setCollisionGroup(1, 0);
        engine.add(new Spring(anchor, 0, 0, bob, 0, 0, 1, stiffness, 0));
        Servos count = new Servos(new Body[] {bob}, 0, 0);
        engine.add(count);
        PhysicsEngine rigid = new PhysicsEngine();
        rigid.setTimeStep(0.5);
        rigid.setIntegrator(new DormandPrince853(1e-12));
        rigid.add(new Gravity(0, -G));
        Body point = rigid.add(new Body(new Circle(0.01)).at(1, 0));
        point.setMass(1, 1e-12);
        rigid.add(new RodJoint(point, 1, 0, null, 0, 0));
        double e = 0;
        for (int k = 0; k < 4; k++) {
            engine.step();
            rigid.step();
            e = Math.max(e, StrictMath.hypot(bob.getX() - point.getX(), bob.getY() - point.getY()));
        }
        return new double[] {count.evaluations, e};
    }

    /** At 10⁸ it oscillates 3,000 times, and the bob is 1.3 · 10⁻⁶ lower than on a rod. */
    @Test
    void aStiffSpringDoesNotSetTheStep() {
        double[] found = onStiffSpring(new RadauIIA(1e-9), 1e8);
        assertThat(found[0]).isLessThan(25_000); // that is 8 for each oscillation
        assertThat(found[1]).isLessThan(5e-6);
    }

    /** At 10¹² it oscillates 318,000 times. */
    @ParameterizedTest
    @CsvSource({"1e10, 150000, 1e-7", "1e12, 600000, 5e-6"})
    void aSpringThatIsStifferStillIsFollowedToo(double stiffness, double evaluations, double near) {
        double[] found = onStiffSpring(new RadauIIA(1e-9), stiffness);
        assertThat(found[0]).isLessThan(evaluations);
        assertThat(found[1]).isLessThan(near);
    }

    /** A pendulum whose pivot shakes up and down, seen from the pivot. */
    private static final class Shaking implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final double amplitude;
        private final double omega;

        Shaking(double amplitude, double omega) {
            this.amplitude = amplitude;
            this.omega = omega;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            double a = amplitude * omega * omega * StrictMath.cos(omega * time);
            forces.add(body, 0, -body.getMass() * (G - a));
        }
    }

    private static double kapitza(double omega, double duration) {
        OrdinaryDifferentialEquation equation = new OrdinaryDifferentialEquation() {
            @Override
            public int getDimension() {
                return 2;
            }

            @Override
            public double[] computeDerivatives(double t, double[] y) {
                double g = G - 0.05 * omega * omega * StrictMath.cos(omega * t);
                return new double[] {y[1], g * StrictMath.sin(y[0])};
            }
        };
        return new DormandPrince853Integrator(1e-12, 1, 1e-13, 1e-13)
                .integrate(equation, new ODEState(0, new double[] {0.1, 0}), duration)
                .getPrimaryState()[0];
    }

    /** Upright it is stable where a²ω² > 2 g L, up to what a small swing changes: ω > 88.6. */
    @ParameterizedTest
    @CsvSource({"100, 5", "85, 4", "300, 5", "1000, 3"})
    void kapitzasPendulumStandsOrFalls(double omega, double duration) {
        engine.setTimeStep(0.5);
        engine.setIntegrator(new DormandPrince853(3e-13));
        Body bob = engine.add(new Body(new Circle(0.05)).at(StrictMath.sin(0.1), StrictMath.cos(0.1)));
        bob.setMass(1, 1e-9);
        engine.add(new RodJoint(bob, bob.getX(), bob.getY(), null, 0, 0));
        engine.add(new Shaking(0.05, omega));
        double most = 0;
        for (int k = 0; k < Math.round(2 * duration); k++) {
            engine.step();
            most = Math.max(most, Math.abs(StrictMath.atan2(bob.getX(), bob.getY())));
        }
        double e = StrictMath.atan2(bob.getX(), bob.getY()) - StrictMath.IEEEremainder(kapitza(omega, duration), 2 * StrictMath.PI);
        assertThat(e).isCloseTo(0, within(1e-8));
        assertThat(most < 0.3).isEqualTo(omega > 88.6);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1e3, 1e6, 1e9})
    void aFastDiscPullsAtItsPin(double omega) {
        engine.setTimeStep(10 / omega);
        engine.setIntegrator(new DormandPrince853(1e-10));
        Body disc = engine.add(new Body(new Circle(0.5)).at(0.25, 0).moving(0, 0.25 * omega, omega));
        disc.setMass(2);
        PinJoint pin = engine.add(new PinJoint(disc, 0, 0));
        Body free = engine.add(new Body(new Rectangle(1, 0.01)).at(10, 0).moving(0, 0, omega));
        for (int k = 1; k <= 100; k++) {
            engine.step();
        }
        double turned = omega * engine.getTime();
        double force = engine.getReaction(pin).force() / (2 * omega * omega * 0.25) - 1;
        double e = disc.getAngle() - turned;
        assertThat(force).isCloseTo(0, within(1e-12));
        assertThat(e).isCloseTo(0, within(1e-9));
        assertThat(free.getAngle()).isCloseTo(turned, within(2e-16 * turned));
    }

    /** With a step that is too long for the spin, the method of fixed step makes parts of it. */
    @ParameterizedTest
    @ValueSource(doubles = {1e3, 1e6})
    void aSpinThatAStepCannotFollowIsNoNonsense(double omega) {
        engine.setTimeStep(1 / 60.0);
        engine.setIntegrator(new RungeKutta4());
        Body disc = engine.add(new Body(new Circle(0.5)).at(0.25, 0).moving(0, 0.25 * omega, omega));
        disc.setMass(2);
        engine.add(new PinJoint(disc, 0, 0));
        double before = engine.kineticEnergy();
        engine.step();
        double e = engine.kineticEnergy() / before - 1;
        assertThat(StrictMath.hypot(disc.getX(), disc.getY())).isCloseTo(0.25, within(1e-15));
        assertThat(e).isCloseTo(0, within(1e-9));
    }

    @Test
    void aSpinThatNoPartOfAStepCanFollowIsRefused() {
        engine.setTimeStep(1 / 60.0);
        Body disc = engine.add(new Body(new Circle(0.5)).at(0.25, 0).moving(0, 0.25e9, 1e9));
        engine.add(new PinJoint(disc, 0, 0));
        assertThatThrownBy(engine::step).isInstanceOf(ConstraintException.class).hasMessageContaining("the time step may be much too long");
    }

    /** A thruster that is switched on within a step. */
    private static final class Thruster implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final double start;
        private long evaluations;

        Thruster(double start) {
            this.start = start;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            evaluations++;
            forces.add(body, time < start ? 0 : body.getMass(), 0);
        }
    }

    @Test
    void aForceOfAStepActsFromItsStartToItsEnd() {
        engine.setTimeStep(0.125);
        Body body = engine.add(new Body(new Circle(1)));
        for (int k = 0; k < 16; k++) {
            body.addForce(k % 4 == 1 ? body.getMass() : 0, 0);
            engine.step();
        }
        // four pushes of 1/8 each, with 1.75 − k/2 − 1/16 left to go on from the middle of each
        assertThat(body.getX()).isCloseTo(0.125 * (4 * 1.8125 - 3), within(1e-15));
    }

    /** From the second step on, and in the first one if it jumps not just at its start. */
    @ParameterizedTest
    @ValueSource(doubles = {0.123456, 0.3, 0.5, 0.77, 0.99, 1.01, 1.123456, 2.5})
    void aForceThatJumpsIsFollowedToTheTolerance(double time) {
        for (double tolerance = 1e-6; tolerance > 0.5e-10; tolerance *= 1e-2) {
            for (int method = 0; method < 2; method++) {
                PhysicsEngine run = new PhysicsEngine();
                run.setTimeStep(1);
                run.setIntegrator(
                        method == 0 ? new DormandPrince853(tolerance) : new Automatic(tolerance));
                Body body = run.add(new Body(new Circle(1)));
                Thruster thruster = new Thruster(time);
                run.add(thruster);
                for (int k = 0; k < 3; k++) {
                    run.step();
                }
                double e = body.getX() - 0.5 * (3 - time) * (3 - time);
                assertThat(e).as("%s", run.getIntegrator()).isCloseTo(0, within(10 * tolerance * (3 - time)));
                assertThat(thruster.evaluations).isLessThan(3000);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 1e-6, 1e-3, 0.1, 1, 10})
    void theStepOfTheEngineDoesNotMatter(double step) {
        double time = step < 1e-7 ? 1e-6 : step < 1e-4 ? 1e-3 : 10;
        double[][] end = new double[2][];
        for (int way = 0; way < 2; way++) {
            DriveTest run = new DriveTest();
            run.engine.setTimeStep(way == 0 ? step : time);
            run.engine.setIntegrator(new DormandPrince853(1e-11));
            run.engine.add(new Gravity(0, -G));
            Body rod = run.chain(1)[0];
            for (int k = 0; k < Math.round(time / run.engine.getTimeStep()); k++) {
                run.engine.step();
            }
            end[way] = new double[] {rod.getX(), rod.getY(), rod.getAngle()};
        }
        double e = StrictMath.hypot(end[0][0] - end[1][0], end[0][1] - end[1][1]);
        assertThat(e).isLessThan(1e-9);
    }
}
