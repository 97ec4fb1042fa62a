// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.io.Serializable;
import java.util.Arrays;

/**
 * The bodies of finer levels in the cells of a level. Without it a body would have to look at all the fine cells that its box
 * covers; bodies cross coarse cells seldom, so it costs little to keep.
 */
final class CellShadow implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int NONE = -1;

    private final CellLevel level;

    /** The first body of each cell's bucket, plus 1. */
    final int[] head;

    /** The body that follows another one in its cell, plus 1, at the place of the other one plus 1. */
    final int[] next;

    private final int[] before;
    private final int[] cells;

    CellShadow(CellLevel level, int bodies) {
        this.level = level;
        head = new int[level.mask + 1];
        next = new int[bodies + 1];
        before = new int[bodies + 1];
        cells = new int[bodies];
        Arrays.fill(cells, NONE);
    }

    /** Puts a body where its box is now. */
    void put(int body, Boxes boxes) {
        int cell = level.place(body, boxes) & level.mask;
        if (cell != cells[body]) {
            drop(body);
            cells[body] = cell;
            int first = head[cell];
            head[cell] = body + 1;
            next[body + 1] = first;
            before[body + 1] = 0;
            before[first] = body + 1;
        }
    }

    /** Takes a body out, if it is in. */
    void drop(int body) {
        int cell = cells[body];
        if (cell == NONE) {
            return;
        }
        cells[body] = NONE;
        int left = before[body + 1];
        int right = next[body + 1];
        if (left == 0) {
            head[cell] = right;
        } else {
            next[left] = right;
        }
        before[right] = left;
    }
}
