// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.AX;
import static sim.physics.stepping.ContactRows.AY;
import static sim.physics.stepping.ContactRows.BELT;
import static sim.physics.stepping.ContactRows.BEND;
import static sim.physics.stepping.ContactRows.BX;
import static sim.physics.stepping.ContactRows.BY;
import static sim.physics.stepping.ContactRows.FRICTION;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NOW;
import static sim.physics.stepping.ContactRows.PAIR;
import static sim.physics.stepping.ContactRows.REGAIN;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT;
import static sim.physics.stepping.ContactRows.WEIGHT;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.motion.State;

/**
 * Solves the points of some rows at once: of each what presses it, and of each pair its friction, within bounds by what presses. So heavy bodies lie on
 * light ones and these on one another, and nothing depends on how unlike their masses are.
 */
final class UnlikeSet implements Serializable {
    private static final long serialVersionUID = 1L;

    /** By what part of its own each unknown is softer: where several do the same, they share what is new. More would be a gift of energy. */
    private static final double SHARES = 1e-12;

    /**
     * How often bounds of friction are found from what presses at most, and by what part they change when that has settled. From the third time on each is
     * the mean of the one before and of what presses now: else what holds a body by friction alone presses, and does not, by turns.
     */
    private static final int BOUNDS = 10;

    private static final int FULL = 2;

    private static final double SETTLED = 1e-3;

    /** By what part friction may be more than what presses lets it be. */
    private static final double EXCESS = 1e-6;

    /**
     * Depth under the weight of the heaviest body, relative to a tenth of the smaller one of a pair. Without any, those of several points that are on one
     * line and differ by rounding would bear all by turns.
     */
    private static final double YIELDS = 3e-3;

    /** And in columns, of which each point bears what it has to: as much more would let those of fifty bodies and more lean, and fall. */
    private static final double STANDS = 1e-5;

    /** Speed at which depth is regained, in units of what forces give in a substep: what lifts a heavy body is to be little of what it presses with. */
    private static final double LIFTS = 0.25;

    /** Values of an unknown: direction, and levers of the two bodies. */
    private static final int WAY = 4;

    private final State state;
    private final ContactRows rows;
    private final BoundedSystem system = new BoundedSystem();

    /** Length of the step, and of its substeps. */
    private double step;

    private double h;

    /** What the points of the set yield. */
    private double softness;

    /** The rows that are solved, where they begin and end; by row its first unknown. */
    private transient int[] order;

    private transient int from;
    private transient int to;
    private transient int[] firsts;

    /** By row its two bodies, −1 for one that cannot move. */
    private transient int[] bodies;

    /** By unknown: its direction and levers; by how much it gives way, as speed for an impulse. */
    private transient double[] ways;

    private transient double[] yields;

    UnlikeSet(State state, ContactRows rows) {
        this.state = state;
        this.rows = rows;
    }

    /** Begins a step. */
    void begin(double step, double h) {
        this.step = step;
        this.h = h;
    }

    /**
     * Solves rows of a list.
     *
     * @param from where they begin
     * @param to where they end
     * @param isColumn whether they are of a column
     * @param rate part of a depth that is regained in a unit of time
     * @param regains whether it is
     */
    void solve(int[] order, int from, int to, boolean isColumn, double rate, boolean regains) {
        softness = isColumn ? STANDS : YIELDS;
        this.order = order;
        this.from = from;
        this.to = to;
        number();
        for (int r = from; r < to; r++) {
            share(order[r]);
        }
        double weight = weight();
        for (int r = from; r < to; r++) {
            aim(r, rate, regains, weight);
        }
        fill();
        bound(0);
        system.solve();
        for (int turn = 1; turn < BOUNDS && bound(turn); turn++) {
            system.solve();
        }
        for (int turn = 0; turn < BOUNDS && settle(); turn++) {
            system.solve();
        }
        give();
    }

    private boolean isRough(int k) {
        return rows.normals[PAIR * k + FRICTION] > 0;
    }

    private void number() {
        int count = 0;
        if (firsts == null || firsts.length <= to - from) {
            firsts = new int[2 * (to - from + 1)];
            bodies = new int[2 * firsts.length];
        }
        double[] w = state.w().values();
        for (int r = from; r < to; r++) {
            int a = rows.first(order[r]);
            int b = rows.second(order[r]);
            firsts[r - from] = count;
            bodies[2 * (r - from)] = w[State.BLOCK * a] > 0 ? a : -1;
            bodies[2 * (r - from) + 1] = w[State.BLOCK * b] > 0 ? b : -1;
            count += rows.pointCount(order[r]) + (isRough(order[r]) ? 1 : 0);
        }
        firsts[to - from] = count;
        system.reserve(count);
        if (ways == null || ways.length < WAY * count) {
            ways = new double[2 * WAY * count];
            yields = new double[2 * count];
        }
    }

    /** The impulse of the heaviest body's weight, or the largest one that there is. */
    private double weight() {
        double[] w = state.w().values();
        double most = 0;
        for (int r = from; r < to; r++) {
            int k = order[r];
            double first = w[State.BLOCK * rows.first(k)];
            double second = w[State.BLOCK * rows.second(k)];
            double least = Math.min(first > 0 ? first : second, second > 0 ? second : first);
            most = Math.max(most, h * rows.normals[PAIR * k + WEIGHT] / least);
            for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
                most = Math.max(most, rows.points[p + NORMAL]);
            }
        }
        system.scale = most;
        return most;
    }

    /** What of the friction of a pair its first point bears: as much as of what presses. */
    private double part(int k) {
        int p = rows.begin(k);
        if (rows.pointCount(k) == 1) {
            return 1;
        }
        double sum = rows.points[p + NORMAL] + rows.points[p + STRIDE + NORMAL];
        return sum > 0 ? rows.points[p + NORMAL] / sum : 0.5;
    }

    /** Lets the points of a pair bear their parts of its friction. */
    private void share(int k) {
        double[] points = rows.points;
        int p = rows.begin(k);
        int q = rows.end(k) - STRIDE;
        double more = p == q ? 0 : part(k) * (points[p + TANGENT] + points[q + TANGENT]) - points[p + TANGENT];
        if (more != 0) {
            rows.give(k, p, state.v(), 0, more);
            rows.give(k, q, state.v(), 0, -more);
            points[p + TANGENT] += more;
            points[q + TANGENT] -= more;
        }
    }

    /** Finds what the unknowns of a row ask for. */
    private void aim(int r, double rate, boolean regains, double weight) {
        double[] points = rows.points;
        int k = order[r];
        double nx = rows.normals[PAIR * k];
        double ny = rows.normals[PAIR * k + 1];
        double regain = rows.normals[PAIR * k + REGAIN];
        int u = firsts[r - from];
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            double gap = points[p + NOW];
            double bend = regains ? 0.5 * h * points[p + BEND] : 0;
            boolean isDeep = regains && gap < 0 && gap + h * bend < 0;
            double lift = LIFTS * h * rows.normals[PAIR * k + WEIGHT];
            double aim = isDeep ? Math.max(rate * gap, -Math.min(regain, lift)) : regains || gap >= 0 ? gap / h : 0;
            yields[u] = isDeep ? Math.min(rate * softness * regain * step, 0.5 * lift) / weight : 0;
            point(u, k, nx, ny, points[p + AX], points[p + AY], points[p + BX], points[p + BY]);
            system.constant[u] += bend + aim + yields[u] * points[p + NORMAL];
            u++;
        }
        if (isRough(k)) {
            rub(u, k, nx, ny, regains ? 0.5 * h : 0);
        }
    }

    /** The friction of a pair, at the point where it acts in the mean. */
    private void rub(int u, int k, double nx, double ny, double ahead) {
        double[] v = state.v();
        double[] points = rows.points;
        int p = rows.begin(k);
        int q = rows.end(k) - STRIDE;
        double part = part(k);
        double ax = part * points[p + AX] + (1 - part) * points[q + AX];
        double ay = part * points[p + AY] + (1 - part) * points[q + AY];
        double bx = part * points[p + BX] + (1 - part) * points[q + BX];
        double by = part * points[p + BY] + (1 - part) * points[q + BY];
        double spin = v[State.BLOCK * rows.first(k) + 2];
        double turn = v[State.BLOCK * rows.second(k) + 2];
        double round = spin * spin * (nx * ay - ny * ax) - turn * turn * (nx * by - ny * bx);
        yields[u] = 0;
        point(u, k, -ny, nx, ax, ay, bx, by);
        system.constant[u] += rows.normals[PAIR * k + BELT] + ahead * round;
    }

    private void point(int u, int k, double dx, double dy, double ax, double ay, double bx, double by) {
        double[] v = state.v();
        int a = State.BLOCK * rows.first(k);
        int b = State.BLOCK * rows.second(k);
        double leverA = ax * dy - ay * dx;
        double leverB = bx * dy - by * dx;
        int o = WAY * u;
        ways[o] = dx;
        ways[o + 1] = dy;
        ways[o + 2] = leverA;
        ways[o + 3] = leverB;
        system.constant[u] = dx * (v[b] - v[a]) + dy * (v[b + 1] - v[a + 1]) + leverB * v[b + 2] - leverA * v[a + 2];
        system.x[u] = 0;
    }

    /** Finds what each unknown does to those before it. */
    private void fill() {
        double[] w = state.w().values();
        for (int r = 0; r < to - from; r++) {
            int a = bodies[2 * r];
            int b = bodies[2 * r + 1];
            int first = -1;
            for (int s = 0; s <= r; s++) {
                boolean isNear = isShared(a, s) || isShared(b, s);
                first = isNear && first < 0 ? firsts[s] : first;
                if (isNear) {
                    fill(r, s, w);
                } else if (first >= 0) {
                    clear(r, s);
                }
            }
            for (int u = firsts[r]; u < firsts[r + 1]; u++) {
                int own = u * system.room + u;
                system.begins[u] = first;
                system.matrix[own] += SHARES * system.matrix[own] + yields[u];
            }
        }
    }

    /** Whether a row has a body, or its second one; nothing that cannot move is shared. */
    private boolean isShared(int body, int row) {
        return body >= 0 && (body == bodies[2 * row] || body == bodies[2 * row + 1]);
    }

    /** What impulses of a row do to one before it, with which it shares a body. */
    private void fill(int r, int s, double[] w) {
        int a = bodies[2 * r];
        int b = bodies[2 * r + 1];
        int c = bodies[2 * s];
        int d = bodies[2 * s + 1];
        double mass = shared(w, a, c, 0) + shared(w, b, d, 0) - shared(w, a, d, 0) - shared(w, b, c, 0);
        double ac = shared(w, a, c, 2);
        double ad = shared(w, a, d, 2);
        double bc = shared(w, b, c, 2);
        double bd = shared(w, b, d, 2);
        for (int u = firsts[r]; u < firsts[r + 1]; u++) {
            int i = WAY * u;
            for (int q = firsts[s]; q < firsts[s + 1] && q <= u; q++) {
                int j = WAY * q;
                system.matrix[u * system.room + q] = mass * (ways[i] * ways[j] + ways[i + 1] * ways[j + 1])
                        + ways[i + 2] * (ac * ways[j + 2] - ad * ways[j + 3]) + ways[i + 3] * (bd * ways[j + 3] - bc * ways[j + 2]);
            }
        }
    }

    /** An inverse mass of a body, if it is another one too; 0 if not. */
    private static double shared(double[] w, int body, int other, int which) {
        return body >= 0 && body == other ? w[State.BLOCK * body + which] : 0;
    }

    /** Rows that share nothing do nothing to one another. */
    private void clear(int r, int s) {
        for (int u = firsts[r]; u < firsts[r + 1]; u++) {
            Arrays.fill(system.matrix, u * system.room + firsts[s], u * system.room + firsts[s + 1], 0);
        }
    }

    /** Sets the bounds, by what presses with what has been found for it; whether those of friction that matter have changed. */
    private boolean bound(int turn) {
        boolean isFirst = turn == 0;
        boolean changes = false;
        double[] points = rows.points;
        for (int r = from; r < to; r++) {
            int k = order[r];
            int u = firsts[r - from];
            for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
                system.low[u] = -points[p + NORMAL];
                system.high[u++] = Double.POSITIVE_INFINITY;
            }
            if (isRough(k)) {
                double tangent = rows.sum(k, TANGENT);
                double most = mostFriction(r);
                most = turn < FULL ? most : 0.5 * (most + system.high[u] + tangent);
                boolean slides = isFirst || Math.abs(tangent + system.x[u]) > most || system.x[u] == system.low[u] || system.x[u] == system.high[u];
                changes |= slides && (isFirst || Math.abs(system.high[u] + tangent - most) > SETTLED * most);
                system.low[u] = -most - tangent;
                system.high[u] = most - tangent;
            }
        }
        return changes;
    }

    /** Holds friction where it is, or at what it may be by what presses, if that is less; whether that is so of any. */
    private boolean settle() {
        boolean isLess = false;
        for (int r = from; r < to; r++) {
            if (isRough(order[r])) {
                int u = firsts[r - from + 1] - 1;
                double tangent = rows.sum(order[r], TANGENT);
                double most = mostFriction(r);
                double rubs = Math.max(-most, Math.min(most, tangent + system.x[u])) - tangent;
                isLess |= Math.abs(rubs - system.x[u]) > EXCESS * most;
                system.low[u] = rubs;
                system.high[u] = rubs;
            }
        }
        return isLess;
    }

    /** What the friction of a pair may be, by what presses with what has been found for it. */
    private double mostFriction(int r) {
        int k = order[r];
        int u = firsts[r - from];
        double presses = 0;
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            presses += Math.max(0, rows.points[p + NORMAL] + system.x[u++]);
        }
        return rows.normals[PAIR * k + FRICTION] * presses;
    }

    /** Gives the bodies what has been found. */
    private void give() {
        double[] points = rows.points;
        for (int r = from; r < to; r++) {
            int k = order[r];
            int u = firsts[r - from];
            double part = part(k);
            double rubs = isRough(k) ? system.x[firsts[r - from + 1] - 1] : 0;
            for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
                double normal = Math.max(0, points[p + NORMAL] + system.x[u++]);
                rows.give(k, p, state.v(), normal - points[p + NORMAL], part * rubs);
                points[p + NORMAL] = normal;
                points[p + TANGENT] += part * rubs;
                part = 1 - part;
            }
        }
    }
}
