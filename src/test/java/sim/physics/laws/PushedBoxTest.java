// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Boxes on a plane with friction, seen from above, that robots push: by applied forces, or by a generator of their author. */
class PushedBoxTest {
    private static final double G = 9.81;
    private static final double MU = 0.3;

    /** A constant force on robots. */
    private static final class Thrust implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final Body robot;
        private final double fx;
        private final double fy;

        Thrust(Body robot, double fx, double fy) {
            this.robot = robot;
            this.fx = fx;
            this.fy = fy;
        }

        @Override
        public boolean actsOn(Body body) {
            return body == robot;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, fx, fy);
        }
    }

    private PhysicsEngine engine = new PhysicsEngine();
    private Body robot;
    private Body box;

    private void build(Body pushed, double step) {
        engine.setTimeStep(step);
        engine.add(new SurfaceFriction(G));
        robot = engine.add(new Body(new Circle(0.5)));
        box = engine.add(pushed);
        robot.setMass(3);
        box.setMass(2);
        box.setSurfaceFriction(MU, 0.4);
        for (Body body : engine.bodies()) {
            body.setRestitution(0);
        }
    }

    private void run(int steps, double fx, double fy) {
        for (int k = 0; k < steps; k++) {
            robot.addForce(fx, fy);
            engine.step();
        }
    }

    /** Below the threshold of static friction, be it beyond that of kinetic friction, a box at rest does not move by a bit. */
    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.9, 0.999})
    void aPushThatStaticFrictionBearsMovesNothing(double share) {
        build(new Body(new Rectangle(1, 1)).at(1, 0), 1 / 60.0);
        double push = share * 0.4 * 2 * G;
        run(60, 0.5 * push, 0); // at their first touch the box slides a little
        double x = box.getX();
        double y = robot.getX();
        run(240, push, 0);
        assertThat(box.getX()).isEqualTo(x).isCloseTo(1, within(1e-3));
        assertThat(robot.getX()).isCloseTo(y, within(1e-9));
        assertThat(box.getVelocityX()).isZero();
        assertThat(engine.contacts(box)).hasSize(1);
        assertThat(engine.contacts(box).get(0).normalForce()).isCloseTo(push, within(1e-9 * push));
    }

    /** Beyond it the two go on together with (F − μ m g) / (m₁ + m₂), whatever way they are pushed. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aStrongPushAcceleratesBoth(boolean byGenerator) {
        double c = 0.8;
        double s = 0.6;
        build(new Body(new Circle(0.5)).at(c, s), 1 / 60.0);
        double push = 12;
        double f = push * (byGenerator ? 0 : 1);
        if (byGenerator) {
            engine.add(new Thrust(robot, push * c, push * s));
        }
        run(120, f * c, f * s);
        double along = c * box.getVelocityX() + s * box.getVelocityY();
        long impacts = engine.getImpacts();
        run(120, f * c, f * s);
        double gained = c * box.getVelocityX() + s * box.getVelocityY() - along;
        assertThat(gained / 2).isCloseTo((push - MU * 2 * G) / 5, within(1e-9));
        assertThat(c * box.getVelocityY() - s * box.getVelocityX()).isCloseTo(0, within(1e-9));
        assertThat(Math.hypot(box.getX() - robot.getX(), box.getY() - robot.getY())).isCloseTo(1, within(1e-6));
        assertThat(engine.getImpacts()).isEqualTo(impacts);
    }

    /** When the push ends, the two slide apart and the box stops where Coulomb friction lets it: v² / 2 μ g. */
    @Test
    void aBoxThatIsLetGoStopsByItself() {
        build(new Body(new Rectangle(1, 1)).at(1, 0), 1 / 60.0);
        run(90, 20, 0);
        double x = box.getX();
        double v = box.getVelocityX();
        robot.setVelocity(-1, 0);
        run(200, 0, 0);
        assertThat(box.getX() - x).isCloseTo(v * v / (2 * MU * G), within(1e-6));
        assertThat(box.getVelocityX()).isZero();
    }

    /** A box between a robot and a wall stays where it is, and both contacts bear something. */
    @Test
    void aBoxIsPressedAgainstAWall() {
        build(new Body(new Rectangle(1, 1)).at(1, 0), 1 / 60.0);
        engine.add(Body.fixed(new Rectangle(1, 10)).at(2, 0)).setRestitution(0);
        run(100, 50, 0);
        double x = box.getX();
        run(100, 50, 0);
        assertThat(box.getX()).isEqualTo(x).isCloseTo(1, within(1e-6));
        assertThat(engine.kineticEnergy()).isLessThan(1e-11);
        run(100, 0, 0);
        assertThat(engine.kineticEnergy()).isLessThan(1e-11);
        run(100, -5, 0);
        assertThat(robot.getX()).isLessThan(-1);
        assertThat(box.getX()).isCloseTo(x, within(1e-9));
    }

    /** Friction never gives energy: what robots put in is more than what the bodies have. */
    @Test
    void workIsNeverLessThanTheEnergyGained() {
        build(new Body(new Rectangle(1, 0.6)).at(1.1, 0.2, 0.4), 1 / 60.0);
        double work = 0;
        for (int k = 0; k < 600; k++) {
            double fx = 15 * StrictMath.cos(0.02 * k);
            double fy = 15 * StrictMath.sin(0.02 * k);
            double x = robot.getX();
            double y = robot.getY();
            robot.addForce(fx, fy);
            engine.step();
            work += fx * (robot.getX() - x) + fy * (robot.getY() - y);
            assertThat(engine.kineticEnergy()).isLessThan(work + 1e-9);
        }
    }

    /**
     * A robot pushes a sliding box beside its middle, and slides along it: of first order, beside an integration of the
     * equations of motion with the constraint that they touch.
     */
    @Test
    void pushingBesideTheMiddleIsOfFirstOrder() {
        double[] exact = new PushedBoxReference(MU * G, 8, 0.15).solve(0.25, 4000);
        double last = 0;
        for (int n = 16; n <= 128; n *= 2) {
            engine = new PhysicsEngine();
            build(new Body(new Rectangle(1, 1)).at(1, 0).moving(1, 0), 0.25 / n);
            robot.setPosition(0, 0.15);
            robot.setVelocity(1, 0);
            run(n, 8, 0);
            double error = Math.hypot(box.getX() - exact[0], box.getY() - exact[1]) + Math.abs(box.getAngle() - exact[2])
                    + Math.hypot(robot.getX() - exact[3], robot.getY() - exact[4]);
            assertThat(error).isLessThan(0.1 / n);
            if (n > 16) {
                assertThat(last / error).as("steps %d", n).isBetween(1.6, 4.6);
            }
            last = error;
        }
    }
}
