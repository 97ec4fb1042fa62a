// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Equations;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Integrator;
import sim.physics.motion.RungeKutta4;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Forces that are applied to jointed bodies in each step, as agents do that steer robots. */
class PushedTiesTest {
    /** Keeps the heights of two bodies the same, and counts how often it is asked. */
    private static final class Level implements Constraint {
        private static final long serialVersionUID = 1L;

        private final Body a;
        private final Body b;
        private int evaluations;

        private Level(Body a, Body b) {
            this.a = a;
            this.b = b;
        }

        @Override
        public Body getBodyA() {
            return a;
        }

        @Override
        public Body getBodyB() {
            return b;
        }

        @Override
        public int getRows() {
            return 1;
        }

        @Override
        public void evaluate(Equations equations) {
            evaluations++;
            equations.set(0, a.getY() - b.getY(), 0);
            equations.setA(0, 0, 1, 0);
            equations.setB(0, 0, -1, 0);
        }
    }

    /** The force of which a body gets the one half applied, or from here. */
    private static final class Wind implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final Body body;
        private double push;

        private Wind(Body body) {
            this.body = body;
        }

        @Override
        public boolean actsOn(Body other) {
            return other == body;
        }

        @Override
        public void addForce(Body other, double time, Forces forces) {
            forces.add(other, push, 0.5 * push);
        }
    }

    private static double force(int step) {
        return Math.sin(0.1 * step) + 0.25;
    }

    /** A force that is written opens no joint, so there is nothing to close. */
    @Test
    void anAppliedForceCostsNoMoreEvaluationsThanAGenerators() {
        int[] evaluations = new int[2];
        for (int way = 0; way < 2; way++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1 / 60.0);
            Body a = engine.add(new Body(new Circle(0.2)).at(0, 0));
            Body b = engine.add(new Body(new Circle(0.2)).at(3, 0));
            Level level = engine.add(new Level(a, b));
            Wind wind = new Wind(a);
            engine.add(wind);
            engine.step();
            level.evaluations = 0;
            for (int k = 1; k <= 60; k++) {
                if (way == 0) {
                    a.addForce(force(k), 0.5 * force(k));
                } else {
                    wind.push = force(k);
                }
                engine.step();
            }
            assertThat(a.getY()).isNotZero();
            evaluations[way] = level.evaluations;
        }
        assertThat(evaluations[0]).isEqualTo(evaluations[1]);
    }

    private static Body robot(PhysicsEngine engine, double x, int wheels) {
        Body robot = engine.add(new Body(new Circle(0.25)).at(x, 0));
        robot.setMass(3, 0.1);
        for (int k = 0; k < wheels; k++) {
            double y = k == 0 ? 0.2 : -0.2;
            Body wheel = engine.add(new Body(new Rectangle(0.1, 0.03)).at(x, y));
            wheel.setMass(0.008, 1e-5);
            wheel.setCollisionGroup(2, 0);
            engine.add(new PinJoint(robot, wheel, x, y));
        }
        return robot;
    }

    @ParameterizedTest
    @CsvSource({"1, 240", "2, 240"})
    void robotsGoWhereAGeneratorWouldDriveThem(int wheels, int steps) {
        List<List<Double>> places = new ArrayList<>();
        for (int way = 0; way < 2; way++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1 / 60.0);
            Body robot = robot(engine, 0, wheels);
            Wind wind = new Wind(robot);
            engine.add(wind);
            for (int k = 0; k < steps; k++) {
                if (way == 0) {
                    robot.addForce(force(k), 0.5 * force(k));
                } else {
                    wind.push = force(k);
                }
                engine.step();
            }
            List<Double> all = new ArrayList<>();
            for (Body body : engine.bodies()) {
                all.add(body.getX());
                all.add(body.getY());
                all.add(body.getAngle());
            }
            places.add(all);
        }
        assertThat(places.get(0).get(0)).isGreaterThan(0.1);
        for (int k = 0; k < places.get(0).size(); k++) {
            assertThat(places.get(0).get(k)).isCloseTo(places.get(1).get(k), within(1e-12));
        }
    }

    private static Integrator method(String name) {
        return switch (name) {
            case "DOP853" -> new DormandPrince853(1e-9);
            case "GBS" -> new GraggBulirschStoer(1e-9);
            default -> new RungeKutta4();
        };
    }

    /** Methods whose steps go beyond the engine's must not take the force along. */
    @ParameterizedTest
    @ValueSource(strings = {"RK4", "DOP853", "GBS"})
    void anAppliedForceGivesItsImpulseInOneStepAndNoMore(String method) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.setIntegrator(method(method));
        robot(engine, 0, 2);
        double given = 0;
        for (int k = 0; k < 40; k++) {
            if (k % 7 == 3 || k % 7 == 4) {
                engine.bodies().get(0).addForceAt(2, 1, 0.1, 0.3);
                given += 2 / 60.0;
            }
            engine.step();
            double momentum = 0;
            for (Body body : engine.bodies()) {
                momentum += body.getMass() * body.getVelocityX();
            }
            assertThat(momentum).isCloseTo(given, within(1e-9));
        }
    }

    /** Whatever is written beside a force, in whatever order, is seen. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void jointsOfBodiesThatAreSetAndPushedClose(boolean isPushedFirst) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1e-9);
        Body robot = robot(engine, 0, 2);
        engine.step();
        if (isPushedFirst) {
            robot.addForce(1, 0);
        }
        robot.setVelocity(0.3, 0);
        robot.setPosition(0.01, 0);
        if (!isPushedFirst) {
            robot.addForce(1, 0);
        }
        engine.step();
        Body wheel = engine.bodies().get(1);
        double pinX = robot.getX() - 0.2 * Math.sin(robot.getAngle());
        double slip = robot.getVelocityX() - 0.2 * robot.getAngularVelocity() - wheel.getVelocityX();
        assertThat(wheel.getX()).isCloseTo(pinX, within(1e-9));
        assertThat(wheel.getX()).isGreaterThan(0.005);
        assertThat(slip).isCloseTo(0, within(1e-9));
    }

    /** Two discs that part are tied between steps, and pushed by next to nothing before or after; or somebody asks what overlaps. */
    private static double[] tied(int substeps, String joint, String deed) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.1);
        engine.setTimeStepping(substeps);
        Body a = engine.add(new Body(new Circle(0.5)).moving(1, 0));
        Body b = engine.add(new Body(new Circle(0.5)).at(1.5, 0).moving(-1, 0.5));
        engine.step();
        for (Body body : List.of(a, b)) {
            body.addForce(deed.equals("before") ? 1e-13 : 0, 0);
        }
        engine.add(switch (joint) {
            case "weld" -> new WeldJoint(a, b, 0.7, 0);
            case "pin" -> new PinJoint(a, b, 0.7, 0);
            default -> new RodJoint(a, a.getX(), a.getY(), b, b.getX(), b.getY());
        });
        for (Body body : List.of(a, b)) {
            body.addForce(deed.equals("after") ? 1e-13 : 0, 0);
        }
        if (deed.equals("asked")) {
            engine.overlaps();
        }
        engine.step();
        return new double[] {a.getX(), a.getY(), b.getX(), b.getY(), engine.kineticEnergy()};
    }

    /**
     * Velocities that a new joint does not allow are changed when it begins to act, whether its bodies are pushed or not: a step that was begun
     * with them left a hundredth of the energy too much, and 10⁻³ m under time stepping; asking for overlaps mended it.
     */
    @ParameterizedTest
    @CsvSource({"0, weld", "0, pin", "0, rod", "4, weld", "4, pin", "4, rod"})
    void aJointBetweenPushedBodiesIsClosedAsBetweenOthers(int substeps, String joint) {
        double[] expected = tied(substeps, joint, "none");
        for (String deed : List.of("before", "after", "asked")) {
            double[] actual = tied(substeps, joint, deed);
            for (int k = 0; k < expected.length; k++) {
                assertThat(actual[k]).as(deed).isCloseTo(expected[k], within(1e-9)); // what is not pushed keeps its energy to rounding
            }
        }
    }
}
