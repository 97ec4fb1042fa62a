// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.Paint;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import sim.physics.internal.Trig;
import sim.physics.motion.Body;
import sim.portrayal.DrawInfo2D;

/** A symbol in world coordinates, as lines, dashed lines and areas, which is drawn or found under the mouse in pixels. */
final class Sketch {
    /** Size of a symbol, relative to the root of its bodies' area. */
    private static final double SIZE = 0.15;

    /** Width of lines, relative to the size of the symbol. */
    private static final double PEN = 0.25;

    /** Width in pixels of what is found under the mouse, at least. */
    private static final double REACH = 5;

    private final Path2D.Double lines = new Path2D.Double();
    private final Path2D.Double dashes = new Path2D.Double();
    private final Path2D.Double areas = new Path2D.Double();

    /** Size of the symbol, length. */
    final double size;

    Sketch(double size) {
        this.size = size;
    }

    /** The size of symbols at two bodies, between theirs; of those that cannot move, walls, it says nothing. */
    static double size(Body a, Body b) {
        double first = Math.sqrt(a.getShape().area());
        if (b == null || b.isFixed()) {
            return SIZE * first;
        }
        double second = Math.sqrt(b.getShape().area());
        return SIZE * (a.isFixed() ? second : Math.sqrt(first * second));
    }

    Sketch line(double... xy) {
        append(lines, xy);
        return this;
    }

    Sketch dashed(double... xy) {
        append(dashes, xy);
        return this;
    }

    Sketch area(double... xy) {
        append(areas, xy);
        areas.closePath();
        return this;
    }

    private static void append(Path2D path, double... xy) {
        path.moveTo(xy[0], xy[1]);
        for (int k = 2; k < xy.length; k += 2) {
            path.lineTo(xy[k], xy[k + 1]);
        }
    }

    Sketch curve(double x, double y, double towardsX, double towardsY, double endX, double endY) {
        lines.moveTo(x, y);
        lines.quadTo(towardsX, towardsY, endX, endY);
        return this;
    }

    Sketch ring(double x, double y, double r) {
        lines.append(new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r), false);
        return this;
    }

    Sketch disc(double x, double y, double r) {
        areas.append(new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r), false);
        return this;
    }

    /** A square with its sides along a direction of length 1. */
    Sketch box(double x, double y, double dx, double dy, double half, double halfAcross, boolean filled) {
        double ax = half * dx;
        double ay = half * dy;
        double bx = -halfAcross * dy;
        double by = halfAcross * dx;
        double[] corners = {
            x + ax + bx, y + ay + by, x - ax + bx, y - ay + by, x - ax - bx, y - ay - by, x + ax - bx, y + ay - by,
            x + ax + bx, y + ay + by
        };
        return filled ? area(corners) : line(corners);
    }

    /** A line with a head at its end. */
    Sketch arrow(double x, double y, double endX, double endY) {
        double length = Math.sqrt((endX - x) * (endX - x) + (endY - y) * (endY - y));
        if (length == 0) {
            return this;
        }
        double head = Math.min(size, length) / length;
        double dx = head * (endX - x);
        double dy = head * (endY - y);
        line(x, y, endX - 0.5 * dx, endY - 0.5 * dy);
        return area(endX, endY, endX - dx - 0.4 * dy, endY - dy + 0.4 * dx, endX - dx + 0.4 * dy, endY - dy - 0.4 * dx);
    }

    /** Part of a circle, with a head at its end if it is asked for. */
    Sketch arc(double x, double y, double r, double from, double to, boolean head) {
        int pieces = Math.max(2, (int) Math.min(200, Math.ceil(Math.abs(to - from) / 0.1)));
        double[] xy = new double[2 * pieces + 2];
        for (int k = 0; k <= pieces; k++) {
            double angle = from + (to - from) * k / pieces;
            xy[2 * k] = x + r * Trig.cos(angle);
            xy[2 * k + 1] = y + r * Trig.sin(angle);
        }
        line(xy);
        if (head) {
            double s = Math.signum(to - from) * size;
            double cos = Trig.cos(to);
            double sin = Trig.sin(to);
            double endX = xy[2 * pieces];
            double endY = xy[2 * pieces + 1];
            area(endX - s * sin, endY + s * cos, endX + 0.5 * s * cos, endY + 0.5 * s * sin, endX - 0.5 * s * cos, endY - 0.5 * s * sin);
        }
        return this;
    }

    /** What brings world coordinates to pixels: the location of a portrayed object is at the corner of its rectangle. */
    private static AffineTransform toPixels(DrawInfo2D info, double x, double y) {
        AffineTransform place = AffineTransform.getTranslateInstance(info.draw.x, info.draw.y);
        place.scale(info.draw.width, info.draw.height);
        place.translate(-x, -y);
        return place;
    }

    private double pen(DrawInfo2D info) {
        return Math.max(1, PEN * size * Math.sqrt(Math.abs(info.draw.width * info.draw.height)));
    }

    /** Draws the symbol of an object whose location is given. */
    void draw(Graphics2D graphics, DrawInfo2D info, double x, double y, Paint paint) {
        AffineTransform place = toPixels(info, x, y);
        float pen = (float) pen(info);
        Stroke stroke = graphics.getStroke(); // other portrayals draw with what they find
        Object control = graphics.getRenderingHint(RenderingHints.KEY_STROKE_CONTROL);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE); // else lines are drawn to whole pixels
        graphics.setPaint(paint);
        graphics.fill(place.createTransformedShape(areas));
        graphics.setStroke(new BasicStroke(pen, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        graphics.draw(place.createTransformedShape(lines));
        float[] pattern = {3 * pen, 3 * pen};
        graphics.setStroke(new BasicStroke(pen, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, pattern, 0));
        graphics.draw(place.createTransformedShape(dashes));
        graphics.setStroke(stroke);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, control == null ? RenderingHints.VALUE_STROKE_DEFAULT : control);
    }

    /** Whether something of it is in the clip of the info. */
    boolean isHit(DrawInfo2D info, double x, double y) {
        AffineTransform place = toPixels(info, x, y);
        Rectangle2D.Double clip = info.clip;
        BasicStroke stroke = new BasicStroke((float) Math.max(pen(info), REACH));
        Path2D.Double drawn = new Path2D.Double(lines);
        drawn.append(dashes, false);
        Shape wide = stroke.createStrokedShape(place.createTransformedShape(drawn));
        Shape filled = place.createTransformedShape(areas);
        return wide.intersects(clip.x, clip.y, clip.width, clip.height)
                || filled.intersects(clip.x, clip.y, clip.width, clip.height);
    }
}
