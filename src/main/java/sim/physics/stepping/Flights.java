// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.BEFORE;
import static sim.physics.stepping.ContactRows.BEND;
import static sim.physics.stepping.ContactRows.BOUNCE;
import static sim.physics.stepping.ContactRows.FORCED;
import static sim.physics.stepping.ContactRows.LAST;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.OPENING;
import static sim.physics.stepping.ContactRows.PAIR;
import static sim.physics.stepping.ContactRows.RESTORED;
import static sim.physics.stepping.ContactRows.STRIDE;

import java.io.Serializable;
import java.util.Arrays;

/**
 * Pairs of bodies that are in flight but for one another: the only one in their group that presses bounces however slow it is, and where nothing presses in
 * the end, what an impulse has left that was given and taken back within the substep is undone.
 */
final class Flights implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Mark of a point whose impulse was taken back within the substep, in place of what it gives back. */
    static final double TAKEN_BACK = -1;

    /** Length of a bounce, in substeps, from which on it is one: what has bounced is apart when the next substep begins. */
    private static final double SHORTEST = 1;

    private final ContactRows rows;
    private final Groups groups;

    /** By group: whether joints tie bodies of it, and how many of its pairs press. */
    private boolean[] areTied = {};

    private int[] pressing = {};
    private boolean areCounted;

    Flights(ContactRows rows, Groups groups) {
        this.rows = rows;
        this.groups = groups;
    }

    /**
     * Begins a step.
     *
     * @param areTied live; by group: whether joints tie bodies of it
     */
    void begin(boolean[] areTied) {
        this.areTied = areTied;
        if (pressing.length < groups.count) {
            pressing = new int[groups.slots.length];
        }
    }

    /** Begins a substep, whose impulses are there: the pairs that press are counted when it matters. */
    void clear() {
        areCounted = false;
    }

    /** Counts the pairs that press, before impulses are taken back. */
    void count() {
        if (areCounted) {
            return;
        }
        areCounted = true;
        Arrays.fill(pressing, 0, groups.count, 0);
        for (int k = 0; k < rows.count; k++) {
            if (rows.sum(k, NORMAL) > 0 && groups.has(k, rows)) {
                pressing[groups.of(k, rows)]++;
            }
        }
    }

    private int pressing(int k) {
        count();
        return pressing[groups.of(k, rows)];
    }

    /** Whether two may have missed one another that were taken to meet: no other pair of their group presses, and where they are is known well enough. */
    boolean mayMiss(int k) {
        return rows.mayBounce(k) && isOnly(k) && rows.turns.areFollowed(k);
    }

    private boolean isOnly(int k) {
        return pressing(k) <= 1;
    }

    /** Whether an impulse was taken back where nothing presses. Bodies have moved meanwhile, so that it has left something: they fly anew. */
    boolean isUndone(int k, int p) {
        return rows.points[p + RESTORED] == TAKEN_BACK && mayFly(k) && pressing(k) == 0;
    }

    /**
     * Whether a pair bounces that alone presses in its group, however slow it is.
     *
     * @param h the step
     * @param d the substep
     */
    boolean isHop(int k, int p, double h, double d) {
        double pull = Math.max(0, -rows.points[p + FORCED] - rows.points[p + BEND]);
        boolean isLong = -2 * rows.normals[PAIR * k + BOUNCE] * rows.points[p + OPENING] > SHORTEST * d * pull;
        return isLong && mayFly(k) && comes(k, h) && isOnly(k);
    }

    /** Whether nothing but bounces and even forces has part in what the bodies of a pair do. */
    private boolean mayFly(int k) {
        return !groups.areRubbed() && !areTied[groups.of(k, rows)] && rows.turns.areFollowed(k);
    }

    /** Whether all points of a pair that press have come together in this substep. */
    private boolean comes(int k, double h) {
        boolean yes = true;
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            yes &= rows.points[p + NORMAL] == 0 || comes(k, p, h);
        }
        return yes;
    }

    /** Whether a point was apart when the substep began, or did not press in the one before. */
    boolean comes(int k, int p, double h) {
        double closed = Impacts.closed(rows, k, h);
        double gap = rows.points[p + BEFORE];
        return gap > closed || gap > -closed && rows.points[p + LAST] == 0;
    }
}
