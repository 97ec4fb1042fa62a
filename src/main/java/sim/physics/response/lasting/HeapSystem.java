// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.util.Arrays;
import sim.physics.motion.SwitchedRow;

/**
 * The contact points of a heap and the impulses that they bear in one step: the complementarity problem of Moreau's time
 * stepping, of velocities at the end of the step,
 *
 * <pre>
 *   λₙ ≥ 0,  vₙ ≥ bₙ,  λₙ (vₙ − bₙ) = 0,    |λₜ| ≤ μ λₙ,  λₜ opposes vₜ
 * </pre>
 *
 * <p>solved by a {@link HeapSolver}.
 */
final class HeapSystem extends HeapPoints {
    private static final long serialVersionUID = 1L;

    /** Mobility of a tied body's point that is none, relative to that of the body alone. */
    private static final double IMMOBILE = 1e-7;

    /** Inverse masses and moments of inertia, 2 per body; and velocities, 3 per body. */
    double[] w = new double[16];

    double[] v = new double[24];

    /** All points, and those of contacts: the others are motors and stops, with a normal of their own and no friction. */
    private int points;

    private int contacts;
    private int count;

    /** Null until a body is tied to others. */
    private HeapReplies replies;

    private boolean tied;
    private final HeapSolver solver = new HeapSolver();
    final HeapShare share = new HeapShare();

    /** Inverse masses of 1. */
    private double[] units = {};

    private final HeapTolerance tolerance = new HeapTolerance();

    /** Whether little work is to be spent. */
    private boolean spared;

    /** The velocities without impulses. */
    private double[] free = {};

    private double[] scratch = {};

    private final PointRows rows = new PointRows();
    private final PointRows middle = new PointRows();
    private boolean isTurned;

    /** Points that are looked at or pushed in the time of a unit of work. */
    private static final int AT_ONCE = 4;

    /** The same of multiplications in the time of a point. */
    private static final int MULTIPLICATIONS = 32;

    /** What solutions have cost, in units of {@link sim.physics.internal.Work}, and points that were passed in sweeps beside. */
    private long cost;

    private long passed;

    HeapSystem() {}

    void clear() {
        points = 0;
        contacts = 0;
        tied = false;
        spared = false;
        isTurned = false;
        solver.forget();
        tolerance.clear();
        count = 0;
        if (replies != null) {
            replies.begin();
        }
    }

    /** Which errors of velocities are good enough, and that of the last solution. */
    HeapTolerance tolerance() {
        return tolerance;
    }

    /** Puts back the velocities without impulses. */
    void again() {
        System.arraycopy(free, 0, v, 0, 3 * count);
    }

    /** Takes the velocities at hand for those without impulses. */
    void renew() {
        free = free.length < v.length ? new double[v.length] : free;
        System.arraycopy(v, 0, free, 0, 3 * count);
    }

    /** Makes room for one more body, and gives it its inverse masses. */
    void enter(int place, double inverseMass, double inverseInertia) {
        if (v.length < 3 * place + 3) {
            v = Arrays.copyOf(v, 6 * place + 6);
            w = Arrays.copyOf(w, 4 * place + 4);
        }
        count = place + 1;
        w[2 * place] = inverseMass;
        w[2 * place + 1] = inverseInertia;
    }

    int size() {
        return points;
    }

    int contacts() {
        return contacts;
    }

    /** Adds a contact's point between two bodies, −1 for what cannot move. */
    void add(int a, int b, ContactPoint c) {
        rows.set(points, a, b, c);
        add(c.friction, c.normalMobility, c.tangentMobility, 0, Double.POSITIVE_INFINITY);
        data[STRIDE * (points - 1) + BELT] = c.belt;
        contacts = points;
    }

    /** Adds the momenta that a point's impulses give. */
    void pushUnits(int p, double jn, double jt, double[] out) {
        rows.pushSecond(p, jn, jt, units(), out);
        rows.pushFirst(p, jn, jt, units, out);
    }

    private double[] units() {
        if (units.length < 2 * count) {
            units = new double[4 * count];
            Arrays.fill(units, 1);
        }
        return units;
    }

    /** Takes note that the last solution is none to begin the next one with. */
    void restart() {
        solver.restart();
    }

    /** Puts the velocities in their place that the impulses give. */
    void refresh() {
        again();
        applyAll();
    }

    /** Takes all impulses to an array, or a larger one. */
    double[] impulses(double[] to) {
        double[] out = to.length < 2 * points ? new double[4 * points] : to;
        for (int p = 0; p < points; p++) {
            out[2 * p] = data[STRIDE * p + IMPULSE_N];
            out[2 * p + 1] = data[STRIDE * p + IMPULSE_T];
        }
        return out;
    }

    /** Puts all impulses in their place, and the velocities that they give. */
    void put(double[] impulses) {
        for (int p = 0; p < points; p++) {
            start(p, impulses[2 * p], impulses[2 * p + 1]);
        }
        refresh();
    }

    /** Adds a motor or a stop, behind all contacts, between two bodies of the heap; sign −1 for the upper stop. */
    void add(int a, int b, SwitchedRow row, double sign, double least, double most) {
        rows.set(points, a, b, row, sign);
        add(0, rows.wholeMobility(points, w), Double.POSITIVE_INFINITY, least, most);
    }

    private void add(double friction, double alongNormal, double alongTangent, double least, double most) {
        int o = STRIDE * points;
        if (data.length < o + STRIDE) {
            data = Arrays.copyOf(data, 2 * o + STRIDE);
        }
        data[o + FRICTION] = friction;
        data[o + MOBILITY_N] = alongNormal;
        data[o + MOBILITY_T] = alongTangent;
        data[o + CROSS] = rows.crossMobility(points, w);
        data[o + IMPULSE_N] = 0;
        data[o + IMPULSE_T] = 0;
        data[o + LEAST] = least;
        Arrays.fill(data, o + DRIFT, o + STRIDE, 0);
        data[o + MOST] = most;
        if (replies != null) {
            replies.clear(points);
        }
        points++;
    }

    /** How fast surfaces move on one another beside the bodies: what they give would else count as gained for nothing. */
    double fastestBelt() {
        double most = 0;
        for (int p = 0; p < contacts; p++) {
            most = Math.max(most, Math.abs(belt(p)));
        }
        return most;
    }

    /** Lets no surface move from now on: what belts have wedged has no forces that would let them go on. */
    void stopBelts() {
        for (int p = 0; p < contacts; p++) {
            data[STRIDE * p + BELT] = 0;
        }
    }

    /** The same, and forgets the impulses if one does: bodies between two surfaces bear any. Those of driven bodies are kept. */
    void unwedge(boolean isDriven) {
        if (isDriven) {
            stopBelts();
        } else if (fastestBelt() > 0) {
            stopBelts();
            startFromNothing();
            restart();
        }
    }

    void removeLast() {
        points--;
    }

    /** The replies of bodies that are tied to others, to points that were added. */
    HeapReplies replies() {
        tied = true;
        if (replies == null) {
            replies = new HeapReplies();
            for (int p = 0; p < points; p++) {
                replies.clear(p);
            }
        }
        return replies;
    }

    PointRows rows() {
        return rows;
    }

    /** The rows of contacts along which their impulses act, if those are not where they are now; to be filled. */
    PointRows middle() {
        isTurned = true;
        return middle;
    }

    /** Lets impulses act where points are now, from now on. */
    void straighten() {
        isTurned = false;
        for (int p = 0; p < contacts; p++) {
            turn(p, 0, 0);
        }
    }

    /** The rows of contacts along which their impulses act. */
    PointRows pressing() {
        return isTurned ? middle : rows;
    }

    /** Spends next to no work from now on: it has been in vain. */
    void spare() {
        spared = true;
    }

    /** Whether impulses have jammed: what ties hardly let move gets any amount where friction locks it. */
    boolean jams() {
        return tied && solver.jams();
    }

    /** Speed that the last impulses would give bodies which nothing tied, if together they do next to nothing beside that; else 0. */
    double strain() {
        return tied ? solver.strain() : 0;
    }

    /** Whether the last solution was found at once. */
    boolean wasEasy() {
        return solver.wasEasy();
    }

    boolean isSpared() {
        return spared;
    }

    /** Whether bodies are tied to others. */
    boolean isTied() {
        return tied;
    }

    /** Takes note that replies of a point have been set. */
    void measure(int p) {
        double[] v = scratch();
        Arrays.fill(v, 0, 3 * count, 0);
        push(p, 1, 0, v);
        measure(STRIDE * p + MOBILITY_N, normal(p, v));
        if (p < contacts) {
            Arrays.fill(v, 0, 3 * count, 0);
            push(p, 0, 1, v);
            measure(STRIDE * p + MOBILITY_T, tangent(p, v));
        }
    }

    /** A body that its ties hold where it is can be given no impulse. */
    private void measure(int at, double mobility) {
        data[at] = mobility > IMMOBILE * data[at] ? mobility : Double.POSITIVE_INFINITY;
    }

    /** Room for velocities that nobody keeps. */
    double[] scratch() {
        if (scratch.length < 3 * count) {
            scratch = new double[v.length];
        }
        return scratch;
    }

    /** Takes the momenta that the impulses give to bodies, whatever their masses, to an array. */
    void momenta(double[] out) {
        Arrays.fill(out, 0, 3 * count, 0);
        pushAlone(units(), out);
    }

    /** Starts all points from no impulses. */
    void startFromNothing() {
        for (int p = 0; p < points; p++) {
            start(p, 0, 0);
        }
    }

    /** Lets contacts bear nothing, and motors and stops what they do. */
    void liftContacts() {
        for (int p = 0; p < contacts; p++) {
            start(p, 0, 0);
        }
        restart();
    }

    double normal(int p) {
        return normal(p, v) + data[STRIDE * p + TURN_N];
    }

    /** The velocity along the tangent that friction is to take, where its impulses are enough. */
    double tangent(int p) {
        return tangent(p, v) + data[STRIDE * p + DRIFT] + data[STRIDE * p + TURN_T] + data[STRIDE * p + BELT];
    }

    /** Normal velocity of a point. */
    double normal(int p, double[] v) {
        return rows.normal(p, v);
    }

    /** Tangential velocity of a point. */
    double tangent(int p, double[] v) {
        return rows.tangent(p, v);
    }

    int bodyCount() {
        return count;
    }

    void apply(int p, double jn, double jt) {
        push(p, jn, jt, v);
    }

    /** Adds what a point's impulses do to velocities. */
    void push(int p, double jn, double jt, double[] v) {
        if (replies == null || !replies.push(2 * p + 1, jn, jt, v)) {
            rows.pushSecond(p, jn, jt, w, v);
        }
        if (replies == null || !replies.push(2 * p, jn, jt, v)) {
            rows.pushFirst(p, jn, jt, w, v);
        }
    }

    /** Takes from the velocities what the points' impulses do. */
    void unpush() {
        for (int p = 0; p < points; p++) {
            push(p, -data[STRIDE * p + IMPULSE_N], -data[STRIDE * p + IMPULSE_T], v);
        }
    }

    /** Adds what all contacts' impulses would do to bodies that nothing ties. */
    void pushAlone(double[] v) {
        pushAlone(w, v);
    }

    private void pushAlone(double[] w, double[] v) {
        PointRows r = pressing();
        for (int p = 0; p < contacts; p++) {
            r.pushSecond(p, data[STRIDE * p + IMPULSE_N], data[STRIDE * p + IMPULSE_T], w, v);
            r.pushFirst(p, data[STRIDE * p + IMPULSE_N], data[STRIDE * p + IMPULSE_T], w, v);
        }
    }

    /**
     * Solves for the impulses.
     *
     * @param scale speed beside which errors are judged
     * @param regains whether points may have to part, for gaps that are too small
     * @return whether the impulses are right or nearly so
     */
    boolean solve(double scale, boolean regains) {
        begin(regains);
        return solver.solve(this, scale, 0, tolerance.enough());
    }

    /** The same if the impulses that there are are wrong by more than an error of velocities; these stay to the bit if not. */
    boolean solveUnlessFair(double scale, double fair) {
        begin(true);
        return solver.solve(this, scale, fair, tolerance.enough());
    }

    /** Error of velocities with the impulses that the last solution was started from; infinite if that is not known. */
    double missed() {
        return solver.missed(this);
    }

    /** The same with impulses that are bounded in any case: no point has to part, and all are a little soft. Begins without any impulses. */
    boolean solveSoftly(double scale) {
        startFromNothing();
        begin(false);
        return solver.solveSoftly(this, scale, tolerance.enough());
    }

    /** The same where a body fills all the room between two walls; false if none does, or nothing is found. No gap is to be regained there. */
    boolean solveSqueezed() {
        if (!Squeezed.yields(this)) {
            return false;
        }
        begin(true);
        startFromNothing();
        return share.solve(this);
    }

    /** The same with little work. */
    boolean solveInTurn(double scale) {
        begin(true);
        return solver.solveInTurn(this, scale, tolerance.enough());
    }

    private void begin(boolean regains) {
        tolerance.setError(0);
        count();
        if (regains) {
            renew();
        } else {
            again();
            regainNothing();
        }
    }

    /** Counts what a solution costs beside what is counted as it is done, in sweeps and in the matrix of rows to which ties reply. */
    private void count() {
        long rows = 2L * contacts + (points - contacts);
        long eliminated = HeapRows.fits(this) ? 0 : rows / 32 + rows * rows / 2048;
        cost += tied ? rows * (count / 4 + eliminated) : 16 * rows;
    }

    /** Counts that all points were passed, some times. */
    void pass(int times) {
        passed += (long) times * points;
    }

    /** What solutions have cost since this was asked last, in units of {@link sim.physics.internal.Work}. */
    long takeCost() {
        passed += solver.takeDone() / MULTIPLICATIONS;
        long taken = cost + passed / AT_ONCE;
        cost = 0;
        passed %= AT_ONCE;
        return taken;
    }

    /** Lets no point have to part from now on. */
    void regainNothing() {
        for (int p = 0; p < points; p++) {
            int o = STRIDE * p;
            if (!isMotor(p)) {
                data[o + BOUND] = Math.min(0, data[o + BOUND]);
                data[o + DRIFT] = 0;
            }
        }
    }

    /** Adds to the velocities what all impulses do. */
    void applyAll() {
        for (int p = 0; p < points; p++) {
            int o = STRIDE * p;
            if (data[o + IMPULSE_N] != 0 || data[o + IMPULSE_T] != 0) {
                apply(p, data[o + IMPULSE_N], data[o + IMPULSE_T]);
            }
        }
    }

    /** The velocities without impulses. */
    double[] free() {
        return free;
    }
}
