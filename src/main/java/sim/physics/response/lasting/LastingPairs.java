// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.motion.Trajectories;

/** The pairs whose bodies lie on one another. */
final class LastingPairs implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Trajectories trajectories;
    private final CollisionDetection detection;
    private final BodyScale scales;
    private final ContactLedger ledger;

    LastingPairs(Trajectories trajectories, CollisionDetection detection, BodyScale scales, ContactLedger ledger) {
        this.trajectories = trajectories;
        this.detection = detection;
        this.scales = scales;
        this.ledger = ledger;
    }

    boolean has(int pair) {
        return detection.marks().isLasting(pair) && !detection.marks().isIgnored(pair);
    }

    /** Lets a pair last. */
    void begin(int pair) {
        if (!has(pair)) {
            double size = scales.size(detection.pairs().first(pair), detection.pairs().second(pair));
            boolean driven = trajectories.isDriven(detection.pairs().first(pair))
                    || trajectories.isDriven(detection.pairs().second(pair));
            detection.marks().setLasting(pair, true);
            detection.marks().setDepth(pair, HeapGaps.depth(driven, size));
            ledger.begin(pair);
        }
    }

    void end(int pair) {
        detection.marks().setLasting(pair, false);
        detection.marks().setDepth(pair, 0);
    }
}
