// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

/**
 * Voronoi regions of the features of a convex shape, Figures 5 to 8 of the write-up: the points that are closer to
 * this feature than to any other of the shape.
 */
final class VoronoiRegion {
    private VoronoiRegion() {}

    /**
     * Whether a point lies in the region of a vertex: beyond the end of the incoming edge, and before the start of the
     * outgoing edge. (The write-up's Figures 6 and 7 test against the normals of the edges, which is the same only at
     * right angles.)
     *
     * @param shape a placed shape
     * @param vertex its vertex
     * @param dx vector from the vertex to the point
     * @param dy vector from the vertex to the point
     * @param tolerance how far outside counts as inside, in the unit of the vector
     */
    static boolean ofVertexContains(Pose.Placed shape, int vertex, double dx, double dy, double tolerance) {
        if (shape.n == 1) {
            return true; // a point's region is the whole plane
        }
        int incoming = vertex == 0 ? shape.n - 1 : vertex - 1;
        // an edge's direction is its outward normal turned by +90 degrees
        double beyond = dy * shape.normalX(incoming) - dx * shape.normalY(incoming);
        double before = dy * shape.normalX(vertex) - dx * shape.normalY(vertex);
        return beyond >= -tolerance && before <= tolerance;
    }

    /**
     * The same in the frame of the shape.
     *
     * @param shapes the data of a {@link ShapeTable}
     * @param base where the shape begins there
     */
    static boolean ofVertexContains(double[] shapes, int base, int vertex, double dx, double dy, double tolerance) {
        int n = (int) shapes[base + ShapeTable.COUNT];
        if (n == 1) {
            return true;
        }
        int o = base + ShapeTable.FIRST + ShapeTable.VERTEX * vertex;
        int i = base + ShapeTable.FIRST + ShapeTable.VERTEX * (vertex == 0 ? n - 1 : vertex - 1);
        double beyond = dy * shapes[i + ShapeTable.NX] - dx * shapes[i + ShapeTable.NY];
        double before = dy * shapes[o + ShapeTable.NX] - dx * shapes[o + ShapeTable.NY];
        return beyond >= -tolerance && before <= tolerance;
    }
}
