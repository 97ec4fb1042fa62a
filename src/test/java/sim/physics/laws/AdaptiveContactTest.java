// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RadauIIA;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Jointed bodies that come to lie under methods that choose their steps: another one after each impact. */
class AdaptiveContactTest {
    static Integrator[] methods() {
        return new Integrator[] {
            new GraggBulirschStoer(1e-9), new DormandPrince853(1e-8), new Automatic(1e-6), new RadauIIA(1e-6)
        };
    }

    @ParameterizedTest
    @MethodSource("methods")
    void pinnedPairComesToLie(Integrator method) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.2);
        engine.setIntegrator(method);
        engine.add(new Gravity(0, -10));
        Body floor = engine.add(Body.fixed(new Rectangle(20, 1)).at(0, -0.5));
        Body disc = new Body(new Circle(0.23)).at(-1.3, 0.376).moving(1.446, -3.336, 0.53);
        Body bar = new Body(new Rectangle(1.08, 0.65)).at(0.03, 0.99, 1.987).moving(1.87, -4.35, 1.86);
        for (Body body : new Body[] {floor, disc, bar}) {
            body.setRestitution(0);
            body.setFriction(0.3);
        }
        engine.add(disc);
        engine.add(bar);
        engine.add(new PinJoint(disc, bar, -0.64, 0.68));
        for (int step = 0; step < 15; step++) {
            long before = engine.getImpacts();
            engine.step();
            long impacts = engine.getImpacts() - before;
            assertTrue(impacts < 5000, impacts + " impacts in step " + step);
            for (Overlap overlap : engine.overlaps()) {
                assertTrue(overlap.depth() < 1e-6, () -> "step: " + overlap);
            }
        }
    }
}
