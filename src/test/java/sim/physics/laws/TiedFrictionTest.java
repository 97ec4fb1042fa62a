// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Integrator;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.Rattle;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.SurfaceFriction;
import sim.physics.motion.SymplecticEuler;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Friction of the plane brings what joints tie to rest, where it stays, whatever the method is. */
class TiedFrictionTest {
    private static final double G = 10;
    private static final double MU = 0.2;
    private static final double STEP = 1.0 / 64;
    private static final double RADIUS = 0.5;

    private final PhysicsEngine engine = new PhysicsEngine();

    private static Integrator method(String name) {
        return switch (name) {
            case "RK4" -> new RungeKutta4();
            case "DOP853" -> new DormandPrince853(1e-6);
            case "Automatic" -> new Automatic(1e-6);
            case "Radau" -> new RadauIIA(1e-6);
            case "Rattle" -> new Rattle(2);
            default -> new SymplecticEuler();
        };
    }

    private void begin(Integrator integrator) {
        engine.setTimeStep(STEP);
        engine.setIntegrator(integrator);
        engine.add(new SurfaceFriction(G));
    }

    private Body put(Body body) {
        body.setSurfaceFriction(MU);
        return engine.add(body);
    }

    private void run(double time) {
        for (int k = 0; k < Math.round(time / STEP); k++) {
            engine.step();
        }
    }

    /** Pinned in its middle it stops after ω² / 2 α with α = 4 μ g / 3 R, and turns no more. */
    @ParameterizedTest
    @ValueSource(strings = {"RK4", "DOP853", "Automatic", "Radau", "Rattle", "SymplecticEuler"})
    void aPinnedDiscStopsAndStays(String name) {
        begin(method(name));
        Body disc = put(new Body(new Circle(RADIUS)).moving(0, 0, 2));
        engine.add(new PinJoint(disc, 0, 0));
        run(3);
        double angle = disc.getAngle();
        double error = name.equals("SymplecticEuler") ? 2 * STEP : name.startsWith("R") && !name.equals("Radau") ? 4 * STEP * STEP : 3e-5;
        assertThat(angle).isCloseTo(2 * 2 / (2 * 4 * MU * G / (3 * RADIUS)), within(error));
        run(10);
        assertThat(disc.getAngle()).isCloseTo(angle, within(name.equals("DOP853") ? 1e-4 : 1e-12));
        assertThat(disc.getAngularVelocity()).isCloseTo(0, within(name.equals("DOP853") ? 1e-3 : 1e-12));
    }

    /**
     * Pinned and pushed back by a constant torque it turns round, and friction with it: all rows of an extrapolation agreed on one that went
     * on or stood, by up to a tenth of a radian, also where the tolerance was less.
     */
    @ParameterizedTest
    @CsvSource({"1e-6, 64", "1e-8, 64", "1e-6, 10", "1e-8, 10", "1e-8, 256"})
    void aDiscThatIsPushedBackTurnsRound(double tolerance, double steps) {
        double slowing = 4 * MU * G / (3 * RADIUS);
        for (int k = 0; k < 20; k++) {
            PhysicsEngine world = new PhysicsEngine();
            world.setTimeStep(1 / steps);
            world.setIntegrator(new GraggBulirschStoer(tolerance));
            world.add(new SurfaceFriction(G));
            double first = 0.5 + 0.2 * k;
            double push = (1.5 + 0.5 * (k % 5)) * slowing;
            Body disc = new Body(new Circle(RADIUS)).moving(0, 0, first);
            disc.setSurfaceFriction(MU);
            world.add(disc);
            world.add(new PinJoint(disc, 0, 0));
            world.add((ForceGenerator) (body, time, forces) -> forces.addTorque(body, -push * body.getInertia()));
            double until = first / (push + slowing);
            int count = (int) Math.ceil(2 * until * steps) + 2;
            for (int m = 0; m < count; m++) {
                world.step();
            }
            double back = count / steps - until;
            double angle = 0.5 * first * until - 0.5 * (push - slowing) * back * back;
            assertThat(disc.getAngle()).isCloseTo(angle, within(2 * Math.sqrt(tolerance)));
        }
    }

    /** A cart that pulls two others comes to rest as a whole. */
    @Test
    void aTrainStopsAndStays() {
        begin(new RungeKutta4());
        Body[] carts = new Body[3];
        for (int k = 0; k < 3; k++) {
            carts[k] = put(new Body(new Rectangle(1, 0.5)).at(1.2 * k, 0).moving(2 - k, 1, 1 - k));
        }
        engine.add(new PinJoint(carts[0], carts[1], 0.6, 0));
        engine.add(new PinJoint(carts[1], carts[2], 1.8, 0));
        run(4);
        double x = carts[1].getX();
        double angle = carts[2].getAngle();
        run(20);
        assertThat(carts[1].getX()).isCloseTo(x, within(1e-12));
        assertThat(carts[2].getAngle()).isCloseTo(angle, within(1e-12));
        assertThat(engine.kineticEnergy()).isLessThan(1e-24);
    }

    /** Under nine tenths of what friction bears a disc stands, and one that spins comes to a stop and stays. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, 0.9})
    void whatIsPushedByLessThanFrictionBearsStands(double share) {
        begin(new RungeKutta4());
        Body disc = put(new Body(new Circle(RADIUS)));
        Body other = put(new Body(new Circle(RADIUS)).at(5, 0).moving(0, 0, 3));
        engine.add(new PinJoint(disc, 0, 0));
        engine.add(new PinJoint(other, 5, 0));
        double torque = share * 2 / 3.0 * MU * G * disc.getMass() * RADIUS;
        double stopped = 0;
        for (int k = 0; k < 1280; k++) {
            disc.addTorque(torque);
            other.addTorque(torque);
            engine.step();
            stopped = k == 1023 ? other.getAngle() : stopped;
        }
        assertThat(disc.getAngle()).isZero();
        assertThat(other.getAngularVelocity()).isZero();
        assertThat(other.getAngle()).isEqualTo(stopped).isCloseTo(9 / (2 * (1 - share) * 4 * MU * G / (3 * RADIUS)), within(5e-3));
    }

    /** A brake and the friction of the plane hold the same: no method finds forces there that it cannot follow. */
    @Test
    void aBrakeHolds() {
        begin(new GraggBulirschStoer(1e-6));
        Body disc = put(new Body(new Circle(0.446)).at(0, 0, 0.3).moving(0, 0, -3));
        engine.add(new PinJoint(disc, 1e-4, 0));
        engine.add(Motor.turning(disc, null, 0, 20));
        run(2);
        assertThat(disc.getAngularVelocity()).isCloseTo(0, within(1e-12));
    }
}
