// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.Trig;

/**
 * Where the contact points of a heap will be when their bodies have moved on by a little: normals turn with the body whose edge
 * they belong to, or with the line from a corner or centre to a centre, and levers with them.
 */
final class TurnedPoint implements Serializable {
    private static final long serialVersionUID = 1L;

    /**
     * Values per point: normal, places relative to both bodies, from centre to centre, gap, radii, shorter lever. The places are those of
     * corners, or of the centres of discs, which may be parts of their bodies: what touches of a disc is another point each time.
     */
    private static final int STRIDE = 12;

    private static final int EDGE_A = 0;
    private static final int EDGE_B = 1;
    private static final int CIRCLES = 2;
    private static final int CORNERS = 3;

    /** How deep a circle may be in something, relative to its radius, for its normal to be the line to its centre. */
    private static final double DEEP = 0.1;

    private double[] data = {};
    private int[] kinds = {};

    /** Where the last point that was looked at is then: its normal, places relative to both bodies, and its gap. */
    double nx;

    double ny;
    double gap;
    private double ax;
    private double ay;
    private double bx;
    private double by;

    private boolean isRoundA;
    private boolean isRoundB;
    private final double[] turns = new double[4];

    TurnedPoint() {
        // filled point by point
    }

    /** Takes in a point where it is now. */
    void set(int p, Manifold m, int k) {
        if (kinds.length <= p) {
            kinds = Arrays.copyOf(kinds, 2 * p + 2);
            data = Arrays.copyOf(data, STRIDE * (2 * p + 2));
        }
        int owner = m.count == 2 && m.isEnd[k] ? 1 - m.owner : m.owner;
        kinds[p] = owner == 0 ? EDGE_A
                : owner == 1 ? EDGE_B
                : m.radiusA + m.radiusB > 0 && !isDeep(m, k) ? CIRCLES : CORNERS;
        double apart = owner < 0 ? m.gaps[k] : 0; // else both places are those of a corner, or of a circle's surface
        int o = STRIDE * p;
        data[o] = m.nx;
        data[o + 1] = m.ny;
        data[o + 2] = m.roundA ? 0 : m.rAx[k] - m.radiusA * m.nx;
        data[o + 3] = m.roundA ? 0 : m.rAy[k] - m.radiusA * m.ny;
        data[o + 4] = m.roundB ? 0 : m.rBx[k] + m.radiusB * m.nx;
        data[o + 5] = m.roundB ? 0 : m.rBy[k] + m.radiusB * m.ny;
        data[o + 6] = m.rAx[k] - m.rBx[k] + apart * m.nx;
        data[o + 7] = m.rAy[k] - m.rBy[k] + apart * m.ny;
        data[o + 8] = m.gaps[k];
        data[o + 9] = m.roundA ? length(m.rAx[k], m.rAy[k]) : m.radiusA;
        data[o + 10] = m.roundB ? length(m.rBx[k], m.rBy[k]) : m.radiusB;
        data[o + 11] = Math.min(length(data[o + 2], data[o + 3]) + data[o + 9], length(data[o + 4], data[o + 5]) + data[o + 10]);
        kinds[p] += (m.roundA ? 8 : 0) + (m.roundB ? 16 : 0);
    }

    private static boolean isDeep(Manifold m, int k) {
        double radiusA = m.radiusA > 0 ? m.radiusA : Double.MAX_VALUE;
        double radiusB = m.radiusB > 0 ? m.radiusB : Double.MAX_VALUE;
        return -m.gaps[k] > DEEP * Math.min(radiusA, radiusB);
    }

    /** How far bodies slide along one another at a point, relative to the shorter lever: that turns normals and levers, too. */
    double slide(int p, double dx, double dy) {
        int o = STRIDE * p;
        double way = data[o] * dy - data[o + 1] * dx;
        return Math.abs(way) / data[o + 11];
    }

    private static double length(double x, double y) {
        return Math.sqrt(x * x + y * y);
    }

    /**
     * Looks at a point when its bodies have moved.
     *
     * @param dx way of the second body's centre less that of the first one's
     * @param dy the same along y
     * @param turnA angle by which the first one has turned, rad
     * @param turnB the same of the second one
     */
    void look(int p, double dx, double dy, double turnA, double turnB) {
        int o = STRIDE * p;
        double px = data[o + 6] + dx;
        double py = data[o + 7] + dy;
        isRoundA = (kinds[p] & 8) != 0;
        isRoundB = (kinds[p] & 16) != 0;
        Trig.sinCos(isRoundA ? 0 : turnA, turns, 0); // the place of a disc is its centre
        Trig.sinCos(isRoundB ? 0 : turnB, turns, 2);
        double cosA = turns[0];
        double sinA = turns[1];
        double cosB = turns[2];
        double sinB = turns[3];
        int kind = kinds[p] & 7;
        nx = data[o];
        ny = data[o + 1];
        if (kind == EDGE_A) {
            turn(cosA, sinA);
        } else if (kind == EDGE_B) {
            turn(cosB, sinB);
        }
        ax = cosA * data[o + 2] - sinA * data[o + 3];
        ay = sinA * data[o + 2] + cosA * data[o + 3];
        bx = cosB * data[o + 4] - sinB * data[o + 5];
        by = sinB * data[o + 4] + cosB * data[o + 5];
        if (kind == CIRCLES) {
            aim(o, px, py);
        }
        ax += data[o + 9] * nx;
        ay += data[o + 9] * ny;
        bx -= data[o + 10] * nx;
        by -= data[o + 10] * ny;
        measure(o, kind, px, py);
        if (kind == EDGE_A) {
            ax = px + bx;
            ay = py + by;
        } else if (kind == EDGE_B) {
            bx = ax - px;
            by = ay - py;
        }
    }

    private void turn(double cos, double sin) {
        double x = cos * nx - sin * ny;
        ny = sin * nx + cos * ny;
        nx = x;
    }

    /** The normal from a corner or centre to a centre. */
    private void aim(int o, double px, double py) {
        double x = px - ax + bx;
        double y = py - ay + by;
        double distance = length(x, y);
        double before = between(o);
        gap = data[o + 8] + (distance - before);
        nx = x / distance;
        ny = y / distance;
    }

    /** How far the corner or centre was from the centre. */
    private double between(int o) {
        double x = data[o + 6] - data[o + 2] + data[o + 4];
        double y = data[o + 7] - data[o + 3] + data[o + 5];
        return length(x, y);
    }

    private void measure(int o, int kind, double px, double py) {
        if (kind == CIRCLES) {
            return;
        }
        double x = px;
        double y = py;
        double x0 = data[o + 6];
        double y0 = data[o + 7];
        if (kind != EDGE_B) {
            x += bx;
            y += by;
            x0 += data[o + 4] - data[o + 10] * data[o];
            y0 += data[o + 5] - data[o + 10] * data[o + 1];
        }
        if (kind != EDGE_A) {
            x -= ax;
            y -= ay;
            x0 -= data[o + 2] + data[o + 9] * data[o];
            y0 -= data[o + 3] + data[o + 9] * data[o + 1];
        }
        gap = data[o + 8] + (nx * x + ny * y) - (data[o] * x0 + data[o + 1] * y0);
    }

    /** What turns the first body when an impulse acts along the normal. */
    double leverA() {
        return isRoundA ? 0 : ax * ny - ay * nx;
    }

    double leverB() {
        return isRoundB ? 0 : bx * ny - by * nx;
    }

    /** The same along the tangent. */
    double armA() {
        return ax * nx + ay * ny;
    }

    double armB() {
        return bx * nx + by * ny;
    }
}
