// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.KinematicBody;
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
