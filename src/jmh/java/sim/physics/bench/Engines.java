// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.List;
import sim.physics.scenes.SceneData;

/** The engines by name. */
final class Engines {
    /** All names: own-euler differs from own in the integrator, the others in continuous detection and thresholds. */
    static final List<String> NAMES = List.of(
            "own", "own-euler", "own-stepped", "dyn4j", "dyn4j-noccd", "dyn4j-noccd-rv0", "jbox2d", "jbox2d-noccd");

    private Engines() {}

    /**
     * Builds a scene in an engine.
     *
     * @param engine one of {@link #NAMES}
     * @param scene what to build
     * @return the engine, before its first step
     */
    static Runner create(String engine, SceneData scene) {
        return switch (engine) {
            case "own" -> new OwnRunner(scene, false, 0);
            case "own-euler" -> new OwnRunner(scene, true, 0);
            case "own-stepped" -> new OwnRunner(scene, false, 4);
            case "dyn4j" -> new Dyn4jRunner(scene, Dyn4jRunner.Setup.DEFAULT);
            case "dyn4j-noccd" -> new Dyn4jRunner(scene, Dyn4jRunner.Setup.NO_CCD);
            case "dyn4j-noccd-rv0" -> new Dyn4jRunner(scene, Dyn4jRunner.Setup.NO_CCD_NO_THRESHOLD);
            case "jbox2d" -> new JBox2DRunner(scene, true);
            case "jbox2d-noccd" -> new JBox2DRunner(scene, false);
            default -> throw new IllegalArgumentException("engine is " + engine + ": it must be one of " + NAMES);
        };
    }
}
