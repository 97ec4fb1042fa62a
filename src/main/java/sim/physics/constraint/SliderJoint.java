// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.internal.Check;
import sim.physics.motion.Body;
import sim.physics.motion.Link;

/**
 * A rail: a point of one body moves along a straight line of another one, or of the world, and the two do not turn
 * against each other. With n the normal of the line, which turns with the second body, and d = pA − pB:
 *
 * <pre>
 *   C0 = n·d            J = [ n  rA⊥·n   −n  −rB⊥·n + n⊥·d ]
 *   J̇ ẋ = n·(−θ̇A² rA + θ̇B² rB) + 2 θ̇B n⊥·u − θ̇B² n·d,   u = ḋ
 *   C1 = θA − θB − c
 * </pre>
 */
public final class SliderJoint extends Joint implements Link {
    private static final long serialVersionUID = 1L;

    private final Anchor first;
    private final Anchor second;
    private final double normalX;
    private final double normalY;
    private final double angle;

    /**
     * Lets a body slide along a line through a point, where the two bodies are now.
     *
     * @param a the body that slides
     * @param b the body with the rail, or null for the world
     * @param x point, in world coordinates
     * @param y point, in world coordinates
     * @param dx direction of the line, of any length
     * @param dy direction of the line
     */
    public SliderJoint(Body a, Body b, double x, double y, double dx, double dy) {
        super(a, b);
        first = Anchor.at(a, x, y);
        second = Anchor.at(b, x, y);
        point(dx, dy);
        double length = Check.positive("length of the direction", Math.sqrt(dx * dx + dy * dy));
        second.evaluate();
        double nx = -dy / length;
        double ny = dx / length;
        normalX = second.cos * nx + second.sin * ny;
        normalY = second.cos * ny - second.sin * nx;
        angle = a.getAngle() - angle(b);
    }

    /**
     * How far the body has slid.
     *
     * @return distance along the line from where it was when the joint was made
     */
    public double getTravel() {
        first.evaluate();
        second.evaluate();
        double nx = second.cos * normalX - second.sin * normalY;
        double ny = second.sin * normalX + second.cos * normalY;
        return (first.x - second.x) * ny - (first.y - second.y) * nx;
    }

    /**
     * Direction of the line, in the coordinates of the second body.
     *
     * @return x of a vector of length 1
     */
    public double getDirectionX() {
        return normalY;
    }

    /**
     * Direction of the line, in the coordinates of the second body.
     *
     * @return y of a vector of length 1
     */
    public double getDirectionY() {
        return -normalX;
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
        return 2;
    }

    @Override
    public boolean isAngle(int row) {
        return row == 1;
    }

    /** The coordinate that {@link #getTravel} says. */
    Joint travel() {
        return new Travel(this, first, second, getDirectionX(), getDirectionY());
    }

    @Override
    public void evaluate(Equations e) {
        separate(e, first, second, normalX, normalY);
        e.set(1, getBodyA().getAngle() - angle(getBodyB()) - angle, 0);
        e.setA(1, 0, 0, 1);
        e.setB(1, 0, 0, -1);
    }

    /** The first row: how far the first point is from the second along n, which is given as the second body has it. */
    static void separate(Equations e, Anchor first, Anchor second, double normalX, double normalY) {
        first.evaluate();
        second.evaluate();
        double nx = second.cos * normalX - second.sin * normalY;
        double ny = second.sin * normalX + second.cos * normalY;
        double dx = first.x - second.x;
        double dy = first.y - second.y;
        double away = nx * dx + ny * dy;
        double along = nx * dy - ny * dx; // n⊥·d
        double speed = nx * (first.vy - second.vy) - ny * (first.vx - second.vx); // n⊥·u
        double omega = second.omega;
        double turning = 2 * omega * speed - omega * omega * away;
        e.set(0, away, first.centripetal(nx, ny) - second.centripetal(nx, ny) + turning);
        e.setA(0, nx, ny, first.lever(nx, ny));
        e.setB(0, -nx, -ny, along - second.lever(nx, ny));
    }

    @Override
    boolean describe(JointRows rows, int node) {
        rows.addSlide(node, first, second, normalX, normalY);
        rows.addAngle(node, 1, this, -1, angle);
        return true;
    }
}
