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
 */
public final class RodJoint extends Joint implements Link {
    private static final long serialVersionUID = 1L;

    private final Anchor first;
    private final Anchor second;
    private final double length;

    /**
     * Links two points by a rod as long as their distance is now.
     *
     * @param a a body
     * @param ax point, in world coordinates
     * @param ay point, in world coordinates
     * @param b another body, or null for the world
     * @param bx point, in world coordinates
     * @param by point, in world coordinates
     * @throws IllegalArgumentException if both points are the same: that is a {@link PinJoint}
     */
    public RodJoint(Body a, double ax, double ay, Body b, double bx, double by) {
        super(a, b);
        first = Anchor.at(a, ax, ay);
        second = Anchor.at(b, bx, by);
        length = Check.positive(
                "distance of the two points in the world", Math.sqrt((ax - bx) * (ax - bx) + (ay - by) * (ay - by)));
    }

    /**
     * Links two points of bodies, wherever the two are, by a rod.
     *
     * @param a a body
     * @param ax point in the coordinates of the first body
     * @param ay point in the coordinates of the first body
     * @param b another body, or null for the world
     * @param bx point in the coordinates of the second body
     * @param by point in the coordinates of the second body
     * @param length of the rod
     */
    public RodJoint(Body a, double ax, double ay, Body b, double bx, double by, double length) {
        super(a, b);
        first = Anchor.local(a, ax, ay);
        second = Anchor.local(b, bx, by);
        this.length = Check.positive("length", length);
    }

    /**
     * Length of the rod.
     *
     * @return L
     */
    public double getLength() {
        return length;
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
        rows.addRod(node, first, second, length);
        return true;
    }
}
