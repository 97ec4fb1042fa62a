// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;

/** The rows of each body among those of contacts, listed when somebody asks for them. */
final class BodyRows implements Serializable {
    private static final long serialVersionUID = 1L;

    private final ContactRows rows;

    /** By body its first row, −1 for none, and by row the next one of its first and of its second body; while {@link #areListed}. */
    private transient int[] first;

    private transient int[] next;
    private transient boolean areListed;

    BodyRows(ContactRows rows) {
        this.rows = rows;
    }

    /** Takes note that there are other rows now. */
    void forget() {
        areListed = false;
    }

    /** The first row of a body, −1 for none; {@link #next} has the others. */
    int first(int body) {
        if (!areListed) {
            list();
        }
        return body < first.length ? first[body] : -1;
    }

    /** The row of a body after one of it, −1 for none. */
    int next(int row, int body) {
        return next[2 * row + (rows.first(row) == body ? 0 : 1)];
    }

    private void list() {
        int bodies = 0;
        for (int row = 0; row < rows.count; row++) {
            bodies = Math.max(bodies, 1 + Math.max(rows.first(row), rows.second(row)));
        }
        first = first == null || first.length < bodies ? new int[bodies] : first;
        next = next == null || next.length < 2 * rows.count ? new int[2 * rows.count] : next;
        Arrays.fill(first, -1);
        for (int row = rows.count - 1; row >= 0; row--) {
            next[2 * row] = first[rows.first(row)];
            first[rows.first(row)] = row;
            next[2 * row + 1] = first[rows.second(row)];
            first[rows.second(row)] = row;
        }
        areListed = true;
    }
}
