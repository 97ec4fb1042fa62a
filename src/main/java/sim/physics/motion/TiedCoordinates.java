// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

/** Coordinates in which bodies that are tied together move as if nothing tied them, such as the angles of a chain of pins. */
public interface TiedCoordinates extends Coordinates {
    /**
     * Begins where the state vectors have the bodies.
     *
     * @param loads what acts on them, each by itself; null: nothing but a uniform field
     * @param gx acceleration of that field
     * @param gy acceleration of that field
     * @param a workspace for the loads, [x″, y″, θ″] per body of the state; not asked for again
     * @return false if the bodies are not where their ties want them
     */
    boolean begin(Loads loads, double gx, double gy, double[] a);

    /** Ends a step whose end was {@link #put}: what nothing can have changed is as it was at the beginning. */
    void end();
}
