// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.Trajectories;

/** Whether driven bodies turn so little that they may lie on something. */
final class HeapCalm implements Serializable {
    private static final long serialVersionUID = 1L;

    static final int NONE = -1;

    /** Turn of driven bodies in a step, rad, up to which they may lie on something. */
    private static final double CALM = 0.5;

    /** The same of tied ones, whose bounces cost more than forces that are found again each time that they have turned a little. */
    private static final double CALM_TIED = 10;

    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final Heap heap;

    HeapCalm(Trajectories trajectories, Motion motion, CollisionDetection detection, Heap heap) {
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        this.heap = heap;
    }

    /** Whether those of some bodies that move together turn little in a step which lie on something, or are to: {@link #NONE} for none. */
    boolean isCalm(IntList group, int body) {
        double most = 0;
        boolean isTied = false;
        for (int k = 0; k < group.size; k++) {
            isTied |= motion.isTied(group.values[k]);
            boolean round = heap.scales.isRound(group.values[k]);
            double spin = trajectories.data()[group.values[k] * Trajectories.STRIDE + Trajectories.OMEGA];
            boolean counts = !round && (group.values[k] == body || liesItself(group.values[k]));
            most = Math.max(most, counts ? Math.abs(spin) : 0);
        }
        return most * trajectories.h() <= (isTied ? CALM_TIED : CALM);
    }

    /** Whether a body has a lasting pair, not only those that move with it. */
    private boolean liesItself(int body) {
        boolean yes = false;
        for (int k = 0; k < detection.pairs().countOf(body) && !yes; k++) {
            yes = heap.lasting.has(detection.pairs().of(body, k));
        }
        return yes;
    }
}
