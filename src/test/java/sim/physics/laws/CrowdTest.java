// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.SurfaceFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * Robots that push boxes about on a plane with friction, as controllers that are evolved do: seen from above, 20 robots and
 * 15 boxes between four walls. Limits of time are only there to fail where a step would never end.
 */
class CrowdTest {
    private static final double SIDE = 8;

    /** A disc that heads for changing directions, by forces that its author applies anew in each step. */
    private static final class Wanderer extends Body {
        private static final long serialVersionUID = 1L;

        private final transient SplittableRandom random;
        private double heading;
        private double speed;
        private int left;

        Wanderer(long seed) {
            super(new Circle(0.2));
            setMass(3);
            random = new SplittableRandom(seed);
        }

        void decide() {
            if (--left <= 0) {
                left = 30 + random.nextInt(120);
                heading = random.nextDouble() * 2 * Math.PI;
                speed = random.nextDouble();
            }
            double error = heading - getAngle();
            error -= 2 * Math.PI * Math.rint(error / (2 * Math.PI));
            double c = StrictMath.cos(getAngle());
            double s = StrictMath.sin(getAngle());
            addForce(20 * (speed * c - getVelocityX()), 20 * (speed * s - getVelocityY()));
            addTorque(0.5 * error - 0.2 * getAngularVelocity());
        }
    }

    private final PhysicsEngine engine = new PhysicsEngine();
    private final List<Wanderer> robots = new ArrayList<>();
    private final List<Body> all = new ArrayList<>();

    /** Four walls around a square. */
    private void walls(double side) {
        for (int end = 0; end < 2; end++) {
            engine.add(Body.fixed(new Rectangle(1, side + 2)).at(end * (side + 1) - 0.5, side / 2));
            engine.add(Body.fixed(new Rectangle(side + 2, 1)).at(side / 2, end * (side + 1) - 0.5));
        }
    }

    private void build(long seed, double restitution) {
        engine.setTimeStep(1.0 / 60);
        engine.add(new SurfaceFriction(9.81));
        walls(SIDE);
        SplittableRandom random = new SplittableRandom(seed);
        for (int k = 0; k < 35; k++) {
            Body body;
            if (k < 20) {
                robots.add(new Wanderer(random.nextLong()));
                body = robots.get(k);
            } else {
                body = new Body(new Rectangle(0.6, 0.4));
                body.setMass(2);
                body.setSurfaceFriction(0.4, 0.5);
            }
            body.setRestitution(restitution);
            body.setFriction(0.2);
            body.setPosition(1 + k % 7 + 0.2 * random.nextDouble(), 1 + k / 7 * 1.4 + 0.2 * random.nextDouble());
            body.setAngle(6 * random.nextDouble());
            all.add(engine.add(body));
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 0", "2, 0", "3, 0.1", "4, 0.1", "5, 0.5", "6, 1"})
    void theStepsEndAndNobodyGetsThroughAnything(long seed, double restitution) {
        build(seed, restitution);
        assertTimeoutPreemptively(Duration.ofSeconds(120), () -> {
            for (int k = 0; k < 400; k++) {
                robots.forEach(Wanderer::decide);
                engine.step();
            }
        });
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-4);
        for (Body body : all) {
            assertThat(body.getX()).isBetween(0.19, SIDE - 0.19);
            assertThat(body.getY()).isBetween(0.19, SIDE - 0.19);
            assertThat(Math.hypot(body.getVelocityX(), body.getVelocityY())).isLessThan(3);
        }
    }

    @Test
    void aBodyThatHardlySlidesStandsStill() {
        engine.setTimeStep(1);
        engine.add(new SurfaceFriction(9.81));
        engine.add(Body.fixed(new Rectangle(1, 10)).at(2, 0));
        engine.add(new Body(new Circle(0.5)).at(0.4, 0).moving(1, 0));
        Body puck = engine.add(new Body(new Rectangle(1, 1)).at(0, 20));
        puck.setSurfaceFriction(0.5);
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public void collided(Contact contact) {
                puck.setVelocity(1e-25, 0); // its way to rest takes less time than the clock can tell
            }
        });
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> engine.step());
        assertThat(puck.getVelocityX()).isZero();
        assertThat(puck.getX()).isZero();
    }

    @Test
    void aDiscThatIsPushedAgainstAWallInEachStepDoesNotBounceAgainInEach() {
        engine.setTimeStep(1.0 / 60);
        engine.add(Body.fixed(new Rectangle(1, 100)).at(1.5, 0));
        Body disc = engine.add(new Body(new Circle(0.5)).at(0.5, 0));
        disc.setRestitution(0.5);
        disc.setMass(2);
        for (int k = 0; k < 100; k++) {
            disc.addForce(3, 1);
            engine.step();
        }
        assertThat(engine.getImpacts()).isLessThan(60); // of the first step
        assertThat(disc.getX()).isCloseTo(0.5, within(1e-12));
        assertThat(disc.getVelocityY()).isCloseTo(0.5 * 100 / 60, within(1e-12));
        for (int k = 0; k < 60; k++) {
            disc.addForce(-2, 0);
            engine.step();
        }
        assertThat(disc.getVelocityX()).isCloseTo(-1, within(1e-12));
    }

    /** Discs that a generator drives, and boxes, all put anywhere, one into the other, without friction on the plane. */
    @ParameterizedTest
    @CsvSource({"0, 0", "1, 0", "2, 0", "3, 9.81", "4, 9.81"})
    void stepsEndWhereBodiesAreJammedIntoOneAnother(long seed, double gravity) {
        SplittableRandom random = new SplittableRandom(seed);
        engine.setTimeStep(0.02);
        engine.add(new Gravity(0, -gravity));
        walls(4);
        for (int k = 0; k < 24; k++) {
            Body body = new Body(k < 8 ? new Circle(0.2) : new Rectangle(0.3 + 0.3 * random.nextDouble(), 0.3));
            body.setMass(1 + k % 2);
            body.setFriction(0.3);
            body.setRestitution(0.2 * (k % 2));
            all.add(engine.add(body.at(
                    0.4 + 3.2 * random.nextDouble(), 0.4 + 3.2 * random.nextDouble(), 6 * random.nextDouble())));
        }
        engine.add(new ForceGenerator() {
            private static final long serialVersionUID = 1L;

            @Override
            public boolean actsOn(Body body) {
                return body.getShape() instanceof Circle;
            }

            @Override
            public void addForce(Body body, double time, Forces forces) {
                double heading = body.getMass() * Math.floor(time);
                forces.add(
                        body,
                        8 * StrictMath.cos(heading) - 2 * body.getVelocityX(),
                        8 * StrictMath.sin(heading) - 2 * body.getVelocityY());
            }
        });
        assertTimeoutPreemptively(Duration.ofSeconds(60), () -> {
            for (int k = 0; k < 150; k++) {
                engine.step();
            }
        });
        for (Body body : all) {
            assertThat(Math.hypot(body.getVelocityX(), body.getVelocityY())).isLessThan(20);
        }
    }
}
