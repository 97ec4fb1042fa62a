// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.ARM_A;
import static sim.physics.stepping.ContactRows.ARM_B;
import static sim.physics.stepping.ContactRows.AX;
import static sim.physics.stepping.ContactRows.AY;
import static sim.physics.stepping.ContactRows.BOTH;
import static sim.physics.stepping.ContactRows.BX;
import static sim.physics.stepping.ContactRows.BY;
import static sim.physics.stepping.ContactRows.DISCS;
import static sim.physics.stepping.ContactRows.FEATURE;
import static sim.physics.stepping.ContactRows.FRICTION;
import static sim.physics.stepping.ContactRows.GAP;
import static sim.physics.stepping.ContactRows.INTS;
import static sim.physics.stepping.ContactRows.LEVER_A;
import static sim.physics.stepping.ContactRows.LEVER_B;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NOW;
import static sim.physics.stepping.ContactRows.PAIR;
import static sim.physics.stepping.ContactRows.RUBBING;
import static sim.physics.stepping.ContactRows.STEADY;
import static sim.physics.stepping.ContactRows.STRIDE;

import java.io.Serializable;
import sim.physics.internal.Growth;
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

    /** Of what are discs: the first one only. */
    private static final int FIRST = 1;

    private final State state;
    private final ContactRows rows;
    private final ContactTurns turns;

    /** Those of the rows, which grow when a step begins. */
    private transient int[] pairs;

    private transient double[] normals;
    private transient double[] points;

    /** By pair: whether one of the two goes its way whatever touches it, as it is fixed, or moves as its author says. */
    private transient boolean[] areBorne;

    ContactArms(State state, ContactRows rows) {
        this.state = state;
        this.rows = rows;
        turns = rows.turns;
    }

    /** Begins a step: all of its rows are there. */
    void begin() {
        pairs = rows.pairs;
        normals = rows.normals;
        points = rows.points;
        if (areBorne == null || areBorne.length < rows.count) {
            areBorne = new boolean[Growth.length(areBorne == null ? 0 : areBorne.length, rows.count)];
        }
        for (int k = 0; k < rows.count; k++) {
            areBorne[k] = !state.body(rows.first(k)).isDynamic() || !state.body(rows.second(k)).isDynamic();
        }
    }

    /** Lets the points of a pair go along, whose gaps have just been measured. */
    void follow(double[] w, int k) {
        int a = State.BLOCK * rows.first(k);
        int b = State.BLOCK * rows.second(k);
        boolean isOnFixed = w[a] == 0 || w[b] == 0;
        int discs = pairs[INTS * k + DISCS];
        if (!(isOnFixed && (discs == 1 || discs == 2) && turns.mode(k) == ContactTurns.STILL)) {
            follow(k, a, b, areBorne[k], discs);
        }
    }

    private void follow(int k, int a, int b, boolean isBorne, int discs) {
        double[] x = state.x();
        double dx = x[b] - x[a];
        double dy = x[b + 1] - x[a + 1];
        double nx = normals[PAIR * k];
        double ny = normals[PAIR * k + 1];
        turns.findMeasured(k);
        turns.note(k, 0.5);
        boolean isOne = rows.pointCount(k) == 1;
        boolean isRound = turns.mode(k) >= ContactTurns.BETWEEN;
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            double jx = 0.5 * (nx * points[p + STEADY] - ny * points[p + RUBBING]);
            double jy = 0.5 * (ny * points[p + STEADY] + nx * points[p + RUBBING]);
            double byA = points[p + AX] * jy - points[p + AY] * jx;
            double byB = points[p + BX] * jy - points[p + BY] * jx;
            boolean isFar = isRound;
            if (isRound) {
                turns.place(k, p, dx, dy);
            } else if (discs == 1 || discs == 2) {
                isFar = move(p, discs - 1, dx, dy);
            } else {
                isFar = isBorne || isOne
                        ? swing(k, p, x[a + 2] - rows.from[a + 2], x[b + 2] - rows.from[b + 2], dx, dy)
                        : move(p, 0.5, dx, dy);
            }
            if (jx != 0 || jy != 0) {
                redirect(k, p, a, b, jx, jy, byA, byB, discs);
            }
            if (isFar || rows.mayStrike(k)) {
                rows.weigh(state.w().values(), a, b, p, turns.nx, turns.ny);
            }
        }
    }

    /** Lets the half of an impulse that acts where the bodies are now act along the present normal, and at the present levers. */
    private void redirect(int k, int p, int a, int b, double jx, double jy, double byA, double byB, int discs) {
        double endX = 0.5 * (turns.nx * points[p + STEADY] - turns.ny * points[p + RUBBING]);
        double endY = 0.5 * (turns.ny * points[p + STEADY] + turns.nx * points[p + RUBBING]);
        if (endX != jx || endY != jy) {
            pushCentres(a, b, endX - jx, endY - jy);
        }
        if (discs != BOTH || normals[PAIR * k + FRICTION] > 0) { // else it acts at their centres
            twist(a, b, p, endX, endY, byA, byB);
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
     * Turns the corner that the point is of with its body, and moves both arms to half way between it and the other body; whether that is far. One
     * that slides off the other body would have a lever there that is no body's: then both go half of the way.
     */
    private boolean swing(int k, int p, double turnA, double turnB, double dx, double dy) {
        boolean isOfFirst = Touch.isCornerOfFirst((int) points[p + FEATURE]);
        double nx = turns.startX(k);
        double ny = turns.startY(k);
        double lever = points[p + (isOfFirst ? LEVER_A : LEVER_B)];
        double toEdge = isOfFirst ? 0.5 : -0.5;
        double arm = points[p + (isOfFirst ? ARM_A : ARM_B)] - toEdge * points[p + GAP];
        double middle = 0.5 * (isOfFirst ? turnA : turnB);
        double by = middle * middle;
        double half = middle * (1 + by * (1.0 / 3 + by * (2.0 / 15 + by * (17.0 / 315)))); // its tangent
        double cos = (1 - half * half) / (1 + half * half);
        double sin = 2 * half / (1 + half * half);
        double startX = arm * nx + lever * ny;
        double startY = arm * ny - lever * nx;
        double endX = cos * startX - sin * startY + toEdge * points[p + NOW] * turns.nx + (isOfFirst ? 0 : dx);
        double endY = cos * startY + sin * startX + toEdge * points[p + NOW] * turns.ny + (isOfFirst ? 0 : dy);
        double square = arm * arm + lever * lever;
        double wayA = square(endX - points[p + AX], endY - points[p + AY]);
        double wayB = square(endX - dx - points[p + BX], endY - dy - points[p + BY]);
        if (!areBorne[k] && (isOfFirst ? wayB : wayA) > SLID * SLID * square) {
            return move(p, 0.5, dx, dy);
        }
        points[p + AX] = endX;
        points[p + AY] = endY;
        points[p + BX] = endX - dx;
        points[p + BY] = endY - dy;
        double way = !areBorne[k] ? Math.max(wayA, wayB) : isDynamic(rows.first(k)) ? wayA : wayB; // on a floor none counts, nor on a belt
        return way > FAR * FAR * square;
    }

    private static double square(double x, double y) {
        return x * x + y * y;
    }

    private boolean isDynamic(int body) {
        return state.body(body).isDynamic();
    }

    /** What was given before the normal turned and taken back along another one has left something beside it: two that do not press do nothing. */
    private void straighten(int k) {
        int p = STRIDE * pairs[INTS * k + 3];
        double x = rows.turned[ContactRows.TURNED * k + 2];
        double y = rows.turned[ContactRows.TURNED * k + 3];
        if (x == 0 && y == 0) {
            return;
        }
        if (pairs[INTS * k + DISCS] != 0 && normals[PAIR * k + FRICTION] == 0) {
            pushCentre(k, p, -x, -y);
        } else {
            rows.push(state.v(), state.w().values(), State.BLOCK * rows.first(k), State.BLOCK * rows.second(k), p, -x, -y);
        }
        turns.forget(k, 1);
    }

    /** Gives the bodies an impulse at the centre of the disc, which is where that of one without friction acts; at both centres, of two discs. */
    private void pushCentre(int k, int p, double jx, double jy) {
        int a = State.BLOCK * rows.first(k);
        int b = State.BLOCK * rows.second(k);
        pushCentres(a, b, jx, jy);
        double turn = (points[p + AX] - points[p + BX]) * jy - (points[p + AY] - points[p + BY]) * jx; // about the disc's centre
        int discs = pairs[INTS * k + DISCS];
        if (discs != BOTH) {
            int other = discs == FIRST ? b : a;
            state.v()[other + 2] -= state.w().values()[other + 2] * turn;
        }
    }

    /** Gives the bodies an impulse at their centres. */
    private void pushCentres(int a, int b, double jx, double jy) {
        double[] v = state.v();
        double[] w = state.w().values();
        v[a] -= w[a] * jx;
        v[a + 1] -= w[a] * jy;
        v[b] += w[b] * jx;
        v[b + 1] += w[b] * jy;
    }

    /** Ends a substep: what does not press in the end has done nothing, though its normal has turned. */
    void straighten() {
        for (int k = 0; k < rows.count; k++) {
            if (turns.mode(k) != ContactTurns.STILL && rows.sum(k, NORMAL) == 0) {
                straighten(k);
            }
        }
    }
}
