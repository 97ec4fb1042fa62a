// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

/**
 * What goes from a point of one body to a point of another one, or of the world: a pin, a rod, a spring. Displays draw it; forces
 * and constraints of your own are drawn too if they implement it. The two points of a pin are at the same place.
 */
public interface Link {
    /**
     * The first body.
     *
     * @return never null
     */
    Body getBodyA();

    /**
     * The second body.
     *
     * @return null: the world
     */
    Body getBodyB();

    /**
     * The point of the first body, in its coordinates.
     *
     * @return x, length
     */
    double getAnchorAX();

    /**
     * The point of the first body, in its coordinates.
     *
     * @return y, length
     */
    double getAnchorAY();

    /**
     * The point of the second body, in its coordinates; in those of the world if that is null.
     *
     * @return x, length
     */
    double getAnchorBX();

    /**
     * The point of the second body, in its coordinates; in those of the world if that is null.
     *
     * @return y, length
     */
    double getAnchorBY();
}
