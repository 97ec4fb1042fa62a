// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.motion.State;

/**
 * Impulses of an impact at several points with friction, along normals and tangents together. First Moreau's inelastic impact with
 * Coulomb friction,
 *
 * <pre>
 *   λₙ ≥ 0,  vₙ ≥ 0,  λₙ vₙ = 0,    |λₜ| ≤ μ λₙ,  λₜ opposes vₜ
 * </pre>
 *
 * <p>with a μ without bounds at points that stick. Then, as Poisson has it, each point gives e λₙ once more, and rubs within μ e λₙ (Glocker and
 * Pfeiffer, <i>Multiple impacts with friction in rigid multibody systems</i>, 1995); the same part of all that, where it would create energy. Friction
 * at one point of a flush edge turns the body into the other one, so that it would rock if normals came first. Solved by projected relaxation until
 * nothing changes beyond rounding.
 */
final class RoughImpact implements Serializable {
    private static final long serialVersionUID = 1L;

    /** A coefficient of friction that nothing overcomes. */
    static final double STICKS = 1e9;

    private static final int SWEEPS = 2000;
    private static final int LEAST_SWEEPS = 50;
    private static final int WORK = 20_000;

    /** Change of velocity in a sweep, relative to the largest one of the first sweep, at which the impulses are right. */
    private static final double RIGHT = 1e-16;

    /** Friction that matters to no normal impulse, relative to the largest one. */
    private static final double NONE = 1e-9;

    /** What surfaces give and take in an impact, relative to what makes bodies as fast as they are: more than what strikes them rubs off. */
    private static final double RUBBED = 4;

    /** By rows: two for each point. */
    private double[] mobility = {};

    private double[] impulse = {};

    /** The impact that is being solved. */
    private transient Impact[] impacts;

    private transient int points;
    private transient int[] first;
    private transient int[] second;
    private transient double[][] velocity;
    private transient Replies replies;

    private final State state;

    RoughImpact(State state) {
        this.state = state;
    }

    /** Whether there is friction at points of several, or some stick. */
    static boolean isRough(Impact[] impacts, int points) {
        boolean rubs = false;
        boolean sticks = false;
        for (int k = 0; k < points; k++) {
            rubs |= impacts[k].friction > 0;
            sticks |= impacts[k].sticky;
        }
        return sticks || rubs && points > 1;
    }

    /**
     * Solves; the impacts get their impulses, the bodies their velocities.
     *
     * @param which the points, which are that many
     * @param placeA the first body of each, −1 for what cannot move
     * @param placeB the second one
     * @param v velocities of that many bodies
     * @param body which these are
     * @param ties what they reply to the points' normal impulses, and behind them to the tangential ones; null without ties
     * @param allowance energy that may be created
     * @return false, with velocities as they were, if points bounce and no friction acts: normals have a better solution then
     */
    boolean solve(Impact[] which, int count, int[] placeA, int[] placeB, double[][] v, int[] body, int bodies, Replies ties, double allowance) {
        points = count;
        impacts = which;
        first = placeA;
        second = placeB;
        velocity = v;
        replies = ties;
        begin();
        double[][] before = copy(velocity, bodies);
        compress(before, body, bodies);
        boolean isSolved = compressed(before, bodies, allowance);
        reset(before, bodies); // the sweeps have added their rounding
        for (int row = 0; isSolved && row < 2 * points; row++) {
            load(row / 2);
            push(row, impulse[row]);
        }
        for (int k = 0; k < points; k++) {
            impacts[k].jn = impulse[2 * k];
            impacts[k].jt = impulse[2 * k + 1];
        }
        return isSolved;
    }

    /**
     * Stops the points. Where surfaces that move wedge a body, what each of them pulls presses on the other, and impulses would grow without end: these
     * surfaces stand still.
     */
    private void compress(double[][] before, int[] body, int bodies) {
        relax(impulse, true);
        double fastest = 0;
        double exchanged = 0;
        for (int k = 0; k < points; k++) {
            fastest = Math.max(fastest, Math.abs(impacts[k].belt));
            exchanged += Math.abs(impulse[2 * k + 1] * impacts[k].belt);
        }
        if (fastest == 0 || !isWedged(fastest, exchanged, before, body, bodies)) {
            return;
        }
        reset(before, bodies);
        Arrays.fill(impulse, 0, 2 * points, 0);
        for (int k = 0; k < points; k++) {
            impacts[k].belt = 0;
        }
        relax(impulse, true);
    }

    /** Whether bodies gain more than surfaces give them that make them as fast as the fastest of these, or are given or lose much more. */
    private boolean isWedged(double fastest, double exchanged, double[][] before, int[] body, int bodies) {
        double gained = 0;
        double bearable = 0;
        for (int k = 0; k < bodies; k++) {
            double w = state.w().values()[State.BLOCK * body[k]];
            double square = square(before[k], body[k]);
            gained += 0.5 * (square(velocity[k], body[k]) - square);
            bearable += w > 0 ? fastest * (fastest + Math.sqrt(square * w)) / w : 0;
        }
        return gained > bearable || exchanged > RUBBED * bearable;
    }

    /** Twice the kinetic energy of a body with a velocity. */
    private double square(double[] v, int body) {
        double sum = 0;
        for (int c = 0; c < State.BLOCK; c++) {
            double w = state.w().values()[State.BLOCK * body + c];
            sum += w > 0 ? v[c] * v[c] / w : 0;
        }
        return sum;
    }

    private void reset(double[][] before, int bodies) {
        for (int k = 0; k < bodies; k++) {
            System.arraycopy(before[k], 0, velocity[k], 0, before[k].length);
        }
    }

    /** Goes on from the compression, if points bounce; false if no friction acts. */
    private boolean compressed(double[][] before, int bodies, double allowance) {
        boolean bounces = false;
        double most = 0;
        double friction = 0;
        for (int k = 0; k < points; k++) {
            bounces |= impacts[k].restitution > 0;
            most = Math.max(most, impulse[2 * k]);
            friction = Math.max(friction, Math.abs(impulse[2 * k + 1]));
        }
        if (bounces && friction > NONE * most) {
            restore(before, copy(velocity, bodies), allowance);
        }
        return !bounces || friction > NONE * most;
    }

    private static double[][] copy(double[][] velocity, int bodies) {
        double[][] copy = new double[bodies][];
        for (int k = 0; k < bodies; k++) {
            copy[k] = velocity[k].clone();
        }
        return copy;
    }

    /** Gives parts of the normal impulses once more, and what friction they allow. */
    private void restore(double[][] before, double[][] compressed, double allowance) {
        double[] back = new double[2 * points];
        for (int k = 0; k < points; k++) {
            back[2 * k] = impacts[k].restitution * impulse[2 * k];
            load(k);
            push(2 * k, back[2 * k]);
        }
        relax(back, false);
        double gained = 0.5 * (work(impulse, before) + work(impulse, compressed)) - allowance;
        double rate = work(back, compressed);
        double square = 0.5 * (work(back, velocity) - rate);
        boolean isTooMuch = square > 0 && gained + rate + square > 0;
        double part = isTooMuch ? Math.max(0, Math.sqrt(Math.max(0, rate * rate - 4 * square * gained)) - rate) / (2 * square) : 1;
        for (int row = 0; row < 2 * points; row++) {
            impulse[row] += Math.min(1, part) * back[row];
        }
    }

    /** Impulses times the velocities at their points. */
    private double work(double[] by, double[][] at) {
        double sum = 0;
        for (int k = 0; k < points; k++) {
            impacts[k].setVelocities(first[k] < 0 ? null : at[first[k]], second[k] < 0 ? null : at[second[k]]);
            sum += by[2 * k] * impacts[k].normalVelocity() + by[2 * k + 1] * impacts[k].tangentVelocity();
        }
        return sum;
    }

    private void begin() {
        if (impulse.length < 2 * points) {
            impulse = new double[2 * points];
            mobility = new double[2 * points];
        }
        Arrays.fill(impulse, 0, 2 * points, 0);
        for (int k = 0; k < points; k++) {
            Impact c = impacts[k];
            boolean alone = replies == null;
            mobility[2 * k] = alone ? c.normalMobility() : replies.normalMobility(first[k], second[k], c, k);
            mobility[2 * k + 1] = alone ? c.tangentMobility() : replies.tangentMobility(first[k], second[k], c, points + k);
        }
    }

    /**
     * Changes impulses until they are right: all, or those along tangents alone. Of all, first those along normals, so that friction which
     * nothing calls for is none: two points of an edge that falls flat would else pull against each other.
     */
    private void relax(double[] impulse, boolean isAll) {
        if (isAll) {
            relax(impulse, 0, 1, relax(impulse, 0, 2, 0));
        } else {
            relax(impulse, 1, 2, 0);
        }
    }

    /**
     * Changes those of some rows: from one on, each, or each second one.
     *
     * @param before the largest change of velocity in sweeps before these
     * @return the largest one in any
     */
    private double relax(double[] impulse, int from, int step, double before) {
        int sweeps = Math.max(LEAST_SWEEPS, Math.min(SWEEPS, WORK / points));
        double largest = before;
        for (int sweep = 0; sweep < sweeps; sweep++) {
            double most = 0;
            for (int row = from; row < 2 * points; row += step) {
                load(row / 2);
                double change = change(impulse, row);
                push(row, change);
                most = Math.max(most, Math.abs(change) * mobility[row]);
            }
            largest = Math.max(largest, most);
            if (most <= RIGHT * largest) {
                break;
            }
        }
        return largest;
    }

    private void load(int k) {
        impacts[k].setVelocities(first[k] < 0 ? null : velocity[first[k]], second[k] < 0 ? null : velocity[second[k]]);
    }

    /** What makes a row right, even ones along normals, the next ones along tangents: a change of its impulse. */
    private double change(double[] impulse, int row) {
        if (!(mobility[row] > 0)) {
            return 0; // ties hold the point where it is
        }
        Impact c = impacts[row / 2];
        boolean tangential = (row & 1) != 0;
        double old = impulse[row];
        double wanted = old - (tangential ? c.tangentVelocity() : c.normalVelocity()) / mobility[row];
        double most = tangential ? (c.sticky ? STICKS : c.friction) * impulse[row - 1] : 0;
        impulse[row] = tangential ? Math.max(-most, Math.min(most, wanted)) : Math.max(0, wanted);
        return impulse[row] - old;
    }

    private void push(int row, double change) {
        int k = row / 2;
        boolean tangential = (row & 1) != 0;
        if (replies != null) {
            replies.apply(tangential ? points + k : k, change, velocity);
            return;
        }
        impacts[k].jn = tangential ? 0 : change;
        impacts[k].jt = tangential ? change : 0;
        impacts[k].apply();
        impacts[k].getVelocities(first[k] < 0 ? null : velocity[first[k]], second[k] < 0 ? null : velocity[second[k]]);
    }
}
