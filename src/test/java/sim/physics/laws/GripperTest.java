// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** Two fingers with motors press a box between them, which nothing drives, and bear it by friction alone. */
class GripperTest {
    private final PhysicsEngine engine = new PhysicsEngine();

    private Body put(Body body, double friction) {
        body.setFriction(friction);
        body.setRestitution(0);
        return engine.add(body);
    }

    private Body finger(Body base, double x, double speed, double torque) {
        Body finger = put(new Body(new Rectangle(0.2, 2.7)).at(x, 2.35), 0.9);
        engine.add(new PinJoint(base, finger, x, 3.7));
        engine.add(Motor.turning(finger, base, speed, torque));
        return finger;
    }

    @Test
    void itsBoxStaysWhereItIsHeld() {
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -9.81));
        Body base = put(Body.fixed(new Rectangle(1.6, 0.4)).at(0, 4), 0.6);
        Body support = put(Body.fixed(new Rectangle(0.5, 0.8)).at(0, 0.4), 0.6);
        Body box = put(new Body(new Rectangle(0.8, 0.8)).at(0, 1.2), 0.9);
        Body left = finger(base, -0.51, 0.3, 100);
        engine.add(Limit.angle(left, base, -0.5, 0.004));
        finger(base, 0.51, -0.3, 40);
        for (int k = 0; k < 120; k++) {
            engine.step();
        }
        engine.remove(support);
        double y = box.getY();
        long before = engine.getImpacts();
        for (int k = 0; k < 480; k++) {
            engine.step();
            for (Overlap overlap : engine.overlaps()) {
                assertThat(overlap.depth()).isLessThan(1e-6);
            }
        }
        assertThat(box.getY()).isEqualTo(y, within(1e-3)); // friction bears it: 2 · 0.9 · 14 N are more than its 6.3 N
        assertThat(box.getVelocityY()).isEqualTo(0, within(1e-6));
        assertThat(engine.getImpacts() - before).isLessThan(20); // it was let go of and struck a thousand times
    }
}
