// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Curve;
import sim.physics.constraint.GearJoint;
import sim.physics.constraint.GlobalSolver;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.Stabilization;
import sim.physics.constraint.WeldJoint;
import sim.physics.constraint.WireJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What joints do no matter what: no work, no momentum, no gap. */
class JointLawsTest {
    private static Body body(SplittableRandom random, PhysicsEngine engine) {
        Body body = new Body(new Rectangle(1, 0.5)).at(random.nextDouble(-3, 3), random.nextDouble(-3, 3), random.nextDouble());
        body.moving(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
        body.setMass(random.nextDouble(0.5, 2));
        body.setCollisionGroup(1, 0);
        return engine.add(body);
    }

    /** A floating mechanism of seven bodies with every kind of joint and a loop. */
    private static Body[] mechanism(PhysicsEngine engine, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Body[] b = new Body[7];
        for (int k = 0; k < b.length; k++) {
            b[k] = body(random, engine);
        }
        engine.add(new PinJoint(b[0], b[1], 0, 0));
        engine.add(new RodJoint(b[1], 1, 0.5, b[2], -1, 2));
        engine.add(new WeldJoint(b[2], b[3], 0.5, 0.5));
        engine.add(new SliderJoint(b[4], b[3], 0.2, 0.1, 1, 2));
        engine.add(new GearJoint(b[4], b[5], -1));
        engine.add(new PinJoint(b[5], b[6], 1, 1));
        engine.add(new RodJoint(b[6], 2, 2, b[0], -1, -2));
        return b;
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void aFloatingMechanismKeepsEnergyAndMomentum(long seed) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1e-3);
        Body[] b = mechanism(engine, seed);
        engine.step();
        double[] before = invariants(engine, b);
        for (int k = 0; k < 2000; k++) {
            engine.step();
        }
        double[] after = invariants(engine, b);
        assertThat(after[0]).as("energy").isCloseTo(before[0], within(1e-9 * before[0]));
        for (int k = 1; k < 4; k++) {
            assertThat(after[k]).as("momentum").isCloseTo(before[k], within(1e-12));
        }
    }

    private static double[] invariants(PhysicsEngine engine, Body[] bodies) {
        double[] sum = {engine.kineticEnergy(), 0, 0, 0};
        for (Body b : bodies) {
            sum[1] += b.getMass() * b.getVelocityX();
            sum[2] += b.getMass() * b.getVelocityY();
            sum[3] += b.getMass() * (b.getX() * b.getVelocityY() - b.getY() * b.getVelocityX())
                    + b.getInertia() * b.getAngularVelocity();
        }
        return sum;
    }

    private static double[] poses(Body[] bodies) {
        return Arrays.stream(bodies).flatMapToDouble(b -> DoubleStream.of(b.getX(), b.getY(), b.getAngle())).toArray();
    }

    @Test
    void theWriteUpsGlobalSolveAndTheEliminationAgree() {
        for (long seed = 1; seed <= 20; seed++) {
            double[][] x = new double[2][];
            for (int way = 0; way < 2; way++) {
                PhysicsEngine engine = new PhysicsEngine();
                engine.setTimeStep(1e-2);
                engine.add(new Gravity(0, -9.81));
                if (way == 1) {
                    engine.setConstraintSolver(new GlobalSolver());
                }
                Body[] b = mechanism(engine, seed);
                for (int k = 0; k < 20; k++) {
                    engine.step();
                }
                x[way] = poses(b);
            }
            assertThat(x[1]).containsExactly(x[0], within(1e-9));
        }
    }

    /** Pins alone, which are a case of their own; the masses change on the way. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theGlobalSolveAndTheEliminationAgreeOnPins(boolean isHeld) {
        double[][] x = new double[2][];
        for (int way = 0; way < 2; way++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1e-3);
            engine.add(new Gravity(0.5, -9.81));
            Body[] b = new Body[5];
            for (int k = 0; k < b.length; k++) {
                b[k] = engine.add(new Body(new Rectangle(1, 0.2)).at(k + 0.5, 0));
                b[k].setMass(1 + 0.5 * k, 0.1);
                b[k].setCollisionGroup(1, 0);
                if (k > 0 || isHeld) {
                    engine.add(k == 0 ? new PinJoint(b[k], 0, 0) : new PinJoint(b[k - 1], b[k], k, 0));
                }
            }
            b[4].setAngularVelocity(1);
            if (way == 1) {
                engine.setConstraintSolver(new GlobalSolver());
            }
            for (int k = 0; k < 200; k++) {
                if (k == 100) {
                    b[2].setMass(5, 0.5);
                }
                engine.step();
            }
            x[way] = poses(b);
        }
        assertThat(x[1]).containsExactly(x[0], within(1e-9));
    }

    /** C″ = −p C − v Ċ of a gear decays; it does not feed on what was fed back before. */
    @Test
    void feedbackKeepsAngles() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        engine.setStabilization(Stabilization.feedback(0.3, 0.3));
        Body a = engine.add(new Body(new Circle(1)).at(0, 0));
        Body b = engine.add(new Body(new Circle(1)).at(3, 0));
        engine.add(new PinJoint(a, 0, 0));
        engine.add(new PinJoint(b, 3, 0));
        engine.add(new GearJoint(a, b, -2));
        engine.add(new Spring(a, 0.9, 0, b, 0, 0.8, 1, 30, 0));
        double most = 0;
        for (int k = 0; k < 3000; k++) {
            engine.step();
            most = Math.max(most, Math.abs(a.getAngle()));
        }
        assertThat(most).isGreaterThan(0.1);
        assertThat(a.getAngle() - 2 * b.getAngle()).isCloseTo(0, within(1e-13)); // it was 2e-11, and grew
    }

    @Test
    void aBeadStartsFromRestAndStaysOnItsWire() {
        PhysicsEngine engine = new PhysicsEngine();
        Body bead = engine.add(new Body(new Circle(3)).at(50, 50));
        bead.setMass(28.27);
        engine.add(new WireJoint(bead, Curve.line(0, 0, 1, 1)));
        engine.add(new Gravity(0, 1 / 28.27));
        for (int t = 1; t <= 100; t++) {
            engine.step();
            double exact = 50 + t * t / (4 * 28.27);
            assertThat(bead.getX()).isCloseTo(exact, within(1e-12 * exact));
            assertThat(bead.getY()).isCloseTo(bead.getX(), within(1e-13));
        }
    }

    @Test
    void aPinnedBodyWithTwoHingesAtOnePlaceIsAPendulum() {
        double[] angle = new double[2];
        for (int hinges = 1; hinges <= 2; hinges++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(0.001);
            engine.add(new Gravity(0, -9.81));
            Body rod = engine.add(new Body(new Rectangle(1, 0.1)).at(0.5, 0));
            for (int k = 0; k < hinges; k++) {
                engine.add(new PinJoint(rod, 0, 0));
            }
            for (int k = 0; k < 3000; k++) {
                engine.step();
            }
            angle[hinges - 1] = rod.getAngle();
        }
        assertThat(angle[1]).isCloseTo(angle[0], within(1e-11)); // RK4 of the angle, and of the place
    }

    @Test
    void aJointThatIsCutLetsItsBodyFlyOn() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        Body rod = engine.add(new Body(new Rectangle(1, 0.1)).at(0.5, 0).moving(0, 1, 2));
        Constraint pin = engine.add(new PinJoint(rod, 0, 0));
        for (int k = 0; k < 50; k++) {
            engine.step();
        }
        engine.remove(pin);
        double[] from = {rod.getX(), rod.getY(), rod.getAngle()};
        double vx = rod.getVelocityX();
        double vy = rod.getVelocityY();
        double omega = rod.getAngularVelocity();
        for (int k = 0; k < 100; k++) {
            engine.step();
        }
        assertThat(rod.getX()).isCloseTo(from[0] + vx, within(1e-14));
        assertThat(rod.getY()).isCloseTo(from[1] + vy, within(1e-14));
        assertThat(rod.getAngle()).isCloseTo(from[2] + omega, within(1e-14));
    }
}
