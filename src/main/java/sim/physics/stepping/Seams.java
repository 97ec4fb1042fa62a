// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.broad.Pairs;
import sim.physics.internal.Growth;
import sim.physics.motion.State;
import sim.physics.motion.Steering;

/**
 * Where what is fixed near a body joins: edges of a fixed polygon that another one covers, and corners of it that are none of the two together. A
 * body on a floor of tiles is then pushed as by one floor. All is in the frame of that polygon. What goes as it does, as its author says, is fixed there.
 */
final class Seams implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Distance that is none, relative to the fixed polygon. */
    private static final double NEAR = 1e-6;

    /** Sine of an angle that is none. */
    private static final double FLAT = 1e-6;

    /** Others that are looked at for one polygon. */
    private static final int MOST = 8;

    /** Part of an edge that is none. */
    private static final double GAP = 1e-5;

    /** Values of a ray: the corner that it starts in, and its direction. */
    private static final int RAY = 3;

    private final State state;
    private final Poses poses;
    private final NearPairs near;

    private Hull hull;
    /** Distance that is none. */
    double distance;

    /** The other polygon's frame in that of the one. */
    private Hull other;

    private double cos;
    private double sin;
    private double x;
    private double y;

    /** [from, to] of each edge's length that each of the others covers, and how many there are of an edge. */
    private double[] covers = {};

    private int[] covered = {};

    /** Along which the others go on from corners of the one. */
    private double[] rays = {};

    private int rayCount;
    private int found;

    Seams(State state, Poses poses, NearPairs near) {
        this.state = state;
        this.poses = poses;
        this.near = near;
    }

    /**
     * Looks for what joins a fixed polygon among what else is near a body.
     *
     * @return whether something does
     */
    boolean find(int body, int fixed, int part) {
        hull = poses.hull(fixed).part(part);
        distance = NEAR * hull.bounding;
        found = 0;
        rayCount = 0;
        if (covered.length < hull.count) {
            covered = new int[hull.count];
            covers = new double[2 * MOST * hull.count];
        }
        Arrays.fill(covered, 0, hull.count, 0);
        Pairs pairs = near.pairs();
        for (int k = 0; k < pairs.countOf(body) && found < MOST; k++) {
            int pair = pairs.of(body, k);
            boolean isFirst = pairs.first(pair) == body;
            int by = isFirst ? pairs.second(pair) : pairs.first(pair);
            int byPart = isFirst ? pairs.secondPart(pair) : pairs.firstPart(pair);
            boolean isOther = by != fixed || byPart != part;
            if (isOther && isOne(fixed, by) && !near.is(pair, NearPairs.FORBIDDEN) && !near.is(pair, NearPairs.IGNORED)) {
                join(fixed, by, poses.hull(by).part(byPart));
            }
        }
        return found > 0;
    }

    /** Whether another body is fixed as the one is, or goes as it does. */
    private boolean isOne(int fixed, int by) {
        return by == fixed || poses.isGround(by) && Steering.goAsOne(state.body(fixed), state.body(by));
    }

    private void join(int fixed, int by, Hull byHull) {
        if (byHull.count == 1) {
            return;
        }
        place(fixed, by);
        double reach = hull.bounding + byHull.bounding + distance;
        if (x * x + y * y > reach * reach) {
            return;
        }
        other = byHull;
        boolean joins = false;
        for (int k = 0; k < hull.count; k++) {
            joins |= corner(k);
            joins |= cover(k);
        }
        found += joins ? 1 : 0;
    }

    private void place(int fixed, int by) {
        double[] at = state.x();
        double cosA = poses.turns[2 * fixed];
        double sinA = poses.turns[2 * fixed + 1];
        double cosB = poses.turns[2 * by];
        double sinB = poses.turns[2 * by + 1];
        double dx = at[State.BLOCK * by] - at[State.BLOCK * fixed];
        double dy = at[State.BLOCK * by + 1] - at[State.BLOCK * fixed + 1];
        cos = cosA * cosB + sinA * sinB;
        sin = cosA * sinB - sinA * cosB;
        x = cosA * dx + sinA * dy;
        y = cosA * dy - sinA * dx;
    }

    /** Whether the other polygon has a corner of this one on it or in it, and goes on from there along its own edges. */
    private boolean corner(int k) {
        double px = hull.x[k] - x;
        double py = hull.y[k] - y;
        double ux = cos * px + sin * py;
        double uy = cos * py - sin * px;
        int on = -1;
        int before = -1;
        for (int j = 0; j < other.count; j++) {
            double height = other.nx[j] * (ux - other.x[j]) + other.ny[j] * (uy - other.y[j]);
            if (height > distance) {
                return false;
            }
            if (height >= -distance) {
                before = on;
                on = j;
            }
        }
        if (on < 0) {
            ray(k, 1, 0);
            ray(k, -1, 0);
            ray(k, 0, 1);
            ray(k, 0, -1);
        } else {
            boolean isCorner = before >= 0;
            boolean isTurned = isCorner && other.next(before) != on; // the first edge follows on the last one
            int from = isTurned || !isCorner ? on : before;
            int to = isTurned ? before : on;
            ray(k, other.ny[from], -other.nx[from]);
            ray(k, -other.ny[to], other.nx[to]);
        }
        return true;
    }

    private void ray(int corner, double dx, double dy) {
        if (rays.length < RAY * (rayCount + 1)) {
            rays = Arrays.copyOf(rays, Growth.length(rays.length, RAY * (rayCount + 1)));
        }
        int o = RAY * rayCount++;
        rays[o] = corner;
        rays[o + 1] = cos * dx - sin * dy;
        rays[o + 2] = sin * dx + cos * dy;
    }

    /** The part of an edge that the other polygon lies on. */
    private boolean cover(int k) {
        int next = hull.next(k);
        double px = hull.x[k] + 2 * distance * hull.nx[k] - x;
        double py = hull.y[k] + 2 * distance * hull.ny[k] - y;
        double ex = hull.x[next] - hull.x[k];
        double ey = hull.y[next] - hull.y[k];
        double from = 0;
        double to = 1;
        for (int j = 0; j < other.count && from < to; j++) {
            double nx = cos * other.nx[j] - sin * other.ny[j];
            double ny = sin * other.nx[j] + cos * other.ny[j];
            double height = nx * px + ny * py - other.nx[j] * other.x[j] - other.ny[j] * other.y[j] - distance;
            double slope = nx * ex + ny * ey;
            if (slope > 0) {
                to = Math.min(to, -height / slope);
            } else if (slope < 0) {
                from = Math.max(from, -height / slope);
            } else if (height > 0) {
                return false;
            }
        }
        if (from < to) {
            int o = 2 * (MOST * k + covered[k]++);
            covers[o] = from;
            covers[o + 1] = to;
        }
        return from < to;
    }

    /** Whether others cover all of an edge, so that nothing can meet it. */
    boolean isCovered(int edge) {
        double until = 0;
        for (int k = 0; k < covered[edge]; k++) {
            for (int m = 0; m < covered[edge]; m++) {
                int o = 2 * (MOST * edge + m);
                until = covers[o] <= until + GAP && covers[o + 1] > until ? covers[o + 1] : until;
            }
        }
        return covered[edge] > 0 && until >= 1 - GAP;
    }

    /** Whether a corner sticks out of all that meets in it, along a direction. */
    boolean sticksOut(int corner, double nx, double ny) {
        boolean does = true;
        for (int k = 0; k < rayCount; k++) {
            int o = RAY * k;
            does &= rays[o] != corner || nx * rays[o + 1] + ny * rays[o + 2] < -FLAT;
        }
        return does;
    }

    /** Whether something rises from a corner along a direction, beyond the corner itself. */
    boolean isHidden(int corner, double nx, double ny) {
        boolean is = false;
        for (int k = 0; k < rayCount; k++) {
            int o = RAY * k;
            is |= rays[o] == corner && nx * rays[o + 1] + ny * rays[o + 2] > FLAT;
        }
        return is;
    }

    /** Whether an edge with a normal goes straight on beyond one of its corners, and nothing rises there. */
    boolean goesOn(int corner, double nx, double ny, boolean isEnd) {
        boolean does = false;
        for (int k = 0; k < rayCount; k++) {
            int o = RAY * k;
            double along = nx * rays[o + 2] - ny * rays[o + 1];
            does |= rays[o] == corner && Math.abs(nx * rays[o + 1] + ny * rays[o + 2]) <= FLAT && isEnd == along > 0;
        }
        return does && !isHidden(corner, nx, ny);
    }
}
