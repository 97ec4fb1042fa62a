// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import sim.physics.collision.broad.Pairs;
import sim.physics.motion.State;

/**
 * What lies is a little deep. So what slides over a gap in a floor, or from one body to the next, comes to the edge beyond with a corner that is a little
 * too low, or next to nothing above it, which would stop it. It passes: as soon as it is over that edge, it lies there.
 */
final class Passing implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of the size by which corners may overlap, or miss one another. */
    private static final double SLIGHT = 5e-3;

    /** Part of an edge that is a small one: what is thin itself strikes with all of its side. */
    private static final double PART = 0.25;

    /** How many times as fast as across it what passes goes at the edge. */
    private static final double STEEP = 4;

    private final State state;
    private final Poses poses;
    private final NearPairs near;

    Passing(State state, Poses poses, NearPairs near) {
        this.state = state;
        this.poses = poses;
        this.near = near;
    }

    /** Whether edges that face one another do so along so small a part of theirs that they may pass; less than 0 is how far they miss one another. */
    static boolean isSlight(double overlap, double shorter, double size) {
        return Math.abs(overlap) < Math.min(SLIGHT * size, PART * shorter);
    }

    /** Whether two bodies pass one another that touch so slightly. */
    boolean passes(int a, int partA, int b, int partB, Touch touch, double size) {
        return touch.gap[0] >= -SLIGHT * size && comes(a, b, touch) && (lies(a, b, partB) || lies(b, a, partA));
    }

    /** Whether the point of the one comes at the other, and not across. */
    private boolean comes(int a, int b, Touch touch) {
        double[] v = state.v();
        double[] x = state.x();
        int i = State.BLOCK * a;
        int k = State.BLOCK * b;
        double bx = touch.px[0] - (x[k] - x[i]);
        double by = touch.py[0] - (x[k + 1] - x[i + 1]);
        double ux = v[k] - by * v[k + 2] - v[i] + touch.py[0] * v[i + 2];
        double uy = v[k + 1] + bx * v[k + 2] - v[i + 1] - touch.px[0] * v[i + 2];
        return -(touch.nx * ux + touch.ny * uy) > STEEP * Math.abs(touch.nx * uy - touch.ny * ux);
    }

    /** Whether a body has pressed in the step before on something that is near another one, but not on that, which it passes. */
    private boolean lies(int body, int other, int part) {
        boolean does = false;
        Pairs pairs = near.pairs();
        for (int k = 0; !poses.isGround(body) && k < pairs.countOf(body); k++) {
            int pair = pairs.of(body, k);
            if (near.is(pair, NearPairs.TOUCHED)) {
                boolean isFirst = pairs.first(pair) == body;
                int by = isFirst ? pairs.second(pair) : pairs.first(pair);
                int byPart = isFirst ? pairs.secondPart(pair) : pairs.firstPart(pair);
                if (by == other && (byPart == part || !poses.isGround(other))) {
                    return false;
                }
                does |= areNear(by, other);
            }
        }
        return does;
    }

    /** Whether two bodies may be side by side: a wheel with teeth is not to pass another one because something lies in it. */
    private boolean areNear(int by, int other) {
        if (poses.isGround(by) && poses.isGround(other)) {
            return true;
        }
        int body = poses.isGround(other) ? by : other;
        int mate = body == by ? other : by;
        Pairs pairs = near.pairs();
        boolean are = false;
        for (int k = 0; !are && k < pairs.countOf(body); k++) {
            int pair = pairs.of(body, k);
            are = pairs.first(pair) == mate || pairs.second(pair) == mate;
        }
        return are;
    }
}
