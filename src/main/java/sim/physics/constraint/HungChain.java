// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.internal.SineTable;
import sim.physics.internal.Trig;
import sim.physics.motion.State;

/**
 * A {@link PinTree} that is a chain hung in the world, under a uniform field: RK4 on its angles with half the operations, and
 * less waiting, since the accelerations are found from both ends at the same time.
 *
 * <p>Where a link's centre of mass is on the line between its pins, the link is as good as two points at the pins, and a
 * moment of inertia J that is left and may be negative. So the chain is knots of mass μ, joined by links without a mass. Link
 * k, of length L and direction n, pulls its knots with forces ± G, which turn it, J α = L n⊥·G. With the accelerations of
 * the knots, μ A = G_k − G_{k−1}, what its ends have to do is
 *
 * <pre>
 *   ((1/μ_k + 1/μ_{k+1}) I + L²/J n⊥ n⊥ᵀ) G_k − G_{k−1} / μ_k − G_{k+1} / μ_{k+1} = ω² L n
 * </pre>
 *
 * <p>The knot that hangs has no 1/μ, and the acceleration −g takes its place. In units σ of G with σ_k σ_{k+1} = μ_{k+1}
 * the blocks beside the diagonal are −I. The blocks of the diagonal are eliminated from both ends to the middle, with one
 * division each, and G is found from there to both ends.
 */
final class HungChain implements Serializable {
    private static final long serialVersionUID = 1L;

    /** J and the masses of the points, in units of m L² and m: less would be too little to divide by. */
    private static final double LEAST = 1.0 / 64;

    /** By how much σ may change along the chain. */
    private static final double WIDEST = 0x1p64;

    /** What the energy may be off by after a step, relative to the kinetic energy; a step that is off by more was too long. */
    private static final double WRONG = 0.05;

    /** What a field does to links far away fades from link to link; below this part of it numbers would soon be denormal. */
    private static final double NOTHING = 0x1p-200;

    /** Links from which on it can fade so far. */
    private static final int FADING = 256;

    /** The largest turn of a link that is followed at once. */
    private static final double HALF_TURN = Math.PI;

    private final PinTree tree;
    private final int links;
    private final int middle;

    /** By link: L, of either sign, and the turn from the axis of the link to n: quarter turns and a rest. */
    private final double[] length;

    private final int[] quarters;
    private final double[] rest;
    private final double[] restCos;
    private final double[] restSin;

    /** By link: the diagonal blocks, τ I + ι n⊥ n⊥ᵀ, as τ, τ + ι and ι; σ L; and σ L / J. */
    private final double[] tau;

    private final double[] all;
    private final double[] iota;
    private final double[] swing;
    private final double[] lever;

    /** σ of the first link. */
    private double first;

    /** From the near pin to the centre of mass, along n; mass and moment of inertia. */
    private final double[] reach;

    private final double[] mass;
    private final double[] inertia;

    /** Where the links are at the start or the end of a step, and how fast they move. */
    private final double[] x;

    private final double[] y;
    private final double[] u;
    private final double[] v;

    /** Angle and angular velocity at the start and the end of a step, the angle of n there, and n there and at a stage. */
    private final double[] angle;

    private final double[] omega;
    private final double[] base;
    private final double[] cos;
    private final double[] sin;

    /** Angular velocity at a stage, and angular accelerations of the stages. */
    private final double[] turning;

    private final double[] alpha0;
    private final double[] alpha1;
    private final double[] alpha2;

    /** Inverses of the eliminated blocks, without the sign beside the diagonal, and those times the right-hand sides. */
    private final double[] p00;

    private final double[] p01;
    private final double[] p11;
    private final double[] z0;
    private final double[] z1;

    /** The unknown of the link in the middle. */
    private double middle0;

    private double middle1;

    private double roughness;

    /** Unknowns below this are none. */
    private double nothing;

    private HungChain(PinTree tree) {
        this.tree = tree;
        links = tree.links;
        middle = (links - 1) / 2;
        quarters = new int[links];
        length = new double[links];
        rest = new double[links];
        restCos = new double[links];
        restSin = new double[links];
        tau = new double[links];
        all = new double[links];
        iota = new double[links];
        swing = new double[links];
        lever = new double[links];
        reach = new double[links];
        mass = new double[links];
        inertia = new double[links];
        x = new double[links];
        y = new double[links];
        u = new double[links];
        v = new double[links];
        angle = new double[links];
        omega = new double[links];
        base = new double[links];
        cos = new double[links];
        sin = new double[links];
        turning = new double[links];
        alpha0 = new double[links];
        alpha1 = new double[links];
        alpha2 = new double[links];
        p00 = new double[links];
        p01 = new double[links];
        p11 = new double[links];
        z0 = new double[links];
        z1 = new double[links];
    }

    /**
     * Makes a chain of a tree of known masses.
     *
     * @return null if it is none of this kind
     */
    static HungChain of(PinTree tree) {
        boolean yes = !tree.isFree && tree.runCount == 1;
        for (int k = 0; yes && k < tree.links; k++) {
            int o = PinTree.STRIDE * k;
            double[] l = tree.link;
            double square = l[o + PinTree.EX] * l[o + PinTree.EX] + l[o + PinTree.EY] * l[o + PinTree.EY];
            double least = LEAST * l[o + PinTree.MASS];
            yes = !tree.isOdd[k]
                    && l[o + PinTree.FAR] >= least
                    && l[o + PinTree.FAR] <= l[o + PinTree.MASS]
                    && Math.abs(l[o + PinTree.HUB]) >= least * square;
        }
        return yes ? new HungChain(tree).weigh() : null;
    }

    /** Takes the masses over; returns null if they differ so much that numbers would become too large. */
    private HungChain weigh() {
        first = Math.sqrt(tree.link[PinTree.KNOT]);
        double sigma = first;
        double before = 0; // 1/μ of the near knot
        for (int k = 0, o = 0; k < links; k++, o += PinTree.STRIDE) {
            aim(k, tree.link[o + PinTree.EX], tree.link[o + PinTree.EY]);
            mass[k] = tree.link[o + PinTree.MASS];
            inertia[k] = tree.link[o + PinTree.INERTIA];
            double mu = tree.link[o + PinTree.KNOT];
            double per = sigma / tree.link[o + PinTree.HUB];
            tau[k] = sigma * sigma * (before + 1 / mu);
            iota[k] = sigma * length[k] * length[k] * per;
            all[k] = tau[k] + iota[k];
            swing[k] = sigma * length[k];
            lever[k] = length[k] * per;
            reach[k] = tree.link[o + PinTree.FAR] / mass[k] * length[k];
            before = 1 / mu;
            sigma = mu / sigma;
            if (!(sigma >= first / WIDEST && sigma <= first * WIDEST)) {
                return null;
            }
        }
        return this;
    }

    /** Along an axis of the link there is no rest, and mirror images have mirrored bits. */
    private void aim(int k, double ex, double ey) {
        boolean isSteep = Math.abs(ey) > Math.abs(ex);
        double along = isSteep ? ey : ex;
        double across = isSteep ? -ex : ey;
        quarters[k] = isSteep ? 1 : 0;
        length[k] = Math.copySign(Math.sqrt(ex * ex + ey * ey), along);
        rest[k] = Trig.atan2(Math.copySign(1, along) * across, Math.abs(along));
        restCos[k] = along / length[k];
        restSin[k] = across / length[k];
    }

    /** Turns n to where the angle has it. */
    private void point(int k) {
        double known = angle[k];
        base[k] = known + rest[k];
        SineTable.direct(known, quarters[k], cos, sin, k);
        if (rest[k] != 0) {
            double c = cos[k];
            double s = sin[k];
            cos[k] = restCos[k] * c - restSin[k] * s;
            sin[k] = restCos[k] * s + restSin[k] * c;
        }
    }

    /** A step, (13); returns its roughness, see {@link PinTree#roughness}. */
    double step(double gx, double gy, double h) {
        nothing = NOTHING * first * (Math.abs(gx) + Math.abs(gy));
        eliminate(gx, gy);
        accelerate(alpha0, 0.5 * h);
        eliminate(gx, gy);
        accelerate(alpha1, 0.5 * h);
        eliminate(gx, gy);
        accelerate(alpha2, h);
        eliminate(gx, gy);
        finish(h);
        return roughness;
    }

    /** Eliminates the links from both ends, and solves for the one in the middle. */
    private void eliminate(double gx, double gy) {
        double a00 = 0; // what the link before it leaves in a block, without the sign beside the diagonal, and in its right side
        double a01 = 0;
        double a11 = 0;
        double x0 = first * gx;
        double x1 = first * gy;
        int q = eliminateOdd();
        boolean isOdd = q < links - 1;
        double b00 = isOdd ? p00[q + 1] : 0; // the same from the tip
        double b01 = isOdd ? p01[q + 1] : 0;
        double b11 = isOdd ? p11[q + 1] : 0;
        double y0 = isOdd ? z0[q + 1] : 0;
        double y1 = isOdd ? z1[q + 1] : 0;
        for (int k = 0; k < middle; k++, q--) {
            double c = cos[k];
            double s = sin[k];
            double across = iota[k] * s;
            double square = turning[k] * turning[k] * swing[k];
            double d00 = tau[k] + across * s - a00;
            double d11 = all[k] - across * s - a11;
            double d01 = a01 - across * c;
            double f0 = square * c + x0;
            double f1 = square * s + x1;
            double per = 1 / (d00 * d11 - d01 * d01);
            a00 = d11 * per;
            a11 = d00 * per;
            a01 = d01 * per;
            x0 = a00 * f0 - a01 * f1;
            x1 = a11 * f1 - a01 * f0;
            p00[k] = a00;
            p01[k] = a01;
            p11[k] = a11;
            z0[k] = x0;
            z1[k] = x1;
            c = cos[q];
            s = sin[q];
            across = iota[q] * s;
            square = turning[q] * turning[q] * swing[q];
            d00 = tau[q] + across * s - b00;
            d11 = all[q] - across * s - b11;
            d01 = b01 - across * c;
            f0 = square * c + y0;
            f1 = square * s + y1;
            per = 1 / (d00 * d11 - d01 * d01);
            b00 = d11 * per;
            b11 = d00 * per;
            b01 = d01 * per;
            y0 = b00 * f0 - b01 * f1;
            y1 = b11 * f1 - b01 * f0;
            p00[q] = b00;
            p01[q] = b01;
            p11[q] = b11;
            z0[q] = y0;
            z1[q] = y1;
        }
        meet(a00 + b00, a01 + b01, a11 + b11, x0 + y0, x1 + y1);
    }

    /** The last link goes first if there are not as many before the middle as behind; returns the last one that is left. */
    private int eliminateOdd() {
        int q = links - 1;
        if (links % 2 == 0) {
            double across = iota[q] * sin[q];
            double square = turning[q] * turning[q] * swing[q];
            double d00 = tau[q] + across * sin[q];
            double d11 = all[q] - across * sin[q];
            double d01 = -across * cos[q];
            double per = 1 / (d00 * d11 - d01 * d01);
            p00[q] = d11 * per;
            p01[q] = d01 * per;
            p11[q] = d00 * per;
            z0[q] = p00[q] * square * cos[q] - p01[q] * square * sin[q];
            z1[q] = p11[q] * square * sin[q] - p01[q] * square * cos[q];
            q--;
        }
        return q;
    }

    private void meet(double a00, double a01, double a11, double x0, double x1) {
        int k = middle;
        double across = iota[k] * sin[k];
        double square = turning[k] * turning[k] * swing[k];
        double d00 = tau[k] + across * sin[k] - a00;
        double d11 = all[k] - across * sin[k] - a11;
        double d01 = a01 - across * cos[k];
        double f0 = square * cos[k] + x0;
        double f1 = square * sin[k] + x1;
        double per = 1 / (d00 * d11 - d01 * d01);
        middle0 = per * (d11 * f0 - d01 * f1);
        middle1 = per * (d00 * f1 - d01 * f0);
    }

    /**
     * The angular accelerations, from the middle to both ends, and the links at the next stage: by c times the rates of this
     * one from the start.
     */
    private void accelerate(double[] alpha, double c) {
        double x0 = middle0;
        double x1 = middle1;
        double y0 = x0;
        double y1 = x1;
        boolean isLong = links > FADING;
        turn(middle, x0, x1, alpha, c);
        int q = middle + 1;
        for (int k = middle - 1; k >= 0; k--, q++) {
            double w0 = z0[k] - p01[k] * x1 + p00[k] * x0;
            x1 = z1[k] - p01[k] * x0 + p11[k] * x1;
            x0 = w0;
            turn(k, x0, x1, alpha, c);
            w0 = z0[q] - p01[q] * y1 + p00[q] * y0;
            y1 = z1[q] - p01[q] * y0 + p11[q] * y1;
            y0 = w0;
            if (isLong) {
                y0 = Math.abs(y0) < nothing ? 0 : y0;
                y1 = Math.abs(y1) < nothing ? 0 : y1;
            }
            turn(q, y0, y1, alpha, c);
        }
        if (q < links) {
            turn(q, z0[q] - p01[q] * y1 + p00[q] * y0, z1[q] - p01[q] * y0 + p11[q] * y1, alpha, c);
        }
    }

    private double alpha(int k, double g0, double g1) {
        return lever[k] * (cos[k] * g1 - sin[k] * g0);
    }

    private void turn(int k, double g0, double g1, double[] alpha, double c) {
        double found = alpha(k, g0, g1);
        double turned = base[k] + c * turning[k];
        alpha[k] = found;
        turning[k] = omega[k] + c * found;
        SineTable.direct(turned, quarters[k], cos, sin, k); // (45), (46)
    }

    /** The same at the last stage, and the links at the end of the step, (13). */
    private void finish(double h) {
        double x0 = middle0;
        double x1 = middle1;
        double y0 = x0;
        double y1 = x1;
        boolean isLong = links > FADING;
        roughness = 0;
        finish(middle, x0, x1, h);
        int q = middle + 1;
        for (int k = middle - 1; k >= 0; k--, q++) {
            double w0 = z0[k] - p01[k] * x1 + p00[k] * x0;
            x1 = z1[k] - p01[k] * x0 + p11[k] * x1;
            x0 = w0;
            finish(k, x0, x1, h);
            w0 = z0[q] - p01[q] * y1 + p00[q] * y0;
            y1 = z1[q] - p01[q] * y0 + p11[q] * y1;
            y0 = w0;
            if (isLong) {
                y0 = Math.abs(y0) < nothing ? 0 : y0;
                y1 = Math.abs(y1) < nothing ? 0 : y1;
            }
            finish(q, y0, y1, h);
        }
        if (q < links) {
            finish(q, z0[q] - p01[q] * y1 + p00[q] * y0, z1[q] - p01[q] * y0 + p11[q] * y1, h);
        }
    }

    private void finish(int k, double g0, double g1, double h) {
        double last = alpha(k, g0, g1);
        double before = omega[k];
        double one = alpha0[k];
        double two = alpha1[k];
        double three = alpha2[k];
        double sum = two + three;
        double rough = Math.abs(one - sum + last) + Math.abs(two - three);
        if (!(rough <= roughness && Math.abs(h * before) <= HALF_TURN)) { // seldom; a maximum would make each wait for the last
            roughness = rough >= 0 && Math.abs(h * before) <= HALF_TURN ? rough : Double.POSITIVE_INFINITY; // NaN stays
        }
        double sixth = h / 6;
        angle[k] = angle[k] + h * (before + sixth * (one + sum));
        omega[k] = before + sixth * (one + 2 * sum + last);
        turning[k] = omega[k];
        point(k);
    }

    /** Where the angles say that the links are, and how fast they move at the end of a step; (42), (43). */
    void place() {
        double px = tree.places.hangsAtX();
        double py = tree.places.hangsAtY();
        double pu = 0;
        double pv = 0;
        for (int k = 0; k < links; k++) {
            double c = cos[k];
            double s = sin[k];
            double turn = omega[k];
            double near = reach[k];
            double far = length[k];
            x[k] = px + near * c;
            y[k] = py + near * s;
            u[k] = pu - turn * (near * s);
            v[k] = pv + turn * (near * c);
            px += far * c;
            py += far * s;
            pu -= turn * (far * s);
            pv += turn * (far * c);
        }
    }

    /**
     * Gives the chain the energy of the start of a step back, as {@link TreeEnergy} does.
     *
     * @param state at the start, while the links are at the end
     * @param gx the field
     * @param gy the field
     * @return false if it is off by too much; then nothing is changed
     */
    boolean restoreEnergy(State state, double gx, double gy) {
        double[] x0 = state.x();
        double[] v0 = state.v();
        double kinetic = 0;
        double growth = 0;
        for (int k = 0; k < links; k++) {
            int b = tree.block[k];
            double m = mass[k];
            double turn = omega[k];
            kinetic += m * (u[k] * u[k] + v[k] * v[k]) + inertia[k] * turn * turn;
            growth += m * ((u[k] - v0[b]) * (u[k] + v0[b]) + (v[k] - v0[b + 1]) * (v[k] + v0[b + 1]))
                    + inertia[k] * (turn - v0[b + 2]) * (turn + v0[b + 2])
                    - 2 * m * (gx * (x[k] - x0[b]) + gy * (y[k] - x0[b + 1]));
        }
        if (!(Math.abs(growth) <= WRONG * kinetic)) {
            return false;
        }
        double scale = Math.sqrt(1 - growth / kinetic);
        for (int k = 0; kinetic > 0 && k < links; k++) {
            u[k] *= scale;
            v[k] *= scale;
            omega[k] *= scale;
            turning[k] *= scale;
        }
        return true;
    }

    /** Takes a state over. */
    void begin(State state) {
        double[] from = state.x();
        double[] rates = state.v();
        for (int k = 0; k < links; k++) {
            int b = tree.block[k];
            x[k] = from[b];
            y[k] = from[b + 1];
            angle[k] = from[b + 2];
            u[k] = rates[b];
            v[k] = rates[b + 1];
            omega[k] = rates[b + 2];
            turning[k] = omega[k];
            point(k);
        }
    }

    /** Whether a state is, to the bit, that of the end of the last step. */
    boolean isAt(State state) {
        double[] other = state.x();
        double[] rates = state.v();
        long different = 0;
        for (int k = 0; k < links; k++) {
            int b = tree.block[k];
            different |= bits(x[k]) ^ bits(other[b]) | bits(u[k]) ^ bits(rates[b]);
            different |= bits(y[k]) ^ bits(other[b + 1]) | bits(v[k]) ^ bits(rates[b + 1]);
            different |= bits(angle[k]) ^ bits(other[b + 2]) | bits(omega[k]) ^ bits(rates[b + 2]);
        }
        return different == 0;
    }

    private static long bits(double value) {
        return Double.doubleToRawLongBits(value);
    }

    /** Lets the next state be one that is not where the last step ended. */
    void forget() {
        x[0] = Double.NaN;
    }

    /** Writes where the links are into the state vectors. */
    void scatter(State state) {
        double[] to = state.x();
        double[] rates = state.v();
        for (int k = 0; k < links; k++) {
            int b = tree.block[k];
            to[b] = x[k];
            to[b + 1] = y[k];
            to[b + 2] = angle[k];
            rates[b] = u[k];
            rates[b + 1] = v[k];
            rates[b + 2] = omega[k];
        }
    }
}
