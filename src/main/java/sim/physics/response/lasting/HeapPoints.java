// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;

/** What is known of each point of a {@link HeapSystem}: its bounds, mobilities and impulses. */
abstract class HeapPoints implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values per point. */
    static final int STRIDE = 13;

    static final int BOUND = 0;
    static final int FRICTION = 1;
    static final int MOBILITY_N = 2;
    static final int MOBILITY_T = 3;
    static final int IMPULSE_N = 4;
    static final int IMPULSE_T = 5;

    /** What a unit of impulse along the tangent does to the velocity along the normal. */
    static final int CROSS = 6;

    /** The least and the greatest impulse along the normal: 0 and infinite but for motors. */
    static final int LEAST = 7;

    static final int MOST = 8;

    /** What is added to the velocity along the tangent. */
    static final int DRIFT = 9;

    /** What turning adds to the velocities along the normal and the tangent at the end of the time. */
    static final int TURN_N = 10;

    static final int TURN_T = 11;

    /** Velocity of the surfaces on one another along the tangent, beside that of the bodies. */
    static final int BELT = 12;

    double[] data = new double[8 * STRIDE];

    /** Whether a point is a motor: its bound is a speed that it is to have, and its impulse may have either sign. */
    boolean isMotor(int p) {
        return data[STRIDE * p + MOST] < Double.POSITIVE_INFINITY;
    }

    /** Lets a motor give impulses up to a bound, either way. */
    void setMost(int p, double impulse) {
        data[STRIDE * p + LEAST] = -impulse;
        data[STRIDE * p + MOST] = impulse;
    }

    double leastImpulse(int p) {
        return data[STRIDE * p + LEAST];
    }

    double mostImpulse(int p) {
        return data[STRIDE * p + MOST];
    }

    /** Sets the least normal velocity of a point. */
    void bound(int p, double least) {
        data[STRIDE * p + BOUND] = least;
    }

    /** Sets what turning takes of the way along a point's tangent, as a speed that its velocity is to make up for. */
    void drift(int p, double speed) {
        data[STRIDE * p + DRIFT] = speed;
    }

    double bound(int p) {
        return data[STRIDE * p + BOUND];
    }

    /** Starts from impulses that are known nearly. */
    void start(int p, double normal, double tangential) {
        data[STRIDE * p + IMPULSE_N] = normal;
        data[STRIDE * p + IMPULSE_T] = tangential;
    }

    double normalImpulse(int p) {
        return data[STRIDE * p + IMPULSE_N];
    }

    double tangentImpulse(int p) {
        return data[STRIDE * p + IMPULSE_T];
    }

    /** Whether a point's normal row is an equation now, and its tangential one. */
    boolean isClosed(int p) {
        double impulse = data[STRIDE * p + IMPULSE_N];
        boolean isBetween = impulse > data[STRIDE * p + LEAST] && impulse < data[STRIDE * p + MOST];
        return isBetween && data[STRIDE * p + MOBILITY_N] < Double.POSITIVE_INFINITY;
    }

    boolean isStuck(int p) {
        double most = data[STRIDE * p + FRICTION] * data[STRIDE * p + IMPULSE_N];
        return Math.abs(data[STRIDE * p + IMPULSE_T]) < most;
    }

    /** Velocity of a point's surfaces on one another, beside that of the bodies. */
    double belt(int p) {
        return data[STRIDE * p + BELT];
    }

    double friction(int p) {
        return data[STRIDE * p + FRICTION];
    }

    double normalMobility(int p) {
        return data[STRIDE * p + MOBILITY_N];
    }

    double tangentMobility(int p) {
        return data[STRIDE * p + MOBILITY_T];
    }

    /** Adds to a point's impulses, but not to the velocities. */
    void addImpulse(int p, double jn, double jt) {
        data[STRIDE * p + IMPULSE_N] += jn;
        data[STRIDE * p + IMPULSE_T] += jt;
    }

    /** Sets what turning adds to a point's velocities along its normal and its tangent. */
    void turn(int p, double normal, double tangential) {
        data[STRIDE * p + TURN_N] = normal;
        data[STRIDE * p + TURN_T] = tangential;
    }
}
