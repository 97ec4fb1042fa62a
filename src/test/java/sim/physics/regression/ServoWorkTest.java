// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** What it costs that motors reach their speeds one after the other, each at an instant of its own. */
class ServoWorkTest {
    private static final int LINKS = 10;
    private static final int STEPS = 100;

    /**
     * A switch is a stride, and a few looks at when it is: four accelerations of ten links each. Where each look halved what was left to
     * look at, it took forty, and a step 36,000 to 65,000 units.
     */
    @ParameterizedTest
    @ValueSource(doubles = {20, 100, 1000})
    void aSwitchTakesAFewLooks(double torque) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -9.81));
        Motor[] motors = new Motor[LINKS];
        Body last = null;
        for (int k = 0; k < LINKS; k++) {
            Body link = engine.add(new Body(new Rectangle(1, 0.2)).at(0, -k - 0.5, -Math.PI / 2));
            link.setMass(1);
            link.setCollisionGroup(1, 0);
            engine.add(last == null ? new PinJoint(link, 0, 0) : new PinJoint(last, link, 0, -k));
            motors[k] = engine.add(Motor.turning(link, last, 0, torque));
            last = link;
        }
        SplittableRandom random = new SplittableRandom(1);
        for (int k = 0; k < STEPS; k++) {
            for (Motor motor : motors) {
                motor.setSpeed(4 * random.nextDouble() - 2);
            }
            engine.step();
        }
        assertThat(engine.getWork()).isLessThan(4_000L * STEPS);
    }
}
