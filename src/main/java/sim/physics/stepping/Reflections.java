// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.BOUNCE;
import static sim.physics.stepping.ContactRows.FORCED;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NORMAL_MASS;
import static sim.physics.stepping.ContactRows.OPENING;
import static sim.physics.stepping.ContactRows.PAIR;
import static sim.physics.stepping.ContactRows.RESTORED;
import static sim.physics.stepping.ContactRows.STEADY;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.OpenGroups;
import sim.physics.motion.State;

/**
 * Bounces in groups that nothing ties, pulls, rubs or supports, as in gases and cradles: generalized reflections (Smith, Kaufman, Vouga,
 * Tamstorf and Grinspun, <i>Reflections on simultaneous impact</i>, 2012). What the contacts took in the substep is taken back; then of all points
 * those that approach are mirrored together, those that approach after that, and so on, until none does: a wave goes through a row of
 * bodies at once, symmetric scenes stay so, and elastic bodies keep their energy.
 */
final class Reflections implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Rounds of a step at most, and turns in each of them. */
    private static final int ROUNDS = 128;

    private static final int TURNS = 32;

    /** When an impulse has settled, relative to itself. */
    private static final double SETTLED = 1e-12;

    /** Approach that counts as none, relative to the fastest one of the step. */
    private static final double NEGLIGIBLE = 1e-9;

    private final State state;
    private final ContactRows rows;
    private final Groups groups;
    private final FreeImpacts free;

    /** By group: whether something else than bounces has part in its impacts. */
    private boolean[] isBound = {};

    /** By group: the fastest approach, 0 if it is not reflected. */
    private double[] fastest = {};

    /** Groups that have not settled in a round. */
    private final OpenGroups turns = new OpenGroups();

    private double h;

    Reflections(State state, ContactRows rows, Groups groups, FreeImpacts free) {
        this.state = state;
        this.rows = rows;
        this.groups = groups;
        this.free = free;
    }

    /**
     * Finds the groups that are reflected; their points give nothing back otherwise.
     *
     * @param step the step
     */
    void reflect(double step) {
        h = step;
        find();
        if (!areSome()) {
            return;
        }
        takeBack();
        boolean goesOn = true;
        for (int round = 0; goesOn && round < ROUNDS; round++) {
            goesOn = choose();
            boolean isOpen = goesOn;
            for (int turn = 0; isOpen && turn < TURNS; turn++) {
                compress();
                isOpen = turns.goOn();
            }
            restore();
        }
        end();
    }

    private boolean areSome() {
        boolean any = false;
        for (int g = 0; g < groups.count; g++) {
            isBound[g] |= fastest[g] == 0;
            any |= !isBound[g];
        }
        return any;
    }

    private boolean isReflected(int row) {
        return !isBound[groups.of(row, rows)];
    }

    private void find() {
        if (isBound.length < groups.count) {
            isBound = new boolean[groups.slots.length];
            fastest = new double[groups.slots.length];
        }
        Arrays.fill(isBound, 0, groups.count, true);
        Arrays.fill(fastest, 0, groups.count, 0);
        for (int n = 0; n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            for (int p = rows.begin(row); p < rows.end(row); p += STRIDE) {
                if (rows.points[p + RESTORED] > Impacts.PLASTIC) {
                    int group = groups.of(row, rows);
                    isBound[group] = !free.isOne(group);
                    fastest[group] = Math.max(fastest[group], -rows.points[p + OPENING]);
                }
            }
        }
        for (int n = 0; n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            for (int p = rows.begin(row); p < rows.end(row); p += STRIDE) {
                boolean isBounce = rows.points[p + RESTORED] > Impacts.PLASTIC && rows.points[p + TANGENT] == 0;
                isBound[groups.of(row, rows)] |= rows.points[p + FORCED] != 0 || !isBounce && rows.points[p + NORMAL] > 0;
            }
        }
    }

    private void takeBack() {
        for (int k = 0; k < groups.bodies; k++) {
            int b = groups.blocks[k];
            if (!isBound[groups.slots[b / State.BLOCK]]) {
                System.arraycopy(free.velocities(), b, state.v(), b, State.BLOCK);
            }
        }
        for (int n = 0; n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            for (int p = rows.begin(row); isReflected(row) && p < rows.end(row); p += STRIDE) {
                rows.points[p + NORMAL] = 0;
            }
        }
    }

    /** Chooses the points that approach; an impulse below 0 is that of one that is not chosen. */
    private boolean choose() {
        boolean any = false;
        turns.begin(groups.count);
        for (int n = 0; n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            int group = groups.of(row, rows);
            for (int p = rows.begin(row); isReflected(row) && p < rows.end(row); p += STRIDE) {
                boolean touches = Impacts.touches(rows, row, p, h);
                boolean isChosen = touches && rows.opening(row, p, state.v()) < -NEGLIGIBLE * fastest[group];
                rows.points[p + STEADY] = isChosen ? 0 : -1;
                if (isChosen) {
                    turns.open(group);
                    any = true;
                }
            }
        }
        return any;
    }

    private void compress() {
        for (int n = 0; n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            int group = groups.of(row, rows);
            for (int p = rows.begin(row); turns.isOpen(group) && p < rows.end(row); p += STRIDE) {
                turns.change(group, rows.points[p + STEADY] >= 0 && compress(row, p));
            }
        }
    }

    /** Takes what is left of a point's approach; whether there was anything. */
    private boolean compress(int row, int p) {
        double old = rows.points[p + STEADY];
        double now = Math.max(0, old - rows.points[p + NORMAL_MASS] * rows.opening(row, p, state.v()));
        rows.points[p + STEADY] = now;
        rows.give(row, p, state.v(), now - old, 0);
        return Math.abs(now - old) > SETTLED * (now + old);
    }

    private void restore() {
        for (int n = 0; n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            for (int p = rows.begin(row); isReflected(row) && p < rows.end(row); p += STRIDE) {
                double taken = Math.max(0, rows.points[p + STEADY]);
                double given = rows.normals[PAIR * row + BOUNCE] * taken;
                rows.give(row, p, state.v(), given, 0);
                rows.points[p + NORMAL] += taken + given;
                rows.points[p + STEADY] = -1;
            }
        }
    }

    private void end() {
        for (int n = 0; n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            for (int p = rows.begin(row); isReflected(row) && p < rows.end(row); p += STRIDE) {
                rows.points[p + RESTORED] = 0; // the two part
            }
        }
    }
}
