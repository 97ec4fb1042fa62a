// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Gravity;
import sim.physics.motion.KinematicBody;
import sim.physics.motion.Spring;
import sim.physics.motion.SurfaceFriction;
import sim.physics.motion.ViscousFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Bodies that move as their author says: what they do to others, and that nothing is done to them. */
class KinematicBodyTest {
    private static final double G = 9.81;

    private static PhysicsEngine engine(double step, int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.setTimeStepping(substeps);
        return engine;
    }

    private static Body rough(Body body, double friction, double restitution) {
        body.setFriction(friction);
        body.setRestitution(restitution);
        return body;
    }

    private static void run(PhysicsEngine engine, int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    /** A ball between a wall and a piston that closes in: each hit of the piston adds twice its speed, at instants in closed form. */
    @ParameterizedTest
    @CsvSource({"0, 1e-9", "4, 1e-5"})
    void aPistonHeatsAGas(int substeps, double tolerance) {
        double u = 0.05;
        double x = 1;
        double v = 3;
        double t = 0;
        int hits = 0;
        for (double next; t + (next = v > 0 ? (2 - u * t - 0.1 - x) / (v + u) : (0.1 - x) / v) < 10; hits++) {
            t += next;
            x += v * next;
            v = v > 0 ? -v - 2 * u : -v;
        }
        PhysicsEngine engine = engine(1 / 64.0, substeps);
        engine.add(Body.fixed(new Rectangle(1, 4)).at(-0.5, 0));
        Body piston = engine.add(new KinematicBody(new Rectangle(1, 4)).at(2.5, 0).moving(-u, 0));
        Body ball = engine.add(new Body(new Circle(0.1)).at(1, 0).moving(3, 0));
        run(engine, 640);
        assertThat(engine.getImpacts()).isEqualTo(hits);
        assertThat(ball.getX()).isCloseTo(x + v * (10 - t), within(tolerance));
        assertThat(ball.getVelocityX()).isCloseTo(v, within(tolerance));
        assertThat(piston.getX()).isCloseTo(2.5 - 10 * u, within(1e-11));
        assertThat(engine.kineticEnergy()).isEqualTo(ball.kineticEnergy());
    }

    /** Einstein's lift: in one that falls upwards with a, all is as in a field that is stronger by a. */
    @ParameterizedTest
    @CsvSource({"0, 0.001, 1e-9", "8, 0.005, 1e-6"})
    void aChainInALift(int substeps, double step, double tolerance) {
        double a = 3;
        double b = 2;
        PhysicsEngine lift = engine(step, substeps);
        lift.add(new Gravity(0, -G));
        KinematicBody hook = new KinematicBody(new Circle(0.1));
        List<Body> moved = chain(lift, lift.add(hook));
        PhysicsEngine still = engine(step, substeps);
        still.add(new Gravity(-a, -G - b));
        Body fixed = still.add(Body.fixed(new Circle(0.1)));
        List<Body> hung = chain(still, fixed);
        for (int k = 1; k <= 1 / step; k++) {
            hook.setTargetVelocity(a * k * step, b * k * step, 0);
            lift.step();
            still.step();
        }
        assertThat(hook.getX()).isCloseTo(0.5 * a, within(1e-11));
        assertThat(hook.getY()).isCloseTo(0.5 * b, within(1e-11));
        for (int k = 0; k < moved.size(); k++) {
            assertThat(moved.get(k).getX() - hook.getX()).isCloseTo(hung.get(k).getX(), within(tolerance));
            assertThat(moved.get(k).getY() - hook.getY()).isCloseTo(hung.get(k).getY(), within(tolerance));
            assertThat(moved.get(k).getVelocityX() - hook.getVelocityX()).isCloseTo(hung.get(k).getVelocityX(), within(10 * tolerance));
        }
    }

    private static List<Body> chain(PhysicsEngine engine, Body hook) {
        Body first = engine.add(new Body(new Rectangle(1, 0.1)).at(0.5, 0));
        Body second = engine.add(new Body(new Rectangle(1, 0.1)).at(1.5, 0));
        engine.add(new PinJoint(hook, first, 0, 0));
        engine.add(new PinJoint(first, second, 1, 0));
        return List.of(first, second);
    }

    /**
     * A pendulum whose pivot is shaken stands upside down (Kapitza), against its equation (I + m d²) θ¨ = m d (g + ÿ) sin θ with the same
     * accelerations of the pivot: right to the order of the method, however light the rod is beside what nothing moves.
     */
    @Test
    void aPendulumUpsideDown() {
        double h = 1e-3;
        PhysicsEngine engine = engine(h, 0);
        engine.add(new Gravity(0, -G));
        KinematicBody pivot = new KinematicBody(new Circle(0.05));
        engine.add(pivot);
        Body rod = engine.add(new Body(new Rectangle(0.05, 1)).at(0.5 * StrictMath.sin(0.1), 0.5 * StrictMath.cos(0.1), -0.1));
        engine.add(new PinJoint(pivot, rod, 0, 0));
        double[] y = {0.1, 0};
        double arm = 0.5 / (rod.getInertia() / rod.getMass() + 0.25);
        double before = 0;
        double most = 0;
        for (int k = 1; k <= 2000; k++) {
            double now = 5 * StrictMath.sin(100 * k * h);
            pivot.setTargetVelocity(0, now, 0);
            engine.step();
            double pull = arm * (G + (now - before) / h);
            before = now;
            for (int m = 0; m < 20; m++) {
                rungeKutta(y, pull, h / 20);
            }
            most = Math.max(most, Math.abs(-rod.getAngle() - y[0]));
        }
        assertThat(most).isLessThan(1e-8);
        assertThat(Math.abs(y[0])).isLessThan(0.15); // it has not fallen over
    }

    private static void rungeKutta(double[] y, double pull, double h) {
        double k1 = pull * StrictMath.sin(y[0]);
        double k2 = pull * StrictMath.sin(y[0] + h / 2 * y[1]);
        double k3 = pull * StrictMath.sin(y[0] + h / 2 * (y[1] + h / 2 * k1));
        double k4 = pull * StrictMath.sin(y[0] + h * (y[1] + h / 2 * k2));
        y[0] += h * y[1] + h * h / 6 * (k1 + k2 + k3);
        y[1] += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }

    /** A rod on a pivot that goes on at any speed spins as on one that stands, for ever: nobody puts energy back that is lost beside that of the pivot. */
    @Test
    void aRodSpinsOnAPivotThatMoves() {
        PhysicsEngine engine = engine(0.01, 0);
        KinematicBody pivot = new KinematicBody(new Circle(0.05));
        engine.add(pivot.moving(7, 3));
        Body rod = engine.add(new Body(new Rectangle(1, 0.1)).at(0.5, 0).moving(7, 4, 2));
        engine.add(new PinJoint(pivot, rod, 0, 0));
        run(engine, 1000);
        assertThat(rod.getAngularVelocity()).isCloseTo(2, within(1e-8));
        assertThat(rod.getAngle()).isCloseTo(20, within(1e-7));
        assertThat(pivot.getX()).isCloseTo(70, within(1e-9));
    }

    /** What lies on a platform that is faster than friction lets it be stays behind by (a − μ g) t² / 2. */
    @ParameterizedTest
    @CsvSource({"0, 1e-6", "4, 2e-3"})
    void aBoxIsLeftBehind(int substeps, double tolerance) {
        PhysicsEngine engine = engine(0.01, substeps);
        engine.add(new Gravity(0, -G));
        KinematicBody platform = new KinematicBody(new Rectangle(10, 1));
        engine.add(rough(platform, 0.25, 0));
        Body box = engine.add(rough(new Body(new Rectangle(1, 1)).at(0, 1), 0.25, 0));
        run(engine, 1);
        for (int k = 1; k <= 100; k++) {
            platform.setTargetVelocity(4 * k * 0.01, 0, 0);
            engine.step();
        }
        assertThat(platform.getX()).isCloseTo(2, within(1e-11));
        assertThat(box.getX()).isCloseTo(0.5 * 0.25 * G, within(tolerance));
        assertThat(box.getVelocityX()).isCloseTo(0.25 * G, within(10 * tolerance));
        assertThat(box.getY()).isCloseTo(1, within(1e-4));
    }

    /** A lift that starts: the floor bears m (g + a), whatever bounces when it is dropped. */
    @ParameterizedTest
    @CsvSource({"0, 0, 1e-7", "0, 0.5, 1e-7", "0, 1, 1e-7", "4, 0, 1e-3", "4, 0.5, 1e-3"})
    void aLiftBears(int substeps, double restitution, double tolerance) {
        PhysicsEngine engine = engine(0.01, substeps);
        engine.add(new Gravity(0, -G));
        KinematicBody lift = new KinematicBody(new Rectangle(4, 1));
        engine.add(rough(lift, 0.5, restitution));
        Body box = engine.add(rough(new Body(new Rectangle(1, 1)).at(0.3, 1), 0.5, restitution));
        run(engine, 1);
        for (int k = 1; k <= 50; k++) {
            lift.setTargetVelocity(0, 2 * k * 0.01, 0);
            engine.step();
        }
        List<LastingContact> contacts = engine.contacts(box);
        assertThat(contacts).hasSize(1);
        assertThat(contacts.get(0).forceY(box)).isCloseTo(G + 2, within(tolerance * G));
        assertThat(box.getY() - lift.getY()).isCloseTo(1, within(1e-4));
        assertThat(box.getVelocityY()).isCloseTo(1, within(1e-4));
    }

    /** The velocity at the end of each step is that of the course, so the place is that of the trapezoidal rule: of second order, without a drift. */
    @Test
    void aCourseIsKept() {
        double before = Double.NaN;
        for (double step : new double[] {0.02, 0.01}) {
            PhysicsEngine engine = engine(step, 0);
            engine.add(new Gravity(0, -G));
            KinematicBody body = new KinematicBody(new Rectangle(1, 1));
            engine.add(body);
            double most = 0;
            for (int k = 1; k <= 100 / step; k++) {
                body.setTargetVelocity(StrictMath.cos(k * step), -2 * StrictMath.sin(2 * k * step), 0.5);
                if (k == 1) {
                    body.moving(1, 0, 0.5);
                    body.setTargetVelocity(StrictMath.cos(step), -2 * StrictMath.sin(2 * step), 0.5);
                }
                engine.step();
                most = Math.max(most, Math.abs(body.getX() - StrictMath.sin(k * step)));
                most = Math.max(most, Math.abs(body.getY() - (StrictMath.cos(2 * k * step) - 1)));
            }
            assertThat(most).isLessThan(step * step / 6 * 4.001);
            assertThat(body.getAngle()).isCloseTo(50, within(1e-10));
            assertThat(before / most).satisfiesAnyOf(r -> assertThat(r).isNaN(), r -> assertThat(r).isCloseTo(4, within(0.01)));
            before = most;
        }
    }

    /** What it misses where something strikes within a step, it makes up for. */
    @Test
    void itComesBackToItsCourse() {
        PhysicsEngine engine = engine(0.01, 0);
        engine.add(new Gravity(0, -G));
        KinematicBody sieve = new KinematicBody(new Rectangle(8, 0.5));
        engine.add(rough(sieve, 0.4, 0.5));
        for (int k = 0; k < 6; k++) {
            engine.add(rough(new Body(new Rectangle(0.5, 0.4)).at(-1.5 + 0.6 * k, 1 + 0.3 * k, 0.1 * k), 0.4, 0.5));
        }
        double place = 0;
        double before = 0;
        double most = 0;
        for (int k = 1; k <= 300; k++) {
            double now = 0.8 * StrictMath.sin(0.2 * Math.min(k, 250));
            sieve.setTargetVelocity(now, 0, 0);
            place += 0.01 * 0.5 * (before + now);
            before = now;
            engine.step();
            most = Math.max(most, Math.abs(sieve.getX() - place));
        }
        assertThat(most).isBetween(1e-5, 4.8e-3); // struck in the midst of steps, one after the other: some a h², which is up to 1.6e-3
        assertThat(sieve.getX()).isCloseTo(place, within(1e-9));
    }

    /** A ball a million times as heavy as the gate bounces off it as off a wall that moves; the gate goes on. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void nothingMovesIt(int substeps) {
        PhysicsEngine engine = engine(0.01, substeps);
        Body gate = engine.add(new KinematicBody(new Rectangle(0.2, 4)).moving(1, 0, 0));
        Body ball = engine.add(new Body(new Circle(0.5)).at(4, 0).moving(-99, 0));
        ball.setMass(1e6);
        engine.add(new Body(new Circle(0.1)).at(100, 100));
        run(engine, 100);
        double deflection = 200 * (substeps == 0 ? 0x1p-39 : 0x1p-29); // of one that is half as heavy as it may be
        assertThat(ball.getVelocityX()).isCloseTo(101, within(2 * deflection));
        assertThat(gate.getVelocityX()).isCloseTo(1, within(1e-12));
        assertThat(gate.getX()).isCloseTo(1, within(0.01 * deflection));
        assertThat(gate.getAngularVelocity()).isCloseTo(0, within(1e-12));
    }

    @Test
    void whatForcesActOnOthers() {
        PhysicsEngine engine = engine(0.01, 0);
        engine.add(new Gravity(1, -G));
        engine.add(new SurfaceFriction(G));
        engine.add(new ViscousFriction(3));
        KinematicBody body = new KinematicBody(new Rectangle(1, 1));
        engine.add(body.at(0, 5).moving(2, 1, 3));
        body.setSurfaceFriction(0.5);
        Body other = engine.add(new Body(new Circle(0.2)).at(0, 9));
        engine.add(new Spring(body, 0, 0, other, 0, 0, 1, 1e4, 10));
        run(engine, 100);
        assertThat(body.getVelocityX()).isCloseTo(2, within(1e-9));
        assertThat(body.getX()).isCloseTo(2, within(1e-9));
        assertThat(body.getY()).isCloseTo(6, within(1e-9));
        assertThat(body.getAngle()).isCloseTo(3, within(1e-9));
    }

    /** It goes through what nothing moves either. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void twoThatNothingMovesDoNotCollide(int substeps) {
        PhysicsEngine engine = engine(0.01, substeps);
        engine.add(Body.fixed(new Rectangle(1, 1)).at(3, 0));
        engine.add(new KinematicBody(new Rectangle(1, 1)).at(6, 0));
        Body body = engine.add(new KinematicBody(new Circle(0.5)).moving(8, 0));
        run(engine, 100);
        assertThat(body.getX()).isCloseTo(8, within(1e-12));
        assertThat(engine.getImpacts()).isZero();
        body.setPosition(3, 0);
        assertThat(engine.overlaps()).isEmpty();
        assertThat(engine.separate()).isZero();
    }

    @Test
    void whatItRefuses() {
        PhysicsEngine engine = new PhysicsEngine();
        KinematicBody body = new KinematicBody(new Circle(1));
        engine.add(body.at(0, 3).moving(1, 0));
        assertThat(body.getMass()).isInfinite();
        assertThat(body.getInertia()).isInfinite();
        assertThat(body.kineticEnergy()).isZero();
        assertThat(body.isFixed()).isFalse();
        assertThat(body.isDynamic()).isFalse();
        assertThatIllegalArgumentException().isThrownBy(() -> body.setMass(2)).withMessageContaining("a mass was given to a kinematic body");
        assertThatIllegalArgumentException().isThrownBy(() -> body.addForce(1, 0)).withMessageContaining("kinematic");
        assertThatIllegalArgumentException().isThrownBy(() -> body.addTorque(1)).withMessageContaining("kinematic");
        assertThatIllegalArgumentException().isThrownBy(() -> body.addImpulse(1, 0)).withMessageContaining("kinematic");
        assertThatIllegalArgumentException().isThrownBy(() -> body.addAngularImpulse(1)).withMessageContaining("kinematic");
        assertThatIllegalArgumentException().isThrownBy(() -> body.setTargetVelocity(Double.NaN, 0, 0)).withMessageContaining("vx");
        assertThatIllegalArgumentException().isThrownBy(() -> body.setTargetVelocity(1, 0, 1e200)).withMessageContaining("angular velocity");
        assertThat(body.getTargetVelocityX()).isEqualTo(1);
        Body wall = engine.add(Body.fixed(new Circle(1)));
        assertThatIllegalArgumentException().isThrownBy(() -> engine.add(new PinJoint(body, wall, 0, 0))).withMessageContaining("none of its bodies can move");
        assertThatIllegalArgumentException().isThrownBy(() -> engine.add(new PinJoint(body, 0, 0))).withMessageContaining("none of its bodies can move");
        assertThat(engine.allConstraints()).isEmpty();
    }

    /** What cannot get out of the way overlaps, and is not thrown about. */
    @ParameterizedTest
    @CsvSource({"0, false", "0, true", "4, false", "4, true"})
    void whatIsCrushed(int substeps, boolean isBox) {
        PhysicsEngine engine = engine(1 / 60.0, substeps);
        engine.add(rough(Body.fixed(new Rectangle(1, 4)).at(-0.5, 0), 0, 0));
        Body piston = engine.add(rough(new KinematicBody(new Rectangle(1, 4)).at(1.5, 0).moving(-0.5, 0), 0, 0));
        Shape shape = isBox ? new Rectangle(0.2, 0.2) : new Circle(0.1);
        Body body = engine.add(rough(new Body(shape).at(0.4, 0).moving(0.4, 0), 0, 0));
        double fastest = 0;
        for (int k = 0; k < 120; k++) {
            engine.step();
            fastest = Math.max(fastest, body.kineticEnergy());
        }
        assertThat(piston.getX()).isCloseTo(0.5, within(1e-6));
        assertThat(fastest).isLessThan(100 * body.getMass());
        assertThat(engine.getRelievedSteps() > 0).isEqualTo(substeps == 0);
    }

    /** What lies on one that stands sleeps, and wakes when it is to move. */
    @Test
    void sleepOnAPlatform() {
        PhysicsEngine engine = engine(1 / 60.0, 4);
        engine.add(new Gravity(0, -G));
        KinematicBody platform = new KinematicBody(new Rectangle(6, 1));
        engine.add(rough(platform, 0.5, 0));
        Body box = engine.add(rough(new Body(new Rectangle(1, 1)).at(0, 1.2), 0.5, 0));
        run(engine, 300);
        assertThat(engine.isAsleep(box)).isTrue();
        assertThat(platform.isImmobile()).isTrue();
        assertThat(platform.getY()).isCloseTo(0, within(1e-9));
        platform.setTargetVelocity(0.05, 0, 0);
        run(engine, 61);
        assertThat(engine.isAsleep(box)).isFalse();
        assertThat(box.getX()).isCloseTo(0.05, within(2e-3));
    }

    /** A listener turns a gate back at the instant of the hit. */
    @Test
    void aListenerSetsItsVelocity() {
        PhysicsEngine engine = engine(0.25, 0);
        engine.add(new Gravity(0, -G));
        KinematicBody gate = new KinematicBody(new Rectangle(0.2, 40));
        engine.add(gate.moving(1, 0));
        engine.add(new Body(new Circle(0.4)).at(1.625, 0)); // 1.125 of room: at the half of the fifth step
        engine.addListener(new CollisionListener() {
            @Override
            public void collided(Contact contact) {
                gate.setVelocity(-1, 0);
            }
        });
        run(engine, 8);
        assertThat(gate.getVelocityX()).isCloseTo(-1, within(1e-9));
        assertThat(gate.getVelocityY()).isCloseTo(0, within(1e-9));
        assertThat(gate.getX()).isCloseTo(1.125 - 0.875, within(1e-9));
    }

    private static PhysicsEngine stirred(int substeps, double length, double time) {
        PhysicsEngine engine = engine(time / 64, substeps);
        engine.add(new Gravity(0, -8 * length / (time * time)));
        engine.add(rough(Body.fixed(new Rectangle(8 * length, length)).at(0, -2.5 * length), 0.4, 0.3));
        KinematicBody stirrer = new KinematicBody(new Rectangle(3 * length, 0.4 * length));
        engine.add(rough(stirrer.moving(0, 0, 2 / time), 0.4, 0.3));
        for (int k = 0; k < 8; k++) {
            double x = (k % 4 - 1.5) * length;
            double y = (2 + k / 4) * length;
            Shape shape = k % 2 == 0 ? new Circle(0.3 * length) : new Rectangle(0.5 * length, 0.4 * length);
            engine.add(rough(new Body(shape).at(x, y), 0.4, 0.3));
        }
        return engine;
    }

    private static void stir(PhysicsEngine engine, int from, int to, double length, double time) {
        KinematicBody stirrer = (KinematicBody) engine.bodies().get(1);
        for (int k = from; k < to; k++) {
            stirrer.setTargetVelocity(StrictMath.cos(0.1 * k) * (length / time), 0, 2 / time);
            engine.step();
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aRunGoesOnAfterACheckpoint(int substeps) {
        PhysicsEngine engine = stirred(substeps, 1, 1);
        stir(engine, 0, 100, 1, 1);
        PhysicsEngine copy = Checkpoint.copy(engine);
        stir(engine, 100, 200, 1, 1);
        stir(copy, 100, 200, 1, 1);
        Checkpoint.assertSameBodies(engine, copy);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void unitsAreOnesOwn(int substeps) {
        PhysicsEngine engine = stirred(substeps, 1, 1);
        stir(engine, 0, 150, 1, 1);
        PhysicsEngine small = stirred(substeps, 0x1p-20, 0x1p-7);
        stir(small, 0, 150, 0x1p-20, 0x1p-7);
        for (int k = 0; k < engine.bodies().size(); k++) {
            assertThat(small.bodies().get(k).getX()).isEqualTo(0x1p-20 * engine.bodies().get(k).getX());
            assertThat(small.bodies().get(k).getAngularVelocity()).isEqualTo(0x1p7 * engine.bodies().get(k).getAngularVelocity());
        }
    }

    /** A step that an author's force has stopped is made again, and counts once. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aStepThatFails(int substeps) {
        PhysicsEngine engine = engine(0.01, substeps);
        KinematicBody body = new KinematicBody(new Circle(1));
        engine.add(body);
        engine.add(new Body(new Circle(1)).at(0, 9));
        boolean[] fails = {false};
        engine.add((ForceGenerator) (on, time, forces) -> {
            if (fails[0]) {
                fails[0] = false;
                throw new IllegalArgumentException("an author's mistake");
            }
            forces.add(on, 0, 1);
        });
        for (int k = 1; k <= 100; k++) {
            body.setTargetVelocity(0.01 * k, 0, 0);
            fails[0] = k == 50;
            if (k == 50) {
                assertThatIllegalArgumentException().isThrownBy(engine::step);
            }
            engine.step();
        }
        assertThat(body.getX()).isCloseTo(0.5, within(1e-10));
    }

    /** One that is taken out and put in again before the next step is one, not two. */
    @Test
    void itComesAgainAtOnce() {
        PhysicsEngine engine = engine(0.01, 0);
        KinematicBody body = new KinematicBody(new Circle(1));
        engine.add(body);
        engine.remove(body);
        engine.add(body);
        for (int k = 1; k <= 100; k++) {
            body.setTargetVelocity(0.01 * k, 0, 0);
            engine.step();
        }
        assertThat(body.getX()).isCloseTo(0.5, within(1e-12));
    }

    /** Takes one out and puts it in again, also into another engine. */
    @Test
    void itComesAndGoes() {
        PhysicsEngine engine = engine(0.01, 0);
        engine.add(new Gravity(0, -G));
        KinematicBody body = new KinematicBody(new Circle(1));
        engine.add(body.moving(1, 0));
        run(engine, 10);
        engine.remove(body);
        run(engine, 10);
        PhysicsEngine other = engine(0.02, 0);
        other.add(new Gravity(0, 5));
        other.add(body);
        run(other, 10);
        run(engine, 10);
        assertThat(body.getX()).isCloseTo(0.3, within(1e-12));
        assertThat(body.getY()).isCloseTo(0, within(1e-12));
    }
}
