// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.Arrays;

/** Finds out whether the pins of an island form a tree, and lays it out from the root to the tips. */
final class TreeLayout {
    private final Island island;
    private final double[] arms;

    /** By body: the first of its pins' sides, 2 p or 2 p + 1, or −1; and the next one of the same body. */
    private final int[] first;

    private final int[] next;

    private TreeLayout(Island island, double[] arms) {
        this.island = island;
        this.arms = arms;
        first = new int[island.bodies.size];
        next = new int[2 * island.nodes];
        Arrays.fill(first, -1);
        for (int side = 2 * island.nodes - 1; side >= 0; side--) {
            int body = body(side);
            if (body >= 0) {
                next[side] = first[body];
                first[body] = side;
            }
        }
    }

    private int body(int side) {
        return side % 2 == 0 ? island.a[side / 2] : island.b[side / 2];
    }

    /**
     * Lays a tree out. An island hangs together, so its pins form a tree if there are as many as bodies, one of them in the
     * world, or one less.
     *
     * @param island its constraints are all pins
     * @param arms by node: the arms of both bodies; places in the world for what does not move
     * @return null if there are loops
     */
    static PinTree find(Island island, double[] arms) {
        int held = 0;
        int root = 0;
        for (int p = 0; p < island.nodes; p++) {
            if (island.a[p] < 0 || island.b[p] < 0) {
                held++;
                root = Math.max(island.a[p], island.b[p]);
            }
        }
        boolean isTree = held <= 1 && island.nodes == island.bodies.size - 1 + held;
        return isTree ? new TreeLayout(island, arms).follow(held == 0 ? hub(island, arms) : root, held == 0) : null;
    }

    /** The body to which all others of a free tree are pinned at their own centres of mass; 0 if there is none. */
    private static int hub(Island island, double[] arms) {
        for (int p = 0, hub = island.a[0], other = island.b[0]; ; p++) {
            if (p == island.nodes) {
                return hub;
            }
            boolean isFirst = island.a[p] == hub;
            int side = 2 * (isFirst ? 2 * p + 1 : 2 * p);
            if (!isFirst && island.b[p] != hub || arms[side] != 0 || arms[side + 1] != 0) {
                if (hub == other) {
                    return 0;
                }
                hub = other; // the first pin has two bodies
                p = -1;
            }
        }
    }

    /** Parents before children, and right before one of them. */
    private PinTree follow(int root, boolean isFree) {
        int n = island.bodies.size;
        int[] block = new int[n];
        int[] parent = new int[n];
        double[] laid = new double[4 * n];
        int[] stack = new int[n];
        int[] from = new int[n];
        int[] by = new int[n]; // the own side of the pin to the parent
        int size = 1;
        stack[0] = root;
        from[root] = -1;
        by[root] = isFree ? -1 : held(root);
        for (int k = 0; k < n; k++) {
            int body = stack[--size];
            int near = by[body];
            block[k] = 3 * island.bodies.values[body];
            parent[k] = from[body];
            if (near >= 0) {
                System.arraycopy(arms, 2 * near, laid, 4 * k, 2);
                System.arraycopy(arms, 2 * (near ^ 1), laid, 4 * k + 2, 2);
            }
            for (int side = first[body]; side >= 0; side = next[side]) {
                int other = body(side ^ 1);
                if (side != near && other >= 0) {
                    from[other] = k;
                    by[other] = side ^ 1;
                    stack[size++] = other;
                }
            }
        }
        return new PinTree(block, parent, laid, isFree);
    }

    private int held(int body) {
        int side = first[body];
        while (body(side ^ 1) >= 0) {
            side = next[side];
        }
        return side;
    }
}
