// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.function.DoubleFunction;

/**
 * An engine and a method in one scene, with the settings that it is run at: time steps, or tolerances.
 *
 * @param engine its name
 * @param method its method, or the engine's name
 * @param isAdaptive whether the settings are tolerances
 * @param settings from coarse to fine
 * @param trial makes a run
 */
record Contender(
        String engine, String method, boolean isAdaptive, double[] settings, DoubleFunction<Trial> trial) {
    String label() {
        return engine.equals("mason-physics") ? method : engine.equals(method) ? engine : engine + " " + method;
    }

    boolean isOurs() {
        return engine.equals("mason-physics");
    }
}
