// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import sim.physics.internal.Check;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;

/**
 * The bodies in a box or around a point: those of the cells there, or of all. Both ways look at bodies by the same
 * arithmetic, and their answers are equal.
 */
final class Surroundings {
    private static final double LESS = 1 - 1e-12;

    private final Census census;
    private final Cells cells;
    private final Outline outline = new Outline();

    /** Blocks of the bodies that are to be looked at, ascending. */
    private final IntList candidates = new IntList();

    /** The nearest so far, the nearest first: blocks and distances. */
    private int[] blocks = new int[8];

    private double[] distances = new double[8];
    private int found;
    private int count;

    private double x;
    private double y;
    private Predicate<? super Body> filter;

    Surroundings(Census census, Cells cells) {
        this.census = census;
        this.cells = cells;
    }

    /** Checks the sides of a box. */
    static void check(double lowX, double lowY, double highX, double highY) {
        Check.finite("lowX", lowX);
        Check.finite("lowY", lowY);
        checkSides("X", lowX, Check.finite("highX", highX));
        checkSides("Y", lowY, Check.finite("highY", highY));
    }

    private static void checkSides(String axis, double low, double high) {
        if (high < low) {
            throw new IllegalArgumentException(
                    "high" + axis + " is " + high + ": it must not be less than low" + axis + ", " + low);
        }
    }

    /** The bodies that are not farther from a point than a distance. */
    void within(double pointX, double pointY, double distance, Predicate<? super Body> which, List<? super Body> into) {
        boolean some = collect(pointX - distance, pointY - distance, pointX + distance, pointY + distance);
        int n = some ? candidates.size : census.size;
        for (int k = 0; k < n; k++) {
            int i = some ? candidates.values[k] : k;
            Body body = census.bodies[i];
            if (body != null && far(i, pointX, pointY) <= distance && (which == null || which.test(body))) {
                outline.of(body);
                if (outline.distance(pointX, pointY) <= distance) {
                    into.add(body);
                }
            }
        }
    }

    /** The bodies that meet a box. */
    void inBox(
            double lowX, double lowY, double highX, double highY, Predicate<? super Body> which, List<? super Body> into) {
        boolean some = collect(lowX, lowY, highX, highY);
        int n = some ? candidates.size : census.size;
        for (int k = 0; k < n; k++) {
            int i = some ? candidates.values[k] : k;
            Body body = census.bodies[i];
            if (body != null && isAbout(i, lowX, lowY, highX, highY) && (which == null || which.test(body))) {
                outline.of(body);
                if (outline.meets(lowX, lowY, highX, highY)) {
                    into.add(body);
                }
            }
        }
    }

    /** The bodies that meet a shape. */
    void overlapping(Stencil stencil, Predicate<? super Body> which, List<? super Body> into) {
        double centreX = stencil.x();
        double centreY = stencil.y();
        double reach = stencil.reach();
        boolean some = collect(centreX - reach, centreY - reach, centreX + reach, centreY + reach);
        int n = some ? candidates.size : census.size;
        for (int k = 0; k < n; k++) {
            int i = some ? candidates.values[k] : k;
            Body body = census.bodies[i];
            if (body != null && far(i, centreX, centreY) <= reach && (which == null || which.test(body)) && stencil.meets(body)) {
                into.add(body);
            }
        }
    }

    private boolean isAbout(int i, double lowX, double lowY, double highX, double highY) {
        double[] at = census.state.x();
        double centreX = at[State.BLOCK * i];
        double centreY = at[State.BLOCK * i + 1];
        double radius = census.radii[i];
        return centreX + radius >= lowX && centreX - radius <= highX
                && centreY + radius >= lowY && centreY - radius <= highY;
    }

    /** Distance of a point from the circle around a body, or a little less; negative inside. */
    private double far(int i, double pointX, double pointY) {
        double[] at = census.state.x();
        double px = at[State.BLOCK * i] - pointX;
        double py = at[State.BLOCK * i + 1] - pointY;
        return Math.sqrt(px * px + py * py) * LESS - census.radii[i];
    }

    /** Collects the bodies of the cells that a box meets; false if all bodies are to be looked at. */
    private boolean collect(double lowX, double lowY, double highX, double highY) {
        if (!cells.serve() || !cells.covers(lowX, lowY) || !cells.covers(highX, highY)) {
            return false;
        }
        double margin = cells.margin();
        int left = cells.column(lowX - margin);
        int right = cells.column(highX + margin);
        int lower = cells.row(lowY - margin);
        int upper = cells.row(highY + margin);
        if (2L * (right - left + 1) * (upper - lower + 1) > (long) cells.columns * cells.rows) {
            return false;
        }
        candidates.clear();
        int question = cells.nextMark();
        for (int k = 0; k < cells.others.size; k++) {
            collect(cells.others.values[k], question);
        }
        for (int row = lower; row <= upper; row++) {
            int start = cells.first[row * cells.columns + left];
            int end = cells.first[row * cells.columns + right + 1]; // the cells of a row lie one after the other
            for (int k = start; k < end; k++) {
                collect(cells.filed[k], question);
            }
        }
        candidates.sort();
        return true;
    }

    private void collect(int i, int question) {
        if (cells.mark[i] != question) {
            cells.mark[i] = question;
            candidates.add(i);
        }
    }

    /** The bodies that are nearest to a point. */
    void nearest(double pointX, double pointY, int most, Predicate<? super Body> which, List<? super Body> into) {
        if (most == 0) {
            return;
        }
        x = pointX;
        y = pointY;
        count = most;
        filter = which;
        found = 0;
        if (cells.serve() && cells.covers(x, y) && 4L * most < census.size) {
            spread();
        } else {
            for (int i = 0; i < census.size; i++) {
                consider(i);
            }
        }
        filter = null;
        for (int k = 0; k < found; k++) {
            into.add(census.bodies[blocks[k]]);
        }
    }

    /** Looks at the cell of the point, then at the ring of cells around it, and so on while a nearer body may be there. */
    private void spread() {
        int question = cells.nextMark();
        for (int k = 0; k < cells.others.size; k++) {
            look(cells.others.values[k], question);
        }
        int column = cells.column(x);
        int row = cells.row(y);
        for (int ring = 0; !isDone(column, row, ring); ring++) {
            int left = Math.max(0, column - ring);
            int right = Math.min(cells.columns - 1, column + ring);
            for (int r = Math.max(0, row - ring); r <= Math.min(cells.rows - 1, row + ring); r++) {
                if (r == row - ring || r == row + ring) {
                    lookIn(r, left, right, question);
                } else {
                    lookIn(r, left, column - ring == left ? left : left - 1, question);
                    lookIn(r, column + ring == right ? right : right + 1, right, question);
                }
            }
        }
    }

    /** Whether all that lies in this ring of cells and beyond is farther than what has been found, or there is no more. */
    private boolean isDone(int column, int row, int ring) {
        if (ring == 0) {
            return false;
        }
        double clear = Double.POSITIVE_INFINITY; // to the nearest side of the square of cells within the ring
        if (column - ring >= 0) {
            clear = Math.min(clear, x - cells.xs.line(column - ring + 1));
        }
        if (column + ring < cells.columns) {
            clear = Math.min(clear, cells.xs.line(column + ring) - x);
        }
        if (row - ring >= 0) {
            clear = Math.min(clear, y - cells.ys.line(row - ring + 1));
        }
        if (row + ring < cells.rows) {
            clear = Math.min(clear, cells.ys.line(row + ring) - y);
        }
        return clear == Double.POSITIVE_INFINITY
                || found == count && distances[count - 1] + cells.margin() < clear;
    }

    private void lookIn(int row, int left, int right, int question) {
        if (left > right) {
            return;
        }
        int end = cells.first[row * cells.columns + right + 1];
        for (int k = cells.first[row * cells.columns + left]; k < end; k++) {
            look(cells.filed[k], question);
        }
    }

    private void look(int i, int question) {
        if (cells.mark[i] != question) {
            cells.mark[i] = question;
            consider(i);
        }
    }

    /** Takes a body in if it is among the nearest; among equals the lower block is nearer. */
    private void consider(int i) {
        Body body = census.bodies[i];
        double most = found < count ? Double.POSITIVE_INFINITY : distances[count - 1];
        if (body == null || far(i, x, y) > most || filter != null && !filter.test(body)) {
            return;
        }
        outline.of(body);
        double d = outline.distance(x, y);
        if (found == count && (d > most || d == most && i > blocks[count - 1])) {
            return;
        }
        if (found == blocks.length) {
            blocks = Arrays.copyOf(blocks, 2 * found);
            distances = Arrays.copyOf(distances, 2 * found);
        }
        int k = found == count ? count - 1 : found++;
        while (k > 0 && (distances[k - 1] > d || distances[k - 1] == d && blocks[k - 1] > i)) {
            blocks[k] = blocks[k - 1];
            distances[k] = distances[k - 1];
            k--;
        }
        blocks[k] = i;
        distances[k] = d;
    }
}
