// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import sim.physics.scenes.SceneData;

/**
 * Metres and seconds of a scene's units, for engines whose constants are made for metres and seconds.
 *
 * <p>A scene with dt = 1 (Figure 1 and its kin: bodies of 10 units, speeds of 1 unit per step) becomes lengths × 0.5 and
 * 1/60 s per step: bodies of 5 m with speeds of 30 m/s, far above the restitution threshold of 1 m/s of dyn4j and JBox2D
 * (with one metre and one second per unit they would stop everything), and, with 0.5 m per step, below JBox2D's limit of
 * 2 m per step but for a rare fast rectangle. Other scenes are in metres and seconds already.
 *
 * @param metres length of one unit
 * @param seconds duration of one unit of time
 */
record Units(double metres, double seconds) {
    static Units of(SceneData scene) {
        return scene.dt() == 1 ? new Units(0.5, 1.0 / 60) : new Units(1, 1);
    }

    /** {@return metres per second of one unit of velocity} */
    double speed() {
        return metres / seconds;
    }
}
