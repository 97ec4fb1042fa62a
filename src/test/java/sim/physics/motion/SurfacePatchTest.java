// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Stream;
import org.hipparchus.ode.ODEState;
import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.hipparchus.ode.nonstiff.DormandPrince853Integrator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Friction of flat bodies on a plane is the mean over their area, and holds the loads inside its limit surface. */
class SurfacePatchTest {
    private static final double R = 0.1;

    static Stream<Shape> shapes() {
        return Stream.of(
                new Circle(0.3),
                new Rectangle(1, 1),
                new Rectangle(3, 1),
                new Rectangle(40, 1),
                new Rectangle(1, 1e-4),
                new Polygon(0, 0, 3, 0, 1, 2),
                new Polygon(0, 0, 1, 0.4, 0.3, 0.121),
                Polygon.regular(5, 2),
                Polygon.regular(64, 0.01),
                Compound.outline(0, 0, 4, 0, 4, 1, 1, 1, 1, 3, 0, 3),
                robot());
    }

    private static Compound robot() {
        return new Compound(Compound.disc(0, 0, 0.6), Compound.box(0.9, 0.35, 0.8, 0.15), Compound.box(0.9, -0.35, 0.8, 0.15));
    }

    private static double[] friction(Shape shape, double vx, double vy, double omega, double theta) {
        double[] out = {Double.NaN, Double.NaN, Double.NaN};
        SurfacePatch.of(shape).friction(vx, vy, omega, theta, out);
        return out;
    }

    private static void assertClose(double[] actual, double[] expected, double size, double tolerance) {
        assertThat(actual[0]).isCloseTo(expected[0], within(tolerance));
        assertThat(actual[1]).isCloseTo(expected[1], within(tolerance));
        assertThat(actual[2]).isCloseTo(expected[2], within(tolerance * size));
    }

    @Test
    void frictionIsTheMeanOverTheArea() {
        Shape[] shapes = {
            new Circle(0.3),
            new Rectangle(1, 1),
            new Rectangle(3, 1),
            new Polygon(0, 0, 3, 0, 1, 2),
            new Rectangle(1, 0.01),
            Compound.outline(0, 0, 4, 0, 4, 1, 1, 1, 1, 3, 0, 3),
            robot()
        };
        Random random = new Random(1);
        for (Shape shape : shapes) {
            double size = shape.boundingRadius();
            for (double distance : new double[] {0, 0.2, 0.7, 1, 3, 15, 17, 500}) {
                double angle = 2 * Math.PI * random.nextDouble();
                double vx = distance * size * Math.cos(angle);
                double vy = distance * size * Math.sin(angle);
                double omega = random.nextBoolean() ? 1 : -1;
                double[] expected = AreaMean.frictionOfParts(shape, vx, vy, omega);
                assertClose(friction(shape, vx, vy, omega, 0), expected, size, 2e-11);
            }
        }
    }

    @Test
    void aSlendersFrictionIsThatOfARod() {
        // rod along x: the mean of (v + ω x ŷ) / |v + ω x ŷ| has a closed form; a width of 1e-9 hardly changes it
        for (double vx : new double[] {0.01, 0.3, 2}) {
            for (double vy : new double[] {0, 0.2, 0.9, 5}) {
                double low = vy - 0.5;
                double high = vy + 0.5;
                double rise = Math.hypot(vx, high) - Math.hypot(vx, low);
                double asinh = Math.log((high + Math.hypot(vx, high)) / (low + Math.hypot(vx, low)));
                double second = (high * Math.hypot(vx, high) - low * Math.hypot(vx, low) - vx * vx * asinh) / 2;
                double[] expected = {-vx * asinh, -rise, -(second - vy * rise)};
                assertClose(friction(new Rectangle(1, 1e-9), vx, vy, 1, 0), expected, 1, 3e-9);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void pureSlidingIsOpposedExactly(Shape shape) {
        assertSame(friction(shape, 1, 0, 0, 0.7), -1, 0, 0);
        assertSame(friction(shape, 0, -1e-9, 0, 0.7), 0, 1, 0);
        assertSame(friction(shape, 3, 4, 0, 0.7), -0.6, -0.8, 0);
        assertSame(friction(shape, 0, 0, 0, 0.7), 0, 0, 0);
    }

    /** Exactly, but for the sign of 0. */
    private static void assertSame(double[] actual, double... expected) {
        for (int k = 0; k < expected.length; k++) {
            assertThat(actual[k] + 0.0).isEqualTo(expected[k] + 0.0);
        }
    }

    @Test
    void theDiscsLimits() {
        for (double e : new double[] {1e-12, 1e-9, 1e-5}) {
            // F = ε (1 − ε²/8 …), T = ⅔ R (1 − ¾ ε² …);  F = 1 − 1/(8ε²) …, T = R / (4ε) (1 + 1/(12ε²) …)
            double[] slow = friction(new Circle(R), e * R, 0, 1, 0);
            assertThat(slow[0] / -e).isCloseTo(1 - e * e / 8, within(1e-15));
            assertThat(slow[2] / R).isCloseTo(-2.0 / 3 * (1 - 0.75 * e * e), within(1e-15));
            double[] fast = friction(new Circle(R), 0, R / e, -1, 0);
            assertThat(fast[1]).isCloseTo(-1 + e * e / 8, within(1e-15));
            assertThat(fast[2] / (R * e)).isCloseTo(0.25 + e * e / 48, within(1e-15));
        }
        double[] equal = friction(new Circle(R), R, 0, 1, 0);
        assertThat(equal[0]).isCloseTo(-8 / (3 * Math.PI), within(1e-15));
        assertThat(equal[2]).isCloseTo(-8 / (9 * Math.PI) * R, within(1e-16));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.9, 1.1, 4})
    void theDiscFollowsTheEllipticIntegrals(double e) {
        double m = e < 1 ? e * e : 1 / (e * e);
        DoubleUnaryOperator root = a -> Math.sqrt(1 - m * Math.sin(a) * Math.sin(a));
        double first = AreaMean.integral(a -> 1 / root.applyAsDouble(a), 0, Math.PI / 2);
        double second = AreaMean.integral(root, 0, Math.PI / 2);
        double force = e < 1
                ? ((1 + m) * second - (1 - m) * first) / e
                : (1 + 1 / m) * second - (1 / m - 1) * first;
        double torque = e < 1
                ? (4 - 2 * m) * second - (1 - m) * first
                : e * ((4 - 2 / m) * second + (2 / m - 5 + 3 * m) * first);
        double[] out = friction(new Circle(R), 0, e * R, 1, 0);
        assertThat(out[1]).isCloseTo(-4 / (3 * Math.PI) * force, within(1e-13));
        assertThat(out[2] / R).isCloseTo(-4 / (9 * Math.PI) * torque, within(2e-12));
    }

    @Test
    void aSpinningPuckStopsWhereFarkasSays() {
        double push = 0.3 * 9.81;
        SurfacePatch disc = SurfacePatch.of(new Circle(R));
        double[] f = new double[3];
        // y: v, ω, time, distance; the variable is ∫ dt / |motion|, in which the motion dies away exponentially
        OrdinaryDifferentialEquation equation = new OrdinaryDifferentialEquation() {
            @Override
            public int getDimension() {
                return 4;
            }

            @Override
            public double[] computeDerivatives(double s, double[] y) {
                double motion = Math.hypot(y[0], R * y[1]);
                disc.friction(y[0], 0, y[1], 0, f);
                return new double[] {push * f[0] * motion, 2 * push * f[2] / (R * R) * motion, motion, y[0] * motion};
            }
        };
        double[] y = new DormandPrince853Integrator(1e-12, 1, 1e-30, 1e-13)
                .integrate(equation, new ODEState(0, new double[] {1, 10, 0, 0}), 14)
                .getPrimaryState();
        assertThat(y[2]).isCloseTo(0.45541905610, within(1e-10));
        assertThat(y[3]).isCloseTo(0.2165807761242, within(1e-11));
        assertThat(y[0] / (R * y[1])).isCloseTo(0.6530017892, within(1e-8));
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void turningTheWorldTurnsTheForce(Shape shape) {
        double[] a = friction(shape, 0.3, -0.2, 0.8, 0.4);
        double[] b = friction(shape, 0.2, 0.3, 0.8, 0.4 + Math.PI / 2);
        assertClose(b, new double[] {-a[1], a[0], a[2]}, shape.boundingRadius(), 2e-12);
        double[] back = friction(shape, -0.3, 0.2, -0.8, 0.4);
        assertSame(back, -a[0], -a[1], -a[2]);
    }

    @Test
    void symmetricShapes() {
        double[] a = friction(new Rectangle(1, 1), 0.3, -0.2, 0.8, 0.4);
        double[] turned = friction(new Rectangle(1, 1), 0.3, -0.2, 0.8, 0.4 + Math.PI / 2);
        assertClose(turned, a, 1, 1e-15);
        double[] b = friction(new Rectangle(3, 1), 0.3, -0.2, 0.8, 0.4);
        double[] mirrored = friction(new Rectangle(3, 1), 0.3, 0.2, -0.8, -0.4);
        assertClose(mirrored, new double[] {b[0], -b[1], -b[2]}, 1, 1e-15);
        assertThat(friction(new Rectangle(3, 1), 0, 0, 1, 0)[0]).isCloseTo(0, within(1e-16));
        assertThat(friction(Polygon.regular(5, 1), 0, 0, 1, 0)[0]).isCloseTo(0, within(1e-15));
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void frictionTakesPowerAndDependsOnTheDirectionOfMotionOnly(Shape shape) {
        Random random = new Random(2);
        SurfacePatch patch = SurfacePatch.of(shape);
        double[] one = new double[3];
        double[] other = new double[3];
        for (int k = 0; k < 1000; k++) {
            double vx = random.nextGaussian();
            double vy = random.nextGaussian();
            double omega = random.nextGaussian() * Math.exp(5 * random.nextGaussian()) / shape.boundingRadius();
            double theta = 3 * random.nextGaussian();
            patch.friction(vx, vy, omega, theta, one);
            double speed = Math.hypot(vx, vy);
            assertThat(one[0] * vx + one[1] * vy + one[2] * omega).isLessThan(-speed * (1 - 1e-12));
            assertThat(Math.hypot(one[0], one[1])).isLessThan(1 + 1e-12);
            for (int power : new int[] {-900, -500, -3, 7, 400, 900}) {
                patch.friction(
                        Math.scalb(vx, power), Math.scalb(vy, power), Math.scalb(omega, power), theta, other);
                assertThat(other).containsExactly(one);
            }
            patch.friction(3 * vx, 3 * vy, 3 * omega, theta, other);
            assertClose(other, one, shape.boundingRadius(), 1e-11);
        }
    }

    @Test
    void lengthsInOtherUnits() {
        double[] a = friction(new Polygon(0, 0, 3, 0, 1, 2), 0.3, 0.7, 0.2, 0.4);
        double s = 0x1p-20;
        double[] b = friction(new Polygon(0, 0, 3 * s, 0, s, 2 * s), 0.3 * s, 0.7 * s, 0.2, 0.4);
        assertThat(b).containsExactly(a[0], a[1], s * a[2]);
    }

    @Test
    void aRegular64GonIsNearlyADisc() {
        for (double v : new double[] {0, 0.5, 0.98, 2, 30}) {
            double[] disc = friction(new Circle(1), v, 0, 1, 0);
            assertClose(friction(Polygon.regular(64, 1), v, 0, 1, 0.1), disc, 1, 2e-3);
            assertClose(friction(Polygon.regular(4096, 1), v, 0, 1, 0.1), disc, 1, 5e-7);
        }
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void noJumpsWhereTheMethodChanges(Shape shape) {
        double size = shape.boundingRadius();
        Random random = new Random(4);
        for (int k = 0; k < 300; k++) {
            double angle = 2 * Math.PI * random.nextDouble();
            double distance = size * (k % 3 == 0 ? 1 : k % 3 == 1 ? 16 : Math.pow(16, random.nextDouble()));
            double near = distance * (1 - 1e-14);
            double far = distance * (1 + 1e-14);
            double[] a = friction(shape, near * Math.cos(angle), near * Math.sin(angle), 1, 0.3);
            double[] b = friction(shape, far * Math.cos(angle), far * Math.sin(angle), 1, 0.3);
            assertClose(a, b, size, 2e-12);
        }
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void centresOnVerticesAndEdges(Shape shape) {
        for (int k = 0; k < shape.vertexCount(); k++) {
            int next = (k + 1) % shape.vertexCount();
            double mx = 0.5 * (shape.vertexX(k) + shape.vertexX(next));
            double my = 0.5 * (shape.vertexY(k) + shape.vertexY(next));
            for (double t : new double[] {0, 0.5, 1, 1.5}) {
                double x = mx + t * (shape.vertexX(k) - mx);
                double y = my + t * (shape.vertexY(k) - my);
                double[] at = friction(shape, y, -x, 1, 0);
                double[] beside = friction(shape, y * (1 + 1e-13), -x * (1 + 1e-13), 1, 0);
                assertClose(at, beside, shape.boundingRadius(), 1e-8 * (shape instanceof Rectangle ? 1 : 1e-1));
            }
        }
    }

    @Test
    void degenerateNumbersStayNumbers() {
        Shape[] shapes = {
            new Circle(1e-3), new Rectangle(1e-3, 2e-3), new Rectangle(1, 1e-12), new Rectangle(1, 1e-300)
        };
        double[][] motions = {{1e-310, 0, 0}, {0, 0, 1e-310}, {1e300, 1e300, -1e305}, {1e-300, 0, 1}, {1, 1, 1e-320}};
        for (Shape shape : shapes) {
            for (double[] v : motions) {
                double[] f = friction(shape, v[0], v[1], v[2], 0.3);
                assertThat(Math.hypot(f[0], f[1])).isLessThanOrEqualTo(1 + 1e-12);
                assertThat(Math.abs(f[2])).isLessThanOrEqualTo(shape.boundingRadius());
                assertThat(f[0] * v[0] + f[1] * v[1] + f[2] * v[2]).isNotPositive();
            }
        }
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void holdsUpToTheLimitOfForce(Shape shape) {
        SurfacePatch patch = SurfacePatch.of(shape);
        assertThat(patch.holds(7, 0, 0, 0.3, 7)).isTrue();
        assertThat(patch.holds(7 * (1 - 1e-9) * 0.6, 7 * (1 - 1e-9) * 0.8, 0, 0.3, 7)).isTrue();
        assertThat(patch.holds(7 * (1 + 1e-9) * 0.6, 7 * (1 + 1e-9) * 0.8, 0, 0.3, 7)).isFalse();
        assertThat(patch.holds(7, 0, 7e-4 * shape.boundingRadius(), 0.3, 7)).isFalse();
        assertThat(patch.holds(0, 0, 0, 0.3, 7)).isTrue();
        assertThat(patch.holds(0, 0, 0, 0.3, 0)).isTrue();
        assertThat(patch.holds(1e-300, 0, 0, 0.3, 0)).isFalse();
        assertThat(patch.holds(0, 0, 1e-300, 0.3, 0)).isFalse();
        assertThat(patch.holds(Double.NaN, 0, 0, 0.3, 7)).isFalse();
        assertThat(patch.holds(0, 0, Double.NaN, 0.3, 7)).isFalse();
    }

    @Test
    void holdsUpToTheLimitOfTorque() {
        double ofSquare = (Math.sqrt(2) + Math.log(1 + Math.sqrt(2))) / 6; // ⟨|r|⟩ for side 1
        for (double sign : new double[] {-1, 1}) {
            double disc = sign * 2.0 / 3 * R * 7;
            assertThat(SurfacePatch.of(new Circle(R)).holds(0, 0, disc * (1 - 1e-9), 0.3, 7)).isTrue();
            assertThat(SurfacePatch.of(new Circle(R)).holds(0, 0, disc * (1 + 1e-9), 0.3, 7)).isFalse();
            double square = sign * ofSquare * 7;
            assertThat(SurfacePatch.of(new Rectangle(1, 1)).holds(0, 0, square * (1 - 1e-9), 0.3, 7)).isTrue();
            assertThat(SurfacePatch.of(new Rectangle(1, 1)).holds(0, 0, square * (1 + 1e-9), 0.3, 7)).isFalse();
        }
        // turning a triangle in place needs a force as well, so less torque is held without it
        double[] spin = friction(new Polygon(0, 0, 3, 0, 1, 2), 0, 0, -1, 0);
        SurfacePatch triangle = SurfacePatch.of(new Polygon(0, 0, 3, 0, 1, 2));
        assertThat(triangle.holds(spin[0], spin[1], spin[2] * (1 - 1e-9), 0, 1)).isTrue();
        assertThat(triangle.holds(0, 0, spin[2] * (1 - 1e-9), 0, 1)).isFalse();
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void frictionLiesOnTheLimitSurface(Shape shape) {
        Random random = new Random(5);
        SurfacePatch patch = SurfacePatch.of(shape);
        double[] f = new double[3];
        for (int k = 0; k < 500; k++) {
            double angle = 2 * Math.PI * random.nextDouble();
            double v = shape.boundingRadius() * Math.pow(10, 8 * random.nextDouble() - 4);
            double theta = 3 * random.nextGaussian();
            patch.friction(v * Math.cos(angle), v * Math.sin(angle), random.nextBoolean() ? 1 : -1, theta, f);
            double limit = Math.exp(5 * random.nextGaussian());
            for (double d : new double[] {1e-3, 1e-8, 1e-10}) {
                double in = -limit * (1 - d);
                double out = -limit * (1 + d);
                assertThat(patch.holds(in * f[0], in * f[1], in * f[2], theta, limit)).isTrue();
                assertThat(patch.holds(out * f[0], out * f[1], out * f[2], theta, limit)).isFalse();
            }
        }
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void aPatchCanBeSaved(Shape shape) {
        double[] f = new double[3];
        Checkpoint.copy(SurfacePatch.of(shape)).friction(1, 2, 3, 4, f);
        assertThat(f).containsExactly(friction(shape, 1, 2, 3, 4));
    }

    /** Means over the area by nested adaptive quadrature on chords: slow, and independent of the closed forms. */
    private static final class AreaMean {
        /** Of the difference between two sums: it falls quadratically, so the better one is much more accurate. */
        private static final double TOLERANCE = 1e-10;

        /** Friction at angle 0. */
        static double[] friction(Shape shape, double vx, double vy, double omega) {
            double cx = -vy / omega;
            double cy = vx / omega;
            double[] out = new double[3];
            for (int k = 0; k < 3; k++) {
                int part = k;
                DoubleUnaryOperator slice = y -> {
                    double[] chord = chord(shape, y);
                    return integral(
                            x -> {
                                double ux = vx - omega * y;
                                double uy = vy + omega * x;
                                double share = ux == 0 && uy == 0 ? 0 : -1 / Math.hypot(ux, uy);
                                return share * (part == 0 ? ux : part == 1 ? uy : x * uy - y * ux);
                            },
                            chord[0],
                            chord[1],
                            cx);
                };
                out[k] = overHeights(shape, slice, cy) / shape.area();
            }
            return out;
        }

        /** The same of several parts: each by its share of the area. */
        static double[] frictionOfParts(Shape shape, double vx, double vy, double omega) {
            double[] out = new double[3];
            for (int p = 0; p < shape.partCount(); p++) {
                Shape part = shape.part(p);
                double[] own = friction(part, vx, vy, omega);
                for (int k = 0; k < 3; k++) {
                    out[k] += part.area() / shape.area() * own[k];
                }
            }
            return out;
        }

        private static double overHeights(Shape shape, DoubleUnaryOperator slice, double cy) {
            if (shape.vertexCount() == 1) {
                double r = shape.radius(); // y = r sin a removes the root at the ends of the chords
                double y = shape.vertexY(0);
                double split = Math.abs(cy - y) < r ? Math.asin((cy - y) / r) : 0;
                return integral(
                        a -> slice.applyAsDouble(y + r * Math.sin(a)) * r * Math.cos(a), -Math.PI / 2, Math.PI / 2, split);
            }
            double[] heights = new double[shape.vertexCount()];
            for (int k = 0; k < heights.length; k++) {
                heights[k] = shape.vertexY(k);
            }
            Arrays.sort(heights);
            double sum = 0;
            for (int k = 1; k < heights.length; k++) {
                sum += integral(slice, heights[k - 1], heights[k], cy);
            }
            return sum;
        }

        private static double[] chord(Shape shape, double y) {
            double fromCentre = y - shape.vertexY(0);
            double half = Math.sqrt(Math.max(0, shape.radius() * shape.radius() - fromCentre * fromCentre));
            double x0 = shape.vertexX(0);
            double[] ends = {half > 0 ? x0 - half : Double.POSITIVE_INFINITY, half > 0 ? x0 + half : Double.NEGATIVE_INFINITY};
            for (int k = 0; half == 0 && k < shape.vertexCount(); k++) {
                int next = (k + 1) % shape.vertexCount();
                double t = (y - shape.vertexY(k)) / (shape.vertexY(next) - shape.vertexY(k));
                if (t >= 0 && t <= 1) {
                    double x = shape.vertexX(k) + t * (shape.vertexX(next) - shape.vertexX(k));
                    ends[0] = Math.min(ends[0], x);
                    ends[1] = Math.max(ends[1], x);
                }
            }
            return ends;
        }

        static double integral(DoubleUnaryOperator f, double a, double b, double split) {
            return split > a && split < b ? integral(f, a, split) + integral(f, split, b) : integral(f, a, b);
        }

        /** Exponential clustering at both ends (Takahasi and Mori 1974), halving the step until two sums agree. */
        static double integral(DoubleUnaryOperator f, double a, double b) {
            if (!(b > a)) {
                return 0;
            }
            double last = Double.NaN;
            for (double h = 0.25; h > 1e-3; h *= 0.5) {
                double sum = 0;
                double size = 0;
                for (int k = (int) Math.round(-3.3 / h); k * h <= 3.3; k++) {
                    double u = Math.PI / 2 * Math.sinh(k * h);
                    double weight = Math.PI / 2 * Math.cosh(k * h) / (Math.cosh(u) * Math.cosh(u));
                    double fromEnd = (b - a) / (1 + Math.exp(2 * Math.abs(u)));
                    double value = weight * f.applyAsDouble(u < 0 ? a + fromEnd : b - fromEnd);
                    sum += value;
                    size += Math.abs(value);
                }
                sum *= 0.5 * (b - a) * h;
                if (Math.abs(sum - last) <= TOLERANCE * (size * (b - a) * h + 1e-3 * (b - a))) {
                    return sum;
                }
                last = sum;
            }
            return last;
        }
    }
}
