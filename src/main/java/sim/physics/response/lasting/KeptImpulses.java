// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;

/** Impulses of a system, to compare later ones with. */
final class KeptImpulses implements Serializable {
    private static final long serialVersionUID = 1L;

    /**
     * Change of velocities, relative to those that are to be expected: what is pressed between the ground and what is held where it is
     * can bear any impulses, and the rounding of large ones throws it about.
     */
    private static final double TORN = 1e6;

    private final HeapSystem system;
    private double[] kept = {};

    KeptImpulses(HeapSystem system) {
        this.system = system;
    }

    /** Keeps the impulses. */
    void keep() {
        kept = kept.length < 2 * system.size() ? new double[4 * system.size()] : kept;
        for (int p = 0; p < system.size(); p++) {
            kept[2 * p] = system.normalImpulse(p);
            kept[2 * p + 1] = system.tangentImpulse(p);
        }
    }

    /** Takes the kept ones again. */
    void goBack() {
        for (int p = 0; p < system.size(); p++) {
            system.start(p, kept[2 * p], kept[2 * p + 1]);
        }
    }

    /** Takes from velocities what the kept impulses do. */
    void takeAway(double[] v) {
        for (int p = 0; p < system.size(); p++) {
            system.push(p, -kept[2 * p], -kept[2 * p + 1], v);
        }
    }

    /** How much the impulses have changed since then, as a velocity that they give. */
    double change() {
        double most = 0;
        for (int p = 0; p < system.size(); p++) {
            most = Math.max(most, change(system.normalImpulse(p) - kept[2 * p], system.normalMobility(p)));
            most = Math.max(most, change(system.tangentImpulse(p) - kept[2 * p + 1], system.tangentMobility(p)));
        }
        return most;
    }

    /** What a change of an impulse does; where mobility is infinite there is none. */
    private static double change(double impulse, double mobility) {
        return impulse == 0 ? 0 : Math.abs(impulse) * mobility;
    }

    /** Whether the impulses have changed by more than is of use even if they are right. */
    boolean tear(double expected) {
        return !(change() <= TORN * expected);
    }
}
