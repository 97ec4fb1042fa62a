// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import sim.physics.motion.AdaptiveIntegrator;
import sim.physics.motion.Automatic;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.RadauIIA;

/** Methods with a tolerance by their names. */
final class Methods {
    private Methods() {}

    static AdaptiveIntegrator method(String name, double tolerance) {
        return switch (name) {
            case "DOP853" -> new DormandPrince853(tolerance);
            case "GBS" -> new GraggBulirschStoer(tolerance);
            case "Radau" -> new RadauIIA(tolerance);
            default -> new Automatic(tolerance);
        };
    }
}
