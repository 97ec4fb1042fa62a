// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * Advances bodies that ties hold together: by the integrator, and then back onto what the ties ask for. A step whose
 * correction is more than its error should be is made again in halves, so that a step that is too long for a scene costs
 * time and not the scene.
 */
final class TiedMotion implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int MOST_PARTS = 1 << 14;

    /** Part of a step in which the correction at its end does not matter to the path. */
    private static final double SHORT = 1e-3;

    private final State state;
    private final Ties ties;
    private double[] startX = {};
    private double[] startV = {};

    TiedMotion(State state, Ties ties) {
        this.state = state;
        this.ties = ties;
    }

    /** Advances a group over a time of either sign; the path is the cubic between its ends. */
    void advance(Motion motion, IntList group, double t, double length, Path path) {
        if (length == 0) {
            return;
        }
        if (startX.length < state.x().length) {
            startX = Arrays.copyOf(startX, state.x().length);
            startV = Arrays.copyOf(startV, state.x().length);
        }
        copy(group, state.x(), startX);
        copy(group, state.v(), startV);
        int parts = 1;
        while (!advance(motion, group, t, length, parts, path)) {
            copy(group, startX, state.x());
            copy(group, startV, state.v());
            parts *= 2;
        }
        if (parts == 1 && Math.abs(length) < SHORT * motion.step()) {
            return; // the integrator's own path: the ends are too near for a difference
        }
        for (int k = 0; k < group.size; k++) {
            int b = State.BLOCK * group.values[k];
            for (int end = b + State.BLOCK; b < end; b++) {
                path.cubic(b, (state.x()[b] - startX[b]) / length, startV[b], state.v()[b], length);
            }
        }
    }

    private boolean advance(Motion motion, IntList group, double t, double length, int parts, Path path) {
        for (int k = 0; k < parts; k++) {
            double from = length * k / parts;
            double to = length * (k + 1) / parts;
            motion.getIntegrator().advance(motion, state, group, t + from, to - from, path);
            if (!ties.project(group)) {
                if (parts < MOST_PARTS) {
                    return false;
                }
                ties.assemble(group);
            }
        }
        return true;
    }

    private static void copy(IntList group, double[] from, double[] to) {
        for (int k = 0; k < group.size; k++) {
            int b = State.BLOCK * group.values[k];
            to[b] = from[b];
            to[b + 1] = from[b + 1];
            to[b + 2] = from[b + 2];
        }
    }
}
