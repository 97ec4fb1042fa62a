// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Rectangle;

/**
 * Bodies that slide and roll on what turns, or turn on what stands: of second order in the substep, as normals, gaps and levers are those of where the
 * bodies have gone. With the normals of a step's start errors were of first order in the step, however many substeps it had.
 */
class SteppedTurnTest {
    private static Body put(PhysicsEngine engine, Body body, double friction) {
        body.setFriction(friction);
        body.setRestitution(0);
        return engine.add(body);
    }

    /** On a heavy bar that turns at ω a disc rolls outwards as cosh(√⅔ ω t), and a smooth one slides as cosh(ω t); it was off by 0.03 to 0.09. */
    @ParameterizedTest
    @CsvSource({"0.5, 60, 1", "0.5, 60, 4", "0.5, 60, 16", "0.5, 240, 4", "0, 60, 1", "0, 60, 4", "0, 60, 16"})
    void aDiscGoesOutwardsOnATurningBar(double friction, int stepsInASecond, int substeps) {
        double radius = 0.2;
        double omega = 2;
        double high = radius + 0.1;
        double rate = friction > 0 ? Math.sqrt(2.0 / 3) * omega : omega;
        PhysicsEngine engine = Stepped.engine(1.0 / stepsInASecond, substeps);
        Body bar = put(engine, new Body(new Rectangle(20, 0.2)).moving(0, 0, omega), friction);
        bar.setMass(1e9);
        Body disc = put(engine, new Body(new Circle(radius)).at(1, high), friction);
        disc.setVelocity(rate - omega * high, omega);
        disc.setAngularVelocity(friction > 0 ? omega - rate / radius : 0);
        Stepped.run(engine, 4 * stepsInASecond / 5);
        double along = disc.getX() * Math.cos(bar.getAngle()) + disc.getY() * Math.sin(bar.getAngle());
        double substep = 60.0 / stepsInASecond / substeps;
        assertThat(along).isCloseTo(Math.exp(rate * 0.8), within(1e-2 * substep * substep));
    }

    /** In the groove of a heavy turntable r″ = ω² r − 2 μ ω r′, as one of the two walls presses. */
    @ParameterizedTest
    @CsvSource({"0, 1", "0, 4", "0, 16", "0.2, 1", "0.2, 4", "0.2, 16"})
    void aBoxSlidesInTheGrooveOfATurntable(double friction, int substeps) {
        double omega = 2;
        double rate = omega * (Math.sqrt(friction * friction + 1) - friction);
        PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
        Body table = put(engine, new Body(new Compound(Compound.box(0, 0.3, 8, 0.2), Compound.box(0, -0.3, 8, 0.2))).moving(0, 0, omega), friction);
        table.setMass(1e9);
        engine.add(new PinJoint(table, 0, 0));
        Body box = put(engine, new Body(new Rectangle(0.4, 0.4)).at(0.5, 0).moving(0.5 * rate, 0.5 * omega, omega), friction);
        Stepped.run(engine, 60);
        assertThat(Math.hypot(box.getX(), box.getY())).isCloseTo(0.5 * Math.exp(rate), within(1e-2 / substeps / substeps));
    }

    /** A plank on two belts that run towards one another swings at ω² = μ g / (l − μ h / 2); it was off by 5 mm in any substeps. */
    @ParameterizedTest
    @ValueSource(ints = {1, 4, 16})
    void aPlankSwingsOnTwoBelts(int substeps) {
        double thickness = 0.1;
        double friction = 0.3;
        PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
        engine.add(new Gravity(0, -Stepped.G));
        for (int side = -1; side <= 1; side += 2) {
            put(engine, Body.fixed(new Circle(0.3)).at(side, -0.3), friction).setBeltSpeed(6 * side);
        }
        Body plank = put(engine, new Body(new Rectangle(6, thickness)).at(0.2, 0.5 * thickness), friction);
        Stepped.run(engine, 120);
        double omega = Math.sqrt(friction * Stepped.G / (1 - 0.5 * friction * thickness));
        assertThat(plank.getX()).isCloseTo(0.2 * Math.cos(2 * omega), within(3e-3 / substeps / substeps));
    }

    /** A plank that rolls on a fixed cylinder keeps its energy; it gained a tenth of a joule, of 3.4, in any substeps. */
    @ParameterizedTest
    @ValueSource(ints = {1, 4, 16})
    void aPlankRocksOnACylinder(int substeps) {
        double lean = 0.3;
        double high = 1.15;
        PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
        engine.add(new Gravity(0, -Stepped.G));
        put(engine, Body.fixed(new Circle(1)), 3);
        double x = high * Math.sin(lean) - lean * Math.cos(lean);
        double y = high * Math.cos(lean) + lean * Math.sin(lean);
        Body plank = put(engine, new Body(new Rectangle(3, 0.3)).at(x, y, -lean), 3);
        plank.setMass(2);
        for (int k = 0; k < 120; k++) {
            engine.step();
            double gained = plank.kineticEnergy() + 2 * Stepped.G * (plank.getY() - y);
            assertThat(gained).isCloseTo(0, within(3e-2 / substeps));
        }
    }

    /** A disc with another one in it, beside its middle, rolls as it would with a weight that is welded to it, and keeps its energy. */
    @ParameterizedTest
    @ValueSource(ints = {1, 4, 16})
    void aDiscOfTwoPartsRolls(int substeps) {
        double off = 0.04;
        double start = 1.2;
        PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
        engine.add(new Gravity(0, -Stepped.G));
        put(engine, Body.fixed(new Rectangle(100, 2)).at(0, -1), 2);
        Body disc = put(engine, new Body(new Compound(Compound.disc(0, 0, 0.5), Compound.disc(0, -0.2, 0.25))), 2);
        disc.setPosition(off * Math.sin(start), 0.5 - off * Math.cos(start));
        disc.setAngle(start);
        disc.setMass(2, 0.2);
        double before = 2 * Stepped.G * disc.getY();
        for (int k = 0; k < 120; k++) {
            engine.step();
            double swing = disc.getAngle();
            assertThat(disc.kineticEnergy() + 2 * Stepped.G * disc.getY()).isCloseTo(before, within(3e-2 / substeps));
            assertThat(disc.getX() - off * Math.sin(swing)).isCloseTo(-0.5 * (swing - start), within(2e-3 / substeps));
        }
    }
}
