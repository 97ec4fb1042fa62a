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
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;

/** Heavy bodies on light ones, by time stepping: statics, momentum and Coulomb's law know of no masses that are too unlike. */
class UnlikeMassesTest {
    /** What stands stands as it was put: ten boxes of which the top one is heavy. It was off by 0.26 at 100 times the mass, and fell at all others here. */
    @ParameterizedTest
    @CsvSource({"100, 60, 4", "100, 60, 1", "100, 240, 1", "1e4, 60, 4", "1e4, 60, 1", "1e4, 240, 4", "1e6, 60, 4"})
    void aHeavyBoxStandsOnAStackOfLightOnes(double mass, double rate, int substeps) {
        PhysicsEngine engine = Stepped.engine(1 / rate, substeps);
        Body[] stack = Stepped.stack(engine, 10);
        stack[9].setMass(mass);
        Stepped.run(engine, (int) (3 * rate));
        for (int k = 0; k < 10; k++) {
            assertThat(Math.hypot(stack[k].getX(), stack[k].getY() - 0.5 - k)).as("box %d", k).isLessThan(1e-3);
            assertThat(stack[k].getAngle()).isCloseTo(0, within(1e-4));
        }
        assertThat(Stepped.fastest(engine)).isLessThan(1e-6);
    }

    /** A plank under a heavy box does not sink in: it was 3, 30 and 200 mm deep. */
    @ParameterizedTest
    @ValueSource(doubles = {15, 150, 1500})
    void aHeavyBoxPressesAPlankIntoNothing(double mass) {
        PhysicsEngine engine = Stepped.onGround(1.0 / 60, 4);
        Body plank = Stepped.box(engine, 4, 0.2, 1, 0, 0.1);
        Body heavy = Stepped.box(engine, 1, 1, mass, 0.3, 0.7);
        Stepped.run(engine, 240);
        assertThat(Stepped.depth(engine)).isLessThan(3e-4);
        assertThat(plank.getX()).isCloseTo(0, within(1e-5));
        assertThat(heavy.getX()).isCloseTo(0.3, within(1e-5));
    }

    /** A slab on five discs lies level, and they bear its weight. */
    @Test
    void aSlabLiesOnDiscs() {
        PhysicsEngine engine = Stepped.onGround(1.0 / 60, 4);
        Body[] discs = new Body[5];
        for (int k = 0; k < 5; k++) {
            discs[k] = Stepped.rough(engine.add(new Body(new Circle(0.5)).at(1.1 * k, 0.5)));
            discs[k].setMass(1, 0.125);
        }
        Body slab = Stepped.box(engine, 6, 0.4, 300, 2.2, 1.2);
        Stepped.run(engine, 120);
        assertThat(slab.getY()).isCloseTo(1.2, within(2e-4));
        assertThat(slab.getAngle()).isCloseTo(0, within(1e-5));
        double borne = engine.contacts(slab).stream().mapToDouble(contact -> Math.abs(contact.normalForce() * contact.normalY())).sum();
        assertThat(borne).isCloseTo(300 * Stepped.G, within(1.0));
    }

    /** A heavy box falls onto a stack, and both stand: it fell through, and threw the stack away. */
    @ParameterizedTest
    @CsvSource({"60, 4", "240, 1", "240, 4"})
    void aHeavyBoxFallsOntoAStack(double rate, int substeps) {
        PhysicsEngine engine = Stepped.engine(1 / rate, substeps);
        Body[] stack = Stepped.stack(engine, 6);
        Body heavy = Stepped.box(engine, 1, 1, 100, 0.1, 8.5);
        double energy = 100 * Stepped.G * 8.5;
        for (int k = 0; k < 4 * rate; k++) {
            engine.step();
            assertThat(100 * Stepped.G * heavy.getY() + heavy.kineticEnergy()).isLessThan(1.001 * energy);
            assertThat(Stepped.depth(engine)).isLessThan(0.02);
        }
        assertThat(heavy.getY()).isCloseTo(6.5, within(2e-3));
        assertThat(stack[0].getY()).isCloseTo(0.5, within(1e-3));
    }

    /**
     * A heavy box slides on a light plank that lies on ice until both go on at M v / (M + m). On its way on the plank it loses v² / (2 μ g (1 + M / m)).
     * Impulses that pass through the plank are a thousand times what it would bear itself.
     */
    @ParameterizedTest
    @ValueSource(doubles = {10, 100, 1000})
    void aHeavyBoxTakesAPlankAlong(double mass) {
        PhysicsEngine engine = Stepped.engine(1.0 / 240, 4);
        engine.add(new Gravity(0, -Stepped.G));
        Body ice = engine.add(Body.fixed(new Rectangle(1000, 2)).at(0, -1));
        ice.setRestitution(0); // and no friction
        Body plank = Stepped.box(engine, 4, 0.2, 1, 0, 0.1);
        Body heavy = Stepped.box(engine, 1, 1, mass, 0, 0.7);
        heavy.setVelocity(2, 0);
        Stepped.run(engine, 240);
        double common = 2 * mass / (mass + 1);
        double slid = 4 / (2 * 0.5 * Stepped.G * (1 + mass));
        assertThat(heavy.getVelocityX()).isCloseTo(common, within(1e-6));
        assertThat(plank.getVelocityX()).isCloseTo(common, within(1e-6));
        assertThat(heavy.getX() - plank.getX()).isCloseTo(slid, within(0.1 * slid + 1e-3));
    }

    /** A stack with a heavy box on top stands on a slope of less than μ, and slides down a steeper one at g (sin φ − μ cos φ). */
    @ParameterizedTest
    @ValueSource(doubles = {0.2, 0.4, 0.6})
    void aHeavyBoxOnLightOnesKnowsTheSlope(double angle) {
        double sin = StrictMath.sin(angle);
        double cos = StrictMath.cos(angle);
        PhysicsEngine engine = Stepped.engine(1.0 / 240, 4);
        engine.add(new Gravity(Stepped.G * sin, -Stepped.G * cos));
        Stepped.ground(engine);
        Body[] stack = {Stepped.box(engine, 3, 0.2, 1, 0, 0.1), Stepped.box(engine, 2, 0.2, 1, 0, 0.3), Stepped.box(engine, 1.5, 0.5, 200, 0, 0.65)};
        Stepped.run(engine, 240);
        double speed = Math.max(0, Stepped.G * (sin - 0.5 * cos));
        for (Body body : stack) {
            assertThat(body.getVelocityX()).isCloseTo(speed, within(1e-3 * speed + 1e-6));
            assertThat(body.getVelocityY()).isCloseTo(0, within(1e-6));
        }
    }

    /** A wedge of the slope 0.3 on the ground, and a weight of mass 5 on a rail that presses on it. */
    private static Body wedge(PhysicsEngine engine, double mass, double friction) {
        engine.add(new Gravity(0, -Stepped.G));
        Stepped.ground(engine).setFriction(friction);
        double rise = StrictMath.tan(0.3);
        Polygon below = new Polygon(0, 0, 2, 0, 2, 2 * rise);
        Polygon above = new Polygon(0.6, 0.6 * rise, 1.4, 1.4 * rise, 1.4, 1.5, 0.6, 1.5);
        Body wedge = engine.add(new Body(below).at(below.centroidX(), below.centroidY()));
        Body weight = engine.add(new Body(above).at(above.centroidX(), above.centroidY()));
        engine.add(new SliderJoint(weight, null, weight.getX(), weight.getY(), 0, 1));
        wedge.setMass(mass);
        weight.setMass(5);
        for (Body body : new Body[] {wedge, weight}) {
            body.setFriction(friction);
            body.setRestitution(0);
        }
        return wedge;
    }

    /**
     * A light wedge under a weight locks itself if twice the angle of friction is more than its slope. Friction was cut down to what presses after what presses had
     * been found with more of it: the wedge was 1.4 · 10⁻³ to 0.6 deep and ran away.
     */
    @ParameterizedTest
    @CsvSource({"0.5, 1.2", "0.05, 1.05", "0.05, 1.2", "0.01, 1.2", "0.01, 2", "0.002, 1.5"})
    void aWedgeLocksItself(double mass, double margin) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        Body wedge = wedge(engine, mass, margin * StrictMath.tan(0.15));
        double x = wedge.getX();
        Stepped.run(engine, 60);
        assertThat(wedge.getX()).isCloseTo(x, within(1e-4));
        assertThat(Stepped.depth(engine)).isLessThan(2e-4);
    }

    /** With less friction it is driven out, with what all forces give. */
    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.05, 0.01})
    void aWedgeIsDrivenOut(double mass) {
        double friction = 0.7 * StrictMath.tan(0.15);
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        Body wedge = wedge(engine, mass, friction);
        double x = wedge.getX();
        Stepped.run(engine, 12);
        double cos = StrictMath.cos(0.3);
        double sin = StrictMath.sin(0.3);
        double up = cos + friction * sin; // of what the face presses with
        double out = sin - friction * cos - friction * up;
        double press = 5 * (Stepped.G + friction * Stepped.G * sin / cos) / (up + 5 * out * sin / (mass * cos));
        double rate = (press * out - friction * mass * Stepped.G) / mass;
        assertThat(wedge.getX() - x).isCloseTo(rate / 50, within(0.05 * rate / 50));
        assertThat(Stepped.depth(engine)).isLessThan(1e-3);
    }
}
