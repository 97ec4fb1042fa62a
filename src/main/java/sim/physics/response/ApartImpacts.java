// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.DisjointSets;
import sim.physics.internal.IntList;

/**
 * Solves the points of one instant part by part: those that movable bodies or their ties connect are a part. Thousands of balls
 * that were let go at one height land at one instant; solved as one, their cost would be the cube of their number, and what one
 * of them gets would depend on all others.
 */
final class ApartImpacts implements Serializable {
    private static final long serialVersionUID = 1L;

    private final SimultaneousImpact all;
    private final SimultaneousImpact one;

    /** By body of the instant: which are connected. */
    private int[] parent = new int[8];

    /** By body by which a part is known: its number; by number: where its next point belongs. */
    private int[] numbers = new int[8];

    private int[] next = new int[8];

    /** By point: a body of it, then its part. */
    private int[] part = new int[8];

    /** The points, part by part, and where each part ends. */
    private int[] sorted = new int[8];

    private final IntList ends = new IntList();

    /**
     * Makes what solves one instant.
     *
     * @param all takes all points, and their solution
     * @param one solves a part of them
     */
    ApartImpacts(SimultaneousImpact all, SimultaneousImpact one) {
        this.all = all;
        this.one = one;
    }

    /** Solves for the impulses and gives the bodies their new velocities. */
    void solve() {
        if (all.isOfOnePair()) {
            all.solve();
            return;
        }
        connect();
        sort(all.pointCount());
        if (ends.size == 1) {
            all.solve();
            return;
        }
        for (int k = 0, from = 0; k < ends.size; k++) {
            solve(from, ends.values[k]);
            from = ends.values[k];
        }
    }

    private void solve(int from, int to) {
        one.clear();
        for (int k = from; k < to; k++) {
            all.give(sorted[k], one);
        }
        one.solve();
        for (int k = from; k < to; k++) {
            all.take(sorted[k], one, k - from);
        }
        all.takeVelocities(one);
    }

    /** Joins the bodies of each point, those of an island by the first of them. */
    private void connect() {
        int points = all.pointCount();
        if (part.length < points) {
            part = new int[2 * points];
            sorted = new int[2 * points];
        }
        if (parent.length < all.bodyCount()) {
            parent = new int[2 * all.bodyCount()];
            numbers = new int[2 * all.bodyCount()];
            next = new int[2 * all.bodyCount()];
        }
        for (int k = 0; k < all.bodyCount(); k++) {
            parent[k] = k;
        }
        for (int k = 0; k < points; k++) {
            int a = all.placeOfIsland(all.bodyA(k));
            int b = all.placeOfIsland(all.bodyB(k));
            part[k] = Math.max(a, b);
            if (a >= 0 && b >= 0) {
                DisjointSets.join(parent, a, b);
            }
        }
    }

    /** Sorts the points: parts in the order of their first points, and the points of a part in their own. */
    private void sort(int points) {
        Arrays.fill(numbers, 0, all.bodyCount(), -1);
        Arrays.fill(next, 0, all.bodyCount(), 0);
        ends.clear();
        for (int k = 0; k < points; k++) {
            int root = DisjointSets.find(parent, part[k]);
            if (numbers[root] < 0) {
                numbers[root] = ends.size;
                ends.add(0);
            }
            part[k] = numbers[root];
            ends.values[part[k]]++;
        }
        for (int k = 1; k < ends.size; k++) {
            next[k] = ends.values[k - 1];
            ends.values[k] += ends.values[k - 1];
        }
        for (int k = 0; k < points; k++) {
            sorted[next[part[k]]++] = k;
        }
    }
}
