// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import sim.physics.internal.Tolerances;
import sim.physics.motion.Body;
import sim.physics.shape.Shape;

/**
 * A shape that moves straight on from where it is put, without turning, and where it meets one body after another. That is a ray
 * against the body that has grown by the shape: its sides are those of both, and its corners are round if one of them is a disc.
 * Coordinates are relative to the shape's centre at its start.
 *
 * <p>A line that parts both at the start to rounding, and still does so at the end, parts them all the way: what lies on a floor
 * slides over it. Parts are looked at one by one.
 */
final class Sweep extends Stencil {
    /** Part of an edge by which a place on it may be beyond its end, for rounding. */
    private static final double BEYOND = 1e-12;

    /** The box around the shape, relative to its centre. */
    double lowX;

    double lowY;
    double highX;
    double highY;

    private double dx;
    private double dy;

    /** How far on it may meet the present body, or less; depth that is rounding; and how far apart points of one contact may be. */
    private double span;

    private double slack;
    private double flush;

    /** Of the present parts: how far on they meet; the normal there, out of the body; and the point on the body. */
    private double at;

    private double atNx;
    private double atNy;
    private double atX;
    private double atY;

    /** The same of the body; the point in the world. */
    double distance;

    double nx;
    double ny;
    double px;
    double py;

    /** While sides are looked at: how far on the last one is entered and the first one is left; and that side. */
    private double enter;

    private double leave;
    private int through;
    private Corners side;

    @Override
    void put(Shape what, double atX, double atY, double angle) {
        super.put(what, atX, atY, angle);
        lowX = Double.POSITIVE_INFINITY;
        lowY = Double.POSITIVE_INFINITY;
        highX = Double.NEGATIVE_INFINITY;
        highY = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < shape.partCount(); i++) {
            own.put(shape.part(i), 0, 0, turn[0], turn[1]);
            for (int k = 0; k < own.count; k++) {
                lowX = Math.min(lowX, own.x[k] - own.radius);
                lowY = Math.min(lowY, own.y[k] - own.radius);
                highX = Math.max(highX, own.x[k] + own.radius);
                highY = Math.max(highY, own.y[k] + own.radius);
            }
        }
    }

    /** Whether it meets a body within a range, in a unit direction; sets distance, normal and point. */
    boolean meets(Body body, double directionX, double directionY, double range) {
        Shape of = body.getShape();
        face(body);
        dx = directionX;
        dy = directionY;
        double cx = body.getX() - x;
        double cy = body.getY() - y;
        measure(body, Math.sqrt(cx * cx + cy * cy), range);
        distance = Double.POSITIVE_INFINITY;
        for (int i = 0; i < shape.partCount(); i++) {
            own.put(shape.part(i), 0, 0, turn[0], turn[1]);
            for (int k = 0; k < of.partCount(); k++) {
                other.put(of.part(k), cx, cy, cos, sin);
                at = Double.POSITIVE_INFINITY;
                if (overlaps()) {
                    distance = 0;
                    nx = 0.0 - dx;
                    ny = 0.0 - dy;
                    px = x;
                    py = y;
                    return true;
                }
                if (at <= range && at < distance) {
                    takePart();
                }
            }
        }
        return distance < Double.POSITIVE_INFINITY;
    }

    private void measure(Body body, double far, double range) {
        double reach = shape.boundingRadius();
        double of = body.getShape().boundingRadius();
        double extent = Math.abs(x) + Math.abs(y) + Math.abs(body.getX()) + Math.abs(body.getY()) + reach + of;
        slack = Tolerances.OVERLAP * Math.min(reach, of) + Tolerances.GAP * extent;
        flush = Tolerances.FLUSH * (reach + of) + Tolerances.GAP * extent;
        span = Math.min(range, far + reach + of);
    }

    private void takePart() {
        distance = at;
        nx = atNx + 0.0; // no negative zeros
        ny = atNy + 0.0;
        px = x + atX;
        py = y + atY;
    }

    /** Whether the present parts overlap at the start, by more than rounding; if not, {@code at} is how far on they meet. */
    private boolean overlaps() {
        if (own.count > 1 && other.count > 1) {
            return overlapPolygons();
        }
        if (own.count > 1) { // seen from the body's disc, a polygon comes
            boolean is = overlapDisc(own, other.x[0], other.y[0], 0 - dx, 0 - dy, other.radius);
            atX = other.x[0] - other.radius * atNx;
            atY = other.y[0] - other.radius * atNy;
            atNx = -atNx;
            atNy = -atNy;
            return is;
        }
        boolean is = other.count > 1
                ? overlapDisc(other, own.x[0], own.y[0], dx, dy, own.radius)
                : overlapDiscs(own.x[0] - other.x[0], own.y[0] - other.y[0]);
        atX = own.x[0] + at * dx - own.radius * atNx;
        atY = own.y[0] + at * dy - own.radius * atNy;
        return is;
    }

    /** Whether a line parts both all the way, by its height over the one at the start and how fast that grows. */
    private boolean parts(double height, double rate) {
        return height > slack ? rate >= 0 : height >= -slack && height + rate * span >= -slack;
    }

    private boolean overlapDiscs(double qx, double qy) {
        double radius = own.radius + other.radius;
        double far = Math.sqrt(qx * qx + qy * qy);
        if (far - radius < -slack) {
            return true;
        }
        boolean isBeside = Math.abs(qx * dy - qy * dx) > radius - slack;
        if (!isBeside && !parts(far - radius, (qx * dx + qy * dy) / far)) {
            enterDisc(qx, qy, dx, dy, radius);
        }
        return false;
    }

    /** The same of a polygon and a disc, whose centre moves in a direction relative to it. */
    private boolean overlapDisc(Corners polygon, double px, double py, double ddx, double ddy, double r) {
        double highest = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < polygon.count; k++) {
            double length = polygon.length(k);
            double height = polygon.over(k, px, py) / length - r;
            if (parts(height, polygon.across(k, ddx, ddy) / length)) {
                return false;
            }
            highest = Math.max(highest, height);
        }
        double square = polygon.square(px, py);
        double gap = square == 0 ? highest : Math.sqrt(square) - r;
        if (gap < -slack) {
            return true;
        }
        if (gap <= slack && square > 0 && isParted(polygon, px, py, ddx, ddy, square, gap)) {
            return false;
        }
        for (int k = 0; k < polygon.count; k++) {
            enterEdge(polygon, k, px, py, ddx, ddy, r);
            enterDisc(px - polygon.x[k], py - polygon.y[k], ddx, ddy, r);
        }
        return false;
    }

    /** Whether a disc that touches the nearest corner moves away from it, or past it. */
    private boolean isParted(Corners polygon, double px, double py, double ddx, double ddy, double square, double gap) {
        for (int k = 0; k < polygon.count; k++) {
            double qx = px - polygon.x[k];
            double qy = py - polygon.y[k];
            boolean isNearest = qx * qx + qy * qy <= square + square * BEYOND;
            if (isNearest && parts(gap, (qx * ddx + qy * ddy) / Math.sqrt(square))) {
                return true;
            }
        }
        return false;
    }

    /** Where a disc touches an edge first, between its ends. */
    private void enterEdge(Corners polygon, int k, double px, double py, double ddx, double ddy, double r) {
        double length = polygon.length(k);
        double height = polygon.over(k, px, py) / length - r;
        double rate = polygon.across(k, ddx, ddy) / length;
        if (height < -slack || rate >= 0) {
            return;
        }
        double t = Math.max(0, -height / rate);
        double ex = polygon.edgeX(k) / length;
        double ey = polygon.edgeY(k) / length;
        double along = (px + t * ddx - polygon.x[k]) * ex + (py + t * ddy - polygon.y[k]) * ey;
        if (t < at && along >= -BEYOND * length && along <= length + BEYOND * length) {
            at = t;
            atNx = ey;
            atNy = -ex;
        }
    }

    /** Where a point that is not in a disc enters it. */
    private void enterDisc(double qx, double qy, double ddx, double ddy, double r) {
        double b = qx * ddx + qy * ddy;
        double offset = qx * ddy - qy * ddx;
        double square = r * r - offset * offset;
        if (b >= 0 || square < 0) {
            return;
        }
        double t = Math.max(0, (qx * qx + qy * qy - r * r) / (Math.sqrt(square) - b));
        if (t < at) {
            at = t;
            atNx = (qx + t * ddx) / r;
            atNy = (qy + t * ddy) / r;
        }
    }

    private boolean overlapPolygons() {
        enter = -1;
        leave = Double.POSITIVE_INFINITY;
        if (isParted(other, own, dx, dy) || isParted(own, other, -dx, -dy) || enter > leave) {
            return false;
        }
        if (enter < 0) {
            return true;
        }
        at = enter;
        findPoint(side == other ? own : other, side == other ? 1 : -1);
        return false;
    }

    /** Looks at the sides of a polygon to which another one moves; whether one of them parts both all the way. */
    private boolean isParted(Corners of, Corners from, double ddx, double ddy) {
        for (int k = 0; k < of.count; k++) {
            double length = of.length(k);
            double height = of.least(k, from) / length;
            double rate = of.across(k, ddx, ddy) / length;
            if (parts(height, rate)) {
                return true;
            }
            if (height < -slack) {
                leave = rate > 0 ? Math.min(leave, -height / rate) : leave;
            } else if (Math.max(0, -height / rate) > enter) {
                enter = Math.max(0, -height / rate);
                through = k;
                side = of;
            }
        }
        return false;
    }

    /** The middle of where a side is touched by the corners that come to it; the other polygon moves to it, or it to the other. */
    private void findPoint(Corners from, int sign) {
        double length = side.length(through);
        double ex = side.edgeX(through) / length;
        double ey = side.edgeY(through) / length;
        double lowest = side.least(through, from) / length;
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int m = 0; m < from.count; m++) {
            if (side.over(through, from.x[m], from.y[m]) / length <= lowest + flush) {
                double along = (from.x[m] - side.x[through] + sign * at * dx) * ex + (from.y[m] - side.y[through] + sign * at * dy) * ey;
                least = Math.min(least, along);
                most = Math.max(most, along);
            }
        }
        double middle = 0.5 * (Math.max(0, least) + Math.min(length, most));
        double moved = sign > 0 ? 0 : at;
        atX = side.x[through] + moved * dx + middle * ex;
        atY = side.y[through] + moved * dy + middle * ey;
        atNx = sign * ey;
        atNy = -sign * ex;
    }
}
