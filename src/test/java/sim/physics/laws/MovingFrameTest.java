// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.KinematicBody;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** A scene is the same when all that bears, holds and drives it moves evenly: Galilei's law. */
class MovingFrameTest {
    /** Hooke's law between a body and a hook, as an author would write it. */
    private record Pull(Body hook, double stiffness) implements ForceGenerator {
        @Override
        public void addForce(Body body, double time, Forces forces) {
            assertThat(body.isDynamic()).isTrue(); // forces on others are not asked for
            forces.add(body, stiffness * (hook.getX() - 1 - body.getX()), 0);
        }

        @Override
        public boolean isCoupled() {
            return true;
        }
    }

    /** A disc behind a hook that goes on evenly, or ever faster: ξ = −(u sin ωt) / ω − a (1 − cos ωt) / ω². */
    @ParameterizedTest
    @CsvSource({"3, 0, 0, false, 1e-6", "3, 0, 1e-10, false, 1e-8", "1, 4, 0, false, 1e-6", "1, 4, 1e-10, false, 1e-8", "1, 4, 0, true, 1e-6", "1, 4, 1e-10, true, 1e-8"})
    void aHookPullsWhereItIs(double u, double a, double tolerance, boolean isAuthors, double bound) {
        double omega = 8;
        double h = 1 / 128.0;
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(h);
        if (tolerance > 0) {
            engine.setIntegrator(new DormandPrince853(tolerance));
        }
        KinematicBody hook = new KinematicBody(new Circle(0.1));
        engine.add(hook.at(100, 0).moving(u, 0));
        Body disc = engine.add(new Body(new Circle(0.1)));
        disc.setMass(2);
        double stiffness = disc.getMass() * omega * omega;
        disc.at(99, 0);
        engine.add(isAuthors ? new Pull(hook, stiffness) : new Spring(disc, 0, 0, hook, 0, 0, 1, stiffness, 0));
        for (int k = 1; k <= 256; k++) {
            hook.setTargetVelocity(u + a * k * h, 0, 0);
            engine.step();
        }
        double lag = -u / omega * StrictMath.sin(2 * omega) - a / (omega * omega) * (1 - StrictMath.cos(2 * omega));
        assertThat(hook.getX()).isCloseTo(100 + 2 * u + 2 * a, within(1e-9));
        assertThat(disc.getX() - hook.getX() + 1).isCloseTo(lag, within(bound));
    }

    /** A box that friction holds against a field askew stands on a floor that goes on as on the ground: by time stepping it crept on at 2 mm/s. */
    @ParameterizedTest
    @CsvSource({"0, 0, 4, 2e-5", "3, 0, 4, 2e-5", "0, -2, 4, 2e-5", "3, -2, 1, 3e-3", "0, 0, 0, 1e-9", "3, -2, 0, 1e-9"})
    void frictionHoldsOnWhatMoves(double u, double v, int substeps, double bound) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(3, -10));
        Body floor = engine.add(new KinematicBody(new Rectangle(40, 2)).at(0, -1).moving(u, v));
        Body box = engine.add(new Body(new Rectangle(1, 1)).at(0, 0.5).moving(u, v));
        for (Body body : engine.bodies()) {
            body.setFriction(0.5);
            body.setRestitution(0);
        }
        double fastest = 0;
        for (int k = 0; k < 600; k++) {
            engine.step();
            fastest = k < 60 ? 0 : Math.max(fastest, Math.abs(box.getVelocityX() - u));
        }
        assertThat(box.getX() - floor.getX()).isCloseTo(0, within(bound));
        assertThat(fastest).isLessThan(bound);
    }

    /** A box that falls askew onto a floor, slides and stops, by time stepping: the floor may be fixed, stand, or go on. */
    @ParameterizedTest
    @CsvSource({"0, 0", "3, -2"})
    void aBoxLandsOnWhatMovesAsOnTheGround(double u, double v) {
        PhysicsEngine still = landing(Body.fixed(new Rectangle(40, 2)), 0, 0);
        PhysicsEngine moving = landing(new KinematicBody(new Rectangle(40, 2)).moving(u, v), u, v);
        Body there = still.bodies().get(1);
        Body here = moving.bodies().get(1);
        for (int k = 1; k <= 150; k++) {
            still.step();
            moving.step();
            assertThat(here.getX() - u * k / 60).isCloseTo(there.getX(), within(1e-6));
            assertThat(here.getY() - v * k / 60).isCloseTo(there.getY(), within(1e-6));
            assertThat(here.getAngle()).isCloseTo(there.getAngle(), within(1e-6));
            assertThat(here.getVelocityY() - v).isCloseTo(there.getVelocityY(), within(1e-5));
            assertThat(here.getAngularVelocity()).isCloseTo(there.getAngularVelocity(), within(1e-5));
        }
    }

    private static PhysicsEngine landing(Body floor, double u, double v) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.setTimeStepping(4);
        engine.setSleepAllowed(false);
        engine.add(new Gravity(0, -10));
        engine.add(floor.at(0, -1));
        engine.add(new Body(new Rectangle(1, 0.6)).at(0, 1.5, 0.3).moving(u + 4, v, 1));
        for (Body body : engine.bodies()) {
            body.setFriction(0.5);
            body.setRestitution(0.3);
        }
        return engine;
    }

    /** An arm that a motor presses on a wall, where both are fixed, stand or go on: nothing is squeezed, so no step is relieved, and all have one angle. */
    @ParameterizedTest
    @CsvSource({"0, 20", "1e-6, 20", "3, 20", "1e-6, 1000", "0, 1000"})
    void aMotorPressesOnAWall(double u, double torque) {
        PhysicsEngine still = press(Body.fixed(new Circle(0.1)), Body.fixed(new Rectangle(1, 1)), 0, torque);
        PhysicsEngine moving = press(new KinematicBody(new Circle(0.1)).moving(u, 0), new KinematicBody(new Rectangle(1, 1)).moving(u, 0), u, torque);
        for (int k = 0; k < 240; k++) {
            still.step();
            moving.step();
        }
        assertThat(moving.getRelievedSteps()).isZero();
        assertThat(moving.bodies().get(2).getAngle()).isCloseTo(still.bodies().get(2).getAngle(), within(1e-6));
        assertThat(moving.bodies().get(0).getX()).isCloseTo(4 * u, within(1e-9));
    }

    private static PhysicsEngine press(Body pivot, Body wall, double u, double torque) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(pivot);
        engine.add(wall.at(0, 1.8));
        Body arm = engine.add(new Body(new Rectangle(2, 0.1)).at(1, 0).moving(u, 0));
        engine.add(new PinJoint(pivot, arm, 0, 0));
        engine.add(Motor.turning(arm, pivot, 3, torque));
        for (Body body : engine.bodies()) {
            body.setFriction(0.3);
            body.setRestitution(0);
        }
        return engine;
    }

    /** A disc in a room that is carried along ever faster, and falls as it does, bounces off a wall beside another one: it did not, by time stepping. */
    @ParameterizedTest
    @CsvSource({"0, 0", "1.7, -2.3"})
    void aDiscBouncesInARoomThatFalls(double gx, double gy) {
        double h = 1 / 60.0;
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(h);
        engine.setTimeStepping(4);
        engine.add(new Gravity(gx, gy));
        KinematicBody roof = new KinematicBody(new Rectangle(9, 2));
        KinematicBody wall = new KinematicBody(new Rectangle(2, 9));
        engine.add(roof.at(0, 3.5));
        engine.add(wall.at(-3.5, 0));
        Body disc = engine.add(new Body(new Circle(0.2755)).at(-0.96, 1.778).moving(-5.78, 1.7, 0.84));
        for (Body body : engine.bodies()) {
            body.setFriction(0.37);
            body.setRestitution(0.5);
        }
        for (int k = 1; k <= 16; k++) {
            roof.setTargetVelocity(gx * k * h, gy * k * h, 0);
            wall.setTargetVelocity(gx * k * h, gy * k * h, 0);
            engine.step();
        }
        assertThat(engine.getImpacts()).isEqualTo(1);
        assertThat(disc.getVelocityX() - wall.getVelocityX()).isCloseTo(0.5 * 5.78, within(1e-6));
    }

    /** What joints and a motor give a four-bar is watched as closely where its frame is fast: by time stepping it went on as if nobody did. */
    @ParameterizedTest
    @CsvSource({"3, 0", "1000, 333"})
    void aFourBarOnAFrameThatMoves(double u, double v) {
        PhysicsEngine still = fourBar(0, 0);
        PhysicsEngine moving = fourBar(u, v);
        for (int k = 0; k < 20; k++) {
            still.step();
            moving.step();
            for (int m = 1; m < 4; m++) {
                assertThat(moving.bodies().get(m).getAngularVelocity()).isCloseTo(still.bodies().get(m).getAngularVelocity(), within(1e-6));
            }
        }
    }

    private static PhysicsEngine fourBar(double u, double v) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.setTimeStepping(4);
        engine.add(new Gravity(0, -10));
        Body frame = engine.add(new KinematicBody(new Circle(0.1)).moving(u, v));
        Body crank = engine.add(new Body(new Rectangle(1, 0.1)).at(0, 0.5, Math.PI / 2).moving(u, v));
        Body coupler = engine.add(new Body(new Rectangle(3, 0.1)).at(1.5, 1).moving(u, v));
        Body rocker = engine.add(new Body(new Rectangle(2, 0.1)).at(3, 0, Math.PI / 2).moving(u, v));
        engine.add(new PinJoint(crank, frame, 0, 0));
        engine.add(new PinJoint(crank, coupler, 0, 1));
        engine.add(new PinJoint(coupler, rocker, 3, 1));
        engine.add(new PinJoint(rocker, frame, 3, -1));
        engine.add(Motor.turning(crank, frame, 2, 100));
        return engine;
    }
}
