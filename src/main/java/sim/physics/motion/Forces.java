// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.Check;

/** Takes the forces of a {@link ForceGenerator} and adds them to the force vector F. */
public final class Forces implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;

    /** For a generator, while it is asked for one force. */
    final double[] workspace = new double[State.BLOCK];

    Forces(State state) {
        this.state = state;
    }

    /**
     * Adds a force at the centre of mass.
     *
     * @param body the body that it acts on
     * @param fx force
     * @param fy force
     * @throws IllegalArgumentException for NaN or infinity
     */
    public void add(Body body, double fx, double fy) {
        Check.finite("fx", fx);
        Check.finite("fy", fy);
        double[] f = state.f();
        int b = State.BLOCK * body.index();
        f[b + State.X] += fx;
        f[b + State.Y] += fy;
    }

    /**
     * Adds a torque.
     *
     * @param body the body that it acts on
     * @param torque force·length
     * @throws IllegalArgumentException for NaN or infinity
     */
    public void addTorque(Body body, double torque) {
        Check.finite("torque", torque);
        state.f()[State.BLOCK * body.index() + State.THETA] += torque;
    }

    /**
     * Adds a force at a point: the force at the centre of mass and the torque r⊥ · f.
     *
     * @param body the body that it acts on
     * @param fx force
     * @param fy force
     * @param px point, in world coordinates
     * @param py point, in world coordinates
     * @throws IllegalArgumentException for NaN or infinity
     */
    public void addAt(Body body, double fx, double fy, double px, double py) {
        Check.finite("px", px);
        Check.finite("py", py);
        add(body, fx, fy);
        addTorque(body, (px - body.getX()) * fy - (py - body.getY()) * fx);
    }
}
