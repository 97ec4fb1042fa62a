// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.Arrays;
import java.util.Locale;
import sim.physics.scenes.Gas;
import sim.physics.scenes.SceneData;
import sim.physics.scenes.SceneData.Kind;

/** The scenes by name, and how long one run of each is. */
enum BenchScene {
    /** {@link Gas#s3}. */
    S3 {
        @Override
        SceneData make(int n, long seed) {
            return Gas.s3(n, seed);
        }
    },
    /** {@link Gas#s3} with disks in place of the boxes, which have the same area. */
    CIRCLES {
        @Override
        SceneData make(int n, long seed) {
            SceneData s3 = Gas.s3(n, seed);
            Kind[] kinds = new Kind[n];
            double[] radii = new double[n];
            Arrays.fill(kinds, Kind.CIRCLE);
            Arrays.fill(radii, 0.5);
            return new SceneData(
                    "circles(" + n + ", " + seed + ")", kinds, radii, new double[n], s3.x(), s3.y(), s3.theta(), s3.vx(),
                    s3.vy(), s3.omega(), s3.mass(), s3.walls(), s3.inner(), s3.restitution(), s3.dt());
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

    private static final int LARGE = 50_000;

    abstract SceneData make(int n, long seed);

    static BenchScene of(String name) {
        return valueOf(name.toUpperCase(Locale.ROOT));
    }

    /** Steps of a fresh scene: some collisions per body, and nobody's energy is gone; fewer of very large scenes. */
    int steps(int n) {
        int usual = this == S3 || this == CIRCLES ? 600 : 1000;
        return n > LARGE ? usual / 20 : usual;
    }

    /** Fresh scenes, of different seeds, in one timed batch. */
    int copies(int n) {
        return Math.max(1, BODY_STEPS / (n * steps(n)));
    }
}
