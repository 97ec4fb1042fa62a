// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.KinematicBody;
import sim.physics.motion.Spring;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.ContactListener;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** A kinematic body that stands is a fixed body, until it moves. */
class StandingBodyTest {
    private static final double G = 9.81;

    private static PhysicsEngine engine(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(0, -G));
        return engine;
    }

    private static Body rough(Body body, double restitution) {
        body.setFriction(0.4);
        body.setRestitution(restitution);
        return body;
    }

    private static Body standing(boolean isKinematic, Shape shape) {
        return isKinematic ? new KinematicBody(shape) : Body.fixed(shape);
    }

    /** A box with a peg, in which bodies bounce, roll and pile up, and swing on pins and on springs, of which one is too stiff for substeps. */
    private static PhysicsEngine scene(long seed, int substeps, boolean isKinematic) {
        Random random = new Random(seed);
        double restitution = random.nextInt(3) / 2.0;
        PhysicsEngine engine = engine(substeps);
        engine.add(rough(standing(isKinematic, new Rectangle(8, 0.5)).at(0, -3), restitution));
        engine.add(rough(standing(isKinematic, new Rectangle(0.5, 8)).at(-4, 1), restitution));
        engine.add(rough(standing(isKinematic, new Rectangle(0.5, 8)).at(4, 1), restitution));
        Body peg = engine.add(rough(standing(isKinematic, new Circle(0.4)).at(0, -1), restitution));
        for (int k = 0; k < 10; k++) {
            Shape shape = k % 2 == 0 ? new Circle(0.25) : Polygon.regular(3 + k / 2, 0.3);
            Body body = new Body(shape).at(-3 + 0.7 * k, 0.5 + random.nextDouble()).moving(random.nextGaussian(), random.nextGaussian(), 1);
            engine.add(rough(body, restitution));
            if (k % 3 == 0) {
                engine.add(new PinJoint(peg, body, body.getX(), body.getY() + 1));
            } else if (k % 3 == 1 && k < 6) {
                engine.add(new Spring(peg, 0, 0.1, body, 0.1, 0, 2, substeps > 0 && k == 1 ? 2e4 : 20, 0.5));
            }
        }
        return engine;
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void doesWhatAFixedOneDoesToTheBit(int substeps) {
        for (int seed = 0; seed < 6; seed++) {
            PhysicsEngine kinematic = scene(seed, substeps, true);
            PhysicsEngine fixed = scene(seed, substeps, false);
            for (int k = 0; k < 150; k++) {
                kinematic.step();
                fixed.step();
            }
            for (int k = 0; k < fixed.bodies().size(); k++) {
                assertThat(kinematic.bodies().get(k).getX()).isEqualTo(fixed.bodies().get(k).getX());
                assertThat(kinematic.bodies().get(k).getVelocityY()).isEqualTo(fixed.bodies().get(k).getVelocityY());
                assertThat(kinematic.bodies().get(k).getAngle()).isEqualTo(fixed.bodies().get(k).getAngle());
            }
        }
    }

    /** A lift waits, rises, waits and sinks: what lies on it stays where it is on it, and no contact ends. */
    @ParameterizedTest
    @CsvSource({"0, 0, 1e-9", "0, 0.5, 1e-9", "4, 0, 2e-3", "4, 0.5, 2e-3"})
    void aLiftStopsAndStarts(int substeps, double restitution, double tolerance) {
        PhysicsEngine engine = engine(substeps);
        KinematicBody lift = new KinematicBody(new Rectangle(4, 0.2));
        engine.add(rough(lift, restitution));
        List<Body> load = new ArrayList<>();
        for (int k = 0; k < 4; k++) {
            Body box = new Body(new Rectangle(0.5, 0.5)).at(k < 3 ? -1 : 0.2, k < 3 ? 0.35 + 0.5 * k : 0.35);
            load.add(engine.add(rough(box, restitution)));
        }
        load.add(engine.add(rough(new Body(new Circle(0.25)).at(1.5, 0.35), restitution)));
        int[] told = new int[2];
        engine.addContactListener(new ContactListener() {
            @Override
            public void began(LastingContact contact) {
                told[0]++;
            }

            @Override
            public void ended(Body a, Body b) {
                told[1]++;
            }
        });
        int stood = 0;
        for (int k = 0; k < 480; k++) {
            int phase = k % 120; // 30 steps of waiting, 15 faster and faster, 30 evenly, 15 slower and slower, 30 of waiting
            double speed = 0.02 * Math.max(0, Math.min(15, Math.min(phase - 30, 90 - phase)));
            lift.setTargetVelocity(0, k / 120 % 2 == 0 ? speed : -speed, 0);
            engine.step();
            stood += lift.isImmobile() ? 1 : 0;
            for (int m = 0; m < load.size(); m++) {
                double height = m == 1 ? 0.85 : m == 2 ? 1.35 : 0.35;
                assertThat(load.get(m).getY() - lift.getY()).isCloseTo(height, within(tolerance));
                assertThat(load.get(m).getX()).isCloseTo(m < 3 ? -1 : m == 3 ? 0.2 : 1.5, within(tolerance));
            }
        }
        assertThat(told).containsExactly(5, 0);
        assertThat(stood).isGreaterThan(4 * 50);
        assertThat(lift.getY()).isCloseTo(0, within(1e-9));
    }

    /** A pivot that has moved and stands again: the pendulum goes on as on a fixed one. */
    @Test
    void aPivotStops() {
        PhysicsEngine engine = engine(0);
        KinematicBody pivot = new KinematicBody(new Circle(0.1));
        engine.add(pivot);
        Body first = engine.add(new Body(new Rectangle(1, 0.1)).at(0.5, 0));
        Body second = engine.add(new Body(new Rectangle(1, 0.1)).at(1.5, 0));
        engine.add(new PinJoint(pivot, first, 0, 0));
        engine.add(new PinJoint(first, second, 1, 0));
        for (int k = 0; k < 60; k++) {
            pivot.setTargetVelocity(k < 10 || k >= 40 ? 0 : 0.5, 0, 0);
            engine.step();
        }
        assertThat(pivot.getX()).isCloseTo(0.25, within(1e-11));
        assertThat(pivot.isImmobile()).isTrue();
        PhysicsEngine other = engine(0);
        Body fixed = other.add(Body.fixed(new Circle(0.1)).at(pivot.getX(), pivot.getY()));
        Body third = other.add(copy(first));
        Body fourth = other.add(copy(second));
        other.add(new PinJoint(fixed, third, pivot.getX(), pivot.getY()));
        other.add(new PinJoint(third, fourth, first.worldX(0.5, 0), first.worldY(0.5, 0)));
        for (int k = 0; k < 60; k++) {
            engine.step();
            other.step();
        }
        assertThat(second.getX()).isCloseTo(fourth.getX(), within(1e-9));
        assertThat(second.getY()).isCloseTo(fourth.getY(), within(1e-9));
        assertThat(second.getAngularVelocity()).isCloseTo(fourth.getAngularVelocity(), within(1e-8));
    }

    private static Body copy(Body of) {
        return new Body(of.getShape())
                .at(of.getX(), of.getY(), of.getAngle())
                .moving(of.getVelocityX(), of.getVelocityY(), of.getAngularVelocity());
    }

    /** A disc hangs on a spring behind a hook that stands, and then sets out with an even acceleration a: m y¨ = −k y − c y˙ − m a. */
    @ParameterizedTest
    @CsvSource({"0, 1e-7", "4, 1e-4"})
    void aHookPulls(int substeps, double tolerance) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.setTimeStepping(substeps);
        KinematicBody hook = new KinematicBody(new Circle(0.1));
        engine.add(hook);
        Body disc = engine.add(new Body(new Circle(0.3)).at(-2, 0));
        disc.setMass(2);
        engine.add(new Spring(hook, 0, 0, disc, 0, 0, 2, 30, 1));
        for (int k = 0; k < 20; k++) {
            engine.step();
        }
        for (int k = 1; k <= 60; k++) {
            hook.setTargetVelocity(3 * k / 60.0, 0, 0);
            engine.step();
        }
        double gamma = 1 / 4.0;
        double omega = Math.sqrt(15 - gamma * gamma);
        double swing = Math.exp(-gamma) * (Math.cos(omega) + gamma / omega * Math.sin(omega));
        assertThat(hook.getX()).isCloseTo(1.5, within(1e-11));
        assertThat(disc.getX()).isCloseTo(1.5 - 2 - 2 * 3 / 30.0 * (1 - swing), within(tolerance));
    }

    /** A floor that has slowed down and stands: a ball bounces on it as on a fixed one. */
    @ParameterizedTest
    @CsvSource({"0, 1e-12", "4, 1e-12"})
    void aFloorHasStopped(int substeps, double tolerance) {
        PhysicsEngine engine = engine(substeps);
        KinematicBody floor = new KinematicBody(new Rectangle(4, 0.2));
        engine.add(rough(floor, 0.7));
        Body ball = engine.add(rough(new Body(new Circle(0.25)).at(0, 1).moving(0.1, 0, 3), 0.7));
        for (int k = 0; k < 15; k++) {
            floor.setTargetVelocity(0, k < 10 ? 1.2 - 0.12 * (k + 1) : 0, 0);
            engine.step();
        }
        assertThat(floor.isImmobile()).isTrue();
        assertThat(engine.getImpacts()).isZero();
        PhysicsEngine other = engine(substeps);
        other.add(rough(Body.fixed(floor.getShape()).at(0, floor.getY()), 0.7));
        Body second = other.add(rough(copy(ball), 0.7));
        for (int k = 0; k < 200; k++) {
            engine.step();
            other.step();
            assertThat(ball.getX()).isCloseTo(second.getX(), within(tolerance));
            assertThat(ball.getY()).isCloseTo(second.getY(), within(tolerance));
        }
        assertThat(engine.getImpacts()).isEqualTo(other.getImpacts());
    }

    /** A gate stands until it is hit, and at that instant sets out. */
    @Test
    void aListenerSetsItGoing() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.25);
        KinematicBody gate = new KinematicBody(new Rectangle(0.2, 4));
        engine.add(gate);
        Body ball = engine.add(new Body(new Circle(0.4)).at(1.625, 0).moving(-1, 0)); // 1.125 of room: at the half of the fifth step
        engine.addListener(new CollisionListener() {
            @Override
            public void collided(Contact contact) {
                gate.setVelocity(-2, 0);
            }
        });
        for (int k = 0; k < 4; k++) {
            engine.step();
            assertThat(gate.isImmobile()).isTrue();
        }
        engine.step();
        assertThat(gate.isImmobile()).isFalse();
        assertThat(gate.getX()).isCloseTo(-2 * 0.125, within(1e-12));
        engine.step();
        assertThat(gate.getX()).isCloseTo(-2 * 0.375, within(1e-12));
        assertThat(ball.getVelocityX()).isCloseTo(1, within(1e-12));
    }

    /** It sets out by time stepping what it has borne by events, and the other way round. */
    @ParameterizedTest
    @CsvSource({"0, 4", "4, 0"})
    void setsOutByTheOtherMode(int before, int after) {
        PhysicsEngine engine = engine(before);
        KinematicBody floor = new KinematicBody(new Rectangle(8, 1));
        engine.add(rough(floor, 0));
        Body box = engine.add(rough(new Body(new Rectangle(1, 1)).at(0, 1), 0));
        for (int k = 0; k < 60; k++) {
            engine.step();
        }
        engine.setTimeStepping(after);
        for (int k = 1; k <= 60; k++) {
            floor.setTargetVelocity(k / 60.0, 0.5 * k / 60.0, 0);
            engine.step();
        }
        assertThat(floor.getX()).isCloseTo(0.5, within(1e-9));
        assertThat(box.getX()).isCloseTo(0.5, within(2e-3));
        assertThat(box.getY()).isCloseTo(1.25, within(2e-3));
        assertThat(box.getVelocityY()).isCloseTo(0.5, within(2e-3));
    }
}
