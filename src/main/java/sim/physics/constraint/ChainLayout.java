// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.Arrays;

/**
 * Finds out whether the pins of an island form a chain between two places that do not move, and lays it out from one to the
 * other. Chains with a free end are trees.
 */
final class ChainLayout {
    /** Pins from which the many short loops of a {@link PinChain} take less time than the general code. */
    private static final int FEWEST = 4;

    private final Island island;
    private final double[] arms;

    /** The nodes of each body, two at most. */
    private final int[] around;

    private final int[] block;
    private final double[] laid;

    private ChainLayout(Island island, double[] arms) {
        this.island = island;
        this.arms = arms;
        around = new int[2 * island.bodies.size];
        Arrays.fill(around, -1);
        block = new int[island.nodes + 1];
        laid = new double[4 * block.length];
    }

    /**
     * Lays a chain out.
     *
     * @param island its constraints are all pins
     * @param arms by node: the arms of both bodies; places in the world for what does not move
     * @return null if the pins do not form such a chain, or one too short to be worth it
     */
    static PinChain find(Island island, double[] arms) {
        if (island.nodes < FEWEST) {
            return null;
        }
        ChainLayout layout = new ChainLayout(island, arms);
        int end = layout.end();
        return end < 0 ? null : layout.follow(end);
    }

    /** A node that holds a body in the world; −1 if there is none, or a body has more than two nodes. */
    private int end() {
        int end = -1;
        for (int p = 0; p < island.nodes; p++) {
            if (!note(island.a[p], p) || !note(island.b[p], p)) {
                return -1;
            }
            end = end < 0 && (island.a[p] < 0 || island.b[p] < 0) ? p : end;
        }
        return end;
    }

    private boolean note(int body, int p) {
        if (body < 0) {
            return true;
        }
        int at = around[2 * body] < 0 ? 2 * body : 2 * body + 1;
        boolean room = around[at] < 0;
        around[at] = p;
        return room;
    }

    /** The other node of a body. */
    private int other(int body, int p) {
        return around[2 * body] == p ? around[2 * body + 1] : around[2 * body];
    }

    private PinChain follow(int end) {
        int p = end;
        boolean forward = island.a[p] < 0;
        block[0] = -1;
        for (int k = 0; p >= 0; k++) {
            int far = forward ? island.b[p] : island.a[p];
            int at = 4 * p + (forward ? 0 : 2);
            block[k + 1] = forward ? island.blockB[p] : island.blockA[p]; // −1 for what cannot move
            laid[4 * k] = arms[at];
            laid[4 * k + 1] = arms[at + 1];
            at = 4 * p + (forward ? 2 : 0);
            laid[4 * k + 6] = arms[at];
            laid[4 * k + 7] = arms[at + 1];
            p = far < 0 ? -1 : other(far, p);
            forward = p >= 0 && island.a[p] == far;
        }
        return new PinChain(block, laid);
    }
}
