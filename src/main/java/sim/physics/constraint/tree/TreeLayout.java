// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import java.util.Arrays;
import sim.physics.internal.IntList;

/** Finds out whether the pins of an island form a tree, and lays it out from the root to the tips. */
final class TreeLayout {
    private final IntList bodies;

    /** By pin: both bodies. */
    private final int[] a;

    private final int[] b;
    private final double[] arms;

    /** By body: the first of its pins' sides, 2 p or 2 p + 1, or −1; and the next one of the same body. */
    private final int[] first;

    private final int[] next;

    private TreeLayout(IntList bodies, int[] a, int[] b, double[] arms) {
        this.bodies = bodies;
        this.a = a;
        this.b = b;
        this.arms = arms;
        first = new int[bodies.size];
        next = new int[2 * a.length];
        Arrays.fill(first, -1);
        for (int side = 2 * a.length - 1; side >= 0; side--) {
            int body = body(side);
            if (body >= 0) {
                next[side] = first[body];
                first[body] = side;
            }
        }
    }

    private int body(int side) {
        return side % 2 == 0 ? a[side / 2] : b[side / 2];
    }

    /**
     * Lays a tree out. An island hangs together, so its pins form a tree if there are as many as bodies, one of them in the
     * world, or one less.
     *
     * @param bodies of the island
     * @param a by pin: the place of the one body among those of the island; −1 for what does not move
     * @param b the other body
     * @param arms by pin: the arms of both bodies; places in the world for what does not move
     * @return null if there are loops, or no pins: a body with a motor and nothing else has none while that is let go
     */
    static PinTree find(IntList bodies, int[] a, int[] b, double[] arms) {
        int held = 0;
        int root = 0;
        for (int p = 0; p < a.length; p++) {
            if (a[p] < 0 || b[p] < 0) {
                held++;
                root = Math.max(a[p], b[p]);
            }
        }
        boolean isTree = a.length > 0 && held <= 1 && a.length == bodies.size - 1 + held;
        return isTree ? new TreeLayout(bodies, a, b, arms).follow(held == 0 ? hub(a, b, arms) : root, held == 0) : null;
    }

    /** The body to which all others of a free tree are pinned at their own centres of mass; 0 if there is none. */
    private static int hub(int[] a, int[] b, double[] arms) {
        for (int p = 0, hub = a[0], other = b[0]; ; p++) {
            if (p == a.length) {
                return hub;
            }
            boolean isFirst = a[p] == hub;
            int side = 2 * (isFirst ? 2 * p + 1 : 2 * p);
            if (!isFirst && b[p] != hub || arms[side] != 0 || arms[side + 1] != 0) {
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
        int n = bodies.size;
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
            block[k] = 3 * bodies.values[body];
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
