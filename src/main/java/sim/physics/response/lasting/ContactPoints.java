// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.narrow.Manifold;

/** What knows the masses, velocities and coefficients of bodies at the points where they touch. */
public interface ContactPoints extends Serializable {
    /**
     * Loads a point of a pair that rests or lies on one another.
     *
     * @param manifold where the pair touches
     * @param pair number of the pair
     * @param k which of the manifold's points
     * @param point filled
     */
    void load(Manifold manifold, int pair, int k, ContactPoint point);
}
