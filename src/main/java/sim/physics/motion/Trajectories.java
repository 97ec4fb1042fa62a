// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;

/**
 * Where every body is at any instant of the present step: the dense output of the equations of motion.
 *
 * <p>Each body follows polynomials of time from its <i>anchor</i>, the instant of its last event:
 *
 * <pre>
 *   x(d) = x0 + d (vx + d (ax + d jx)),   and y and θ likewise,   d = time since the anchor
 * </pre>
 *
 * <p>(1)–(4) for a time of any length: the series (9) and (10), which end here. ax is <i>half</i> the acceleration and
 * jx a sixth of its rate. A free body under a constant force needs no integrator: its polynomials (parabola and constant
 * spin) hold until its next event, exactly and for any number of steps, so that nothing adds up along the way. A body
 * that an integrator drives gets new polynomials in every step and is marked {@link #DRIVEN}.
 *
 * <p>Instants are offsets τ from the start of the present step, 0 … h. The anchor is kept as (step number, offset), so
 * that the clock does not drift and no precision is lost in long runs.
 *
 * <p>The values lie in two arrays, a cache line per body in each:
 *
 * <pre>
 *   0  1  2   3  4  5  6     7          0  1  2   3  4  5   6
 *   x0 y0 θ0  vx vy ω  step  offset     ax ay aθ  jx jy jθ  driven
 * </pre>
 *
 * <p>Where no body has ever been accelerated, which is where none is driven either, the second array, the <i>bends</i>, is one
 * line of zeros for all: a value is at {@code bends()[(o & bendMask()) + AX]}, o the place of the body's first line.
 */
public final class Trajectories implements Serializable {
    private static final long serialVersionUID = 2L;

    /** Values per body. */
    public static final int STRIDE = 8;
    /** Position at the anchor. */
    public static final int X0 = 0;
    /** Position at the anchor. */
    public static final int Y0 = 1;
    /** Orientation at the anchor. */
    public static final int THETA0 = 2;
    /** Velocity at the anchor. */
    public static final int VX = 3;
    /** Velocity at the anchor. */
    public static final int VY = 4;
    /** Angular velocity at the anchor. */
    public static final int OMEGA = 5;
    /** Number of the step of the anchor. */
    public static final int STEP = 6;
    /** Offset of the anchor in its step. */
    public static final int OFFSET = 7;
    /** Among the bends: half the acceleration at the anchor. */
    public static final int AX = 0;
    /** Among the bends: half the acceleration at the anchor. */
    public static final int AY = 1;
    /** Among the bends: half the angular acceleration at the anchor. */
    public static final int ATHETA = 2;
    /** Among the bends: a sixth of the third derivative. */
    public static final int JX = 3;
    /** Among the bends: a sixth of the third derivative. */
    public static final int JY = 4;
    /** Among the bends: a sixth of the third derivative. */
    public static final int JTHETA = 5;
    /** Among the bends: 1 if the polynomials hold for the present step only, else 0. */
    public static final int DRIVEN = 6;

    private double[] data = {};
    private double[] bends = new double[STRIDE];

    /** −1 where bodies have bends of their own, else 0. */
    private int bendMask;

    /** Bounding radii of the bodies' shapes. */
    private double[] radii = {};

    private double step;
    private double h;

    /** Makes trajectories for no body. */
    public Trajectories() {
        // the arrays grow with the bodies
    }

    /**
     * The values of the first lines themselves, {@link #STRIDE} per body.
     *
     * @return the live array
     */
    public double[] data() {
        return data;
    }

    /**
     * The bends: accelerations and third derivatives.
     *
     * @return the live array, of one line of zeros if no body has ever had any
     */
    public double[] bends() {
        return bends;
    }

    /**
     * What the place of a body's first line is to be masked with among the bends.
     *
     * @return −1, or 0 if no body has ever had bends
     */
    public int bendMask() {
        return bendMask;
    }

    /**
     * Whether all bodies have always moved and spun uniformly, so that nobody need look at the bends.
     *
     * @return true if no body has ever been accelerated or driven
     */
    public boolean areStraight() {
        return bendMask == 0;
    }

    /** Gives each body bends of its own. */
    double[] unfold() {
        if (bendMask == 0) {
            bends = new double[data.length];
            bendMask = -1;
        }
        return bends;
    }

    /**
     * Number of the present step.
     *
     * @return 0, 1, … as a double, for kernels
     */
    public double step() {
        return step;
    }

    /**
     * Length of the present step.
     *
     * @return h, time
     */
    public double h() {
        return h;
    }

    /**
     * Begins a step.
     *
     * @param number its number
     * @param length its length h, time; anchors of earlier steps must have been made with the same length
     */
    public void begin(long number, double length) {
        step = number;
        h = length;
    }

    /**
     * Makes room for bodies.
     *
     * @param count number of blocks
     */
    public void ensure(int count) {
        if (data.length < count * STRIDE) {
            data = Arrays.copyOf(data, STRIDE * Growth.length(data.length / STRIDE, count));
            bends = bendMask == 0 ? bends : Arrays.copyOf(bends, data.length);
            radii = Arrays.copyOf(radii, data.length / STRIDE);
        }
    }

    /**
     * The offset of a body's anchor in its step.
     *
     * @param body index
     * @return τ
     */
    public double offset(int body) {
        return data[body * STRIDE + OFFSET];
    }

    /**
     * Since when a body is on its present course in this step.
     *
     * @param body index
     * @return τ of its anchor; 0 if that is of an earlier step
     */
    public double since(int body) {
        return data[body * STRIDE + STEP] == step ? data[body * STRIDE + OFFSET] : 0;
    }

    /**
     * Time from a body's anchor to an instant.
     *
     * @param body index
     * @param tau offset in the present step
     * @return d, time
     */
    public double duration(int body, double tau) {
        int o = body * STRIDE;
        return (step - data[o + STEP]) * h + (tau - data[o + OFFSET]);
    }

    /**
     * Anchors a body at an instant with the position and velocity of its block in the state vectors, and without
     * acceleration.
     *
     * @param body index
     * @param tau offset in the present step
     * @param state the vectors
     */
    public void anchor(int body, double tau, State state) {
        int o = body * STRIDE;
        int b = body * State.BLOCK;
        double[] k = bends;
        double[] m = data; // copied one by one: a call for three values takes longer
        double[] x = state.x();
        double[] v = state.v();
        m[o] = x[b];
        m[o + 1] = x[b + 1];
        m[o + 2] = x[b + 2];
        m[o + VX] = v[b];
        m[o + VY] = v[b + 1];
        m[o + OMEGA] = v[b + 2];
        k[(o & bendMask) + AX] = 0;
        k[(o & bendMask) + AY] = 0;
        k[(o & bendMask) + ATHETA] = 0;
        k[(o & bendMask) + JX] = 0;
        k[(o & bendMask) + JY] = 0;
        k[(o & bendMask) + JTHETA] = 0;
        m[o + STEP] = step;
        m[o + OFFSET] = tau;
    }

    /**
     * Moves a body's anchor along its trajectory to an instant; the path stays the same.
     *
     * @param body index
     * @param tau offset in the present step
     */
    public void bring(int body, double tau) {
        int o = body * STRIDE;
        double[] m = data;
        double[] k = bends;
        double d = (step - m[o + STEP]) * h + (tau - m[o + OFFSET]);
        if (bendMask == 0) {
            bringStraight(o, d);
        } else if (d != 0) {
            for (int c = 0; c < State.BLOCK; c++) {
                double v = m[o + VX + c];
                double a = k[(o & bendMask) + AX + c];
                double j = k[(o & bendMask) + JX + c];
                m[o + c] += d * (v + d * (a + d * j));
                m[o + VX + c] = v + d * (2 * a + 3 * d * j);
                k[(o & bendMask) + AX + c] = a + 3 * d * j;
            }
        }
        m[o + STEP] = step;
        m[o + OFFSET] = tau;
    }

    /** The same with zeros for the bends, of which one term is left: it makes a negative zero positive. */
    private void bringStraight(int o, double d) {
        if (d != 0) {
            double[] m = data;
            double zero = d * 0.0;
            double vx = m[o + VX] + zero;
            double vy = m[o + VY] + zero;
            double omega = m[o + OMEGA] + zero;
            m[o] += d * vx;
            m[o + 1] += d * vy;
            m[o + 2] += d * omega;
            m[o + VX] = vx;
            m[o + VY] = vy;
            m[o + OMEGA] = omega;
        }
    }

    /**
     * Sets the constant accelerations of a body from its anchor on.
     *
     * @param body index, brought to the present instant before
     * @param ax length/time²
     * @param ay length/time²
     * @param alpha rad/time²
     */
    public void accelerate(int body, double ax, double ay, double alpha) {
        int o = body * STRIDE;
        if (ax != 0 || ay != 0 || alpha != 0) {
            unfold();
        } else if (bendMask == 0) {
            return;
        }
        bends[(o & bendMask) + AX] = 0.5 * ax;
        bends[(o & bendMask) + AY] = 0.5 * ay;
        bends[(o & bendMask) + ATHETA] = 0.5 * alpha;
        bends[(o & bendMask) + JX] = 0;
        bends[(o & bendMask) + JY] = 0;
        bends[(o & bendMask) + JTHETA] = 0;
    }

    /**
     * Whether a body follows a parabola and spins uniformly.
     *
     * @param body index
     * @return false if its spin or its acceleration changes
     */
    public boolean isParabola(int body) {
        int o = body * STRIDE & bendMask;
        return bends[o + ATHETA] == 0 && bends[o + JX] == 0 && bends[o + JY] == 0 && bends[o + JTHETA] == 0;
    }

    /**
     * Whether a body stays where it is on its present course.
     *
     * @param body index
     * @return true if it has neither velocity nor acceleration
     */
    public boolean stands(int body) {
        int o = body * STRIDE & bendMask;
        return !isMoving(body) && isParabola(body) && bends[o + AX] == 0 && bends[o + AY] == 0;
    }

    /** Whether a body has a velocity at its anchor. */
    boolean isMoving(int body) {
        int o = body * STRIDE;
        return data[o + VX] != 0 || data[o + VY] != 0 || data[o + OMEGA] != 0;
    }

    /**
     * Marks whether a body's polynomials hold for the present step only.
     *
     * @param body index
     * @param driven true if an integrator makes new ones in the next step
     */
    void setDriven(int body, boolean driven) {
        if (driven) {
            unfold();
        }
        bends[(body * STRIDE & bendMask) + DRIVEN] = driven ? 1 : 0;
    }

    /**
     * Whether a body's polynomials hold for the present step only.
     *
     * @param body index
     * @return true if an integrator drives it
     */
    public boolean isDriven(int body) {
        return bendMask != 0 && bends[(body * STRIDE & bendMask) + DRIVEN] != 0;
    }

    /**
     * Sets the bounding radius of a body's shape.
     *
     * @param body index
     * @param radius length
     */
    public void setRadius(int body, double radius) {
        radii[body] = radius;
    }

    /**
     * The bounding radius of a body's shape.
     *
     * @param body index
     * @return length
     */
    public double radius(int body) {
        return radii[body];
    }

    /**
     * Writes positions and velocities of the bodies that are not driven, at an instant, into the state vectors.
     *
     * @param tau offset in the present step
     * @param state the vectors
     */
    public void publish(double tau, State state) {
        if (bendMask == 0) {
            publishStraight(tau, state);
            return;
        }
        double[] x = state.x();
        double[] v = state.v();
        double[] m = data;
        double[] k = bends;
        int n = state.size();
        for (int i = 0, o = 0, b = 0; i < n; i++, o += STRIDE, b += State.BLOCK) {
            if (k[(o & bendMask) + DRIVEN] != 0) {
                continue;
            }
            double d = (step - m[o + STEP]) * h + (tau - m[o + OFFSET]);
            x[b] = m[o] + d * (m[o + VX] + d * (k[(o & bendMask) + AX] + d * k[(o & bendMask) + JX]));
            x[b + 1] = m[o + 1] + d * (m[o + VY] + d * (k[(o & bendMask) + AY] + d * k[(o & bendMask) + JY]));
            x[b + 2] = m[o + 2] + d * (m[o + OMEGA] + d * (k[(o & bendMask) + ATHETA] + d * k[(o & bendMask) + JTHETA]));
            v[b] = m[o + VX] + d * (2 * k[(o & bendMask) + AX] + 3 * d * k[(o & bendMask) + JX]);
            v[b + 1] = m[o + VY] + d * (2 * k[(o & bendMask) + AY] + 3 * d * k[(o & bendMask) + JY]);
            v[b + 2] = m[o + OMEGA] + d * (2 * k[(o & bendMask) + ATHETA] + 3 * d * k[(o & bendMask) + JTHETA]);
        }
    }

    private void publishStraight(double tau, State state) {
        double[] x = state.x();
        double[] v = state.v();
        double[] m = data;
        double now = step;
        double length = h;
        int n = state.size();
        for (int i = 0; i < n; i++) {
            int o = STRIDE * i;
            int b = State.BLOCK * i;
            double d = (now - m[o + STEP]) * length + (tau - m[o + OFFSET]);
            double zero = d * 0.0;
            double vx = m[o + VX] + zero;
            double vy = m[o + VY] + zero;
            double omega = m[o + OMEGA] + zero;
            double px = m[o] + d * vx;
            double py = m[o + 1] + d * vy;
            double theta = m[o + 2] + d * omega;
            x[b] = px;
            x[b + 1] = py;
            x[b + 2] = theta;
            v[b] = vx;
            v[b + 1] = vy;
            v[b + 2] = omega;
        }
    }

    /**
     * Whether a body is where the state vectors have it.
     *
     * @param body index
     * @param tau offset in the present step
     * @param state the vectors
     * @param near by how much of its size, or in rad, it may be elsewhere
     * @return true if it is
     */
    public boolean isAt(int body, double tau, State state, double near) {
        int o = body * STRIDE;
        double d = duration(body, tau);
        boolean same = true;
        for (int c = 0; c < State.BLOCK; c++) {
            double bend = bends[(o & bendMask) + AX + c] + d * bends[(o & bendMask) + JX + c];
            double x = data[o + c] + d * (data[o + VX + c] + d * bend);
            same &= Math.abs(x - state.x()[State.BLOCK * body + c]) <= (c < State.THETA ? near * radii[body] : near);
        }
        return same;
    }

    /**
     * Whether a body moves as the state vectors have it.
     *
     * @param body index
     * @param tau offset in the present step
     * @param state the vectors
     * @return true if the velocities are the same
     */
    public boolean movesAs(int body, double tau, State state) {
        int o = body * STRIDE;
        double d = duration(body, tau);
        boolean same = true;
        for (int c = 0; c < State.BLOCK; c++) {
            double a = bends[(o & bendMask) + AX + c];
            double j = bends[(o & bendMask) + JX + c];
            same &= data[o + VX + c] + d * (2 * a + 3 * d * j) == state.v()[State.BLOCK * body + c];
        }
        return same;
    }

    /**
     * Writes one body's position and velocity at an instant into the state vectors.
     *
     * @param body index
     * @param tau offset in the present step
     * @param state the vectors
     */
    public void publish(int body, double tau, State state) {
        int b = body * State.BLOCK;
        double d = duration(body, tau);
        for (int c = 0; c < State.BLOCK; c++) {
            state.x()[b + c] = x(body, c, d);
            state.v()[b + c] = v(body, c, d);
        }
    }

    double x(int body, int c, double d) {
        int o = body * STRIDE;
        return data[o + c] + d * (data[o + VX + c] + d * (bends[(o & bendMask) + AX + c] + d * bends[(o & bendMask) + JX + c]));
    }

    double v(int body, int c, double d) {
        int o = body * STRIDE;
        return data[o + VX + c] + d * (2 * bends[(o & bendMask) + AX + c] + 3 * d * bends[(o & bendMask) + JX + c]);
    }
}
