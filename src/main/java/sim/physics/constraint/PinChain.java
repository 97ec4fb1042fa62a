// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Trig;
import sim.physics.motion.State;

/**
 * The equations A λ = b, (41), of an island whose pins form a chain: pin k holds body k to body k + 1, so A is block
 * tridiagonal. What does not move, and the nothing behind a free end, are bodies of no inverse mass.
 *
 * <p>All values lie in one array for each, by body, and every loop but that of the elimination treats each body by
 * itself: compilers make vector instructions of such loops. The chain is eliminated from both ends towards the middle,
 * which the processor does at the same time, because a link takes far longer from its first operation to its last than
 * their number asks for.
 */
final class PinChain implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Angles from the one whose cosine and sine are known, up to which the series below are right to rounding. */
    private static final double NEAR = 0.125;

    /** Known angles are multiples of 1/16 rad, so that the cosines do not depend on what was before. */
    private static final double GRAIN = 16;

    /** Number of pins; there is one body more. */
    final int pins;

    /** Blocks of the bodies in the state vectors, −1 for what does not move. */
    final int[] block;

    /** Inverse masses and moments of inertia. */
    final double[] mass;

    final double[] inertia;

    /** Positions, velocities, and solutions: what W Jᵀ λ adds to a body. */
    final double[] x;

    final double[] y;
    final double[] angle;
    final double[] u;
    final double[] v;
    final double[] omega;
    final double[] dx;
    final double[] dy;
    final double[] turn;

    /** What a body adds to C, or to a derivative of it, of its next pin and, but for the sign, of the one before. */
    final double[] nextX;

    final double[] nextY;
    final double[] lastX;
    final double[] lastY;

    private final ChainFactor factor;

    /** Arms to the next pin and to the one before, in the coordinates of the body; and turned. */
    private final double[] ownNextX;

    private final double[] ownNextY;
    private final double[] ownLastX;
    private final double[] ownLastY;
    final double[] armNextX;
    final double[] armNextY;
    final double[] armLastX;
    final double[] armLastY;

    /** The known angles, and their cosines and sines. */
    private final double[] known;

    private final double[] knownCos;
    private final double[] knownSin;

    /** What a body adds to the diagonal blocks of A of its next pin and of the one before, and the block between them. */
    final double[] next00;

    final double[] next01;
    final double[] next11;
    final double[] last00;
    final double[] last01;
    final double[] last11;
    final double[] mid00;
    final double[] mid01;
    final double[] mid10;
    final double[] mid11;

    /** λ of a body's next pin and of the one before. */
    final double[] lambdaNextX;

    final double[] lambdaNextY;
    final double[] lambdaLastX;
    final double[] lambdaLastY;
    private final double[] cosines;
    private final double[] sines;

    /**
     * Makes a chain.
     *
     * @param block by body, −1 for what does not move
     * @param arms by body: to the next pin, to the one before; places in the world for what does not move
     */
    PinChain(int[] block, double[] arms) {
        this.block = block;
        int n = block.length;
        pins = n - 1;
        mass = new double[n];
        inertia = new double[n];
        x = new double[n];
        y = new double[n];
        angle = new double[n];
        u = new double[n];
        v = new double[n];
        omega = new double[n];
        dx = new double[n];
        dy = new double[n];
        turn = new double[n];
        nextX = new double[n];
        nextY = new double[n];
        lastX = new double[n];
        lastY = new double[n];
        ownNextX = new double[n];
        ownNextY = new double[n];
        ownLastX = new double[n];
        ownLastY = new double[n];
        armNextX = new double[n];
        armNextY = new double[n];
        armLastX = new double[n];
        armLastY = new double[n];
        known = new double[n];
        knownCos = new double[n];
        knownSin = new double[n];
        next00 = new double[n];
        next01 = new double[n];
        next11 = new double[n];
        last00 = new double[n];
        last01 = new double[n];
        last11 = new double[n];
        mid00 = new double[n];
        mid01 = new double[n];
        mid10 = new double[n];
        mid11 = new double[n];
        lambdaNextX = new double[n];
        lambdaNextY = new double[n];
        lambdaLastX = new double[n];
        lambdaLastY = new double[n];
        cosines = new double[n];
        sines = new double[n];
        factor = new ChainFactor(pins);
        Arrays.fill(knownCos, 1);
        for (int k = 0; k < n; k++) {
            ownNextX[k] = arms[4 * k];
            ownNextY[k] = arms[4 * k + 1];
            ownLastX[k] = arms[4 * k + 2];
            ownLastY[k] = arms[4 * k + 3];
        }
    }

    /** Takes the masses over. */
    void weigh(double[] w) {
        for (int k = 0; k <= pins; k++) {
            mass[k] = block[k] < 0 ? 0 : w[block[k]];
            inertia[k] = block[k] < 0 ? 0 : w[block[k] + State.THETA];
        }
    }

    /** Lets the known angles be those nearest to the present ones. */
    void settleAngles() {
        for (int k = 0; k <= pins; k++) {
            double nearest = Math.rint(GRAIN * angle[k]) / GRAIN;
            if (nearest != known[k]) {
                know(k, nearest);
            }
        }
    }

    private void know(int k, double nearest) {
        known[k] = nearest;
        knownCos[k] = Trig.cos(nearest);
        knownSin[k] = Trig.sin(nearest);
    }

    /** Turns the arms: (45), (46). */
    void turnArms() {
        for (int k = 0; k <= pins; k++) {
            if (!(Math.abs(angle[k] - known[k]) <= NEAR)) {
                know(k, Math.rint(GRAIN * angle[k]) / GRAIN);
            }
        }
        double[] to = angle;
        double[] from = known;
        double[] fromCos = knownCos;
        double[] fromSin = knownSin;
        double[] c = cosines;
        double[] s = sines;
        for (int k = 0; k < c.length; k++) {
            double d = to[k] - from[k];
            double z = d * d;
            double p = z * (1.0 / 6 - z * (1.0 / 120 - z * (1.0 / 5040 - z * (1.0 / 362880))));
            double q = z * (0.5 - z * (1.0 / 24 - z * (1.0 / 720 - z * (1.0 / 40320 - z * (1.0 / 3628800)))));
            double sin = d - d * p; // series of sin d and 1 − cos d
            c[k] = fromCos[k] - (fromCos[k] * q + fromSin[k] * sin);
            s[k] = fromSin[k] - (fromSin[k] * q - fromCos[k] * sin);
        }
        turn(cosines, sines, ownNextX, ownNextY, armNextX, armNextY);
        turn(cosines, sines, ownLastX, ownLastY, armLastX, armLastY);
    }

    private static void turn(double[] cos, double[] sin, double[] ownX, double[] ownY, double[] armX, double[] armY) {
        for (int k = 0; k < cos.length; k++) {
            armX[k] = cos[k] * ownX[k] - sin[k] * ownY[k];
            armY[k] = sin[k] * ownX[k] + cos[k] * ownY[k];
        }
    }

    /** Turns the arms by the tiny angles of the last solution. */
    void nudgeArms() {
        nudge(turn, armNextX, armNextY);
        nudge(turn, armLastX, armLastY);
    }

    private static void nudge(double[] by, double[] armX, double[] armY) {
        for (int k = 0; k < by.length; k++) {
            double d = by[k];
            double rx = armX[k];
            double ry = armY[k];
            armX[k] = rx - d * (ry + 0.5 * d * rx);
            armY[k] = ry + d * (rx - 0.5 * d * ry);
        }
    }

    /** The right side of the accelerations: J F W + J̇ ẋ where a body falls with an acceleration. */
    void askAcceleration(double[] fallX, double[] fallY) {
        ask(fallX, fallY, omega, armNextX, armNextY, nextX, nextY);
        ask(fallX, fallY, omega, armLastX, armLastY, lastX, lastY);
    }

    private static void ask(
            double[] fx, double[] fy, double[] spin, double[] rx, double[] ry, double[] outX, double[] outY) {
        for (int k = 0; k < outX.length; k++) {
            double square = spin[k] * spin[k];
            outX[k] = fx[k] - square * rx[k];
            outY[k] = fy[k] - square * ry[k];
        }
    }

    /** The right side of the positions: C, (42)–(44). */
    void askPosition() {
        add(x, armNextX, nextX);
        add(y, armNextY, nextY);
        add(x, armLastX, lastX);
        add(y, armLastY, lastY);
    }

    private static void add(double[] a, double[] b, double[] sum) {
        for (int k = 0; k < sum.length; k++) {
            sum[k] = a[k] + b[k];
        }
    }

    /** The right side of the velocities: J ẋ. */
    void askVelocity() {
        speed(u, v, omega, armNextX, armNextY, nextX, nextY);
        speed(u, v, omega, armLastX, armLastY, lastX, lastY);
    }

    private static void speed(
            double[] u, double[] v, double[] spin, double[] rx, double[] ry, double[] outX, double[] outY) {
        for (int k = 0; k < outX.length; k++) {
            outX[k] = u[k] - spin[k] * ry[k];
            outY[k] = v[k] + spin[k] * rx[k];
        }
    }

    /** The entries of A = J W Jᵀ. */
    private void assemble() {
        diagonal(mass, inertia, armNextX, armNextY, next00, next01, next11);
        diagonal(mass, inertia, armLastX, armLastY, last00, last01, last11);
        double[] m = mass;
        double[] i = inertia;
        double[] rx = armNextX;
        double[] ry = armNextY;
        double[] sx = armLastX;
        double[] sy = armLastY;
        double[] e00 = mid00;
        double[] e01 = mid01;
        double[] e10 = mid10;
        double[] e11 = mid11;
        for (int k = 0; k < e00.length; k++) {
            double ix = i[k] * sx[k];
            double iy = i[k] * sy[k];
            e00[k] = -(m[k] + iy * ry[k]);
            e01[k] = iy * rx[k];
            e10[k] = ix * ry[k];
            e11[k] = -(m[k] + ix * rx[k]);
        }
    }

    private static void diagonal(
            double[] m, double[] i, double[] rx, double[] ry, double[] d00, double[] d01, double[] d11) {
        for (int k = 0; k < d00.length; k++) {
            double ix = i[k] * rx[k];
            double iy = i[k] * ry[k];
            d00[k] = m[k] + iy * ry[k];
            d01[k] = -(iy * rx[k]);
            d11[k] = m[k] + ix * rx[k];
        }
    }

    /**
     * Factors A at the present arms and solves for the right side that was asked for.
     *
     * @return false if a pin is near to depend on others
     */
    boolean factorAndSolve() {
        assemble();
        boolean sound = factor.factor(this);
        factor.back(this);
        apply();
        return sound;
    }

    /** Solves for the right side that was asked for, with the last factors. */
    void solve() {
        factor.forward(this);
        factor.back(this);
        apply();
    }

    /** The largest component of the right side that was asked for. */
    double largest() {
        double most = 0;
        for (int k = 0; k < pins; k++) {
            most = Math.max(most, Math.max(Math.abs(lastX[k + 1] - nextX[k]), Math.abs(lastY[k + 1] - nextY[k])));
        }
        return most;
    }

    /** W Jᵀ λ. */
    private void apply() {
        push(mass, lambdaNextX, lambdaLastX, dx);
        push(mass, lambdaNextY, lambdaLastY, dy);
        double[] i = inertia;
        double[] px = lambdaNextX;
        double[] py = lambdaNextY;
        double[] qx = lambdaLastX;
        double[] qy = lambdaLastY;
        double[] rx = armNextX;
        double[] ry = armNextY;
        double[] sx = armLastX;
        double[] sy = armLastY;
        double[] out = turn;
        for (int k = 0; k < out.length; k++) {
            out[k] = i[k] * ((rx[k] * py[k] - ry[k] * px[k]) - (sx[k] * qy[k] - sy[k] * qx[k]));
        }
    }

    private static void push(double[] m, double[] next, double[] last, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = m[k] * (next[k] - last[k]);
        }
    }
}
