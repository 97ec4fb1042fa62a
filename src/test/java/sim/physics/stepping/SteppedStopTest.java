// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.GearJoint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Stops that are struck: v⁺ = −e v⁻ of the coordinate, with all that holds the bodies meanwhile, and nothing of it is lost in the next steps. */
class SteppedStopTest {
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private static Body smooth(PhysicsEngine engine, Body body) {
        engine.add(body);
        body.setFriction(0);
        body.setRestitution(1);
        return body;
    }

    /** A rod on a pin at the origin. */
    private static Body rod(PhysicsEngine engine, double angle, double turning) {
        double x = 0.5 * Math.cos(angle);
        double y = 0.5 * Math.sin(angle);
        Body rod = smooth(engine, new Body(new Rectangle(1, 0.1)).at(x, y, angle).moving(-turning * y, turning * x, turning));
        engine.add(new PinJoint(rod, 0, 0));
        return rod;
    }

    private static double energy(PhysicsEngine engine, double g) {
        double sum = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            sum += body.isFixed() ? 0 : body.getMass() * g * body.getY();
        }
        return sum;
    }

    /** Largest change of energy, relative to a scale, in some steps. */
    private static double change(PhysicsEngine engine, double g, double scale, int steps) {
        double start = energy(engine, g);
        double most = 0;
        for (int k = 0; k < steps; k++) {
            engine.step();
            most = Math.max(most, Math.abs(energy(engine, g) - start) / scale);
        }
        return most;
    }

    @Test
    void aRodOnAPinLeavesAStopAsItsRestitutionSays() {
        for (double restitution : new double[] {0, 0.5, 1}) {
            for (int substeps : new int[] {1, 4, 16}) {
                PhysicsEngine engine = Stepped.engine(1.0 / 240, substeps);
                Body rod = rod(engine, 0.8, -2);
                engine.add(new Limit(new GearJoint(rod, null, -1), -0.8, INFINITE, restitution));
                Stepped.run(engine, 108);
                for (int k = 0; k < 12; k++) {
                    engine.step();
                    assertThat(rod.getAngularVelocity()).isCloseTo(2 * restitution, within(1e-4));
                    assertThat(Math.hypot(rod.getVelocityX(), rod.getVelocityY())).as("so says the pin").isCloseTo(restitution, within(1e-4));
                }
            }
        }
    }

    /** Wherever it is: it stopped short of it by up to the way of a substep. */
    @Test
    void whatComesToAStopIsAtIt() {
        for (int n = 0; n < 200; n++) {
            double bound = 0.5 + 0.00137 * n;
            PhysicsEngine engine = Stepped.engine(0.01, 4);
            Body wheel = smooth(engine, new Body(new Circle(0.1)).at(0, 0).moving(0, 0, 1));
            engine.add(new PinJoint(wheel, 0, 0));
            engine.add(Limit.angle(wheel, null, -1, bound));
            Stepped.run(engine, 100);
            assertThat(wheel.getAngle()).isCloseTo(bound, within(1e-12));
            assertThat(wheel.getAngularVelocity()).isCloseTo(0, within(1e-12));
        }
    }

    @Test
    void elasticStopsKeepWhatFallsOnThem() {
        for (int substeps : new int[] {4, 16}) {
            PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
            engine.add(new Gravity(0, -Stepped.G));
            Body rod = rod(engine, 0, 0);
            engine.add(new Limit(new GearJoint(rod, null, -1), -2, 1, 1));
            double most = rod.getMass() * Stepped.G * 0.5;
            assertThat(change(engine, Stepped.G, most, 600)).as("14 strikes").isLessThan(0.02);
        }
    }

    /** Each of the links strikes stops beside the one before it: some 60 strikes, of which several at once. */
    @Test
    void elasticStopsOfAChainKeepItsEnergy() {
        PhysicsEngine engine = Stepped.engine(1.0 / 240, 4);
        Body before = null;
        for (int k = 0; k < 3; k++) {
            int sign = k == 1 ? -1 : 1;
            Body link = smooth(engine, new Body(new Rectangle(1, 0.1)).at(k + 0.5, 0).moving(0, 0.5 * sign, sign));
            engine.add(before == null ? new PinJoint(link, 0, 0) : new PinJoint(before, link, k, 0));
            engine.add(new Limit(new GearJoint(link, before, -1), -0.4, 0.5, 1));
            before = link;
        }
        engine.step(); // velocities that the pins do not allow are gone
        assertThat(change(engine, 0, engine.kineticEnergy(), 1200)).isLessThan(0.02);
    }

    /** Two cranks and a coupler, a closed loop, strike the stop of one of them. */
    @Test
    void anElasticStopOfALoopKeepsItsEnergy() {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        Body crank = smooth(engine, new Body(new Rectangle(0.1, 1)).at(0, 0.5).moving(-0.5, 0, 1));
        Body rocker = smooth(engine, new Body(new Rectangle(0.1, 1.5)).at(2, 0.75).moving(-0.5, 0, 2.0 / 3));
        Body coupler = smooth(engine, new Body(new Rectangle(Math.hypot(2, 0.5), 0.1)).at(1, 1.25, Math.atan2(0.5, 2)).moving(-1, 0));
        engine.add(new PinJoint(crank, 0, 0));
        engine.add(new PinJoint(rocker, 2, 0));
        engine.add(new PinJoint(crank, coupler, 0, 1));
        engine.add(new PinJoint(coupler, rocker, 2, 1.5));
        engine.add(new Limit(new GearJoint(crank, null, -1), -0.5, 0.4, 1));
        int strikes = 0;
        double energy = engine.kineticEnergy();
        double speed = crank.getAngularVelocity();
        for (int k = 0; k < 600; k++) {
            engine.step();
            strikes += speed * crank.getAngularVelocity() < 0 ? 1 : 0;
            speed = crank.getAngularVelocity();
            assertThat(engine.kineticEnergy()).isCloseTo(energy, within(0.01 * energy));
        }
        assertThat(strikes).isGreaterThan(4);
    }

    /** Two turning rods that a rope brings to their senses: two pins and the rope take part in the impact. */
    @Test
    void aRopeBetweenPinnedRodsPullsAsByEvents() {
        double[][] turnings = new double[2][];
        for (int way = 0; way < 2; way++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1.0 / 960);
            engine.setTimeStepping(way == 0 ? 0 : 4);
            Body a = smooth(engine, new Body(new Rectangle(1, 0.1)).at(-1, 0.5, Math.PI / 2).moving(-0.5, 0, 1));
            Body b = smooth(engine, new Body(new Rectangle(1, 0.1)).at(1, 0.5, Math.PI / 2).moving(0.25, 0, -0.5));
            engine.add(new PinJoint(a, -1, 0));
            engine.add(new PinJoint(b, 1, 0));
            engine.add(new Limit(RodJoint.bodyPoints(a, 0.5, 0, b, 0.5, 0, 2.4), Double.NEGATIVE_INFINITY, 0, 0.5));
            Stepped.run(engine, 768);
            turnings[way] = new double[] {a.getAngularVelocity(), b.getAngularVelocity()};
        }
        assertThat(turnings[1]).containsExactly(turnings[0], within(1e-3));
    }

    /** A slide flies along a turning arm to its end, as Coriolis' force and the arm's pin have it, and bounces there. */
    @Test
    void aSlideBouncesOffTheEndOfATurningArm() {
        double[][] speeds = new double[2][];
        for (int way = 0; way < 2; way++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1.0 / 240);
            engine.setTimeStepping(way == 0 ? 0 : 4);
            Body arm = smooth(engine, new Body(new Rectangle(3, 0.1)).at(1.5, 0).moving(0, 3, 2));
            Body slide = smooth(engine, new Body(new Circle(0.1)).at(0.5, 0).moving(0, 1, 2));
            slide.setMass(1);
            engine.add(new PinJoint(arm, 0, 0));
            SliderJoint rail = engine.add(new SliderJoint(slide, arm, 0.5, 0, 1, 0));
            engine.add(Limit.travel(rail, -1, 0.5, 0.5));
            Stepped.run(engine, 192);
            speeds[way] = new double[] {arm.getAngularVelocity(), engine.kineticEnergy()};
        }
        assertThat(speeds[1]).containsExactly(speeds[0], within(5e-3));
    }

    /** What strikes an arm that lies on its stop strikes the stop with it: contact, pin and stop are one impact. */
    @Test
    void aBallBouncesOffAnArmThatLiesOnItsStop() {
        for (double restitution : new double[] {0, 1}) {
            PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
            Body arm = smooth(engine, new Body(new Rectangle(0.1, 2)));
            engine.add(new PinJoint(arm, 0, 0));
            engine.add(new Limit(new GearJoint(arm, null, -1), -0.5, 0, restitution));
            Body ball = smooth(engine, new Body(new Circle(0.1)).at(1, 0.7).moving(-2, 0));
            Stepped.run(engine, 120);
            assertThat(ball.getVelocityX()).isCloseTo(2, within(1e-6));
            assertThat(arm.getAngularVelocity()).isCloseTo(0, within(1e-6));
        }
    }

    /** A cart of 1 falls on its plastic stop with a load: both lie there at once, and the stop bears the two. */
    @Test
    void aPlasticStopIsDead() {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        engine.add(new Gravity(0, -Stepped.G));
        Body cart = engine.add(Stepped.rough(new Body(new Rectangle(2, 0.2)).at(0, 1)));
        cart.setMass(1);
        Body load = engine.add(Stepped.rough(new Body(new Rectangle(1, 1)).at(0, 1.6)));
        load.setMass(1);
        SliderJoint rail = engine.add(new SliderJoint(cart, null, 0, 1, 0, 1));
        Limit stop = engine.add(Limit.travel(rail, -1, 1));
        double highest = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < 90; k++) {
            engine.step();
            highest = k > 28 ? Math.max(highest, cart.getVelocityY()) : highest;
        }
        assertThat(highest).as("fastest upwards, of 4.5 downwards").isLessThan(0.02);
        assertThat(engine.getReaction(stop).forceY()).isCloseTo(2 * Stepped.G, within(0.05));
    }

    /** A lift on its lower stop, held by a brake, too, on which a box has fallen: both push up, the brake as far as it can. */
    @Test
    void aBrakeDoesNotPushAgainstTheStopAtWhichItStands() {
        for (double limit : new double[] {6000, 1000}) {
            for (int side : new int[] {1, -1}) {
                PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
                engine.setSleepAllowed(false);
                engine.add(new Gravity(0, -Stepped.G));
                Body lift = engine.add(Stepped.rough(new Body(new Rectangle(3, 0.2))));
                lift.setMass(300);
                SliderJoint rail = engine.add(new SliderJoint(lift, null, 0, 0, 0, side));
                Motor brake = engine.add(Motor.sliding(rail, 0, limit));
                Limit stop = engine.add(side > 0 ? Limit.travel(rail, 0, 10) : Limit.travel(rail, -10, 0));
                Body box = engine.add(Stepped.rough(new Body(new Rectangle(1, 1)).at(0, 1)));
                box.setMass(240);
                Stepped.run(engine, 180);
                double half = 270 * Stepped.G;
                double held = Math.min(limit, half);
                assertThat(engine.getReaction(brake).forceY()).isCloseTo(held, within(1.0));
                assertThat(engine.getReaction(stop).forceY()).isCloseTo(2 * half - held, within(1.0));
                assertThat(rail.getTravel()).isCloseTo(0, within(1e-3));
            }
        }
    }
}
