// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.response.BorderedImpulse;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.ImpulseSolver;
import sim.physics.response.TwoBodyImpulse;

/**
 * The laws of an impact, on 10,000 random ones of all kinds with masses over twelve decades, as a listener sees them
 * through the engine.
 */
class RandomImpactTest {
    private static final int IMPACTS_PER_KIND = 2000;
    private static final double EXACT = 1e-14;

    /** Notes the first collision with the states right before and after it. */
    private static final class FirstImpact implements CollisionListener {
        private static final long serialVersionUID = 1L;
        final Decision decision;
        Contact contact;
        double[] before;
        double[] after;

        FirstImpact(Decision decision) {
            this.decision = decision;
        }

        @Override
        public Decision colliding(Contact c) {
            if (before == null) {
                before = state(c);
                return decision;
            }
            return Decision.IGNORE;
        }

        @Override
        public void collided(Contact c) {
            if (contact == null) {
                contact = c;
                after = state(c);
            }
        }

        /** Position, velocity and angular velocity of both. */
        private static double[] state(Contact c) {
            Body a = c.a();
            Body b = c.b();
            return new double[] {
                a.getX(), a.getY(), a.getVelocityX(), a.getVelocityY(), a.getAngularVelocity(),
                b.getX(), b.getY(), b.getVelocityX(), b.getVelocityY(), b.getAngularVelocity()
            };
        }
    }

    private static TouchingPair pair(TouchingPair.Kind kind, int number) {
        return new TouchingPair(new SplittableRandom(97 * number + kind.ordinal()), kind, number % 4 == 0);
    }

    private static FirstImpact collide(TouchingPair pair, ImpulseSolver solver, CollisionListener.Decision decision) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1e-9);
        engine.setImpulseSolver(solver);
        engine.add(pair.a);
        engine.add(pair.b);
        FirstImpact first = new FirstImpact(decision);
        engine.addListener(first);
        engine.step();
        assertThat(first.contact).isNotNull();
        assertThat(first.contact.normalX() * pair.nx + first.contact.normalY() * pair.ny).isCloseTo(1, within(1e-9));
        return first;
    }

    private static FirstImpact collide(TouchingPair pair) {
        return collide(pair, new TwoBodyImpulse(), CollisionListener.Decision.BOUNCE);
    }

    /** Momentum, angular momentum about a point, and energy: [sum, sum of the sizes of the terms] each. */
    private static double[][] conserved(FirstImpact i, double[] s, double x, double y) {
        double[][] sums = new double[4][2];
        for (int k = 0; k < 2; k++) {
            Body body = k == 0 ? i.contact.a() : i.contact.b();
            if (body.isFixed()) {
                continue;
            }
            double m = body.getMass();
            double vx = s[5 * k + 2];
            double vy = s[5 * k + 3];
            double omega = s[5 * k + 4];
            add(sums[0], m * vx);
            add(sums[1], m * vy);
            add(sums[2], m * (s[5 * k] - x) * vy);
            add(sums[2], -m * (s[5 * k + 1] - y) * vx);
            add(sums[2], body.getInertia() * omega);
            add(sums[3], 0.5 * m * (vx * vx + vy * vy));
            add(sums[3], 0.5 * body.getInertia() * omega * omega);
        }
        double momentum = sums[0][1] + sums[1][1];
        sums[0][1] = momentum;
        sums[1][1] = momentum;
        return sums;
    }

    private static void add(double[] sum, double term) {
        sum[0] += term;
        sum[1] += Math.abs(term);
    }

    private static void assertEqual(double[] before, double[] after, String what) {
        assertThat(after[0]).as(what).isCloseTo(before[0], within(EXACT * (before[1] + after[1])));
    }

    /** Momentum and angular momentum; of a pair with a fixed body only that about the collision point. */
    private static void assertMomentum(TouchingPair pair, FirstImpact i, String what) {
        boolean fixed = i.contact.a().isFixed() || i.contact.b().isFixed();
        if (fixed && pair.points.length == 2) {
            assertThat(twist(pair.points[0], i) * twist(pair.points[1], i)).as(what).isLessThanOrEqualTo(0);
            return;
        }
        double x = fixed ? i.contact.x() : 0;
        double y = fixed ? i.contact.y() : 0;
        double[][] before = conserved(i, i.before, x, y);
        double[][] after = conserved(i, i.after, x, y);
        for (int k = fixed ? 2 : 0; k < 3; k++) {
            assertEqual(before[k], after[k], what + ", momentum " + k);
        }
    }

    /** Angular momentum about a point that an impact gives the movable body of a pair; 0 if it is rounding. */
    private static double twist(double[] point, FirstImpact i) {
        double[][] before = conserved(i, i.before, point[0], point[1]);
        double[][] after = conserved(i, i.after, point[0], point[1]);
        double change = after[2][0] - before[2][0];
        double far = Math.abs(point[0]) + Math.abs(point[1]);
        double rounding = EXACT * (before[2][1] + after[2][1] + far * (before[0][1] + after[0][1]));
        return Math.abs(change) <= rounding ? 0 : change;
    }

    /** Velocity of b's point relative to a's along a direction, and the sum of the sizes of its terms. */
    private static double[] relative(double[] s, double x, double y, double dx, double dy) {
        double[] sum = new double[2];
        for (int k = 0; k < 2; k++) {
            double sign = k == 0 ? -1 : 1;
            add(sum, sign * s[5 * k + 2] * dx);
            add(sum, sign * s[5 * k + 3] * dy);
            add(sum, -sign * s[5 * k + 4] * (y - s[5 * k + 1]) * dx);
            add(sum, sign * s[5 * k + 4] * (x - s[5 * k]) * dy);
            sum[1] += Math.abs(s[5 * k + 4]) * (Math.abs(x) + Math.abs(y));
        }
        return sum;
    }

    /** Parting speed = e × approach where the bodies push, and no less anywhere. */
    private static void assertParting(TouchingPair pair, FirstImpact i, double e, String what) {
        double nx = i.contact.normalX();
        double ny = i.contact.normalY();
        double least = Double.POSITIVE_INFINITY;
        for (double[] p : pair.points) {
            double[] before = relative(i.before, p[0], p[1], nx, ny);
            double[] after = relative(i.after, p[0], p[1], nx, ny);
            double excess = (after[0] + e * before[0]) / (before[1] + after[1]);
            assertThat(excess).as(what + ", parting").isGreaterThan(-10 * EXACT);
            least = Math.min(least, excess);
        }
        assertThat(least).as(what + ", parting").isLessThan(10 * EXACT);
    }

    /** The impulse pushes along the normal, and nowhere else. */
    private static void assertNormal(FirstImpact i, String what) {
        double m = i.contact.b().isFixed() ? i.contact.a().getMass() : i.contact.b().getMass();
        int o = i.contact.b().isFixed() ? 2 : 7;
        double rx = m * (i.after[o] - i.before[o]);
        double ry = m * (i.after[o + 1] - i.before[o + 1]);
        double sign = o == 7 ? 1 : -1;
        double rounding = EXACT * m * (Math.abs(i.before[o]) + Math.abs(i.before[o + 1])
                + Math.abs(i.after[o]) + Math.abs(i.after[o + 1]));
        double normal = sign * (rx * i.contact.normalX() + ry * i.contact.normalY());
        assertThat(normal).as(what + ", impulse").isGreaterThan(-rounding);
        assertThat(normal).as(what + ", impulse").isCloseTo(i.contact.impulse(), within(rounding));
        assertThat(ry * i.contact.normalX() - rx * i.contact.normalY()).as(what + ", tangent").isCloseTo(0, within(rounding));
    }

    @ParameterizedTest
    @EnumSource
    void elasticImpactsConserveAll(TouchingPair.Kind kind) {
        for (int number = 0; number < IMPACTS_PER_KIND; number++) {
            String what = kind + " " + number;
            TouchingPair pair = pair(kind, number);
            FirstImpact i = collide(pair);
            assertMomentum(pair, i, what);
            assertEqual(conserved(i, i.before, 0, 0)[3], conserved(i, i.after, 0, 0)[3], what + ", energy");
            assertParting(pair, i, 1, what);
            assertNormal(i, what);
        }
    }

    @ParameterizedTest
    @EnumSource
    void bodiesPartWithTheirShareOfTheApproach(TouchingPair.Kind kind) {
        for (int number = 0; number < IMPACTS_PER_KIND; number++) {
            String what = kind + " " + number;
            TouchingPair pair = pair(kind, number);
            double e = number % 5 == 0 ? 0 : (number % 100) / 99.0;
            pair.b.setRestitution(e);
            FirstImpact i = collide(pair);
            assertMomentum(pair, i, what);
            double[] before = conserved(i, i.before, 0, 0)[3];
            double[] after = conserved(i, i.after, 0, 0)[3];
            assertThat(after[0]).as(what + ", energy").isLessThan(before[0] * (1 + EXACT));
            assertParting(pair, i, e, what);
            assertNormal(i, what);
        }
    }

    @ParameterizedTest
    @EnumSource
    void frictionStaysInItsConeAndCostsEnergy(TouchingPair.Kind kind) {
        for (int number = 0; number < IMPACTS_PER_KIND; number++) {
            String what = kind + " " + number;
            TouchingPair pair = pair(kind, number);
            double mu = 0.01 * (1 + number % 150);
            pair.a.setFriction(mu);
            pair.b.setFriction(mu);
            pair.b.setRestitution((number % 10) / 9.0);
            FirstImpact i = collide(pair);
            assertMomentum(pair, i, what);
            double[] before = conserved(i, i.before, 0, 0)[3];
            double[] after = conserved(i, i.after, 0, 0)[3];
            assertThat(after[0]).as(what + ", energy").isLessThan(before[0] * (1 + EXACT));
            double m = pair.b.getMass();
            boolean swapped = i.contact.b() != pair.b;
            int o = swapped ? 2 : 7;
            double rx = (swapped ? -m : m) * (i.after[o] - i.before[o]);
            double ry = (swapped ? -m : m) * (i.after[o + 1] - i.before[o + 1]);
            double normal = rx * i.contact.normalX() + ry * i.contact.normalY();
            double tangent = Math.abs(ry * i.contact.normalX() - rx * i.contact.normalY());
            double rounding = EXACT * m * (Math.hypot(i.before[o], i.before[o + 1]) + Math.hypot(i.after[o], i.after[o + 1]));
            assertThat(tangent).as(what + ", cone").isLessThanOrEqualTo(mu * normal + (2 + mu) * rounding);
        }
    }

    @ParameterizedTest
    @EnumSource
    void bothWaysToTheImpulseAgree(TouchingPair.Kind kind) {
        for (int number = 0; number < IMPACTS_PER_KIND; number++) {
            FirstImpact closed = collide(pair(kind, number));
            FirstImpact bordered =
                    collide(pair(kind, number), new BorderedImpulse(), CollisionListener.Decision.BOUNCE);
            assertThat(bordered.contact.impulse())
                    .as("%s %d", kind, number)
                    .isCloseTo(closed.contact.impulse(), within(1e-10 * closed.contact.impulse()));
        }
    }

    @ParameterizedTest
    @EnumSource
    void stuckPointsMoveAlike(TouchingPair.Kind kind) {
        for (int number = 0; number < IMPACTS_PER_KIND; number++) {
            String what = kind + " " + number;
            TouchingPair pair = pair(kind, number);
            FirstImpact i = collide(pair, new TwoBodyImpulse(), CollisionListener.Decision.STICK);
            assertMomentum(pair, i, what);
            assertThat(conserved(i, i.after, 0, 0)[3][0]).isLessThan(conserved(i, i.before, 0, 0)[3][0] * (1 + EXACT));
            if (pair.points.length == 1) {
                for (double[] d : new double[][] {{1, 0}, {0, 1}}) {
                    double[] before = relative(i.before, i.contact.x(), i.contact.y(), d[0], d[1]);
                    double[] after = relative(i.after, i.contact.x(), i.contact.y(), d[0], d[1]);
                    assertThat(after[0]).as(what).isCloseTo(0, within(10 * EXACT * (before[1] + after[1])));
                }
            }
        }
    }
}
