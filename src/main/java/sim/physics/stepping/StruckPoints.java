// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.AX;
import static sim.physics.stepping.ContactRows.AY;
import static sim.physics.stepping.ContactRows.BELT;
import static sim.physics.stepping.ContactRows.BEND;
import static sim.physics.stepping.ContactRows.BX;
import static sim.physics.stepping.ContactRows.BY;
import static sim.physics.stepping.ContactRows.COUPLING;
import static sim.physics.stepping.ContactRows.FRICTION;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NORMAL_MASS;
import static sim.physics.stepping.ContactRows.NOW;
import static sim.physics.stepping.ContactRows.PAIR;
import static sim.physics.stepping.ContactRows.RESTORED;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT;
import static sim.physics.stepping.ContactRows.TANGENT_MASS;

import java.io.Serializable;
import sim.physics.internal.CoulombImpulse;
import sim.physics.motion.State;

/**
 * Solves points for both of their impulses at once, as they are solved by events. What strikes is over in a substep, and what was given too much or too
 * little of is not given back in the next one.
 *
 * <p>A gap may take two substeps to be used up. The first one then gives a part of what would stop the approach, in the direction of all of it: so what
 * is left asks for the rest of it, and the sum does not depend on where substeps begin.
 */
final class StruckPoints implements Serializable {
    private static final long serialVersionUID = 1L;

    /** How often the points of a pair are solved in turn at most. */
    private static final int TURNS = 32;

    /** When an impulse has settled, relative to itself. */
    private static final double SETTLED = 1e-10;

    private final State state;
    private final ContactRows rows;
    private final PinnedPairs pinned;
    private final CoulombImpulse law = new CoulombImpulse();

    StruckPoints(State state, ContactRows rows, PinnedPairs pinned) {
        this.state = state;
        this.rows = rows;
        this.pinned = pinned;
    }

    /** Solves the points of a pair in turn, each so that it uses up what is left of its gap. All that is fixed is one to the body that strikes it. */
    void solve(int k, double h, boolean regains) {
        int body = rows.strikesFixed(k);
        int first = body < 0 ? k : rest(rows.byBody.first(body), body);
        if (first < k) {
            return; // solved with the first of them
        }
        boolean goesOn = true;
        for (int turn = 0; goesOn && turn < TURNS; turn++) {
            goesOn = false;
            int points = 0;
            for (int row = k; row >= 0; row = body < 0 ? -1 : rest(rows.byBody.next(row, body), body)) {
                goesOn |= solveInTurn(row, h, regains);
                points += rows.pointCount(row);
            }
            goesOn &= points > 1;
        }
    }

    /** The first of a body's rows from one on in which it strikes what is fixed, −1 for none. */
    private int rest(int row, int body) {
        int k = row;
        while (k >= 0 && rows.strikesFixed(k) < 0) {
            k = rows.byBody.next(k, body);
        }
        return k;
    }

    private boolean solveInTurn(int k, double h, boolean regains) {
        boolean changes = false;
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            double gap = Math.max(0, rows.points[p + NOW]);
            boolean meets = rows.points[p + NORMAL] > 0;
            boolean isOver = !regains && rows.comesToStrike(k) && (meets || gap == 0); // its gap was used up in this substep
            if (isOver || regains || !rows.comesToStrike(k)) {
                double bend = regains ? 0.5 * h * rows.points[p + BEND] : 0;
                changes |= solve(k, p, isOver ? 0 : Math.max(0, gap / h + bend), 0, 1, false) > SETTLED;
                boolean isTakenBack = meets && !regains && rows.mayBounce(k) && rows.points[p + NORMAL] == 0;
                rows.points[p + RESTORED] = isTakenBack ? Flights.TAKEN_BACK : rows.points[p + RESTORED];
            }
        }
        return changes;
    }

    /**
     * Solves a point. The law, the velocities it is asked for, and what it gives are all found here: most of the time of what bounces is spent with them.
     *
     * @param closing the speed at which it may approach
     * @param opening the speed at which it is to part
     * @param part of what this asks for that is given
     * @param isLimited whether it may create no energy
     * @return by how much its impulses have changed, relative to them
     */
    double solve(int k, int p, double closing, double opening, double part, boolean isLimited) {
        double[] d = rows.points;
        double[] v = state.v();
        int a = State.BLOCK * rows.first(k);
        int b = State.BLOCK * rows.second(k);
        double nx = rows.normals[PAIR * k], ny = rows.normals[PAIR * k + 1];
        double vx = v[a], vy = v[a + 1], spin = v[a + 2];
        double ux = v[b], uy = v[b + 1], turn = v[b + 2];
        double normal = d[p + NORMAL];
        double tangent = d[p + TANGENT];
        double apartX = ux - d[p + BY] * turn - vx + d[p + AY] * spin;
        double apartY = uy + d[p + BX] * turn - vy - d[p + AX] * spin;
        double speed = nx * apartX + ny * apartY;
        if (normal == 0 && tangent == 0 && speed + closing >= 0) {
            return 0; // it is open, and stays so
        }
        double kn = 1 / d[p + NORMAL_MASS];
        double kt = 1 / d[p + TANGENT_MASS];
        double knt = d[p + COUPLING];
        boolean isPinned = pinned.has(k);
        if (isPinned) {
            pinned.weigh(k, p);
            kn = pinned.kn;
            kt = pinned.kt;
            knt = pinned.knt;
            speed -= pinned.lostNormal;
        }
        double free = speed - kn * normal - knt * tangent;
        double given = isPinned ? Math.min(1, part) : part; // with the pin, nothing is left to be solved in turns
        double byNormal = -given * normal;
        double byTangent = -given * tangent;
        if (free + closing < 0) {
            double slide = -ny * apartX + nx * apartY + rows.normals[PAIR * k + BELT] - (isPinned ? pinned.lostTangent : 0) - knt * normal - kt * tangent;
            law.solve(kn, kt, knt, opening - free, slide, rows.normals[PAIR * k + FRICTION]);
            if (isPinned) {
                pinned.unlock(law, opening - free, slide, rows.normals[PAIR * k + FRICTION]);
            }
            if (isLimited) {
                law.limit(kn, kt, knt, free, slide, 0);
            }
            double share = closing == 0 ? given : given * ((free + closing) / free);
            byNormal += share * law.normal;
            byTangent += share * law.tangent;
        }
        double now = Math.max(0, normal + byNormal);
        byNormal = now - normal;
        byTangent = now > 0 ? byTangent : -tangent;
        d[p + NORMAL] = now;
        d[p + TANGENT] = tangent + byTangent;
        rows.give(k, p, v, byNormal, byTangent);
        if (isPinned) {
            pinned.answer(k, byNormal, byTangent);
        }
        return (Math.abs(byNormal) + Math.abs(byTangent)) / (now + normal + Double.MIN_NORMAL);
    }
}
