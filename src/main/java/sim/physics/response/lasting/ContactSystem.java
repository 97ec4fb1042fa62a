// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;

/**
 * Contact points of a cluster of bodies at rest on one another, and projected relaxation of their forces: unilateral along
 * the normals, and Coulomb's along the tangents.
 *
 * <pre>
 *   λₙ ≥ 0,  vₙ ≥ 0,  λₙ vₙ = 0,    |λₜ| ≤ μ λₙ,  λₜ opposes vₜ
 * </pre>
 *
 * <p>The same system is solved for displacements, velocities and accelerations: u are three values per body, and each point
 * in turn gets the change that makes its own row right (projected Gauss-Seidel; Jean 1999). Values start from those of the
 * last time that the same point was solved.
 */
final class ContactSystem implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values per point: gap, friction, mobilities, bias, sliding, forces, parting, belt. */
    private static final int STRIDE = 10;

    private static final int GAP = 0;
    private static final int FRICTION = 1;
    private static final int MOBILITY_N = 2;
    private static final int MOBILITY_T = 3;
    private static final int BIAS = 4;
    private static final int SLIDING = 5;
    private static final int FORCE_N = 6;
    private static final int FORCE_T = 7;
    private static final int PARTING = 8;
    private static final int BELT = 9;

    /** Accelerations that no contact gives, relative to those of the forces: an impulse would be needed (Painlevé 1895). */
    private static final double ASTRAY = 1e4;

    /** Points whose forces are found exactly, from the modes that some sweeps guess. */
    private static final int FEW = 120;

    private static final int FIRST_SWEEPS = 30;
    private static final int SWEEPS = 2000;
    private static final int WORK = 60_000;

    /** Change of a sweep, relative to the largest one of the first, at which the forces are right. */
    private static final double RIGHT = 1e-13;

    /** Inverse masses and moments of inertia, 2 per body; and the values that are solved for, 3 per body. */
    double[] w = new double[16];

    double[] u = new double[24];

    private int points;

    /** Points behind them that do not touch yet. */
    private int near;
    private int bodyCount;
    private double[] data = new double[8 * STRIDE];
    private final PointRows rows = new PointRows();
    private double[] before = {};
    private double slowest;
    private boolean frictionless;
    private final ContactModes modes = new ContactModes();

    ContactSystem() {
        // grows with the clusters
    }

    void clear(int count) {
        points = 0;
        near = 0;
        bodyCount = count;
        if (u.length < 3 * count) {
            u = new double[6 * count];
            w = new double[4 * count];
        }
    }

    int size() {
        return points;
    }

    /** Adds a point between two bodies of the cluster, −1 for what cannot move. */
    void add(int a, int b, ContactPoint c, double gap, double bias) {
        int at = points + near;
        rows.set(at, a, b, c);
        int o = STRIDE * at;
        if (data.length < o + STRIDE) {
            data = Arrays.copyOf(data, 2 * o + STRIDE);
        }
        data[o + GAP] = gap;
        data[o + BIAS] = bias;
        data[o + PARTING] = 0;
        data[o + FRICTION] = c.friction;
        data[o + BELT] = c.belt;
        data[o + MOBILITY_N] = c.normalMobility;
        data[o + MOBILITY_T] = c.tangentMobility;
        points++;
    }

    /** Adds a point that does not touch yet, behind all that do. */
    void addNear(int a, int b, ContactPoint c, double gap) {
        add(a, b, c, gap, 0);
        points--;
        near++;
    }

    /** Notes which points part, by the velocities u: those that do bear no force. */
    void noteParting(double bound) {
        for (int p = 0; p < points + near; p++) {
            double v = normal(p);
            data[STRIDE * p + PARTING] = p >= points || v > bound ? v == 0 ? Double.MIN_NORMAL : v : 0;
        }
    }

    boolean parts(int p) {
        return data[STRIDE * p + PARTING] != 0;
    }

    /** The time after which the first of them touches, by the accelerations u. */
    double untilTouch() {
        double least = Double.POSITIVE_INFINITY;
        for (int p = 0; p < points + near; p++) {
            if (!parts(p)) {
                continue;
            }
            double gap = Math.max(0, data[STRIDE * p + GAP]);
            double v = data[STRIDE * p + PARTING];
            double a = normal(p);
            double square = v * v - 2 * a * gap;
            if (square >= 0 && (v < 0 || a < 0)) {
                double t = v < 0 ? 2 * gap / (Math.sqrt(square) - v) : -(v + Math.sqrt(square)) / a;
                least = Math.min(least, t);
            }
        }
        return least;
    }

    /** Displacements u that close all gaps, wide or deep. */
    void close() {
        start();
        if (points <= FEW) {
            modes.close(this);
            return;
        }
        double first = 0;
        int sweeps = sweeps();
        for (int k = 0; k < sweeps; k++) {
            double most = 0;
            for (int p = 0; p < points; p++) {
                int o = STRIDE * p;
                if (parts(p)) {
                    continue;
                }
                double change = -(normal(p) + data[o + GAP]) / data[o + MOBILITY_N];
                push(p, change, 0);
                most = Math.max(most, Math.abs(change));
            }
            first = k == 0 ? most : first;
            if (!(most > RIGHT * first)) {
                return;
            }
        }
    }

    /** Velocities u that do not approach, slow ones are none, and slide only where friction lets them. */
    void stop(double slow) {
        start();
        slowest = slow;
        solve(false);
    }

    /** Accelerations u that do not approach; points that slide rub, others stick if they can. */
    void press() {
        start();
        solve(true);
    }

    private void start() {
        for (int p = 0; p < points; p++) {
            data[STRIDE * p + FORCE_N] = 0;
            data[STRIDE * p + FORCE_T] = 0;
        }
    }

    private int sweeps() {
        return Math.max(20, Math.min(SWEEPS, WORK / Math.max(1, points)));
    }

    /** Exactly if the points are few and modes are found, else by relaxation; without friction if that goes astray. */
    private void solve(boolean forces) {
        before = before.length < u.length ? u.clone() : before;
        System.arraycopy(u, 0, before, 0, u.length);
        double energy = forces ? Double.POSITIVE_INFINITY : energy() * (1 + 1e-9) + slowEnergy();
        double most = forces ? ASTRAY * largest() : Double.POSITIVE_INFINITY;
        boolean few = points <= FEW;
        if (few) {
            modes.keep(u);
            relax(FIRST_SWEEPS, forces);
            if (modes.solve(this, forces) && energy() + driven() <= energy && largest() <= most) {
                return;
            }
        }
        again(forces);
        if (energy() + driven() <= energy && largest() <= most) {
            return;
        }
        frictionless = true;
        again(forces);
        frictionless = false;
    }

    /** Twice the energy that slow motions have. */
    private double slowEnergy() {
        double sum = 0;
        for (int k = 0; k < bodyCount; k++) {
            sum += slowest * slowest / w[2 * k];
        }
        return sum;
    }

    private void again(boolean forces) {
        System.arraycopy(before, 0, u, 0, u.length);
        start();
        relax(sweeps(), forces);
    }

    private double largest() {
        double most = 0;
        for (int k = 0; k < bodyCount; k++) {
            most = Math.max(most, BodyScale.largest(w, u, k));
        }
        return most;
    }

    /** Twice the kinetic energy of the velocities u. */
    private double energy() {
        double sum = 0;
        for (int k = 0; k < bodyCount; k++) {
            double square = u[3 * k] * u[3 * k] + u[3 * k + 1] * u[3 * k + 1];
            sum += square / w[2 * k] + u[3 * k + 2] * u[3 * k + 2] / w[2 * k + 1];
        }
        return sum;
    }

    /** What moving surfaces take by their impulses, as twice an energy: negative if they give it. */
    private double driven() {
        double sum = 0;
        for (int p = 0; p < points; p++) {
            sum += 2 * data[STRIDE * p + FORCE_T] * data[STRIDE * p + BELT];
        }
        return sum;
    }

    private void relax(int sweeps, boolean forces) {
        double first = 0;
        for (int k = 0; k < sweeps; k++) {
            double most = 0;
            for (int p = 0; p < points; p++) {
                most = Math.max(most, relaxPoint(p, forces));
            }
            first = Math.max(most, first);
            if (!(most > RIGHT * first)) {
                return;
            }
        }
    }

    /** Makes one point's rows right; returns the change of its forces. */
    private double relaxPoint(int p, boolean forces) {
        int o = STRIDE * p;
        if (forces && parts(p)) {
            return 0;
        }
        double bias = forces ? data[o + BIAS] : 0;
        double old = data[o + FORCE_N];
        double force = Math.max(0, old - (normal(p) + bias) / data[o + MOBILITY_N]);
        data[o + FORCE_N] = force;
        push(p, force - old, 0);
        double change = Math.abs(force - old);
        double most = frictionless ? 0 : data[o + FRICTION] * force;
        if (most == 0 && data[o + FORCE_T] == 0) {
            return change;
        }
        double oldT = data[o + FORCE_T];
        double sliding = forces ? data[o + SLIDING] : 0;
        double forceT = sliding != 0
                ? -Math.copySign(most, sliding)
                : Math.max(-most, Math.min(most, oldT - slip(p, forces) / data[o + MOBILITY_T]));
        data[o + FORCE_T] = forceT;
        push(p, 0, forceT - oldT);
        return Math.max(change, Math.abs(forceT - oldT));
    }

    /** Notes which points slide, by the velocities u; slower than a bound is none. Returns the fastest way of a body over another one. */
    double noteSliding(double bound) {
        double most = 0;
        for (int p = 0; p < points; p++) {
            double t = tangent(p);
            most = Math.max(most, Math.abs(t));
            t += data[STRIDE * p + BELT];
            data[STRIDE * p + SLIDING] = Math.abs(t) > bound && data[STRIDE * p + FRICTION] > 0 ? t : 0;
        }
        return most;
    }

    /** The time after which the first point that slides comes to a stop, by the accelerations u. */
    double untilStop() {
        double least = Double.POSITIVE_INFINITY;
        for (int p = 0; p < points; p++) {
            double sliding = data[STRIDE * p + SLIDING];
            double t = sliding == 0 ? 0 : -sliding / tangent(p);
            if (t > 0) {
                least = Math.min(least, t);
            }
        }
        return least;
    }

    double normal(int p) {
        return rows.normal(p, u);
    }

    double tangent(int p) {
        return rows.tangent(p, u);
    }

    /** What friction is to take along the tangent: of velocities that of the surfaces, whose accelerations are those of the bodies. */
    double slip(int p, boolean forces) {
        return tangent(p) + (forces ? 0 : data[STRIDE * p + BELT]);
    }

    /** Adds forces along the normal and the tangent of a point. */
    void push(int p, double fn, double ft) {
        rows.pushFirst(p, fn, ft, w, u);
        rows.pushSecond(p, fn, ft, w, u);
    }

    double gap(int p) {
        return data[STRIDE * p + GAP];
    }

    double bias(int p) {
        return data[STRIDE * p + BIAS];
    }

    double friction(int p) {
        return data[STRIDE * p + FRICTION];
    }

    double sliding(int p) {
        return data[STRIDE * p + SLIDING];
    }

    double normalMobility(int p) {
        return data[STRIDE * p + MOBILITY_N];
    }

    /** Takes note of a point's forces, which the values u know already. */
    void setForces(int p, double normal, double tangential) {
        data[STRIDE * p + FORCE_N] = normal;
        data[STRIDE * p + FORCE_T] = tangential;
    }

    double normalForce(int p) {
        return data[STRIDE * p + FORCE_N];
    }

    double tangentForce(int p) {
        return data[STRIDE * p + FORCE_T];
    }
}
