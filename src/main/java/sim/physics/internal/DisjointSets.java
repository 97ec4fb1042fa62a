// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

/**
 * Sets that are joined: each is known by one of its members, which is its own parent; others have one nearer to
 * it (union–find, Tarjan 1975).
 */
public final class DisjointSets {
    private DisjointSets() {}

    /**
     * Finds the set of a member, and shortens the way to it.
     *
     * @param parent by member
     * @param k member
     * @return the member by which its set is known
     */
    public static int find(int[] parent, int k) {
        int root = k;
        while (parent[root] != root) {
            parent[root] = parent[parent[root]];
            root = parent[root];
        }
        return root;
    }

    /**
     * Joins the sets of two members; the lesser of the two by which they were known is that of both.
     *
     * @param parent by member
     * @param a member
     * @param b member
     */
    public static void join(int[] parent, int a, int b) {
        int first = find(parent, a);
        int second = find(parent, b);
        parent[Math.max(first, second)] = Math.min(first, second);
    }
}
