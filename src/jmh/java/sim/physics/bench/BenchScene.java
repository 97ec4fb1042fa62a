// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.Locale;
import sim.physics.scenes.Gas;
import sim.physics.scenes.SceneData;

/** The scenes by name, and how long one run of each is. */
enum BenchScene {
    /** {@link Gas#s3}. */
    S3 {
        @Override
        SceneData make(int n, long seed) {
            return Gas.s3(n, seed);
        }
    },
    /** {@link Gas#figure1} at the density of the figure. */
    FIGURE1 {
        @Override
        SceneData make(int n, long seed) {
            return Gas.figure1(n, Gas.FIGURE_1_FRACTION, seed);
        }
    },
    /** {@link Gas#polygons}. */
    POLYGONS {
        @Override
        SceneData make(int n, long seed) {
            return Gas.polygons(n, seed);
        }
    };

    /** A run is at least so many body-steps, so that it is long against the clock and the rebuild. */
    private static final int BODY_STEPS = 200_000;

    abstract SceneData make(int n, long seed);

    static BenchScene of(String name) {
        return valueOf(name.toUpperCase(Locale.ROOT));
    }

    /** Steps of a fresh scene: some collisions per body, and nobody's energy is gone. */
    int steps() {
        return this == S3 ? 600 : 1000;
    }

    /** Fresh scenes, of different seeds, in one timed batch. */
    int copies(int n) {
        return Math.max(1, BODY_STEPS / (n * steps()));
    }
}
