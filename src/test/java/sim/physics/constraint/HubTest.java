// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Bodies to which others are pinned at their own centres of mass, as wheels are: laws of motion, and the general code. */
class HubTest {
    /** Pushes bodies by a law. */
    private record Push(Law law) implements ForceGenerator {
        interface Law {
            void push(Body body, Forces forces);
        }

        @Override
        public boolean actsOn(Body body) {
            return !body.isFixed();
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            law.push(body, forces);
        }
    }

    /** A hub, the first or the last body, with wheels of some mass; the hub has 3 and 0.7. */
    private static List<Body> hub(PhysicsEngine engine, int wheels, double mass, boolean isLast) {
        SplittableRandom random = new SplittableRandom(wheels);
        Body hub = new Body(new Rectangle(1, 0.6)).at(2, -1, 0.4);
        hub.setMass(3, 0.7);
        List<Body> all = new ArrayList<>();
        for (int k = 0; k < wheels; k++) {
            Body wheel = new Body(new Circle(0.2)).at(2 + 2 * random.nextDouble(), -2 + 2 * random.nextDouble());
            wheel.setMass(mass * (1 + k), 0.01 + 0.1 * mass);
            all.add(wheel);
        }
        all.add(isLast ? wheels : 0, hub);
        all.forEach(engine::add);
        for (Body one : all) {
            one.setCollisionGroup(1, 0);
            if (one != hub) {
                engine.add(one.index() % 2 == 0
                        ? new PinJoint(hub, one, one.getX(), one.getY())
                        : new PinJoint(one, hub, one.getX(), one.getY()));
            }
        }
        all.remove(hub);
        all.add(0, hub);
        return all;
    }

    private static double centre(List<Body> bodies, boolean isX) {
        double sum = 0;
        double mass = 0;
        for (Body body : bodies) {
            sum += body.getMass() * (isX ? body.getX() : body.getY());
            mass += body.getMass();
        }
        return sum / mass;
    }

    /** Under constant forces on the common centre and constant torques all turns and ways are quadratic, which RK4 follows exactly. */
    @ParameterizedTest
    @CsvSource({"1, 0.5, false", "2, 0.5, true", "3, 1e-4, false", "4, 2, true", "2, 1e-6, true"})
    void constantTorquesTurnHubAndWheelsByThemselves(int wheels, double mass, boolean isLast) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.1);
        List<Body> all = hub(engine, wheels, mass, isLast);
        Body hub = all.get(0);
        double[] x = new double[all.size()];
        double[] y = new double[all.size()];
        double inertia = 0.7;
        double cx = centre(all, true);
        double cy = centre(all, false);
        for (int k = 0; k < all.size(); k++) {
            x[k] = all.get(k).getX() - cx;
            y[k] = all.get(k).getY() - cy;
            inertia += all.get(k).getMass() * (x[k] * x[k] + y[k] * y[k]);
        }
        engine.add(new Push((body, forces) -> {
            forces.add(body, 0.3 * body.getMass(), -0.1 * body.getMass());
            forces.addTorque(body, body == hub ? 0.5 : 0.002 * body.getMass());
        }));
        for (int step = 0; step < 40; step++) {
            engine.step();
        }
        double turn = 0.5 * 0.5 / inertia * 16;
        double cos = Math.cos(turn);
        double sin = Math.sin(turn);
        for (int k = 0; k < all.size(); k++) {
            Body body = all.get(k);
            double spin = body == hub ? 0.4 + turn : 0.5 * 0.002 * body.getMass() / body.getInertia() * 16;
            assertThat(body.getAngle()).isCloseTo(spin, within(1e-12));
            assertThat(body.getX()).isCloseTo(cx + 0.15 * 16 + cos * x[k] - sin * y[k], within(1e-12));
            assertThat(body.getY()).isCloseTo(cy - 0.05 * 16 + sin * x[k] + cos * y[k], within(1e-12));
            double rate = 0.5 / inertia * 4;
            assertThat(body.getVelocityX()).isCloseTo(1.2 - rate * (sin * x[k] + cos * y[k]), within(1e-12));
        }
    }

    private static List<Body> driven(ConstraintSolver solver, double step, double mass) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.setConstraintSolver(solver);
        List<Body> all = hub(engine, 3, mass, false);
        Body hub = all.get(0);
        hub.setAngularVelocity(1);
        engine.add(new Push((body, forces) -> {
            double weight = body.getMass();
            forces.add(body, -weight * body.getX() * (1 + body.index()), weight * Trigger.wave(body.getAngle() - body.getY()));
            forces.addTorque(body, 0.1 * weight * (Trigger.wave(body.getX()) - body.getAngularVelocity()));
        }));
        for (int k = 0; k < Math.round(1 / step); k++) {
            engine.step();
        }
        return all;
    }

    /** A smooth force. */
    private static final class Trigger {
        static double wave(double x) {
            return StrictMath.sin(2 * x);
        }
    }

    private static double apart(List<Body> those, List<Body> others) {
        double most = 0;
        for (int k = 0; k < those.size(); k++) {
            Body a = those.get(k);
            Body b = others.get(k);
            most = Math.max(most, Math.abs(a.getX() - b.getX()) + Math.abs(a.getY() - b.getY()));
            most = Math.max(most, Math.abs(a.getAngle() - b.getAngle()));
            most = Math.max(most, Math.abs(a.getVelocityX() - b.getVelocityX()));
            most = Math.max(most, Math.abs(a.getAngularVelocity() - b.getAngularVelocity()));
        }
        return most;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.4, 0.003})
    void anyForcesAreFollowedAsByTheGeneralCode(double mass) {
        assertThat(apart(driven(new DirectSolver(), 1.0 / 512, mass), driven(new GlobalSolver(), 1.0 / 512, mass)))
                .isLessThan(2e-9);
    }

    @Test
    void halvingTheStepDividesTheErrorBySixteen() {
        List<Body> exact = driven(new DirectSolver(), 1.0 / 1024, 0.4);
        double coarse = apart(driven(new DirectSolver(), 1.0 / 16, 0.4), exact);
        double fine = apart(driven(new DirectSolver(), 1.0 / 32, 0.4), exact);
        assertThat(coarse / fine).isBetween(12.0, 22.0);
    }
}
