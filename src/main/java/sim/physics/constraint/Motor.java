// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.Objects;
import sim.physics.internal.Check;
import sim.physics.motion.Body;
import sim.physics.motion.SwitchedRow;

/**
 * A motor. It brings a coordinate to a speed and keeps it there, with a force or torque that is never greater than its limit.
 * With speed 0 it is a brake, or the dry friction of a joint.
 */
public final class Motor extends Switched {
    private static final long serialVersionUID = 1L;

    /** Speed within which the target is reached, relative to the speeds of the bodies. */
    private static final double REACHED = 1e-12;

    /** Way in a step, rad or relative to the size, of speeds that count at least: all less is the rounding of a brake. */
    private static final double LEAST = 1e-3;

    private double speed;
    private double limit;

    /** Speeds when the motor was last found off its target. */
    private double scale;

    /**
     * Creates a motor on any coordinate.
     *
     * @param coordinate a constraint of one row, whose C is driven; it need not be in an engine
     * @param speed speed of C
     * @param limit greatest force or torque along C, greater than 0
     * @throws IllegalArgumentException if the coordinate has more than one row, the speed is not finite, or the limit is not positive
     *     and finite
     */
    public Motor(Constraint coordinate, double speed, double limit) {
        super(coordinate);
        setSpeed(speed);
        setLimit(limit);
    }

    /**
     * Creates a motor that turns a body against another one.
     *
     * @param a a body
     * @param b another body, or null for the world
     * @param speed θ̇A − θ̇B, rad/time
     * @param torque greatest torque, greater than 0
     * @return a motor
     */
    public static Motor turning(Body a, Body b, double speed, double torque) {
        return new Motor(new GearJoint(a, b, -1), speed, torque);
    }

    /**
     * Creates a motor that drives a body along its rail.
     *
     * @param rail a slider or a slot; the motor acts once it is added itself, and is removed separately
     * @param speed speed of {@link Rail#getTravel()}, length/time
     * @param force greatest force along the rail, greater than 0
     * @return a motor
     */
    public static Motor sliding(Rail rail, double speed, double force) {
        return new Motor(Objects.requireNonNull(rail, "rail").travel(), speed, force);
    }

    /**
     * Creates a motor that drives a wheel, or brakes it with speed 0.
     *
     * @param wheel a wheel; it need not be in an engine. The motor acts once it is added itself, and is removed separately
     * @param speed speed with which the wheel is to roll, {@link Wheel#getRollingSpeed()}, length/time
     * @param force greatest force along the direction in which it rolls, greater than 0
     * @return a motor
     */
    public static Motor rolling(Wheel wheel, double speed, double force) {
        return new Motor(new Roll(Objects.requireNonNull(wheel, "wheel"), false), speed, force);
    }

    /**
     * Creates the grip of a wheel that skids, as by dry friction: what keeps {@link Wheel#getSlip()} at 0 with a bounded force. Add it in the
     * place of the wheel. It acts beside a motor that drives the wheel, and does not know of it: the force of both may be up to
     * √2 times as large if their limits are the same.
     *
     * @param wheel a wheel that is not added itself, as it would never slip
     * @param force greatest force across the wheel, such as its friction times its load, greater than 0
     * @return a motor with speed 0; its limit is the grip
     */
    public static Motor gripping(Wheel wheel, double force) {
        return new Motor(new Roll(Objects.requireNonNull(wheel, "wheel"), true), 0, force);
    }

    /**
     * Returns the speed that the motor aims at.
     *
     * @return rate of the coordinate
     */
    public double getSpeed() {
        return speed;
    }

    /**
     * Sets the speed that the motor aims at. You may call this at any time, between steps or from a listener; it holds from that
     * instant on.
     *
     * @param speed rate of the coordinate
     * @throws IllegalArgumentException if it is not finite
     */
    public void setSpeed(double speed) {
        boolean isNew = Check.finite("speed", speed) != this.speed;
        this.speed = speed;
        setAtOnce(isNew);
    }

    /** Between steps nothing else is to be done: the next one begins by deciding what its motors do. */
    private void setAtOnce(boolean isNew) {
        if (isNew && getBodyA().state().isOpenWithin()) {
            Joint.stir(getBodyA(), getBodyB());
        }
    }

    /**
     * Returns the greatest force or torque.
     *
     * @return force or torque, greater than 0
     */
    public double getLimit() {
        return limit;
    }

    /**
     * Sets the greatest force or torque. Like the speed, it may be set at any time.
     *
     * @param limit greatest force or torque, greater than 0
     * @throws IllegalArgumentException if it is not positive and finite
     */
    public void setLimit(double limit) {
        boolean isNew = Check.positive("limit", limit) != this.limit;
        this.limit = limit;
        setAtOnce(isNew);
    }

    @Override
    double remembered() {
        return scale;
    }

    @Override
    void remember(double what) {
        scale = what;
    }

    @Override
    double gap(double q) {
        return 0;
    }

    @Override
    double decide(double q, double now, double time) {
        double missing = speed - now;
        double least = LEAST * (isAngle(0) ? 1 : getSize()) / time;
        isOn = Math.abs(missing) <= REACHED * Math.max(least, Math.max(scale, Math.abs(speed)));
        force = isOn ? 0 : missing > 0 ? limit : -limit;
        if (!isOn) {
            scale = Math.max(least, Math.abs(speed) + Math.abs(now));
        }
        return Double.NaN;
    }

    /** Whether an impact has turned what its coordinate lacks: it would push away from its speed. */
    @Override
    boolean isStruck(double q, double now, double time) {
        return !isOn && force * (speed - now) < 0;
    }

    @Override
    double least() {
        return -limit;
    }

    @Override
    double greatest() {
        return limit;
    }

    @Override
    double watch(double q, double now) {
        double unit = unit(now);
        return unit > 0 ? (speed - now) * Math.signum(force) / (REACHED * unit) : 0; // a brake that yields from rest
    }

    @Override
    double slope(double q, double now, double change) {
        return -change * Math.signum(force) / (REACHED * unit(now));
    }

    private double unit(double now) {
        return Math.max(scale, Math.abs(speed)) > 0 ? Math.max(scale, Math.abs(speed)) : Math.abs(now);
    }

    @Override
    double toGo(double q, double now) {
        return watch(q, now) > 0 ? Double.POSITIVE_INFINITY : Double.NaN;
    }

    @Override
    void hold(double q) {
        // a motor that is off has not reached its speed
    }

    @Override
    void describe(SwitchedRow to, double q, double arm) {
        to.isMotor = true;
        to.speed = speed * arm;
        to.limit = limit / arm;
    }

    @Override
    double target() {
        return speed;
    }
}
