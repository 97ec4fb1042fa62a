// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

/**
 * Something that goes from a point of one body to a point of another one, or of the world: a pin, a rod, a spring. Displays draw
 * it. Forces and constraints of your own are drawn too if they implement this interface. The two points of a pin are in the same
 * place.
 */
public interface Link {
    /**
     * Returns the first body.
     *
     * @return never null
     */
    Body getBodyA();

    /**
     * Returns the second body.
     *
     * @return the body; null for the world
     */
    Body getBodyB();

    /**
     * Returns the x coordinate of the point of the first body, in that body's coordinates.
     *
     * @return x, length
     */
    double getAnchorAX();

    /**
     * Returns the y coordinate of the point of the first body, in that body's coordinates.
     *
     * @return y, length
     */
    double getAnchorAY();

    /**
     * Returns the x coordinate of the point of the second body, in that body's coordinates, or in those of the world if the body
     * is null.
     *
     * @return x, length
     */
    double getAnchorBX();

    /**
     * Returns the y coordinate of the point of the second body, in that body's coordinates, or in those of the world if the body
     * is null.
     *
     * @return y, length
     */
    double getAnchorBY();
}
