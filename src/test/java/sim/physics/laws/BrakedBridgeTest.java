// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/**
 * A bridge of planks whose hinges rub: where all of them hold there is one equation more than the planks have freedoms, and no motion
 * left. The bridge comes to rest, bears its weight, and its steps are as cheap as those of others.
 */
class BrakedBridgeTest {
    private static final int PLANKS = 10;
    private static final double SLACK = 0.03;
    private static final double MASS = 2;
    private static final double G = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final Constraint[] pins = new Constraint[PLANKS + 1];

    private void build() {
        engine.setTimeStep(1.0 / 120);
        engine.add(new Gravity(0, -G));
        Body[] planks = new Body[PLANKS];
        for (int k = 0; k < PLANKS; k++) {
            double sag = Math.sqrt(SLACK) * Math.sin(Math.PI * (k + 0.5) / PLANKS);
            planks[k] = engine.add(new Body(new Rectangle(1, 0.2)).at(k + 0.5, -sag));
            planks[k].setMass(MASS);
        }
        pins[0] = PinJoint.bodyPoints(planks[0], -0.5, 0, null, SLACK / 2, 0);
        pins[PLANKS] = PinJoint.bodyPoints(planks[PLANKS - 1], 0.5, 0, null, PLANKS - SLACK / 2, 0);
        for (int k = 1; k < PLANKS; k++) {
            pins[k] = PinJoint.bodyPoints(planks[k - 1], 0.5, 0, planks[k], -0.5, 0);
        }
        engine.assemble(pins);
        for (int k = 1; k < PLANKS; k++) {
            engine.add(Motor.turning(planks[k - 1], planks[k], 0, 2));
        }
    }

    @Test
    void bridgeWhoseHingesRubComesToRestWithoutLongSteps() {
        build();
        for (int k = 0; k < 200; k++) {
            engine.step();
        }
        assertThat(engine.kineticEnergy()).isLessThan(1e-20);
        double borne = engine.getReaction(pins[0]).forceY() + engine.getReaction(pins[PLANKS]).forceY();
        assertThat(borne).isCloseTo(PLANKS * MASS * G, within(1e-6));
        assertThat(engine.getRelievedSteps()).isZero();
        assertThat(engine.getWork()).isLessThan(1_000_000);
    }
}
