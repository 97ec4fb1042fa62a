// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos;

import static org.assertj.core.api.Assertions.assertThat;

import demos.machines.Machines;
import org.junit.jupiter.api.Test;
import sim.physics.Checkpoint;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;

/** A car, boxes and ragdolls in one heap: nothing sinks in, joints stay closed, and a checkpoint in the middle changes nothing. */
class MachinesTest {
    @Test
    void nothingSinksInAndJointsStayClosed() {
        Machines model = new Machines(1);
        model.start();
        for (int k = 0; k < 400; k++) {
            model.schedule.step(model);
        }
        assertThat(model.physics.getDeepestPenetration()).isLessThan(2e-6); // sizes are 2 to 40
        for (Body body : model.physics.bodies()) {
            assertThat(body.getX()).isBetween(0.0, Scene.WORLD);
            assertThat(body.getY()).isBetween(0.0, Scene.WORLD);
        }
        for (Constraint joint : model.physics.allConstraints()) {
            if (joint instanceof PinJoint pin) {
                assertThat(gap(pin)).isLessThan(1e-11);
            }
        }
    }

    private static double gap(PinJoint pin) {
        double[] a = place(pin.getBodyA(), pin.getAnchorAX(), pin.getAnchorAY());
        double[] b = place(pin.getBodyB(), pin.getAnchorBX(), pin.getAnchorBY());
        return StrictMath.hypot(a[0] - b[0], a[1] - b[1]);
    }

    private static double[] place(Body body, double x, double y) {
        double cos = StrictMath.cos(body.getAngle());
        double sin = StrictMath.sin(body.getAngle());
        return new double[] {body.getX() + cos * x - sin * y, body.getY() + sin * x + cos * y};
    }

    @Test
    void aCheckpointInTheMiddleOfAHeapContinuesBitForBit() {
        Machines model = new Machines(2);
        model.start();
        for (int k = 0; k < 200; k++) {
            model.schedule.step(model);
        }
        Machines restored = Checkpoint.copy(model);
        for (int k = 0; k < 60; k++) {
            model.schedule.step(model);
            restored.schedule.step(restored);
        }
        Checkpoint.assertSameBodies(model.physics, restored.physics);
    }
}
