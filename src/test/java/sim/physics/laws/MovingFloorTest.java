// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.KinematicBody;
import sim.physics.motion.Spring;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** A floor whose course is given hands nothing on: what lies on it knows nothing of what else does, by time stepping as by any other law. */
class MovingFloorTest {
    private static final int PILES = 3;

    /** Piles far from one another on one floor; those of a set of numbers. */
    private static PhysicsEngine piles(int which, double restitution) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.setTimeStepping(4);
        engine.add(new Gravity(0, -10));
        engine.add(new KinematicBody(new Rectangle(200, 1)).at(0, -0.5).moving(2, 0.5));
        SplittableRandom random = new SplittableRandom(5);
        for (int pile = 0; pile < PILES; pile++) {
            for (int k = 0; k < 5; k++) {
                double width = 0.5 + 0.5 * random.nextDouble();
                Body body = new Body(k % 2 == 0 ? new Rectangle(width, 0.6) : new Circle(width / 2));
                body.at(40 * pile - 40 + 0.4 * random.nextDouble(), 0.8 + 1.2 * k, random.nextDouble()).moving(1 + 2 * random.nextDouble(), 0.5);
                body.setMass(1 + k);
                if ((which >> pile & 1) != 0) {
                    engine.add(body);
                }
            }
        }
        for (Body body : engine.bodies()) {
            body.setFriction(0.5);
            body.setRestitution(restitution);
        }
        return engine;
    }

    private static void run(PhysicsEngine engine, double acceleration) {
        KinematicBody floor = (KinematicBody) engine.bodies().get(0);
        for (int k = 1; k <= 120; k++) {
            if (acceleration > 0) {
                floor.setTargetVelocity(2 + acceleration * StrictMath.sin(k / 15.0), 0.5 + acceleration * StrictMath.sin(k / 10.0), 0);
            }
            engine.step();
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "0.5, 0", "1, 0", "0, 1", "0.5, 1", "1, 1"})
    void pilesOnOneFloorAreAsEachAlone(double restitution, double acceleration) {
        PhysicsEngine all = piles((1 << PILES) - 1, restitution);
        run(all, acceleration);
        int next = 1;
        for (int pile = 0; pile < PILES; pile++) {
            PhysicsEngine one = piles(1 << pile, restitution);
            run(one, acceleration);
            for (int k = 1; k < one.bodies().size(); k++, next++) {
                assertThat(all.bodies().get(next).getX()).isEqualTo(one.bodies().get(k).getX());
                assertThat(all.bodies().get(next).getY()).isEqualTo(one.bodies().get(k).getY());
                assertThat(all.bodies().get(next).getAngle()).isEqualTo(one.bodies().get(k).getAngle());
            }
        }
    }

    /** A pendulum on a floor that is accelerated evenly, and two bodies that fall on it, do as on a fixed one in the field that this makes. */
    @ParameterizedTest
    @CsvSource({"1, 0", "1, 0.5", "1, 1", "4, 0.5", "4, 1"})
    void aFloorThatIsAcceleratedIsAnotherField(int substeps, double restitution) {
        for (int seed = 1; seed <= 5; seed++) {
            PhysicsEngine still = fall(Body.fixed(new Rectangle(400, 1)), -0.7, -12.3, substeps, restitution, seed);
            PhysicsEngine moving = fall(new KinematicBody(new Rectangle(400, 1)), 0, -10, substeps, restitution, seed);
            KinematicBody floor = (KinematicBody) moving.bodies().get(0);
            for (int k = 1; k <= 90; k++) {
                floor.setTargetVelocity(0.7 * k / 60, 2.3 * k / 60, 0);
                still.step();
                moving.step();
                for (int m = 1; m < 4; m++) {
                    Body there = still.bodies().get(m);
                    Body here = moving.bodies().get(m);
                    assertThat(here.getX() - floor.getX()).isCloseTo(there.getX(), within(1e-9));
                    assertThat(here.getY() - floor.getY() - 0.5).isCloseTo(there.getY(), within(1e-9));
                }
            }
        }
    }

    private static PhysicsEngine fall(Body floor, double gx, double gy, int substeps, double restitution, int seed) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.setTimeStepping(substeps);
        engine.setSleepAllowed(false);
        engine.add(new Gravity(gx, gy));
        engine.add(floor.at(0, -0.5));
        SplittableRandom random = new SplittableRandom(seed);
        for (int k = 0; k < 2; k++) {
            Body body = new Body(k == 0 ? new Circle(0.4) : new Rectangle(0.7, 0.6));
            body.at(0.4 * random.nextDouble() + 6 * k, 0.8 + 1.2 * k, random.nextDouble());
            engine.add(body.moving(2 * random.nextDouble() - 1, 0, random.nextDouble()));
        }
        Body pendulum = engine.add(new Body(new Rectangle(2, 0.2)).at(21, 5));
        engine.add(new PinJoint(floor, pendulum, 20, 5));
        for (Body body : engine.bodies()) {
            body.setFriction(0.4);
            body.setRestitution(restitution);
        }
        return engine;
    }

    /** A machine on a floor that moves evenly does as on a fixed one, whatever else falls there. */
    @ParameterizedTest
    @CsvSource({"0, 2, 0.5", "0, 1000, 333", "0.5, 2, 0.5", "0.5, 1000, 333"})
    void machinesOnOneFloorAreAsOnTheGround(double restitution, double u, double v) {
        PhysicsEngine still = machines(Body.fixed(new Rectangle(400, 1)), restitution, 0, 0);
        PhysicsEngine moving = machines(new KinematicBody(new Rectangle(400, 1)).moving(u, v), restitution, u, v);
        for (int k = 1; k <= 90; k++) {
            still.step();
            moving.step();
            for (int m = 1; m < 7; m++) {
                Body there = still.bodies().get(m);
                Body here = moving.bodies().get(m);
                assertThat(here.getX() - u * k / 60).isCloseTo(there.getX(), within(1e-8));
                assertThat(here.getY() - v * k / 60).isCloseTo(there.getY(), within(1e-8));
            }
        }
    }

    /** A double pendulum, a four-bar with a motor, what hangs on a stiff spring, and a heap. */
    private static PhysicsEngine machines(Body floor, double restitution, double u, double v) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.setTimeStepping(4);
        engine.add(new Gravity(0, -10));
        engine.add(floor.at(0, -0.5));
        Body upper = engine.add(new Body(new Rectangle(2, 0.2)).at(-49, 6).moving(u, v));
        Body lower = engine.add(new Body(new Rectangle(2, 0.2)).at(-47, 6).moving(u, v));
        Body crank = engine.add(new Body(new Rectangle(1, 0.1)).at(0, 5.5, Math.PI / 2).moving(u, v));
        Body coupler = engine.add(new Body(new Rectangle(3, 0.1)).at(1.5, 6).moving(u, v));
        Body rocker = engine.add(new Body(new Rectangle(2, 0.1)).at(3, 5, Math.PI / 2).moving(u, v));
        engine.add(new PinJoint(floor, upper, -50, 6));
        engine.add(new PinJoint(upper, lower, -48, 6));
        engine.add(new PinJoint(crank, floor, 0, 5));
        engine.add(new PinJoint(crank, coupler, 0, 6));
        engine.add(new PinJoint(coupler, rocker, 3, 6));
        engine.add(new PinJoint(rocker, floor, 3, 4));
        engine.add(Motor.turning(crank, floor, 2, 100));
        Body hung = engine.add(new Body(new Rectangle(1, 1)).at(20, 4).moving(u + 1, v));
        engine.add(new Spring(hung, 0.3, 0.5, floor, 20, 7, 2, 1e5, 1));
        for (int k = 0; k < 5; k++) {
            engine.add(new Body(new Rectangle(0.7, 0.6)).at(50, 0.8 + 1.2 * k, 0.3 * k).moving(u, v));
        }
        for (Body body : engine.bodies()) {
            body.setFriction(0.4);
            body.setRestitution(restitution);
        }
        return engine;
    }

    /** What stands in a lift bears m (g + a) on it also while other things fall and tumble there: it was up to 3 % off. */
    @ParameterizedTest
    @CsvSource({"60, 0", "60, 0.5", "240, 0", "240, 0.5"})
    void aPassengerBearsOnlyItsOwnWeight(int rate, double restitution) {
        double h = 1.0 / rate;
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(h);
        engine.setTimeStepping(4);
        engine.add(new Gravity(0, -10));
        KinematicBody lift = new KinematicBody(new Rectangle(40, 1));
        engine.add(lift.at(0, -0.5));
        Body passenger = engine.add(new Body(new Rectangle(0.7, 0.8)).at(-6, 0.4));
        for (int k = 0; k < 3; k++) {
            engine.add(new Body(new Rectangle(0.5, 0.5)).at(14, 1 + k, 0.3 * k)).setMass(5);
        }
        for (Body body : engine.bodies()) {
            body.setFriction(0.5);
            body.setRestitution(restitution);
        }
        double before = 0;
        for (int k = 1; k <= 2 * rate; k++) {
            double speed = 1.5 * (1 - StrictMath.cos(4 * k * h));
            lift.setTargetVelocity(0, speed, 0);
            engine.step();
            double force = 0;
            for (LastingContact contact : engine.contacts(passenger)) {
                force += contact.forceY(passenger);
            }
            double expected = passenger.getMass() * (10 + (speed - before) / h);
            before = speed;
            assertThat(Math.abs(force / expected - 1)).as("step " + k).isLessThan(k > 8 ? 1e-4 : 1);
        }
    }
}
