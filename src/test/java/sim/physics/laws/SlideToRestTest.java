// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.DoubleFunction;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.Witness;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Integrator;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;

/** Bodies that slide to a stop, under methods with a tolerance. */
class SlideToRestTest {
    private static final double FRICTION = 0.3;
    private static final double G = 9.81;

    private static final List<DoubleFunction<Integrator>> METHODS =
            List.of(DormandPrince853::new, GraggBulirschStoer::new, RadauIIA::new);

    /** A puck of 0.1 m that is let go at 1 m/s. */
    private static final class Puck {
        private final PhysicsEngine engine = new PhysicsEngine();
        private final Body body = new Body(new Circle(0.1)).at(0, 0);
        private final Witness counter = new Witness(body, true);

        Puck(Integrator method, double dt, double spin) {
            engine.setTimeStep(dt);
            engine.setIntegrator(method);
            body.moving(1, 0, spin);
            body.setSurfaceFriction(FRICTION);
            engine.add(body);
            engine.add(new SurfaceFriction(G));
            engine.add(counter);
            for (int k = 0; k < Math.round(0.5 / dt); k++) {
                engine.step();
            }
        }
    }

    /** It stops after v²/(2 μ g), evenly: there is nothing to divide, however small the tolerance. */
    @Test
    void whatOnlySlidesStopsInOnePart() {
        for (DoubleFunction<Integrator> method : METHODS) {
            Puck puck = new Puck(method.apply(1e-11), 0.5, 0);
            assertThat(puck.body.kineticEnergy()).isZero();
            assertThat(puck.body.getX()).isCloseTo(1 / (2 * FRICTION * G), within(1e-15));
            assertThat(puck.counter.calls()).isLessThan(10);
        }
    }

    /** Farkas, Bartels, Unger and Wolf 2003: a puck that spins, too, goes farther. Tolerances hold, long steps or short. */
    @Test
    void whatSpinsAndSlidesStopsWithinTheTolerance() {
        for (DoubleFunction<Integrator> method : METHODS) {
            for (double tolerance = 1e-3; tolerance > 1e-9; tolerance /= 10) {
                for (double dt : new double[] {0.5, 0.01}) {
                    Puck puck = new Puck(method.apply(tolerance), dt, 10);
                    assertThat(puck.body.kineticEnergy()).isZero();
                    assertThat(puck.body.getX()).isCloseTo(0.2165807761242, within(10 * tolerance));
                }
            }
        }
    }

    /** When velocities, turning and not, fade together, the rest of the way is even to any tolerance that is not too small. */
    @Test
    void aCoarseToleranceTakesOneStep() {
        assertThat(new Puck(new DormandPrince853(1e-3), 0.5, 10).counter.calls()).isLessThan(20);
        assertThat(new Puck(new RadauIIA(1e-3), 0.5, 10).counter.calls()).isLessThan(75);
    }
}
