// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Objects;
import sim.physics.internal.Check;
import sim.physics.motion.Body;

/**
 * A rope without mass that runs from a body over two pulleys to another body: what one side gives, the other one takes. With a ratio,
 * a tackle: the second side has that many strands, so its body goes a part of the way, and is pulled as many times as hard.
 *
 * <pre>
 *   C = |dA| + k |dB| − L,   d = p − g,   n = d / |d|      J = [ nA  rA⊥·nA   k nB  k rB⊥·nB ]
 *   J̇ ẋ = sA + k sB,   s = −θ̇² r·n + (v² − (n·v)²) / |d|
 * </pre>
 *
 * <p>where p is a body's point, v its velocity, and g its pulley, which is small and stands still. The rope is taut, and can push, as a rod can. For
 * one that may slacken, add {@code new Limit(pulley, Double.NEGATIVE_INFINITY, 0, 0)} instead of the joint itself.
 *
 * <p>{@link Reaction#force()} of this joint is the tension of the first side, which is that of the rope; on the second body the rope pulls with k
 * times that. Unlike those of other joints, the bodies of a pulley collide unless you forbid it.
 */
public final class PulleyJoint extends Joint {
    private static final long serialVersionUID = 1L;

    private final Side first;
    private final Side second;
    private final double ratio;
    private double length;

    private PulleyJoint(Side first, Side second, double ratio, double length) {
        super(first.end.body, Objects.requireNonNull(second.end.body, "b: both ends of the rope of a pulley are bodies"));
        this.first = first;
        this.second = second;
        this.ratio = ratio;
        this.length = length;
        collideConnected();
    }

    /**
     * Leads a rope over two pulleys. It is as long as the way is now. All points are where they are in the world.
     *
     * @param a a body
     * @param ax x of the end of the rope on the first body, in world coordinates
     * @param ay y of the end of the rope on the first body, in world coordinates
     * @param pulleyAX x of the pulley of the first body
     * @param pulleyAY y of the pulley of the first body
     * @param b another body
     * @param bx x of the end of the rope on the second body, in world coordinates
     * @param by y of the end of the rope on the second body, in world coordinates
     * @param pulleyBX x of the pulley of the second body; may be that of the first one
     * @param pulleyBY y of the pulley of the second body
     * @param ratio number k of strands of the second side, greater than 0: 1 for a plain rope
     * @return a taut rope
     * @throws IllegalArgumentException if a number is not finite, the ratio is not positive, or both ends are at their pulleys
     */
    public static PulleyJoint worldPoints(
            Body a, double ax, double ay, double pulleyAX, double pulleyAY,
            Body b, double bx, double by, double pulleyBX, double pulleyBY, double ratio) {
        return taut(new Side(Anchor.at(a, "a", ax, ay), pulleyAX, pulleyAY), new Side(Anchor.at(b, "b", bx, by), pulleyBX, pulleyBY), ratio);
    }

    /**
     * Leads a rope over two pulleys, wherever the bodies are.
     *
     * @param a a body
     * @param ax x of the end of the rope on the first body, in its coordinates
     * @param ay y of the end of the rope on the first body, in its coordinates
     * @param pulleyAX x of the pulley of the first body, in world coordinates
     * @param pulleyAY y of the pulley of the first body, in world coordinates
     * @param b another body
     * @param bx x of the end of the rope on the second body, in its coordinates
     * @param by y of the end of the rope on the second body, in its coordinates
     * @param pulleyBX x of the pulley of the second body, in world coordinates; may be that of the first one
     * @param pulleyBY y of the pulley of the second body, in world coordinates
     * @param ratio number k of strands of the second side, greater than 0: 1 for a plain rope
     * @param length length L of the rope: from the first body to its pulley, and k times from the second one to its pulley
     * @return a taut rope
     * @throws IllegalArgumentException if a number is not finite, or the ratio or the length is not positive
     */
    public static PulleyJoint bodyPoints(
            Body a, double ax, double ay, double pulleyAX, double pulleyAY,
            Body b, double bx, double by, double pulleyBX, double pulleyBY, double ratio, double length) {
        Side first = new Side(Anchor.local(a, "a", ax, ay), pulleyAX, pulleyAY);
        Side second = new Side(Anchor.local(b, "b", bx, by), pulleyBX, pulleyBY);
        return new PulleyJoint(first, second, Check.positive("ratio", ratio), Check.positive("length", length));
    }

    private static PulleyJoint taut(Side first, Side second, double ratio) {
        Check.positive("ratio", ratio);
        first.evaluate();
        second.evaluate();
        return new PulleyJoint(first, second, ratio, Check.positive("length of the rope", first.length + ratio * second.length));
    }

    /**
     * Returns the number of strands of the second side.
     *
     * @return ratio k
     */
    public double getRatio() {
        return ratio;
    }

    /**
     * Returns the length of the rope.
     *
     * @return length L
     */
    public double getLength() {
        return length;
    }

    /**
     * Sets the length of the rope. As with {@link RodJoint#setLength}, bodies go to the nearest places, at once, and get no velocity by that. To wind
     * the rope in or pay it out, add {@code new Motor(pulley, …)} instead of the joint itself: the motor's speed is the rate of the length.
     *
     * @param length length L, greater than 0
     * @throws IllegalArgumentException if it is not positive and finite
     */
    public void setLength(double length) {
        boolean isNew = Check.positive("length", length) != this.length;
        if (isNew) {
            write(getBodyA(), getBodyB());
        }
        this.length = length;
    }

    /**
     * Returns the x coordinate of the rope's end on the first body, in that body's coordinates.
     *
     * @return x, length
     */
    public double getAnchorAX() {
        return first.end.localX;
    }

    /**
     * Returns the y coordinate of the rope's end on the first body, in that body's coordinates.
     *
     * @return y, length
     */
    public double getAnchorAY() {
        return first.end.localY;
    }

    /**
     * Returns the x coordinate of the rope's end on the second body, in that body's coordinates.
     *
     * @return x, length
     */
    public double getAnchorBX() {
        return second.end.localX;
    }

    /**
     * Returns the y coordinate of the rope's end on the second body, in that body's coordinates.
     *
     * @return y, length
     */
    public double getAnchorBY() {
        return second.end.localY;
    }

    /**
     * Returns the x coordinate of the first body's pulley.
     *
     * @return x in the world
     */
    public double getPulleyAX() {
        return first.x;
    }

    /**
     * Returns the y coordinate of the first body's pulley.
     *
     * @return y in the world
     */
    public double getPulleyAY() {
        return first.y;
    }

    /**
     * Returns the x coordinate of the second body's pulley.
     *
     * @return x in the world
     */
    public double getPulleyBX() {
        return second.x;
    }

    /**
     * Returns the y coordinate of the second body's pulley.
     *
     * @return y in the world
     */
    public double getPulleyBY() {
        return second.y;
    }

    @Override
    public int getRows() {
        return 1;
    }

    @Override
    public double getSize() {
        return Math.max(length, super.getSize());
    }

    @Override
    boolean isInternal() {
        return false;
    }

    @Override
    double bend() {
        return length;
    }

    @Override
    public void evaluate(Equations e) {
        first.evaluate();
        second.evaluate();
        e.set(0, first.length + ratio * second.length - length, first.bends() + ratio * second.bends());
        e.setA(0, first.nx, first.ny, first.lever());
        e.setB(0, ratio * second.nx, ratio * second.ny, ratio * second.lever());
    }

    /** The part of the rope between a body and its pulley. */
    private static final class Side implements Serializable {
        private static final long serialVersionUID = 1L;

        final Anchor end;
        final double x;
        final double y;

        /** At the instant of an evaluation. */
        double length;

        double nx;
        double ny;

        Side(Anchor end, double x, double y) {
            this.end = end;
            this.x = Check.finite("x of a pulley", x);
            this.y = Check.finite("y of a pulley", y);
        }

        void evaluate() {
            end.evaluate();
            double dx = end.x - x;
            double dy = end.y - y;
            length = Math.sqrt(dx * dx + dy * dy);
            nx = length > 0 ? dx / length : 1;
            ny = length > 0 ? dy / length : 0;
        }

        double lever() {
            return end.lever(nx, ny);
        }

        /** What turning and swinging do to the length. */
        double bends() {
            double across = end.vx * ny - end.vy * nx;
            return end.centripetal(nx, ny) + (length > 0 ? across * across / length : 0);
        }
    }
}
