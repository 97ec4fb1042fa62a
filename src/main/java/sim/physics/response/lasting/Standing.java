// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.internal.Tolerances;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * What a body of a heap stands on, and what stands on it, all the same whether these have met in this step. A heap that gives a body all
 * of its weight for the rest of the step, and nothing that bears it, would throw it against the ground; and of several supports those
 * that were met first would bear it alone.
 */
final class Standing implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of what forces give a body in a step that the speed is at which it is not on its way to or from the ground. */
    private static final double STANDING = 1e-5;

    /** Gap at which bodies stand on one another, in parts of the depth that is allowed: what lies in a heap is off its ground by as much. */
    private static final double NEAR = 4;

    private static final int[] NONE = {};

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final ContactPoints points;
    private final BodyScale scales;
    private final IntList found = new IntList();
    private final double[] fall = new double[State.BLOCK];
    private final ContactPoint point = new ContactPoint();
    private transient Manifold manifold;

    Standing(
            State state, Trajectories trajectories, Motion motion, CollisionDetection detection, ContactPoints points, BodyScale scales) {
        this.scales = scales;
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        this.points = points;
    }

    /** The pairs of a body and those on which it stands or that stand on it, but for those that last. */
    int[] find(int body, LastingPairs lasting) {
        found.clear();
        double pull = pull(body);
        if (pull == 0) {
            return NONE;
        }
        double tau = trajectories.since(body);
        for (int k = 0; k < detection.pairs().countOf(body); k++) {
            int pair = detection.pairs().of(body, k);
            if (!detection.marks().isUnseen(pair) && !lasting.has(pair) && standsOn(pair, body, tau, pull)) {
                found.add(pair);
            }
        }
        return found.size == 0 ? NONE : Arrays.copyOf(found.values, found.size);
    }

    /**
     * Lets elastic bodies bounce again that lie on one that has been struck, if it meets them at a speed at which they would not lie down: in a
     * heap they would stop one another. Bobs of a cradle that swing side by side lie on one another, as they have met too often.
     */
    void loosen(int body, LastingPairs lasting) {
        for (int k = 0; k < detection.pairs().countOf(body); k++) {
            int pair = detection.pairs().of(body, k);
            int a = detection.pairs().first(pair);
            int b = detection.pairs().second(pair);
            if (lasting.has(pair) && points.restitution(a, b) == 1) {
                double pull = pull(a) + pull(b);
                double h = trajectories.h();
                if (approach(pair, body) > Math.max(0.5 * Tolerances.SHORT * h * pull, Tolerances.REST * scales.size(a, b) / h)) {
                    lasting.end(pair);
                }
            }
        }
    }

    private double pull(int body) {
        if (state.body(body).isImmobile()) {
            return 0;
        }
        motion.fall(body, fall, 0);
        return Math.sqrt(fall[0] * fall[0] + fall[1] * fall[1]);
    }

    /** The greatest speed at which points of a pair approach. */
    private double approach(int pair, int body) {
        manifold = manifold == null ? new Manifold() : manifold;
        LastingPairs.look(detection, pair, trajectories.since(body), manifold);
        double most = 0;
        for (int k = 0; k < manifold.count; k++) {
            points.load(manifold, pair, k, point);
            most = Math.max(most, -point.opening);
        }
        return most;
    }

    private boolean standsOn(int pair, int body, double tau, double pull) {
        if (detection.marks().isIgnored(pair)) {
            return false;
        }
        int code = detection.pairs().code(pair);
        boolean yes = isBorne(pair, body, tau, pull);
        detection.pairs().setCode(pair, code);
        return yes;
    }

    private boolean isBorne(int pair, int body, double tau, double pull) {
        double depth = HeapGaps.depth(trajectories.isDriven(body), scales.size(detection.pairs().first(pair), detection.pairs().second(pair)));
        double gap = detection.narrowPhase().gap(pair, tau);
        double near = Math.max(NEAR * depth, detection.narrowPhase().roundingOfGap());
        if (gap > near) {
            return false;
        }
        manifold = manifold == null ? new Manifold() : manifold;
        detection.narrowPhase().contact(pair, tau, manifold);
        double none = Math.max(STANDING * pull * trajectories.h(), Math.sqrt(8 * pull * near));
        boolean isGround = state.body(detection.pairs().other(pair, body)).isImmobile();
        boolean yes = true;
        for (int k = 0; k < manifold.count; k++) {
            points.load(manifold, pair, k, point);
            double pressed = fall[0] * point.nx + fall[1] * point.ny;
            boolean isBelow = (detection.pairs().first(pair) == body ? pressed : -pressed) > 0;
            yes &= (isBelow || !isGround) && Math.abs(point.opening) < none;
        }
        return yes;
    }
}
