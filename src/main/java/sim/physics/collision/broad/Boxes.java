// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;

/**
 * Axis-parallel boxes of all bodies, [min x, min y, max x, max y] per body. A body's box holds the whole path of the
 * body until the box is set again, so that bodies whose boxes are apart cannot meet before.
 */
public final class Boxes implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values per box. */
    public static final int STRIDE = 4;

    private double[] data = new double[8 * STRIDE];
    private final BodyNotes notes = new BodyNotes();

    /** Makes no box. */
    public Boxes() {
        // the arrays grow with the bodies
    }

    /**
     * The values themselves.
     *
     * @return [min x, min y, max x, max y] per body, length; live
     */
    public double[] data() {
        return data;
    }

    /**
     * What is noted of the bodies.
     *
     * @return live
     */
    public BodyNotes notes() {
        return notes;
    }

    /**
     * Makes room for boxes, and for what is noted of the bodies.
     *
     * @param count number of blocks
     */
    public void ensure(int count) {
        notes.ensure(count);
        if (data.length < STRIDE * count) {
            data = Arrays.copyOf(data, STRIDE * Growth.length(data.length / STRIDE, count));
        }
    }

    /**
     * Whether a body is fixed. Two fixed bodies are never a pair.
     *
     * @param body index
     * @return true for a wall
     */
    public boolean isFixed(int body) {
        return notes.has(body, BodyNotes.FIXED);
    }

    /**
     * Notes whether a body is fixed.
     *
     * @param body index
     * @param isFixed true for a wall
     */
    public void setFixed(int body, boolean isFixed) {
        notes.set(body, BodyNotes.FIXED, isFixed);
    }

    /**
     * Sets a box.
     *
     * @param body index
     * @param minX length
     * @param minY length
     * @param maxX length
     * @param maxY length
     */
    public void set(int body, double minX, double minY, double maxX, double maxY) {
        int o = STRIDE * body;
        data[o] = minX;
        data[o + 1] = minY;
        data[o + 2] = maxX;
        data[o + 3] = maxY;
    }

    /** The longer side of a body's box. */
    double extent(int body) {
        int o = STRIDE * body;
        return Math.max(data[o + 2] - data[o], data[o + 3] - data[o + 1]);
    }

    /**
     * Whether the boxes of two bodies overlap and one of the bodies is movable.
     *
     * @param a index
     * @param b index
     * @return true if they are to be a pair
     */
    public boolean overlap(int a, int b) {
        int i = STRIDE * a;
        return meets(b, data[i], data[i + 1], data[i + 2], data[i + 3]) && !(isFixed(a) && isFixed(b));
    }

    private boolean meets(int body, double minX, double minY, double maxX, double maxY) {
        return met(body, minX, minY, maxX, maxY) != 0;
    }

    /**
     * 1 if the box of a body and a given one overlap, else 0: no branch for four comparisons that nobody could foretell,
     * since what counts is that none of the differences is negative.
     */
    int met(int body, double minX, double minY, double maxX, double maxY) {
        int o = STRIDE * body;
        double[] d = data;
        long signs = Double.doubleToRawLongBits(d[o + 2] - minX)
                | Double.doubleToRawLongBits(maxX - d[o])
                | Double.doubleToRawLongBits(d[o + 3] - minY)
                | Double.doubleToRawLongBits(maxY - d[o + 1]);
        return (int) (~signs >>> 63);
    }
}
