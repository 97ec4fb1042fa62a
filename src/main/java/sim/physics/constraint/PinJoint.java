// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.internal.Trig;
import sim.physics.motion.Body;
import sim.physics.motion.Link;

/**
 * A hinge. A point of one body stays on a point of another one, or of the world, (42)–(46).
 *
 * <pre>
 *   C = (xA + R(θA) rA) − (xB + R(θB) rB)        J = [ 1  0  −rAy  −1  0   rBy ]     r: the arms, turned
 *                                                    [ 0  1   rAx   0 −1  −rBx ]
 *   J̇ ẋ = −θ̇A² rA + θ̇B² rB
 * </pre>
 *
 * <p>Beware: the constructors with one point take it in coordinates of the <i>world</i>, and the one with two points takes them
 * in those of the <i>bodies</i>. The constructor of {@link RodJoint} with as many numbers takes points of the world. The names of
 * {@link #worldPoint} and {@link #bodyPoints} say which points they take.
 */
public final class PinJoint extends Joint implements Link {
    private static final long serialVersionUID = 1L;

    private final double ax;
    private final double ay;
    private final double bx;
    private final double by;

    /**
     * Pins two bodies together at a point, where the bodies are now.
     *
     * @param a a body
     * @param b another body, or null for the world
     * @param x x of the point, in world coordinates
     * @param y y of the point, in world coordinates
     */
    public PinJoint(Body a, Body b, double x, double y) {
        super(a, b);
        point("", x, y);
        ax = localX(a, x, y);
        ay = localY(a, x, y);
        bx = localX(b, x, y);
        by = localY(b, x, y);
    }

    /**
     * Pins a body to a point of the world, where the body is now.
     *
     * @param a a body
     * @param x x of the point, in world coordinates
     * @param y y of the point, in world coordinates
     */
    public PinJoint(Body a, double x, double y) {
        this(a, null, x, y);
    }

    /**
     * Pins a point of one body to a point of another one, wherever the two are. The points are in the <i>bodies'</i> own
     * coordinates, not in those of the world. {@link #bodyPoints} does the same, and its name says so.
     *
     * @param a a body
     * @param ax x of the point of the first body, in its coordinates
     * @param ay y of the point of the first body, in its coordinates
     * @param b another body, or null for the world
     * @param bx x of the point of the second body, in its coordinates
     * @param by y of the point of the second body, in its coordinates
     */
    public PinJoint(Body a, double ax, double ay, Body b, double bx, double by) {
        super(a, b);
        point("a", ax, ay);
        point("b", bx, by);
        this.ax = ax;
        this.ay = ay;
        this.bx = bx;
        this.by = by;
    }

    /**
     * Pins two bodies together at a point of the world, where the bodies are now.
     *
     * @param a a body
     * @param b another body, or null for the world
     * @param x x of the point, in world coordinates
     * @param y y of the point, in world coordinates
     * @return a pin
     */
    public static PinJoint worldPoint(Body a, Body b, double x, double y) {
        return new PinJoint(a, b, x, y);
    }

    /**
     * Pins a point of one body to a point of another one, wherever the two are.
     *
     * @param a a body
     * @param ax x of the point of the first body, in its coordinates
     * @param ay y of the point of the first body, in its coordinates
     * @param b another body, or null for the world
     * @param bx x of the point of the second body, in its coordinates
     * @param by y of the point of the second body, in its coordinates
     * @return a pin; if its points are not in one place yet, {@code PhysicsEngine.assemble} puts them there
     */
    public static PinJoint bodyPoints(Body a, double ax, double ay, Body b, double bx, double by) {
        return new PinJoint(a, ax, ay, b, bx, by);
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

    @Override
    public int getRows() {
        return 2;
    }

    @Override
    public void evaluate(Equations e) {
        Body a = getBodyA();
        Body b = getBodyB();
        double cos = Trig.cos(a.getAngle());
        double sin = Trig.sin(a.getAngle());
        double rAx = cos * ax - sin * ay; // (45), (46)
        double rAy = sin * ax + cos * ay;
        cos = Trig.cos(angle(b));
        sin = Trig.sin(angle(b));
        double rBx = cos * bx - sin * by;
        double rBy = sin * bx + cos * by;
        double oA = a.getAngularVelocity();
        double oB = spin(b);
        double x = b == null ? 0 : b.getX();
        double y = b == null ? 0 : b.getY();
        e.set(0, (a.getX() + rAx) - (x + rBx), oB * oB * rBx - oA * oA * rAx); // (44)
        e.set(1, (a.getY() + rAy) - (y + rBy), oB * oB * rBy - oA * oA * rAy);
        e.setA(0, 1, 0, -rAy);
        e.setA(1, 0, 1, rAx);
        e.setB(0, -1, 0, rBy);
        e.setB(1, 0, -1, -rBx);
    }
}
