// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import sim.physics.motion.Body;
import sim.physics.shape.Rectangle;

/** J and J̇ẋ of every joint are the derivatives of its C, and those of a pin are the write-up's. */
class JacobianTest {
    private static final SplittableRandom RANDOM = new SplittableRandom(5);

    private static double random() {
        return RANDOM.nextDouble(-2, 2);
    }

    private static Body body() {
        return new Body(new Rectangle(2, 1)).at(random(), random(), random()).moving(random(), random(), random());
    }

    private static Curve parabola() {
        return (x, y, f) -> {
            f[0] = y - x * x;
            f[1] = -2 * x;
            f[2] = 1;
            f[3] = -2;
            f[4] = 0;
            f[5] = 0;
        };
    }

    static Stream<Constraint> joints() {
        return Stream.of(
                new PinJoint(body(), body(), random(), random()),
                new PinJoint(body(), 0.3, 0.4, body(), -0.5, 0.1),
                new PinJoint(body(), random(), random()),
                new RodJoint(body(), random(), random(), body(), random(), random()),
                new RodJoint(body(), 0.1, 0.2, body(), 0.3, -0.4, 2.5),
                new RodJoint(body(), 1, 2, null, 3, 4),
                new WeldJoint(body(), body(), random(), random()),
                new SliderJoint(body(), body(), random(), random(), 0.6, 1.8),
                new SliderJoint(body(), null, random(), random(), -1, 0.4),
                new SlotJoint(body(), body(), random(), random(), 0.6, 1.8),
                new SlotJoint(body(), null, random(), random(), -1, 0.4),
                new GearJoint(body(), body(), 2.5),
                PulleyJoint.bodyPoints(body(), 0.3, -0.2, 0.5, 3, body(), -0.7, 0.4, -1, 4, 2.5, 6),
                new WireJoint(body(), Curve.line(0, 0, 1, 1)),
                new WireJoint(body(), 0.4, -0.3, Curve.circle(0.5, -0.2, 1.5)),
                new WireJoint(body(), 0.2, 0.7, parabola()));
    }

    private static double[] positions(Constraint c) {
        Body a = c.getBodyA();
        Body b = c.getBodyB();
        return b == null
                ? new double[] {a.getX(), a.getY(), a.getAngle()}
                : new double[] {a.getX(), a.getY(), a.getAngle(), b.getX(), b.getY(), b.getAngle()};
    }

    private static double[] velocities(Constraint c) {
        Body a = c.getBodyA();
        Body b = c.getBodyB();
        return b == null
                ? new double[] {a.getVelocityX(), a.getVelocityY(), a.getAngularVelocity()}
                : new double[] {
                    a.getVelocityX(), a.getVelocityY(), a.getAngularVelocity(),
                    b.getVelocityX(), b.getVelocityY(), b.getAngularVelocity()
                };
    }

    private static double[] values(Constraint c, double[] x) {
        c.getBodyA().at(x[0], x[1], x[2]);
        if (c.getBodyB() != null) {
            c.getBodyB().at(x[3], x[4], x[5]);
        }
        Equations e = new Equations();
        c.evaluate(e);
        double[] values = new double[c.getRows()];
        for (int row = 0; row < values.length; row++) {
            values[row] = e.value(row);
        }
        return values;
    }

    @ParameterizedTest
    @MethodSource("joints")
    void jacobianIsTheDerivative(Constraint c) {
        double[] x = positions(c);
        Equations e = new Equations();
        c.evaluate(e);
        double h = 1e-6;
        for (int k = 0; k < x.length; k++) {
            double[] more = x.clone();
            double[] less = x.clone();
            more[k] += h;
            less[k] -= h;
            double[] up = values(c, more);
            double[] down = values(c, less);
            for (int row = 0; row < up.length; row++) {
                assertThat(e.jacobian(row, k)).isCloseTo((up[row] - down[row]) / (2 * h), within(1e-8));
            }
        }
    }

    @ParameterizedTest
    @MethodSource("joints")
    void curvatureIsTheSecondDerivativeAlongUniformMotion(Constraint c) {
        double[] x = positions(c);
        double[] v = velocities(c);
        Equations e = new Equations();
        c.evaluate(e);
        double h = 1e-4;
        double[] now = values(c, x);
        double[][] at = new double[2][];
        for (int side = 0; side < 2; side++) {
            double[] moved = x.clone();
            for (int k = 0; k < x.length; k++) {
                moved[k] += (side == 0 ? h : -h) * v[k];
            }
            at[side] = values(c, moved);
        }
        for (int row = 0; row < now.length; row++) {
            double second = (at[0][row] - 2 * now[row] + at[1][row]) / (h * h);
            assertThat(e.curvature(row)).isCloseTo(second, within(1e-5 * (1 + Math.abs(second))));
        }
    }

    @Test
    void thePinOfADoorIsTheWriteUps() {
        double thetaF = 0.3;
        double thetaD = 1.1;
        Body frame = new Body(new Rectangle(1, 1)).at(2, 3, thetaF).moving(0, 0, 0.7);
        Body door = new Body(new Rectangle(1, 1)).at(4, 5, thetaD).moving(0, 0, -0.4);
        double fx = 0.5;
        double fy = 0.2;
        double dx = -0.6;
        double dy = 0.1;
        Equations e = new Equations();
        new PinJoint(frame, fx, fy, door, dx, dy).evaluate(e);
        double[][] printed = {
            {1, 0, -fx * Math.sin(thetaF) - fy * Math.cos(thetaF), -1, 0, dx * Math.sin(thetaD) + dy * Math.cos(thetaD)},
            {0, 1, fx * Math.cos(thetaF) - fy * Math.sin(thetaF), 0, -1, -dx * Math.cos(thetaD) + dy * Math.sin(thetaD)}
        };
        double[] dotFrame = {
            (-fx * Math.cos(thetaF) + fy * Math.sin(thetaF)) * 0.7, (-fx * Math.sin(thetaF) - fy * Math.cos(thetaF)) * 0.7
        };
        double[] dotDoor = {
            (dx * Math.cos(thetaD) - dy * Math.sin(thetaD)) * -0.4, (dx * Math.sin(thetaD) + dy * Math.cos(thetaD)) * -0.4
        };
        for (int row = 0; row < 2; row++) {
            for (int k = 0; k < 6; k++) {
                assertThat(e.jacobian(row, k)).isCloseTo(printed[row][k], within(1e-15));
            }
            assertThat(e.curvature(row)).isCloseTo(dotFrame[row] * 0.7 + dotDoor[row] * -0.4, within(1e-15));
        }
    }
}
