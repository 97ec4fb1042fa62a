// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import sim.physics.internal.Trig;
import sim.physics.motion.Body;
import sim.physics.shape.Shape;

/**
 * The outline of one body after another, and what a ray or a point has to do with it, in the body's own frame; of a body of
 * several parts with each of them.
 */
final class Outline {
    private final double[] turn = new double[2];
    private Shape whole;

    /** The part that is looked at. */
    private Shape shape;

    private double x;
    private double y;

    /** Where a ray enters, and the normal there, in the world. */
    double distance;

    double nx;
    double ny;

    /** The box around the body, in the world. */
    double leastX;

    double leastY;
    double mostX;
    double mostY;

    void of(Body body) {
        whole = body.getShape();
        shape = whole;
        x = body.getX();
        y = body.getY();
        if (shape.vertexCount() > 1) {
            Trig.sinCos(body.getAngle(), turn, 0);
        } else {
            turn[0] = 1;
            turn[1] = 0;
        }
    }

    private double toLocalX(double dx, double dy) {
        return turn[0] * dx + turn[1] * dy;
    }

    private double toLocalY(double dx, double dy) {
        return turn[0] * dy - turn[1] * dx;
    }

    /** Whether a ray of unit direction enters; sets distance and normal. */
    boolean enters(double fromX, double fromY, double directionX, double directionY, double range) {
        double px = toLocalX(fromX - x, fromY - y);
        double py = toLocalY(fromX - x, fromY - y);
        double dx = toLocalX(directionX, directionY);
        double dy = toLocalY(directionX, directionY);
        if (!entersLocal(px, py, dx, dy) || distance > range) {
            return false;
        }
        double lx = nx;
        nx = turn[0] * lx - turn[1] * ny + 0.0; // no negative zeros
        ny = turn[1] * lx + turn[0] * ny + 0.0;
        return true;
    }

    private boolean entersLocal(double px, double py, double dx, double dy) {
        if (whole.partCount() == 1) {
            return entersPart(px, py, dx, dy);
        }
        double first = Double.POSITIVE_INFINITY;
        double firstX = 0;
        double firstY = 0;
        for (int k = 0; k < whole.partCount(); k++) {
            shape = whole.part(k);
            if (entersPart(px, py, dx, dy) && distance < first) {
                first = distance;
                firstX = nx;
                firstY = ny;
            }
        }
        distance = first;
        nx = firstX;
        ny = firstY;
        return first < Double.POSITIVE_INFINITY;
    }

    private boolean entersPart(double px, double py, double dx, double dy) {
        return shape.vertexCount() == 1 ? entersCircle(px, py, dx, dy) : entersPolygon(px, py, dx, dy);
    }

    private boolean entersCircle(double fromX, double fromY, double dx, double dy) {
        double r = shape.radius();
        double px = fromX - shape.vertexX(0);
        double py = fromY - shape.vertexY(0);
        double c = px * px + py * py - r * r;
        double b = px * dx + py * dy;
        if (c <= 0) {
            return startsInside(dx, dy);
        }
        double offset = px * dy - py * dx; // of the centre from the ray
        double square = r * r - offset * offset;
        if (b >= 0 || square < 0) {
            return false;
        }
        distance = c / (Math.sqrt(square) - b);
        nx = (px + distance * dx) / r;
        ny = (py + distance * dy) / r;
        return true;
    }

    private boolean startsInside(double dx, double dy) {
        distance = 0;
        nx = -dx;
        ny = -dy;
        return true;
    }

    /** Clips the ray at the lines of the edges. */
    private boolean entersPolygon(double px, double py, double dx, double dy) {
        double enter = 0;
        double leave = Double.POSITIVE_INFINITY;
        int through = -1;
        int n = shape.vertexCount();
        for (int k = 0; k < n; k++) {
            double ex = edgeX(k);
            double ey = edgeY(k);
            double height = (px - shape.vertexX(k)) * ey - (py - shape.vertexY(k)) * ex;
            double rate = dx * ey - dy * ex;
            if (rate == 0) {
                if (height > 0) {
                    return false;
                }
            } else if (rate < 0) {
                if (-height / rate > enter) {
                    enter = -height / rate;
                    through = k;
                }
            } else {
                leave = Math.min(leave, -height / rate);
            }
        }
        if (enter > leave || leave < 0) {
            return false;
        }
        if (through < 0) {
            return startsInside(dx, dy);
        }
        double length = Math.sqrt(edgeX(through) * edgeX(through) + edgeY(through) * edgeY(through));
        distance = enter;
        nx = edgeY(through) / length;
        ny = -edgeX(through) / length;
        return true;
    }

    private double edgeX(int k) {
        return shape.vertexX(k + 1 == shape.vertexCount() ? 0 : k + 1) - shape.vertexX(k);
    }

    private double edgeY(int k) {
        return shape.vertexY(k + 1 == shape.vertexCount() ? 0 : k + 1) - shape.vertexY(k);
    }

    /** Distance of a point from the surface, 0 inside. */
    double distance(double pointX, double pointY) {
        double px = toLocalX(pointX - x, pointY - y);
        double py = toLocalY(pointX - x, pointY - y);
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < whole.partCount(); k++) {
            shape = whole.part(k);
            least = Math.min(least, distanceLocal(px, py));
        }
        return least;
    }

    private double distanceLocal(double px, double py) {
        if (shape.vertexCount() == 1) {
            double cx = px - shape.vertexX(0);
            double cy = py - shape.vertexY(0);
            return Math.max(0, Math.sqrt(cx * cx + cy * cy) - shape.radius());
        }
        double least = Double.POSITIVE_INFINITY;
        boolean inside = true;
        for (int k = 0; k < shape.vertexCount(); k++) {
            double ex = edgeX(k);
            double ey = edgeY(k);
            double qx = px - shape.vertexX(k);
            double qy = py - shape.vertexY(k);
            inside &= qx * ey - qy * ex <= 0;
            least = Math.min(least, squareToEdge(qx, qy, ex, ey));
        }
        return inside ? 0 : Math.sqrt(least);
    }

    /** Square of the distance of a point from an edge, both given from where the edge begins. */
    static double squareToEdge(double qx, double qy, double ex, double ey) {
        double along = Math.max(0, Math.min(1, (qx * ex + qy * ey) / (ex * ex + ey * ey)));
        double rx = qx - along * ex;
        double ry = qy - along * ey;
        return rx * rx + ry * ry;
    }

    /** Whether the outline meets a box with sides along the axes: none of the lines that could part them does. */
    boolean meets(double lowX, double lowY, double highX, double highY) {
        boolean meets = false;
        for (int k = 0; k < whole.partCount() && !meets; k++) {
            shape = whole.part(k);
            meets = shape.vertexCount() == 1
                    ? circleMeets(lowX, lowY, highX, highY)
                    : !isBeside(lowX, lowY, highX, highY) && !edgeParts(lowX, lowY, highX, highY);
        }
        return meets;
    }

    private boolean circleMeets(double lowX, double lowY, double highX, double highY) {
        double cx = x + (turn[0] * shape.vertexX(0) - turn[1] * shape.vertexY(0));
        double cy = y + (turn[1] * shape.vertexX(0) + turn[0] * shape.vertexY(0));
        double dx = cx - Math.max(lowX, Math.min(highX, cx));
        double dy = cy - Math.max(lowY, Math.min(highY, cy));
        return dx * dx + dy * dy <= shape.radius() * shape.radius();
    }

    /** Finds the box around all parts. */
    void bound() {
        double lowX = Double.POSITIVE_INFINITY;
        double lowY = Double.POSITIVE_INFINITY;
        double highX = Double.NEGATIVE_INFINITY;
        double highY = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < whole.partCount(); k++) {
            shape = whole.part(k);
            boundPart();
            lowX = Math.min(lowX, leastX - shape.radius());
            lowY = Math.min(lowY, leastY - shape.radius());
            highX = Math.max(highX, mostX + shape.radius());
            highY = Math.max(highY, mostY + shape.radius());
        }
        leastX = lowX;
        leastY = lowY;
        mostX = highX;
        mostY = highY;
    }

    private boolean isBeside(double lowX, double lowY, double highX, double highY) {
        boundPart();
        return mostX < lowX || leastX > highX || mostY < lowY || leastY > highY;
    }

    private void boundPart() {
        leastX = Double.POSITIVE_INFINITY;
        leastY = Double.POSITIVE_INFINITY;
        mostX = Double.NEGATIVE_INFINITY;
        mostY = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < shape.vertexCount(); k++) {
            double vx = x + turn[0] * shape.vertexX(k) - turn[1] * shape.vertexY(k);
            double vy = y + turn[1] * shape.vertexX(k) + turn[0] * shape.vertexY(k);
            leastX = Math.min(leastX, vx);
            leastY = Math.min(leastY, vy);
            mostX = Math.max(mostX, vx);
            mostY = Math.max(mostY, vy);
        }
    }

    private boolean edgeParts(double lowX, double lowY, double highX, double highY) {
        for (int k = 0; k < shape.vertexCount(); k++) {
            double least = Double.POSITIVE_INFINITY;
            for (int corner = 0; corner < 4; corner++) {
                double cx = ((corner & 1) == 0 ? lowX : highX) - x;
                double cy = ((corner & 2) == 0 ? lowY : highY) - y;
                double px = toLocalX(cx, cy) - shape.vertexX(k);
                double py = toLocalY(cx, cy) - shape.vertexY(k);
                least = Math.min(least, px * edgeY(k) - py * edgeX(k));
            }
            if (least > 0) {
                return true;
            }
        }
        return false;
    }
}
