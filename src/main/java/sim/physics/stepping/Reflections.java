// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.APPROACH;
import static sim.physics.stepping.ContactRows.FORCED;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NORMAL_MASS;
import static sim.physics.stepping.ContactRows.NORMAL_SUM;
import static sim.physics.stepping.ContactRows.RESTORED;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT_SUM;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.motion.State;

/**
 * Bounces in groups that nothing ties, pulls, rubs or supports, as in gases and cradles: generalized reflections (Smith, Kaufman, Vouga,
 * Tamstorf and Grinspun, <i>Reflections on simultaneous impact</i>, 2012). What the contacts took in the step is taken back; then of all points
 * those that approach are mirrored together, those that approach after that, and so on, until none does: a wave goes through a row of
 * bodies at once, symmetric scenes stay so, and elastic bodies keep their energy.
 */
final class Reflections implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Rounds of a step at most, and turns in each of them. */
    private static final int ROUNDS = 128;

    private static final int TURNS = 32;

    /** When an impulse has settled, relative to itself. */
    private static final double SETTLED = 1e-4;

    /** Approach that counts as none, relative to the fastest one of the step. */
    private static final double NEGLIGIBLE = 1e-9;

    private final State state;
    private final ContactRows rows;
    private final Groups groups;

    /** By group: whether something else than bounces has part in its impacts. */
    private boolean[] isBound = {};

    private double fastest;

    Reflections(State state, ContactRows rows, Groups groups) {
        this.state = state;
        this.rows = rows;
        this.groups = groups;
    }

    /** Finds the groups that are reflected; their points give nothing back otherwise. */
    void reflect() {
        find();
        if (fastest == 0) {
            return;
        }
        boolean goesOn = true;
        for (int round = 0; goesOn && round < ROUNDS; round++) {
            goesOn = choose();
            boolean isOpen = goesOn;
            for (int turn = 0; isOpen && turn < TURNS; turn++) {
                isOpen = compress();
            }
            restore();
        }
        end();
    }

    private int group(int row) {
        int body = rows.first(row);
        return groups.slots[state.w().values()[State.BLOCK * body] > 0 ? body : rows.second(row)];
    }

    private boolean isReflected(int row) {
        return rows.hasBounced(row) && !isBound[group(row)];
    }

    private void find() {
        if (isBound.length < groups.count) {
            isBound = new boolean[groups.slots.length];
        }
        Arrays.fill(isBound, 0, groups.count, false);
        groups.markTied(isBound);
        for (int row = 0; row < rows.count; row++) {
            for (int p = rows.begin(row); groups.has(row, rows) && p < rows.end(row); p += STRIDE) {
                boolean isBounce = rows.points[p + RESTORED] > 0 && rows.points[p + TANGENT_SUM] == 0;
                isBound[group(row)] |= rows.points[p + FORCED] != 0 || !isBounce && rows.points[p + NORMAL_SUM] > 0;
            }
        }
        fastest = 0;
        for (int row = 0; row < rows.count; row++) {
            for (int p = rows.begin(row); isReflected(row) && p < rows.end(row); p += STRIDE) {
                rows.give(row, p, state.v(), -rows.points[p + NORMAL_SUM], 0);
                rows.points[p + NORMAL_SUM] = 0;
                fastest = Math.max(fastest, -rows.points[p + APPROACH]);
            }
        }
    }

    /** Chooses the points that approach; an impulse below 0 is that of one that is not chosen. */
    private boolean choose() {
        boolean any = false;
        for (int row = 0; row < rows.count; row++) {
            for (int p = rows.begin(row); isReflected(row) && p < rows.end(row); p += STRIDE) {
                boolean approaches = rows.opening(row, p, state.v()) < -NEGLIGIBLE * fastest;
                rows.points[p + NORMAL] = approaches && rows.points[p + RESTORED] > 0 ? 0 : -1;
                any |= rows.points[p + NORMAL] == 0;
            }
        }
        return any;
    }

    private boolean compress() {
        boolean goesOn = false;
        for (int row = 0; row < rows.count; row++) {
            for (int p = rows.begin(row); isReflected(row) && p < rows.end(row); p += STRIDE) {
                goesOn |= rows.points[p + NORMAL] >= 0 && compress(row, p);
            }
        }
        return goesOn;
    }

    /** Takes what is left of a point's approach; whether there was anything. */
    private boolean compress(int row, int p) {
        double old = rows.points[p + NORMAL];
        double now = Math.max(0, old - rows.points[p + NORMAL_MASS] * rows.opening(row, p, state.v()));
        rows.points[p + NORMAL] = now;
        rows.give(row, p, state.v(), now - old, 0);
        return Math.abs(now - old) > SETTLED * (now + old);
    }

    private void restore() {
        for (int row = 0; row < rows.count; row++) {
            for (int p = rows.begin(row); isReflected(row) && p < rows.end(row); p += STRIDE) {
                double taken = Math.max(0, rows.points[p + NORMAL]);
                double given = rows.points[p + RESTORED] * taken;
                rows.give(row, p, state.v(), given, 0);
                rows.points[p + NORMAL_SUM] += taken + given;
                rows.points[p + NORMAL] = -1;
            }
        }
    }

    private void end() {
        for (int row = 0; row < rows.count; row++) {
            for (int p = rows.begin(row); isReflected(row) && p < rows.end(row); p += STRIDE) {
                rows.points[p + NORMAL] = 0; // the two part
                rows.points[p + RESTORED] = 0;
            }
        }
    }
}
