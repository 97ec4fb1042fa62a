// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.references.Ladder;
import sim.physics.references.TippingBox;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;

/** What moves while it lies on something is of second order in the step: half as long a step, a quarter of the error. */
class ContactOrderTest {
    private static final double G = 9.81;

    /** The error may shrink by a little less than that, twice in a row. */
    private static final double QUARTER_TWICE = 1 / 14.0;

    /** Gravity, as an author might write it. */
    private static final class Weight implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, 0, -G * body.getMass());
        }
    }

    private final PhysicsEngine engine = new PhysicsEngine();

    private Body put(Body body, double friction) {
        body.setFriction(friction);
        body.setRestitution(0);
        return engine.add(body);
    }

    private void go(double time, int steps) {
        engine.setTimeStep(time / steps);
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    /** Slips between a smooth wall and a smooth floor; normals stand still, levers turn. */
    private static double ladderError(int steps, boolean driven, double time) {
        ContactOrderTest scene = new ContactOrderTest();
        double thick = 0.02;
        double angle = 1.1;
        scene.engine.add(driven ? new Weight() : new Gravity(0, -G));
        scene.put(Body.fixed(new Rectangle(20, 2)).at(9, -1), 0);
        scene.put(Body.fixed(new Rectangle(2, 18)).at(-1, 9), 0);
        double x = Math.cos(angle) + thick * Math.sin(angle);
        double y = Math.sin(angle) + thick * Math.cos(angle);
        Body bar = scene.put(new Body(new Rectangle(2, 2 * thick)).at(x, y, -angle), 0);
        bar.setMass(1, (1 + thick * thick) / 3);
        scene.go(time, steps);
        double[] exact = new Ladder(1, thick, (1 + thick * thick) / 3, G).place(angle, time, 1e-13);
        return Math.max(Math.abs(bar.getX() - exact[0]), Math.max(Math.abs(bar.getY() - exact[1]), Math.abs(-bar.getAngle() - exact[2])));
    }

    @ParameterizedTest
    @ValueSource(ints = {32, 64, 128, 256})
    void aLadderThatSlips(int steps) {
        assertThat(ladderError(4 * steps, false, 0.4)).isLessThan(QUARTER_TWICE * ladderError(steps, false, 0.4));
        assertThat(ladderError(steps, false, 0.4)).isLessThan(0.1 / (steps * steps));
    }

    /** From 0.4922 s on it touches the floor alone. */
    @ParameterizedTest
    @ValueSource(ints = {45, 180, 720, 2880})
    void aLadderThatLeavesTheWall(int steps) {
        assertThat(ladderError(steps, false, 0.6)).isLessThan(0.3 / (steps * steps));
    }

    /** Moved by an integrator, as an author's force is its weight. */
    @ParameterizedTest
    @ValueSource(ints = {32, 64, 128, 256, 512, 1024})
    void aLadderThatSlipsUnderAnAuthorsForce(int steps) {
        assertThat(ladderError(steps, true, 0.4)).isLessThan(1.0 / (steps * steps));
    }

    /** Two bars that a pin holds together at the top, and whose feet slip apart: each as on a smooth wall. */
    private static double frameError(int steps) {
        ContactOrderTest scene = new ContactOrderTest();
        double thick = 0.02;
        double angle = 1.1;
        scene.engine.add(new Gravity(0, -G));
        scene.put(Body.fixed(new Rectangle(20, 2)).at(0, -1), 0);
        double x = Math.cos(angle) + thick * Math.sin(angle);
        double y = Math.sin(angle) + thick * Math.cos(angle);
        Body right = scene.put(new Body(new Rectangle(2, 2 * thick)).at(x, y, -angle), 0);
        Body left = scene.put(new Body(new Rectangle(2, 2 * thick)).at(-x, y, angle), 0);
        right.setMass(1, (1 + thick * thick) / 3);
        left.setMass(1, (1 + thick * thick) / 3);
        scene.engine.add(new PinJoint(right, left, 0, 2 * Math.sin(angle)));
        scene.go(0.4, steps);
        double[] exact = new Ladder(1, thick, (1 + thick * thick) / 3, G).place(angle, 0.4, 1e-13);
        double place = Math.max(Math.abs(right.getX() - exact[0]), Math.abs(right.getY() - exact[1]));
        place = Math.max(place, Math.max(Math.abs(left.getX() + exact[0]), Math.abs(left.getY() - exact[1])));
        return Math.max(place, Math.max(Math.abs(-right.getAngle() - exact[2]), Math.abs(left.getAngle() - exact[2])));
    }

    /** What joints tie is moved by an integrator, too. */
    @ParameterizedTest
    @ValueSource(ints = {32, 64, 128, 256, 512, 1024})
    void aFrameWhoseFeetSlipApart(int steps) {
        assertThat(frameError(steps)).isLessThan(1.0 / (steps * steps));
    }

    /** A box that falls over one of its corners, which friction holds: a pendulum about that. */
    private static double tipError(int steps, boolean ofVelocity, boolean driven) {
        ContactOrderTest scene = new ContactOrderTest();
        TippingBox reference = new TippingBox(1, 2, G);
        double[] start = reference.at(0.7, 0);
        double[] end = reference.at(0.7, 0.25);
        scene.engine.add(driven ? new Weight() : new Gravity(0, -G));
        scene.put(Body.fixed(new Rectangle(40, 2)).at(0, -1), 0.9);
        Body box = scene.put(new Body(new Rectangle(1, 2)).at(start[0], start[1], -0.7), 0.9);
        scene.go(0.25, steps);
        double place = Math.max(Math.abs(box.getX() - end[0]), Math.abs(box.getY() - end[1]));
        return ofVelocity ? Math.abs(box.getAngularVelocity() + end[3]) : Math.max(place, Math.abs(box.getAngle() + end[2]));
    }

    @ParameterizedTest
    @ValueSource(ints = {16, 32, 64})
    void aBoxThatFallsOver(int steps) {
        assertThat(tipError(4 * steps, false, false)).isLessThan(QUARTER_TWICE * tipError(steps, false, false));
        assertThat(tipError(4 * steps, true, false)).isLessThan(QUARTER_TWICE * tipError(steps, true, false));
        assertThat(tipError(steps, false, false)).isLessThan(1.0 / (steps * steps));
    }

    @ParameterizedTest
    @ValueSource(ints = {16, 32, 64, 128, 256, 512})
    void aBoxThatFallsOverUnderAnAuthorsForce(int steps) {
        assertThat(tipError(steps, false, true)).isLessThan(1.0 / (steps * steps));
    }

    /**
     * A plank that rolls on a disc which does not move: at an angle a it has rolled R a, its centre is at −(R + b) sin a + R a cos a and
     * (R + b) cos a + R a sin a for half a thickness b, and its energy says how fast.
     */
    private static double plankError(int steps) {
        ContactOrderTest scene = new ContactOrderTest();
        double r = 0.5;
        double b = 0.1;
        double start = 0.25;
        double high = (r + b) * Math.cos(start) + r * start * Math.sin(start);
        scene.engine.add(new Gravity(0, -G));
        scene.put(Body.fixed(new Circle(r)), 1.5);
        Body plank = scene.put(new Body(new Rectangle(3, 2 * b)).at(r * start * Math.cos(start) - (r + b) * Math.sin(start), high, start), 1.5);
        scene.engine.setTimeStep(0.6 / steps);
        double worst = 0;
        for (int k = 0; k < steps; k++) {
            scene.engine.step();
            double a = plank.getAngle();
            double x = r * a * Math.cos(a) - (r + b) * Math.sin(a);
            double y = (r + b) * Math.cos(a) + r * a * Math.sin(a);
            double square = r * r * a * a + b * b + plank.getInertia() / plank.getMass(); // of the way of its centre per angle, and its own
            double rate = Math.sqrt(Math.max(0, 2 * G * (high - y) / square));
            worst = Math.max(worst, Math.hypot(plank.getX() - x, plank.getY() - y));
            worst = Math.max(worst, Math.abs(Math.abs(plank.getAngularVelocity()) - rate));
        }
        return worst;
    }

    @ParameterizedTest
    @ValueSource(ints = {30, 60, 120, 240})
    void aPlankThatRollsOnADisc(int steps) {
        assertThat(plankError(steps)).isLessThan(0.13 / (steps * steps));
    }

    /** Neither normals nor levers turn: uniform accelerations, exact at any step. */
    @ParameterizedTest
    @ValueSource(ints = {10, 60, 600})
    void aDiscThatSlidesDownAWedgeWhichGivesWay(int steps) {
        engine.add(new Gravity(0, -G));
        put(Body.fixed(new Rectangle(40, 2)).at(0, -1), 0);
        Body wedge = put(new Body(new Polygon(0, 0, 3, 0, 0, 2)).at(1, 2 / 3.0), 0);
        wedge.setMass(2);
        double steep = Math.atan2(2, 3);
        double x = 0.8 + 0.3 * Math.sin(steep);
        double y = 2 - 0.8 * 2 / 3 + 0.3 * Math.cos(steep);
        Body disc = put(new Body(new Circle(0.3)).at(x, y), 0);
        disc.setMass(1);
        go(0.6, steps);
        double back = G * Math.sin(steep) * Math.cos(steep) / (2 + Math.sin(steep) * Math.sin(steep));
        assertThat(wedge.getX()).isCloseTo(1 - back * 0.18, within(1e-9));
        assertThat(disc.getX()).isCloseTo(x + 2 * back * 0.18, within(1e-9));
        assertThat(disc.getY()).isCloseTo(y - 3 * back * 0.18 * Math.tan(steep), within(1e-9));
        assertThat(wedge.getVelocityX()).isCloseTo(-back * 0.6, within(1e-9));
    }
}
