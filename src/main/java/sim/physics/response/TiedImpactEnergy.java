// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import sim.physics.motion.State;

/**
 * No impact of tied bodies makes energy, whatever rounding does to its impulses. Where ties hardly let a point move, what
 * is left of its mobility is the difference of much greater numbers: impulses are as great as that is small, and so is
 * what is wrong in them. The energy that impulses j change is a parabola in a factor s of all of them,
 *
 * <pre>
 *   ΔE(s) = s j·(J v) + s² Δv·M Δv / 2
 * </pre>
 *
 * <p>with the speeds of the points before the impact, and with how much the velocities of the bodies change in fact. The
 * impulses are shortened to where it is no more than it may be. Bounces that are kept from getting too short may add some,
 * but not where ties hardly let a point move: there a bounce of next to no height would take more than all that there is.
 */
final class TiedImpactEnergy implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Energy that is rounding, relative to what is exchanged. */
    private static final double ROUNDING = 1e-9;

    /** Part of the mobility of a point without ties, of which these leave less where they hold it but for next to nothing. */
    static final double HELD = 1e-3;

    private final State state;
    private double[][] kept = new double[8][3];
    private int bodies;

    /** Energy that the impulses take to first order, and that they may add. */
    private double taken;

    private double allowance;

    TiedImpactEnergy(State state) {
        this.state = state;
    }

    /** Keeps the velocities before an impact. */
    void begin(double[][] velocity, int count) {
        bodies = count;
        taken = 0;
        allowance = 0;
        if (kept.length < count) {
            kept = new double[2 * count][3];
        }
        for (int k = 0; k < count; k++) {
            System.arraycopy(velocity[k], 0, kept[k], 0, 3);
        }
    }

    /**
     * Takes note of the impulses at a point.
     *
     * @param a place of a body, −1 if it is fixed
     * @param b place of the other one
     * @param approach speed that was to be stopped
     * @param mobility what the ties leave of that of the point
     */
    void add(Impact c, int a, int b, double approach, double mobility) {
        c.setVelocities(a < 0 ? null : kept[a], b < 0 ? null : kept[b]);
        taken -= c.jn * c.normalVelocity() + c.jt * c.tangentVelocity();
        double e = c.restitution;
        if (e > 1 && approach > 0 && mobility > HELD * c.normalMobility()) {
            allowance += 0.5 * (e - 1) * approach * Math.max(c.jn, (e + 1) * approach / mobility);
        }
    }

    /** Shortens all impulses and changes of velocities so that they make no more energy than they may. */
    void limit(int[] body, double[][] velocity, Impact[] impacts, int points) {
        double exchanged = exchanged(body, velocity);
        boolean isFinite = exchanged < Double.POSITIVE_INFINITY; // not if impulses are no numbers
        if (isFinite && 0.5 * exchanged - taken <= allowance + ROUNDING * exchanged) {
            return;
        }
        double root = Math.sqrt(taken * taken + 2 * exchanged * allowance);
        double scale = isFinite ? Math.max(0, (taken + root) / exchanged) : 0;
        boolean isAny = scale > 0;
        for (int k = 0; k < bodies; k++) {
            for (int c = 0; c < 3; c++) {
                velocity[k][c] = isAny ? kept[k][c] + scale * (velocity[k][c] - kept[k][c]) : kept[k][c];
            }
        }
        for (int k = 0; k < points; k++) {
            impacts[k].jn = isAny ? scale * impacts[k].jn : 0;
            impacts[k].jt = isAny ? scale * impacts[k].jt : 0;
        }
    }

    /** Twice the energy of the changes of velocities, Δv·M Δv. */
    private double exchanged(int[] body, double[][] velocity) {
        double[] w = state.w().values();
        double sum = 0;
        for (int k = 0; k < bodies; k++) {
            int s = State.BLOCK * body[k];
            for (int c = 0; c < 3; c++) {
                double change = velocity[k][c] - kept[k][c];
                sum += w[s + c] > 0 ? change * change / w[s + c] : 0;
            }
        }
        return sum;
    }
}
