// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.internal.Check;
import sim.physics.motion.Body;
import sim.physics.motion.Link;

/**
 * A rail or a slot: a point of one body moves along a straight line of another one, or of the world. With n the normal of the
 * line, which turns with the second body, and d = pA − pB:
 *
 * <pre>
 *   C0 = n·d            J = [ n  rA⊥·n   −n  −rB⊥·n + n⊥·d ]
 *   J̇ ẋ = n·(−θ̇A² rA + θ̇B² rB) + 2 θ̇B n⊥·u − θ̇B² n·d,   u = ḋ
 * </pre>
 */
public abstract sealed class Rail extends Joint implements Link permits SliderJoint, SlotJoint {
    private static final long serialVersionUID = 1L;

    private final Anchor first;
    private final Anchor second;
    private final double normalX;
    private final double normalY;

    /** A line through a point, where the two bodies are now; all in world coordinates. */
    Rail(Body a, Body b, double x, double y, double dx, double dy) {
        super(a, b);
        first = Anchor.at(a, "", x, y);
        second = Anchor.at(b, "", x, y);
        double factor = Check.direction("dx", dx, "dy", dy);
        double toX = factor * dx;
        double toY = factor * dy;
        double length = Math.sqrt(toX * toX + toY * toY);
        second.evaluate();
        double nx = -toY / length;
        double ny = toX / length;
        normalX = second.cos * nx + second.sin * ny;
        normalY = second.cos * ny - second.sin * nx;
    }

    /**
     * Returns how far the first body has slid.
     *
     * @return distance along the line from its place when the joint was made
     */
    public final double getTravel() {
        first.evaluate();
        second.evaluate();
        double nx = second.cos * normalX - second.sin * normalY;
        double ny = second.sin * normalX + second.cos * normalY;
        return (first.x - second.x) * ny - (first.y - second.y) * nx;
    }

    /**
     * Returns how fast the first body slides: the rate of {@link #getTravel()}.
     *
     * @return speed along the line, length/time
     */
    public final double getTravelSpeed() {
        Equations now = new Equations();
        travel().evaluate(now);
        return now.speed(getBodyA(), getBodyB());
    }

    /**
     * Returns the x component of the direction of the line, in the coordinates of the second body.
     *
     * @return x of a vector of length 1
     */
    public final double getDirectionX() {
        return normalY;
    }

    /**
     * Returns the y component of the direction of the line, in the coordinates of the second body.
     *
     * @return y of a vector of length 1
     */
    public final double getDirectionY() {
        return -normalX;
    }

    @Override
    public final double getAnchorAX() {
        return first.localX;
    }

    @Override
    public final double getAnchorAY() {
        return first.localY;
    }

    @Override
    public final double getAnchorBX() {
        return second.localX;
    }

    @Override
    public final double getAnchorBY() {
        return second.localY;
    }

    /** The coordinate that {@link #getTravel} says. */
    final Joint travel() {
        return new Travel(this, first, second, getDirectionX(), getDirectionY());
    }

    /** The first row. */
    final void separate(Equations e) {
        separate(e, first, second, normalX, normalY);
    }

    /** How far the first point is from the second along n, which is given as the second body has it. */
    static void separate(Equations e, Anchor first, Anchor second, double normalX, double normalY) {
        first.evaluateArm();
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
        return true;
    }
}
