// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import sim.physics.internal.Softness;

/** The pace at which depths of contacts and gaps of joints are regained: what longer substeps have left is not to be thrown out in a shorter one. */
final class Pace implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Oscillations in a substep, and damping ratios, with which depths of contacts and gaps of joints are regained. */
    private static final double CONTACT_FREQUENCY = 1.0 / 4;

    private static final double CONTACT_DAMPING = 5;
    private static final double JOINT_FREQUENCY = 1.0 / 4;
    private static final double JOINT_DAMPING = 2;

    /** Time in which the pace becomes shorter by one unit of it where substeps are shorter: depths are regained in a few paces. */
    private static final double PATIENCE = 16;

    /** The substep by which they are regained, the one before the step that has begun, and the one that the softness is of. */
    private double substep;

    private double last;
    private double softened;

    Softness contact = Softness.RIGID;
    Softness joint = Softness.RIGID;

    /** Sets it beforehand. */
    void set(double substep) {
        this.substep = substep;
    }

    /** Begins a step h of substeps d. */
    void begin(double h, double d) {
        last = substep;
        substep = Math.max(d, substep - h / PATIENCE);
        if (substep != softened) {
            softened = substep;
            contact = Softness.of(CONTACT_FREQUENCY, CONTACT_DAMPING, substep);
            joint = Softness.of(JOINT_FREQUENCY, JOINT_DAMPING, substep);
        }
    }

    /** The step that has begun is none. */
    void putBack() {
        substep = last;
    }
}
