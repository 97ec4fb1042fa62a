// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.util.Arrays;

/**
 * Finds which points of a {@link HeapSystem} are open, stuck, or slide, from impulses that are about right, by a path of
 * solutions. With springs in place of contacts, which begin to press at other places than they should, any impulses are
 * exact; from there the places are moved to where they belong, evenly. The solution moves along straight lines, and at their
 * ends one point opens, closes, comes to rest or begins to slide (the method of complementary pivots: Lemke 1965; from any start:
 * Dirkse and Ferris, <i>The PATH solver</i>, 1995). In the plane Coulomb's law has no other pieces, so that this ends where
 * Newton's method runs in circles.
 */
final class HeapPath {
    /** Lines at most for each point, and beside them; and points that are looked at over all lines. */
    private static final int LINES_EACH = 6;

    private static final int LINES = 40;
    private static final int WORK = 100_000;

    /** Lines of a short path: more cost more than a central path. */
    private static final int SHORT = 80;

    /** Times that points are passed in the time of a line. */
    private static final int LINE = 6;

    /** Way back beyond the start at which another start is better. */
    private static final double LOST = -10;

    /** What a line meets at its end: nothing, that a point closes or opens, or a bound of friction. */
    private static final int NOTHING = 0;

    private static final int NORMAL = 1;
    private static final int UPPER = 2;
    private static final int LOWER = 3;

    private final HeapPiece piece;

    /** By point: the impulses that its springs would give, could they pull; how these and their offsets change on the way. */
    private double[] force = {};

    private double[] change = {};
    private double[] offset = {};
    private double[] right = {};

    /** What the present line meets: the point, what happens there, and the sign of the change that leads there. */
    private int point;

    private int event;
    private double sign;

    HeapPath(HeapPiece piece) {
        this.piece = piece;
    }

    /** Makes room for a system. */
    void begin(HeapSystem s) {
        if (force.length < 2 * s.size()) {
            force = new double[4 * s.size()];
            change = new double[4 * s.size()];
            offset = new double[4 * s.size()];
        }
        right = right.length < 3 * s.bodyCount() ? new double[6 * s.bodyCount()] : right;
    }

    /**
     * Follows the path from the impulses that a system has.
     *
     * @return whether it came to its end, where the impulses and the piece are nearly right; else they are as before
     */
    boolean follow(HeapSystem s) {
        return follow(s, 0, LINES + LINES_EACH * s.size());
    }

    /** The same where it is short, as from impulses that are nearly right. */
    boolean followShortly(HeapSystem s) {
        return follow(s, 0, SHORT);
    }

    /** Follows the path from no impulses, where points first have to come near. */
    boolean followFromNothing(HeapSystem s) {
        double most = 0;
        s.startFromNothing();
        s.refresh();
        for (int p = 0; p < s.size(); p++) {
            most = Math.max(most, s.bound(p) - s.normal(p));
        }
        return follow(s, most, LINES + LINES_EACH * s.size());
    }

    private boolean follow(HeapSystem s, double apart, int lines) {
        for (int p = 0; p < s.size(); p++) {
            start(s, p, apart);
        }
        double way = 0;
        double ahead = 1;
        event = NOTHING;
        for (int k = Math.min(lines, WORK / Math.max(1, s.size())); k > 0 && way > LOST; k--) {
            s.pass(LINE);
            if (!line(s)) {
                return false;
            }
            if (event != NOTHING) {
                ahead = rate(s) * sign > 0 ? 1 : -1; // on into the new piece, be it forth or back
            }
            double length = meet(s, ahead, ahead > 0 ? 1 - way : Double.POSITIVE_INFINITY);
            if (event == NOTHING && ahead < 0) {
                return false; // for ever back
            }
            way += ahead * length;
            for (int i = 0; i < 2 * s.size(); i++) {
                force[i] += ahead * length * change[i];
            }
            if (event == NOTHING) {
                end(s);
                return true;
            }
            turn(s);
        }
        return false;
    }

    /** Lets a point's springs press as the impulses say, and says how far they are from their places. */
    private void start(HeapSystem s, int p, double least) {
        double jn = s.normalImpulse(p);
        double jt = s.tangentImpulse(p);
        double most = s.friction(p) * jn;
        double kn = HeapPiece.normalStiffness(s, p);
        double kt = HeapPiece.tangentStiffness(s, p);
        double apart = kn * (s.normal(p) - s.bound(p));
        double along = kt * s.tangent(p);
        piece.isClosed[p] = jn > 0;
        piece.slides[p] = jn > 0 && Math.abs(jt) >= most ? Math.signum(jt) : 0;
        force[2 * p] = jn > 0 ? jn : Math.min(-apart, -Math.max(HeapPiece.SOFT / s.normalMobility(p), kn * least));
        double slide = piece.slides[p];
        force[2 * p + 1] = jn <= 0 ? -along : slide == 0 ? jt : slide * Math.max(-slide * along, most);
        offset[2 * p] = jn - force[2 * p] - apart;
        offset[2 * p + 1] = jt - force[2 * p + 1] - along;
    }

    /** Finds how all changes on the next line; false if that cannot be solved for. */
    private boolean line(HeapSystem s) {
        if (!(event == NOTHING ? piece.factor(s) : piece.refactor(s, point))) {
            return false;
        }
        Arrays.fill(right, 0, 3 * s.bodyCount(), 0);
        for (int p = 0; p < s.size(); p++) {
            if (piece.isClosed[p]) {
                double jn = offset[2 * p];
                s.pushUnits(p, jn, piece.isStuck(s, p) ? offset[2 * p + 1] : piece.rub(s, p) * jn, right);
            }
        }
        piece.matrix.solve(right);
        for (int p = 0; p < s.size(); p++) {
            change[2 * p] = offset[2 * p] - HeapPiece.normalStiffness(s, p) * s.normal(p, right);
            change[2 * p + 1] = offset[2 * p + 1] - HeapPiece.tangentStiffness(s, p) * s.tangent(p, right);
        }
        return true;
    }

    /** How fast what was met changes on the next line. */
    private double rate(HeapSystem s) {
        return rate(s, point, event);
    }

    private double rate(HeapSystem s, int p, int what) {
        double most = s.friction(p) * change[2 * p];
        return what == NORMAL ? change[2 * p] : (what == UPPER ? change[2 * p + 1] : -change[2 * p + 1]) - most;
    }

    private double value(HeapSystem s, int p, int what) {
        double most = s.friction(p) * force[2 * p];
        return what == NORMAL ? force[2 * p] : (what == UPPER ? force[2 * p + 1] : -force[2 * p + 1]) - most;
    }

    /** How far the line goes, at most that far; notes what ends it. */
    private double meet(HeapSystem s, double ahead, double farthest) {
        double nearest = farthest;
        int last = event == NOTHING ? -1 : point;
        int passed = event;
        event = NOTHING;
        for (int p = 0; p < s.size(); p++) {
            for (int what = NORMAL; what <= LOWER; what++) {
                if (what != NORMAL && !isBound(s, p, what) || p == last && what == passed) {
                    continue;
                }
                double value = value(s, p, what);
                double rate = ahead * rate(s, p, what);
                if (value * rate < 0 && -value / rate < nearest) {
                    nearest = -value / rate;
                    point = p;
                    event = what;
                    sign = Math.signum(rate);
                }
            }
        }
        return nearest;
    }

    /** Whether a point can come to a bound of its friction, from either side. */
    private boolean isBound(HeapSystem s, int p, int what) {
        return piece.isClosed[p] && s.friction(p) > 0 && piece.slides[p] != (what == UPPER ? -1 : 1);
    }

    /** Enters the next piece. */
    private void turn(HeapSystem s) {
        piece.leave(s, point);
        if (event == NORMAL) {
            force[2 * point] = 0;
            piece.isClosed[point] = !piece.isClosed[point];
            piece.slides[point] = piece.isClosed[point] && s.friction(point) > 0 ? Math.signum(force[2 * point + 1]) : 0;
        } else {
            piece.slides[point] = piece.slides[point] != 0 ? 0 : event == UPPER ? 1 : -1;
        }
    }

    /** Gives the system what has been found. */
    private void end(HeapSystem s) {
        for (int p = 0; p < s.size(); p++) {
            double jn = piece.isClosed[p] ? Math.max(0, force[2 * p]) : 0;
            s.start(p, jn, piece.isStuck(s, p) ? force[2 * p + 1] : piece.rub(s, p) * jn);
        }
        s.refresh();
    }
}
