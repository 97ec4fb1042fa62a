// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import java.util.List;
import java.util.function.Predicate;
import sim.physics.motion.Body;
import sim.physics.motion.State;

/**
 * One ray after another: through the cells, from one to the next that the ray enters (Amanatides and Woo 1987), or past all
 * bodies. Both ways look at a body by the same arithmetic, and of bodies at the same distance the one with the lower block
 * is the first, so that their answers are equal to the bit.
 */
final class RayWalk {
    /** Slopes below this never come to the next row or column. */
    private static final double FLAT = 1e-200;

    /** Makes up for rounding where a look at the circle only spares work. */
    private static final double SLACK = 1 + 1e-12;

    private final Census census;
    private final Cells cells;
    private final Outline outline = new Outline();

    private double x;
    private double y;
    private double dx;
    private double dy;
    private Predicate<? super Body> filter;

    /** Takes all that the ray enters; null if only the first counts. */
    private List<Hit> all;

    /** What the ray entered first, or null; how far on, or the range; and the normal there. */
    Body body;

    double distance;
    double nx;
    double ny;

    private int block;

    RayWalk(Census census, Cells cells) {
        this.census = census;
        this.cells = cells;
    }

    /** Casts a ray of unit direction. */
    void cast(
            double fromX,
            double fromY,
            double directionX,
            double directionY,
            double range,
            Predicate<? super Body> which,
            List<Hit> takesAll) {
        x = fromX;
        y = fromY;
        dx = directionX;
        dy = directionY;
        filter = which;
        all = takesAll;
        body = null;
        block = -1;
        distance = range;
        if (cells.serve() && cells.covers(x, y)) {
            walk();
        } else {
            pass();
        }
        filter = null;
        all = null;
    }

    double hitX() {
        return x + distance * dx;
    }

    double hitY() {
        return y + distance * dy;
    }

    /** Looks at all bodies. */
    private void pass() {
        int n = census.size;
        for (int i = 0; i < n; i++) {
            if (isNear(i)) {
                meet(i);
            }
        }
    }

    /** Looks at the bodies of the cells that the ray comes to. */
    private void walk() {
        int question = cells.nextMark();
        for (int k = 0; k < cells.others.size; k++) {
            look(cells.others.values[k], question);
        }
        double margin = cells.margin();
        int column = cells.column(x);
        int row = cells.row(y);
        int lastColumn = dx > FLAT ? cells.columns - 1 : dx < -FLAT ? 0 : column;
        int lastRow = dy > FLAT ? cells.rows - 1 : dy < -FLAT ? 0 : row;
        int stepX = dx > 0 ? 1 : -1;
        int stepY = dy > 0 ? 1 : -1;
        double perX = 1 / dx;
        double perY = 1 / dy;
        double nextX = column == lastColumn ? Double.POSITIVE_INFINITY : borderX(column, stepX) * perX;
        double nextY = row == lastRow ? Double.POSITIVE_INFINITY : borderY(row, stepY) * perY;
        int[] first = cells.first;
        int[] filed = cells.filed;
        while (true) {
            int cell = row * cells.columns + column;
            int end = first[cell + 1];
            for (int k = first[cell]; k < end; k++) {
                look(filed[k], question);
            }
            double next = Math.min(nextX, nextY);
            if (next == Double.POSITIVE_INFINITY || next > distance + distance * 1e-9 + margin) {
                return;
            }
            if (nextX < nextY) {
                column += stepX;
                nextX = column == lastColumn ? Double.POSITIVE_INFINITY : borderX(column, stepX) * perX;
            } else {
                row += stepY;
                nextY = row == lastRow ? Double.POSITIVE_INFINITY : borderY(row, stepY) * perY;
            }
        }
    }

    /** Where the ray leaves a column, relative to its start. */
    private double borderX(int column, int step) {
        return cells.xs.line(step > 0 ? column + 1 : column) - x;
    }

    private double borderY(int row, int step) {
        return cells.ys.line(step > 0 ? row + 1 : row) - y;
    }

    private void look(int i, int question) {
        if (cells.mark[i] != question && isNear(i)) {
            cells.mark[i] = question;
            meet(i);
        }
    }

    /** Whether the ray comes into the circle around a body before its end; not into that of none. */
    private boolean isNear(int i) {
        double[] at = census.state.x();
        double px = at[State.BLOCK * i] - x;
        double py = at[State.BLOCK * i + 1] - y;
        double radius = census.radii[i];
        double across = px * dy - py * dx;
        if (Math.abs(across) > radius) {
            return false;
        }
        double along = px * dx + py * dy;
        return along >= -radius && along - distance * SLACK <= radius;
    }

    private void meet(int i) {
        Body candidate = census.bodies[i];
        if (filter != null && !filter.test(candidate)) {
            return;
        }
        outline.of(candidate);
        if (!outline.enters(x, y, dx, dy, distance)) {
            return;
        }
        double d = outline.distance;
        if (all != null) {
            all.add(new Hit(candidate, x + d * dx, y + d * dy, outline.nx, outline.ny, d));
        } else if (body == null || d < distance || d == distance && i < block) {
            body = candidate;
            block = i;
            distance = d;
            nx = outline.nx;
            ny = outline.ny;
        }
    }
}
