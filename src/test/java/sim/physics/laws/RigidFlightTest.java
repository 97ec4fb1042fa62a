// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.Euler;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.Rattle;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.SymplecticEuler;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Bodies welded to one another fly as one: on a parabola, with an even spin, by closed form, whatever the method and the step. */
class RigidFlightTest {
    private static final double G = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final List<Body> parts = new ArrayList<>();
    private double mass;
    private double x;
    private double y;

    static Stream<Integrator> methods() {
        return Stream.of(
                new RungeKutta4(), new Euler(), new SymplecticEuler(), new Rattle(4), new DormandPrince853(1e-6),
                new GraggBulirschStoer(1e-6), new RadauIIA(1e-6), new Automatic(1e-6));
    }

    private Body part(Body body) {
        parts.add(engine.add(body));
        return body;
    }

    /** A foot, a bar and a ball, of unlike density; each is welded to each other, so that rows depend on one another. */
    private void thing(double atX, double atY) {
        Body foot = part(new Body(new Rectangle(1, 0.3)).at(atX, atY));
        Body bar = part(new Body(new Rectangle(0.3, 0.7)).at(atX + 0.35, atY + 0.5, 0.2));
        Body ball = part(new Body(new Circle(0.2)).at(atX - 0.6, atY + 0.1));
        ball.setMass(3);
        engine.add(new WeldJoint(foot, bar, atX, atY));
        engine.add(new WeldJoint(ball, foot, atX - 0.4, atY));
        engine.add(new WeldJoint(bar, ball, atX, atY + 0.2));
    }

    private void centre() {
        mass = parts.stream().mapToDouble(Body::getMass).sum();
        x = parts.stream().mapToDouble(b -> b.getMass() * b.getX()).sum() / mass;
        y = parts.stream().mapToDouble(b -> b.getMass() * b.getY()).sum() / mass;
    }

    private void launch(double vx, double vy, double spin) {
        centre();
        for (Body part : parts) {
            part.setVelocity(vx - spin * (part.getY() - y), vy + spin * (part.getX() - x));
            part.setAngularVelocity(spin);
        }
    }

    @ParameterizedTest
    @MethodSource("methods")
    void itIsWhereTheClosedFormHasIt(Integrator method) {
        engine.setIntegrator(method);
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -G));
        thing(2, 3);
        launch(1, 20, 50);
        double[][] starts = parts.stream().map(b -> new double[] {b.getX() - x, b.getY() - y, b.getAngle()}).toArray(double[][]::new);
        for (int k = 0; k < 240; k++) {
            engine.step();
        }
        double turn = 50 * 4.0;
        for (int k = 0; k < parts.size(); k++) {
            double[] start = starts[k];
            double px = x + 4 + Math.cos(turn) * start[0] - Math.sin(turn) * start[1];
            double py = y + 80 - 8 * G + Math.sin(turn) * start[0] + Math.cos(turn) * start[1];
            assertThat(parts.get(k).getX()).isEqualTo(px, within(1e-11));
            assertThat(parts.get(k).getY()).isEqualTo(py, within(1e-11));
            assertThat(parts.get(k).getAngle()).isEqualTo(start[2] + turn, within(1e-11));
            assertThat(parts.get(k).getAngularVelocity()).isEqualTo(50, within(1e-12));
        }
    }

    /** A corner of the spinning foot meets a wall where the closed form says so, in whatever part of a step. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0.1, 1 / 60.0})
    void itStrikesAWallWhenTheClosedFormDoes(double step) {
        engine.setTimeStep(step);
        thing(0, 0);
        launch(1.5, 0, 2);
        engine.add(Body.fixed(new Rectangle(2, 100)).at(11, 0));
        double[] starts = {parts.get(0).getX() - x, parts.get(0).getY() - y};
        double time = meeting(starts);
        double[] met = {0};
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public Decision colliding(Contact contact) {
                met[0] = met[0] == 0 ? contact.time() : met[0];
                return Decision.BOUNCE;
            }
        });
        for (int k = 0; k * step < 10 && met[0] == 0; k++) {
            engine.step();
        }
        assertThat(met[0]).isEqualTo(time, within(1e-6)); // paths of what is tied are found to a millionth of its size
        assertThat(engine.kineticEnergy()).isEqualTo(energy(1.5, 2), within(1e-12 * energy(1.5, 2)));
    }

    private double energy(double v, double spin) {
        centre();
        double inertia = 0;
        for (Body part : parts) {
            inertia += part.getInertia() + part.getMass() * (sq(part.getX() - x) + sq(part.getY() - y));
        }
        return 0.5 * mass * v * v + 0.5 * inertia * spin * spin;
    }

    private static double sq(double value) {
        return value * value;
    }

    /** The first time at which a corner of the foot or of the bar, or the ball, is at 10; all in the world of the start. */
    private double meeting(double[] start) {
        double step = 1e-4;
        double t = 0;
        while (reach(t) < 10) {
            t += step;
        }
        double low = t - step;
        double high = t;
        for (int k = 0; k < 80; k++) {
            double middle = 0.5 * (low + high);
            if (reach(middle) < 10) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return high;
    }

    private double reach(double t) {
        double cos = Math.cos(2 * t);
        double sin = Math.sin(2 * t);
        double most = x + 1.5 * t + cos * (-0.6 - x) - sin * (0.1 - y) + 0.2;
        for (int side = 0; side < 4; side++) {
            double a = (side & 1) == 0 ? 1 : -1;
            double b = (side & 2) == 0 ? 1 : -1;
            most = Math.max(most, x + 1.5 * t + cos * (0.5 * a - x) - sin * (0.15 * b - y));
            double rx = 0.35 + Math.cos(0.2) * 0.15 * a - Math.sin(0.2) * 0.35 * b;
            double ry = 0.5 + Math.sin(0.2) * 0.15 * a + Math.cos(0.2) * 0.35 * b;
            most = Math.max(most, x + 1.5 * t + cos * (rx - x) - sin * (ry - y));
        }
        return most;
    }

    /** A gas of welded things keeps its energy as one of single bodies does. */
    @Test
    void aGasOfThemKeepsItsEnergy() {
        engine.setTimeStep(1 / 60.0);
        SplittableRandom random = new SplittableRandom(3);
        for (int side = -1; side <= 1; side += 2) {
            engine.add(Body.fixed(new Rectangle(2, 30)).at(side * 9, 0));
            engine.add(Body.fixed(new Rectangle(30, 2)).at(0, side * 9));
        }
        for (int k = 0; k < 16; k++) {
            parts.clear();
            thing(-6 + 4 * (k % 4), -6 + 4 * (k / 4));
            launch(random.nextDouble() * 20 - 10, random.nextDouble() * 20 - 10, random.nextDouble() * 20 - 10);
        }
        double energy = engine.kineticEnergy();
        for (int k = 0; k < 3000; k++) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isGreaterThan(1000);
        assertThat(engine.kineticEnergy()).isEqualTo(energy, within(1e-11 * energy));
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-9);
        PhysicsEngine copy = Checkpoint.copy(engine);
        for (int k = 0; k < 60; k++) {
            engine.step();
            copy.step();
        }
        Checkpoint.assertSameBodies(engine, copy);
    }

    /** One that is pinned to the world is a pendulum, and what is welded to the world stays there. */
    @Test
    void whatIsPinnedOrWeldedToTheWorldIsNone() {
        engine.setTimeStep(0.01);
        engine.add(new Gravity(0, -G));
        thing(0, 0);
        centre();
        double height = y;
        Body held = engine.add(new Body(new Rectangle(1, 1)).at(20, 0));
        Body other = engine.add(new Body(new Rectangle(1, 1)).at(21, 0));
        engine.add(new WeldJoint(held, other, 20.5, 0));
        engine.add(new WeldJoint(other, null, 21, 0));
        engine.add(new PinJoint(parts.get(1), 0.35, 0.9));
        for (int k = 0; k < 100; k++) {
            engine.step();
        }
        assertThat(held.getX()).isEqualTo(20, within(1e-12));
        assertThat(held.getY()).isEqualTo(0, within(1e-12));
        centre();
        double motion = parts.stream().mapToDouble(RigidFlightTest::energy).sum();
        assertThat(motion + mass * G * (y - height)).isEqualTo(0, within(1e-6));
        assertThat(motion).isGreaterThan(0.1);
    }

    private static double energy(Body b) {
        return 0.5 * b.getMass() * (sq(b.getVelocityX()) + sq(b.getVelocityY())) + 0.5 * b.getInertia() * sq(b.getAngularVelocity());
    }
}
