// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.ARM_A;
import static sim.physics.stepping.ContactRows.ARM_B;
import static sim.physics.stepping.ContactRows.AX;
import static sim.physics.stepping.ContactRows.AY;
import static sim.physics.stepping.ContactRows.BEND;
import static sim.physics.stepping.ContactRows.BX;
import static sim.physics.stepping.ContactRows.BY;
import static sim.physics.stepping.ContactRows.FEATURE;
import static sim.physics.stepping.ContactRows.GAP;
import static sim.physics.stepping.ContactRows.LEVER_A;
import static sim.physics.stepping.ContactRows.LEVER_B;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NORMAL_SUM;
import static sim.physics.stepping.ContactRows.NOW;
import static sim.physics.stepping.ContactRows.PAIR;
import static sim.physics.stepping.ContactRows.REGAIN;
import static sim.physics.stepping.ContactRows.RUBBING;
import static sim.physics.stepping.ContactRows.STEADY;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT;
import static sim.physics.stepping.ContactRows.TANGENT_SUM;
import static sim.physics.stepping.ContactRows.WEIGHT;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.motion.State;
import sim.physics.motion.Steering;

/**
 * Normals and gaps where bodies have gone within a step. A normal is that of an edge, and turns with its body, or goes from the middle of a disc or
 * a corner to that of another disc. With the normals of the start, however many substeps there are, what slides on a body that turns would be
 * pressed askew, and its gap be off by its way times the turn.
 */
final class ContactTurns implements Serializable {
    private static final long serialVersionUID = 1L;

    /** What turns a normal: nothing, its edge's body, the first one or the second one, or two middles. */
    static final int STILL = 0;

    static final int FIRST = 1;
    static final int SECOND = 2;
    static final int BETWEEN = 3;

    /** Added where a disc, or one of a body's parts, touches an edge, or a corner of the first body; and where it does one of the second body. */
    static final int ROUND = 4;

    static final int ON_SECOND = 8;

    /**
     * Values of a pair: the normal at the start, the middles of what is round, or the corner, from their bodies' centres, how far the point is
     * from one, and of an edge beside the corner the normal and the way along it.
     */
    private static final int SIZE = 11;

    /** Turn of a body in a step, rad, from which on no normal goes along. */
    private static final double MOST = 0.5;

    /** The same that is none: what hardly turns, in piles, costs no more than what does not. */
    private static final double NONE = 2e-5;

    /**
     * The same of what trembles, else it is solved in two ways by turns, and for ever: a tenth of what forces move it by in a step, seen from as far as
     * it is large, which is the less the shorter the step; and at most.
     */
    private static final double TREMBLING = 0.1;

    private static final double MOST_TREMBLING = 5e-4;

    private final State state;
    private final ContactRows rows;

    /** Length of the step. */
    private double step;

    private int[] modes = {};
    private double[] starts = {};

    /** The present normal, the middles, and the way from the first middle to the second one. */
    double nx;

    double ny;
    private double ax;
    private double ay;
    private double bx;
    private double by;
    private double wayX;
    private double wayY;

    /** Whether a disc that began beyond a corner is over the edge. */
    private boolean isOver;

    ContactTurns(State state, ContactRows rows) {
        this.state = state;
        this.rows = rows;
    }

    /** Adds a pair that has been found. Where bodies turn far in the step nothing is foreseen. */
    void add(int k, Touch touch, double h) {
        if (k >= modes.length) {
            modes = Arrays.copyOf(modes, Growth.length(modes.length, k + 1));
            starts = Arrays.copyOf(starts, SIZE * modes.length);
        }
        step = h;
        int o = SIZE * k;
        starts[o] = touch.nx;
        starts[o + 1] = touch.ny;
        starts[o + 2] = touch.middleAX;
        starts[o + 3] = touch.middleAY;
        starts[o + 4] = touch.middleBX;
        starts[o + 5] = touch.middleBY;
        starts[o + 6] = touch.reach();
        starts[o + 7] = touch.edgeX;
        starts[o + 8] = touch.edgeY;
        starts[o + 9] = touch.alongX;
        starts[o + 10] = touch.alongY;
        modes[k] = touch.isDiscA && touch.isDiscB || !isStill(k, touch) ? touch.turnsBy : STILL;
    }

    private boolean isStill(int k, Touch touch) {
        double[] v = state.v();
        double turn = step * Math.max(Math.abs(v[State.BLOCK * rows.first(k) + 2]), Math.abs(v[State.BLOCK * rows.second(k) + 2]));
        double none = none(k);
        return turn > MOST || isPlain(k, touch) || turn < none && (touch.turnsBy < BETWEEN || goesRound(k) < none);
    }

    private double none(int k) {
        double size = step * rows.normals[PAIR * k + REGAIN] / TimeStepping.REGAIN;
        return Math.min(MOST_TREMBLING, Math.max(NONE, TREMBLING * step * step * rows.normals[PAIR * k + WEIGHT] / size));
    }

    /** Whether a body turns too far in the step for that. */
    boolean spins(int body) {
        return step * Math.abs(state.v()[State.BLOCK * body + 2]) > MOST;
    }

    /** Gives a pair, of which nothing is noted in this substep, another normal, which is kept. */
    void hold(int k, double x, double y) {
        modes[k] = STILL;
        starts[SIZE * k] = x;
        starts[SIZE * k + 1] = y;
        nx = x;
        ny = y;
        note(k, 0);
    }

    /** Whether the bodies of a pair, unless they are discs, turn so little in the step that points follow them well. */
    boolean areFollowed(int k) {
        double[] v = state.v();
        int discs = rows.pairs[ContactRows.INTS * k + ContactRows.DISCS];
        double first = (discs & 1) == 0 ? v[State.BLOCK * rows.first(k) + 2] : 0;
        double second = (discs & 2) == 0 ? v[State.BLOCK * rows.second(k) + 2] : 0;
        return step * Math.max(Math.abs(first), Math.abs(second)) <= MOST;
    }

    /** By how much the way between two middles turns in the step at most, apart from what the bodies turn by. */
    private double goesRound(int k) {
        double[] v = state.v();
        int a = State.BLOCK * rows.first(k);
        int b = State.BLOCK * rows.second(k);
        double apart = Math.abs(startWay(k, 0)) + Math.abs(startWay(k, 1));
        return step * (Math.abs(v[b] - v[a]) + Math.abs(v[b + 1] - v[a + 1])) / apart; // infinite or no number where they are in one place
    }

    /** {@return what turns a pair's normal} */
    int mode(int k) {
        return modes[k];
    }

    /** Whether nothing of a pair but its gap changes as the one moves that can: a disc on a fixed edge. */
    private boolean isPlain(int k, Touch touch) {
        return touch.isDiscB && touch.turnsBy == FIRST + ROUND && isGround(rows.first(k))
                || touch.isDiscA && touch.turnsBy == SECOND + ROUND && isGround(rows.second(k));
    }

    /** Whether no force moves a body, and it does not turn. */
    private boolean isGround(int body) {
        return state.w().values()[State.BLOCK * body] == 0 || !state.body(body).isDynamic() && !Steering.turns(state.body(body));
    }

    double startX(int k) {
        return starts[SIZE * k];
    }

    double startY(int k) {
        return starts[SIZE * k + 1];
    }

    /** Whether a struck body has turned too far to be followed. */
    private boolean isLost(int k) {
        boolean areDiscs = rows.pairs[ContactRows.INTS * k + ContactRows.DISCS] == ContactRows.BOTH;
        return !areDiscs && Math.max(Math.abs(turn(rows.first(k))), Math.abs(turn(rows.second(k)))) > MOST;
    }

    /** Finds the present normal of a pair. */
    void find(int k) {
        lose(k);
        if (modes[k] >= BETWEEN) {
            between(k);
        }
        findNormal(k);
    }

    /** The same of the pair that was measured last, since when its bodies have not moved. */
    void findMeasured(int k) {
        if (modes[k] < BETWEEN) { // else it was found with the gap
            findNormal(k);
        }
    }

    private void lose(int k) {
        if (modes[k] != STILL && isLost(k)) {
            modes[k] = STILL;
            starts[SIZE * k] = rows.normals[PAIR * k];
            starts[SIZE * k + 1] = rows.normals[PAIR * k + 1];
        }
    }

    private void findNormal(int k) {
        int mode = modes[k] & BETWEEN;
        nx = starts[SIZE * k];
        ny = starts[SIZE * k + 1];
        if (mode == BETWEEN) {
            findBetween(k);
        } else if (mode != STILL) {
            turn(nx, ny, turn(mode == FIRST ? rows.first(k) : rows.second(k)));
        }
    }

    /** Along the way between the middles, until a disc that was beyond a corner is over the edge: then that of the edge. */
    private void findBetween(int k) {
        int o = SIZE * k;
        int corner = modes[k] & (ROUND + ON_SECOND);
        isOver = false;
        double x = nx;
        double y = ny;
        double distance = Math.sqrt(wayX * wayX + wayY * wayY);
        if (corner != 0) {
            double turn = turn(corner == ROUND ? rows.first(k) : rows.second(k));
            turn(starts[o + 9], starts[o + 10], turn);
            if ((corner == ROUND ? 1 : -1) * (nx * wayX + ny * wayY) > 0) {
                turn(starts[o + 7], starts[o + 8], turn);
                isOver = true;
                return;
            }
        }
        nx = distance > 0 ? wayX / distance : x;
        ny = distance > 0 ? wayY / distance : y;
    }

    /** By what a body has turned in the step. */
    private double turn(int body) {
        int o = State.BLOCK * body + 2;
        return state.x()[o] - rows.from[o];
    }

    /** Turns a vector by an angle of up to some half a radian, and leaves it in the normal: series, as divisions and sines cost more than all the rest. */
    private void turn(double x, double y, double angle) {
        double square = angle * angle;
        double cos = 1 - square * (0.5 - square * (1.0 / 24 - square * (1.0 / 720 - square * (1.0 / 40320 - square * (1.0 / 3628800)))));
        double sin = angle * (1 - square * (1.0 / 6 - square * (1.0 / 120 - square * (1.0 / 5040 - square * (1.0 / 362880)))));
        nx = cos * x - sin * y;
        ny = sin * x + cos * y;
    }

    /** Finds the present middles, and the way between them. */
    private void between(int k) {
        double[] x = state.x();
        int o = SIZE * k;
        int a = State.BLOCK * rows.first(k);
        int b = State.BLOCK * rows.second(k);
        turnMiddle(o + 2, rows.first(k));
        ax = nx;
        ay = ny;
        turnMiddle(o + 4, rows.second(k));
        bx = nx;
        by = ny;
        wayX = x[b] - x[a] + bx - ax;
        wayY = x[b + 1] - x[a + 1] + by - ay;
    }

    /** Begins a substep, of which nothing is noted yet, with what turns will do to the gaps of what lies; what strikes uses its gap up as it is. */
    void begin(int k) {
        int o = ContactRows.TURNED * k;
        rows.turned[o + 2] = 0;
        rows.turned[o + 3] = 0;
        int a = State.BLOCK * rows.first(k);
        int b = State.BLOCK * rows.second(k);
        if (modes[k] != STILL && !(rows.mayBounce(k) && rows.isFast(k))) {
            bend(k, a, b);
        }
    }

    private void bend(int k, int a, int b) {
        double[] v = state.v();
        double[] points = rows.points;
        double spin = v[a + 2];
        double turn = v[b + 2];
        int mode = modes[k] & BETWEEN;
        boolean isRound = modes[k] >= BETWEEN;
        if (isRound) {
            find(k);
        }
        double n0 = rows.normals[PAIR * k];
        double n1 = rows.normals[PAIR * k + 1];
        double dx = state.x()[b] - state.x()[a];
        double dy = state.x()[b + 1] - state.x()[a + 1];
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            double firstX = !isRound ? points[p + AX] : mode == FIRST ? dx + bx : ax; // the middle of a disc, as a point of either body
            double firstY = !isRound ? points[p + AY] : mode == FIRST ? dy + by : ay;
            double secondX = !isRound ? points[p + BX] : mode == SECOND ? ax - dx : bx;
            double secondY = !isRound ? points[p + BY] : mode == SECOND ? ay - dy : by;
            double ux = v[b] - turn * secondY - v[a] + spin * firstY;
            double uy = v[b + 1] + turn * secondX - v[a + 1] - spin * firstX;
            double slide = n0 * uy - n1 * ux;
            double turned = mode == FIRST ? 2 * spin : mode == SECOND ? 2 * turn : mode == BETWEEN && !isOver ? turnBetween(points[p + GAP], slide, n0, n1) : 0;
            points[p + BEND] = spin * spin * (n0 * firstX + n1 * firstY) - turn * turn * (n0 * secondX + n1 * secondY) + turned * slide;
        }
    }

    /** Turns a middle with its body: that of a disc, which is in its centre, does not move. */
    private void turnMiddle(int o, int body) {
        nx = starts[o];
        ny = starts[o + 1];
        if (nx != 0 || ny != 0) {
            turn(nx, ny, turn(body));
        }
    }

    /** How fast the way between two middles turns; not where that is far, or they are deep in one another. */
    private double turnBetween(double gap, double slide, double n0, double n1) {
        double distance = n0 * wayX + n1 * wayY;
        return distance > -gap && step * Math.abs(slide) < MOST * distance ? slide / distance : 0;
    }

    /** Finds the gaps where the bodies are now. */
    void measure(int k) {
        double[] points = rows.points;
        int begin = rows.begin(k);
        lose(k);
        int mode = modes[k];
        if (mode == STILL) {
            measureStill(k);
        } else if (mode >= BETWEEN) {
            between(k);
            findNormal(k);
            points[begin + NOW] = points[begin + GAP] + nx * wayX + ny * wayY - startHeight(k);
        } else {
            for (int p = begin; p < rows.end(k); p += STRIDE) {
                measureCorner(k, p);
            }
        }
    }

    /** What the way between the middles was along the normal. */
    private double startHeight(int k) {
        return startX(k) * startWay(k, 0) + startY(k) * startWay(k, 1);
    }

    private double startWay(int k, int axis) {
        int o = SIZE * k + axis;
        return rows.from[State.BLOCK * rows.second(k) + axis] - rows.from[State.BLOCK * rows.first(k) + axis] + starts[o + 4] - starts[o + 2];
    }

    /** A corner goes with its body, and the edge below it turns with the other one. */
    private void measureCorner(int k, int p) {
        double[] points = rows.points;
        double[] x = state.x();
        double[] from = rows.from;
        boolean isOfFirst = Touch.isCornerOfFirst((int) points[p + FEATURE]);
        int own = State.BLOCK * (isOfFirst ? rows.first(k) : rows.second(k));
        int other = State.BLOCK * (isOfFirst ? rows.second(k) : rows.first(k));
        double n0 = startX(k);
        double n1 = startY(k);
        double arm = points[p + (isOfFirst ? ARM_A : ARM_B)];
        double lever = points[p + (isOfFirst ? LEVER_A : LEVER_B)];
        double start = n0 * (from[own] - from[other]) + n1 * (from[own + 1] - from[other + 1]) + arm;
        double turn = x[own + 2] - from[own + 2] - (x[other + 2] - from[other + 2]); // of the corner, seen from the edge
        turn(arm, -lever, turn);
        double now = nx; // of the corner along the edge's normal
        turn(n0, n1, x[other + 2] - from[other + 2]);
        now += nx * (x[own] - x[other]) + ny * (x[own + 1] - x[other + 1]);
        points[p + NOW] = points[p + GAP] + (isOfFirst ? start - now : now - start);
    }

    /** Along the normal of the start, arms turned to second order. */
    private void measureStill(int k) {
        double[] points = rows.points;
        double[] x = state.x();
        double[] from = rows.from;
        int a = State.BLOCK * rows.first(k);
        int b = State.BLOCK * rows.second(k);
        double turnA = x[a + 2] - from[a + 2];
        double turnB = x[b + 2] - from[b + 2];
        double moved = startX(k) * (x[b] - from[b] - (x[a] - from[a])) + startY(k) * (x[b + 1] - from[b + 1] - (x[a + 1] - from[a + 1]));
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            double turned = points[p + LEVER_B] * turnB - points[p + LEVER_A] * turnA;
            turned -= 0.5 * (points[p + ARM_B] * turnB * turnB - points[p + ARM_A] * turnA * turnA);
            points[p + NOW] = points[p + GAP] + moved + turned;
        }
    }

    /** Takes note of what the normal by which sums are told of was more while they acted, but for the part that goes along with it. */
    void note(int k, double part) {
        double[] normals = rows.normals;
        double dx = normals[PAIR * k] - nx;
        double dy = normals[PAIR * k + 1] - ny;
        if (dx == 0 && dy == 0) {
            return;
        }
        double normal = 0;
        double tangent = 0;
        double normalSum = 0;
        double tangentSum = 0;
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            normal += rows.points[p + NORMAL] - part * rows.points[p + STEADY];
            tangent += rows.points[p + TANGENT] - part * rows.points[p + RUBBING];
            normalSum += rows.points[p + NORMAL_SUM];
            tangentSum += rows.points[p + TANGENT_SUM];
        }
        double[] turned = rows.turned;
        int o = ContactRows.TURNED * k;
        turned[o + 2] = dx * normal - dy * tangent;
        turned[o + 3] = dy * normal + dx * tangent;
        turned[o] += turned[o + 2] + dx * normalSum - dy * tangentSum;
        turned[o + 1] += turned[o + 3] + dy * normalSum + dx * tangentSum;
        normals[PAIR * k] = nx;
        normals[PAIR * k + 1] = ny;
    }

    /** Takes a part of what was noted of the last turn back. */
    void forget(int k, double part) {
        int o = ContactRows.TURNED * k;
        for (int m = o; m < o + 2; m++) {
            rows.turned[m] -= part * rows.turned[m + 2];
            rows.turned[m + 2] *= 1 - part;
        }
    }

    /** Puts both arms of what is round to the point half way between the surfaces, after its normal was found. */
    void place(int k, int p, double dx, double dy) {
        double[] points = rows.points;
        double reach = starts[SIZE * k + 6];
        double more = 0.5 * (points[p + NOW] - points[p + GAP]);
        if (modes[k] == FIRST + ROUND) {
            points[p + BX] = bx + nx * (reach - more);
            points[p + BY] = by + ny * (reach - more);
            points[p + AX] = points[p + BX] + dx;
            points[p + AY] = points[p + BY] + dy;
        } else {
            points[p + AX] = ax + nx * (reach + more);
            points[p + AY] = ay + ny * (reach + more);
            points[p + BX] = points[p + AX] - dx;
            points[p + BY] = points[p + AY] - dy;
        }
    }
}
