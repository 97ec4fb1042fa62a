// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import sim.physics.motion.State;

/**
 * Where two bodies touch, or would soon: a normal from the first to the second one and up to two points with their gaps. Polygons
 * by the direction in which they are farthest apart or least deep in one another (separating axes), and the edge that faces it,
 * clipped to the other one's.
 */
final class Touch implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Depth, relative to the size, by which the second body's edge must be the better one to be taken: else edges change places. */
    private static final double PREFERENCE = 1e-3;

    /** Depth, relative to the size, from which on a way out that others do not cover is none: the other side of a tile below tiles. */
    private static final double COVERED = 0.5;

    /** Cosine of the angle to a side that others cover from which on a way out leads through to the other side. */
    private static final double THROUGH = -0.5;

    private final Poses poses;
    private final State state;
    private final Seams seams;
    private final Passing passing;

    /** Whether the first or the second hull is fixed and joins others; whether the one does whose edges are asked for, or the one over them. */
    private boolean joinsFirst;

    private boolean joinsSecond;
    private boolean joinsOn;
    private boolean joinsOther;

    int count;
    double nx;
    double ny;

    /** Per point: place in the world relative to the first body's centre, gap, and which features these are. */
    final double[] px = new double[2];

    final double[] py = new double[2];
    final double[] gap = new double[2];
    final int[] feature = new int[2];

    /** Whether the two are discs, whose points do not go along when they turn. */
    boolean isDiscA;

    boolean isDiscB;

    /** What turns the normal, and the middles of what is round, or the corner, from the bodies' centres ({@link ContactTurns}). */
    int turnsBy;

    double middleAX;
    double middleAY;
    double middleBX;
    double middleBY;

    /** Of an edge beside that corner, the one that the disc is beyond: its normal, and the way along it, from the corner. */
    double edgeX;

    double edgeY;
    double alongX;
    double alongY;

    /** The second body's centre from the first one's. */
    private double dx;

    private double dy;

    /** The edge that was found by {@link #separation}, and that separation. */
    private int edge;

    private int corner;

    /** The size of the smaller one of two polygons, and whether they face one another along a slight part of their edges only. */
    private double size;

    private boolean isSlight;

    Touch(State state, Poses poses, NearPairs near) {
        this.state = state;
        this.poses = poses;
        seams = new Seams(state, poses, near);
        passing = new Passing(state, poses, near);
    }

    /** Finds the points of two bodies' parts whose gaps are at most a margin. */
    void find(int a, int partA, int b, int partB, double margin) {
        double[] x = state.x();
        int i = State.BLOCK * a;
        int k = State.BLOCK * b;
        dx = x[k] - x[i];
        dy = x[k + 1] - x[i + 1];
        Hull first = poses.hull(a).part(partA);
        Hull second = poses.hull(b).part(partB);
        isDiscA = first == poses.hull(a) && first.count == 1;
        isDiscB = second == poses.hull(b) && second.count == 1;
        isSlight = false;
        meet(a, first, b, second, margin);
        if (count > 0 && (poses.isGround(a) || poses.isGround(b))) {
            boolean isFirstFixed = poses.isGround(a);
            Hull fixed = isFirstFixed ? first : second;
            if (fixed.count > 1 && (isFirstFixed ? seams.find(b, a, partA) : seams.find(a, b, partB))) {
                joinsFirst = isFirstFixed;
                joinsSecond = !isFirstFixed;
                meet(a, first, b, second, margin);
                joinsFirst = false;
                joinsSecond = false;
            }
        }
        if (count > 0 && isSlight && passing.passes(a, partA, b, partB, this, size)) {
            count = 0;
        }
    }

    private void meet(int a, Hull first, int b, Hull second, double margin) {
        count = 0;
        joinsOn = joinsFirst || joinsSecond;
        if (first.count > 1 && second.count > 1) {
            edges(a, b, first, second, margin);
        } else if (first.count == 1 && second.count == 1) {
            circles(a, first, b, second, margin);
        } else if (first.count > 1) {
            roundOn(a, first, second.radius, dx + offsetX(b, second), dy + offsetY(b, second), margin, false);
        } else {
            roundOn(b, second, first.radius, offsetX(a, first) - dx, offsetY(a, first) - dy, margin, true);
        }
    }

    /** Where a disc's centre is from that of its body, which it is a part of. */
    private double offsetX(int body, Hull disc) {
        return disc.bounding == disc.radius ? 0 : poses.turns[2 * body] * disc.x[0] - poses.turns[2 * body + 1] * disc.y[0];
    }

    private double offsetY(int body, Hull disc) {
        return disc.bounding == disc.radius ? 0 : poses.turns[2 * body + 1] * disc.x[0] + poses.turns[2 * body] * disc.y[0];
    }

    private void circles(int a, Hull first, int b, Hull second, double margin) {
        double x = offsetX(a, first);
        double y = offsetY(a, first);
        double cx = dx + offsetX(b, second) - x;
        double cy = dy + offsetY(b, second) - y;
        double square = cx * cx + cy * cy;
        double sum = first.radius + second.radius;
        if (square > (sum + margin) * (sum + margin)) {
            return;
        }
        double distance = Math.sqrt(square);
        nx = distance > 0 ? cx / distance : 1;
        ny = distance > 0 ? cy / distance : 0;
        double way = 0.5 * (first.radius + distance - second.radius);
        turnsBy = ContactTurns.BETWEEN;
        setMiddles(x, y, x + cx, y + cy);
        add(x + way * nx, y + way * ny, distance - sum, 0);
    }

    /** Notes what is round, or the corner; both from the first body's centre. */
    private void setMiddles(double x, double y, double otherX, double otherY) {
        middleAX = x;
        middleAY = y;
        middleBX = otherX - dx;
        middleBY = otherY - dy;
    }

    private void setEdge(double x, double y, double side, double way) {
        edgeX = side * x;
        edgeY = side * y;
        alongX = -way * y;
        alongY = way * x;
    }

    /** {@return how far the point of what is round is from its middle, or from the corner, along the normal} */
    double reach() {
        return turnsBy == ContactTurns.FIRST + ContactTurns.ROUND
                ? nx * (px[0] - dx - middleBX) + ny * (py[0] - dy - middleBY)
                : nx * (px[0] - middleAX) + ny * (py[0] - middleAY);
    }

    private void add(double x, double y, double distance, int id) {
        px[count] = x;
        py[count] = y;
        gap[count] = distance;
        feature[count++] = id;
    }

    /** A circle on a polygon, whose centre is (cx, cy) from the polygon's; the circle is the second body unless it is the other way. */
    private void roundOn(int polygon, Hull hull, double radius, double cx, double cy, double margin, boolean isOther) {
        double cos = poses.turns[2 * polygon];
        double sin = poses.turns[2 * polygon + 1];
        double x = cos * cx + sin * cy;
        double y = cos * cy - sin * cx;
        int best = facing(hull, x, y, false);
        double most = height(hull, best, x, y);
        if (joinsOn && seams.isCovered(best)) {
            int open = facing(hull, x, y, true);
            if (most > 0 || open < 0 || height(hull, open, x, y) < -COVERED * radius && leadsThrough(hull, open, x, y)) {
                return;
            }
            best = open;
            most = height(hull, open, x, y);
        }
        if (most > radius + margin) {
            return;
        }
        double n0 = hull.nx[best];
        double n1 = hull.ny[best];
        double distance = most;
        turnsBy = ContactTurns.ROUND + (isOther ? ContactTurns.SECOND : ContactTurns.FIRST);
        double cornerX = 0;
        double cornerY = 0;
        if (most > 0) {
            int next = hull.next(best);
            double along = n0 * (y - hull.y[best]) - n1 * (x - hull.x[best]);
            double length = n0 * (hull.y[next] - hull.y[best]) - n1 * (hull.x[next] - hull.x[best]);
            if (along < 0 || along > length) {
                int near = along < 0 ? best : next;
                double ex = x - hull.x[near];
                double ey = y - hull.y[near];
                distance = Math.sqrt(ex * ex + ey * ey);
                if (distance > radius + margin || joinsOn && seams.isHidden(near, ex / distance, ey / distance)) {
                    return;
                }
                if (joinsOn && seams.goesOn(near, n0, n1, along > length)) {
                    distance = most; // over a seam, but for rounding: no corner to go round
                } else {
                    n0 = ex / distance;
                    n1 = ey / distance;
                    turnsBy = ContactTurns.BETWEEN + (isOther ? ContactTurns.ON_SECOND : ContactTurns.ROUND);
                    setEdge(cos * hull.nx[best] - sin * hull.ny[best], sin * hull.nx[best] + cos * hull.ny[best], isOther ? -1 : 1, along < 0 ? 1 : -1);
                    cornerX = cos * hull.x[near] - sin * hull.y[near];
                    cornerY = sin * hull.x[near] + cos * hull.y[near];
                }
            }
        }
        double wx = cos * n0 - sin * n1;
        double wy = sin * n0 + cos * n1;
        double back = 0.5 * (distance + radius); // half way between the surfaces
        double x0 = cx - back * wx;
        double y0 = cy - back * wy;
        nx = isOther ? -wx : wx;
        ny = isOther ? -wy : wy;
        setMiddles(isOther ? dx + cx : cornerX, isOther ? dy + cy : cornerY, isOther ? dx + cornerX : cx, isOther ? dy + cornerY : cy);
        add(isOther ? x0 + dx : x0, isOther ? y0 + dy : y0, distance - radius, 0);
    }

    /** The edge that a place is highest over, of all or of those that nothing covers; −1 for none. */
    private int facing(Hull hull, double x, double y, boolean isOpen) {
        int best = isOpen ? -1 : 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < hull.count; k++) {
            double height = height(hull, k, x, y);
            if (height > most && !(isOpen && seams.isCovered(k))) {
                most = height;
                best = k;
            }
        }
        return best;
    }

    /** Whether the way out by an edge leads through to the other side of one that others cover and that is nearer. */
    private boolean leadsThrough(Hull hull, int edge, double x, double y) {
        boolean does = false;
        for (int k = 0; k < hull.count; k++) {
            boolean isOpposite = hull.nx[k] * hull.nx[edge] + hull.ny[k] * hull.ny[edge] < THROUGH;
            does |= isOpposite && seams.isCovered(k) && height(hull, k, x, y) > height(hull, edge, x, y);
        }
        return does;
    }

    private static double height(Hull hull, int edge, double x, double y) {
        return hull.nx[edge] * (x - hull.x[edge]) + hull.ny[edge] * (y - hull.y[edge]);
    }

    private void edges(int a, int b, Hull first, Hull second, double margin) {
        double cosA = poses.turns[2 * a];
        double sinA = poses.turns[2 * a + 1];
        double cosB = poses.turns[2 * b];
        double sinB = poses.turns[2 * b + 1];
        double cos = cosA * cosB + sinA * sinB; // the second frame in the first one
        double sin = cosA * sinB - sinA * cosB;
        double x = cosA * dx + sinA * dy;
        double y = cosA * dy - sinA * dx;
        joinsOn = joinsFirst;
        joinsOther = joinsSecond;
        double byFirst = separation(first, second, cos, sin, x, y);
        if (byFirst > margin) {
            return;
        }
        int edgeA = edge;
        int cornerB = corner;
        double bx = -(cos * x + sin * y); // the first centre in the second frame
        double by = sin * x - cos * y;
        joinsOn = joinsSecond;
        joinsOther = joinsFirst;
        double bySecond = separation(second, first, cos, -sin, bx, by);
        size = Math.min(first.bounding, second.bounding);
        if (bySecond > margin) {
            return;
        }
        boolean isSecond = bySecond > byFirst + PREFERENCE * size;
        double most = Math.max(byFirst, bySecond);
        boolean isDeep = (joinsFirst || joinsSecond) && most < -COVERED * size;
        if (isDeep && (joinsFirst
                ? leadsThrough(first, second, cos, sin, x, y, most, !isSecond, isSecond ? edge : edgeA)
                : leadsThrough(second, first, cos, -sin, bx, by, most, isSecond, isSecond ? edge : edgeA))) {
            return;
        }
        if (isSecond) {
            clip(second, first, edge, corner, cos, -sin, bx, by, margin);
            turnsBy = turnsBy == ContactTurns.STILL ? turnsBy : ContactTurns.SECOND;
            toWorld(cosB, sinB, dx, dy, true);
        } else {
            joinsOn = joinsFirst;
            joinsOther = joinsSecond;
            clip(first, second, edgeA, cornerB, cos, sin, x, y, margin);
            toWorld(cosA, sinA, 0, 0, false);
        }
    }

    /** The largest distance of an edge's line from all of another hull, which is turned and put at (x, y) in the frame of the first. */
    private double separation(Hull on, Hull other, double cos, double sin, double x, double y) {
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < on.count; k++) {
            double n0 = on.nx[k];
            double n1 = on.ny[k];
            double turnedX = cos * n0 + sin * n1; // the normal in the other frame
            double turnedY = cos * n1 - sin * n0;
            int nearest = other.lowest(turnedX, turnedY);
            double least = turnedX * other.x[nearest] + turnedY * other.y[nearest];
            least += n0 * (x - on.x[k]) + n1 * (y - on.y[k]);
            boolean isNone = joinsOn && seams.isCovered(k) || joinsOther && !seams.sticksOut(nearest, -turnedX, -turnedY);
            if (least > most && !isNone) {
                most = least;
                edge = k;
                corner = nearest;
            }
        }
        return most;
    }

    /**
     * Whether the way out of a fixed hull, by an edge of its own or of the other one, leads through to the other side of an edge that others cover and that is
     * nearer.
     */
    private boolean leadsThrough(
            Hull fixed, Hull other, double cos, double sin, double x, double y, double most, boolean isOwn, int edge) {
        double wayX = isOwn ? fixed.nx[edge] : sin * other.ny[edge] - cos * other.nx[edge];
        double wayY = isOwn ? fixed.ny[edge] : -(sin * other.nx[edge] + cos * other.ny[edge]);
        boolean does = false;
        for (int k = 0; k < fixed.count; k++) {
            boolean isOpposite = fixed.nx[k] * wayX + fixed.ny[k] * wayY < THROUGH;
            does |= isOpposite && seams.isCovered(k) && separation(fixed, k, other, cos, sin, x, y) > most;
        }
        return does;
    }

    /** The distance of an edge's line from all of another hull. */
    private static double separation(Hull on, int edge, Hull other, double cos, double sin, double x, double y) {
        double n0 = on.nx[edge];
        double n1 = on.ny[edge];
        double turnedX = cos * n0 + sin * n1;
        double turnedY = cos * n1 - sin * n0;
        int nearest = other.lowest(turnedX, turnedY);
        return turnedX * other.x[nearest] + turnedY * other.y[nearest] + n0 * (x - on.x[edge]) + n1 * (y - on.y[edge]);
    }

    /** The points of the other hull's edge over an edge, in the frame of the hull that the edge is of. */
    private void clip(
            Hull on, Hull other, int edge, int corner, double cos, double sin, double x, double y, double margin) {
        double n0 = on.nx[edge];
        double n1 = on.ny[edge];
        double length = n0 * (on.y[on.next(edge)] - on.y[edge]) - n1 * (on.x[on.next(edge)] - on.x[edge]);
        int before = corner > 0 ? corner - 1 : other.count - 1;
        double turnedX = cos * n0 + sin * n1;
        double turnedY = cos * n1 - sin * n0;
        boolean isBefore = turnedX * other.nx[before] + turnedY * other.ny[before]
                < turnedX * other.nx[corner] + turnedY * other.ny[corner];
        int from = isBefore ? before : corner; // the edge that faces this one runs against it
        int to = other.next(from);
        double fromX = x + cos * other.x[from] - sin * other.y[from] - on.x[edge];
        double fromY = y + sin * other.x[from] + cos * other.y[from] - on.y[edge];
        double toX = x + cos * other.x[to] - sin * other.y[to] - on.x[edge];
        double toY = y + sin * other.x[to] + cos * other.y[to] - on.y[edge];
        double right = n0 * fromY - n1 * fromX;
        double left = n0 * toY - n1 * toX;
        double rightGap = n0 * fromX + n1 * fromY;
        double leftGap = n0 * toX + n1 * toY;
        nx = n0;
        ny = n1;
        turnsBy = left > length || right < 0 ? ContactTurns.STILL : ContactTurns.FIRST;
        isSlight = Passing.isSlight(Math.min(right, length) - Math.max(left, 0), Math.min(right - left, length), size);
        if (left > length || right < 0) {
            corners(on, edge, left > length, fromX, fromY, toX, toY, length, margin, id(edge, from, left > length ? 1 : 0));
            return;
        }
        double slope = right - left > 0 ? (rightGap - leftGap) / (right - left) : 0;
        double l = Math.max(left, 0);
        double r = Math.min(right, length);
        boolean startGoesOn = joinsOn && left < -seams.distance && seams.goesOn(edge, n0, n1, false);
        boolean endGoesOn = joinsOn && right > length + seams.distance && seams.goesOn(on.next(edge), n0, n1, true);
        if (!startGoesOn && !(endGoesOn && left >= length - seams.distance)) {
            over(on, edge, l, leftGap + slope * (l - left), margin, id(edge, to, left < 0 ? 3 : 2));
        }
        if (r > l && !endGoesOn && !(startGoesOn && right <= seams.distance)) {
            over(on, edge, r, leftGap + slope * (r - left), margin, id(edge, from, right > length ? 5 : 4));
        }
    }

    private static int id(int edge, int corner, int which) {
        return (edge * 4096 + corner) * 8 + which;
    }

    /** Whether a point of two polygons is a corner of the first one. */
    static boolean isCornerOfFirst(int feature) {
        boolean isOfFirstEdge = feature >= 0;
        boolean isEndOfEdge = ((isOfFirstEdge ? feature : ~feature) & 1) != 0;
        return isEndOfEdge == isOfFirstEdge;
    }

    /** A point at a distance along an edge and above it. */
    private void over(Hull on, int edge, double along, double height, double margin, int id) {
        if (height <= margin) {
            double x = on.x[edge] - ny * along + 0.5 * nx * height;
            double y = on.y[edge] + nx * along + 0.5 * ny * height;
            add(x, y, height, id);
        }
    }

    /** The facing edge is beyond the end of this one: the corners may meet, along the line between them. */
    private void corners(
            Hull on, int edge, boolean isEnd, double fromX, double fromY, double toX, double toY, double length, double margin, int id) {
        double endX = isEnd ? -ny * length : 0;
        double endY = isEnd ? nx * length : 0;
        double ex = (isEnd ? toX : fromX) - endX;
        double ey = (isEnd ? toY : fromY) - endY;
        double distance = Math.sqrt(ex * ex + ey * ey);
        if (distance > margin || !(distance > 0) || nx * ex + ny * ey <= 0) {
            return;
        }
        nx = ex / distance;
        ny = ey / distance;
        if (joinsOn && seams.isHidden(isEnd ? on.next(edge) : edge, nx, ny)) {
            return;
        }
        add(on.x[edge] + endX + 0.5 * ex, on.y[edge] + endY + 0.5 * ey, distance, id);
    }

    /** Normal and points, from the frame of one of the two to the world; (x, y) is its centre. */
    private void toWorld(double cos, double sin, double x, double y, boolean isSecond) {
        for (int k = 0; k < count; k++) {
            double localX = px[k];
            double localY = py[k];
            px[k] = x + cos * localX - sin * localY;
            py[k] = y + sin * localX + cos * localY;
            feature[k] = isSecond ? ~feature[k] : feature[k];
        }
        double n0 = nx;
        nx = isSecond ? sin * ny - cos * n0 : cos * n0 - sin * ny;
        ny = isSecond ? -(sin * n0 + cos * ny) : sin * n0 + cos * ny;
    }
}
