// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Driven bodies that lie on one another, in steps that are long beside what happens in them, and something strikes them. */
class StruckDrivenHeapTest {
    /** A spring of stiffness 0.3 per mass to a place. */
    private static final class Pull implements ForceGenerator {
        private static final long serialVersionUID = 1L;
        private final double x;
        private final double y;

        Pull(double x, double y) {
            this.x = x;
            this.y = y;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            double stiffness = 0.3 * body.getMass();
            forces.add(body, stiffness * (x - body.getX()), stiffness * (y - body.getY()));
        }
    }

    private final PhysicsEngine engine = new PhysicsEngine();

    private Body put(Body body, double restitution, double friction) {
        body.setRestitution(restitution);
        body.setFriction(friction);
        body.setSurfaceFriction(0.05);
        return engine.add(body);
    }

    private void step() {
        engine.step();
        assertThat(engine.overlaps()).allSatisfy((Overlap o) -> assertThat(o.depth()).isLessThan(1e-6));
    }

    /**
     * A heavy box runs into a row of discs before a wall. What strikes touches, to rounding: at the instant at which the row takes the
     * impact, too. With that of the search, to which bodies went back with their velocities of after it, they were 10⁻⁷ deep.
     */
    @ParameterizedTest
    @CsvSource({"2, false", "5, false", "10, false", "20, false", "2, true", "5, true", "10, true", "20, true"})
    void whatStrikesARowTouchesIt(double speed, boolean rubs) {
        engine.setTimeStep(0.2);
        engine.add(new Pull(-5, 0));
        if (rubs) {
            engine.add(new SurfaceFriction(1));
        }
        put(Body.fixed(new Rectangle(2, 20)).at(-1, 0), 0, 0.3);
        for (int k = 0; k < 3; k++) {
            put(new Body(new Circle(0.5)).at(0.5 + k, 0), 0, 0.3);
        }
        put(new Body(new Rectangle(1, 0.5)).at(6, 0.3).moving(-speed, 0.1, 2), 0, 0.3).setMass(10);
        for (int k = 0; k < 15; k++) {
            step();
        }
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-12);
    }

    /**
     * A light box that spins in a corner, and a heavy disc that comes: it is wedged, and no impulse leads it out. Found again and again for where
     * it would be then, they grew to 10⁶ times what there was, and the step was relieved when its search for impacts had cost too much.
     */
    @ParameterizedTest
    @ValueSource(doubles = {4, 40})
    void nothingIsThrownOutOfACorner(double mass) {
        engine.setTimeStep(0.2);
        engine.add(new Pull(-5, -2));
        engine.add(new SurfaceFriction(1));
        put(Body.fixed(new Rectangle(2, 40)).at(-1, 0), 0.0138, 0);
        put(Body.fixed(new Rectangle(40, 2)).at(20, -1), 0.0138, 0);
        Body light = put(new Body(new Rectangle(0.4, 0.28)).at(0.21, 0.15).moving(0, 0, 20), 0.0138, 0);
        light.setMass(0.04);
        put(new Body(new Circle(1.4)).at(2.6, 1.9).moving(-1.5, -0.3, -0.4), 0.0138, 0).setMass(mass);
        for (int k = 0; k < 25; k++) {
            step();
            assertThat(Math.hypot(light.getVelocityX(), light.getVelocityY())).isLessThan(10);
        }
        assertThat(engine.getRelievedSteps()).isZero();
    }
}
