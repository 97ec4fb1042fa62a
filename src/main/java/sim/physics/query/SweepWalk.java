// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import java.util.List;
import java.util.function.Predicate;
import sim.physics.motion.Body;
import sim.physics.shape.Shape;

/**
 * One shape after another that moves straight on: through the cells that the box around it comes to, strip by strip, or past all
 * bodies. Both ways look at a body by the same arithmetic.
 */
final class SweepWalk extends Walk {
    private final Sweep sweep = new Sweep();
    private int question;

    SweepWalk(Census census, Cells cells) {
        super(census, cells);
    }

    /** Casts a shape. */
    void cast(
            Shape shape,
            double fromX,
            double fromY,
            double angle,
            double directionX,
            double directionY,
            double range,
            Predicate<? super Body> which,
            List<Hit> takesAll) {
        begin(fromX, fromY, directionX, directionY, range, which, takesAll);
        sweep.put(shape, x, y, angle);
        reach = shape.boundingRadius() * SLACK;
        if (cells.serve() && cells.covers(Math.abs(x) + reach, Math.abs(y) + reach)) {
            walk();
        } else {
            for (int i = 0; i < census.size; i++) {
                meet(i);
            }
        }
        end();
    }

    private void walk() {
        question = cells.nextMark();
        for (int k = 0; k < cells.others.size; k++) {
            look(cells.others.values[k]);
        }
        if (Math.abs(dy) > Math.abs(dx)) {
            walk(cells.ys, y + sweep.lowY, y + sweep.highY, dy, cells.xs, x + sweep.lowX, x + sweep.highX, dx);
        } else {
            walk(cells.xs, x + sweep.lowX, x + sweep.highX, dx, cells.ys, y + sweep.lowY, y + sweep.highY, dy);
        }
    }

    /**
     * Goes from strip to strip along the axis that it is more parallel to, as far as the box has come when nothing was met before.
     * The strips at the border reach on without end.
     */
    private void walk(Lines along, double low, double high, double d, Lines across, double left, double right, double slope) {
        double margin = cells.margin();
        boolean isUp = d > 0;
        int step = isUp ? 1 : -1;
        int first = isUp ? 0 : along.count - 1;
        int last = along.count - 1 - first;
        for (int strip = along.at(isUp ? low - margin : high + margin); ; strip += step) {
            double ahead = isUp ? along.line(strip) - high - margin : along.line(strip + 1) - low + margin;
            double past = isUp ? along.line(strip + 1) - low + margin : along.line(strip) - high - margin;
            double from = strip == first ? 0 : Math.max(0, ahead / d);
            double end = distance + distance * 1e-9 + margin;
            if (from > end) {
                return;
            }
            double to = strip == last ? end : Math.min(end, past / d);
            double begins = slope * from;
            double ends = slope == 0 ? 0 : slope * to;
            lookAt(along == cells.ys, strip,
                    across.at(left - margin + Math.min(begins, ends)), across.at(right + margin + Math.max(begins, ends)));
            if (strip == last) {
                return;
            }
        }
    }

    private void lookAt(boolean isRow, int strip, int from, int to) {
        for (int c = from; c <= to; c++) {
            int cell = isRow ? strip * cells.columns + c : c * cells.columns + strip;
            int end = cells.first[cell + 1];
            for (int k = cells.first[cell]; k < end; k++) {
                look(cells.filed[k]);
            }
        }
    }

    private void look(int i) {
        if (cells.mark[i] != question) {
            cells.mark[i] = question;
            meet(i);
        }
    }

    private void meet(int i) {
        Body candidate = census.bodies[i];
        if (candidate == null || !isNear(i) || filter != null && !filter.test(candidate)) {
            return;
        }
        if (sweep.meets(candidate, dx, dy, distance)) {
            take(candidate, i, sweep.distance, sweep.nx, sweep.ny, sweep.px, sweep.py);
        }
    }
}
