// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * What a body stood on until just now, when it was struck from aside: a heap that gives the body all of its weight for the rest
 * of the step, and nothing that bears it, would throw it against the ground.
 */
final class Standing implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of what forces give a body in a step that the speed is at which it is not on its way to or from the ground. */
    private static final double STANDING = 1e-5;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final ContactPoints points;
    private final IntList found = new IntList();
    private final double[] fall = new double[State.BLOCK];
    private final ContactPoint point = new ContactPoint();
    private transient Manifold manifold;

    Standing(
            State state, Trajectories trajectories, Motion motion, CollisionDetection detection, ContactPoints points) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        this.points = points;
    }

    /** The pairs of a body and the fixed ones on which it stands, but for those that last; valid until the next call. */
    IntList find(int body, LastingPairs lasting) {
        found.clear();
        motion.fall(body, fall, 0);
        double pull = Math.sqrt(fall[0] * fall[0] + fall[1] * fall[1]);
        if (pull == 0 || trajectories.isDriven(body)) {
            return found;
        }
        double tau = trajectories.offset(body);
        for (int k = 0; k < detection.pairs().countOf(body); k++) {
            int pair = detection.pairs().of(body, k);
            boolean isGround = state.body(detection.pairs().other(pair, body)).isFixed();
            if (isGround && !detection.marks().isUnseen(pair) && !lasting.has(pair) && standsOn(pair, body, tau, pull)) {
                found.add(pair);
            }
        }
        return found;
    }

    private boolean standsOn(int pair, int body, double tau, double pull) {
        if (detection.marks().isIgnored(pair) || !detection.narrowPhase().touches(pair, tau)) {
            return false;
        }
        manifold = manifold == null ? new Manifold() : manifold;
        detection.narrowPhase().contact(pair, tau, manifold);
        boolean yes = true;
        for (int k = 0; k < manifold.count; k++) {
            points.load(manifold, pair, k, point);
            double pressed = fall[0] * point.nx + fall[1] * point.ny;
            yes &= (detection.pairs().first(pair) == body ? pressed : -pressed) > 0
                    && Math.abs(point.opening) < STANDING * pull * trajectories.h();
        }
        return yes;
    }
}
