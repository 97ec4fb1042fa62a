// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.motion.State;

/** The contacts of a step, in flat rows: pairs with their normals, and up to two points each, which {@link ContactSolver} solves. */
final class ContactRows implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values of a point. */
    static final int STRIDE = 27;

    static final int AX = 0;
    static final int AY = 1;
    static final int BX = 2;
    static final int BY = 3;
    /** The gap at the start. */
    static final int GAP = 4;

    static final int NORMAL_MASS = 5;
    static final int TANGENT_MASS = 6;
    static final int NORMAL = 7;
    static final int TANGENT = 8;
    /** Speed at which it opens at the start. */
    static final int APPROACH = 9;
    /** The part of what it has taken that a point gives once more. */
    static final int RESTORED = 10;

    static final int NORMAL_SUM = 11;
    static final int TANGENT_SUM = 12;
    static final int FORCED = 13;
    static final int FEATURE = 14;

    /** What turns of the bodies do to the gap, of first order, and of second: nothing to discs. */
    static final int LEVER_A = 15;

    static final int LEVER_B = 16;
    static final int ARM_A = 17;
    static final int ARM_B = 18;

    /** What an impulse along the normal changes of the speed along the tangent, and one along the tangent of that along the normal. */
    static final int COUPLING = 19;

    /** The impulse along the normal with which the last substep began, and what of those of this one is steady. */
    static final int LAST = 20;

    static final int STEADY = 21;
    static final int RUBBING = 22;

    /** The gap where the bodies are now. */
    static final int NOW = 23;

    /** Twice what turns of the bodies will add to the gap in a substep, by its square. */
    static final int BEND = 24;

    /** The gap at the start of the substep, and the speed at which it opened before an impact, of pairs that may strike. */
    static final int BEFORE = 25;

    static final int OPENING = 26;

    /**
     * Values of a pair: normal, friction, restitution, largest speed at which depth is regained, velocity of surfaces on one another, and
     * the friction that was asked for, and by how much forces accelerate the two along the normal, and at all.
     */
    static final int PAIR = 9;

    static final int FRICTION = 2;
    static final int BOUNCE = 3;
    static final int REGAIN = 4;
    static final int BELT = 5;
    static final int ASKED = 6;
    static final int LOAD = 7;
    static final int WEIGHT = 8;

    private final State state;

    /** The rows of each body, and what turns their normals. */
    final BodyRows byBody = new BodyRows(this);

    final ContactTurns turns;

    int count;
    /** Per pair: its number, its bodies, its first point and the one after its last. */
    int[] pairs = {};

    static final int INTS = 11;

    /** Whether the pair has bounced in this step. */
    static final int BOUNCED = 5;

    /** Whether it pressed in the step before. */
    static final int PRESSED = 6;

    /** Which of the two are discs: 1 the first one, 2 the second one, 3 both. */
    static final int DISCS = 7;

    static final int BOTH = 3;

    /** Whether the pair closes a gap faster than forces do. */
    static final int FAST = 8;

    /** Whether forces press a heavy body on a light one. */
    static final int UNLIKE = 9;

    /** Whether a body may be {@linkplain Crush crushed}. */
    static final int SUNK = 10;

    double[] normals = {};
    double[] points = {};

    /**
     * Per pair of discs, whose normal turns within the step: what the impulses of the step were more than their sums along the last normal;
     * and which part of that is of the last turn.
     */
    double[] turned = {};

    static final int TURNED = 4;
    int used;

    /** Number of pairs that may bounce. */
    int bounces;

    /** Number of pairs that close a gap faster than forces do. */
    int fast;

    /** Number of pairs that moving surfaces drive. */
    int driven;

    /** Number of pairs of a heavy body that forces press on a light one. */
    int unlike;

    /** Where the bodies were at the start of the step. */
    double[] from = {};

    ContactRows(State state) {
        this.state = state;
        turns = new ContactTurns(state, this);
    }

    /** Begins a step, with where the bodies are. */
    void begin() {
        byBody.forget();
        count = 0;
        used = 0;
        bounces = 0;
        driven = 0;
        unlike = 0;
        fast = 0;
        double[] x = state.x();
        if (from.length < x.length) {
            from = new double[x.length];
        }
        System.arraycopy(x, 0, from, 0, State.BLOCK * state.size());
    }

    /** The first of the values of a pair's first point, and the one after those of its last. */
    int begin(int k) {
        return STRIDE * pairs[INTS * k + 3];
    }

    int end(int k) {
        return STRIDE * pairs[INTS * k + 4];
    }

    int pair(int k) {
        return pairs[INTS * k];
    }

    int first(int k) {
        return pairs[INTS * k + 1];
    }

    int second(int k) {
        return pairs[INTS * k + 2];
    }

    /**
     * Adds a pair.
     *
     * @param belt velocity of the surfaces on one another along the tangent, beside that of the bodies
     * @param forces accelerations of all bodies
     * @param regain the largest speed at which depth is regained
     * @param hasPressed whether the two pressed on one another in the step before
     */
    void add(
            int pair, int a, int b, Touch touch,
            double friction, double restitution, double belt, double[] forces, double h, double regain, boolean hasPressed) {
        reserve();
        int o = INTS * count;
        pairs[o] = pair;
        pairs[o + 1] = a;
        pairs[o + 2] = b;
        pairs[o + 3] = used;
        pairs[o + BOUNCED] = 0;
        pairs[o + SUNK] = 0;
        pairs[o + PRESSED] = hasPressed ? 1 : 0;
        pairs[o + DISCS] = (touch.isDiscA ? 1 : 0) + (touch.isDiscB ? 2 : 0);
        int n = PAIR * count++;
        normals[n] = touch.nx;
        normals[n + 1] = touch.ny;
        normals[n + FRICTION] = friction;
        normals[n + BOUNCE] = restitution;
        bounces += restitution > 0 ? 1 : 0;
        normals[n + REGAIN] = regain;
        normals[n + BELT] = belt;
        normals[n + ASKED] = friction;
        load(count - 1, forces);
        driven += isDriven(count - 1) ? 1 : 0;
        Arrays.fill(turned, TURNED * (count - 1), TURNED * count, 0);
        for (int k = 0; k < touch.count; k++) {
            load(touch, k, State.BLOCK * a, State.BLOCK * b, forces);
        }
        pairs[o + 4] = used;
        pairs[o + FAST] = closes(count - 1, h) ? 1 : 0;
        fast += pairs[o + FAST];
        pairs[o + UNLIKE] = UnlikeRows.presses(state, a, b, touch, forces) ? 1 : 0;
        unlike += pairs[o + UNLIKE];
        turns.add(count - 1, touch, h);
    }

    /** Makes room for one more. */
    private void reserve() {
        if (INTS * (count + 1) > pairs.length) {
            int length = Growth.length(pairs.length / INTS, count + 1);
            pairs = Arrays.copyOf(pairs, INTS * length);
            normals = Arrays.copyOf(normals, PAIR * length);
            turned = Arrays.copyOf(turned, TURNED * length);
        }
        if (STRIDE * (used + 2) > points.length) {
            points = Arrays.copyOf(points, STRIDE * Growth.length(points.length / STRIDE, used + 2));
        }
    }

    void load(Touch touch, int k, int a, int b, double[] forces) {
        double[] w = state.w().values();
        double[] v = state.v();
        int p = STRIDE * used++;
        double nx = touch.nx, ny = touch.ny;
        double half = touch.isDiscA == touch.isDiscB ? 0 : 0.5 * Math.max(0, touch.gap[k]); // of the way to a disc: its arm is its radius when it strikes
        double way = touch.isDiscA ? -half : half;
        double ax = touch.px[k] + way * nx;
        double ay = touch.py[k] + way * ny;
        double bx = ax - (from[b] - from[a]);
        double by = ay - (from[b + 1] - from[a + 1]);
        points[p + AX] = ax;
        points[p + AY] = ay;
        points[p + BX] = bx;
        points[p + BY] = by;
        points[p + GAP] = touch.gap[k];
        points[p + NOW] = touch.gap[k];
        double leverA = ax * ny - ay * nx;
        double leverB = bx * ny - by * nx;
        weigh(w, a, b, p, nx, ny);
        points[p + APPROACH] = nx * (v[b] - v[a]) + ny * (v[b + 1] - v[a + 1]) + leverB * v[b + 2] - leverA * v[a + 2];
        points[p + FORCED] =
                nx * (forces[b] - forces[a]) + ny * (forces[b + 1] - forces[a + 1]) + leverB * forces[b + 2] - leverA * forces[a + 2];
        points[p + FEATURE] = touch.feature[k];
        points[p + LEVER_A] = leverA;
        points[p + LEVER_B] = leverB;
        points[p + ARM_A] = touch.isDiscA ? 0 : ax * nx + ay * ny;
        points[p + ARM_B] = touch.isDiscB ? 0 : bx * nx + by * ny;
        points[p + NORMAL] = 0;
        points[p + TANGENT] = 0;
        points[p + NORMAL_SUM] = 0;
        points[p + TANGENT_SUM] = 0;
        points[p + LAST] = 0;
        points[p + RESTORED] = 0;
        points[p + BEND] = 0;
        points[p + OPENING] = 0;
    }

    /**
     * What an impulse at a point takes to change the speeds there by one, along the normal and the tangent. With less than its arms ask
     * for, impulses would be too large, and grow from solution to solution.
     */
    void weigh(double[] w, int a, int b, int p, double nx, double ny) {
        double leverA = points[p + AX] * ny - points[p + AY] * nx;
        double leverB = points[p + BX] * ny - points[p + BY] * nx;
        double slipA = points[p + AX] * nx + points[p + AY] * ny;
        double slipB = points[p + BX] * nx + points[p + BY] * ny;
        double masses = w[a] + w[b];
        points[p + NORMAL_MASS] = 1 / (masses + w[a + 2] * leverA * leverA + w[b + 2] * leverB * leverB);
        points[p + TANGENT_MASS] = 1 / (masses + w[a + 2] * slipA * slipA + w[b + 2] * slipB * slipB);
        points[p + COUPLING] = w[a + 2] * leverA * slipA + w[b + 2] * leverB * slipB;
    }

    /** Adds a pair of other rows as it is there. */
    void copy(ContactRows other, int k) {
        byBody.forget();
        reserve();
        int n = other.pointCount(k);
        System.arraycopy(other.pairs, INTS * k, pairs, INTS * count, INTS);
        System.arraycopy(other.normals, PAIR * k, normals, PAIR * count, PAIR);
        System.arraycopy(other.turned, TURNED * k, turned, TURNED * count, TURNED);
        System.arraycopy(other.points, STRIDE * other.pairs[INTS * k + 3], points, STRIDE * used, STRIDE * n);
        pairs[INTS * count + 3] = used;
        used += n;
        pairs[INTS * count++ + 4] = used;
    }

    /** Keeps the pairs that have a body of those that are marked, in their order. */
    void keepOf(boolean[] marks) {
        byBody.forget();
        int all = count;
        count = 0;
        used = 0;
        for (int k = 0; k < all; k++) {
            if (marks[first(k)] || marks[second(k)]) {
                copy(this, k);
            }
        }
    }

    /** Takes back the pair that was added last. */
    void dropLast() {
        byBody.forget();
        count--;
        used = pairs[INTS * count + 3];
        bounces -= normals[PAIR * count + BOUNCE] > 0 ? 1 : 0;
        driven -= isDriven(count) ? 1 : 0;
        fast -= pairs[INTS * count + FAST];
        unlike -= pairs[INTS * count + UNLIKE];
    }

    /** Whether a pair will touch within a step if nothing else happens. */
    boolean touches(int k, double h) {
        for (int p = begin(k); p < end(k); p += STRIDE) {
            if (points[p + GAP] + h * (points[p + APPROACH] + h * points[p + FORCED]) <= 0) {
                return true;
            }
        }
        return false;
    }

    /** Lets a point begin with the impulses of the step before. */
    void remember(int k, int point, double normal, double tangent, double last) {
        int p = STRIDE * (pairs[INTS * k + 3] + point);
        points[p + NORMAL] = normal;
        points[p + TANGENT] = tangent;
        points[p + LAST] = last;
    }

    int pointCount(int k) {
        return pairs[INTS * k + 4] - pairs[INTS * k + 3];
    }

    double normalX(int k) {
        return normals[PAIR * k];
    }

    double normalY(int k) {
        return normals[PAIR * k + 1];
    }

    /** One of the values of a point. */
    double of(int k, int point, int what) {
        return points[STRIDE * (pairs[INTS * k + 3] + point) + what];
    }

    double approach(int k, int point) {
        return 0 - of(k, point, APPROACH);
    }

    /** The impulses along the normal in the step. */
    double impulse(int k) {
        return sum(k, NORMAL_SUM);
    }

    /** The impulses along the tangent in the step. */
    double rubbed(int k) {
        return sum(k, TANGENT_SUM);
    }

    double sum(int k, int which) {
        double sum = 0;
        for (int m = pairs[INTS * k + 3]; m < pairs[INTS * k + 4]; m++) {
            sum += points[STRIDE * m + which];
        }
        return sum;
    }

    /** The speed of a point's surfaces on one another. */
    double slip(int k, int p, double[] v) {
        return speed(k, p, v, -normals[PAIR * k + 1], normals[PAIR * k]) + normals[PAIR * k + BELT];
    }

    /** The speed at which a point opens. */
    double opening(int k, int p, double[] v) {
        return speed(k, p, v, normals[PAIR * k], normals[PAIR * k + 1]);
    }

    /** The velocity of the second body at a point against that of the first one, in a direction. */
    double speed(int k, int p, double[] v, double dx, double dy) {
        int a = State.BLOCK * first(k);
        int b = State.BLOCK * second(k);
        double ux = v[b] - points[p + BY] * v[b + 2] - v[a] + points[p + AY] * v[a + 2];
        double uy = v[b + 1] + points[p + BX] * v[b + 2] - v[a + 1] - points[p + AX] * v[a + 2];
        return dx * ux + dy * uy;
    }

    /** Gives the bodies of a point impulses along the normal and the tangent. */
    void give(int k, int p, double[] v, double normal, double tangent) {
        double nx = normals[PAIR * k], ny = normals[PAIR * k + 1];
        push(v, state.w().values(), State.BLOCK * first(k), State.BLOCK * second(k), p, nx * normal - ny * tangent, ny * normal + nx * tangent);
    }

    /** Gives the bodies of a point an impulse. */
    void push(double[] v, double[] w, int a, int b, int p, double jx, double jy) {
        v[a] -= w[a] * jx;
        v[a + 1] -= w[a] * jy;
        v[a + 2] -= w[a + 2] * (points[p + AX] * jy - points[p + AY] * jx);
        v[b] += w[b] * jx;
        v[b + 1] += w[b] * jy;
        v[b + 2] += w[b + 2] * (points[p + BX] * jy - points[p + BY] * jx);
    }

    /** Whether a pair may strike, whose impact is over in the substep in which the two meet: not one that lies and does not bounce. */
    boolean mayStrike(int k) {
        return mayBounce(k) || isFast(k);
    }

    /** Whether a pair did not press in the step before. */
    boolean isNew(int k) {
        return pairs[INTS * k + PRESSED] == 0;
    }

    /** Whether a pair is fast, and new. */
    boolean comesToStrike(int k) {
        return isFast(k) && isNew(k);
    }

    /** Whether a pair has just met, or is fast. */
    boolean isStruck(int k) {
        return isNew(k) || isFast(k);
    }

    /** The body that strikes a fixed one in a pair, −1 if none does. */
    int strikesFixed(int k) {
        double[] w = state.w().values();
        boolean isFirstFixed = w[State.BLOCK * first(k)] == 0;
        boolean isFixed = isFirstFixed || w[State.BLOCK * second(k)] == 0;
        return !isFixed || !isStruck(k) || isDriven(k) ? -1 : isFirstFixed ? second(k) : first(k);
    }

    /** Whether a pair closes a gap faster than forces do. */
    boolean isFast(int k) {
        return pairs[INTS * k + FAST] != 0;
    }

    /** Finds by how much forces accelerate the two bodies, whichever way they go. */
    private void load(int k, double[] forces) {
        int a = State.BLOCK * first(k);
        int b = State.BLOCK * second(k);
        double nx = normalX(k), ny = normalY(k);
        normals[PAIR * k + LOAD] = Math.abs(nx * forces[a] + ny * forces[a + 1]) + Math.abs(nx * forces[b] + ny * forces[b + 1]);
        normals[PAIR * k + WEIGHT] = size(forces, a) + size(forces, b);
    }

    private static double size(double[] forces, int o) {
        return Math.sqrt(forces[o] * forces[o] + forces[o + 1] * forces[o + 1]);
    }

    private boolean closes(int k, double h) {
        boolean is = false;
        for (int p = begin(k); !is && p < end(k); p += STRIDE) {
            is = points[p + GAP] > 0 && points[p + APPROACH] < -2 * h * normals[PAIR * k + LOAD];
        }
        return is;
    }

    /** Whether surfaces that move drive the bodies of a pair. */
    boolean isDriven(int k) {
        return normals[PAIR * k + BELT] != 0 && normals[PAIR * k + ASKED] > 0;
    }

    boolean mayBounce(int k) {
        return normals[PAIR * k + BOUNCE] > 0;
    }

    boolean hasBounced(int k) {
        return pairs[INTS * k + BOUNCED] != 0;
    }

    int feature(int k, int point) {
        return (int) of(k, point, FEATURE);
    }

    /** A point relative to the second body's centre at the start. */
    double armX(int k, int point) {
        return of(k, point, BX);
    }

    double armY(int k, int point) {
        return of(k, point, BY);
    }
}
