// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.broad.Boxes;
import sim.physics.collision.broad.Departures;
import sim.physics.collision.broad.Pairs;
import sim.physics.internal.IntList;

/**
 * Puts many bodies or pairs into an order in which neighbours in space follow one another, so that what is read of one of them
 * and its surroundings is still in the cache for the next one. Large scenes do not fit there, and what is due in a step comes
 * in the order in which it was noted, from all over the place. Nothing depends on the order but which numbers new pairs get.
 *
 * <p>A pass of counting: the items go into square tiles, row by row, and keep their order within a tile.
 */
final class SpaceOrder implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Fewer items are left as they are. */
    private static final int MANY = 512;

    /** Items in a tile, about, and the most tiles in a row. */
    private static final int PER_TILE = 8;

    private static final int MOST = 128;

    private final Boxes boxes;
    private final Pairs pairs;
    private final Departures departures = new Departures();

    /** Scratch: the tiles of the items, the items, and where those of each tile begin. */
    private transient int[] tiles;

    private transient int[] copy;
    private transient int[] begins;

    private double minX;
    private double minY;
    private double maxX;
    private double maxY;

    SpaceOrder(Boxes boxes, Pairs pairs) {
        this.boxes = boxes;
        this.pairs = pairs;
    }

    /** Whether a list is worth sorting. */
    boolean isLong(IntList list) {
        return list.size >= MANY;
    }

    /** Sorts bodies that leave their boxes by the lower corners of these; the order that they had is taken down. */
    Departures sortLeaving(IntList bodies, int all) {
        departures.begin(bodies, all);
        room(bodies.size);
        System.arraycopy(bodies.values, 0, copy, 0, bodies.size);
        sort(bodies, bodies.size);
        return departures;
    }

    /** Sorts pairs by those of their first bodies; pairs that have ended are left out. */
    void sortPairs(IntList those) {
        if (!isLong(those)) {
            return;
        }
        room(those.size);
        int n = 0;
        for (int k = 0; k < those.size; k++) {
            int body = pairs.first(those.values[k]);
            if (body >= 0) {
                those.values[n] = those.values[k];
                copy[n++] = boxes.isFixed(body) ? pairs.second(those.values[k]) : body;
            }
        }
        those.size = n;
        sort(those, n);
    }

    private void room(int count) {
        if (tiles == null || tiles.length < count) {
            int length = count + count / 4;
            tiles = new int[length];
            copy = new int[length];
            begins = new int[MOST * MOST + 1];
        }
    }

    /** Sorts items whose bodies lie in the copy. */
    private void sort(IntList items, int n) {
        bound(n);
        int across = Math.min(MOST, (int) Math.sqrt(n / PER_TILE));
        double perTile = across / Math.max(Math.max(maxX - minX, maxY - minY), Double.MIN_NORMAL);
        double[] d = boxes.data();
        Arrays.fill(begins, 0, across * across + 1, 0);
        for (int k = 0; k < n; k++) {
            int o = Boxes.STRIDE * copy[k];
            int column = Math.min(across - 1, (int) ((d[o] - minX) * perTile));
            int row = Math.min(across - 1, (int) ((d[o + 1] - minY) * perTile));
            tiles[k] = row * across + column;
            begins[tiles[k] + 1]++;
        }
        for (int t = 0; t < across * across; t++) {
            begins[t + 1] += begins[t];
        }
        System.arraycopy(items.values, 0, copy, 0, n);
        for (int k = 0; k < n; k++) {
            items.values[begins[tiles[k]]++] = copy[k];
        }
    }

    private void bound(int n) {
        double[] d = boxes.data();
        minX = Double.POSITIVE_INFINITY;
        minY = Double.POSITIVE_INFINITY;
        maxX = Double.NEGATIVE_INFINITY;
        maxY = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < n; k++) {
            int o = Boxes.STRIDE * copy[k];
            minX = Math.min(minX, d[o]);
            minY = Math.min(minY, d[o + 1]);
            maxX = Math.max(maxX, d[o]);
            maxY = Math.max(maxY, d[o + 1]);
        }
    }
}
