// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

/**
 * The closed form of (16)–(24) for two bodies and one point, with friction, and also for surfaces that stick.
 *
 * <p>With (18), (19) and (24) in (23), the normal impulse is
 *
 * <pre>
 *   j = −(1 + e) v·n / K,   K = 1/mA + 1/mB + (rA⊥·n)²/IA + (rB⊥·n)²/IB,   R = −j n
 * </pre>
 *
 * <p>With friction, the impulse is that of Routh's law in one step. It stops the sliding if Coulomb's cone allows that. Otherwise
 * it lies on the edge of the cone that opposes the sliding after the impact (Moreau): an oblique impact makes points slide that
 * did not, or turns their sliding round. Newton's restitution with friction can create energy (Kane and Levinson 1985). Where it
 * would, the impulse is shortened until the energy stays the same.
 */
public final class TwoBodyImpulse implements ImpulseSolver {
    private static final long serialVersionUID = 1L;

    /** Creates a solver. */
    public TwoBodyImpulse() {
        // no state
    }

    @Override
    public void solve(Impact c) {
        if (!c.sticky && c.friction == 0) {
            c.jn = -(1 + c.restitution) * c.normalVelocity() / c.normalMobility(); // (17), (20), (23)
            c.jt = 0;
            return;
        }
        withFriction(c);
    }

    /** In the frame of the normal n and the tangent t = n⊥. */
    private static void withFriction(Impact c) {
        double kn = c.normalMobility();
        double kt = c.tangentMobility();
        double knt = c.iA * c.leverA * c.armA + c.iB * c.leverB * c.armB;
        rub(c, kn, kt, knt);
        double gain = c.energyGain();
        if (!c.sticky && gain > c.allowance) {
            c.law.shorten(c.jn * c.normalVelocity() + c.jt * c.tangentVelocity(), gain, c.allowance);
            take(c);
        }
    }

    /**
     * Finds the impulse of a point that rubs or sticks, by what a unit of the normal impulse changes of the normal velocity, one of the
     * tangential impulse of the tangential velocity, and each of the other's. Ties may let the point move in one direction only.
     */
    private static void rub(Impact c, double kn, double kt, double knt) {
        c.law.solve(kn, kt, knt, -(1 + c.restitution) * c.normalVelocity(), c.tangentVelocity(), c.sticky ? Double.POSITIVE_INFINITY : c.friction);
        take(c);
    }

    private static void take(Impact c) {
        c.jn = c.law.normal;
        c.jt = c.law.tangent;
    }

    /** The same for bodies that are tied, to whose energy no more is added than allowed. */
    static void rubTied(Impact c, double kn, double kt, double knt) {
        rub(c, kn, kt, knt);
        c.law.limit(kn, kt, knt, c.normalVelocity(), c.tangentVelocity(), c.allowance);
        take(c);
    }
}
