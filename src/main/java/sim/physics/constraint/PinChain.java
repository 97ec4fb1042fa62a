// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Trig;
import sim.physics.motion.State;

/**
 * The equations A λ = b, (41), of an island whose pins form a chain: pin k holds body k to body k + 1, so A is block
 * tridiagonal. Its ends are held: what does not move are bodies of no inverse mass.
 *
 * <p>Each quantity has an array of its own, by body or by pin, so that all but the elimination are {@link Lanes}.
 */
final class PinChain implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Angles from the one whose cosine and sine are known, up to which series are right to rounding. */
    private static final double NEAR = 0.125;

    /** Known angles are multiples of 1/16 rad, so that the cosines do not depend on what was before. */
    private static final double GRAIN = 16;

    /** Number of pins; there is one body more. */
    final int pins;

    /** Blocks of the bodies in the state vectors, −1 for what does not move. */
    final int[] block;

    /** By body: positions and velocities. */
    final double[] x;

    final double[] y;
    final double[] angle;
    final double[] u;
    final double[] v;
    final double[] omega;

    private final double[] mass;
    private final double[] inertia;

    /** Arms to the next pin and to the one before, in the coordinates of the body; and turned. */
    private final double[] ownNextX;

    private final double[] ownNextY;
    private final double[] ownLastX;
    private final double[] ownLastY;
    private final double[] nextX;
    private final double[] nextY;
    private final double[] lastX;
    private final double[] lastY;

    /** The known angles, and their cosines and sines. */
    private final double[] known;

    private final double[] knownCos;
    private final double[] knownSin;

    private final double[] one;
    private final double[] two;
    private final double[] three;
    private final double[] four;

    private final ChainFactor factor;

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
        x = new double[n];
        y = new double[n];
        angle = new double[n];
        u = new double[n];
        v = new double[n];
        omega = new double[n];
        mass = new double[n];
        inertia = new double[n];
        ownNextX = every(arms, 0);
        ownNextY = every(arms, 1);
        ownLastX = every(arms, 2);
        ownLastY = every(arms, 3);
        nextX = new double[n];
        nextY = new double[n];
        lastX = new double[n];
        lastY = new double[n];
        known = new double[n];
        knownCos = new double[n];
        knownSin = new double[n];
        Arrays.fill(knownCos, 1);
        one = new double[n];
        two = new double[n];
        three = new double[n];
        four = new double[n];
        factor = new ChainFactor(pins);
    }

    private static double[] every(double[] arms, int from) {
        double[] some = new double[arms.length / 4];
        for (int k = 0; k < some.length; k++) {
            some[k] = arms[4 * k + from];
        }
        return some;
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
        if (Lanes.areApart(angle, known, NEAR)) {
            settleAngles();
        }
        double[] sine = one;
        double[] versine = two;
        double[] cos = three;
        double[] sin = four;
        Lanes.sine(angle, known, sine);
        Lanes.versine(angle, known, versine);
        Lanes.rotate(knownCos, versine, knownSin, sine, cos);
        Lanes.rotateBack(knownSin, versine, knownCos, sine, sin);
        Lanes.cross(cos, ownNextX, sin, ownNextY, nextX);
        Lanes.dot(sin, ownNextX, cos, ownNextY, nextY);
        Lanes.cross(cos, ownLastX, sin, ownLastY, lastX);
        Lanes.dot(sin, ownLastX, cos, ownLastY, lastY);
    }

    /** Turns the arms by tiny angles: cosine and sine to third order. */
    void nudgeArms(double[] by) {
        nudge(by, nextX, nextY);
        nudge(by, lastX, lastY);
    }

    private static void nudge(double[] by, double[] armX, double[] armY) {
        for (int k = 0; k < by.length; k++) {
            double d = by[k];
            double rx = armX[k];
            double ry = armY[k];
            double cos = 0.5 * d * d;
            double sin = d - d * cos * (1.0 / 3);
            armX[k] = rx - (cos * rx + sin * ry);
            armY[k] = ry - (cos * ry - sin * rx);
        }
    }

    /** Asks for C″ = 0 where the bodies fall with an acceleration: b = −(J a + J̇ ẋ), (38). */
    void askAcceleration(double[] fallX, double[] fallY) {
        Lanes.subtractSquare(fallX, omega, nextX, one);
        Lanes.subtractSquare(fallY, omega, nextY, two);
        Lanes.subtractSquare(fallX, omega, lastX, three);
        Lanes.subtractSquare(fallY, omega, lastY, four);
        ask();
    }

    /** The same where they are also turned by an acceleration, to be asked for after that. */
    void askTurning(double[] turn) {
        double[] b0 = factor.b0;
        double[] b1 = factor.b1;
        for (int k = 0; k < b0.length; k++) {
            b0[k] += turn[k] * nextY[k] - turn[k + 1] * lastY[k + 1];
            b1[k] += turn[k + 1] * lastX[k + 1] - turn[k] * nextX[k];
        }
    }

    /** Asks for C = 0: b = −C, (42)–(44). */
    void askPosition() {
        Lanes.add(x, nextX, one);
        Lanes.add(y, nextY, two);
        Lanes.add(x, lastX, three);
        Lanes.add(y, lastY, four);
        ask();
    }

    /** Asks for C′ = 0: b = −J ẋ. */
    void askVelocity() {
        Lanes.subtractProduct(u, omega, nextY, one);
        Lanes.addProduct(v, omega, nextX, two);
        Lanes.subtractProduct(u, omega, lastY, three);
        Lanes.addProduct(v, omega, lastX, four);
        ask();
    }

    private void ask() {
        Lanes.nextLess(three, one, factor.b0);
        Lanes.nextLess(four, two, factor.b1);
    }

    /** The largest part of b, the sum of its components. */
    double largest() {
        return Lanes.most(factor.b0, factor.b1);
    }

    /** A = J W Jᵀ at the present arms, factored, and the first half of its solution for what was asked for. */
    private void factor() {
        Lanes.entry(mass, inertia, nextY, nextY, one);
        Lanes.entry(mass, inertia, lastY, lastY, two);
        Lanes.addNext(one, two, factor.d00);
        Lanes.product(inertia, nextX, nextY, one);
        Lanes.product(inertia, lastX, lastY, two);
        Lanes.minusSumNext(one, two, factor.d01);
        Lanes.entry(mass, inertia, nextX, nextX, one);
        Lanes.entry(mass, inertia, lastX, lastX, two);
        Lanes.addNext(one, two, factor.d11);
        Lanes.minusEntry(mass, inertia, lastY, nextY, factor.e00);
        Lanes.product(inertia, lastY, nextX, factor.e01);
        Lanes.product(inertia, lastX, nextY, factor.e10);
        Lanes.minusEntry(mass, inertia, lastX, nextX, factor.e11);
        factor.factor();
    }

    /** Whether the last factors are those of pins that do not nearly depend on each other. */
    boolean isSound() {
        return factor.isSound();
    }

    /**
     * Solves for what was asked for, at the present arms: f + W Jᵀ λ.
     *
     * @param fx f
     * @param fy f
     * @param outX gets the result
     * @param outY gets the result
     * @param outTurn gets the result
     */
    void factorAndSolve(double[] fx, double[] fy, double[] outX, double[] outY, double[] outTurn) {
        factor();
        factor.back();
        push(fx, fy, outX, outY, outTurn);
    }

    /**
     * The same with the last factors.
     *
     * @param fx f
     * @param fy f
     * @param outX gets the result
     * @param outY gets the result
     * @param outTurn gets the result
     */
    void solve(double[] fx, double[] fy, double[] outX, double[] outY, double[] outTurn) {
        factor.solve();
        push(fx, fy, outX, outY, outTurn);
    }

    private void push(double[] fx, double[] fy, double[] outX, double[] outY, double[] outTurn) {
        Lanes.push(fx, mass, factor.lambdaX, outX);
        Lanes.push(fy, mass, factor.lambdaY, outY);
        Lanes.turnNext(inertia, nextX, nextY, factor.lambdaX, factor.lambdaY, outTurn);
        Lanes.turnLast(inertia, lastX, lastY, factor.lambdaX, factor.lambdaY, outTurn);
    }
}
