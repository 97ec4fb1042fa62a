// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.motion.Body;

/** Takes the equations of a {@link Constraint}: C, the blocks of J for its two bodies, and J̇ ẋ. */
public final class Equations implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Rows at most. */
    static final int ROWS = 3;

    /** Beyond this the squares of squares of lengths and speeds are no numbers. */
    private static final double HUGE = 1e75;

    final double[] c = new double[ROWS];
    final double[] rate = new double[ROWS];
    final double[] jA = new double[3 * ROWS];
    final double[] jB = new double[3 * ROWS];

    /** Creates equations that hold nothing. */
    public Equations() {
        // filled by a constraint
    }

    void clear() {
        clear(ROWS);
    }

    /** Clears so many rows: to fill arrays that are so short costs more than to write them. */
    void clear(int rows) {
        for (int r = 0; r < rows; r++) {
            set(r, 0, 0);
            setA(r, 0, 0, 0);
            setB(r, 0, 0, 0);
        }
    }

    /** Refuses what is no number from an author's constraint or curve; not where its bodies have been thrown beyond all measure. */
    void check(Constraint constraint, int rows) {
        Constraint tie = constraint instanceof Switched s ? s.coordinate() : constraint;
        if (tie instanceof Joint && !(tie instanceof WireJoint)) {
            return;
        }
        boolean isSecond = tie.getBodyB() != null;
        for (int r = 0; r < rows; r++) {
            double zero = 0 * c[r] + 0 * rate[r]; // NaN if any is not finite
            for (int k = 3 * r; k < 3 * r + 3; k++) {
                zero += 0 * jA[k] + (isSecond ? 0 * jB[k] : 0);
            }
            if (zero != 0 && isMeasured(tie.getBodyA()) && (!isSecond || isMeasured(tie.getBodyB()))) {
                throw new IllegalArgumentException("constraint is " + tie + ": its row " + r + " must be finite, but C is " + c[r] + ", J is "
                        + Arrays.toString(Arrays.copyOfRange(jA, 3 * r, 3 * r + 3)) + ", "
                        + Arrays.toString(Arrays.copyOfRange(jB, 3 * r, 3 * r + 3)) + ", and its part of the second derivative " + rate[r]);
            }
        }
    }

    private static boolean isMeasured(Body body) {
        double most = Math.max(Math.abs(body.getX()), Math.max(Math.abs(body.getY()), Math.abs(body.getAngle())));
        double fastest = Math.max(Math.abs(body.getVelocityX()), Math.max(Math.abs(body.getVelocityY()), Math.abs(body.getAngularVelocity())));
        return Math.max(most, fastest) < HUGE; // not NaN
    }

    /** How fast the C of the first row changes; the second body may be null. */
    double speed(Body a, Body b) {
        return speed(jA, a) + (b == null ? 0 : speed(jB, b));
    }

    private static double speed(double[] row, Body body) {
        return row[0] * body.getVelocityX() + row[1] * body.getVelocityY() + row[2] * body.getAngularVelocity();
    }

    /**
     * Sets the value of an equation, and the part of its second derivative that comes from the bodies' motion alone.
     *
     * @param row number of the row: 0, 1, 2
     * @param value C, which is to be 0
     * @param curvature the row of J̇ ẋ
     */
    public void set(int row, double value, double curvature) {
        c[row] = value;
        rate[row] = curvature;
    }

    /**
     * Sets the row of J for the first body.
     *
     * @param row number of the row: 0, 1, 2
     * @param x ∂C/∂x
     * @param y ∂C/∂y
     * @param theta ∂C/∂θ
     */
    public void setA(int row, double x, double y, double theta) {
        jA[3 * row] = x;
        jA[3 * row + 1] = y;
        jA[3 * row + 2] = theta;
    }

    /**
     * Sets the row of J for the second body. This has no effect if that is the world.
     *
     * @param row number of the row: 0, 1, 2
     * @param x ∂C/∂x
     * @param y ∂C/∂y
     * @param theta ∂C/∂θ
     */
    public void setB(int row, double x, double y, double theta) {
        jB[3 * row] = x;
        jB[3 * row + 1] = y;
        jB[3 * row + 2] = theta;
    }

    /**
     * Returns the value of an equation.
     *
     * @param row number of the row: 0, 1, 2
     * @return C
     */
    public double value(int row) {
        return c[row];
    }

    /**
     * Returns a row of J̇ ẋ.
     *
     * @param row number of the row: 0, 1, 2
     * @return its value
     */
    public double curvature(int row) {
        return rate[row];
    }

    /**
     * Returns an entry of J.
     *
     * @param row number of the row: 0, 1, 2
     * @param column 0, 1, 2 for x, y, θ of the first body, 3, 4, 5 of the second one
     * @return its value
     */
    public double jacobian(int row, int column) {
        return column < 3 ? jA[3 * row + column] : jB[3 * row + column - 3];
    }
}
