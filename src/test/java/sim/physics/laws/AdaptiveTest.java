// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.function.DoubleFunction;
import java.util.stream.Stream;
import org.hipparchus.special.elliptic.jacobi.JacobiEllipticBuilder;
import org.hipparchus.special.elliptic.legendre.LegendreEllipticIntegral;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.AdaptiveIntegrator;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Methods that take a tolerance in place of a step do what is asked of them. */
class AdaptiveTest {
    private static final double G = 9.81;

    static Stream<Arguments> methods() {
        DoubleFunction<AdaptiveIntegrator> dormandPrince = DormandPrince853::new;
        DoubleFunction<AdaptiveIntegrator> bulirschStoer = GraggBulirschStoer::new;
        return Stream.of(Arguments.of(dormandPrince), Arguments.of(bulirschStoer));
    }

    private static PhysicsEngine engine(AdaptiveIntegrator method, double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.setIntegrator(method);
        engine.add(new Gravity(0, -G));
        return engine;
    }

    private static Body rods(PhysicsEngine engine, int count) {
        return Scenes.rods(engine, count, 0);
    }

    private static double tipError(Body rod, double x, double y) {
        double tipX = rod.getX() + 0.5 * StrictMath.cos(rod.getAngle());
        double tipY = rod.getY() + 0.5 * StrictMath.sin(rod.getAngle());
        return StrictMath.hypot(tipX - x, tipY - y);
    }

    /** References of thirty digits, from another program. */
    @ParameterizedTest
    @MethodSource("methods")
    void theErrorIsAboutTheToleranceWhateverThatIs(DoubleFunction<AdaptiveIntegrator> method) {
        for (double tolerance = 1e-3; tolerance > 2e-13; tolerance /= 10) {
            PhysicsEngine engine = engine(method.apply(tolerance), 1);
            Body last = rods(engine, 10);
            engine.step();
            double error = tipError(last, 7.5272290155603557074, -4.9062623197150037263);
            assertThat(error / tolerance).as("tolerance %s", tolerance).isBetween(0.005, 10.0);
        }
    }

    @ParameterizedTest
    @MethodSource("methods")
    void thePublishedStepDoesNotMatter(DoubleFunction<AdaptiveIntegrator> method) {
        for (int steps : new int[] {1, 2, 7, 60, 1000}) {
            PhysicsEngine engine = engine(method.apply(1e-11), 1.0 / steps);
            Body last = rods(engine, 2);
            for (int k = 0; k < steps; k++) {
                engine.step();
            }
            assertThat(tipError(last, -1.662115135816127581, -1.04146663719322474)).isLessThan(2e-10);
        }
    }

    /** Angle from straight down of a rod let go from the horizontal. */
    private static double swing(double t) {
        double quarter = LegendreEllipticIntegral.bigK(0.5);
        double sn = JacobiEllipticBuilder.build(0.5)
                .valuesN(quarter - StrictMath.sqrt(1.5 * G) * t)
                .sn();
        return 2 * StrictMath.asin(StrictMath.sqrt(0.5) * sn);
    }

    @ParameterizedTest
    @MethodSource("methods")
    void elasticWallsDoNotCostAccuracy(DoubleFunction<AdaptiveIntegrator> method) {
        PhysicsEngine engine = engine(method.apply(1e-12), 0.9);
        Body rod = rods(engine, 1);
        rod.setCollisionGroup(1, -1);
        engine.add(Body.fixed(new Rectangle(1, 0.2)).at(-0.505, -0.6));
        double bottom = LegendreEllipticIntegral.bigK(0.5) / StrictMath.sqrt(1.5 * G);
        for (int k = 1; k <= 4; k++) {
            engine.step();
            double t = 0.9 * k;
            double sinceTop = t % (2 * bottom);
            assertThat(rod.getAngle() + StrictMath.PI / 2)
                    .as("after %d impacts", engine.getImpacts())
                    .isCloseTo(swing(Math.min(sinceTop, 2 * bottom - sinceTop)), within(1e-10));
        }
        assertThat(engine.getImpacts()).isEqualTo(4);
        assertThat(engine.getDeepestPenetration()).isGreaterThan(-1e-11);
    }

    @ParameterizedTest
    @MethodSource("methods")
    void fastBodiesDoNotTunnelInALongStep(DoubleFunction<AdaptiveIntegrator> method) {
        PhysicsEngine engine = engine(method.apply(1e-8), 10);
        Body anchor = engine.add(Body.fixed(new Circle(0.1)));
        Body ball = engine.add(new Body(new Circle(0.1)).at(1, 0).moving(0, 3));
        ball.setMass(1);
        engine.add(new Spring(anchor, 0, 0, ball, 0, 0, 1, 50, 0));
        Body wall = engine.add(Body.fixed(new Rectangle(40, 0.001)).at(0, -0.5));
        double energy = energy(ball);
        for (int k = 0; k < 20; k++) {
            engine.step();
            assertThat(ball.getY()).isGreaterThan(wall.getY());
        }
        assertThat(engine.getImpacts()).isGreaterThan(50);
        assertThat(energy(ball)).isCloseTo(energy, within(1e-4));
    }

    private static double energy(Body ball) {
        double stretch = StrictMath.hypot(ball.getX(), ball.getY()) - 1;
        return ball.kineticEnergy() + ball.getMass() * G * ball.getY() + 25 * stretch * stretch;
    }

    @ParameterizedTest
    @MethodSource("methods")
    void motorsReachTheirSpeedAtTheInstant(DoubleFunction<AdaptiveIntegrator> method) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setIntegrator(method.apply(1e-10));
        engine.setTimeStep(5);
        Body wheel = engine.add(new Body(new Circle(1)));
        engine.add(new PinJoint(wheel, 0, 0));
        engine.add(Motor.turning(wheel, null, 3, 2 * wheel.getInertia())); // 2 rad/time² up to 3 rad/time
        engine.step();
        assertThat(wheel.getAngularVelocity()).isCloseTo(3, within(1e-12));
        assertThat(wheel.getAngle()).isCloseTo(2.25 + 3.5 * 3, within(1e-8));
    }

    @Test
    void aToleranceThatIsNoneIsRefused() {
        assertThatThrownBy(() -> new DormandPrince853(0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("tolerance is 0.0");
        assertThatThrownBy(() -> new GraggBulirschStoer(Double.NaN))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("tolerance is NaN");
    }
}
