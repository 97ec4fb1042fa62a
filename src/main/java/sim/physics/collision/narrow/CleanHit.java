// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

/**
 * Whether a corner hits an edge so far from the edge's ends, and so far from lying flat on it, that no other edge can have
 * all of the other body on its line or beyond it: then the two do not graze one another, and {@link TimeOfImpact#graze} need
 * not look at all edges of both.
 */
final class CleanHit {
    /** How many tolerances of the gap one body must reach over the line of each other edge. */
    private static final double CLEAR = 1000;

    private CleanHit() {}

    /**
     * Whether a hit is clean; false may also mean not known.
     *
     * @param shape the data of a {@link ShapeTable}
     * @param owner where the shape begins that has the edge
     * @param edge the edge that is hit
     * @param at where on it, from its vertex, length
     * @param margin how far the place may be from there, length
     * @param other where the shape begins that has the corner
     * @param corner the corner
     * @param ox the edge's normal in the frame of that shape, at an instant before
     * @param oy the edge's normal in the frame of that shape
     * @param turn bound of the angle by which the bodies turn to one another since then
     * @param tolerance gap at which surfaces touch, length
     */
    static boolean is(
            double[] shape, int owner, int edge, double at, double margin, int other, int corner, double ox, double oy,
            double turn, double tolerance) {
        double least = CLEAR * tolerance;
        int e = owner + ShapeTable.FIRST + ShapeTable.VERTEX * edge;
        double arm = Math.min(at, shape[e + ShapeTable.LENGTH] - at) - margin;
        double x = shape[e] - shape[e + ShapeTable.NY] * at;
        double y = shape[e + 1] + shape[e + ShapeTable.NX] * at;
        int before = corner == 0 ? (int) shape[other + ShapeTable.COUNT] - 1 : corner - 1;
        int c = other + ShapeTable.FIRST + ShapeTable.VERTEX * corner;
        return shape[owner + ShapeTable.ROUNDING] + shape[other + ShapeTable.ROUNDING] == 0
                && arm > least
                && isWithin(shape, owner, x, y, edge, edge, margin + least)
                && isWithin(shape, other, shape[c], shape[c + 1], corner, before, least)
                && rises(shape, other, corner, ox, oy, turn, least / arm)
                && rises(shape, other, before, -ox, -oy, turn, least / arm);
    }

    /** Whether a point lies deeper than a depth under all edges of a shape but two. */
    private static boolean isWithin(double[] shape, int base, double x, double y, int edge, int another, double depth) {
        boolean is = true;
        int n = (int) shape[base + ShapeTable.COUNT];
        for (int k = 0, e = base + ShapeTable.FIRST; k < n; k++, e += ShapeTable.VERTEX) {
            double own = shape[e + ShapeTable.H] - (shape[e + ShapeTable.NX] * x + shape[e + ShapeTable.NY] * y);
            is &= own > depth | k == edge | k == another;
        }
        return is;
    }

    /** Whether an edge goes up along a direction by more than a slope, also if it turns first. */
    private static boolean rises(double[] shape, int base, int edge, double dx, double dy, double turn, double slope) {
        int e = base + ShapeTable.FIRST + ShapeTable.VERTEX * edge;
        return shape[e + ShapeTable.NX] * dy - shape[e + ShapeTable.NY] * dx > turn + slope;
    }
}
