// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;

/**
 * A tie of {@link SwitchedTies}: a coordinate q of two bodies, which a motor brings to a speed with a bounded force, or that
 * stays between two stops. Its rate is n₂ · v₂ − n₁ · v₁ + l₂ ω₂ − l₁ ω₁, as the normal velocity of a contact is, but that the two
 * directions differ where a rope goes over pulleys. A turn is a way here, too, at an arm of the size of its bodies; so all rows have one
 * unit, and none counts for more in another unit of length.
 */
public final class SwitchedRow implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Indices of the bodies; −1 for what cannot move. */
    public int first;

    /** The same for the second one. */
    public int second;

    /** n₂; where the second body cannot move, n₁. */
    public double nx;

    /** n₂. */
    public double ny;

    /** n₁; where the first body cannot move, n₂. */
    public double firstX;

    /** n₁. */
    public double firstY;

    /** l₁. */
    public double firstLever;

    /** l₂. */
    public double secondLever;

    /** The force with which it pushes while frozen, else 0. */
    public double force;

    /** Whether it is a motor; else it is a pair of stops. */
    public boolean isMotor;

    /** The speed of a motor, and the greatest force either way. */
    public double speed;

    /** The greatest force either way. */
    public double limit;

    /** How far q is above its lower stop, which may be infinitely far. */
    public double aboveLower;

    /** How far q is below its upper stop. */
    public double belowUpper;

    /** Of the stops. */
    public double restitution;

    /** The size of the coordinate: of what it measures, or the arm of a turn. */
    public double size;

    /** Makes a row that has not been read. */
    public SwitchedRow() {
        // filled by read
    }
}
