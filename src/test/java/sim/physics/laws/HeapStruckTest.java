// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Heaps have got what forces give them up to the end of the step: a bounce must not give that back as energy. */
class HeapStruckTest {
    private static final double G = 10;

    /** Discs in a row on the ground, all heavy but for one, and one that is shot along it: none of them may leave the ground. */
    @ParameterizedTest
    @CsvSource({"1, 1, 0", "1, 1, 0.7", "1, 0.5, 0", "0.1, 1, 0.7", "0.1, 0.5, 0.3", "0.01, 1, 0", "0.01, 0.9, 0.7"})
    void rowThatIsStruckStaysOnTheGround(double step, double restitution, double friction) {
        PhysicsEngine engine = box(step, restitution, friction);
        for (int k = 0; k < 7; k++) {
            add(engine, new Body(new Circle(0.5)).at(-3.3 + k, -4.5), k == 0 ? 1 : 300, restitution, friction);
        }
        add(engine, new Body(new Circle(0.5)).at(-4.4, -4.5).moving(2, 0), 300, restitution, friction);
        double before = energy(engine);
        double most = engine.kineticEnergy();
        for (int k = 0; k < 20; k++) {
            engine.step();
            assertNoGain(engine, before, most);
            before = energy(engine);
        }
    }

    /** A block that lies with one end on a pebble and falls on its other end. */
    @ParameterizedTest
    @CsvSource({"1, 0.5", "0.1, 1", "0.1, 0.5", "0.02, 1"})
    void blockOnPebbleDoesNotJump(double step, double restitution) {
        PhysicsEngine engine = box(step, restitution, 0.7);
        add(engine, new Body(new Circle(0.02)).at(-2, -4.98), 3, restitution, 0.7);
        add(engine, new Body(new Rectangle(5, 1)).at(0, -4.4), 1000, restitution, 0.7);
        double before = energy(engine);
        double most = 1000 * G * 0.1;
        for (int k = 0; k < 40; k++) {
            engine.step();
            assertNoGain(engine, before, most);
            before = energy(engine);
        }
    }

    private static void assertNoGain(PhysicsEngine engine, double before, double scale) {
        double gain = energy(engine) - before;
        assertTrue(gain <= 0.01 * scale, () -> "gain " + gain + " of " + scale + " in step " + engine.getSteps());
    }

    private static double energy(PhysicsEngine engine) {
        double sum = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            sum += body.isFixed() ? 0 : body.getMass() * G * body.getY();
        }
        return sum;
    }

    private static void add(PhysicsEngine engine, Body body, double mass, double restitution, double friction) {
        body.setMass(mass);
        body.setRestitution(restitution);
        body.setFriction(friction);
        engine.add(body);
    }

    private static PhysicsEngine box(double step, double restitution, double friction) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.add(new Gravity(0, -G));
        for (int side = -1; side <= 1; side += 2) {
            engine.add(Body.fixed(new Rectangle(14, 1)).at(0, 5.5 * side));
            engine.add(Body.fixed(new Rectangle(1, 10)).at(5.5 * side, 0));
        }
        for (Body wall : engine.bodies()) {
            wall.setRestitution(restitution);
            wall.setFriction(friction);
        }
        return engine;
    }
}
