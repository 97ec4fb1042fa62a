// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.CollisionDetection;
import sim.physics.internal.IntList;
import sim.physics.internal.Tolerances;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * Which pairs of a large heap's bodies may come to touch in the step that begins: they are solved with the heap, each with the
 * gap that it has, so that hardly anything happens within the step (Stewart and Trinkle 1996; Anitescu and Potra 1997). An impact in
 * the midst of many bodies would else have all of them solved anew. Bounces are no part of it, nor what is so far away that its
 * normal may be another one when it touches.
 */
final class Foresight implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Gap of a pair at most, relative to the smaller body. */
    private static final double NEAR = 0.5;

    private final State state;
    private final Trajectories trajectories;
    private final HeapPull pulls;
    private final CollisionDetection detection;
    private final ContactPoints points;
    private final BodyScale scales;

    /** By pair: the step in which it was foreseen last, plus 1. */
    private double[] seen = {};

    Foresight(
            State state,
            Trajectories trajectories,
            HeapPull pulls,
            CollisionDetection detection,
            ContactPoints points,
            BodyScale scales) {
        this.state = state;
        this.trajectories = trajectories;
        this.pulls = pulls;
        this.detection = detection;
        this.points = points;
        this.scales = scales;
    }

    /** Whether a pair was foreseen in this step. */
    boolean has(int pair) {
        return pair < seen.length && seen[pair] == trajectories.step() + 1;
    }

    /**
     * Finds the pairs of a body, at the start of a step, that do not last and may close in it.
     *
     * @param found takes their numbers
     */
    void look(int body, IntList found) {
        if (!points.areForeseen()) {
            return;
        }
        double pull = pulls.of(body);
        for (int m = 0; m < detection.pairs().countOf(body); m++) {
            int pair = detection.pairs().of(body, m);
            int other = detection.pairs().other(pair, body);
            boolean isOpen = !detection.marks().isUnseen(pair) && !detection.marks().isLasting(pair) && !has(pair);
            if (isOpen && !trajectories.isDriven(other) && closes(pair, body, other, pull)) {
                seen = pair < seen.length ? seen : Arrays.copyOf(seen, Math.max(2 * seen.length, pair + 1));
                seen[pair] = trajectories.step() + 1;
                found.add(pair);
            }
        }
    }

    /** Whether two bodies may touch in the step, and hardly bounce then. */
    private boolean closes(int pair, int a, int b, double pull) {
        double h = trajectories.h();
        double[] d = trajectories.data();
        int oa = a * Trajectories.STRIDE;
        int ob = b * Trajectories.STRIDE;
        double ux = d[ob + Trajectories.VX] - d[oa + Trajectories.VX];
        double uy = d[ob + Trajectories.VY] - d[oa + Trajectories.VY];
        double turn = rim(a, d[oa + Trajectories.OMEGA]) + rim(b, d[ob + Trajectories.OMEGA]);
        double speed = Math.sqrt(ux * ux + uy * uy) + turn + pull * h;
        double way = Math.min(speed * h, NEAR * scales.size(a, b));
        if (2 * points.restitution(a, b) * speed > Tolerances.SHORT * h * pull || !state.body(b).isImmobile() && centres(a, b) > way) {
            return false;
        }
        return detection.narrowPhase().gap(pair, 0) <= way;
    }

    private double rim(int body, double omega) {
        return Math.abs(omega) * trajectories.radius(body);
    }

    /** How far the circles of two bodies are apart at the start of the step. */
    private double centres(int a, int b) {
        double[] d = trajectories.data();
        int oa = a * Trajectories.STRIDE;
        int ob = b * Trajectories.STRIDE;
        double ta = trajectories.duration(a, 0);
        double tb = trajectories.duration(b, 0);
        double x = d[ob] + tb * d[ob + Trajectories.VX] - d[oa] - ta * d[oa + Trajectories.VX];
        double y = d[ob + 1] + tb * d[ob + Trajectories.VY] - d[oa + 1] - ta * d[oa + Trajectories.VY];
        return Math.sqrt(x * x + y * y) - trajectories.radius(a) - trajectories.radius(b);
    }
}
