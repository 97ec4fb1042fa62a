// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Curve;
import sim.physics.constraint.GearJoint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.Reaction;

import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.constraint.WireJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping of joints, motors and stops. */
class SteppedJointTest {
    private static final double STEP = 1.0 / 60;

    private static Body link(PhysicsEngine engine, double x) {
        Body link = engine.add(new Body(new Rectangle(1, 0.2)).at(x, 0));
        link.setCollisionGroup(1, 0);
        return link;
    }

    /** A chain of links of length 1 from the origin to the right. */
    private static Body[] chain(PhysicsEngine engine, int count) {
        engine.add(new Gravity(0, -Stepped.G));
        Body[] links = new Body[count];
        for (int k = 0; k < count; k++) {
            links[k] = link(engine, k + 0.5);
            engine.add(k == 0 ? new PinJoint(links[0], 0, 0) : new PinJoint(links[k - 1], links[k], k, 0));
        }
        return links;
    }

    private static double[] angles(int count, int substeps, double step, double time) {
        PhysicsEngine engine = Stepped.engine(step, substeps);
        Body[] links = chain(engine, count);
        Stepped.run(engine, (int) Math.round(time / step));
        double[] angles = new double[count];
        for (int k = 0; k < count; k++) {
            angles[k] = links[k].getAngle();
        }
        return angles;
    }

    /** Pendulums, against events and RK4: a quarter of the substep misses by a sixteenth. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void pendulumsAreOfSecondOrder(int count) {
        double[] exact = angles(count, 0, 1.0 / 960, 1);
        double last = Double.NaN;
        for (int substeps : new int[] {8, 32, 128}) {
            double[] angles = angles(count, substeps, STEP, 1);
            double miss = 0;
            for (int k = 0; k < count; k++) {
                miss = Math.max(miss, Math.abs(angles[k] - exact[k]));
            }
            assertThat(miss).isLessThan(0.06 / (substeps * substeps));
            if (!Double.isNaN(last)) {
                assertThat(last / miss).isBetween(12.0, 20.0);
            }
            last = miss;
        }
    }

    /** The largest miss of something in some seconds. */
    private static double worst(PhysicsEngine engine, ToDoubleFunction<PhysicsEngine> miss) {
        double worst = 0;
        for (int k = 0; k < 300; k++) {
            engine.step();
            worst = Math.max(worst, Math.abs(miss.applyAsDouble(engine)));
        }
        return worst;
    }

    /** What a joint misses with some substeps; the sizes are about 1. */
    private static double miss(int which, int substeps) {
        PhysicsEngine engine = Stepped.engine(STEP, substeps);
        engine.add(new Gravity(0, -Stepped.G));
        Body a = link(engine, 0.5);
        Body b = link(engine, 1.5);
        engine.add(new PinJoint(a, 0, 0));
        switch (which) {
            case 0 -> {
                engine.add(new PinJoint(a, b, 1, 0));
                return worst(engine, e -> Math.hypot(
                        a.worldX(0.5, 0) - b.worldX(-0.5, 0), a.worldY(0.5, 0) - b.worldY(-0.5, 0)));
            }
            case 1 -> {
                engine.add(new WeldJoint(a, b, 1, 0));
                return worst(engine, e -> Math.hypot(
                                a.worldX(0.5, 0) - b.worldX(-0.5, 0), a.worldY(0.5, 0) - b.worldY(-0.5, 0))
                        + Math.abs(a.getAngle() - b.getAngle()));
            }
            case 2 -> {
                engine.add(new RodJoint(a, 0.5, 0, b, 0.5, 0, 1));
                return worst(engine, e -> Math.hypot(
                                a.worldX(0.5, 0) - b.worldX(0.5, 0), a.worldY(0.5, 0) - b.worldY(0.5, 0)) - 1);
            }
            case 3 -> {
                SliderJoint rail = engine.add(new SliderJoint(a, b, 1, 0, 1, 0));
                engine.add(Limit.travel(rail, -0.5, 0.5));
                return worst(engine, e -> Math.abs(a.getAngle() - b.getAngle())
                        + Math.max(0, Math.abs(rail.getTravel()) - 0.5));
            }
            case 4 -> {
                engine.add(new PinJoint(b, 1.5, 0));
                engine.add(new GearJoint(a, b, 2));
                b.setAngularVelocity(0);
                double start = a.getAngle() + 2 * b.getAngle();
                return worst(engine, e -> a.getAngle() + 2 * b.getAngle() - start);
            }
            default -> {
                Body bead = engine.add(new Body(new Circle(0.1)).at(6, 0));
                engine.add(new WireJoint(bead, Curve.circle(5, 0, 1)));
                return worst(engine, e -> Math.hypot(bead.getX() - 5, bead.getY()) - 1);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5})
    void jointsHoldAndTheBetterTheShorterSubstepsAre(int which) {
        double usual = miss(which, 4);
        assertThat(usual).isLessThan(0.01);
        assertThat(miss(which, 32)).isLessThan(0.25 * usual + 1e-9);
    }

    @Test
    void whatHangsPullsWithItsWeightAndBreaksAJointThatBearsLess() {
        for (double mass : new double[] {4.9, 5.1}) {
            PhysicsEngine engine = Stepped.engine(STEP, 4);
            engine.add(new Gravity(0, -Stepped.G));
            Body body = engine.add(new Body(new Circle(0.5)).at(0, -1));
            body.setMass(mass);
            RodJoint rod = engine.add(new RodJoint(body, 0, 0, null, 0, 0, 1));
            Stepped.run(engine, 100);
            Reaction reaction = engine.getReaction(rod);
            assertThat(reaction.forceY()).isCloseTo(mass * Stepped.G, within(1e-3 * mass * Stepped.G));
            assertThat(reaction.forceX()).isCloseTo(0, within(1e-9));
            rod.setBreakingLoad(50, Double.POSITIVE_INFINITY);
            Stepped.run(engine, 60);
            assertThat(engine.contains(rod)).isEqualTo(mass < 5);
            assertThat(body.getY() < -1.5).isEqualTo(mass > 5);
        }
    }

    @Test
    void aBeamThatIsWeldedToTheWorldHasItsWeightAndItsMomentAsReaction() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(new Gravity(0, -Stepped.G));
        Body beam = engine.add(new Body(new Rectangle(2, 0.5)).at(1, 0)); // of mass 1
        WeldJoint weld = engine.add(new WeldJoint(beam, null, 0, 0));
        Stepped.run(engine, 300);
        Reaction reaction = engine.getReaction(weld);
        assertThat(reaction.forceY()).isCloseTo(Stepped.G, within(1e-2));
        assertThat(reaction.torque()).isCloseTo(0, within(1e-2)); // about its own centre nothing turns it
    }

    /** A motor of torque M turns a wheel of moment I by M t / I until it has its speed, and keeps that. */
    @Test
    void aMotorKeepsItsLimitAndThenItsSpeed() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Body wheel = engine.add(new Body(new Circle(1)));
        wheel.setMass(2, 3);
        engine.add(new PinJoint(wheel, 0, 0));
        Motor motor = engine.add(Motor.turning(wheel, null, 4, 6));
        Stepped.run(engine, 60);
        assertThat(wheel.getAngularVelocity()).isCloseTo(2, within(1e-9));
        assertThat(engine.getReaction(motor).torque()).isCloseTo(6, within(1e-9));
        Stepped.run(engine, 120);
        assertThat(wheel.getAngularVelocity()).isCloseTo(4, within(1e-9));
        wheel.addTorque(-7);
        engine.step();
        assertThat(wheel.getAngularVelocity()).as("more than it bears").isCloseTo(4 - 1.0 / 3 * STEP, within(1e-9));
        motor.setSpeed(-1);
        Stepped.run(engine, 300);
        assertThat(wheel.getAngularVelocity()).isCloseTo(-1, within(1e-9));
    }

    @Test
    void aStopBouncesWithItsRestitutionAndHoldsWithoutOne() {
        for (double restitution : new double[] {0, 0.5, 1}) {
            PhysicsEngine engine = Stepped.engine(STEP, 4);
            Body cart = engine.add(new Body(new Rectangle(1, 0.5)).moving(2, 0));
            SliderJoint rail = engine.add(new SliderJoint(cart, null, 0, 0, 1, 0));
            engine.add(Limit.travel(rail, -1, 1, restitution));
            for (int k = 0; k < 45; k++) {
                engine.step();
                assertThat(cart.getX()).isLessThan(1.001);
            }
            assertThat(cart.getVelocityX()).isCloseTo(-2 * restitution, within(1e-9));
        }
    }

    /** A rope that is slack leaves a body alone, and then holds it. */
    @Test
    void aRopeIsSlackUntilItIsTaut() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(new Gravity(0, -Stepped.G));
        Body body = engine.add(new Body(new Circle(0.1)));
        engine.add(Limit.rope(body, 0, 0, null, 0, 0, 2));
        Stepped.run(engine, 30);
        assertThat(body.getY()).isCloseTo(-0.5 * Stepped.G * 0.25, within(0.05));
        Stepped.run(engine, 60);
        assertThat(body.getY()).isCloseTo(-2, within(1e-3));
        assertThat(Stepped.fastest(engine)).isLessThan(1e-6);
    }

    /** A step that ends with an exception has loaded joints, too: what is reported of it is what they break under. */
    @Test
    void aJointBreaksUnderWhatIsReportedOfAStepThatFailed() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Body body = engine.add(new Body(new Circle(0.5)).at(0, -1));
        PinJoint pin = engine.add(new PinJoint(body, 0, 0));
        int[] calls = {0};
        engine.add((ForceGenerator) (b, time, forces) -> {
            if (++calls[0] == 25) { // five times a step: when it begins, and at the end of each substep
                throw new UnsupportedOperationException("in the last substep");
            }
            forces.add(b, 0, calls[0] > 21 ? -1000 : -1);
        });
        pin.setBreakingLoad(100, Double.POSITIVE_INFINITY);
        for (int k = 0; k < 4; k++) {
            engine.step();
        }
        assertThatThrownBy(engine::step).isInstanceOf(UnsupportedOperationException.class);
        assertThat(engine.getReaction(pin).force()).isGreaterThan(100);
        assertThat(engine.contains(pin)).isTrue();
        engine.step();
        assertThat(engine.contains(pin)).isFalse();
    }
}
