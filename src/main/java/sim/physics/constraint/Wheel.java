// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.internal.Check;
import sim.physics.internal.Trig;
import sim.physics.motion.Body;

/**
 * A wheel of a body that is seen from above. It stands at a point p of the body, rolls freely along a direction t that turns with
 * the body, and never slips across it. With n the normal of t to its left and r from the body's centre to p:
 *
 * <pre>
 *   n·ṗ = 0            J = [ n  r⊥·n ]
 *   J̇ ẋ = −θ̇ t·ṗ − θ̇² r·n
 * </pre>
 *
 * <p>This is an equation of velocities, which is the derivative of no C(x): a wheel may be brought to any place. So its C is 0
 * everywhere, and nothing is closed. Like other joints it does no work, and holds in impacts, too.
 *
 * <p>Add a {@link Motor#rolling} to drive it or to brake it. For a wheel that may skid, do not add the wheel itself but a
 * {@link Motor#gripping}.
 */
public final class Wheel extends Joint {
    private static final long serialVersionUID = 1L;

    private final Anchor anchor;
    private double steering;
    private double steeringX = 1;
    private double steeringY;

    /**
     * Makes a wheel that rolls along the x axis of its body.
     *
     * @param body a body
     * @param x x of the point where it stands, in the body's coordinates
     * @param y y of the point where it stands, in the body's coordinates
     * @throws IllegalArgumentException if a number is not finite
     */
    public Wheel(Body body, double x, double y) {
        this(body, x, y, 0);
    }

    /**
     * Makes a wheel that rolls along any direction of its body.
     *
     * @param body a body
     * @param x x of the point where it stands, in the body's coordinates
     * @param y y of the point where it stands, in the body's coordinates
     * @param steering angle from the body's x axis to the direction in which it rolls, rad
     * @throws IllegalArgumentException if a number is not finite
     */
    public Wheel(Body body, double x, double y, double steering) {
        super(body, null);
        anchor = Anchor.local(body, "", x, y);
        steer(Check.finite("steering", steering));
    }

    private void steer(double angle) {
        steering = angle;
        steeringX = Trig.cos(angle);
        steeringY = Trig.sin(angle);
    }

    /**
     * Returns the x coordinate of the point where the wheel stands, in its body's coordinates.
     *
     * @return x, length
     */
    public double getAnchorAX() {
        return anchor.localX;
    }

    /**
     * Returns the y coordinate of the point where the wheel stands, in its body's coordinates.
     *
     * @return y, length
     */
    public double getAnchorAY() {
        return anchor.localY;
    }

    /**
     * Returns the angle from the body's x axis to the direction in which the wheel rolls.
     *
     * @return angle, rad
     */
    public double getSteering() {
        return steering;
    }

    /**
     * Steers the wheel. You may call this at any time, between steps or from a listener within one; it holds from that instant on.
     *
     * <p>The wheel jumps to the angle. If it was added itself, what its point has of a velocity across the new direction is taken
     * away as by an impact that is not elastic. So a car that is steered as it rolls loses about δ² of its energy with each jump
     * of δ. A wheel on a body of its own, with a pin and a motor that turns it, loses none.
     *
     * @param steering angle from the body's x axis to the direction in which it rolls, rad
     * @throws IllegalArgumentException if it is not finite
     */
    public void setSteering(double steering) {
        boolean isNew = Check.finite("steering", steering) != this.steering;
        steer(steering);
        if (isNew) {
            write(getBodyA(), null);
        }
    }

    /**
     * Returns the speed with which the wheel rolls, whether or not it was added. Asking changes nothing.
     *
     * @return t·ṗ, length/time; negative if it rolls backwards
     */
    public double getRollingSpeed() {
        anchor.evaluate();
        return alongX() * anchor.vx + alongY() * anchor.vy;
    }

    /**
     * Returns the speed with which the wheel slips sideways: 0 up to rounding for one that was added, and what is left of it for
     * one that skids. Asking changes nothing.
     *
     * @return n·ṗ, length/time; positive if it slips to its left, as seen where y points upwards
     */
    public double getSlip() {
        anchor.evaluate();
        return alongX() * anchor.vy - alongY() * anchor.vx;
    }

    private double alongX() {
        return anchor.cos * steeringX - anchor.sin * steeringY;
    }

    private double alongY() {
        return anchor.sin * steeringX + anchor.cos * steeringY;
    }

    @Override
    public int getRows() {
        return 1;
    }

    @Override
    public void evaluate(Equations e) {
        anchor.evaluate();
        evaluate(e, -alongY(), alongX());
    }

    /** The same for the speed along the direction in which it rolls. */
    void evaluateRolling(Equations e) {
        anchor.evaluate();
        evaluate(e, alongX(), alongY());
    }

    /** The speed of the point along a direction that turns with the body. */
    private void evaluate(Equations e, double nx, double ny) {
        double turning = anchor.omega * (nx * anchor.vy - ny * anchor.vx); // ṅ·ṗ
        e.set(0, 0, turning + anchor.centripetal(nx, ny));
        e.setA(0, nx, ny, anchor.lever(nx, ny));
    }
}
