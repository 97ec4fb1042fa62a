// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

/**
 * Where two bodies touch: one point, or the two ends of a stretch where an edge lies flush on an edge. Filled by
 * {@link NarrowPhase#contact}.
 */
public final class Manifold {
    /** Points that touch, and corners next to a single one. */
    private static final int POINTS = 4;

    /** Number of points, 1 or 2. */
    public int count;

    /** Number of points behind them that do not touch yet: the corners next to one that lies on an edge. */
    public int near;

    /** Unit normal from body A to body B. */
    public double nx;

    /** Unit normal from body A to body B. */
    public double ny;

    /** From the centre of A to each point, length. */
    public final double[] rAx = new double[POINTS];

    /** From the centre of A to each point, length. */
    public final double[] rAy = new double[POINTS];

    /** From the centre of B to each point, length. */
    public final double[] rBx = new double[POINTS];

    /** From the centre of B to each point, length. */
    public final double[] rBy = new double[POINTS];

    /** Whether A is a circle. */
    public boolean roundA;

    /** Whether B is a circle. */
    public boolean roundB;

    /** Radius of the disc by which A touches, length; 0 if it is none. It may be a part of A, and about another centre. */
    public double radiusA;

    /** The same of B. */
    public double radiusB;

    /** The body whose edge gives the normal: 0 for A, 1 for B, −1 where corners or circles meet. */
    public int owner;

    /** Whether a point is the end of that edge, on an edge of the other body, else a corner of the other body or of none. */
    public final boolean[] isEnd = new boolean[POINTS];

    /** Whether a point of two is the end of both edges. Which of the two stays on the other one's edge is said by how they slide. */
    private final boolean[] isOfBoth = new boolean[POINTS];

    /** How far a single point is from the nearer end of the edge on which it lies, length; 0 if it lies on none. */
    public double room;

    /**
     * Whether sides that lie on one line have but their ends in common, as those of a box and of the tile beside the one on which it stands:
     * either of two normals parts the bodies there.
     */
    public boolean isAtEnds;

    /** Distance of the surfaces, length; zero but for rounding. */
    public double gap;

    /** The same at each point. */
    public final double[] gaps = new double[POINTS];

    /** Makes an empty manifold. */
    public Manifold() {
        // filled again for each contact
    }

    void begin(ClosestFeatures features, Pose pose) {
        count = 0;
        near = 0;
        roundA = pose.a.isRound();
        roundB = pose.b.isRound();
        radiusA = pose.a.rounding();
        radiusB = pose.b.rounding();
        nx = features.nx;
        ny = features.ny;
        gap = features.gap;
        room = 0;
        isAtEnds = false;
        owner = (features.featureB & 1) != 0 ? 1 : (features.featureA & 1) != 0 ? 0 : -1;
        isEnd[0] = false;
        isEnd[1] = false;
        gaps[0] = gap;
        gaps[1] = gap;
    }

    /** Where two circles touch: each one's lever is its radius along the normal, exactly. */
    void touch(double normalX, double normalY, double distance, double firstRadius, double secondRadius) {
        count = 1;
        near = 0;
        roundA = true;
        roundB = true;
        nx = normalX;
        ny = normalY;
        gap = distance;
        owner = -1;
        isEnd[0] = false;
        isAtEnds = false;
        room = 0;
        gaps[0] = distance;
        gaps[1] = distance;
        radiusA = firstRadius;
        radiusB = secondRadius;
        rAx[0] = radiusA * normalX;
        rAy[0] = radiusA * normalY;
        rBx[0] = -radiusB * normalX;
        rBy[0] = -radiusB * normalY;
    }

    /**
     * Whether a fixed body can bear the other one here: a circle on an edge, or an edge on an edge with the centre of
     * mass between the ends.
     *
     * @param fixedA whether A is the fixed body, else B
     * @return false if the body would roll or tip over
     */
    public boolean bears(boolean fixedA) {
        if (count == 1) {
            return owner >= 0 && (fixedA ? roundB : roundA);
        }
        double[] rx = fixedA ? rBx : rAx;
        double[] ry = fixedA ? rBy : rAy;
        double first = ry[0] * nx - rx[0] * ny;
        double second = ry[1] * nx - rx[1] * ny;
        return first * second <= 0;
    }

    /** Takes in the stretch along which an edge lies on the owner's, given by where its ends are along that, and how near ends are one. */
    void stretch(double first, double last, double length, double near) {
        isEnd[0] = first <= 0;
        isEnd[1] = last >= length;
        isOfBoth[0] = Math.abs(first) <= near;
        isOfBoth[1] = Math.abs(last - length) <= near;
        isAtEnds = Math.min(last, length) - Math.max(first, 0) <= near;
    }

    /**
     * Says which corner is followed where those of both bodies are one point: the one that does not leave the other one's edge.
     *
     * @param point 0 or 1, of two
     * @param slip velocity of B's point relative to A's along the normal turned counter-clockwise
     */
    public void slide(int point, double slip) {
        if (isOfBoth(point) && slip != 0) {
            isEnd[point] = point == 0 == slip < 0;
        }
    }

    /**
     * Whether a point is the end of both edges.
     *
     * @param point 0 or 1
     * @return false also for a single point
     */
    public boolean isOfBoth(int point) {
        return count == 2 && isOfBoth[point];
    }

    /**
     * Says whose corner is followed at a point of two.
     *
     * @param point 0 or 1
     * @param ofA whether that of A, else that of B
     */
    public void follow(int point, boolean ofA) {
        isEnd[point] = ofA == (owner == 0);
    }

    /** Adds a point given relative to the centre of A; B's centre is at (px, py). */
    void add(double x, double y, double px, double py) {
        rAx[count] = x;
        rAy[count] = y;
        rBx[count] = x - px;
        rBy[count] = y - py;
        count++;
    }

    /** Adds a point that does not touch yet. */
    void addNear(double x, double y, double px, double py, double height) {
        gaps[count + near] = height;
        rAx[count + near] = x;
        rAy[count + near] = y;
        rBx[count + near] = x - px;
        rBy[count + near] = y - py;
        near++;
    }
}
