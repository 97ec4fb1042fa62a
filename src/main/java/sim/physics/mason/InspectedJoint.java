// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import sim.physics.PhysicsEngine;
import sim.physics.constraint.Joint;

/** A {@link Joint} of an engine as MASON's inspectors see it, with what may be set. */
public class InspectedJoint extends InspectedConstraint {
    private final Joint joint;

    /**
     * Makes the view of a joint.
     *
     * @param engine that it is, or was, in
     * @param joint live
     */
    public InspectedJoint(PhysicsEngine engine, Joint joint) {
        super(engine, joint);
        this.joint = joint;
    }

    /** {@return whether its two bodies collide with one another} */
    public boolean isCollideConnected() {
        return joint.isCollideConnected();
    }

    /** @param collide whether its two bodies collide with one another */
    public void setCollideConnected(boolean collide) {
        joint.setCollideConnected(collide);
    }

    /** {@return the force at which it breaks} */
    public double getBreakingForce() {
        return joint.getBreakingForce();
    }

    /** @param force at which it breaks, greater than 0 */
    public void setBreakingForce(double force) {
        joint.setBreakingLoad(force, joint.getBreakingTorque());
    }

    /** {@return the torque at which it breaks} */
    public double getBreakingTorque() {
        return joint.getBreakingTorque();
    }

    /** @param torque at which it breaks, greater than 0 */
    public void setBreakingTorque(double torque) {
        joint.setBreakingLoad(joint.getBreakingForce(), torque);
    }
}
