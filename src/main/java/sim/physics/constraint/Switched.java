// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.Arrays;
import java.util.Objects;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.motion.SwitchedRow;

/**
 * A constraint of one row, on a coordinate q of two bodies, that acts at some times only: its force is bounded, or it
 * pushes and does not pull. The coordinate is the C of another constraint of one row, and need not be 0.
 *
 * <p>Its public methods are not final: a public class inherits those in a form that cannot be called by reflection, as inspectors do.
 */
abstract class Switched implements Constraint {
    private static final long serialVersionUID = 1L;

    /** Number of values of {@link #keep}. */
    static final int MEMORY = 13;

    /** Part of a bound within which a force has reached it. */
    private static final double BEARS = 1e-11;

    /** How nearly the two bodies' parts of a row are opposite, relative to themselves. */
    private static final double MEETS = 1e-9;

    /** Part of what an acceleration is the sum of that is rounding. */
    private static final double ROUNDING = 1e-11;

    private final Constraint coordinate;

    /** Whether the row acts; and if it does not, the force along the coordinate. */
    boolean isOn;

    double force;

    /** The value at which a stop holds its coordinate. */
    double held;

    /** The same for one evaluation of the accelerations only. */
    boolean isOnNow;

    double forceNow;

    /** The greatest force that it has been seen to need. */
    private double strongest;

    /** Whether it was found at the start of a path that the force of the row would be out of its bounds. */
    boolean yields;

    private boolean collideConnected;
    private double value;

    /** J̇ ẋ of the coordinate. */
    private double curvature;

    private final double[] row = new double[6];
    private final double[] lastRow = new double[6];

    /** Whether the coordinate is of an author. */
    private final boolean isAuthors;

    Switched(Constraint coordinate) {
        this.coordinate = Objects.requireNonNull(coordinate, "coordinate");
        if (coordinate instanceof Rail) { // a slot has one row: how far the pin is beside it
            throw new IllegalArgumentException("coordinate is " + coordinate + ": Motor.sliding and Limit.travel take a rail");
        }
        if (coordinate instanceof Wheel) {
            throw new IllegalArgumentException("coordinate is " + coordinate + ": Motor.rolling and Motor.gripping take a wheel");
        }
        if (coordinate.getRows() != 1 || coordinate instanceof Switched) {
            throw new IllegalArgumentException("coordinate is " + coordinate + ": it must have one row");
        }
        isAuthors = !Joint.isOwn(coordinate);
    }

    final Constraint coordinate() {
        return coordinate;
    }

    @Override
    public Body getBodyA() {
        return coordinate.getBodyA();
    }

    @Override
    public Body getBodyB() {
        return coordinate.getBodyB();
    }

    /**
     * Returns the coordinate that this acts on: the constraint that it was made with, the rail if it is a motor or an end of a
     * rail, the wheel if it is a motor of one, a {@link RodJoint} for a rope, a {@link GearJoint} for a turn.
     *
     * @return never null
     */
    public Constraint getCoordinate() {
        return coordinate instanceof Travel travel ? travel.rail : coordinate instanceof Roll roll ? roll.wheel : coordinate;
    }

    /**
     * Returns the value of the coordinate where the bodies are now, whether the motor or stop acts or not: for a turn, by how much
     * that of the first body against the second one has changed since the coordinate was made, in rad; for a rail, its travel, and for a rope,
     * the distance less the length, in your unit of length; for a wheel 0, as it has none. Asking changes nothing. {@link #evaluate} is for
     * the engine: it gives 0 while the motor or stop does not act.
     *
     * @return what the bounds of a {@link Limit} refer to, and the rate of which is the speed of a {@link Motor}
     */
    public double getValue() {
        Equations now = new Equations();
        coordinate.evaluate(now);
        return now.c[0];
    }

    /**
     * Returns how fast the coordinate changes now, whether the motor or stop acts or not: the rate of {@link #getValue()}, and for a wheel
     * the speed with which it rolls, or slips. It is what a controller compares with the speed that it asks a {@link Motor} for.
     *
     * @return rad/time for an angle, length/time otherwise
     */
    public double getRate() {
        Equations now = new Equations();
        coordinate.evaluate(now);
        return now.speed(getBodyA(), getBodyB());
    }

    /**
     * Returns whether the two bodies collide with one another, if no joint decides that.
     *
     * @return false unless set
     */
    public boolean isCollideConnected() {
        return collideConnected;
    }

    /**
     * Sets whether the two bodies collide with one another. As with {@link Joint#setCollideConnected}, you may call this at any
     * time. It counts where only motors and stops are between the two bodies, such as a rope. Otherwise the joints decide.
     *
     * @param collide false to let them overlap
     */
    public void setCollideConnected(boolean collide) {
        boolean isNew = collide != collideConnected;
        if (isNew) {
            Joint.stir(getBodyA(), getBodyB());
        }
        collideConnected = collide;
    }

    @Override
    public int getRows() {
        return 1;
    }

    @Override
    public boolean isAngle(int row) {
        return coordinate.isAngle(row);
    }

    @Override
    public double getSize() {
        return coordinate.getSize();
    }

    @Override
    public void evaluate(Equations equations) {
        coordinate.evaluate(equations);
        if (isAuthors) {
            equations.check(coordinate, 1); // before what does not act is set to 0
        }
        value = equations.c[0];
        curvature = equations.rate[0];
        System.arraycopy(equations.jA, 0, row, 0, 3);
        System.arraycopy(equations.jB, 0, row, 3, 3);
        equations.c[0] = isOnNow ? gap(value) : 0;
        if (!isOnNow) {
            equations.rate[0] = 0;
            equations.setA(0, 0, 0, 0);
            equations.setB(0, 0, 0, 0);
        }
    }

    /** The same, given what the coordinate's row says; a row that does not act is cleared. */
    final void take(double[] c, double[] rate, double[] j, int node) {
        int o = Island.J * node;
        value = c[2 * node];
        curvature = rate[2 * node];
        c[2 * node] = isOnNow ? gap(value) : 0;
        for (int k = 0; k < 3; k++) {
            row[k] = j[o + k];
            row[3 + k] = j[o + 6 + k];
        }
        if (!isOnNow) {
            rate[2 * node] = 0;
            for (int k = 0; k < 3; k++) {
                j[o + k] = 0;
                j[o + 6 + k] = 0;
            }
        }
    }

    /** Finds the coordinate, a turn, at some positions. */
    final void measure(double[] x, int blockA, int blockB) {
        value = ((GearJoint) coordinate).open(
                blockA < 0 ? getBodyA().getAngle() : x[blockA + State.THETA],
                blockB < 0 ? Joint.angle(getBodyB()) : x[blockB + State.THETA]);
    }

    /** The coordinate at the last evaluation. */
    final double value() {
        return value;
    }

    /** The coordinate's rate, from the last evaluation's J; blocks of its bodies, −1 for what cannot move. */
    final double speed(double[] v, int blockA, int blockB) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            sum += (blockA < 0 ? 0 : row[k] * v[blockA + k]) + (blockB < 0 ? 0 : row[3 + k] * v[blockB + k]);
        }
        return sum;
    }

    /** Whether the coordinate of another row is the same, 1, or the same the other way, −1; else 0. */
    final int sense(Switched other) {
        Constraint one = coordinate;
        Constraint two = other.coordinate;
        boolean isRail = one instanceof Travel && two instanceof Travel && ((Travel) one).rail == ((Travel) two).rail;
        if (one == two || isRail) {
            return 1;
        }
        boolean areTurns = one instanceof GearJoint && two instanceof GearJoint && ((GearJoint) one).getRatio() == ((GearJoint) two).getRatio();
        if (areTurns && getBodyA() == other.getBodyA() && getBodyB() == other.getBodyB()) {
            return 1;
        }
        boolean isBack = areTurns && getBodyA() == other.getBodyB() && getBodyB() == other.getBodyA() && ((GearJoint) one).getRatio() == -1;
        return isBack ? -1 : 0;
    }

    /** Says what the row is of a coordinate that is the turn of one body against the other one, wherever these are; blocks are −1 for what cannot move. */
    final void turn(int blockA, int blockB) {
        Arrays.fill(row, 0);
        row[State.THETA] = blockA < 0 ? 0 : 1;
        row[State.BLOCK + State.THETA] = blockB < 0 ? 0 : -1;
        curvature = 0;
    }

    /** What the coordinate's rate changes by beside what accelerations do, from the last evaluation. */
    final double curvature() {
        return curvature;
    }

    /** By how much a coordinate that is an angle changes as its bodies turn. */
    final double turn(double a, double b) {
        return row[2] * a + row[5] * b;
    }

    /**
     * Whether a row that has yielded should act again: with the bound of its force that it pushes with, the coordinate is
     * accelerated to the side from which that force keeps it.
     */
    final boolean isPressed(double[] a, int blockA, int blockB) {
        return isPressed(force, a, blockA, blockB);
    }

    /** The same of one that has yielded for one evaluation only. */
    final boolean isPressedNow(double[] a, int blockA, int blockB) {
        return isPressed(forceNow, a, blockA, blockB);
    }

    private boolean isPressed(double force, double[] a, int blockA, int blockB) {
        double sum = curvature;
        double terms = Math.abs(curvature);
        for (int k = 0; k < 3; k++) {
            double one = blockA < 0 ? 0 : row[k] * a[blockA + k];
            double other = blockB < 0 ? 0 : row[3 + k] * a[blockB + k];
            sum += one + other;
            terms += Math.abs(one) + Math.abs(other);
        }
        double away = force == greatest() ? -sum : sum;
        return away < -ROUNDING * terms;
    }

    /** u += W rowᵀ force. */
    final void push(double f, double[] w, double[] u, int blockA, int blockB) {
        for (int k = 0; k < 3; k++) {
            if (blockA >= 0) {
                u[blockA + k] += w[blockA + k] * (row[k] * f);
            }
            if (blockB >= 0) {
                u[blockB + k] += w[blockB + k] * (row[3 + k] * f);
            }
        }
    }

    final Reaction reaction(double f) {
        return new Reaction(row[0] * f, row[1] * f, row[2] * f);
    }

    /**
     * Describes the row, from its last evaluation. Turns are given as ways at an arm, so that all rows of a problem have the same unit.
     *
     * @param blockA block of the first body, −1 for what cannot move
     * @param blockB the same of the second one
     */
    final void describe(SwitchedRow to, int blockA, int blockB) {
        to.first = blockA < 0 ? -1 : blockA / State.BLOCK;
        to.second = blockB < 0 ? -1 : blockB / State.BLOCK;
        to.nx = blockB < 0 ? -row[0] : row[3];
        to.ny = blockB < 0 ? -row[1] : row[4];
        boolean isOne = blockA < 0 || blockB < 0 || isAlongOneLine(); // up to rounding: of that nothing is to come
        to.firstX = isOne ? to.nx : -row[0];
        to.firstY = isOne ? to.ny : -row[1];
        double arm = arm();
        to.firstLever = -row[2] * arm;
        to.secondLever = row[5] * arm;
        to.force = isOn ? 0 : force / arm;
        to.size = isAngle(0) ? arm : getSize();
        describe(to, value, arm);
    }

    /** The same of the row where its bodies are now, of which nothing is kept. */
    final void describeNow(SwitchedRow to, Equations now, int blockA, int blockB) {
        System.arraycopy(row, 0, lastRow, 0, row.length);
        double lastValue = value;
        double lastCurvature = curvature;
        now.clear(1);
        evaluate(now);
        describe(to, blockA, blockB);
        System.arraycopy(lastRow, 0, row, 0, row.length);
        value = lastValue;
        curvature = lastCurvature;
    }

    /** Whether its force on one body is the opposite of that on the other one. */
    private boolean isAlongOneLine() {
        double most = Math.max(Math.abs(row[0]), Math.abs(row[1]));
        return Math.abs(row[0] + row[3]) <= MEETS * most && Math.abs(row[1] + row[4]) <= MEETS * most;
    }

    /** The lever at which a turn is taken for a way; 1 for ways. A power of two, so that no bit is lost by it. */
    final double arm() {
        return isAngle(0) ? Math.scalb(1.0, Math.getExponent(TieEquations.size(this))) : 1;
    }

    /** Says what the row asks for; turns as ways at an arm. */
    abstract void describe(SwitchedRow to, double q, double arm);

    /** Lets the row not act until that is decided anew. */
    final void forget() {
        isOn = false;
        isOnNow = false;
    }

    /** Copies all that changes with time. */
    final void keep(double[] to, int at) {
        to[at] = isOn ? 1 : 0;
        to[at + 1] = force;
        to[at + 2] = isOnNow ? 1 : 0;
        to[at + 3] = forceNow;
        to[at + 4] = value;
        to[at + 5] = remembered();
        System.arraycopy(row, 0, to, at + 6, row.length);
        to[at + 12] = held;
    }

    final void restore(double[] from, int at) {
        isOn = from[at] != 0;
        force = from[at + 1];
        isOnNow = from[at + 2] != 0;
        forceNow = from[at + 3];
        value = from[at + 4];
        remember(from[at + 5]);
        System.arraycopy(from, at + 6, row, 0, row.length);
        held = from[at + 12];
    }

    /** What the row keeps in mind from one decision to the next. */
    abstract double remembered();

    abstract void remember(double what);

    /** By how much a force is within its bounds, in units of what counts as reached: of a bound, or of the greatest force. */
    final double spare(double f) {
        strongest = Math.max(strongest, Math.abs(f));
        double bound = Math.max(Double.isInfinite(least()) ? 0 : -least(), Double.isInfinite(greatest()) ? 0 : greatest());
        double unit = BEARS * (bound > 0 ? bound : strongest);
        return unit > 0 ? Math.min(f - least(), greatest() - f) / unit : Double.POSITIVE_INFINITY;
    }

    /** The value that the row keeps at 0 when it is on; 0 if it keeps a speed only. */
    abstract double gap(double q);

    /** How far that may be from 0 when the row begins to be on. */
    double leeway() {
        return 0;
    }

    /**
     * Decides whether the row is on from now on.
     *
     * @param q the coordinate
     * @param speed its rate
     * @param time the engine's step
     * @return the speed that it must have at once, or NaN if it may have any
     */
    abstract double decide(double q, double speed, double time);

    /** Whether it is to be decided again: an impact on other stops has driven a stop against its own, or a motor past its speed. */
    boolean isStruck(double q, double speed, double time) {
        return false;
    }

    /** The least and the greatest force that the row can have when it is on. */
    abstract double least();

    abstract double greatest();

    /**
     * A value that turns negative when the row must be decided anew, in units of what counts as reached; the row is off.
     */
    abstract double watch(double q, double speed);

    /**
     * How fast that changes.
     *
     * @param q the coordinate
     * @param speed its rate
     * @param change how fast that changes; NaN if nobody knows
     * @return NaN if that is not known then
     */
    abstract double slope(double q, double speed, double change);

    /** The time until that is 0 at the speed of now; infinite if it never is, NaN if it cannot be said. */
    abstract double toGo(double q, double speed);

    /** Turns the row on if its coordinate is where it may be held. */
    abstract void hold(double q);

    /** The speed that the row keeps when it is on. */
    abstract double target();

    @Override
    public String toString() {
        return getClass().getSimpleName() + "(" + coordinate + ")";
    }
}
