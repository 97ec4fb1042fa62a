// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

/** How much of a change of velocities leaves them no more energy than they may have. */
final class LimitedChange {
    private LimitedChange() {}

    /**
     * The largest s from 0 to 1 with |u + s (v − u)|² at most a bound; the one with the least, if there is none.
     *
     * @param uu product of u with itself
     * @param uv of u with v
     * @param vv of v with itself
     */
    static double part(double uu, double uv, double vv, double most) {
        double along = uu - uv; // −u (v − u)
        double square = vv - 2 * uv + uu;
        double root = along * along - square * (uu - most);
        double s = square > 0 ? (along + Math.sqrt(Math.max(0, root))) / square : 0;
        return Math.max(0, Math.min(1, s));
    }
}
