// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.util.Arrays;
import sim.physics.internal.Check;
import sim.physics.shape.Shape;

/**
 * A body that moves as its author says, and as nothing else does: a platform, a lift, a gate, a piston, a turning drum, an arm that
 * sweeps things away. It pushes and carries what it touches, and drags what is tied to it. No force, impact or joint changes its
 * course, so its mass is infinite, and its energy counts as 0.
 *
 * <p>There are two ways to say how it moves:
 *
 * <ul>
 *   <li>{@link #setVelocity} is a velocity from now on. What lies on the body is struck by the jump.
 *   <li>{@link #setTargetVelocity} is the velocity at the end of the next step, and from then on. It is reached evenly, so what
 *       lies on the body is carried along.
 * </ul>
 *
 * <p>Two kinematic bodies, or a kinematic and a fixed one, do not collide, and cannot be joined. What is wedged between two such bodies
 * cannot get out of the way, and overlaps them.
 *
 * <p>The engine moves it as a body that is 2⁴⁰ times as heavy as the heaviest one, or 2³⁰ times by time stepping: an impact changes its
 * velocity by some 10⁻¹² or 10⁻⁹ of that of the other body, until the next step begins. One that stands is a fixed body.
 */
public class KinematicBody extends Body {
    private static final long serialVersionUID = 1L;

    /** How far it may be off its course, relative to where it is and to its size, for rounding. */
    private static final double ROUNDING = 1e-12;

    /** How much of what it has missed of its course it makes up for in a step. */
    private static final double CATCH_UP = 0.5;

    /** By how much velocities may differ that are those of one body, relative to them, and to what it is that turns. */
    private static final double ALIKE = 1e-12;

    private static final double TURNED_ALIKE = 1e-4;

    /** Velocities at the end of the next step. */
    private final double[] target = new double[State.BLOCK];

    /** Where it will be at the end of the step by its velocities; only if it has a course, as nobody has put it elsewhere since. */
    private final double[] course = new double[State.BLOCK];

    private boolean hasCourse;

    /** Velocities that it was to have at the end of the last step. */
    private final double[] pace = new double[State.BLOCK];

    /** The same, and where it was, when the step began that may begin again. */
    private final double[] lastPlace = new double[State.BLOCK];

    private final double[] lastCourse = new double[State.BLOCK];
    private final double[] lastPace = new double[State.BLOCK];
    private boolean hadCourse;

    /** Velocities that it was to have when the step began. */
    private final double[] asked = new double[State.BLOCK];

    /** Velocities at both ends of the step. */
    private final double[] before = new double[State.BLOCK];

    private final double[] after = new double[State.BLOCK];

    /** Accelerations in the step. */
    private final double[] rate = new double[State.BLOCK];

    /** With which masses it is moved. */
    private double heavy;

    private double heavyInertia;

    /**
     * Creates a body at rest at the origin.
     *
     * @param shape shape of the body
     */
    public KinematicBody(Shape shape) {
        super(shape);
        stiffen();
        state().group(); // it does not collide with all others
    }

    /**
     * Sets the velocity that the body has at the end of the next step, and keeps. In that step its acceleration is constant. If a
     * listener calls this within a step, it holds from the next step on.
     *
     * <p>If you set the rate ṗ(t + h) of a course p before each step, the body is within h² / 6 · max |p̈| of it, and does not drift away. What it
     * misses where something strikes it in the midst of a step, it makes up for in the next ones.
     *
     * @param vx x component of the velocity, length/time
     * @param vy y component of the velocity, length/time
     * @param omega angular velocity, rad/time
     * @throws IllegalArgumentException for NaN or more than 10¹⁵⁰
     */
    public final void setTargetVelocity(double vx, double vy, double omega) {
        Check.between("vx", vx, -FASTEST, FASTEST);
        Check.between("vy", vy, -FASTEST, FASTEST);
        Check.between("angular velocity", omega, -FASTEST, FASTEST);
        target[State.X] = vx;
        target[State.Y] = vy;
        target[State.THETA] = omega;
    }

    /**
     * Returns the x component of the velocity at the end of the next step.
     *
     * @return length/time
     */
    public final double getTargetVelocityX() {
        return target[State.X];
    }

    /**
     * Returns the y component of the velocity at the end of the next step.
     *
     * @return length/time
     */
    public final double getTargetVelocityY() {
        return target[State.Y];
    }

    /**
     * Returns the angular velocity at the end of the next step.
     *
     * @return rad/time
     */
    public final double getTargetAngularVelocity() {
        return target[State.THETA];
    }

    @Override
    final boolean hasSpeed(int c, double value) {
        return value == speed(c) || value == pace(c);
    }

    @Override
    final boolean goesOn(boolean isVelocity) {
        if (!isVelocity && state().isOpenWithin()) {
            return true; // where it is to be is known for the end of the step only
        }
        boolean goes = true;
        for (int k = 0; k < State.BLOCK; k++) {
            goes &= isVelocity ? target[k] == pace(k) : catchUp(k, state().x()[State.BLOCK * index() + k]) == 0;
        }
        return goes;
    }

    /** The velocity that it is to have now: what has struck it changes it until the next step begins. */
    private double pace(int c) {
        boolean isSteady = hasCourse && (asked[c] == pace[c] || !state().isOpenWithin());
        return isSteady ? pace[c] : speed(c);
    }

    @Override
    final void written(boolean isVelocity) {
        if (isVelocity) {
            System.arraycopy(state().v(), State.BLOCK * index(), target, 0, State.BLOCK);
        }
        hasCourse = false;
        if (isImmobile() && !isToStand()) {
            setImmobile(false, heavy, heavyInertia);
        }
    }

    /** Where the body is to go: to be {@linkplain #putBack put back}. */
    final double[] keep() {
        return new double[] {target[State.X], target[State.Y], target[State.THETA], hasCourse ? 1 : 0};
    }

    /** It goes on as it did, from where it has been put back. */
    final void putBack(double[] kept) {
        System.arraycopy(kept, 0, target, 0, State.BLOCK);
        hasCourse = kept[State.BLOCK] != 0;
    }

    /**
     * Begins a step: finds the accelerations by which it gets its target velocity in it, and where its velocities bring it.
     *
     * @param still way in a step, relative to its size, of a body that stands
     * @param isAgain whether it is the step that had begun last, which has failed
     */
    final void begin(double h, double still, boolean isAgain) {
        if (isAgain) {
            comeBack();
        }
        settle(h, still);
        System.arraycopy(state().x(), State.BLOCK * index(), lastPlace, 0, State.BLOCK);
        System.arraycopy(course, 0, lastCourse, 0, State.BLOCK);
        System.arraycopy(pace, 0, lastPace, 0, State.BLOCK);
        hadCourse = hasCourse;
        for (int k = 0, at = State.BLOCK * index(); k < State.BLOCK; k++, at++) {
            double x = state().x()[at];
            before[k] = state().v()[at];
            rate[k] = (target[k] + catchUp(k, x) / h - before[k]) / h;
            after[k] = before[k] + h * rate[k];
            asked[k] = hasCourse ? pace[k] : before[k];
            course[k] = (hasCourse ? course[k] : x) + 0.5 * h * (asked[k] + target[k]);
            pace[k] = target[k];
        }
        hasCourse = true;
    }

    /** Is on the course again that it was on when the step began that has failed; or goes on from where it is, if it has moved since. */
    private void comeBack() {
        boolean isThere = hasCourse;
        for (int k = 0, at = State.BLOCK * index(); k < State.BLOCK; k++, at++) {
            isThere &= state().x()[at] == lastPlace[k] && state().v()[at] == before[k];
        }
        System.arraycopy(lastCourse, 0, course, 0, State.BLOCK);
        System.arraycopy(lastPace, 0, pace, 0, State.BLOCK);
        hasCourse = isThere && hadCourse;
    }

    /** How much it makes up for in a step of what it has missed of its course, where something closed on it within the ones before. */
    private double catchUp(int k, double x) {
        double missed = missed(k, x);
        boolean isRounding = Math.abs(missed) <= ROUNDING * (size(k) + Math.abs(course[k]));
        return isRounding ? 0 : CATCH_UP * missed;
    }

    /** The acceleration in the step that has begun. */
    final double acceleration(int k) {
        return rate[k];
    }

    /** Lets nothing move the body as long as it is to stand, and does. */
    private void settle(double h, double still) {
        boolean stands = isToStand();
        for (int k = 0, at = State.BLOCK * index(); k < State.BLOCK && stands; k++, at++) {
            double off = Math.max(Math.abs(state().v()[at]) * h, Math.abs(missed(k, state().x()[at])));
            stands = off <= still * size(k);
        }
        if (stands != isImmobile()) {
            setImmobile(stands, heavy, heavyInertia);
            Arrays.fill(state().v(), State.BLOCK * index(), State.BLOCK * (index() + 1), 0); // but for rounding, it is
        }
    }

    private boolean isToStand() {
        return target[State.X] == 0 && target[State.Y] == 0 && target[State.THETA] == 0;
    }

    private double size(int k) {
        return k == State.THETA ? 1 : getShape().boundingRadius();
    }

    private double missed(int k, double x) {
        return hasCourse ? course[k] - x : 0;
    }

    /** Whether it is on a course that its author has not changed within the step. */
    final boolean hasCourse() {
        return hasCourse;
    }

    /** The fastest that its surface is to go in the step: what others push it by is no part of that. */
    final double fastest() {
        double spin = getShape().boundingRadius() * Math.max(Math.abs(asked[State.THETA]), Math.abs(pace[State.THETA]));
        return Math.max(speed(asked), speed(pace)) + spin;
    }

    private static double speed(double[] v) {
        return Math.abs(v[State.X]) + Math.abs(v[State.Y]);
    }

    /** Whether it turns in the step. */
    final boolean turns() {
        return before[State.THETA] != 0 || after[State.THETA] != 0 || asked[State.THETA] != 0 || pace[State.THETA] != 0;
    }

    /** Whether it and another one go as parts of one rigid body in the step, but for rounding; where they turn, to first order in the angle by which. */
    final boolean goesWith(KinematicBody other) {
        double[] x = state().x();
        int a = State.BLOCK * index();
        int b = State.BLOCK * other.index();
        return goAlike(asked, other.asked, x[b] - x[a], x[b + 1] - x[a + 1])
                && goAlike(pace, other.pace, other.course[0] - course[0], other.course[1] - course[1]);
    }

    /** Whether two velocities, the second one of what is at (dx, dy) from the first one, are those of one body. */
    private static boolean goAlike(double[] one, double[] other, double dx, double dy) {
        double spin = one[State.THETA];
        double round = Math.abs(spin) * (Math.abs(dx) + Math.abs(dy));
        double x = other[State.X] - one[State.X] + spin * dy;
        double y = other[State.Y] - one[State.Y] - spin * dx;
        double most = ALIKE * (speed(one) + speed(other)) + TURNED_ALIKE * round;
        return Math.abs(other[State.THETA] - spin) <= ALIKE * Math.abs(spin) && Math.abs(x) + Math.abs(y) <= most;
    }

    /** How far its velocity, as the state has it, is outside of what it is to be in the step. */
    final double deflection() {
        double most = 0;
        for (int k = 0, at = State.BLOCK * index(); k < State.BLOCK; k++, at++) {
            double v = state().v()[at];
            double off = Math.max(v - Math.max(before[k], after[k]), Math.min(before[k], after[k]) - v);
            most = Math.max(most, k == State.THETA ? off * getShape().boundingRadius() : off);
        }
        return most;
    }

    /** How much its velocity, as the state has it, differs from what it is to be when a part of the step is over. */
    final double deflection(double part) {
        double most = 0;
        for (int k = 0, at = State.BLOCK * index(); k < State.BLOCK; k++, at++) {
            double off = Math.abs(state().v()[at] - before[k] - part * (after[k] - before[k]));
            most = Math.max(most, k == State.THETA ? off * getShape().boundingRadius() : off);
        }
        return most;
    }

    /** Sets with which masses it is moved. */
    final void become(double mass, double inertia) {
        double[] w = state().w().values();
        int b = State.BLOCK * index();
        heavy = mass;
        heavyInertia = inertia;
        if (!isImmobile() && (w[b] != 1 / mass || w[b + State.THETA] != 1 / inertia)) {
            weigh(mass, inertia);
        }
    }
}
