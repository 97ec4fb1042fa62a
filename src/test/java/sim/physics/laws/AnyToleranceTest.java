// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Curve;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.WireJoint;
import sim.physics.motion.AdaptiveIntegrator;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Gravity;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.Spring;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * Hard case K09: a method that chooses its steps ends in bounded work and throws nothing about, whatever the tolerance is, from
 * a hundred times the scene to far below rounding.
 */
class AnyToleranceTest {
    private static final double G = 9.81;

    /** A bead, in lengths of its rod. */
    private static final double TINY = 0x1p-20;

    /** Counts evaluations of the forces, and ends what does not end. */
    private static final class Count implements ForceGenerator {
        private static final long serialVersionUID = 1L;
        private final Body watched;
        private final long most;
        private long calls;

        Count(Body watched, long most) {
            this.watched = watched;
            this.most = most;
        }

        @Override
        public boolean actsOn(Body body) {
            return body == watched;
        }

        @Override
        public boolean isAutonomous() {
            return true;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            calls++;
            if (calls > most) {
                throw new AssertionError("more than " + most + " evaluations");
            }
        }
    }

    /** Of unit size: all lengths are in units of l, which is a power of four, so that times are powers of two. */
    private enum Scene {
        /** Ten rods let go from the side. */
        CHAIN {
            @Override
            void fill(PhysicsEngine engine, double l) {
                rods(engine, l, 10);
            }
        },
        /** Four rods, one of them light, and the last one spins. */
        SPUN {
            @Override
            void fill(PhysicsEngine engine, double l) {
                Body last = rods(engine, l, 4);
                engine.bodies().get(2).setMass(0.01, 0.01 * l * l / 12);
                last.setAngularVelocity(60 / Math.sqrt(l));
            }
        },
        /** Three tiny beads on rods. */
        BEADS {
            @Override
            void fill(PhysicsEngine engine, double l) {
                Body last = null;
                for (int k = 1; k <= 3; k++) {
                    Body bead = bead(engine, k * l, 0, l);
                    engine.add(new RodJoint(bead, k * l, 0, last, (k - 1) * l, 0));
                    last = bead;
                }
            }
        },
        /** A tiny bead on a round wire. */
        WIRE {
            @Override
            void fill(PhysicsEngine engine, double l) {
                engine.add(new WireJoint(bead(engine, l, 0, l), Curve.circle(0, 0, l)));
            }
        },
        FOUR_BAR {
            @Override
            void fill(PhysicsEngine engine, double l) {
                double w = 1 / Math.sqrt(l);
                Body left = bar(engine, 0, 0.5 * l, 0.01 * l, l);
                Body top = bar(engine, 0.5 * l, l, l, 0.01 * l);
                Body right = bar(engine, l, 0.5 * l, 0.01 * l, l);
                for (Body side : List.of(left, right)) {
                    side.setAngularVelocity(-w);
                    side.setVelocity(0.5 * w * l, 0);
                }
                top.setVelocity(w * l, 0);
                engine.add(new PinJoint(left, 0, 0));
                engine.add(new PinJoint(left, top, 0, l));
                engine.add(new PinJoint(top, right, l, l));
                engine.add(new PinJoint(right, l, 0));
            }
        },
        SPRING {
            @Override
            void fill(PhysicsEngine engine, double l) {
                Body body = bar(engine, l, 0.25 * l, l, 0.5 * l);
                engine.add(new Spring(body, 0.25 * l, 0.125 * l, null, 0, 0, l, 40 / l, 0));
            }
        },
        SLIDING {
            @Override
            void fill(PhysicsEngine engine, double l) {
                engine.add(new SurfaceFriction(G));
                Body body = bar(engine, 0, 0, l, 0.5 * l);
                body.setSurfaceFriction(0.3);
                body.setVelocity(3 * Math.sqrt(l), Math.sqrt(l));
                body.setAngularVelocity(2 / Math.sqrt(l));
            }
        };

        abstract void fill(PhysicsEngine engine, double l);

        private static Body bar(PhysicsEngine engine, double x, double y, double width, double height) {
            double l = Math.max(width, height);
            Body body = engine.add(new Body(new Rectangle(width, height)).at(x, y));
            body.setMass(1, l * l / 12);
            body.setCollisionGroup(1, 0);
            return body;
        }

        private static Body bead(PhysicsEngine engine, double x, double y, double l) {
            Body body = engine.add(new Body(new Circle(TINY * l)).at(x, y));
            body.setMass(1);
            body.setCollisionGroup(1, 0);
            return body;
        }

        private static Body rods(PhysicsEngine engine, double l, int count) {
            Body last = null;
            for (int k = 0; k < count; k++) {
                Body rod = bar(engine, (k + 0.5) * l, 0, l, 0.01 * l);
                engine.add(new PinJoint(last == null ? rod : last, last == null ? null : rod, k * l, 0));
                last = rod;
            }
            return last;
        }
    }

    private enum Method {
        DOP853,
        GBS,
        RADAU,
        AUTOMATIC;

        AdaptiveIntegrator of(double tolerance) {
            return switch (this) {
                case DOP853 -> new DormandPrince853(tolerance);
                case GBS -> new GraggBulirschStoer(tolerance);
                case RADAU -> new RadauIIA(tolerance);
                case AUTOMATIC -> new Automatic(tolerance);
            };
        }

        /** Evaluations for the time in which a scene moves once, at any tolerance. */
        long most() {
            return this == RADAU ? 40_000 : 20_000;
        }

        /** The finest tolerance for which there is time in a test, a power of ten. */
        int finest() {
            return this == RADAU ? -8 : -18;
        }
    }

    /** What a run took, and where it has led, in units of the scene. */
    private record Run(long evaluations, double x, double y, double energy) {}

    /**
     * Runs a scene.
     *
     * @param tolerance in lengths l of the scene
     * @param time in units of √(l / (1 length/time²))
     */
    private static Run run(Scene scene, Method method, double l, double tolerance, double time, int steps, long most) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(time * Math.sqrt(l) / steps);
        engine.setIntegrator(method.of(tolerance * l));
        scene.fill(engine, l);
        if (scene != Scene.SLIDING) {
            engine.add(new Gravity(0, -G));
        }
        Body last = engine.bodies().get(engine.bodies().size() - 1);
        Count count = new Count(last, most);
        engine.add(count);
        double kinetic = 0;
        for (int k = 0; k < steps; k++) {
            engine.step();
            double now = 0;
            for (Body body : engine.bodies()) {
                now += body.kineticEnergy() / l;
            }
            assertThat(now).as("kinetic energy").isFinite();
            kinetic = Math.max(kinetic, now);
        }
        return new Run(count.calls, last.getX() / l, last.getY() / l, kinetic);
    }

    /** All of the weight at rest at the bottom, and what the scene begins with, thrice. */
    private static double mostEnergy(Scene scene) {
        PhysicsEngine engine = new PhysicsEngine();
        scene.fill(engine, 1);
        double most = 0;
        for (Body body : engine.bodies()) {
            double fall = scene == Scene.SLIDING ? 0 : 2 * (Math.hypot(body.getX(), body.getY()) + 1);
            most += body.kineticEnergy() + body.getMass() * G * fall;
        }
        return 3 * most;
    }

    @ParameterizedTest
    @EnumSource(Scene.class)
    void workIsBoundedAtAnyToleranceAndScale(Scene scene) {
        for (Method method : Method.values()) {
            for (int power = 2; power >= method.finest(); power -= 2) {
                double tolerance = Math.pow(10, power);
                Run one = run(scene, method, 1, tolerance, 1, 4, method.most());
                assertThat(one.energy).as("%s at %s", method, tolerance).isLessThan(mostEnergy(scene));
                for (double l : new double[] {0x1p-20, 0x1p20}) {
                    if (method == Method.GBS) {
                        assertThat(run(scene, method, l, tolerance, 1, 4, method.most()))
                                .as("%s at %s in lengths of %s", method, tolerance, l)
                                .isEqualTo(one);
                    }
                }
            }
        }
    }

    /** What is wrong in each step by a part of what moves would in time give it any speed. */
    @ParameterizedTest
    @EnumSource(Scene.class)
    void aCoarseToleranceDoesNotWindAnythingUp(Scene scene) {
        for (Method method : Method.values()) {
            for (double tolerance : new double[] {100, 0.01}) {
                Run run = run(scene, method, 1, tolerance, 30, 100, method == Method.RADAU ? 200_000 : 100_000);
                assertThat(run.energy).as("%s at %s", method, tolerance).isLessThan(mostEnergy(scene));
            }
        }
    }

    /** Radau IIA would take some 10⁵ evaluations. */
    @ParameterizedTest
    @EnumSource(Scene.class)
    void belowRoundingNothingIsAskedFor(Scene scene) {
        for (Method method : List.of(Method.DOP853, Method.GBS, Method.AUTOMATIC)) {
            Run rounded = run(scene, method, 1, 0x1p-60, 1, 1, method.most());
            assertThat(run(scene, method, 1, 1e-300, 1, 1, method.most())).as("%s", method).isEqualTo(rounded);
        }
    }

    /** The case as it was found. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5})
    void tenRodsOfAMillimetre(double tolerance) {
        for (Method method : Method.values()) {
            long most = method == Method.RADAU ? 2000 : 200;
            Run run = run(Scene.CHAIN, method, 1.0 / 1024, 1024 * tolerance, 1, 1, most);
            assertThat(run.energy).isLessThan(mostEnergy(Scene.CHAIN));
        }
    }

    /** The same bound holds where the engine publishes often. */
    @Test
    void shortStepsOfTheEngineDoNotMatter() {
        for (Method method : Method.values()) {
            Run run = run(Scene.CHAIN, method, 1, 10, 1, 1000, method == Method.RADAU ? 4000 : 2000);
            assertThat(run.energy).isLessThan(mostEnergy(Scene.CHAIN));
        }
    }
}
