// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Pedestrians who press through a door, by an author's force: what that costs, counted, and that it obeys the laws of contacts. */
class CrowdAtDoorTest {
    private static final double RADIUS = 0.25;
    private static final double MASS = 80;
    private static final double SPEED = 1.3;
    private static final double DELAY = 0.5;

    /** How deep bodies that an author drives may be. */
    private static final double DEPTH = 1e-7 * RADIUS;

    /** Drives everybody to the door, and through it. */
    private record Will(double gap) implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            double half = Math.max(0, gap / 2 - RADIUS);
            double dx = 0.3 - body.getX();
            double dy = Math.max(-half, Math.min(half, body.getY())) - body.getY();
            double way = Math.hypot(dx, dy);
            boolean isThrough = body.getX() > 0;
            double ex = isThrough ? 1 : dx / way;
            double ey = isThrough ? 0 : dy / way;
            forces.add(body, MASS * (SPEED * ex - body.getVelocityX()) / DELAY, MASS * (SPEED * ey - body.getVelocityY()) / DELAY);
        }

        @Override
        public boolean isAutonomous() {
            return true;
        }
    }

    private static Body add(PhysicsEngine engine, Body body, double friction) {
        body.setRestitution(0);
        body.setFriction(friction);
        return engine.add(body);
    }

    private static List<Body> crowd(PhysicsEngine engine, int n, double gap, double friction) {
        engine.setTimeStep(1.0 / 60);
        engine.add(new Will(gap));
        double half = Math.sqrt(n) * 0.4 + 1;
        double length = half + 1 - gap / 2;
        for (int side = -1; side <= 1; side += 2) {
            add(engine, Body.fixed(new Rectangle(0.2, length)).at(0.1, side * (gap / 2 + length / 2)), friction);
            add(engine, Body.fixed(new Rectangle(4 * half, 0.2)).at(-2 * half, side * (half + 0.1)), friction);
        }
        SplittableRandom random = new SplittableRandom(1);
        List<Body> people = new ArrayList<>();
        int columns = (int) ((2 * half - 0.3) / 0.6);
        for (int k = 0; k < n; k++) {
            double x = -0.6 - k / columns * 0.6 + 0.08 * (random.nextDouble() - 0.5);
            double y = -half + 0.4 + k % columns * 0.6 + 0.08 * (random.nextDouble() - 0.5);
            Body body = new Body(new Circle(RADIUS)).at(x, y);
            body.setMass(MASS);
            people.add(add(engine, body, friction));
        }
        return people;
    }

    private static void assertApart(List<Body> people) {
        for (int k = 0; k < people.size(); k++) {
            for (int m = 0; m < k; m++) {
                double apart = Math.hypot(people.get(k).getX() - people.get(m).getX(), people.get(k).getY() - people.get(m).getY());
                assertThat(apart).isGreaterThan(2 * RADIUS - 1.01 * DEPTH);
            }
        }
    }

    /** It took 2.1 times as much when a pair of them that met in the crowd met three times before it lay, and each solution was found from nothing. */
    @Test
    void thoseWhoMeetInACrowdAreSolvedForOnce() {
        PhysicsEngine engine = new PhysicsEngine();
        List<Body> people = crowd(engine, 50, 1, 0);
        for (int step = 0; step < 150; step++) {
            engine.step();
            assertApart(people);
        }
        assertThat(engine.getRelievedSteps()).isZero();
        assertThat(people.stream().filter(b -> b.getX() > 1.5).count()).isPositive();
        assertThat(engine.getWork()).isLessThan(6_000_000);
    }

    /**
     * Whoever stands in an arch goes on to do so, under forces that hold one another in balance, and friction within its bounds. When what they had borne
     * counted as too much beside speeds that were but rounding, it was found anew from nothing, again and again, at two to two hundred times the cost.
     */
    @Test
    void anArchStandsAtNextToNoCost() {
        double friction = 0.3;
        PhysicsEngine engine = new PhysicsEngine();
        List<Body> people = crowd(engine, 40, 0.8, friction);
        for (int step = 0; step < 240; step++) {
            engine.step();
        }
        List<Body> within = people.stream().filter(b -> b.getX() < 0.3).toList();
        double[] places = within.stream().mapToDouble(Body::getX).toArray();
        long work = engine.getWork();
        for (int step = 0; step < 60; step++) {
            engine.step();
            assertApart(people);
        }
        assertThat(engine.getWork() - work).isLessThan(60 * 12_000);
        assertThat(engine.getRelievedSteps()).isZero();
        for (int k = 0; k < within.size(); k++) {
            assertThat(within.get(k).getX()).isCloseTo(places[k], org.assertj.core.api.Assertions.within(1e-9));
            assertBorne(engine, within.get(k), friction);
        }
    }

    /** The contact forces on a body that stands, and its drive, have no sum; and none of them pulls, or rubs by more than it may. */
    private static void assertBorne(PhysicsEngine engine, Body body, double friction) {
        double half = 0.8 / 2 - RADIUS;
        double dx = 0.3 - body.getX();
        double dy = Math.max(-half, Math.min(half, body.getY())) - body.getY();
        double drive = MASS * SPEED / DELAY;
        double x = drive * dx / Math.hypot(dx, dy);
        double y = drive * dy / Math.hypot(dx, dy);
        for (LastingContact contact : engine.contacts()) {
            if (contact.a() == body || contact.b() == body) {
                x += contact.forceX(body);
                y += contact.forceY(body);
                assertThat(contact.normalForce()).isNotNegative();
                assertThat(Math.abs(contact.tangentForce())).isLessThanOrEqualTo(friction * contact.normalForce() + 1e-7 * drive);
            }
        }
        assertThat(Math.hypot(x, y)).isLessThan(1e-7 * drive);
    }
}
