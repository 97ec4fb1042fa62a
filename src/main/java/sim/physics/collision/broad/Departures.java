// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;

/**
 * Bodies that leave their boxes in one step, in their order of leaving. If they are looked at in another order, a pair of two
 * of them ends just as if they were looked at in that one: the first of the two is in its new box while the second one is
 * still in its old box. Whether a pair ends and begins anew decides where the search for its contact starts, and so of the
 * last bits of the instant found.
 */
public final class Departures implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Per body its place in the order, plus {@link #base}; less for those that do not leave in this step. */
    private transient int[] places = {};

    /** The old boxes, in the order of leaving. */
    private transient double[] old = {};

    private transient int base;
    private transient int count;

    /** Makes a set that is empty. */
    public Departures() {
        // a small scene pays nothing
    }

    /**
     * Takes down an order of leaving.
     *
     * @param bodies those that leave
     * @param all one more than the largest index of a body
     */
    public void begin(IntList bodies, int all) {
        if (places == null || places.length < all) {
            places = new int[Growth.length(places == null ? 0 : places.length, all)];
            base = 0;
            count = 0;
        }
        base += count;
        if (base > Integer.MAX_VALUE / 2) {
            Arrays.fill(places, 0);
            base = 0;
        }
        base = Math.max(base, 1);
        count = bodies.size;
        for (int k = 0; k < count; k++) {
            places[bodies.values[k]] = base + k;
        }
        if (old == null || old.length < Boxes.STRIDE * count) {
            old = new double[Boxes.STRIDE * (count + count / 8)];
        }
    }

    /**
     * Keeps the old box of a body that leaves.
     *
     * @param body index
     * @param boxes all boxes
     */
    public void keep(int body, Boxes boxes) {
        System.arraycopy(boxes.data(), Boxes.STRIDE * body, old, Boxes.STRIDE * (places[body] - base), Boxes.STRIDE);
    }

    /**
     * Takes note that a body that leaves has been looked at, and its pairs with the others that leave.
     *
     * @param body index
     */
    void done(int body) {
        places[body] = 0;
    }

    /**
     * Whether a pair ends because the second of two bodies that leave, neither of which has been looked at, has not left yet
     * when the first one has.
     *
     * @param body a body that leaves
     * @param other any other
     * @param boxes all boxes
     * @return true if it ends, though their new boxes may overlap
     */
    boolean parts(int body, int other, Boxes boxes) {
        if (places[other] < base) {
            return false;
        }
        boolean isFirst = places[body] < places[other];
        int first = Boxes.STRIDE * (isFirst ? body : other);
        int second = Boxes.STRIDE * (places[isFirst ? other : body] - base);
        double[] d = boxes.data();
        return !(d[first + 2] >= old[second]
                && old[second + 2] >= d[first]
                && d[first + 3] >= old[second + 1]
                && old[second + 3] >= d[first + 1]);
    }
}
