// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.narrow.Manifold;
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
            detection.marks().setLasting(pair, true);
            detection.marks().setDepth(pair, depth(pair));
            ledger.begin(pair, detection.marks().isHeld(pair));
        }
    }

    /** Looks where a pair touches, and keeps the features that were closest when an impact was looked for. */
    static void look(CollisionDetection detection, int pair, double tau, Manifold manifold) {
        int code = detection.pairs().code(pair);
        detection.narrowPhase().contact(pair, tau, manifold);
        detection.pairs().setCode(pair, code);
    }

    /** Whether a pair that lasts has not pressed in the last solution, and is open by that much, relative to the smaller body. */
    boolean hasParted(int pair, double tau, double part) {
        if (ledger.presses(pair)) {
            return false;
        }
        int code = detection.pairs().code(pair);
        double gap = detection.narrowPhase().gap(pair, tau);
        detection.pairs().setCode(pair, code);
        return gap > part * scales.size(detection.pairs().first(pair), detection.pairs().second(pair));
    }

    /** How deep a pair may be when it begins to last. */
    double depth(int pair) {
        int a = detection.pairs().first(pair);
        int b = detection.pairs().second(pair);
        return HeapGaps.depth(trajectories.isDriven(a) || trajectories.isDriven(b), scales.size(a, b));
    }

    /** A pair bears nothing from an instant on, until forces are found anew. */
    void relax(int pair, double tau) {
        ledger.relax(pair, tau);
    }

    /** What a body that leaves has borne in the step is told no more. */
    void drop(int body) {
        ledger.drop(body);
    }

    void end(int pair) {
        ledger.leave(pair, !detection.marks().isLasting(pair) || detection.marks().isHeld(pair));
        detection.marks().setLasting(pair, false);
        detection.marks().setDepth(pair, 0);
    }
}
