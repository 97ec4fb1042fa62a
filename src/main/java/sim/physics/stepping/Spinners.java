// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.FEATURE;
import static sim.physics.stepping.ContactRows.GAP;
import static sim.physics.stepping.ContactRows.INTS;
import static sim.physics.stepping.ContactRows.LAST;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NORMAL_SUM;
import static sim.physics.stepping.ContactRows.NOW;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT;
import static sim.physics.stepping.ContactRows.TANGENT_SUM;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/**
 * Finds the points of what turns far within a step anew in each substep: other corners come to where those of the start were, and gaps that are foreseen from
 * there are off by the square of the turn. Of all other pairs points are found once a step.
 */
final class Spinners implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values kept of a point while others are found. */
    private static final int KEPT = 4;

    private final State state;
    private final Poses poses;
    private final NearPairs near;
    private final Touch touch;
    private final ContactRows rows;

    /** The rows, the bodies that spin, and how far what is looked for may be away. */
    private final IntList spinning = new IntList();
    private final IntList bodies = new IntList();

    private double[] reaches = {};

    /** Of the points of a row: impulses, and the features. */
    private final double[] kept = new double[2 * KEPT];

    Spinners(State state, Poses poses, NearPairs near, Touch touch, ContactRows rows) {
        this.state = state;
        this.poses = poses;
        this.near = near;
        this.touch = touch;
        this.rows = rows;
    }

    /**
     * Makes room for two points of the row that was added last if it is one.
     *
     * @param reach how far what is looked for may be away
     */
    void add(double reach) {
        int k = rows.count - 1;
        spinning.size = k == 0 ? 0 : spinning.size;
        bodies.size = k == 0 ? 0 : bodies.size;
        if (rows.turns.areFollowed(k)) {
            return;
        }
        note(rows.first(k), touch.isDiscA);
        note(rows.second(k), touch.isDiscB);
        if (reaches.length <= spinning.size) {
            reaches = Arrays.copyOf(reaches, 2 * spinning.size + 8);
        }
        reaches[spinning.size] = reach;
        spinning.add(k);
        int begin = rows.begin(k);
        for (int p = rows.end(k); p < begin + 2 * STRIDE; p++) {
            rows.points[p] = 0;
        }
        rows.used = begin / STRIDE + 2;
    }

    /** Takes note of a body that spins: all of its rows are of this kind. */
    private void note(int body, boolean isDisc) {
        if (!isDisc && rows.turns.spins(body)) {
            bodies.add(body);
        }
    }

    /**
     * Begins a substep: nothing is to be found in the first one. What bodies that spin have done until now is no part of what is measured from now on.
     *
     * @param substep its number in the step
     * @param a accelerations by forces
     */
    void find(int substep, double[] a) {
        boolean areSome = substep > 0 && rows.count > 0;
        for (int n = 0; areSome && n < bodies.size; n++) {
            int b = State.BLOCK * bodies.values[n];
            System.arraycopy(state.x(), b, rows.from, b, State.BLOCK);
        }
        for (int n = 0; areSome && n < spinning.size; n++) {
            find(spinning.values[n], reaches[n], a);
        }
    }

    private void find(int k, double reach, double[] a) {
        int pair = rows.pair(k);
        poses.turn(rows.first(k));
        poses.turn(rows.second(k));
        touch.find(rows.first(k), near.pairs().firstPart(pair), rows.second(k), near.pairs().secondPart(pair), reach);
        double normalSum = rows.impulse(k);
        double tangentSum = rows.rubbed(k);
        keep(k);
        if (touch.count == 0) {
            for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
                rows.points[p + GAP] = reach;
            }
            return;
        }
        rows.turns.hold(k, touch.nx, touch.ny);
        load(k, a);
        restore(k);
        int begin = rows.begin(k);
        rows.points[begin + NORMAL_SUM] = normalSum;
        rows.points[begin + TANGENT_SUM] = tangentSum;
        rows.turns.measure(k);
        for (int m = 0; m < touch.count; m++) {
            int p = begin + m * STRIDE;
            rows.points[p + GAP] += touch.gap[m] - rows.points[p + NOW];
            rows.points[p + NOW] = touch.gap[m];
        }
    }

    private void keep(int k) {
        Arrays.fill(kept, 0);
        int m = 0;
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            kept[m++] = rows.points[p + FEATURE];
            kept[m++] = rows.points[p + NORMAL];
            kept[m++] = rows.points[p + TANGENT];
            kept[m++] = rows.points[p + LAST];
            rows.points[p + NORMAL] = 0;
            rows.points[p + TANGENT] = 0;
        }
    }

    /** Loads the points as those of now, where bodies that do not spin have moved since the step began. */
    private void load(int k, double[] a) {
        int first = State.BLOCK * rows.first(k);
        int second = State.BLOCK * rows.second(k);
        double[] from = rows.from;
        rows.from = state.x();
        int used = rows.used;
        rows.used = rows.begin(k) / STRIDE;
        for (int m = 0; m < touch.count; m++) {
            rows.load(touch, m, first, second, a);
        }
        rows.pairs[INTS * k + 4] = rows.used;
        rows.used = used;
        rows.from = from;
    }

    /** A corner that is still there begins with the impulses that it had. */
    private void restore(int k) {
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            for (int m = 0; m < 2 * KEPT; m += KEPT) {
                if (kept[m] == rows.points[p + FEATURE] && kept[m + 1] > 0) {
                    rows.points[p + NORMAL] = kept[m + 1];
                    rows.points[p + TANGENT] = kept[m + 2];
                    rows.points[p + LAST] = kept[m + 3];
                }
            }
        }
    }
}
