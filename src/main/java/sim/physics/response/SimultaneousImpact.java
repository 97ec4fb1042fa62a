// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.motion.State;
import sim.physics.motion.Ties;

/**
 * Impacts at several points at the same instant, solved as one problem.
 *
 * <p>The impulses λ ≥ 0 along the normals are those that would just stop the approach,
 *
 * <pre>
 *   λ ≥ 0,   A λ + b ≥ 0,   λ·(A λ + b) = 0,   A = J W Jᵀ,   b = J v
 * </pre>
 *
 * <p>made larger by 1 + e: a <i>generalized reflection</i> (Smith, Kaufman, Vouga, Tamstorf and Grinspun, <i>Reflections
 * on simultaneous impact</i>, 2012). At e = 1 it keeps the energy exactly, it treats mirror images alike, and points
 * that approach again afterwards are simply the next impact at the same instant, so that a momentum passes through a
 * row of touching balls. Where points are redundant the λ of least norm is taken.
 *
 * <p>Sums over the points of a body and residuals are formed with twice the precision, so that the result does not
 * depend on the order of the points. Points that no movable body connects are problems of their own ({@link ApartImpacts}).
 */
final class SimultaneousImpact implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private int points;
    private int[] bodyA = new int[8];
    private int[] bodyB = new int[8];
    private Impact[] impacts = new Impact[8];

    private int bodies;
    private int[] body = new int[8];
    private double[][] velocity = new double[8][3];

    /** The place of each body of the state among them, plus 1; 0 if it is not there. */
    private transient int[] places;

    private final TwoBodyImpulse single = new TwoBodyImpulse();

    private final PushingPoints pushing = new PushingPoints();

    /** Velocity along the normal before the impact, by point. */
    private double[] before = new double[8];

    /** Null while nothing ties bodies together; and whether a body of this impact is tied. */
    private Ties ties;

    private boolean tied;
    private BorderedJoints bordered;

    /** Null until there is friction at several points. */
    private RoughImpact rough;

    /** Null until tied bodies collide. */
    private TiedImpactEnergy energy;

    /** What a unit of each point's impulse does to the velocities of all bodies: by points, then by bodies. */
    private final Replies replies = new Replies();

    SimultaneousImpact(State state) {
        this.state = state;
    }

    void setTies(Ties ties) {
        this.ties = ties;
    }

    void clear() {
        if (places == null || places.length < state.size()) {
            places = new int[places == null ? state.size() : Growth.length(places.length, state.size())];
        } else {
            for (int k = 0; k < bodies; k++) {
                places[body[k]] = 0;
            }
        }
        points = 0;
        bodies = 0;
        tied = false;
    }

    int bodyCount() {
        return bodies;
    }

    int body(int k) {
        return body[k];
    }

    double[] velocity(int k) {
        return velocity[k];
    }

    int pointCount() {
        return points;
    }

    int bodyA(int k) {
        return bodyA[k];
    }

    int bodyB(int k) {
        return bodyB[k];
    }

    /** Speed at which the surfaces approached at a point. */
    double approach(int k) {
        return -before[k];
    }

    /** Copies a point into an impact. */
    void get(int k, Impact to) {
        to.copy(impacts[k]);
    }

    /** Adds a point. */
    void add(int a, int b, Impact impact) {
        if (points == impacts.length) {
            grow();
        }
        if (impacts[points] == null) {
            impacts[points] = new Impact();
        }
        impacts[points].copy(impact);
        bodyA[points] = a;
        bodyB[points] = b;
        points++;
        if (impact.wA != 0) {
            note(a, impact.vAx, impact.vAy, impact.omegaA);
        }
        if (impact.wB != 0) {
            note(b, impact.vBx, impact.vBy, impact.omegaB);
        }
    }

    /** Notes a body, and those that are tied to it, whose velocities the state vectors hold. */
    private void note(int index, double vx, double vy, double omega) {
        if (place(index) >= 0) {
            return;
        }
        if (ties == null || !ties.isTied(index)) {
            noteOne(index, vx, vy, omega);
            return;
        }
        tied = true;
        IntList island = ties.island(index);
        for (int k = 0; k < island.size; k++) {
            int s = State.BLOCK * island.values[k];
            double[] v = state.v();
            noteOne(island.values[k], v[s], v[s + 1], v[s + 2]);
        }
    }

    private void noteOne(int index, double vx, double vy, double omega) {
        if (bodies == body.length) {
            body = Arrays.copyOf(body, 2 * bodies);
            velocity = Arrays.copyOf(velocity, 2 * bodies);
            for (int k = bodies; k < velocity.length; k++) {
                velocity[k] = new double[3];
            }
        }
        body[bodies] = index;
        velocity[bodies][0] = vx;
        velocity[bodies][1] = vy;
        velocity[bodies][2] = omega;
        places[index] = ++bodies;
    }

    /** The place of a body, −1 if it is fixed. */
    private int place(int index) {
        return places[index] - 1;
    }

    /** The place of a body, or that of the first of those that are tied to it; −1 if it is fixed. */
    int placeOfIsland(int index) {
        return place(tied && ties.isTied(index) ? ties.island(index).values[0] : index);
    }

    boolean isOfOnePair() {
        boolean yes = true;
        for (int k = 1; yes && k < points; k++) {
            yes = bodyA[k] == bodyA[0] && bodyB[k] == bodyB[0];
        }
        return yes;
    }

    /** Adds a point of these to others. */
    void give(int k, SimultaneousImpact to) {
        to.add(bodyA[k], bodyB[k], impacts[k]);
    }

    /** Takes the impulses of a point that was solved among others. */
    void take(int k, SimultaneousImpact from, int m) {
        impacts[k].copy(from.impacts[m]);
        before[k] = from.before[m];
    }

    void takeVelocities(SimultaneousImpact from) {
        for (int k = 0; k < from.bodies; k++) {
            System.arraycopy(from.velocity[k], 0, velocity[place(from.body[k])], 0, 3);
        }
    }

    /** Chooses the write-up's bordered system for impacts of one point without friction on jointed bodies. */
    void setBordered(boolean yes) {
        bordered = yes ? new BorderedJoints() : null;
    }

    /** Solves for the impulses and gives the bodies their new velocities. */
    void solve() {
        boolean isWatched = tied && bordered == null;
        if (isWatched) {
            energy = energy == null ? new TiedImpactEnergy(state) : energy;
            energy.begin(velocity, bodies);
        }
        solveAll();
        for (int k = 0; isWatched && k < points; k++) {
            energy.add(impacts[k], place(bodyA[k]), place(bodyB[k]), approach(k), pushing.matrix[k * points + k]);
        }
        if (isWatched) {
            energy.limit(body, velocity, impacts, points);
        }
    }

    private void solveAll() {
        Impact only = impacts[0];
        if (bordered != null && tied && points == 1 && only.friction == 0 && !only.sticky) {
            before[0] = only.normalVelocity();
            bordered.solve(only, bodyA[0], bodyB[0], body, velocity, bodies, state, ties);
            return;
        }
        if (!tied && isOnePoint()) {
            solveOne();
            return;
        }
        assemble();
        if (tied && points == 1 && only.friction > 0 && only.isEarly && !only.sticky && rubOne()) {
            return;
        }
        if (RoughImpact.isRough(impacts, points) && (!tied || !isHeld()) && solveRough()) {
            return;
        }
        pushing.solve();
        double least = impacts[0].restitution;
        boolean uniform = true;
        for (int k = 0; k < points; k++) {
            double e = impacts[k].restitution;
            uniform &= e == least;
            least = Math.min(least, e);
        }
        for (int k = 0; k < points; k++) {
            double e = impacts[k].restitution;
            impacts[k].jn = (1 + e) * pushing.lambda[k];
            impacts[k].jt = 0;
        }
        if (!uniform && energyGain() > allowance()) {
            for (int k = 0; k < points; k++) {
                impacts[k].jn = (1 + Math.min(1, least)) * pushing.lambda[k];
            }
        }
        apply();
        rub();
    }

    /** Whether all points are one, such as a corner on a seam: of the same movable bodies, of one place and of one law. */
    private boolean isOnePoint() {
        boolean yes = points > 1 && (bodies == 1 || isOfOnePair());
        Impact one = impacts[0];
        for (int k = 1; yes && k < points; k++) {
            yes = one.isSame(impacts[k]);
        }
        return yes;
    }

    /** A corner feels no seam: the points share what one would get. */
    private void solveOne() {
        Impact one = impacts[0];
        double speed = one.normalVelocity();
        single.solve(one);
        double jn = one.jn / points;
        double jt = one.jt / points;
        one.apply();
        int a = place(bodyA[0]);
        int b = place(bodyB[0]);
        one.getVelocities(a < 0 ? null : velocity[a], b < 0 ? null : velocity[b]);
        for (int k = 0; k < points; k++) {
            before[k] = speed;
            impacts[k].jn = jn;
            impacts[k].jt = jt;
        }
    }

    /**
     * One point of tied bodies has, before their impacts are many in a step, the law of {@link TwoBodyImpulse}, with what the ties reply;
     * false if they hold the point.
     */
    private boolean rubOne() {
        Impact one = impacts[0];
        int a = place(bodyA[0]);
        int b = place(bodyB[0]);
        replies.find(1, bodyA[0], bodyB[0], one, true);
        double kn = replies.normalMobility(a, b, one, 0);
        double kt = replies.tangentMobility(a, b, one, 1);
        if (!(kn > 0 && kt > 0)) {
            return false;
        }
        TwoBodyImpulse.rubTied(one, kn, kt, replies.normal(a, b, one, 1));
        replies.apply(0, one.jn, velocity);
        replies.apply(1, one.jt, velocity);
        return true;
    }

    /** Whether a point bounces that ties hold but for next to nothing: the least impulses are taken there. */
    private boolean isHeld() {
        boolean is = false;
        for (int k = 0; k < points; k++) {
            double mobility = pushing.matrix[k * points + k];
            is |= impacts[k].restitution > 0 && mobility <= TiedImpactEnergy.HELD * impacts[k].normalMobility();
        }
        return is;
    }

    private boolean solveRough() {
        rough = rough == null ? new RoughImpact(state) : rough;
        int[] placeA = new int[points];
        int[] placeB = new int[points];
        for (int k = 0; k < points; k++) {
            placeA[k] = place(bodyA[k]);
            placeB[k] = place(bodyB[k]);
            if (tied) {
                replies.find(points + k, bodyA[k], bodyB[k], impacts[k], true);
            }
        }
        return rough.solve(impacts, points, placeA, placeB, velocity, body, bodies, tied ? replies : null, allowance());
    }

    /** A = J W Jᵀ over the points, b = J v. */
    private void assemble() {
        pushing.begin(points);
        double[] matrix = pushing.matrix;
        for (int k = 0; tied && k < points; k++) {
            pushing.roundAt(impacts[k].normalMobility());
        }
        if (tied) {
            replies.begin(bodies, body, state, ties);
            for (int k = 0; k < points; k++) {
                replies.find(k, bodyA[k], bodyB[k], impacts[k], false);
            }
        }
        for (int i = 0; i < points; i++) {
            before[i] = impacts[i].normalVelocity();
            pushing.rhs[i] = before[i];
            for (int j = 0; j < points; j++) {
                matrix[i * points + j] = coupling(i, j);
            }
        }
        for (int k = 0; tied && k < points; k++) {
            if (replies.normalMobility(place(bodyA[k]), place(bodyB[k]), impacts[k], k) == 0) {
                hold(k);
            }
        }
    }

    /** Takes a point out that ties hold: it neither approaches nor can be given an impulse. */
    private void hold(int k) {
        double[] matrix = pushing.matrix;
        for (int j = 0; j < points; j++) {
            matrix[k * points + j] = 0;
            matrix[j * points + k] = 0;
        }
        matrix[k * points + k] = impacts[k].normalMobility();
        before[k] = 0;
        pushing.rhs[k] = 0;
    }

    private double coupling(int i, int j) {
        if (tied) {
            return replies.normal(place(bodyA[i]), place(bodyB[i]), impacts[i], j);
        }
        Impact p = impacts[i];
        Impact q = impacts[j];
        double sum = 0;
        if (bodyA[i] == bodyA[j]) {
            sum += mobility(p.nx, p.ny, p.leverA, q.nx, q.ny, q.leverA, p.wA, p.iA);
        }
        if (bodyB[i] == bodyB[j]) {
            sum += mobility(p.nx, p.ny, p.leverB, q.nx, q.ny, q.leverB, p.wB, p.iB);
        }
        if (bodyA[i] == bodyB[j]) {
            sum -= mobility(p.nx, p.ny, p.leverA, q.nx, q.ny, q.leverB, p.wA, p.iA);
        }
        if (bodyB[i] == bodyA[j]) {
            sum -= mobility(p.nx, p.ny, p.leverB, q.nx, q.ny, q.leverA, p.wB, p.iB);
        }
        return sum;
    }

    private static double mobility(
            double px, double py, double lp, double qx, double qy, double lq, double w, double i) {
        return w * (px * qx + py * qy) + i * (lp * lq);
    }

    /** Energy that bounces may add which are kept from getting too short; 0 where no restitution is above 1. */
    private double allowance() {
        double sum = 0;
        for (int k = 0; k < points; k++) {
            double e = impacts[k].restitution;
            sum += Math.max(0, e * e - 1) * before[k] * before[k] / (2 * pushing.matrix[k * points + k]);
        }
        return sum;
    }

    private double energyGain() {
        double gain = 0;
        for (int i = 0; i < points; i++) {
            double half = 0;
            for (int j = 0; j < points; j++) {
                half += pushing.matrix[i * points + j] * impacts[j].jn;
            }
            gain += impacts[i].jn * (before[i] + 0.5 * half);
        }
        return gain;
    }

    /** Adds each body's impulses, and gives it the velocity that they make. */
    private void apply() {
        for (int k = 0; k < bodies; k++) {
            for (int c = 0; c < 3; c++) {
                velocity[k][c] += change(body[k], c);
            }
        }
    }

    private double change(int index, int component) {
        double sum = 0;
        double low = 0;
        for (int k = 0; k < points; k++) {
            boolean isA = bodyA[k] == index;
            if (!tied && !isA && bodyB[k] != index) {
                continue;
            }
            double term = tied
                    ? impacts[k].jn * replies.get(k, place(index), component)
                    : impacts[k].change(isA, component);
            double next = sum + term;
            double part = next - sum;
            low += (sum - (next - part)) + (term - part);
            sum = next;
        }
        return sum + low;
    }

    /** Friction and sticking: one point after the other, each with at most what stops its sliding. */
    private void rub() {
        for (int k = 0; k < points; k++) {
            Impact c = impacts[k];
            if (c.friction == 0 && !c.sticky) {
                continue;
            }
            int a = place(bodyA[k]);
            int b = place(bodyB[k]);
            c.setVelocities(a < 0 ? null : velocity[a], b < 0 ? null : velocity[b]);
            double kt = c.tangentMobility();
            if (tied) {
                replies.find(k, bodyA[k], bodyB[k], c, true);
                kt = replies.tangentMobility(a, b, c, k);
            }
            double stop = kt > 0 ? -c.tangentVelocity() / kt : 0;
            double most = c.sticky ? Math.abs(stop) : c.friction * c.jn;
            c.jt = Math.max(-most, Math.min(most, stop));
            if (tied) {
                replies.apply(k, c.jt, velocity);
                continue;
            }
            double normal = c.jn;
            c.jn = 0;
            c.apply();
            c.jn = normal;
            c.getVelocities(a < 0 ? null : velocity[a], b < 0 ? null : velocity[b]);
        }
    }

    private void grow() {
        int n = 2 * points;
        bodyA = Arrays.copyOf(bodyA, n);
        bodyB = Arrays.copyOf(bodyB, n);
        impacts = Arrays.copyOf(impacts, n);
        before = new double[n];
    }
}
