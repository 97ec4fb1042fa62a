// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import sim.physics.internal.Check;
import sim.physics.internal.Trig;

/**
 * A spring with a damper between points of two bodies, or of a body and the world:
 *
 * <pre>
 *   F = −(k (|d| − L) + c n·ḋ) n   on the first body,   d = pA − pB,   n = d / |d|
 * </pre>
 *
 * <p>It exerts no force where both points are the same. Movable bodies that springs connect, directly or through others, are
 * integrated together. Like a joint, a spring leaves an engine with the first of its bodies that is removed from it.
 */
public final class Spring implements ForceGenerator, Link {
    private static final long serialVersionUID = 1L;

    /** Values of a pull: the force on the first body, and the arms of both. */
    static final int PULL = 6;

    private final Body a;
    private final Body b;
    private final double ax;
    private final double ay;
    private final double bx;
    private final double by;
    private double length;
    private double stiffness;
    private double damping;

    /** Cosine and sine of both bodies, and the angles that they are of: both bodies are asked for at each instant. */
    private transient double[] turn;

    private transient double angleA;
    private transient double angleB;

    /**
     * Creates a spring.
     *
     * @param a a body
     * @param ax x of the point of the first body, in its coordinates
     * @param ay y of the point of the first body, in its coordinates
     * @param b another body, or null for the world
     * @param bx x of the point of the second body, in its coordinates
     * @param by y of the point of the second body, in its coordinates
     * @param length length L at which the spring exerts no force, not negative
     * @param stiffness k, force/length, not negative
     * @param damping c, force·time/length, not negative
     * @throws IllegalArgumentException if a number is out of its range, or both bodies are the same
     */
    public Spring(
            Body a, double ax, double ay, Body b, double bx, double by, double length, double stiffness, double damping) {
        this.a = Objects.requireNonNull(a, "a: only the second body of a spring may be null, for the world");
        if (a == b) {
            throw new IllegalArgumentException("b is " + b + ": a spring needs two different bodies");
        }
        this.b = b;
        this.ax = Check.finite("ax", ax);
        this.ay = Check.finite("ay", ay);
        this.bx = Check.finite("bx", bx);
        this.by = Check.finite("by", by);
        this.length = Check.notNegative("length", length);
        this.stiffness = Check.notNegative("stiffness", stiffness);
        this.damping = Check.notNegative("damping", damping);
    }

    @Override
    public Body getBodyA() {
        return a;
    }

    @Override
    public Body getBodyB() {
        return b;
    }

    @Override
    public double getAnchorAX() {
        return ax;
    }

    @Override
    public double getAnchorAY() {
        return ay;
    }

    @Override
    public double getAnchorBX() {
        return bx;
    }

    @Override
    public double getAnchorBY() {
        return by;
    }

    /**
     * Returns the length at which the spring exerts no force.
     *
     * @return length L
     */
    public double getLength() {
        return length;
    }

    /**
     * Sets the length at which the spring exerts no force, as a muscle does that contracts. Like a motor's speed, it may be set at any time, between steps or from a listener; it holds from that
     * instant on.
     *
     * @param length length L, length, not negative
     * @throws IllegalArgumentException if it is negative or not finite
     */
    public void setLength(double length) {
        boolean isNew = Check.notNegative("length", length) != this.length;
        writeIf(isNew);
        this.length = length;
    }

    /**
     * Returns the stiffness: force per length.
     *
     * @return stiffness k
     */
    public double getStiffness() {
        return stiffness;
    }

    /**
     * Sets the stiffness. Like a motor's speed, it may be set at any time, between steps or from a listener; it holds from that
     * instant on.
     *
     * @param stiffness k, force/length, not negative
     * @throws IllegalArgumentException if it is negative or not finite
     */
    public void setStiffness(double stiffness) {
        boolean isNew = Check.notNegative("stiffness", stiffness) != this.stiffness;
        writeIf(isNew);
        this.stiffness = stiffness;
    }

    /**
     * Returns the damping: force per speed.
     *
     * @return damping c
     */
    public double getDamping() {
        return damping;
    }

    /**
     * Sets the damping. Like a motor's speed, it may be set at any time, between steps or from a listener; it holds from that
     * instant on.
     *
     * @param damping c, force·time/length, not negative
     * @throws IllegalArgumentException if it is negative or not finite
     */
    public void setDamping(double damping) {
        boolean isNew = Check.notNegative("damping", damping) != this.damping;
        writeIf(isNew);
        this.damping = damping;
    }

    /** Lets an engine look anew at the bodies of the spring, which may be at rest or asleep. */
    private void writeIf(boolean isNew) {
        for (Body body : isNew ? getBodies() : List.<Body>of()) {
            if (!body.isFixed()) {
                body.state().write(body.index(), false);
            }
        }
    }

    @Override
    public boolean actsOn(Body body) {
        return body == a || body == b;
    }

    @Override
    public boolean isCoupled() {
        return b != null && !b.isFixed() && !a.isFixed();
    }

    @Override
    public List<Body> getBodies() {
        return b == null ? List.of(a) : List.of(a, b);
    }

    /** {@return true, unless the other body is in no engine, or in another one, and is moved from there} */
    @Override
    public boolean isAutonomous() {
        return b == null || b.state() == a.state();
    }

    private void turn() {
        double now = a.getAngle();
        if (turn == null) {
            turn = new double[] {1, 0, 1, 0}; // of angles that are 0
        }
        if (now != angleA) {
            Trig.sinCos(now, turn, 0);
            angleA = now;
        }
        if (b != null && b.getAngle() != angleB) {
            angleB = b.getAngle();
            Trig.sinCos(angleB, turn, 2);
        }
    }

    @Override
    public void addForce(Body body, double time, Forces forces) {
        double[] pull = forces.pull;
        find(pull);
        give(pull, body, forces);
    }

    /** Finds with what force it pulls its first body, and where: of both bodies the same. */
    void find(double[] pull) {
        turn();
        double rax = turn[0] * ax - turn[1] * ay;
        double ray = turn[1] * ax + turn[0] * ay;
        double rbx = bx;
        double rby = by;
        if (b != null) {
            rbx = turn[2] * bx - turn[3] * by;
            rby = turn[3] * bx + turn[2] * by;
        }
        double dx = a.getX() + rax - rbx - (b == null ? 0 : b.getX());
        double dy = a.getY() + ray - rby - (b == null ? 0 : b.getY());
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (distance == 0) {
            Arrays.fill(pull, 0);
            return;
        }
        double nx = dx / distance;
        double ny = dy / distance;
        double spin = a.getAngularVelocity();
        double ux = a.getVelocityX() - spin * ray;
        double uy = a.getVelocityY() + spin * rax;
        if (b != null) {
            spin = b.getAngularVelocity();
            ux -= b.getVelocityX() - spin * rby;
            uy -= b.getVelocityY() + spin * rbx;
        }
        double f = -(stiffness * (distance - length) + damping * (nx * ux + ny * uy));
        pull[0] = f * nx;
        pull[1] = f * ny;
        pull[2] = rax;
        pull[3] = ray;
        pull[4] = rbx;
        pull[5] = rby;
    }

    /** Gives one of the two bodies what it is pulled with. */
    void give(double[] pull, Body body, Forces forces) {
        boolean first = body == a;
        double fx = first ? pull[0] : -pull[0];
        double fy = first ? pull[1] : -pull[1];
        forces.add(body, fx, fy);
        forces.addTorque(body, first ? pull[2] * fy - pull[3] * fx : pull[4] * fy - pull[5] * fx);
    }

    /**
     * Returns the energy that is stored in the spring now.
     *
     * @return k (|d| − L)² / 2
     */
    @Override
    public double energy() {
        double cosA = Trig.cos(a.getAngle());
        double sinA = Trig.sin(a.getAngle());
        double dx = a.getX() + (cosA * ax - sinA * ay);
        double dy = a.getY() + (sinA * ax + cosA * ay);
        double cosB = b == null ? 1 : Trig.cos(b.getAngle());
        double sinB = b == null ? 0 : Trig.sin(b.getAngle());
        dx -= cosB * bx - sinB * by + (b == null ? 0 : b.getX());
        dy -= sinB * bx + cosB * by + (b == null ? 0 : b.getY());
        double stretch = Math.sqrt(dx * dx + dy * dy) - length;
        return 0.5 * stiffness * stretch * stretch;
    }

    @Override
    public String toString() {
        return getClass().getSimpleName() + "(" + a + ", " + (b == null ? "world" : b) + ", length " + length + ", stiffness "
                + stiffness + ", damping " + damping + ")";
    }
}
