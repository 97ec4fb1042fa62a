// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import java.io.Serializable;

/**
 * The impulse at one point that rubs: Routh's law in one step. It stops the sliding if Coulomb's cone allows that. Otherwise it lies on the edge of
 * the cone that opposes the sliding after the impact (Moreau): an oblique impact makes points slide that did not, or turns their sliding round.
 */
public final class CoulombImpulse implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Share of a point's mobility, and of its velocity, that is none but for rounding. */
    private static final double ONE_WAY = 1e-12;

    /** The impulse along the normal. */
    public double normal;

    /** The impulse along the tangent. */
    public double tangent;

    /** Creates one of no impulse. */
    public CoulombImpulse() {
        // zeros
    }

    /**
     * Finds it. The bodies may be tied so that the point moves in one direction only.
     *
     * @param kn what a unit of the normal impulse changes of the normal velocity
     * @param kt what one of the tangential impulse changes of the tangential velocity
     * @param knt what each changes of the other's
     * @param wanted the change of the normal velocity that is wanted
     * @param slide the tangential velocity before
     * @param friction coefficient; infinite if the surfaces stick
     */
    public void solve(double kn, double kt, double knt, double wanted, double slide, double friction) {
        double det = kn * kt - knt * knt;
        boolean isSticky = friction == Double.POSITIVE_INFINITY;
        boolean mayStick = isSticky || det > ONE_WAY * kn * kt;
        normal = mayStick ? (kt * wanted + knt * slide) / det : 0;
        tangent = mayStick ? -(kn * slide + knt * wanted) / det : 0;
        if (!mayStick || !isSticky && Math.abs(tangent) > friction * normal) {
            double smooth = slide + knt * wanted / kn; // what slides after an impact without friction
            boolean slides = Math.abs(smooth) > ONE_WAY * (Math.abs(slide) + Math.abs(smooth - slide));
            double mu = slides ? -Math.signum(smooth) * friction : 0; // against what slides after the impact, not before it
            double resistance = kn + mu * knt;
            normal = wanted / (resistance > 0 ? resistance : kn);
            tangent = resistance > 0 ? mu * normal : 0;
        }
    }

    /**
     * Shortens it if it creates more energy than it may; what it creates is found from the mobilities with which it was solved.
     *
     * @param kn as above
     * @param kt as above
     * @param knt as above
     * @param opening the normal velocity before
     * @param slide the tangential velocity before
     * @param allowance the energy that it may create
     */
    public void limit(double kn, double kt, double knt, double opening, double slide, double allowance) {
        double linear = normal * opening + tangent * slide;
        double gain = linear + (0.5 * (kn * normal * normal + kt * tangent * tangent) + knt * normal * tangent);
        if (gain > allowance) {
            shorten(linear, gain, allowance);
        }
    }

    /**
     * Shortens one that creates too much energy, as Newton's restitution may with friction (Kane and Levinson 1985): a part s of it gives
     * s·linear + s²·square, and that is what is allowed.
     *
     * @param linear its product with the velocity before
     * @param gain the energy that it creates as it is
     * @param allowance the energy that it may create
     */
    public void shorten(double linear, double gain, double allowance) {
        double square = gain - linear;
        double root = allowance == 0 ? -linear : Math.sqrt(linear * linear + 4 * square * allowance);
        double s = square > 0 ? Math.max(0, Math.min(1, 0.5 * (root - linear) / square)) : 0; // all of it gains where they part already
        normal *= s;
        tangent *= s;
    }
}
