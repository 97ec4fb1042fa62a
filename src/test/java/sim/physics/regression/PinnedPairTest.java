// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Two bars that are pinned together, a disc on the pin and a box bounce between walls and keep their energy. */
class PinnedPairTest {
    @Test
    void thePairKeepsItsEnergyForAHundredThousandSteps() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(Body.fixed(new Rectangle(180, 6)).at(100, 10));
        engine.add(Body.fixed(new Rectangle(180, 6)).at(100, 190));
        engine.add(Body.fixed(new Rectangle(6, 180)).at(10, 100));
        engine.add(Body.fixed(new Rectangle(6, 180)).at(190, 100));
        engine.add(new Body(new Rectangle(10, 20)).at(100, 100).moving(1, 1)).setMass(200);
        Body left = engine.add(new Body(new Rectangle(20, 10)).at(50, 50).moving(0.5, 0.5));
        Body right = engine.add(new Body(new Rectangle(20, 10)).at(90, 50).moving(0.5, 0.5));
        Body disc = engine.add(new Body(new Circle(3)).at(70, 50).moving(0.5, 0.5));
        left.setMass(200);
        right.setMass(200);
        PinJoint pin = new PinJoint(left, right, 70, 50);
        pin.setCollideConnected(true);
        engine.add(pin);
        engine.add(new PinJoint(left, disc, 70, 50));
        engine.setCollisions(right, disc, false);
        double energy = engine.kineticEnergy();
        for (int k = 0; k < 100_000; k++) {
            engine.step();
            if (k % 1000 == 0) {
                assertThat(engine.kineticEnergy() / energy).isCloseTo(1, within(1e-10));
            }
        }
        assertThat(engine.getImpacts()).isGreaterThan(1000);
        assertThat(gap(left, right)).isLessThan(100 * 0x1p-52 * 200);
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-9);
    }

    private static double gap(Body left, Body right) {
        double x = left.getX() + 20 * StrictMath.cos(left.getAngle());
        double y = left.getY() + 20 * StrictMath.sin(left.getAngle());
        x -= right.getX() - 20 * StrictMath.cos(right.getAngle());
        y -= right.getY() - 20 * StrictMath.sin(right.getAngle());
        return StrictMath.hypot(x, y);
    }
}
