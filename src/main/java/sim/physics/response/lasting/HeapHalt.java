// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.Trajectories;

/** Takes all motion relative to one another from the bodies of a {@link HeapSystem}. */
final class HeapHalt {
    private HeapHalt() {}

    /**
     * Lets the bodies stand if some lie on what cannot move, and else go on as one body, with the momenta that they have together. On the
     * straight ways on which they go then they part, by a second order of the time, as none of their normals turns against the line of centres.
     */
    static void halt(HeapSystem s, IntList heap, Trajectories trajectories) {
        for (int p = 0; p < s.size(); p++) {
            if (s.rows().isOnFixed(p)) {
                Arrays.fill(s.v, 0, 3 * s.bodyCount(), 0);
                return;
            }
        }
        double[] d = trajectories.data();
        double mass = 0;
        double x = 0;
        double y = 0;
        double vx = 0;
        double vy = 0;
        for (int k = 0; k < s.bodyCount(); k++) {
            double m = 1 / s.w[2 * k];
            int o = heap.values[k] * Trajectories.STRIDE;
            mass += m;
            x += m * d[o + Trajectories.X0];
            y += m * d[o + Trajectories.Y0];
            vx += m * s.v[3 * k];
            vy += m * s.v[3 * k + 1];
        }
        x /= mass;
        y /= mass;
        vx /= mass;
        vy /= mass;
        double inertia = 0;
        double spin = 0;
        for (int k = 0; k < s.bodyCount(); k++) {
            int o = heap.values[k] * Trajectories.STRIDE;
            double dx = d[o + Trajectories.X0] - x;
            double dy = d[o + Trajectories.Y0] - y;
            inertia += (dx * dx + dy * dy) / s.w[2 * k] + 1 / s.w[2 * k + 1];
            spin += (dx * (s.v[3 * k + 1] - vy) - dy * (s.v[3 * k] - vx)) / s.w[2 * k] + s.v[3 * k + 2] / s.w[2 * k + 1];
        }
        spin /= inertia;
        for (int k = 0; k < s.bodyCount(); k++) {
            int o = heap.values[k] * Trajectories.STRIDE;
            s.v[3 * k] = vx - spin * (d[o + Trajectories.Y0] - y);
            s.v[3 * k + 1] = vy + spin * (d[o + Trajectories.X0] - x);
            s.v[3 * k + 2] = spin;
        }
    }
}
