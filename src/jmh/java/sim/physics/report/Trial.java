// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

/** One run of a scene in one engine, not begun yet. */
interface Trial {
    /** Runs the scene to its end. */
    void run();

    /** The error of what the scene asks for, against its reference. */
    double error();

    /** The change of energy over the run, relative to what the scene says; NaN if nobody looked. */
    default double energy() {
        return Double.NaN;
    }

    /** The largest opening of a joint at the end; NaN if there is none. */
    default double gap() {
        return Double.NaN;
    }
}
