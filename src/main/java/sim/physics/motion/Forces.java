// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;

/** Takes the forces of a {@link ForceGenerator} and adds them to the force vector F. */
public final class Forces implements Serializable {
    private static final long serialVersionUID = 1L;

    /** A place or speed that no model means: with its square's square a force may overflow. */
    private static final double HUGE = 1e75;

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
        finite("fx", fx, body);
        finite("fy", fy, body);
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
        finite("torque", torque, body);
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
        finite("px", px, body);
        finite("py", py, body);
        add(body, fx, fy);
        addTorque(body, (px - body.getX()) * fy - (py - body.getY()) * fx);
    }

    /** Takes what was applied to bodies for a step off them; those that have left are passed over. */
    void clearApplied(IntList bodies) {
        for (int k = 0; k < bodies.size; k++) {
            Body view = state.body(bodies.values[k]);
            if (view != null) {
                view.clearApplied();
            }
        }
    }

    /** Refuses what is not finite; where a body has been thrown beyond all measure, that is said to be the cause. */
    private void finite(String name, double value, Body body) {
        if (Math.abs(value) < Double.POSITIVE_INFINITY) {
            return;
        }
        double largest = 0;
        for (int b = State.BLOCK * body.index(), k = b; k < b + State.BLOCK; k++) {
            largest = Math.max(largest, Math.max(Math.abs(state.x()[k]), Math.abs(state.v()[k]))); // NaN stays
        }
        String cause = largest < HUGE
                ? ""
                : ". Its motion has grown without bound: the time step may be too long for the forces on it";
        throw new IllegalArgumentException(name + " is " + value + ": it must be finite; it acts on " + body + " with velocity ("
                + body.getVelocityX() + ", " + body.getVelocityY() + ")" + cause);
    }
}
