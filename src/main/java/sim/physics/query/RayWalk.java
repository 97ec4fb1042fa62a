// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import java.util.List;
import java.util.function.Predicate;
import sim.physics.motion.Body;

/**
 * One ray after another: through the cells, from one to the next that the ray enters (Amanatides and Woo 1987), or past all
 * bodies. Both ways look at a body by the same arithmetic, and of bodies at the same distance the one with the lower block
 * is the first, so that their answers are equal to the bit.
 */
final class RayWalk extends Walk {
    /** Slopes below this never come to the next row or column. */
    private static final double FLAT = 1e-200;

    private final Outline outline = new Outline();

    RayWalk(Census census, Cells cells) {
        super(census, cells);
    }

    /** Casts a ray. */
    void cast(
            double fromX,
            double fromY,
            double directionX,
            double directionY,
            double range,
            Predicate<? super Body> which,
            List<Hit> takesAll) {
        begin(fromX, fromY, directionX, directionY, range, which, takesAll);
        if (cells.serve() && cells.covers(x, y)) {
            walk();
        } else {
            pass();
        }
        end();
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
        take(candidate, i, d, outline.nx, outline.ny, x + d * dx, y + d * dy);
    }
}
