// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.internal.Softness;
import sim.physics.motion.State;

/**
 * The contacts of a step: per point an impulse along the normal that keeps what is left of the gap from being passed within a
 * substep, or regains what is missing of it, and one along the tangent within the cone of friction.
 */
final class ContactRows implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values of a point. */
    private static final int STRIDE = 19;

    private static final int AX = 0;
    private static final int AY = 1;
    private static final int BX = 2;
    private static final int BY = 3;
    /** The gap at the start. */
    private static final int GAP = 4;

    private static final int NORMAL_MASS = 5;
    private static final int TANGENT_MASS = 6;
    private static final int NORMAL = 7;
    private static final int TANGENT = 8;
    /** Speed at which it opens at the start. */
    private static final int APPROACH = 9;

    /** The part of what it has taken that a point gives once more. */
    private static final int RESTORED = 10;

    private static final int NORMAL_SUM = 11;
    private static final int TANGENT_SUM = 12;
    private static final int FORCED = 13;
    private static final int FEATURE = 14;

    /** What turns of the bodies do to the gap, of first order, and of second: nothing to discs. */
    private static final int LEVER_A = 15;

    private static final int LEVER_B = 16;
    private static final int ARM_A = 17;
    private static final int ARM_B = 18;

    /** Values of a pair: normal, friction, restitution, largest speed at which depth is regained. */
    private static final int PAIR = 5;

    private static final int FRICTION = 2;
    private static final int BOUNCE = 3;
    private static final int REGAIN = 4;

    /** When an impulse has settled, relative to itself. */
    private static final double SETTLED = 1e-4;

    private final State state;

    int count;
    /** Per pair: its number, its bodies, its first point and the one after its last. */
    private int[] pairs = {};

    private static final int INTS = 7;

    /** Whether the pair has bounced in this step. */
    private static final int BOUNCED = 5;

    /** Whether it pressed in the step before. */
    private static final int PRESSED = 6;

    private double[] normals = {};
    private double[] points = {};
    private int used;

    /** Where the bodies were at the start of the step. */
    private double[] from = {};

    ContactRows(State state) {
        this.state = state;
    }

    /** Begins a step, with where the bodies are. */
    void begin() {
        count = 0;
        used = 0;
        double[] x = state.x();
        if (from.length < x.length) {
            from = new double[x.length];
        }
        System.arraycopy(x, 0, from, 0, State.BLOCK * state.size());
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
     * @param forced acceleration by which forces close the gap
     * @param regain the largest speed at which depth is regained
     * @param hasPressed whether the two pressed on one another in the step before
     */
    void add(
            int pair, int a, int b, Touch touch, double friction, double restitution, double[] forces, double regain, boolean hasPressed) {
        if (INTS * (count + 1) > pairs.length) {
            int length = Growth.length(pairs.length / INTS, count + 1);
            pairs = Arrays.copyOf(pairs, INTS * length);
            normals = Arrays.copyOf(normals, PAIR * length);
        }
        int o = INTS * count;
        pairs[o] = pair;
        pairs[o + 1] = a;
        pairs[o + 2] = b;
        pairs[o + 3] = used;
        pairs[o + BOUNCED] = 0;
        pairs[o + PRESSED] = hasPressed ? 1 : 0;
        int n = PAIR * count++;
        normals[n] = touch.nx;
        normals[n + 1] = touch.ny;
        normals[n + FRICTION] = friction;
        normals[n + BOUNCE] = restitution;
        normals[n + REGAIN] = regain;
        if (STRIDE * (used + 2) > points.length) {
            points = Arrays.copyOf(points, STRIDE * Growth.length(points.length / STRIDE, used + 2));
        }
        for (int k = 0; k < touch.count; k++) {
            load(touch, k, State.BLOCK * a, State.BLOCK * b, forces);
        }
        pairs[o + 4] = used;
    }

    private void load(Touch touch, int k, int a, int b, double[] forces) {
        double[] w = state.w().values();
        double[] v = state.v();
        int p = STRIDE * used++;
        double nx = touch.nx;
        double ny = touch.ny;
        double ax = touch.px[k];
        double ay = touch.py[k];
        double bx = ax - (from[b] - from[a]);
        double by = ay - (from[b + 1] - from[a + 1]);
        points[p + AX] = ax;
        points[p + AY] = ay;
        points[p + BX] = bx;
        points[p + BY] = by;
        points[p + GAP] = touch.gap[k];
        double leverA = ax * ny - ay * nx;
        double leverB = bx * ny - by * nx;
        double slipA = ax * nx + ay * ny;
        double slipB = bx * nx + by * ny;
        double masses = w[a] + w[b];
        points[p + NORMAL_MASS] = 1 / (masses + w[a + 2] * leverA * leverA + w[b + 2] * leverB * leverB);
        points[p + TANGENT_MASS] = 1 / (masses + w[a + 2] * slipA * slipA + w[b + 2] * slipB * slipB);
        points[p + APPROACH] = nx * (v[b] - v[a]) + ny * (v[b + 1] - v[a + 1]) + leverB * v[b + 2] - leverA * v[a + 2];
        points[p + FORCED] =
                nx * (forces[b] - forces[a]) + ny * (forces[b + 1] - forces[a + 1]) + leverB * forces[b + 2] - leverA * forces[a + 2];
        points[p + FEATURE] = touch.feature[k];
        points[p + LEVER_A] = leverA;
        points[p + LEVER_B] = leverB;
        points[p + ARM_A] = touch.isDiscA ? 0 : slipA;
        points[p + ARM_B] = touch.isDiscB ? 0 : slipB;
        points[p + NORMAL] = 0;
        points[p + TANGENT] = 0;
        points[p + NORMAL_SUM] = 0;
        points[p + TANGENT_SUM] = 0;
    }

    /** Takes back the pair that was added last. */
    void dropLast() {
        count--;
        used = pairs[INTS * count + 3];
    }

    /** Whether a pair will touch within a step if nothing else happens. */
    boolean touches(int k, double h) {
        for (int m = pairs[INTS * k + 3]; m < pairs[INTS * k + 4]; m++) {
            int p = STRIDE * m;
            if (points[p + GAP] + h * (points[p + APPROACH] + h * points[p + FORCED]) <= 0) {
                return true;
            }
        }
        return false;
    }

    /** Lets a point begin with the impulses of the step before. */
    void remember(int k, int point, double normal, double tangent) {
        int p = STRIDE * (pairs[INTS * k + 3] + point);
        points[p + NORMAL] = normal;
        points[p + TANGENT] = tangent;
    }

    int pointCount(int k) {
        return pairs[INTS * k + 4] - pairs[INTS * k + 3];
    }

    /** Gives the bodies the impulses of the substep before. */
    void start() {
        double[] v = state.v();
        double[] w = state.w().values();
        for (int k = 0; k < count; k++) {
            int a = State.BLOCK * first(k);
            int b = State.BLOCK * second(k);
            double nx = normals[PAIR * k];
            double ny = normals[PAIR * k + 1];
            for (int p = STRIDE * pairs[INTS * k + 3]; p < STRIDE * pairs[INTS * k + 4]; p += STRIDE) {
                double jx = nx * points[p + NORMAL] - ny * points[p + TANGENT];
                double jy = ny * points[p + NORMAL] + nx * points[p + TANGENT];
                push(v, w, a, b, p, jx, jy);
            }
        }
    }

    private void push(double[] v, double[] w, int a, int b, int p, double jx, double jy) {
        v[a] -= w[a] * jx;
        v[a + 1] -= w[a] * jy;
        v[a + 2] -= w[a + 2] * (points[p + AX] * jy - points[p + AY] * jx);
        v[b] += w[b] * jx;
        v[b + 1] += w[b] * jy;
        v[b + 2] += w[b + 2] * (points[p + BX] * jy - points[p + BY] * jx);
    }

    /** Solves all points once: friction, and then what matters more. */
    void solve(Softness softness, boolean regains, double h) {
        double[] v = state.v();
        double[] w = state.w().values();
        for (int k = 0; k < count; k++) {
            int a = State.BLOCK * first(k);
            int b = State.BLOCK * second(k);
            int begin = STRIDE * pairs[INTS * k + 3];
            int end = STRIDE * pairs[INTS * k + 4];
            for (int p = begin; p < end; p += STRIDE) {
                rub(v, w, a, b, k, p);
            }
            for (int p = begin; p < end; p += STRIDE) {
                press(v, w, a, b, k, p, softness, regains, h);
            }
        }
    }

    private void rub(double[] v, double[] w, int a, int b, int k, int p) {
        double nx = normals[PAIR * k];
        double ny = normals[PAIR * k + 1];
        double ux = v[b] - points[p + BY] * v[b + 2] - v[a] + points[p + AY] * v[a + 2];
        double uy = v[b + 1] + points[p + BX] * v[b + 2] - v[a + 1] - points[p + AX] * v[a + 2];
        double most = normals[PAIR * k + FRICTION] * points[p + NORMAL];
        double old = points[p + TANGENT];
        double now = old - points[p + TANGENT_MASS] * (nx * uy - ny * ux);
        now = Math.max(-most, Math.min(most, now));
        points[p + TANGENT] = now;
        push(v, w, a, b, p, -ny * (now - old), nx * (now - old));
    }

    private void press(double[] v, double[] w, int a, int b, int k, int p, Softness softness, boolean regains, double h) {
        double nx = normals[PAIR * k];
        double ny = normals[PAIR * k + 1];
        double ux = v[b] - points[p + BY] * v[b + 2] - v[a] + points[p + AY] * v[a + 2];
        double uy = v[b + 1] + points[p + BX] * v[b + 2] - v[a + 1] - points[p + AX] * v[a + 2];
        double gap = gap(a, b, p, nx, ny);
        double aim = 0;
        double mass = 1;
        double back = 0;
        if (gap >= 0) {
            aim = gap / h;
        } else if (regains) {
            aim = Math.max(softness.rate() * gap, -normals[PAIR * k + REGAIN]);
            mass = softness.mass();
            back = softness.impulse();
        }
        double old = points[p + NORMAL];
        double now = Math.max(0, old - mass * points[p + NORMAL_MASS] * (nx * ux + ny * uy + aim) - back * old);
        points[p + NORMAL] = now;
        push(v, w, a, b, p, nx * (now - old), ny * (now - old));
    }

    /** The gap where the bodies are now, along the normal of the start; arms turned to second order. */
    private double gap(int a, int b, int p, double nx, double ny) {
        double[] x = state.x();
        double turnA = x[a + 2] - from[a + 2];
        double turnB = x[b + 2] - from[b + 2];
        double moved = nx * (x[b] - from[b] - (x[a] - from[a])) + ny * (x[b + 1] - from[b + 1] - (x[a + 1] - from[a + 1]));
        double turned = points[p + LEVER_B] * turnB - points[p + LEVER_A] * turnA;
        turned -= 0.5 * (points[p + ARM_B] * turnB * turnB - points[p + ARM_A] * turnA * turnA);
        return points[p + GAP] + moved + turned;
    }

    /**
     * Lets points go along when the bodies have moved, half with each: only of one point for both does an impulse keep the angular
     * momentum. What is fixed needs no arms, and the other body's stay.
     */
    void follow() {
        double[] x = state.x();
        double[] w = state.w().values();
        for (int k = 0; k < count; k++) {
            int a = State.BLOCK * first(k);
            int b = State.BLOCK * second(k);
            if (w[a] == 0 || w[b] == 0) {
                continue;
            }
            double dx = x[b] - x[a];
            double dy = x[b + 1] - x[a + 1];
            for (int p = STRIDE * pairs[INTS * k + 3]; p < STRIDE * pairs[INTS * k + 4]; p += STRIDE) {
                double wayX = 0.5 * (dx - (points[p + AX] - points[p + BX]));
                double wayY = 0.5 * (dy - (points[p + AY] - points[p + BY]));
                points[p + AX] += wayX;
                points[p + AY] += wayY;
                points[p + BX] -= wayX;
                points[p + BY] -= wayY;
            }
        }
    }

    /** Adds the impulses of a substep to those of the step. */
    void add() {
        for (int p = 0; p < STRIDE * used; p += STRIDE) {
            points[p + NORMAL_SUM] += points[p + NORMAL];
            points[p + TANGENT_SUM] += points[p + TANGENT];
        }
    }

    /** Compresses what will bounce once more in turn, as its gaps are of no more use; whether something has changed. */
    boolean compress() {
        double[] v = state.v();
        double[] w = state.w().values();
        boolean goesOn = false;
        for (int k = 0; k < count; k++) {
            for (int m = pairs[INTS * k + 3]; hasBounced(k) && m < pairs[INTS * k + 4]; m++) {
                goesOn |= points[STRIDE * m + RESTORED] > 0 && compress(v, w, k, STRIDE * m);
            }
        }
        return goesOn;
    }

    /** Gives what compression has taken once more, in part. What forces alone give in the step does not bounce. */
    void restore(double h) {
        double[] v = state.v();
        double[] w = state.w().values();
        for (int k = 0; k < count; k++) {
            for (int m = pairs[INTS * k + 3]; hasBounced(k) && m < pairs[INTS * k + 4]; m++) {
                restore(v, w, k, STRIDE * m, h);
            }
        }
    }

    /** Notes which points have met and will bounce; false if none does. */
    boolean findImpacts(double h) {
        boolean any = false;
        for (int k = 0; k < count; k++) {
            for (int m = pairs[INTS * k + 3]; normals[PAIR * k + BOUNCE] > 0 && m < pairs[INTS * k + 4]; m++) {
                int p = STRIDE * m;
                double pull = h * Math.max(0, -points[p + FORCED]);
                boolean isImpact = points[p + APPROACH] < -2 * pull || !hasPressed(k) && pull == 0;
                boolean bounces = isImpact && points[p + NORMAL_SUM] > 0;
                points[p + RESTORED] = bounces ? normals[PAIR * k + BOUNCE] : 0;
                pairs[INTS * k + BOUNCED] |= bounces ? 1 : 0;
                any |= bounces;
            }
        }
        return any;
    }

    /** Takes what is left of a point's approach, as the gap that it still had is of no more use; whether there was anything. */
    private boolean compress(double[] v, double[] w, int k, int p) {
        int a = State.BLOCK * first(k);
        int b = State.BLOCK * second(k);
        double nx = normals[PAIR * k];
        double ny = normals[PAIR * k + 1];
        double ux = v[b] - points[p + BY] * v[b + 2] - v[a] + points[p + AY] * v[a + 2];
        double uy = v[b + 1] + points[p + BX] * v[b + 2] - v[a + 1] - points[p + AX] * v[a + 2];
        double old = points[p + NORMAL_SUM];
        double now = Math.max(0, old - points[p + NORMAL_MASS] * (nx * ux + ny * uy));
        points[p + NORMAL_SUM] = now;
        push(v, w, a, b, p, nx * (now - old), ny * (now - old));
        return Math.abs(now - old) > SETTLED * (now + old);
    }

    private void restore(double[] v, double[] w, int k, int p, double h) {
        double pull = 0.5 * h * Math.max(0, -points[p + FORCED]) * points[p + NORMAL_MASS];
        double by = points[p + RESTORED] * Math.max(0, points[p + NORMAL_SUM] - pull);
        points[p + NORMAL] = 0; // the two part
        points[p + NORMAL_SUM] += by;
        push(v, w, State.BLOCK * first(k), State.BLOCK * second(k), p, normals[PAIR * k] * by, normals[PAIR * k + 1] * by);
    }

    private boolean hasPressed(int k) {
        return pairs[INTS * k + PRESSED] != 0;
    }

    double normalX(int k) {
        return normals[PAIR * k];
    }

    double normalY(int k) {
        return normals[PAIR * k + 1];
    }

    private double of(int k, int point, int what) {
        return points[STRIDE * (pairs[INTS * k + 3] + point) + what];
    }

    double normal(int k, int point) {
        return of(k, point, NORMAL);
    }

    double tangent(int k, int point) {
        return of(k, point, TANGENT);
    }

    double normalSum(int k, int point) {
        return of(k, point, NORMAL_SUM);
    }

    double tangentSum(int k, int point) {
        return of(k, point, TANGENT_SUM);
    }

    double approach(int k, int point) {
        return 0 - of(k, point, APPROACH);
    }

    /** The impulses along the normal in the step. */
    double impulse(int k) {
        double sum = 0;
        for (int m = pairs[INTS * k + 3]; m < pairs[INTS * k + 4]; m++) {
            sum += points[STRIDE * m + NORMAL_SUM];
        }
        return sum;
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
