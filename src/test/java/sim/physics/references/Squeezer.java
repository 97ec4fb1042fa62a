// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import org.hipparchus.ode.OrdinaryDifferentialEquation;

/**
 * Andrews' squeezing mechanism, with the data of the IVP test set: seven bodies, a spring and a drive torque. Newton's
 * equations of the bodies in (x, y, θ) and the ten pins with multipliers, as one dense system; over the 0.03 s of the
 * problem the pins open by rounding only.
 */
public final class Squeezer implements OrdinaryDifferentialEquation {
    /** Masses of K1 … K7. */
    public static final double[] MASS = {.04325, .00365, .02373, .00706, .07050, .00706, .05498};

    /** Moments of inertia of K1 … K7. */
    public static final double[] INERTIA = {2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5};

    /** The drive torque on K1. */
    public static final double TORQUE = 0.033;

    /** The spring: its stiffness, its length without force, and its fixed end. */
    public static final double[] SPRING = {4530, 0.07785, 0.014, 0.072};

    static final double XA = -.06934;
    static final double YA = -.00227;
    static final double XB = -.03635;
    static final double YB = .03273;
    static final double RR = .007;
    static final double D = .028;
    static final double E = .02;
    static final double ZF = .02;
    static final double ZT = .04;
    static final double U = .04;
    static final double SS = .035;

    /** Angles of K1 … K7 at the start, from which the coordinates of the problem follow. */
    static final double BETA = -0.0617138900142764496358948458001;

    private static final double GAMMA = 0.455279819163070380255912382449;
    private static final double PHI = 0.222668390165885884674473185609;
    private static final double DELTA = 0.487364979543842550225598953530;
    private static final double EPSILON = 1.23054744454982119249735015568;

    /** Centres of mass at the start: x, y, angle for each body; the angle is the one that turns with the body. */
    private final double[] start = new double[42];

    /** Pins: body, body or −1, world point at the start. */
    private final double[][] pins;

    private final double[][] arms;

    /** The mechanism at its start. */
    public Squeezer() {
        double px = RR * cos(BETA);
        double py = RR * sin(BETA);
        // all but K1 hang together at the point where K2 ends
        double qx = px - D * cos(BETA);
        double qy = py - D * sin(BETA);
        double a4 = PHI + DELTA;
        double a6 = -PHI + EPSILON;
        place(0, .00092 * cos(BETA), .00092 * sin(BETA));
        place(1, px - .0115 * cos(BETA), py - .0115 * sin(BETA));
        place(2, XB + .01874 * sin(GAMMA) + .01043 * cos(GAMMA), YB - .01874 * cos(GAMMA) + .01043 * sin(GAMMA));
        place(3, XA + ZT * cos(DELTA) + (E - .01421) * sin(a4), YA + ZT * sin(DELTA) - (E - .01421) * cos(a4));
        place(4, XA + .02308 * cos(DELTA) - .00916 * sin(DELTA), YA + .02308 * sin(DELTA) + .00916 * cos(DELTA));
        place(5, XA + U * sin(EPSILON) + (ZF - .01421) * cos(a6), YA - U * cos(EPSILON) + (ZF - .01421) * sin(a6));
        place(6, XA + .01228 * sin(EPSILON) - .00449 * cos(EPSILON), YA - .01228 * cos(EPSILON) - .00449 * sin(EPSILON));
        pins = new double[][] {
            {0, -1, 0, 0},
            {0, 1, px, py},
            {2, -1, XB, YB},
            {4, -1, XA, YA},
            {6, -1, XA, YA},
            {4, 3, XA + ZT * cos(DELTA), YA + ZT * sin(DELTA)},
            {6, 5, XA + U * sin(EPSILON), YA - U * cos(EPSILON)},
            {1, 2, qx, qy},
            {1, 3, qx, qy},
            {1, 5, qx, qy}
        };
        arms = new double[pins.length][4];
        for (int k = 0; k < pins.length; k++) {
            for (int side = 0; side < 2; side++) {
                int body = (int) pins[k][side];
                arms[k][2 * side] = pins[k][2] - (body < 0 ? 0 : start[3 * body]);
                arms[k][2 * side + 1] = pins[k][3] - (body < 0 ? 0 : start[3 * body + 1]);
            }
        }
    }

    private static double cos(double angle) {
        return StrictMath.cos(angle);
    }

    private static double sin(double angle) {
        return StrictMath.sin(angle);
    }

    private void place(int body, double x, double y) {
        start[3 * body] = x;
        start[3 * body + 1] = y;
    }

    /**
     * The pins.
     *
     * @return for each the two bodies, the second −1 for the world, and the point at the start
     */
    public double[][] pins() {
        return pins;
    }

    /**
     * Where a body is at the start; it has not turned then.
     *
     * @param body 0 … 6
     * @return x, y
     */
    public double[] centre(int body) {
        return new double[] {start[3 * body], start[3 * body + 1]};
    }

    /**
     * Where the spring pulls K3, at the start.
     *
     * @return x, y in the world
     */
    public double[] springEnd() {
        return new double[] {
            .02 * cos(GAMMA) + .018 * sin(GAMMA) + XB, .02 * sin(GAMMA) - .018 * cos(GAMMA) + YB
        };
    }

    @Override
    public int getDimension() {
        return 42;
    }

    @Override
    public double[] computeDerivatives(double t, double[] y) {
        int rows = 21 + 2 * pins.length;
        double[][] m = new double[rows][rows + 1];
        for (int body = 0; body < 7; body++) {
            m[3 * body][3 * body] = MASS[body];
            m[3 * body + 1][3 * body + 1] = MASS[body];
            m[3 * body + 2][3 * body + 2] = INERTIA[body];
        }
        m[2][rows] = TORQUE;
        spring(y, m);
        for (int k = 0; k < pins.length; k++) {
            for (int side = 0; side < 2; side++) {
                int body = (int) pins[k][side];
                if (body >= 0) {
                    pin(y, m, 21 + 2 * k, body, arms[k][2 * side], arms[k][2 * side + 1], side == 0 ? 1 : -1);
                }
            }
        }
        RodChain.solve(m);
        double[] rates = new double[42];
        System.arraycopy(y, 21, rates, 0, 21);
        for (int k = 0; k < 21; k++) {
            rates[21 + k] = m[k][rows];
        }
        return rates;
    }

    private static void pin(double[] y, double[][] m, int row, int body, double ax, double ay, double sign) {
        double c = Math.cos(y[3 * body + 2]);
        double s = Math.sin(y[3 * body + 2]);
        double rx = c * ax - s * ay;
        double ry = s * ax + c * ay;
        double omega = y[21 + 3 * body + 2];
        double[][] jacobian = {{sign, 0, -sign * ry}, {0, sign, sign * rx}};
        for (int r = 0; r < 2; r++) {
            for (int k = 0; k < 3; k++) {
                m[row + r][3 * body + k] = jacobian[r][k];
                m[3 * body + k][row + r] = jacobian[r][k];
            }
            m[row + r][m.length] += sign * omega * omega * (r == 0 ? rx : ry);
        }
    }

    private void spring(double[] y, double[][] m) {
        double[] end = springEnd();
        double c = Math.cos(y[8]);
        double s = Math.sin(y[8]);
        double rx = c * (end[0] - start[6]) - s * (end[1] - start[7]);
        double ry = s * (end[0] - start[6]) + c * (end[1] - start[7]);
        double dx = y[6] + rx - SPRING[2];
        double dy = y[7] + ry - SPRING[3];
        double length = Math.sqrt(dx * dx + dy * dy);
        double f = -SPRING[0] * (length - SPRING[1]) / length;
        m[6][m.length] = f * dx;
        m[7][m.length] = f * dy;
        m[8][m.length] = f * (rx * dy - ry * dx);
    }

    /**
     * The state.
     *
     * @param t times, ascending
     * @param gragg whether by Gragg, Bulirsch and Stoer, else by Dormand and Prince 8(5,3)
     * @param tolerance of the integrator
     * @return for each time x, y and the angle turned of each body, then their rates
     */
    public double[][] states(double[] t, boolean gragg, double tolerance) {
        return RodChain.integrate(this, start.clone(), t, gragg, tolerance);
    }

    /**
     * The angle β of the problem.
     *
     * @param state one of {@link #states}
     * @return angle of the crank
     */
    public static double beta(double[] state) {
        return BETA + state[2];
    }
}
