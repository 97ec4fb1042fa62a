// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.internal.Check;
import sim.physics.motion.Body;
import sim.physics.motion.Link;

/**
 * A massless rod: two points keep their distance.
 *
 * <pre>
 *   C = |d| − L,   d = pA − pB,   n = d / |d|      J = [ n  rA⊥·n   −n  −rB⊥·n ]
 *   J̇ ẋ = n·(−θ̇A² rA + θ̇B² rB) + (ḋ·ḋ − (n·ḋ)²) / |d|
 * </pre>
 *
 * <p>Beware: the constructor without a length takes points of the <i>world</i>, and the one with a length takes points of the
 * <i>bodies</i>. So does the constructor of {@link PinJoint} that has as many numbers as the first. The names of
 * {@link #worldPoints} and {@link #bodyPoints} say which points they take.
 */
public final class RodJoint extends Joint implements Link {
    private static final long serialVersionUID = 1L;

    private final Anchor first;
    private final Anchor second;
    private double length;

    /**
     * Links two points by a rod whose length is their present distance. The points are given where they are in the <i>world</i>,
     * not in the bodies' own coordinates. {@link #worldPoints} does the same, and its name says so.
     *
     * @param a a body
     * @param worldAX x of the point of the first body, in world coordinates
     * @param worldAY y of the point of the first body, in world coordinates
     * @param b another body, or null for the world
     * @param worldBX x of the point of the second body, in world coordinates
     * @param worldBY y of the point of the second body, in world coordinates
     * @throws IllegalArgumentException if both points are the same: use a {@link PinJoint} for that
     */
    public RodJoint(Body a, double worldAX, double worldAY, Body b, double worldBX, double worldBY) {
        this(Anchor.at(a, "a", worldAX, worldAY), Anchor.at(b, "b", worldBX, worldBY), distance(worldAX - worldBX, worldAY - worldBY));
    }

    /**
     * Links two points of bodies by a rod, wherever the bodies are.
     *
     * @param a a body
     * @param ax x of the point of the first body, in its coordinates
     * @param ay y of the point of the first body, in its coordinates
     * @param b another body, or null for the world
     * @param bx x of the point of the second body, in its coordinates
     * @param by y of the point of the second body, in its coordinates
     * @param length length of the rod
     */
    public RodJoint(Body a, double ax, double ay, Body b, double bx, double by, double length) {
        this(Anchor.local(a, "a", ax, ay), Anchor.local(b, "b", bx, by), Check.positive("length", length));
    }

    private RodJoint(Anchor first, Anchor second, double length) {
        super(first.body, second.body);
        this.first = first;
        this.second = second;
        this.length = length;
    }

    private static double distance(double dx, double dy) {
        return Check.positive("distance of the two points in the world", Math.sqrt(dx * dx + dy * dy));
    }

    /**
     * Links two points by a rod whose length is their present distance, where the bodies are now.
     *
     * @param a a body
     * @param ax x of the point of the first body, in world coordinates
     * @param ay y of the point of the first body, in world coordinates
     * @param b another body, or null for the world
     * @param bx x of the point of the second body, in world coordinates
     * @param by y of the point of the second body, in world coordinates
     * @return a rod
     * @throws IllegalArgumentException if both points are the same: use a {@link PinJoint} for that
     */
    public static RodJoint worldPoints(Body a, double ax, double ay, Body b, double bx, double by) {
        return new RodJoint(a, ax, ay, b, bx, by);
    }

    /**
     * Links two points of bodies by a rod whose length is their present distance.
     *
     * @param a a body
     * @param ax x of the point of the first body, in its coordinates
     * @param ay y of the point of the first body, in its coordinates
     * @param b another body, or null for the world
     * @param bx x of the point of the second body, in its coordinates
     * @param by y of the point of the second body, in its coordinates
     * @return a rod
     * @throws IllegalArgumentException if both points are in one place: use a {@link PinJoint} for that
     */
    public static RodJoint bodyPoints(Body a, double ax, double ay, Body b, double bx, double by) {
        Anchor first = Anchor.local(a, "a", ax, ay);
        Anchor second = Anchor.local(b, "b", bx, by);
        first.evaluate();
        second.evaluate();
        return new RodJoint(first, second, distance(first.x - second.x, first.y - second.y));
    }

    /**
     * Links two points of bodies by a rod, wherever the bodies are.
     *
     * @param a a body
     * @param ax x of the point of the first body, in its coordinates
     * @param ay y of the point of the first body, in its coordinates
     * @param b another body, or null for the world
     * @param bx x of the point of the second body, in its coordinates
     * @param by y of the point of the second body, in its coordinates
     * @param length length of the rod
     * @return a rod
     */
    public static RodJoint bodyPoints(Body a, double ax, double ay, Body b, double bx, double by, double length) {
        return new RodJoint(a, ax, ay, b, bx, by, length);
    }

    /**
     * Returns the length of the rod.
     *
     * @return length L
     */
    public double getLength() {
        return length;
    }

    /**
     * Sets the length of the rod. You may call this at any time, between steps or from a listener within one; it holds from that
     * instant on. If it is not the distance of the two points, the joint is closed as when you move a body: bodies go to the nearest
     * places, at once, and get no velocity by that. So what you shorten a little in each step moves bodies, but pushes nothing with
     * it. For that, take a {@link SliderJoint} with a {@link Motor}. Of a {@link Limit#rope}, this is the length at which it is taut.
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

    @Override
    public double getAnchorAX() {
        return first.localX;
    }

    @Override
    public double getAnchorAY() {
        return first.localY;
    }

    @Override
    public double getAnchorBX() {
        return second.localX;
    }

    @Override
    public double getAnchorBY() {
        return second.localY;
    }

    @Override
    public int getRows() {
        return 1;
    }

    @Override
    public double getSize() {
        return Math.max(length, super.getSize());
    }

    /** Whether the rod turns neither body, as its points are their middles. */
    boolean isCentral() {
        return first.isMiddle() && second.isMiddle();
    }

    @Override
    double bend() {
        return length > 0 ? length : super.bend();
    }

    @Override
    public void evaluate(Equations e) {
        first.evaluate();
        second.evaluate();
        double dx = first.x - second.x;
        double dy = first.y - second.y;
        double distance = Math.sqrt(dx * dx + dy * dy);
        double nx = distance > 0 ? dx / distance : 1;
        double ny = distance > 0 ? dy / distance : 0;
        double ux = first.vx - second.vx;
        double uy = first.vy - second.vy;
        double across = ux * ny - uy * nx;
        double swing = distance > 0 ? across * across / distance : 0;
        e.set(0, distance - length, first.centripetal(nx, ny) - second.centripetal(nx, ny) + swing);
        e.setA(0, nx, ny, first.lever(nx, ny));
        e.setB(0, -nx, -ny, -second.lever(nx, ny));
    }

    @Override
    boolean describe(JointRows rows, int node) {
        rows.addRod(node, this, first, second);
        return true;
    }
}
