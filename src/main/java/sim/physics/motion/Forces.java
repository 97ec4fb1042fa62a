// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;

/** Takes the forces of a {@link ForceGenerator}, and adds them to the force vector F. */
public final class Forces implements Serializable {
    private static final long serialVersionUID = 1L;

    /** A place or speed that no model means: with its square's square a force may overflow. */
    private static final double HUGE = 1e75;

    /** A speed, relative to that up to which friction grows, from which on it is all there. */
    private static final double FAST = 1e4;

    private final State state;

    /** For a generator, while it is asked for one force. */
    final double[] workspace = new double[State.BLOCK];

    /** For a spring, the same. */
    final double[] pull = new double[Spring.PULL];

    /** The body about which generators are asked; null while none are. */
    private Body asked;

    /** Time in which friction of the plane takes the speed away up to which it grows, 0 if it does not; and what that way may be. */
    private double soft;

    private double way;

    Forces(State state) {
        this.state = state;
    }

    /** Sets for how long, and for which way at most, bodies come to rest under friction of the plane that becomes less; 0: it stays as it is. */
    void soften(double time, double most) {
        soft = time;
        way = most;
    }

    /**
     * What is left of the friction of the plane on a body of this speed, which would be decelerated by so much: it grows with the speed up to
     * that which it takes away in the time. For methods with a tolerance it does so smoothly, as they see corners.
     */
    double left(double speed, double deceleration) {
        double slow = slow(deceleration);
        if (!(speed < FAST * slow)) {
            return 1;
        }
        double ratio = speed / slow;
        double square = ratio * ratio;
        return way < Double.POSITIVE_INFINITY ? ratio / Math.sqrt(Math.sqrt(1 + square * square)) : Math.min(ratio, 1);
    }

    /** The speed up to which friction of the plane grows that decelerates by so much. */
    double slow(double deceleration) {
        return deceleration * Math.min(soft, Math.sqrt(2 * way / deceleration));
    }

    /** Generators are asked about a body, or about none any more. */
    void ask(Body body) {
        asked = body;
    }

    /** What was added to another one would be lost, or another engine's body of the same index would have it. */
    private void requireAsked(Body body) {
        if (body != asked) {
            throw new IllegalArgumentException("a force was added to " + body + ", but the one that is asked about is " + asked
                    + ": each body's force is asked for in its turn");
        }
    }

    /**
     * Adds a force at the centre of mass.
     *
     * @param body the body that the force acts on, which must be the one that the generator is asked about
     * @param fx x component of the force
     * @param fy y component of the force
     * @throws IllegalArgumentException for NaN or infinity, or for another body
     */
    public void add(Body body, double fx, double fy) {
        requireAsked(body);
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
     * @param body the body that the torque acts on, which must be the one that the generator is asked about
     * @param torque torque, force·length
     * @throws IllegalArgumentException for NaN or infinity, or for another body
     */
    public void addTorque(Body body, double torque) {
        requireAsked(body);
        finite("torque", torque, body);
        state.f()[State.BLOCK * body.index() + State.THETA] += torque;
    }

    /**
     * Adds a force at a point. This is a force at the centre of mass together with the torque r⊥ · f.
     *
     * @param body the body that the force acts on, which must be the one that the generator is asked about
     * @param fx x component of the force
     * @param fy y component of the force
     * @param px x of the point, in world coordinates
     * @param py y of the point, in world coordinates
     * @throws IllegalArgumentException for NaN or infinity, or for another body
     */
    public void addAt(Body body, double fx, double fy, double px, double py) {
        requireAsked(body);
        finite("px", px, body);
        finite("py", py, body);
        add(body, fx, fy);
        addTorque(body, (px - body.getX()) * fy - (py - body.getY()) * fx);
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
