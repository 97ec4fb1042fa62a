// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.Objects;
import sim.physics.internal.Check;
import sim.physics.motion.Body;
import sim.physics.motion.SwitchedRow;

/**
 * The stops of a joint: a coordinate stays between two bounds. It hits a bound as bodies hit one another, with a restitution, and
 * rests there as long as it is pressed against it. Angles do not wrap: bounds may be any number of turns away. If a coordinate is
 * put beyond a bound, or is beyond one when the stops are added, it is not torn back. It is held where it is until it moves back
 * by itself.
 */
public final class Limit extends Switched {
    private static final long serialVersionUID = 1L;

    /** Distance within which a bound is reached, relative to the size of the coordinate. */
    private static final double REACHED = 1e-11;

    private double lower;
    private double upper;
    private final double restitution;

    /** −1 or +1: at the lower or the upper bound; 0: between. */
    private int side;

    /**
     * Creates stops on any coordinate.
     *
     * @param coordinate a constraint of one row, whose C is bounded; it need not be in an engine
     * @param lower lower bound, may be −∞
     * @param upper upper bound, greater than the lower one, may be ∞
     * @param restitution 0 to stop at a bound, 1 to bounce off elastically
     * @throws IllegalArgumentException if the coordinate has more than one row, the lower bound is not less than the upper one, or
     *     the restitution is not between 0 and 1
     */
    public Limit(Constraint coordinate, double lower, double upper, double restitution) {
        super(coordinate);
        bound(lower, upper);
        this.restitution = Check.between("restitution", restitution, 0, 1);
    }

    private void bound(double least, double most) {
        if (!(least < most)) {
            throw new IllegalArgumentException("lower is " + least + ": it must be less than upper, " + most);
        }
        lower = least;
        upper = most;
    }

    /**
     * Creates stops for the angle of a body against another one, counted from where the two are now.
     *
     * @param a a body
     * @param b another body, or null for the world
     * @param lower lower bound of θA − θB less its present value, rad
     * @param upper upper bound
     * @return stops that do not bounce
     */
    public static Limit angle(Body a, Body b, double lower, double upper) {
        return angle(a, b, lower, upper, 0);
    }

    /**
     * Creates stops for the angle of a body against another one, with buffers.
     *
     * @param a a body
     * @param b another body, or null for the world
     * @param lower lower bound of θA − θB less its present value, rad
     * @param upper upper bound
     * @param restitution 0 if the bodies stop there, 1 if they bounce off elastically
     * @return stops with that restitution
     */
    public static Limit angle(Body a, Body b, double lower, double upper, double restitution) {
        return new Limit(new GearJoint(a, b, -1), lower, upper, restitution);
    }

    /**
     * Creates the ends of a rail.
     *
     * @param rail a slider or a slot; its ends hold once they are added themselves, and are removed separately
     * @param lower lower bound of {@link Rail#getTravel()}, may be −∞
     * @param upper upper bound, greater than the lower one, may be ∞
     * @return stops that do not bounce
     */
    public static Limit travel(Rail rail, double lower, double upper) {
        return travel(rail, lower, upper, 0);
    }

    /**
     * Creates the ends of a rail, with buffers.
     *
     * @param rail a slider or a slot
     * @param lower lower bound of {@link Rail#getTravel()}, may be −∞
     * @param upper upper bound, greater than the lower one, may be ∞
     * @param restitution 0 if the body stops there, 1 if it bounces off elastically
     * @return stops with that restitution
     */
    public static Limit travel(Rail rail, double lower, double upper, double restitution) {
        return new Limit(Objects.requireNonNull(rail, "rail").travel(), lower, upper, restitution);
    }

    /**
     * Creates a rope: it keeps two points from getting farther apart than its length. {@link #getCoordinate()} is a
     * {@link RodJoint} then, whose {@link RodJoint#setLength} sets that of the rope.
     *
     * @param a a body
     * @param ax x of the point of the first body, in its coordinates
     * @param ay y of the point of the first body, in its coordinates
     * @param b another body, or null for the world
     * @param bx x of the point of the second body, in its coordinates
     * @param by y of the point of the second body, in its coordinates
     * @param length length of the rope
     * @return stops that do not bounce
     */
    public static Limit rope(Body a, double ax, double ay, Body b, double bx, double by, double length) {
        return rope(a, ax, ay, b, bx, by, length, 0);
    }

    /**
     * Creates an elastic rope, which throws back what pulls it taut.
     *
     * @param a a body
     * @param ax x of the point of the first body, in its coordinates
     * @param ay y of the point of the first body, in its coordinates
     * @param b another body, or null for the world
     * @param bx x of the point of the second body, in its coordinates
     * @param by y of the point of the second body, in its coordinates
     * @param length length of the rope
     * @param restitution 0 if the points go no farther, 1 if they come back as fast as they went
     * @return stops with that restitution
     */
    public static Limit rope(Body a, double ax, double ay, Body b, double bx, double by, double length, double restitution) {
        return new Limit(new RodJoint(a, ax, ay, b, bx, by, length), Double.NEGATIVE_INFINITY, 0, restitution);
    }

    /**
     * Returns the lower bound.
     *
     * @return bound of the coordinate; may be −∞
     */
    public double getLower() {
        return lower;
    }

    /**
     * Returns the upper bound.
     *
     * @return bound of the coordinate; may be ∞
     */
    public double getUpper() {
        return upper;
    }

    /**
     * Sets both bounds. You may call this at any time, between steps or from a listener within one; they hold from that instant on. A
     * coordinate that is beyond a new bound is as one that was put there: by events it is held where it is until it moves back by
     * itself, and by time stepping it is brought back at the pace at which gaps of joints are closed. In neither case does it get a
     * velocity by that. To drive it back with a force, take a {@link Motor}.
     *
     * @param lower lower bound, may be −∞
     * @param upper upper bound, greater than the lower one, may be ∞
     * @throws IllegalArgumentException if the lower bound is not less than the upper one, or one of the two is not a number; the
     *     bounds are as before then
     */
    public void setBounds(double lower, double upper) {
        boolean isNew = lower != this.lower || upper != this.upper;
        if (isNew && lower < upper) {
            Joint.stir(getBodyA(), getBodyB());
        }
        bound(lower, upper);
    }

    /**
     * Returns the restitution with which the coordinate hits a bound.
     *
     * @return 0 if it stops, 1 if it bounces off elastically
     */
    public double getRestitution() {
        return restitution;
    }

    /** The bounds that hold now: what was put beyond one is held where it is. */
    private double least(double bound) {
        return side < 0 ? held : bound;
    }

    private double most(double bound) {
        return side > 0 ? held : bound;
    }

    private double reach(double bound) {
        double size = isAngle(0) ? 1 : getSize();
        return REACHED * (Double.isInfinite(bound) ? size : size + Math.abs(bound));
    }

    @Override
    double remembered() {
        return side;
    }

    @Override
    void remember(double what) {
        side = (int) what;
    }

    @Override
    double gap(double q) {
        return q - held;
    }

    @Override
    double leeway() {
        return reach(side < 0 ? lower : upper);
    }

    @Override
    double decide(double q, double now, double time) {
        side = 0;
        if (q - lower <= reach(lower)) {
            side = -1;
        } else if (upper - q <= reach(upper)) {
            side = 1;
        }
        force = 0;
        held = side < 0 ? lower : upper;
        if (side != 0 && side * (q - held) > reach(held)) {
            held = q; // it was put there: it goes no farther, and is not torn back
        }
        double into = now * side; // positive: into the bound
        // a speed that does not take it from there is rounding, and whether it leaves, the forces say
        isOn = side != 0 && into * time >= -reach(side < 0 ? lower : upper);
        if (!isOn || into <= 0) {
            return Double.NaN;
        }
        isOn = restitution == 0;
        return -restitution * now;
    }

    @Override
    boolean isStruck(double q, double now, double time) {
        return q - lower <= reach(lower) && -now * time > reach(lower) || upper - q <= reach(upper) && now * time > reach(upper);
    }

    @Override
    double least() {
        return side < 0 ? 0 : Double.NEGATIVE_INFINITY;
    }

    @Override
    double greatest() {
        return side < 0 ? Double.POSITIVE_INFINITY : 0;
    }

    @Override
    double watch(double q, double now) {
        double least = least(lower);
        double most = most(upper);
        return Math.min((q - least) / reach(least), (most - q) / reach(most));
    }

    @Override
    double slope(double q, double now, double change) {
        double below = (q - least(lower)) / reach(least(lower));
        double above = (most(upper) - q) / reach(most(upper));
        return below < above ? now / reach(least(lower)) : -now / reach(most(upper));
    }

    @Override
    double toGo(double q, double now) {
        double way = now > 0 ? most(upper) - q : least(lower) - q;
        return watch(q, now) < 0 && way / now > 0 ? Double.NaN : now == 0 ? Double.POSITIVE_INFINITY : way / now;
    }

    @Override
    void hold(double q) {
        isOn |= side != 0 && Math.abs(watch(q, 0)) <= 1;
    }

    @Override
    void describe(SwitchedRow to, double q, double arm) {
        to.isMotor = false;
        to.aboveLower = (q - lower) * arm;
        to.belowUpper = (upper - q) * arm;
        to.restitution = restitution;
    }

    @Override
    double target() {
        return 0;
    }
}
