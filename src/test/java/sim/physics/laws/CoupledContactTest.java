// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.Spring;
import sim.physics.motion.SurfaceFriction;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Bodies that springs couple lie on the ground as others do. */
class CoupledContactTest {
    private static final double G = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final List<Body> bodies = new ArrayList<>();
    private final List<Spring> springs = new ArrayList<>();

    private void ground(double friction) {
        engine.add(new Gravity(0, -G));
        engine.add(Body.fixed(new Rectangle(60, 1)).at(0, -0.5)).setFriction(friction);
    }

    private Body add(Body body, double friction) {
        body.setFriction(friction);
        body.setRestitution(0);
        bodies.add(body);
        return body;
    }

    /** Two bars on a wheel each, whose bodies may be added by turns, and with a spring between them that has next to no force. */
    private static double[] carts(Integrator method, boolean isDriven, boolean isRough, boolean isMixed, boolean isCoupled) {
        CoupledContactTest run = new CoupledContactTest();
        run.engine.setTimeStep(1 / 60.0);
        run.engine.setIntegrator(method);
        run.ground(0.8);
        if (isRough) {
            run.engine.add(new SurfaceFriction(1));
        }
        for (double x = 0; x <= 4; x += 4) {
            run.add(new Body(new Rectangle(1, 0.2)).at(x, 0.5), 0.8);
            run.add(new Body(new Circle(0.25)).at(x + 0.5, 0.3), 0.8);
        }
        for (int k : isMixed ? new int[] {0, 2, 1, 3} : new int[] {0, 1, 2, 3}) {
            run.engine.add(run.bodies.get(k)).setSurfaceFriction(0.5);
        }
        for (int k = 0; k < 4; k += 2) {
            run.engine.add(new PinJoint(run.bodies.get(k), run.bodies.get(k + 1), 2 * k + 0.5, 0.3));
            if (isDriven) {
                run.engine.add(Motor.turning(run.bodies.get(k + 1), run.bodies.get(k), -4 - k, 0.3));
            }
        }
        if (isCoupled) {
            run.engine.add(new Spring(run.bodies.get(0), 0, 0, run.bodies.get(2), 0, 0, 4, 1e-13, 0));
        }
        for (int k = 0; k < 120; k++) {
            run.engine.step();
        }
        assertThat(run.engine.contacts()).isNotEmpty();
        return run.places();
    }

    private double[] places() {
        return bodies.stream().flatMapToDouble(body -> DoubleStream.of(body.getX(), body.getY(), body.getAngle())).toArray();
    }

    static Stream<Integrator> methods() {
        return Stream.of(new RungeKutta4(), new RadauIIA(1e-6));
    }

    /** A spring without force changes nothing, and neither does the order in which machines are put together. It had: 0.8 m in 2 s. */
    @ParameterizedTest
    @MethodSource("methods")
    void aSpringWithoutForceChangesNothing(Integrator method) {
        for (boolean isDriven : new boolean[] {false, true}) {
            for (boolean isRough : new boolean[] {false, true}) {
                double[] alone = carts(method, isDriven, isRough, false, false);
                for (boolean isMixed : new boolean[] {false, true}) {
                    assertThat(carts(method, isDriven, isRough, isMixed, true)).containsExactly(alone, within(isDriven ? 3e-3 : 1e-4));
                }
            }
        }
    }

    /** A square net of springs and dampers that falls askew. */
    private void net(int size, boolean areRound, double friction, double restitution) {
        ground(friction);
        double cos = StrictMath.cos(0.2);
        double sin = StrictMath.sin(0.2);
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                Body body = areRound ? new Body(new Circle(0.2)) : new Body(new Rectangle(0.4, 0.4));
                body.at(i * cos - j * sin, 1 + i * sin + j * cos, areRound ? 0 : 0.2).setMass(1);
                engine.add(add(body, friction)).setRestitution(restitution);
            }
        }
        int[][] sides = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
        for (int k = 0; k < size * size; k++) {
            for (int[] side : sides) {
                int i = k / size + side[0];
                int j = k % size + side[1];
                if (i < size && j >= 0 && j < size) {
                    double apart = Math.sqrt(side[0] * side[0] + side[1] * side[1]);
                    springs.add(engine.add(new Spring(bodies.get(k), 0, 0, bodies.get(i * size + j), 0, 0, apart, 2000, 5)));
                }
            }
        }
    }

    private static double[] fallen(int size, boolean areRound, double friction, int parts) {
        CoupledContactTest run = new CoupledContactTest();
        run.net(size, areRound, friction, 0);
        run.engine.setTimeStep(1 / (120.0 * parts));
        for (int k = 0; k < 90 * parts; k++) {
            run.engine.step();
        }
        assertThat(run.engine.getImpacts()).isLessThan(40);
        return run.places();
    }

    /** Places after a net has come down, against steps of a 32nd; they were off by 0.2 m, after up to 10,000 impacts. */
    @ParameterizedTest
    @CsvSource({"2, true, 0", "2, true, 0.6", "2, false, 0", "2, false, 0.6", "3, true, 0.6", "3, false, 0.6"})
    void netsOfSpringsComeDown(int size, boolean areRound, double friction) {
        assertThat(fallen(size, areRound, friction, 1)).containsExactly(fallen(size, areRound, friction, 32), within(0.02));
    }

    private double energy() {
        double sum = engine.kineticEnergy() + springs.stream().mapToDouble(Spring::energy).sum();
        return sum + bodies.stream().mapToDouble(body -> body.getMass() * G * body.getY()).sum();
    }

    /** Contacts give no energy: discs on a smooth ground had been pressed off it by ever more in one step. */
    @ParameterizedTest
    @CsvSource({"3, true, 0", "5, true, 0", "3, false, 0", "3, true, 0.6", "4, false, 0.6"})
    void netsGainNothing(int size, boolean areRound, double friction) {
        net(size, areRound, friction, 0.2);
        engine.setTimeStep(1 / 120.0);
        double last = energy();
        for (int k = 0; k < 480; k++) {
            engine.step();
            double now = energy();
            assertThat(now - last).as("step %s", k).isLessThan(1e-4 * now);
            last = now;
        }
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-7);
    }

    /** What lies presses with its weight. */
    @ParameterizedTest
    @CsvSource({"2, true", "2, false", "3, false"})
    void netsLieStill(int size, boolean areRound) {
        net(size, areRound, 0.6, 0);
        engine.setTimeStep(1 / 120.0);
        for (int k = 0; k < 3600; k++) {
            engine.step();
        }
        long impacts = engine.getImpacts();
        double force = 0;
        for (int k = 0; k < 60; k++) {
            engine.step();
            force += engine.contacts().stream().mapToDouble(LastingContact::normalForce).sum() / 60;
        }
        assertThat(engine.getImpacts()).isEqualTo(impacts);
        assertThat(force).isCloseTo(size * size * G, within(1e-2 * size * size * G));
    }
}
