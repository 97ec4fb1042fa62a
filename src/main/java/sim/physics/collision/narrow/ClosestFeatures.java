// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import sim.physics.internal.Tolerances;

/**
 * The closest features of two convex shapes, the write-up's <i>Narrow Phase</i> (after Lin and Canny 1991, Mirtich
 * 1998): the pair of features of which the closest point of each lies in the Voronoi region of the other.
 *
 * <p>The pair that was closest last time is tried first and believed only if it still holds that certificate; else the
 * likely candidates, then all pairs are searched. If no pair holds it, the shapes touch or penetrate, and the edge of
 * least penetration is taken.
 *
 * <p><b>Correction of the write-up.</b> Its test of a vertex's Voronoi region (Figures 6 and 7) projects on the two
 * rays that bound the region, which is right only where the edges meet at a right angle. Here a point is in the region
 * if it lies beyond the end of the incoming edge and before the start of the outgoing edge.
 *
 * <p>All coordinates are relative to the centre of body A.
 */
final class ClosestFeatures {
    /** How far outside a region a point may lie and still count as inside, relative to the sizes of the bodies. */
    private static final double REGION_TOLERANCE = 1e-13;

    /** A feature code: 2·index for a vertex, 2·index + 1 for the edge from that vertex to the next. */
    static final int NO_FEATURES = -1;

    private final Pose pose;

    /** The closest features of A and B. */
    int featureA;

    int featureB;

    /** Distance of the surfaces, length; negative if they penetrate. */
    double gap;

    /** Unit normal from A to B. */
    double nx;

    double ny;

    ClosestFeatures(Pose pose) {
        this.pose = pose;
    }

    /**
     * Finds the closest features at the present pose.
     *
     * @param cached the code of the features to try first, or {@link #NO_FEATURES}
     * @return the code of the features found
     */
    int find(int cached) {
        if (cached != NO_FEATURES && check(cached >> 16, cached & 0xffff)) {
            return cached;
        }
        if (!searchNearCentreLine() && !penetrates() && !searchAll()) {
            takeLeastPenetration();
        }
        return featureA << 16 | featureB;
    }

    /** Tries the vertices that are extreme along the line of centres, and their edges. */
    private boolean searchNearCentreLine() {
        int i = pose.a.support(pose.px, pose.py);
        int j = pose.b.support(-pose.px, -pose.py);
        int na = pose.a.n;
        int nb = pose.b.n;
        return nb > 1 && (check(2 * i, 2 * j + 1) || check(2 * i, 2 * ((j + nb - 1) % nb) + 1))
                || na > 1 && (check(2 * i + 1, 2 * j) || check(2 * ((i + na - 1) % na) + 1, 2 * j))
                || check(2 * i, 2 * j);
    }

    /**
     * Whether no edge's line has the core of the other body beyond it; then the edge of least penetration is taken. A
     * circle that reaches over the line of an edge may still be off the corner.
     */
    private boolean penetrates() {
        takeLeastPenetration();
        return gap <= -pose.rounding;
    }

    private boolean searchAll() {
        int na = pose.a.n;
        int nb = pose.b.n;
        for (int i = 0; i < na; i++) {
            for (int j = 0; j < nb; j++) {
                if (nb > 1 && check(2 * i, 2 * j + 1) || na > 1 && check(2 * i + 1, 2 * j) || check(2 * i, 2 * j)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether the closest point on each of two features lies in the Voronoi region of the other. */
    private boolean check(int fa, int fb) {
        if ((fb & 1) != 0) {
            return pose.b.n > 1 && checkEdge(pose.b, fb >> 1, pose.a, fa >> 1, -1) && accept(fa, fb);
        }
        if ((fa & 1) != 0) {
            return pose.a.n > 1 && checkEdge(pose.a, fa >> 1, pose.b, fb >> 1, 1) && accept(fa, fb);
        }
        return checkVertices(fa >> 1, fb >> 1) && accept(fa, fb);
    }

    private boolean accept(int fa, int fb) {
        featureA = fa;
        featureB = fb;
        return true;
    }

    /**
     * An edge of one body against a vertex of the other.
     *
     * @param side +1 if the edge's outward normal is the normal from A to B, −1 if it is the opposite
     */
    private boolean checkEdge(Pose.Placed owner, int edge, Pose.Placed other, int vertex, int side) {
        double ex = owner.normalX(edge);
        double ey = owner.normalY(edge);
        double dx = other.vx[vertex] - owner.vx[edge];
        double dy = other.vy[vertex] - owner.vy[edge];
        double height = dx * ex + dy * ey;
        double along = dy * ex - dx * ey;
        double tolerance = REGION_TOLERANCE * pose.size;
        if (height < -Tolerances.CORNERS * pose.size || along < -tolerance || along > owner.length(edge) + tolerance) {
            return false;
        }
        // the point of the edge, seen from the vertex, lies along -normal: it must be in the vertex's region
        if (!VoronoiRegion.ofVertexContains(other, vertex, -ex, -ey, REGION_TOLERANCE)) {
            return false;
        }
        gap = height - pose.rounding;
        nx = side * ex;
        ny = side * ey;
        return true;
    }

    private boolean checkVertices(int i, int j) {
        double dx = pose.b.vx[j] - pose.a.vx[i];
        double dy = pose.b.vy[j] - pose.a.vy[i];
        double tolerance = REGION_TOLERANCE * pose.size;
        if (!VoronoiRegion.ofVertexContains(pose.a, i, dx, dy, tolerance)
                || !VoronoiRegion.ofVertexContains(pose.b, j, -dx, -dy, tolerance)) {
            return false;
        }
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (distance <= Tolerances.CORNERS * pose.size) {
            return false; // too close for the line between them to be a normal: an edge gives a better one
        }
        gap = distance - pose.rounding;
        nx = dx / distance;
        ny = dy / distance;
        return true;
    }

    /** The edge beyond which the other body reaches in least. */
    private void takeLeastPenetration() {
        gap = Double.NEGATIVE_INFINITY;
        takeLeastPenetration(pose.a, pose.b, 1);
        takeLeastPenetration(pose.b, pose.a, -1);
        gap -= pose.rounding;
        if (gap == Double.NEGATIVE_INFINITY) {
            takeCoincidentPoints();
        }
    }

    private void takeLeastPenetration(Pose.Placed owner, Pose.Placed other, int side) {
        for (int edge = 0; edge < owner.n && owner.n > 1; edge++) {
            double ex = owner.normalX(edge);
            double ey = owner.normalY(edge);
            int vertex = other.support(-ex, -ey);
            double height = (other.vx[vertex] - owner.vx[edge]) * ex + (other.vy[vertex] - owner.vy[edge]) * ey;
            if (height > gap) {
                gap = height;
                nx = side * ex;
                ny = side * ey;
                featureA = side > 0 ? 2 * edge + 1 : 2 * vertex;
                featureB = side > 0 ? 2 * vertex : 2 * edge + 1;
            }
        }
    }

    /** Two circles on the same point: any normal is as good as another. */
    private void takeCoincidentPoints() {
        gap = -pose.rounding;
        nx = 1;
        ny = 0;
        featureA = 0;
        featureB = 0;
    }
}
