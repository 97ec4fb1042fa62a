// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.AX;
import static sim.physics.stepping.ContactRows.AY;
import static sim.physics.stepping.ContactRows.BEND;
import static sim.physics.stepping.ContactRows.BX;
import static sim.physics.stepping.ContactRows.BY;
import static sim.physics.stepping.ContactRows.COUPLING;
import static sim.physics.stepping.ContactRows.FRICTION;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NORMAL_MASS;
import static sim.physics.stepping.ContactRows.NOW;
import static sim.physics.stepping.ContactRows.PAIR;
import static sim.physics.stepping.ContactRows.REGAIN;
import static sim.physics.stepping.ContactRows.RESTORED;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT;
import static sim.physics.stepping.ContactRows.TANGENT_MASS;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.constraint.PinLevers;
import sim.physics.internal.CoulombImpulse;
import sim.physics.internal.Growth;
import sim.physics.internal.Softness;
import sim.physics.motion.State;

/**
 * Contacts beside pins: what presses on a door near its hinge is borne by the hinge, nearly all of it. In turns, each of the two takes back most of what the other has
 * done, however often. So an impulse of such a contact comes with the one of the pin that answers it, and what the pin itself is about to change is seen beforehand.
 */
final class PinnedPairs implements Serializable {
    private static final long serialVersionUID = 1L;

    /** The part of a point's mobility that is left by its pin, from which on turns do. */
    private static final double MUCH = 0.25;

    /** The part of what another pin leaves from which on a pin is the one that counts: which of two alike is, is not to depend on rounding. */
    private static final double ALIKE = 1 - 1e-6;

    /** The part that is left at least: less is rounding. */
    private static final double LEAST = 1e-9;

    /** How many times larger than without friction an impulse may be that rubs: beyond that it locks what it presses on. */
    private static final double LOCKED = 4;

    private final State state;
    private final ContactRows rows;
    private final PinLevers levers;

    /** By pair: its pin, −1 for none. */
    private int[] pins = {};

    private boolean any;

    /** Of the point that was weighed last, along its normal and its tangent: what they give the pin, and what that gives in turn. */
    private final double[] speeds = new double[4];

    private final double[] held = new double[4];

    /** Its mobilities with its pin; see {@link CoulombImpulse}. */
    double kn;

    double kt;
    double knt;

    /** What its speeds along the two will lose by its pin. */
    double lostNormal;

    double lostTangent;

    PinnedPairs(State state, ContactRows rows, PinLevers levers) {
        this.state = state;
        this.rows = rows;
        this.levers = levers;
    }

    /** Begins a step: all rows are there, and pins are where their bodies are. */
    void find(boolean isTied) {
        boolean had = any; // whose pins are to give way again
        any = false;
        if (!isTied || rows.count == 0 && !had || !levers.find()) {
            return;
        }
        pins = pins.length < rows.count ? new int[Growth.length(pins.length, rows.count)] : pins;
        for (int k = 0; k < rows.count; k++) {
            pins[k] = find(k);
            any |= pins[k] >= 0;
            if (pins[k] >= 0) {
                levers.stiffen(pins[k]);
            }
        }
    }

    /** The pin of the two bodies that leaves least of a point's mobility. */
    private int find(int k) {
        int best = -1;
        double least = MUCH;
        for (int which = 0; which < 2; which++) {
            for (int end = levers.first(which == 0 ? rows.first(k) : rows.second(k)); end >= 0; end = levers.next(end)) {
                for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
                    weigh(k, p, end / 2);
                    double left = kn * rows.points[p + NORMAL_MASS];
                    best = left < ALIKE * least ? end / 2 : best;
                    least = Math.min(least, left);
                }
            }
        }
        return best;
    }

    /** Whether a pair is solved with a pin. */
    boolean has(int k) {
        return any && pins[k] >= 0;
    }

    /** A body that is pushed when a pair is, though it is not of it; −1 for none. */
    int third(int k) {
        int a = levers.body(2 * pins[k]);
        int b = levers.body(2 * pins[k] + 1);
        return !isOf(a, k) ? a : !isOf(b, k) ? b : -1;
    }

    private boolean isOf(int body, int k) {
        return body == rows.first(k) || body == rows.second(k);
    }

    /** Finds the mobilities of a point with its pin. */
    void weigh(int k, int p) {
        weigh(k, p, pins[k]);
        lostNormal = levers.lost(pins[k], speeds, held, 0);
        lostTangent = levers.lost(pins[k], speeds, held, 2);
    }

    private void weigh(int k, int p, int pin) {
        double[] d = rows.points;
        double nx = rows.normals[PAIR * k], ny = rows.normals[PAIR * k + 1];
        double alongNormal = 1 / d[p + NORMAL_MASS];
        double alongTangent = 1 / d[p + TANGENT_MASS];
        Arrays.fill(speeds, 0);
        for (int end = 2 * pin; end < 2 * pin + 2; end++) {
            push(k, p, end, nx, ny, 0);
            push(k, p, end, -ny, nx, 2);
        }
        double mass = levers.mass(pin);
        kn = Math.max(LEAST * alongNormal, alongNormal - mass * levers.hold(pin, speeds[0], speeds[1], held, 0));
        kt = Math.max(LEAST * alongTangent, alongTangent - mass * levers.hold(pin, speeds[2], speeds[3], held, 2));
        for (int i = 0; i < held.length; i++) {
            held[i] *= mass;
        }
        knt = d[p + COUPLING] - (held[0] * speeds[2] + held[1] * speeds[3]);
    }

    /** Adds what an impulse at a point does to a pin by way of one of the pin's bodies. */
    private void push(int k, int p, int end, double x, double y, int at) {
        double[] d = rows.points;
        int body = levers.body(end);
        if (body == rows.first(k)) {
            levers.push(end, -x, -y, d[p + AY] * x - d[p + AX] * y, speeds, at);
        } else if (body == rows.second(k)) {
            levers.push(end, x, y, d[p + BX] * y - d[p + BY] * x, speeds, at);
        }
    }

    /** Lets the pin answer to impulses at the point that was weighed last. */
    void answer(int k, double normal, double tangent) {
        levers.give(pins[k], -held[0] * normal - held[2] * tangent, -held[1] * normal - held[3] * tangent);
    }

    /**
     * Bounds the impulse of a point that was weighed last. Friction may lock a body that can only turn against what presses on it: the impulse that stops
     * the two is as large as you like then. In place of it comes the one without friction, and what that rubs.
     */
    void unlock(CoulombImpulse law, double wanted, double slide, double friction) {
        if (law.normal * kn > LOCKED * wanted) {
            double most = friction * (wanted / kn);
            law.normal = wanted / kn;
            law.tangent = Math.max(-most, Math.min(most, -(slide + knt * law.normal) / kt));
        }
    }

    /** Solves the points of a pair once, as {@link ContactSolver} does those that no pin is beside. */
    void solve(int k, Softness softness, boolean regains, double h) {
        for (int p = rows.begin(k); regains && p < rows.end(k); p += STRIDE) {
            rub(k, p, 0.5 * h);
        }
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            press(k, p, softness, regains, h);
        }
        for (int p = rows.begin(k); !regains && p < rows.end(k); p += STRIDE) {
            rub(k, p, 0);
        }
    }

    private void rub(int k, int p, double ahead) {
        double[] d = rows.points;
        double most = rows.normals[PAIR * k + FRICTION] * d[p + NORMAL];
        double old = d[p + TANGENT];
        if (most != 0 || old != 0) {
            double spin = state.v()[State.BLOCK * rows.first(k) + 2];
            double turn = state.v()[State.BLOCK * rows.second(k) + 2];
            double nx = rows.normals[PAIR * k], ny = rows.normals[PAIR * k + 1];
            double round = spin * spin * (nx * d[p + AY] - ny * d[p + AX]) - turn * turn * (nx * d[p + BY] - ny * d[p + BX]);
            weigh(k, p);
            d[p + TANGENT] = Math.max(-most, Math.min(most, old - (rows.slip(k, p, state.v()) - lostTangent + ahead * round) / kt));
            rows.give(k, p, state.v(), 0, d[p + TANGENT] - old);
            answer(k, 0, d[p + TANGENT] - old);
        }
    }

    private void press(int k, int p, Softness softness, boolean regains, double h) {
        double[] d = rows.points;
        double gap = d[p + NOW];
        double bend = regains ? 0.5 * h * d[p + BEND] : 0;
        double regain = -rows.normals[PAIR * k + REGAIN];
        boolean isDeep = gap < ContactSolver.ROUNDING * h * regain && gap + h * bend < 0 && regains;
        double old = d[p + NORMAL];
        weigh(k, p);
        double mass = (isDeep ? softness.mass() : 1) / kn;
        double kept = isDeep ? softness.impulse() * old : 0;
        double aim = bend + (isDeep ? Math.max(softness.rate() * gap, regain - kept / mass) : regains || gap >= 0 ? gap / h : 0);
        double now = Math.max(0, old - mass * (rows.opening(k, p, state.v()) - lostNormal + aim) - kept);
        if (now != 0 || old != 0) {
            d[p + NORMAL] = now;
            d[p + RESTORED] = now == 0 && !regains && rows.mayBounce(k) ? Flights.TAKEN_BACK : d[p + RESTORED];
            rows.give(k, p, state.v(), now - old, 0);
            answer(k, now - old, 0);
        }
    }

    /** Gives the bodies of a point impulses along the normal and the tangent, whether a pin answers or not. */
    void give(int k, int p, double normal, double tangent) {
        rows.give(k, p, state.v(), normal, tangent);
        if (has(k)) {
            weigh(k, p);
            answer(k, normal, tangent);
        }
    }

    /** The impulse against the tangent that stops the sliding of a point, whether a pin answers or not. */
    double stopping(int k, int p) {
        double slip = rows.slip(k, p, state.v());
        if (has(k)) {
            weigh(k, p);
            return (slip - lostTangent) / kt;
        }
        return rows.points[p + TANGENT_MASS] * slip;
    }
}
