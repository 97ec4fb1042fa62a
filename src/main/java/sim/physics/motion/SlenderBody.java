// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;

/**
 * Friction of a slender polygon that turns around a centre beside it, which is many widths but not many lengths away.
 * The polygon is cut across its longest edge at its vertices, and the pieces are halved until they are short in relation
 * to their distance from the centre. Then Gauss's quadrature is accurate to rounding: along with eight nodes, across
 * with four.
 */
final class SlenderBody implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Distance of the centre from a piece, relative to its length, at which quadrature is accurate. */
    private static final double APART = 2;

    /** Length, relative to the polygon's, of pieces that are too short to be divided. */
    private static final double NEGLIGIBLE = 1e-14;

    // spotless:off
    /** Gauss's quadrature on [0, 1]. */
    private static final double[] ALONG = {
        0.019855071751231884, 0.10166676129318664, 0.2372337950418355, 0.4082826787521751,
        0.591717321247825,    0.7627662049581645,  0.8983332387068134, 0.9801449282487681
    };
    private static final double[] WEIGHT_ALONG = {
        0.05061426814518813, 0.11119051722668724, 0.15685332293894363, 0.18134189168918100,
        0.18134189168918100, 0.15685332293894363, 0.11119051722668724, 0.05061426814518813
    };
    private static final double[] ACROSS = {
        0.06943184420297371, 0.33000947820757187, 0.6699905217924281, 0.9305681557970263
    };
    private static final double[] WEIGHT_ACROSS = {
        0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693
    };
    // spotless:on

    /** Vertices in the frame whose x axis is the longest edge, counter-clockwise; the first has the least x. */
    private final double[] xy;

    private final double axisX;
    private final double axisY;
    private final double shortest;

    SlenderBody(double[] vertices) {
        int n = vertices.length;
        int longest = 0;
        for (int k = 0; k < n; k += 2) {
            longest = edge(vertices, k) > edge(vertices, longest) ? k : longest;
        }
        double length = edge(vertices, longest);
        axisX = (vertices[(longest + 2) % n] - vertices[longest]) / length;
        axisY = (vertices[(longest + 3) % n] - vertices[longest + 1]) / length;
        shortest = NEGLIGIBLE * length;
        int first = 0;
        for (int k = 0; k < n; k += 2) {
            first = along(vertices, k) < along(vertices, first) ? k : first;
        }
        xy = new double[n];
        for (int k = 0; k < n; k += 2) {
            int at = (first + k) % n;
            xy[k] = along(vertices, at);
            xy[k + 1] = axisX * vertices[at + 1] - axisY * vertices[at];
        }
    }

    private static double edge(double[] v, int k) {
        return StrictMath.hypot(v[(k + 2) % v.length] - v[k], v[(k + 3) % v.length] - v[k + 1]);
    }

    private double along(double[] v, int k) {
        return axisX * v[k] + axisY * v[k + 1];
    }

    /** Takes the integrals of e = (r − c)/|r − c| and of r·e to out. */
    void integrals(double cx, double cy, double[] out) {
        double x = axisX * cx + axisY * cy;
        double y = axisX * cy - axisY * cx;
        out[0] = 0;
        out[1] = 0;
        out[2] = 0;
        int low = 0;
        int high = xy.length;
        double from = xy[0];
        while (high - low > 2) {
            // the piece between the edge low → low + 2 and the edge high → high − 2; vertex n is vertex 0
            double lowEnd = xy[low + 2];
            double highEnd = xy[high - 2];
            double to = Math.min(lowEnd, highEnd);
            if (to > from) {
                addPiece(from, height(low, low + 2, from), height(high, high - 2, from), to, height(low, low + 2, to),
                        height(high, high - 2, to), x, y, out);
                from = to;
            }
            if (lowEnd <= highEnd) {
                low += 2;
            } else {
                high -= 2;
            }
        }
        double ex = out[0];
        out[0] = axisX * ex - axisY * out[1];
        out[1] = axisY * ex + axisX * out[1];
    }

    /** Height of an edge between two vertices at x. */
    private double height(int vertex, int other, double x) {
        int k = vertex % xy.length;
        double part = (x - xy[k]) / (xy[other] - xy[k]);
        return xy[k + 1] + part * (xy[other + 1] - xy[k + 1]);
    }

    /** Adds the integrals over the trapezium between x0 and x1 whose sides go from l0 to h0 and from l1 to h1. */
    private void addPiece(
            double x0, double l0, double h0, double x1, double l1, double h1, double cx, double cy, double[] out) {
        double length = x1 - x0;
        double dx = 0.5 * (x0 + x1) - cx;
        double dy = 0.25 * (l0 + h0 + l1 + h1) - cy;
        if (length > shortest && dx * dx + dy * dy < APART * APART * length * length) {
            double x = 0.5 * (x0 + x1);
            double l = 0.5 * (l0 + l1);
            double h = 0.5 * (h0 + h1);
            addPiece(x0, l0, h0, x, l, h, cx, cy, out);
            addPiece(x, l, h, x1, l1, h1, cx, cy, out);
            return;
        }
        for (int i = 0; i < ALONG.length; i++) {
            double x = x0 + ALONG[i] * length;
            double low = l0 + ALONG[i] * (l1 - l0);
            double width = h0 - l0 + ALONG[i] * (h1 - l1 - (h0 - l0));
            double share = WEIGHT_ALONG[i] * length * width;
            for (int j = 0; j < ACROSS.length; j++) {
                add(x, low + ACROSS[j] * width, cx, cy, share * WEIGHT_ACROSS[j], out);
            }
        }
    }

    private static void add(double x, double y, double cx, double cy, double area, double[] out) {
        double ex = x - cx;
        double ey = y - cy;
        double share = area / Math.max(Math.sqrt(ex * ex + ey * ey), Double.MIN_NORMAL);
        out[0] += share * ex;
        out[1] += share * ey;
        out[2] += share * (x * ex + y * ey);
    }
}
