// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.Objects;
import sim.physics.internal.Check;
import sim.physics.internal.Trig;
import sim.physics.motion.Body;

/**
 * The base class of the joints in this package. It holds their two bodies, and settings that all joints have: whether the bodies
 * collide, and the load at which the joint breaks.
 */
public abstract class Joint implements Constraint {
    private static final long serialVersionUID = 1L;

    private final Body a;
    private final Body b;
    private boolean collideConnected;
    private double breakingForce = Double.POSITIVE_INFINITY;
    private double breakingTorque = Double.POSITIVE_INFINITY;

    /**
     * Makes a joint.
     *
     * @param a a body
     * @param b another body, or null for the world
     * @throws IllegalArgumentException if both are the same
     */
    Joint(Body a, Body b) {
        this.a = Objects.requireNonNull(a, "a: only the second body of a joint may be null, for the world");
        this.b = b;
        if (a == b) {
            throw new IllegalArgumentException("b is " + b + ": a joint needs two different bodies");
        }
    }

    @Override
    public final Body getBodyA() {
        return a;
    }

    @Override
    public final Body getBodyB() {
        return b;
    }

    /**
     * Returns whether the two bodies collide with one another.
     *
     * @return false unless set
     */
    public final boolean isCollideConnected() {
        return collideConnected;
    }

    /**
     * Sets whether the two bodies collide with one another. You may call this at any time, between steps or from a listener
     * within one.
     *
     * <p>If the bodies overlap when they begin to collide, they are treated as other bodies that are put into one another:
     * {@code PhysicsEngine.separate()} parts them, else they pass through one another until their boxes are apart. Where there
     * are several joints between two bodies, each of them has to let them collide. Where there are joints, motors and stops have
     * no say, see {@link Motor#setCollideConnected}.
     *
     * @param collide false to let them overlap
     */
    public final void setCollideConnected(boolean collide) {
        boolean isNew = collide != collideConnected;
        if (isNew) {
            stir(a, b);
        }
        collideConnected = collide;
    }

    /** The same for a joint that is being made, which is in no engine yet. */
    final void collideConnected() {
        collideConnected = true;
    }

    /** Lets an engine look anew at the bodies of a constraint, if they are in one, before it is set; refuses it where it must not be. */
    static void write(Body a, Body b) {
        write(a, b, true);
    }

    /** The same for what does not bring bodies elsewhere, and does not change their velocities. */
    static void stir(Body a, Body b) {
        write(a, b, false);
    }

    private static void write(Body a, Body b, boolean moves) {
        for (Body body : b == null ? new Body[] {a} : new Body[] {a, b}) {
            if (!body.isImmobile()) {
                body.state().write(body.index(), moves);
            }
        }
    }

    /**
     * Returns the force at which the joint breaks.
     *
     * @return force; infinite unless set
     */
    public final double getBreakingForce() {
        return breakingForce;
    }

    /**
     * Returns the torque at which the joint breaks.
     *
     * @return torque; infinite unless set
     */
    public final double getBreakingTorque() {
        return breakingTorque;
    }

    /**
     * Sets the load at which the joint breaks. It breaks if its force or its torque (see {@link Reaction}) is greater than the
     * limit at the start of a step; where bodies of its island lie on something, or are new, when the step is over, which has told
     * what their contacts give. A pin has no torque of its own. You may call this at any time; it holds from the next step on.
     *
     * @param force greatest force, greater than 0; may be infinite
     * @param torque greatest torque, greater than 0; may be infinite
     * @throws IllegalArgumentException if the force or the torque is not greater than 0
     */
    public final void setBreakingLoad(double force, double torque) {
        if (!(force > 0)) {
            throw new IllegalArgumentException("breaking force is " + force + ": it must be greater than 0");
        }
        if (!(torque > 0)) {
            throw new IllegalArgumentException("breaking torque is " + torque + ": it must be greater than 0");
        }
        boolean isNew = force != breakingForce || torque != breakingTorque;
        if (isNew) {
            stir(a, b);
        }
        breakingForce = force;
        breakingTorque = torque;
    }

    final boolean isBreakable() {
        return breakingForce < Double.POSITIVE_INFINITY || breakingTorque < Double.POSITIVE_INFINITY;
    }

    /** Whether a load is greater than the joint bears. */
    final boolean breaksUnder(Reaction load) {
        double torque = this instanceof PinJoint ? 0 : Math.abs(load.torque());
        return load.force() > breakingForce || torque > breakingTorque;
    }

    /** Adds the rows to those that are evaluated by kinds, from a node on; false if the joint must be asked itself. */
    boolean describe(JointRows rows, int node) {
        return false;
    }

    /** Whether what the joint does to one body it undoes at the other, so that bodies which nothing else holds keep their momenta. */
    boolean isInternal() {
        return true;
    }

    /** The same of any constraint. Of an author's it is not known. */
    static boolean isInternal(Constraint constraint) {
        Constraint one = constraint instanceof Switched s ? s.coordinate() : constraint;
        return one instanceof Joint joint && joint.isInternal();
    }

    /** The length in which the joint bends the way of a body, beside what bodies turn; infinite if there is none. */
    double bend() {
        return Double.POSITIVE_INFINITY;
    }

    /** Whether a constraint is all our own code, so that different ones may be evaluated by different threads. */
    static boolean isOwn(Constraint constraint) {
        Constraint one = constraint instanceof Switched s ? s.coordinate() : constraint;
        return one instanceof WireJoint w ? w.hasOwnWire() : one instanceof Joint;
    }

    /** A world point in the coordinates of a body; of the world for null. */
    static double localX(Body body, double x, double y) {
        if (body == null) {
            return x;
        }
        return Trig.cos(body.getAngle()) * (x - body.getX()) + Trig.sin(body.getAngle()) * (y - body.getY());
    }

    static double localY(Body body, double x, double y) {
        if (body == null) {
            return y;
        }
        return Trig.cos(body.getAngle()) * (y - body.getY()) - Trig.sin(body.getAngle()) * (x - body.getX());
    }

    static double angle(Body body) {
        return body == null ? 0 : body.getAngle();
    }

    static double spin(Body body) {
        return body == null ? 0 : body.getAngularVelocity();
    }

    /** Checks a point; what its coordinates are called begins with a letter, or none. */
    static void point(String of, double x, double y) {
        Check.finite(of + "x", x);
        Check.finite(of + "y", y);
    }

    @Override
    public String toString() {
        return getClass().getSimpleName() + "(" + a + ", " + (b == null ? "world" : b) + ")";
    }
}
