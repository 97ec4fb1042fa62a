// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.Reaction;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Rattle;
import sim.physics.motion.Spring;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Large mechanisms with a closed form: a linkage that draws a line, a lift, a bridge, a chain that is struck. */
class StructureTest {
    private static final double G = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();

    private Body rod(double x0, double y0, double x1, double y1) {
        double length = StrictMath.hypot(x1 - x0, y1 - y0);
        Body rod = new Body(new Rectangle(length, 0.02));
        rod.at((x0 + x1) / 2, (y0 + y1) / 2, StrictMath.atan2(y1 - y0, x1 - x0));
        rod.setMass(1, length * length / 12);
        rod.setCollisionGroup(1, 0);
        return engine.add(rod);
    }

    private Body point(double x, double y) {
        Body body = engine.add(new Body(new Circle(0.1)).at(x, y));
        body.setCollisionGroup(1, 0);
        return body;
    }

    private Body lineOfPeaucellier(double p, double arm, double side) {
        double oa = 2 * p * StrictMath.cos(0.2);
        double oc = (arm * arm - side * side) / oa;
        double half = (oc - oa) / 2;
        double away = StrictMath.sqrt(side * side - half * half);
        double ux = StrictMath.cos(0.2);
        double uy = StrictMath.sin(0.2);
        Body a = point(oa * ux, oa * uy);
        Body c = point(oc * ux, oc * uy);
        Body b = point((oa + half) * ux - away * uy, (oa + half) * uy + away * ux);
        Body d = point((oa + half) * ux + away * uy, (oa + half) * uy - away * ux);
        Body[][] bars = {{b, null}, {d, null}, {a, b}, {a, d}, {c, b}, {c, d}};
        for (Body[] bar : bars) {
            double x = bar[1] == null ? 0 : bar[1].getX();
            double y = bar[1] == null ? 0 : bar[1].getY();
            engine.add(new RodJoint(bar[0], bar[0].getX(), bar[0].getY(), bar[1], x, y));
        }
        engine.add(new RodJoint(a, a.getX(), a.getY(), null, p, 0));
        return c;
    }

    @Test
    void peaucelliersPointStaysOnItsLine() {
        engine.setTimeStep(0.01);
        drawsALine(50);
    }

    /** Some seven steps a turn: twenty minutes at 0.01. */
    @Test
    @Tag("soak")
    void peaucelliersPointStaysOnItsLineForAMillionTurns() {
        engine.setTimeStep(0.5);
        engine.setIntegrator(new Rattle(2));
        drawsALine(1_000_000);
    }

    /** A spring draws the point back and forth along its line. */
    private void drawsALine(int times) {
        Body c = lineOfPeaucellier(0.7, 2.5, 2);
        double line = (2.5 * 2.5 - 2 * 2) / (2 * 0.7);
        Body anchor = engine.add(Body.fixed(new Circle(0.01)).at(line, 0));
        anchor.setCollisionGroup(1, 0);
        engine.add(new Spring(anchor, 0, 0, c, 0, 0, 0, 5 * c.getMass(), 0));
        double most = 0;
        int turns = 0;
        boolean up = c.getY() > 0;
        for (int k = 0; turns <= times && k < 400 * times; k++) {
            engine.step();
            most = Math.max(most, Math.abs(c.getX() - line));
            turns += up != c.getY() > 0 ? 1 : 0;
            up = c.getY() > 0;
        }
        assertThat(turns).isGreaterThan(times);
        assertThat(most).isLessThan(1e-13 * line);
    }

    /** n stages of crossed bars; the foot on the right rolls. Returns the bar whose end is the top on the left. */
    private Body scissors(int n, double phi, Body carriage) {
        double w = StrictMath.cos(phi);
        double h = StrictMath.sin(phi);
        Body left = null;
        Body right = null;
        for (int k = 0; k < n; k++) {
            Body rising = rod(0, k * h, w, (k + 1) * h);
            Body falling = rod(w, k * h, 0, (k + 1) * h);
            engine.add(new PinJoint(rising, falling, w / 2, (k + 0.5) * h));
            if (k == 0) {
                engine.add(new PinJoint(rising, 0, 0));
                engine.add(new PinJoint(falling, carriage, w, 0));
            } else {
                engine.add(new PinJoint(rising, left, 0, k * h));
                engine.add(new PinJoint(falling, right, w, k * h));
            }
            left = falling;
            right = rising;
        }
        return left;
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 10, 50})
    void aScissorsLiftPressesWithItsWeight(int n) {
        engine.setTimeStep(0.01);
        engine.add(new Gravity(0, -G));
        double phi = 0.5;
        double w = StrictMath.cos(phi);
        double h = StrictMath.sin(phi);
        Body carriage = point(w, 0);
        engine.add(new SliderJoint(carriage, null, w, 0, 1, 0));
        RodJoint hydraulics = engine.add(new RodJoint(carriage, w, 0, null, -1, 0));
        Body top = scissors(n, phi, carriage);
        Body load = point(0, n * h);
        load.setMass(100);
        engine.add(new PinJoint(top, load, 0, n * h));
        for (int k = 0; k < 100; k++) {
            engine.step();
        }
        double exact = (100 * n + n * n) * G / StrictMath.tan(phi);
        double force = Math.abs(engine.getReaction(hydraulics).forceX());
        double sag = load.getY() - n * h;
        assertThat(force).isCloseTo(exact, within(1e-9 * exact));
        assertThat(sag).isCloseTo(0, within(1e-12));
    }

    @ParameterizedTest
    @CsvSource({"3, 1e6", "10, 1e5", "20, 1e6", "3, 1e7", "3, 1e9", "3, 1e12"})
    void aScissorsLiftRisesByItsKinematics(int n, double limit) {
        engine.setTimeStep(0.01);
        engine.add(new Gravity(0, -G));
        double w = StrictMath.cos(0.3);
        Body carriage = point(w, 0);
        SliderJoint rail = engine.add(new SliderJoint(carriage, null, w, 0, 1, 0));
        Body top = scissors(n, 0.3, carriage);
        engine.add(new Motor(new RodJoint(carriage, w, 0, null, -1, 0), -0.1, limit));
        double most = 0;
        for (int k = 0; k < 200; k++) {
            engine.step();
            double phi = StrictMath.acos(carriage.getX());
            double height = top.getY() + 0.5 * Math.abs(StrictMath.sin(top.getAngle()));
            most = Math.max(most, Math.abs(height - n * StrictMath.sin(phi)));
        }
        assertThat(Math.abs(rail.getTravel())).isCloseTo(0.2, within(2e-3)); // less the start
        assertThat(carriage.getVelocityX()).isCloseTo(-0.1, within(1e-13));
        assertThat(most).isLessThan(1e-12 * n);
    }

    /** A chain of n links between two supports, placed where statics has it: the slope is the weight borne over the pull. */
    @ParameterizedTest
    @CsvSource({"160, 80", "1000, 400"})
    void aBridgeHangsWhereStaticsHasIt(int n, double pull) {
        engine.setTimeStep(0.01);
        engine.add(new Gravity(0, -G));
        Body last = null;
        double x = 0;
        double y = 0;
        Body[] links = new Body[n];
        double[][] start = new double[n][];
        PinJoint first = null;
        for (int k = 0; k < n; k++) {
            double angle = StrictMath.atan2(-(0.5 * n - (k + 0.5)) * G, pull * G);
            double cos = StrictMath.cos(angle);
            double sin = StrictMath.sin(angle);
            links[k] = rod(x, y, x + cos, y + sin);
            start[k] = new double[] {links[k].getX(), links[k].getY()};
            PinJoint pin = engine.add(k == 0 ? new PinJoint(links[0], 0, 0) : new PinJoint(last, links[k], x, y));
            first = k == 0 ? pin : first;
            x += cos;
            y += sin;
            last = links[k];
        }
        engine.add(new PinJoint(last, x, y));
        for (int k = 0; k < 100; k++) {
            engine.step();
        }
        double moved = 0;
        for (int k = 0; k < n; k++) {
            moved = Math.max(moved, StrictMath.hypot(links[k].getX() - start[k][0], links[k].getY() - start[k][1]));
        }
        Reaction r = engine.getReaction(first);
        assertThat(moved).isLessThan(1e-12 * n);
        assertThat(Math.abs(r.forceX())).isCloseTo(pull * G, within(1e-11 * pull * G));
        assertThat(r.forceY()).isCloseTo(0.5 * n * G, within(1e-11 * n * G));
    }

    /** Takes the velocities right after the first impact. */
    private static final class Watch implements CollisionListener {
        private static final long serialVersionUID = 1L;

        private final Body[] links;
        private final Body ball;
        private final double[][] seen;

        Watch(Body[] links, Body ball, double[][] seen) {
            this.links = links;
            this.ball = ball;
            this.seen = seen;
        }

        @Override
        public void collided(Contact contact) {
            for (int k = 0; seen[links.length] == null && k < links.length; k++) {
                seen[k] = velocity(links[k]);
            }
            seen[links.length] = seen[links.length] == null ? velocity(ball) : seen[links.length];
        }

        private static double[] velocity(Body body) {
            return new double[] {body.getVelocityX(), body.getVelocityY(), body.getAngularVelocity()};
        }
    }

    /** Velocities of a straight chain of rods after a blow of 1 at the middle of rod k: heights of its ends, tridiagonal. */
    private static double[] blow(int n, int at) {
        double[] diagonal = new double[n + 1];
        double[] right = new double[n + 1];
        right[at] = 0.5;
        right[at + 1] = 0.5;
        for (int k = 0; k <= n; k++) {
            diagonal[k] = k == 0 || k == n ? 1.0 / 3 : 2.0 / 3;
        }
        for (int k = 1; k <= n; k++) {
            double factor = 1.0 / 6 / diagonal[k - 1];
            diagonal[k] -= factor / 6;
            right[k] -= factor * right[k - 1];
        }
        for (int k = n; k >= 0; k--) {
            right[k] = (right[k] - (k < n ? right[k + 1] / 6 : 0)) / diagonal[k];
        }
        return right;
    }

    @ParameterizedTest
    @CsvSource({"100, 0", "100, 37", "100, 99", "1000, 500"})
    void aChainIsStruck(int n, int at) {
        engine.setTimeStep(0.125);
        Body[] links = new Body[n];
        for (int k = 0; k < n; k++) {
            links[k] = rod(k, 0, k + 1, 0);
            links[k].setCollisionGroup(1, 2);
            if (k > 0) {
                engine.add(new PinJoint(links[k - 1], links[k], k, 0));
            }
        }
        Body ball = engine.add(new Body(new Circle(0.25)).at(at + 0.5, -0.26 - 0.125).moving(0, 1));
        ball.setCollisionGroup(2, 1);
        ball.setMass(1);
        double[][] seen = new double[n + 1][];
        engine.addListener(new Watch(links, ball, seen));
        engine.step();
        engine.step();
        double[] heights = blow(n, at);
        double there = 0.5 * (heights[at] + heights[at + 1]);
        double impulse = 2 / (1 + there);
        double most = Math.abs(seen[n][1] - (1 - impulse));
        for (int k = 0; k < n; k++) {
            most = Math.max(most, Math.abs(seen[k][1] - 0.5 * impulse * (heights[k] + heights[k + 1])));
            most = Math.max(most, Math.abs(seen[k][2] - impulse * (heights[k + 1] - heights[k])));
        }
        assertThat(most).isLessThan(1e-12);
    }
}
