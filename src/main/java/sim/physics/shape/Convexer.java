// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import java.util.ArrayList;
import java.util.List;
import sim.physics.internal.Check;
import sim.physics.internal.IntList;

/**
 * Cuts a simple polygon into convex ones: into triangles by its ears (Meisters, <i>Polygons have ears</i>, 1975), the best shaped one
 * first, which are put together again as long as what comes of it is convex (Hertel and Mehlhorn, <i>Fast triangulation of simple
 * polygons</i>, 1983): at most four times as many as there have to be.
 */
final class Convexer {
    /** Counter-clockwise. */
    private final double[] xy;

    /** The polygons so far, by their vertices. */
    private final List<IntList> pieces = new ArrayList<>();

    Convexer(double[] given) {
        if (given.length < 6 || given.length % 2 != 0) {
            throw new IllegalArgumentException("an outline was given " + given.length
                    + " coordinates: it needs x and y of at least 3 vertices");
        }
        for (int k = 0; k < given.length; k += 2) {
            Check.finite("x of vertex " + k / 2, given[k]);
            Check.finite("y of vertex " + k / 2, given[k + 1]);
        }
        xy = given.clone();
        requireSimple();
        IntList outline = corners();
        if (outline.size < 3) {
            throw new IllegalArgumentException("the outline encloses nothing: its vertices lie on one line");
        }
        cut(outline);
        merge();
    }

    /** The vertices of each polygon: x0, y0, x1, y1 …. */
    double[][] parts() {
        double[][] parts = new double[pieces.size()][];
        for (int k = 0; k < parts.length; k++) {
            IntList piece = pieces.get(k);
            parts[k] = new double[2 * piece.size];
            for (int m = 0; m < piece.size; m++) {
                parts[k][2 * m] = xy[2 * piece.values[m]];
                parts[k][2 * m + 1] = xy[2 * piece.values[m] + 1];
            }
        }
        return parts;
    }

    private int turn(int a, int b, int c) {
        return PolygonCheck.turn(xy, a, b, c);
    }

    private void requireSimple() {
        int n = xy.length / 2;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < i; j++) {
                if (xy[2 * i] == xy[2 * j] && xy[2 * i + 1] == xy[2 * j + 1]) {
                    throw refusal(i, "it coincides with vertex " + j);
                }
            }
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < i; j++) {
                boolean areNeighbours = i - j == 1 || i - j == n - 1;
                if (!areNeighbours && doMeet(i, (i + 1) % n, j, (j + 1) % n)) {
                    throw refusal(j, "the outline meets itself, the edge from there and the edge from vertex " + i);
                }
            }
        }
    }

    private IllegalArgumentException refusal(int k, String why) {
        return new IllegalArgumentException("vertex " + k + " is (" + xy[2 * k] + ", " + xy[2 * k + 1] + "): " + why);
    }

    private boolean doMeet(int a, int b, int c, int d) {
        int ofC = turn(a, b, c);
        int ofD = turn(a, b, d);
        int ofA = turn(c, d, a);
        int ofB = turn(c, d, b);
        return ofC * ofD < 0 && ofA * ofB < 0
                || ofC == 0 && isWithin(a, b, c)
                || ofD == 0 && isWithin(a, b, d)
                || ofA == 0 && isWithin(c, d, a)
                || ofB == 0 && isWithin(c, d, b);
    }

    /** Whether a point on the line of an edge lies between its ends. */
    private boolean isWithin(int a, int b, int c) {
        return between(xy[2 * a], xy[2 * b], xy[2 * c]) && between(xy[2 * a + 1], xy[2 * b + 1], xy[2 * c + 1]);
    }

    private static boolean between(double a, double b, double c) {
        return Math.min(a, b) <= c && c <= Math.max(a, b);
    }

    /** The vertices that are corners, counter-clockwise. */
    private IntList corners() {
        IntList corners = new IntList();
        int n = xy.length / 2;
        boolean isCounterClockwise = twiceArea() > 0;
        for (int k = 0; k < n; k++) {
            corners.add(isCounterClockwise ? k : n - 1 - k);
        }
        for (int k = 0; k < corners.size && corners.size > 2; ) {
            if (turnAt(corners, k) == 0) {
                take(corners, k);
                k = Math.max(0, k - 1);
            } else {
                k++;
            }
        }
        return corners;
    }

    private double twiceArea() {
        double sum = 0;
        for (int k = 2; k + 3 < xy.length; k += 2) {
            sum += (xy[k] - xy[0]) * (xy[k + 3] - xy[1]) - (xy[k + 1] - xy[1]) * (xy[k + 2] - xy[0]);
        }
        return sum;
    }

    private static int at(IntList list, int k) {
        return list.values[(k + list.size) % list.size];
    }

    private int turnAt(IntList list, int k) {
        return turn(at(list, k - 1), at(list, k), at(list, k + 1));
    }

    private static void take(IntList list, int k) {
        System.arraycopy(list.values, k + 1, list.values, k, list.size - k - 1);
        list.size--;
    }

    private void cut(IntList left) {
        while (left.size > 3) {
            int best = -1;
            double most = -1;
            for (int k = 0; k < left.size; k++) {
                double quality = quality(at(left, k - 1), at(left, k), at(left, k + 1));
                if (quality > most && isEar(left, k)) {
                    best = k;
                    most = quality;
                }
            }
            if (best < 0) {
                throw new IllegalArgumentException("the outline cannot be cut into convex polygons: rounding makes it meet itself");
            }
            add(at(left, best - 1), at(left, best), at(left, best + 1));
            take(left, best);
        }
        add(left.values[0], left.values[1], left.values[2]);
    }

    private void add(int a, int b, int c) {
        if (turn(a, b, c) > 0) { // what is left may have no area
            IntList piece = new IntList();
            piece.add(a);
            piece.add(b);
            piece.add(c);
            pieces.add(piece);
        }
    }

    /** The area of a triangle relative to its sides: small if one of its angles is. */
    private double quality(int a, int b, int c) {
        double ux = xy[2 * b] - xy[2 * a];
        double uy = xy[2 * b + 1] - xy[2 * a + 1];
        double vx = xy[2 * c] - xy[2 * b];
        double vy = xy[2 * c + 1] - xy[2 * b + 1];
        double squares = ux * ux + uy * uy + vx * vx + vy * vy + (ux + vx) * (ux + vx) + (uy + vy) * (uy + vy);
        return (ux * vy - uy * vx) / squares;
    }

    /** Whether the triangle at a corner holds no other vertex. A corner without area may go, too. */
    private boolean isEar(IntList left, int k) {
        int a = at(left, k - 1);
        int b = at(left, k);
        int c = at(left, k + 1);
        boolean isEar = turn(a, b, c) >= 0;
        for (int m = 0; isEar && m < left.size; m++) {
            int p = left.values[m];
            isEar = p == a || p == b || p == c || turn(a, b, p) < 0 || turn(b, c, p) < 0 || turn(c, a, p) < 0;
        }
        return isEar;
    }

    /** Puts pieces together that have an edge in common, as long as one can be. */
    private void merge() {
        boolean isOver = false;
        while (!isOver) {
            isOver = true;
            for (int i = 0; i < pieces.size() && isOver; i++) {
                for (int j = 0; j < i && isOver; j++) {
                    IntList merged = merged(pieces.get(i), pieces.get(j));
                    if (merged != null) {
                        pieces.set(j, merged);
                        pieces.remove(i);
                        isOver = false;
                    }
                }
            }
        }
    }

    /** Two pieces as one, or null if they have no edge in common or it would not be convex. */
    private IntList merged(IntList p, IntList q) {
        for (int k = 0; k < p.size; k++) {
            for (int m = 0; m < q.size; m++) {
                if (at(p, k) == at(q, m + 1) && at(p, k + 1) == at(q, m)) {
                    boolean isConvex = turn(at(p, k - 1), at(p, k), at(q, m + 2)) > 0
                            && turn(at(q, m - 1), at(q, m), at(p, k + 2)) > 0;
                    return isConvex ? joined(p, k, q, m) : null;
                }
            }
        }
        return null;
    }

    private static IntList joined(IntList p, int k, IntList q, int m) {
        IntList all = new IntList();
        for (int s = 1; s <= p.size; s++) {
            all.add(at(p, k + s)); // from the end of the common edge round to its beginning
        }
        for (int s = 2; s < q.size; s++) {
            all.add(at(q, m + s));
        }
        return all;
    }
}
