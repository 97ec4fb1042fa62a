// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Time stepping: Coulomb's law between bodies, and with the plane below them. */
class SteppedFrictionTest {
    private static final double STEP = 1.0 / 60;
    private static final double MU = 0.5;

    /** A block on a plane that is turned so that its tangent is some times the coefficient of friction. */
    private static Body slope(PhysicsEngine engine, double times) {
        double angle = Math.atan(MU * times);
        engine.add(new Gravity(Stepped.G * Math.sin(angle), -Stepped.G * Math.cos(angle)));
        Stepped.rough(engine.add(Body.fixed(new Rectangle(4000, 2)).at(0, -1)));
        return Stepped.rough(engine.add(new Body(new Rectangle(1, 0.5)).at(0, 0.25)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.5, 0.9, 0.99})
    void aBlockStaysOnASlopeThatIsNotTooSteep(double times) {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Body block = slope(engine, times);
        Stepped.run(engine, 600);
        assertThat(block.getX()).isCloseTo(0, within(1e-3));
        double x = block.getX();
        Stepped.run(engine, 600);
        assertThat(block.getX()).as("it does not creep").isCloseTo(x, within(1e-6));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1.05, 1.5, 3})
    void aBlockSlidesDownASteeperOneAsCoulombSays(double times) {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Body block = slope(engine, times);
        Stepped.run(engine, 60);
        double v = block.getVelocityX();
        Stepped.run(engine, 240);
        double angle = Math.atan(MU * times);
        double a = Stepped.G * (Math.sin(angle) - MU * Math.cos(angle));
        assertThat((block.getVelocityX() - v) / 4).isCloseTo(a, within(1e-6 * a));
    }

    /**
     * A box slides outwards on a heavy bar that turns at 1 rad/s and presses it on: r″ = r − μ (2 r′ − d), from r = r′ = 1. Friction was bounded by
     * what regains depth, too, and the more so the shorter substeps were: r was 2.05 in place of 2.47.
     */
    @ParameterizedTest
    @CsvSource({"60, 1", "60, 4", "60, 16", "240, 4", "240, 16"})
    void aTurningBarRubsNoMoreThanItPresses(double stepsInASecond, int substeps) {
        double friction = 0.2;
        double height = 0.3;
        PhysicsEngine engine = Stepped.engine(1 / stepsInASecond, substeps);
        Body bar = engine.add(new Body(new Rectangle(20, 0.2)).moving(0, 0, 1));
        bar.setMass(4e7);
        bar.setFriction(friction);
        Body box = engine.add(new Body(new Rectangle(0.4, 0.4)).at(1, height).moving(1 - height, 1, 1));
        box.setFriction(friction);
        box.setRestitution(0);
        bar.setRestitution(0);
        Stepped.run(engine, (int) stepsInASecond);
        double root = Math.sqrt(friction * friction + 1);
        double rest = -friction * height; // where it would stay
        double fast = (1 + (root + friction) * (1 - rest)) / (2 * root);
        double exact = rest + fast * Math.exp(root - friction) + (1 - rest - fast) * Math.exp(-root - friction);
        double along = box.getX() * Math.cos(bar.getAngle()) + box.getY() * Math.sin(bar.getAngle());
        assertThat(along).isCloseTo(exact, within(0.2 / stepsInASecond));
    }

    /** A box tips on a corner that sticks, to a floor or to a plate on two pins, as a pendulum on its head: it was off by 4 · 10⁻³ rad in any substeps. */
    @ParameterizedTest
    @CsvSource({"60, 4, false", "240, 1, false", "60, 4, true", "240, 1, true"})
    void aBoxTipsOnItsCorner(double stepsInASecond, int substeps, boolean isPinned) {
        PhysicsEngine engine = Stepped.engine(1 / stepsInASecond, substeps);
        engine.add(new Gravity(0, -Stepped.G));
        Body floor = isPinned ? new Body(new Rectangle(20, 2)) : Body.fixed(new Rectangle(20, 2));
        Stepped.rough(engine.add(floor.at(0, -1)));
        if (isPinned) {
            engine.add(new PinJoint(floor, -5, -1));
            engine.add(new PinJoint(floor, 5, -1));
        }
        double lean = -0.25 * Math.PI + 0.3; // of the diagonal from upright
        double arm = Math.sqrt(0.5);
        Body box = new Body(new Rectangle(1, 1)).at(arm * Math.sin(lean), arm * Math.cos(lean), -0.3);
        box.setFriction(1);
        floor.setFriction(1);
        engine.add(box.moving(arm * Math.cos(lean), -arm * Math.sin(lean), -1));
        box.setRestitution(0);
        Stepped.run(engine, (int) (0.5 * stepsInASecond));
        double rate = 1;
        int parts = 100_000;
        double h = 0.5 / parts;
        for (int k = 0; k < parts; k++) { // the middle of each part, which is good to 10⁻¹⁰
            double half = lean + 0.5 * h * rate;
            rate += h * Stepped.G * arm * Math.sin(half) / (1.0 / 6 + arm * arm);
            lean = half + 0.5 * h * rate;
        }
        assertThat(-box.getAngle()).isCloseTo(lean + 0.25 * Math.PI, within(3e-4));
    }

    /** What strikes while it slides loses μ times what it gets across, whatever it bounces with, and a disc spins by that. */
    @ParameterizedTest
    @CsvSource({"0, true, 4", "0.5, true, 4", "1, true, 4", "0, false, 4", "0.5, false, 4", "1, false, 4", "0.5, true, 1", "0, true, 16"})
    void anImpactRubsAsCoulombSays(double restitution, boolean isDisc, int substeps) {
        PhysicsEngine engine = Stepped.engine(STEP, substeps);
        Body ground = Stepped.rough(engine.add(Body.fixed(new Rectangle(100, 1)).at(0, -0.5)));
        Body body = Stepped.rough(engine.add(new Body(isDisc ? new Circle(0.5) : new Rectangle(1, 1)).at(0, 0.8).moving(4, -2)));
        ground.setFriction(0.1);
        ground.setRestitution(1);
        body.setFriction(0.1);
        body.setRestitution(restitution);
        Stepped.run(engine, 11);
        double along = 0.1 * (1 + restitution) * 2;
        assertThat(body.getVelocityY()).isCloseTo(2 * restitution, within(0.01));
        assertThat(body.getVelocityX()).isCloseTo(4 - along, within((isDisc ? 0.01 : 0.2) * along)); // a box rattles
        if (isDisc) {
            assertThat(body.getAngularVelocity()).isCloseTo(-along / 0.25, within(0.05 * along / 0.25)); // its arm is taken where the step begins
        }
    }

    /** A box that falls flat, under weight: half of it was lost where an impact lasted for more than a substep. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whatFallsAndSlidesOnIsBrakedByItsFall(boolean isDisc) {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(new Gravity(0, -10));
        Stepped.rough(engine.add(Body.fixed(new Rectangle(100, 1)).at(0, -0.5))).setFriction(0.2);
        Body body = Stepped.rough(engine.add(new Body(isDisc ? new Circle(0.5) : new Rectangle(1, 1)).at(0, 0.8).moving(9, 0)));
        body.setFriction(0.2);
        Stepped.run(engine, 30);
        double fallen = Math.sqrt(2 * 10 * 0.3);
        double left = 0.5 - fallen / 10;
        assertThat(body.getVelocityX()).isCloseTo(9 - 0.2 * (fallen + 10 * left), within(0.05));
    }

    /** What slides to rest is off by less in shorter substeps: v² / 2 μ g. */
    @Test
    void theWayOfABlockThatSlidesToRestIsOfFirstOrder() {
        double[] miss = new double[3];
        for (int k = 0; k < 3; k++) {
            PhysicsEngine engine = Stepped.engine(STEP, 2 << 2 * k);
            engine.add(new Gravity(0, -Stepped.G));
            Stepped.ground(engine);
            Body block = Stepped.rough(engine.add(new Body(new Rectangle(2, 0.2)).at(0, 0.1).moving(4, 0)));
            Stepped.run(engine, 120);
            assertThat(block.getVelocityX()).isCloseTo(0, within(1e-9));
            miss[k] = Math.abs(block.getX() - 16 / (2 * MU * Stepped.G));
        }
        assertThat(miss[0]).isLessThan(0.03);
        assertThat(miss[1]).isLessThan(miss[0] / 2);
        assertThat(miss[2]).isLessThan(miss[1] / 2);
    }

    /** A ball that is thrown without spin rolls in the end with 2/3 of its speed if it is a disc of uniform density. */
    @Test
    void aDiscThatSlidesRollsInTheEndAndDoesNotSink() {
        for (int substeps : new int[] {1, 4}) {
            PhysicsEngine engine = Stepped.engine(STEP, substeps);
            engine.add(new Gravity(0, -Stepped.G));
            Stepped.ground(engine);
            Body disc = Stepped.rough(engine.add(new Body(new Circle(0.5)).at(-100, 0.5).moving(6, 0)));
            Stepped.run(engine, 120);
            for (int k = 0; k < 900; k++) {
                engine.step();
                assertThat(disc.getVelocityX()).isCloseTo(4, within(0.02));
                assertThat(disc.getAngularVelocity()).isCloseTo(-2 * disc.getVelocityX(), within(1e-6));
                assertThat(disc.getY()).isCloseTo(0.5, within(1e-3));
            }
        }
    }

    private static Body onPlane(PhysicsEngine engine, Shape shape) {
        engine.add(new SurfaceFriction(Stepped.G));
        Body body = engine.add(new Body(shape));
        body.setSurfaceFriction(0.3, 0.4);
        return body;
    }

    @ParameterizedTest
    @CsvSource({"1, false", "4, false", "16, false", "256, false", "1, true", "4, true", "16, true", "256, true"})
    void whatSlidesOnThePlaneStopsInItsTimeAndOnItsWay(int substeps, boolean isBox) {
        PhysicsEngine engine = Stepped.engine(STEP, substeps);
        Body body = onPlane(engine, isBox ? new Rectangle(1, 2) : new Circle(0.5)).moving(3, 4);
        double time = 5 / (0.3 * Stepped.G);
        double way = 25 / (2 * 0.3 * Stepped.G);
        double last = 5;
        while (body.getVelocityX() != 0 && engine.getTime() < 10) {
            engine.step();
            double along = 0.6 * body.getVelocityX() + 0.8 * body.getVelocityY();
            assertThat(along).isBetween(0.0, last);
            last = along;
        }
        assertThat(engine.getTime()).isCloseTo(time, within(0.02 * time));
        assertThat(Math.hypot(body.getX(), body.getY())).isCloseTo(way, within(0.02 * way));
        assertThat(body.getVelocityY()).isZero();
        assertThat(body.getAngle()).isZero();
    }

    /** The torque of a disc of uniform pressure that spins is 2/3 μ m g r, so it spins for 3 r ω / 4 μ g. */
    @ParameterizedTest
    @ValueSource(ints = {1, 4, 16, 256})
    void whatSpinsOnThePlaneStopsInItsTime(int substeps) {
        PhysicsEngine engine = Stepped.engine(STEP, substeps);
        Body body = onPlane(engine, new Circle(0.5)).moving(0, 0, 20);
        double time = 3 * 0.5 * 20 / (4 * 0.3 * Stepped.G);
        double last = 20;
        while (body.getAngularVelocity() != 0 && engine.getTime() < 10) {
            engine.step();
            assertThat(body.getAngularVelocity()).isBetween(0.0, last);
            last = body.getAngularVelocity();
        }
        assertThat(engine.getTime()).isCloseTo(time, within(0.02 * time));
        assertThat(body.getAngle()).isCloseTo(0.5 * 20 * time, within(0.02 * 10 * time));
        assertThat(body.getX()).isZero();
    }

    /** A disc that slides and spins stops doing both at the same time, as all limit surfaces have it. */
    @ParameterizedTest
    @ValueSource(ints = {1, 4, 64})
    void slidingAndSpinningEndTogether(int substeps) {
        PhysicsEngine engine = Stepped.engine(STEP, substeps);
        Body body = onPlane(engine, new Circle(0.5)).moving(3, 0, 6);
        double slides = 0;
        double spins = 0;
        for (int k = 0; k < 300; k++) {
            engine.step();
            slides = body.getVelocityX() != 0 ? engine.getTime() : slides;
            spins = body.getAngularVelocity() != 0 ? engine.getTime() : spins;
        }
        assertThat(slides).isCloseTo(spins, within(2 * STEP)).isGreaterThan(1);
    }

    @Test
    void whatRestsStaysToTheLastBitUntilItIsPushedHardEnough() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Body body = onPlane(engine, new Rectangle(1, 2)).at(0.1, 0.2, 0.3);
        body.setMass(2);
        for (int k = 0; k < 100; k++) {
            body.addForce(0, 7.9);
            engine.step();
            assertThat(body.getY()).isEqualTo(0.2);
            assertThat(body.getVelocityY()).isZero();
            assertThat(body.getAngle()).isEqualTo(0.3);
        }
        for (int k = 0; k < 60; k++) {
            body.addForce(0, 8.1);
            engine.step();
        }
        double a = (8.1 - 0.3 * 2 * Stepped.G) / 2;
        assertThat(body.getVelocityY()).isCloseTo(a, within(0.01 * a));
    }

    /** Two bodies flush on the plane, 2 and 3 kg; static friction bears 11.8 N and kinetic 8.8 N of a push that begins at once. */
    private static PhysicsEngine pushed(int substeps) {
        PhysicsEngine engine = Stepped.engine(STEP, substeps);
        engine.add(new SurfaceFriction(9.81));
        Body box = engine.add(new Body(new Rectangle(1, 1)).at(1, 0));
        box.setMass(3);
        box.setSurfaceFriction(0.3, 0.4);
        Body pusher = engine.add(new Body(new Circle(0.5)).at(0, 0));
        pusher.setMass(2);
        Stepped.rough(box);
        Stepped.rough(pusher);
        Stepped.run(engine, 60);
        return engine;
    }

    private static void push(PhysicsEngine engine, double force, int steps) {
        for (int k = 0; k < steps; k++) {
            engine.bodies().get(1).addForce(force, 0);
            engine.step();
        }
    }

    /** It overshoots in the first substeps: that tore the box off from 9 N on. */
    @ParameterizedTest
    @ValueSource(doubles = {8, 9, 9.5, 10, 10.5, 11})
    void staticFrictionBearsASuddenPush(double force) {
        PhysicsEngine engine = pushed(4);
        push(engine, force, 120);
        assertThat(engine.bodies().get(0).getX()).isEqualTo(1, within(2e-4));
        assertThat(engine.bodies().get(0).getVelocityX()).isEqualTo(0, within(1e-9));
    }

    @ParameterizedTest
    @ValueSource(doubles = {12.5, 14, 20})
    void beyondItTheyGoOnAgainstKineticFriction(double force) {
        PhysicsEngine engine = pushed(4);
        push(engine, force, 30);
        double before = engine.bodies().get(0).getVelocityX();
        push(engine, force, 60);
        assertThat(engine.bodies().get(0).getVelocityX() - before).isEqualTo((force - 0.3 * 3 * 9.81) / 5, within(1e-6));
    }

    /** However few the substeps of a step are, it is soon kinetic friction that they go on against. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void soonItIsKineticFriction(int substeps) {
        PhysicsEngine engine = pushed(substeps);
        push(engine, 12.5, 14);
        double before = engine.bodies().get(0).getVelocityX();
        push(engine, 12.5, 10);
        assertThat(engine.bodies().get(0).getVelocityX() - before).isEqualTo((12.5 - 0.3 * 3 * 9.81) / 5 / 6, within(1e-3));
    }
}
