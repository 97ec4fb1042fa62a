// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.robots;

import sim.physics.motion.Body;
import sim.physics.shape.Circle;

/** A can, and who is after it. */
public final class Can extends Body {
    private static final long serialVersionUID = 1L;

    /** Cans are home above this line. */
    public static final double HOME = 50;

    /** The robot that fetches or holds it, or null. */
    Collector taker;

    boolean isHeld;

    Can() {
        super(new Circle(2));
        setMass(80);
        setSurfaceFriction(0.5);
    }

    public boolean isHome() {
        return getY() <= HOME && !isHeld;
    }
}
