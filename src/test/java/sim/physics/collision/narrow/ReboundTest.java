// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import sim.physics.motion.Trajectories;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** For as long as bodies that touch are said to stay apart they do, by their distance at many instants. */
class ReboundTest extends MovingPair {
    private static final int INSTANTS = 400;
    private static final double LONG = 20;

    ReboundTest() {
        super(5);
    }

    /** Moves a body on to an instant, as an impact does. */
    private void bring(int body, double tau) {
        double[] m = trajectories.data();
        int o = body * Trajectories.STRIDE;
        for (int c = 0; c < 3; c++) {
            m[o + c] += tau * m[o + Trajectories.VX + c];
        }
        m[o + Trajectories.OFFSET] = tau;
    }

    @Test
    void bodiesDoNotTouchForAsLongAsItSays() {
        trajectories.begin(0, 1);
        trajectories.ensure(2);
        int contacts = 0;
        int known = 0;
        int forGood = 0;
        for (int k = 0; k < 12_000; k++) {
            place(0, shape(k % 3), 0, 0, 3);
            place(1, shape(1 + k % 2), between(-4, 4), between(-4, 4), 3);
            if (gap(0) <= 0) {
                continue;
            }
            double tau = line.search(0, shapes.base(0), 1, shapes.base(1), 0, 1, ClosestFeatures.NO_FEATURES);
            if (!line.touching) {
                continue;
            }
            contacts++;
            bring(0, tau);
            bring(1, tau);
            double spin = k % 5 == 0 ? 30 : k % 7 == 0 ? 0 : 2;
            push(0, spin);
            push(1, spin);
            gap(tau);
            double time = Rebound.time(pose, features, trajectories.data(), 0, Trajectories.STRIDE);
            known += time > 0 ? 1 : 0;
            forGood += time == Double.POSITIVE_INFINITY ? 1 : 0;
            double until = Math.min(time, LONG);
            for (int i = 1; i <= INSTANTS && time > 0; i++) {
                double part = (double) i / INSTANTS; // more of the instants lie at the beginning
                assertThat(gap(tau + until * part * part)).as("pair %d at %d of %s", k, i, time).isGreaterThan(-1e-12);
            }
        }
        assertThat(contacts).isGreaterThan(1500);
        assertThat(known).isGreaterThan(contacts / 3);
        assertThat(forGood).isGreaterThan(contacts / 20);
    }

    @Test
    void aDiscLeavesAWallForGood() {
        trajectories.begin(0, 1);
        trajectories.ensure(2);
        place(0, new Rectangle(20, 2), 0, -1, 3);
        trajectories.data()[Trajectories.THETA0] = 0;
        place(1, new Circle(1), 3, 1, 3);
        double[] m = trajectories.data();
        m[Trajectories.VX] = 0;
        m[Trajectories.VY] = 0;
        m[Trajectories.OMEGA] = 0;
        m[Trajectories.STRIDE + Trajectories.VY] = 0.5;
        gap(0);
        assertThat(Rebound.time(pose, features, m, 0, Trajectories.STRIDE)).isEqualTo(Double.POSITIVE_INFINITY);
        m[Trajectories.STRIDE + Trajectories.VY] = -0.5;
        assertThat(Rebound.time(pose, features, m, 0, Trajectories.STRIDE)).isZero();
    }
}
