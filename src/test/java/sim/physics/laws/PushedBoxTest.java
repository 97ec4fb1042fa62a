// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Spring;
import sim.physics.motion.SurfaceFriction;
import sim.physics.references.PushedBox;
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

    /** A force on a robot in every third second, from the first on. */
    private static final class Pulses implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final Body robot;
        private final double fx;

        Pulses(Body robot, double fx) {
            this.robot = robot;
            this.fx = fx;
        }

        @Override
        public boolean actsOn(Body body) {
            return body == robot;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, (long) time % 3 == 0 ? fx : 0, 0);
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

    /**
     * A row of boxes at rest sets off when its robot pushes more than static friction bears of all of them together, and then
     * goes on against kinetic friction; also if the robot has friction of its own.
     */
    @ParameterizedTest
    @CsvSource({"1, 0, 1.05", "1, 0.1, 1.05", "1, 0.1, 1.3", "2, 0, 0.95", "2, 0, 1.05", "5, 0, 0.95", "5, 0, 1.05", "12, 0, 1.05"})
    void aRowSetsOffBeyondItsStaticFriction(int boxes, double own, double share) {
        build(new Body(new Rectangle(1, 1)).at(1, 0), 1 / 60.0);
        robot.setSurfaceFriction(own);
        for (int k = 1; k < boxes; k++) {
            Body next = engine.add(new Body(new Rectangle(1, 1)).at(1 + k, 0));
            next.setMass(2);
            next.setSurfaceFriction(MU, 0.4);
            next.setRestitution(0);
        }
        double bears = own * 3 * G + boxes * 0.4 * 2 * G;
        run(200, own * 3 * G + 2, 0);
        assertThat(engine.kineticEnergy()).isLessThan(1e-12);
        run(120, share * bears, 0);
        double pull = share < 1 ? 0 : share * bears - own * 3 * G - boxes * MU * 2 * G;
        assertThat(robot.getVelocityX()).isCloseTo(2 * pull / (3 + 2 * boxes), within(1e-6));
        assertThat(box.getVelocityX()).isCloseTo(robot.getVelocityX(), within(1e-6));
    }

    /** A robot that its author's force lets stand for a while, together with the box, is pushed on by it later. */
    @Test
    void aForceThatReturnsIsFelt() {
        build(new Body(new Rectangle(1, 1)).at(1, 0), 1 / 60.0);
        robot.setSurfaceFriction(0.1);
        engine.add(new Pulses(robot, 14));
        run(150, 0, 0);
        assertThat(engine.kineticEnergy()).isZero();
        double x = box.getX();
        run(30 + 60, 0, 0);
        assertThat(box.getVelocityX()).isCloseTo((14 - 0.1 * 3 * G - MU * 2 * G) / 5, within(0.01));
        assertThat(box.getX() - x).isGreaterThan(0.1);
    }

    /** A spring between others that is added and removed while a robot pushes takes nothing from the box's friction. */
    @Test
    void frictionStaysWhereForcesAreCoupled() {
        build(new Body(new Rectangle(1, 1)).at(1, 0), 1 / 60.0);
        Body one = engine.add(new Body(new Circle(0.5)).at(0, 10));
        Body other = engine.add(new Body(new Circle(0.5)).at(3, 10));
        engine.add(new Thrust(robot, 14, 0));
        run(60, 0, 0);
        Spring spring = new Spring(one, 0, 0, other, 0, 0, 2, 5, 0);
        engine.add(spring);
        run(60, 0, 0);
        engine.remove(spring);
        run(60, 0, 0);
        assertThat(box.getVelocityX()).isCloseTo(3 * (14 - MU * 2 * G) / 5, within(0.01));
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
        double[] exact = new PushedBox(MU * G, 8, 0.15).solve(0.25, 4000);
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

    /** Twenty robots that push fifteen boxes between walls, as far as a step; they steer by where they are. */
    private static void steer(PhysicsEngine crowd, int from, int to) {
        for (int k = from; k < to; k++) {
            for (Body body : crowd.bodies()) {
                if (body.getMass() == 1) {
                    double round = 0.05 * (k / 20) + body.getY();
                    double fx = 8 * StrictMath.cos(round) - 4 * body.getX();
                    double fy = 8 * StrictMath.sin(round) - 4 * body.getY();
                    body.addForce(fx - 2 * body.getVelocityX(), fy - 2 * body.getVelocityY());
                }
            }
            crowd.step();
        }
    }

    private static PhysicsEngine crowd(int threads) {
        PhysicsEngine crowd = new PhysicsEngine();
        crowd.setTimeStep(0.02);
        crowd.setThreads(threads);
        crowd.add(new SurfaceFriction(G));
        for (int side = -1; side <= 1; side += 2) {
            crowd.add(Body.fixed(new Rectangle(8, 1)).at(0, 3.5 * side));
            crowd.add(Body.fixed(new Rectangle(1, 8)).at(3.5 * side, 0));
        }
        for (int k = 0; k < 35; k++) {
            boolean isBox = k % 7 % 2 == 1;
            Body body = crowd.add(new Body(isBox ? new Rectangle(0.5, 0.4) : new Circle(0.2)));
            body.at(0.9 * (k % 6) - 2.25, 0.9 * (k / 6) - 2.25, 0.3 * k);
            body.setMass(isBox ? 2 : 1);
            body.setSurfaceFriction(isBox ? 0.3 : 0.05 * (k % 3), isBox ? 0.4 : 0.05 * (k % 3));
            body.setFriction(0.3);
            body.setRestitution(0.2 * (k % 2));
        }
        return crowd;
    }

    /** A crowd that pushes goes on bit for bit from a checkpoint, whenever it is taken, and with any number of threads. */
    @Test
    void aCrowdGoesOnFromACheckpointBitForBit() {
        PhysicsEngine straight = crowd(1);
        PhysicsEngine shared = crowd(3);
        steer(straight, 0, 100);
        steer(shared, 0, 100);
        PhysicsEngine restored = Checkpoint.copy(straight);
        for (int k = 100; k < 160; k++) {
            steer(straight, k, k + 1);
            steer(shared, k, k + 1);
            restored = Checkpoint.copy(restored);
            steer(restored, k, k + 1);
            assertThat(Scenes.hash(restored)).isEqualTo(Scenes.hash(straight));
            assertThat(Scenes.hash(shared)).isEqualTo(Scenes.hash(straight));
        }
        assertThat(straight.getImpacts()).isEqualTo(restored.getImpacts()).isGreaterThan(100);
        assertThat(straight.contacts()).isNotEmpty();
    }
}
