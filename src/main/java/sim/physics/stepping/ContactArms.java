// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.ARM_A;
import static sim.physics.stepping.ContactRows.ARM_B;
import static sim.physics.stepping.ContactRows.AX;
import static sim.physics.stepping.ContactRows.AY;
import static sim.physics.stepping.ContactRows.BOTH;
import static sim.physics.stepping.ContactRows.BOUNCE;
import static sim.physics.stepping.ContactRows.BX;
import static sim.physics.stepping.ContactRows.BY;
import static sim.physics.stepping.ContactRows.DISCS;
import static sim.physics.stepping.ContactRows.FEATURE;
import static sim.physics.stepping.ContactRows.FRICTION;
import static sim.physics.stepping.ContactRows.INTS;
import static sim.physics.stepping.ContactRows.LEVER_A;
import static sim.physics.stepping.ContactRows.LEVER_B;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NORMAL_SUM;
import static sim.physics.stepping.ContactRows.PAIR;
import static sim.physics.stepping.ContactRows.RUBBING;
import static sim.physics.stepping.ContactRows.STEADY;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT;
import static sim.physics.stepping.ContactRows.TANGENT_SUM;

import java.io.Serializable;
import sim.physics.motion.State;

/**
 * Lets points go along when the bodies have moved within a step, since only of one point for both does an impulse keep the angular momentum:
 * with the body whose corner one is, with the disc of a disc and a polygon, and of two discs along the line of their centres. Two corners of
 * a pair that can both move go half with each.
 */
final class ContactArms implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Way of the ends of arms, relative to them, up to which what they take is as it was. */
    private static final double FAR = 1e-3;

    /** Way of a corner on the other body in a substep, relative to its own arm, from which it counts as slid off. */
    private static final double SLID = 0.5;

    private final State state;
    private final ContactRows rows;

    /** Those of the rows, which grow when a step begins. */
    private transient int[] pairs;

    private transient double[] normals;
    private transient double[] points;

    ContactArms(State state, ContactRows rows) {
        this.state = state;
        this.rows = rows;
    }

    /** Begins a step: all of its rows are there. */
    void begin() {
        pairs = rows.pairs;
        normals = rows.normals;
        points = rows.points;
    }

    /** Lets all points go along, but those of elastic pairs, as their bounce is the mirror image of all that the step has taken. */
    void follow() {
        double[] w = state.w().values();
        for (int k = 0; k < rows.count; k++) {
            int a = State.BLOCK * rows.first(k);
            int b = State.BLOCK * rows.second(k);
            boolean isOnFixed = w[a] == 0 || w[b] == 0;
            int discs = pairs[INTS * k + DISCS];
            if (normals[PAIR * k + BOUNCE] < 1 && !(isOnFixed && (discs == 1 || discs == 2))) {
                follow(k, a, b, isOnFixed, discs);
            }
        }
    }

    private void follow(int k, int a, int b, boolean isOnFixed, int discs) {
        double[] x = state.x();
        double dx = x[b] - x[a];
        double dy = x[b + 1] - x[a + 1];
        double nx = normals[PAIR * k];
        double ny = normals[PAIR * k + 1];
        boolean isOne = rows.pointCount(k) == 1;
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            if (discs == BOTH && normals[PAIR * k + FRICTION] == 0) {
                slide(k, p, a, b, dx, dy);
                continue;
            }
            double jx = 0.5 * (nx * points[p + STEADY] - ny * points[p + RUBBING]);
            double jy = 0.5 * (ny * points[p + STEADY] + nx * points[p + RUBBING]);
            double byA = points[p + AX] * jy - points[p + AY] * jx;
            double byB = points[p + BX] * jy - points[p + BY] * jx;
            boolean isFar = discs == BOTH ? turn(k, p, 0, dx, dy)
                    : discs == 0 && (isOnFixed || isOne) ? swing(k, p, x[a + 2] - rows.from[a + 2], x[b + 2] - rows.from[b + 2], dx, dy)
                    : move(p, discs == 0 ? 0.5 : discs - 1, dx, dy);
            twist(a, b, p, jx, jy, byA, byB);
            if (isFar) {
                rows.weigh(state.w().values(), a, b, p, normals[PAIR * k], normals[PAIR * k + 1]);
            }
        }
    }

    /** Gives the bodies what the half of the impulse that acts where they are now turns them by, in place of what it did where they were. */
    private void twist(int a, int b, int p, double jx, double jy, double byA, double byB) {
        double[] v = state.v();
        double[] w = state.w().values();
        v[a + 2] -= w[a + 2] * (points[p + AX] * jy - points[p + AY] * jx - byA);
        v[b + 2] += w[b + 2] * (points[p + BX] * jy - points[p + BY] * jx - byB);
    }

    /** Moves the ends of both arms to one point: by a part of the way between them that of the first body, by the rest that of the other; whether that is far. */
    private boolean move(int p, double part, double dx, double dy) {
        double wayX = dx - (points[p + AX] - points[p + BX]);
        double wayY = dy - (points[p + AY] - points[p + BY]);
        points[p + AX] += part * wayX;
        points[p + AY] += part * wayY;
        points[p + BX] -= (1 - part) * wayX;
        points[p + BY] -= (1 - part) * wayY;
        double arms = points[p + AX] * points[p + AX] + points[p + AY] * points[p + AY]
                + points[p + BX] * points[p + BX] + points[p + BY] * points[p + BY];
        return wayX * wayX + wayY * wayY > FAR * FAR * arms;
    }

    /**
     * Turns the arm of the body whose corner the point is with it, and moves that of the other one to its end; whether that is far. One that
     * slides off the other body would have a lever there that is no body's: then both go half of the way.
     */
    private boolean swing(int k, int p, double turnA, double turnB, double dx, double dy) {
        boolean isOfFirst = Touch.isCornerOfFirst((int) points[p + FEATURE]);
        double nx = normals[PAIR * k];
        double ny = normals[PAIR * k + 1];
        double lever = points[p + (isOfFirst ? LEVER_A : LEVER_B)];
        double arm = points[p + (isOfFirst ? ARM_A : ARM_B)];
        double half = 0.5 * (isOfFirst ? turnA : turnB);
        double cos = (1 - half * half) / (1 + half * half);
        double sin = 2 * half / (1 + half * half);
        double startX = arm * nx + lever * ny;
        double startY = arm * ny - lever * nx;
        double endX = cos * startX - sin * startY + (isOfFirst ? 0 : dx);
        double endY = cos * startY + sin * startX + (isOfFirst ? 0 : dy);
        double square = arm * arm + lever * lever;
        double wayA = square(endX - points[p + AX], endY - points[p + AY]);
        double wayB = square(endX - dx - points[p + BX], endY - dy - points[p + BY]);
        boolean movesA = isMovable(rows.first(k));
        boolean movesB = isMovable(rows.second(k));
        if (movesA && movesB && (isOfFirst ? wayB : wayA) > SLID * SLID * square) {
            return move(p, 0.5, dx, dy);
        }
        points[p + AX] = endX;
        points[p + AY] = endY;
        points[p + BX] = endX - dx;
        points[p + BY] = endY - dy;
        double way = Math.max(movesA ? wayA : 0, movesB ? wayB : 0); // on a floor none counts, nor on a belt
        return way > FAR * FAR * square;
    }

    private static double square(double x, double y) {
        return x * x + y * y;
    }

    private boolean isMovable(int body) {
        return state.w().values()[State.BLOCK * body] > 0;
    }

    /**
     * Turns the normal of two discs without friction, and with it the half of what has pressed them that acts where they are now: along the
     * normal of before it would turn them, and take from their way about one another what it gives to their spins.
     */
    private void slide(int k, int p, int a, int b, double dx, double dy) {
        double x = normals[PAIR * k];
        double y = normals[PAIR * k + 1];
        double half = 0.5 * points[p + STEADY];
        turn(k, p, half, dx, dy);
        pushCentres(a, b, half * (normals[PAIR * k] - x), half * (normals[PAIR * k + 1] - y));
    }

    /** Takes note of what the normal by which sums are told of was more, while they acted, but for a part that goes along with it. */
    private void turned(int k, int p, double along, double nx, double ny) {
        double[] turned = rows.turned;
        int o = ContactRows.TURNED * k;
        turned[o + 2] = nx * (points[p + NORMAL] - along) - ny * points[p + TANGENT];
        turned[o + 3] = ny * (points[p + NORMAL] - along) + nx * points[p + TANGENT];
        turned[o] += turned[o + 2] + nx * points[p + NORMAL_SUM] - ny * points[p + TANGENT_SUM];
        turned[o + 1] += turned[o + 3] + ny * points[p + NORMAL_SUM] + nx * points[p + TANGENT_SUM];
    }

    /** Turns normal and arms of two discs to where their centres are now; a part of the impulse goes along. */
    private boolean turn(int k, int p, double along, double dx, double dy) {
        double distance = Math.sqrt(dx * dx + dy * dy);
        double nx = normals[PAIR * k];
        double ny = normals[PAIR * k + 1];
        double first = nx * points[p + AX] + ny * points[p + AY];
        double second = nx * points[p + BX] + ny * points[p + BY];
        double middle = 0.5 * (first + second + distance); // of the distance, by what the arms were
        if (!(distance > 0)) {
            return false;
        }
        turned(k, p, along, nx - dx / distance, ny - dy / distance);
        nx = dx / distance;
        ny = dy / distance;
        normals[PAIR * k] = nx;
        normals[PAIR * k + 1] = ny;
        points[p + AX] = middle * nx;
        points[p + AY] = middle * ny;
        points[p + BX] = (middle - distance) * nx;
        points[p + BY] = (middle - distance) * ny;
        return true;
    }

    /** What was given before the normal turned and taken back along another one has left something beside it: two that do not press do nothing. */
    private void straighten(int k) {
        int p = STRIDE * pairs[INTS * k + 3];
        double x = rows.turned[ContactRows.TURNED * k + 2];
        double y = rows.turned[ContactRows.TURNED * k + 3];
        if (x == 0 && y == 0) {
            return;
        }
        int a = State.BLOCK * rows.first(k);
        int b = State.BLOCK * rows.second(k);
        if (normals[PAIR * k + FRICTION] == 0) {
            pushCentres(a, b, -x, -y);
        } else {
            rows.push(state.v(), state.w().values(), a, b, p, -x, -y);
        }
        forget(k, 1);
    }

    /** What discs without friction do to one another acts at their centres. */
    private void pushCentres(int a, int b, double jx, double jy) {
        double[] v = state.v();
        double[] w = state.w().values();
        v[a] -= w[a] * jx;
        v[a + 1] -= w[a] * jy;
        v[b] += w[b] * jx;
        v[b + 1] += w[b] * jy;
    }

    /** Takes a part of what was noted of the last turn back. */
    void forget(int k, double part) {
        int o = ContactRows.TURNED * k;
        for (int m = o; m < o + 2; m++) {
            rows.turned[m] -= part * rows.turned[m + 2];
            rows.turned[m + 2] *= 1 - part;
        }
    }

    /** Ends a substep of discs: what does not press in the end has done nothing, though its normal has turned. */
    void straighten() {
        for (int k = 0; k < rows.count; k++) {
            if (pairs[INTS * k + DISCS] == BOTH && points[STRIDE * pairs[INTS * k + 3] + NORMAL] == 0) {
                straighten(k);
            }
        }
    }
}
