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

    /**
     * The coefficient of restitution of a contact of two bodies.
     *
     * @param a index
     * @param b index
     * @return 0 … 1
     */
    double restitution(int a, int b);

    /**
     * Whether contacts may be foreseen: nobody is to be asked or told of impacts.
     *
     * @return false if there are listeners
     */
    boolean areForeseen();
}
