// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import sim.physics.collision.Overlap;
import sim.physics.collision.Overlaps;
import sim.physics.constraint.ConstraintException;
import sim.physics.constraint.Constraints;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.Reach;
import sim.physics.motion.State;

/**
 * The way back from time stepping to events: joints, which it leaves a little open, are closed. Where something heavy bears on them, that may put
 * a link into what bears on it, from where no event drives it out again: then they are left as they are, and time stepping goes on.
 */
final class WayBack {
    /** Depth, relative to the smaller body, that closing joints may add, or as much as there is: what time stepping leaves in a crash. */
    private static final double PRESSED = 1e-2;

    private final State state;
    private final Constraints constraints;
    private final Overlaps overlaps;
    private final List<Body> bodies;

    /** Where all were, and how fast. */
    private final double[] x;

    private final double[] v;

    /** Bodies whose joints were closed. */
    private final IntList met = new IntList();

    /**
     * Prepares for it.
     *
     * @param overlaps finds what closing joints has put into one another
     */
    WayBack(State state, Constraints constraints, Overlaps overlaps, List<Body> bodies) {
        this.state = state;
        this.constraints = constraints;
        this.overlaps = overlaps;
        this.bodies = bodies;
        x = state.x().clone();
        v = state.v().clone();
    }

    /**
     * Closes all joints; false if one cannot be closed, or if something is in the way, and then all are where they were.
     *
     * @param isAsked whether an author has asked for events, so that nothing is in the way
     */
    boolean go(boolean isAsked) {
        if (!close() || !isAsked && presses()) {
            putBack();
            return false;
        }
        for (int k = 0; k < met.size; k++) {
            state.touch(met.values[k]);
        }
        return true;
    }

    private boolean close() {
        IslandRounds rounds = new IslandRounds();
        rounds.begin();
        try {
            for (int k = 0; k < state.size(); k++) {
                if (state.body(k) != null && constraints.isTied(k) && rounds.isFirst(constraints.island(k))) {
                    IntList island = constraints.island(k);
                    for (int m = 0; m < island.size; m++) {
                        met.add(island.values[m]);
                    }
                    constraints.assemble(island, Reach.NEWTON);
                }
            }
            return true;
        } catch (ConstraintException e) {
            return false;
        }
    }

    private void putBack() {
        System.arraycopy(x, 0, state.x(), 0, x.length);
        System.arraycopy(v, 0, state.v(), 0, v.length);
        state.placedAll();
    }

    /** Whether closing them has put bodies into one another. */
    private boolean presses() {
        if (!isFar()) {
            return false;
        }
        List<Overlap> now = overlaps.find(bodies);
        if (now.stream().noneMatch(pair -> isPressed(pair, 0))) {
            return false;
        }
        double[] closedX = state.x().clone();
        double[] closedV = state.v().clone();
        putBack();
        Map<List<Body>, Double> before = new HashMap<>();
        overlaps.find(bodies).forEach(pair -> before.put(List.of(pair.a(), pair.b()), pair.depth()));
        System.arraycopy(closedX, 0, state.x(), 0, x.length);
        System.arraycopy(closedV, 0, state.v(), 0, v.length);
        state.placedAll();
        return now.stream().anyMatch(pair -> isPressed(pair, before.getOrDefault(List.of(pair.a(), pair.b()), 0.0)));
    }

    private static boolean isPressed(Overlap pair, double before) {
        double size = Math.min(pair.a().getShape().boundingRadius(), pair.b().getShape().boundingRadius());
        return pair.depth() - before > Math.max(PRESSED * size, before);
    }

    /** Whether a body has been moved so far that it may have been put into another one. */
    private boolean isFar() {
        for (int k = 0; k < state.size(); k++) {
            if (state.body(k) != null && constraints.isTied(k)) {
                int b = State.BLOCK * k;
                double size = state.body(k).getShape().boundingRadius();
                double turn = size * Math.abs(state.x()[b + State.THETA] - x[b + State.THETA]);
                if (Math.abs(state.x()[b] - x[b]) + Math.abs(state.x()[b + 1] - x[b + 1]) + turn > 0.25 * PRESSED * size) {
                    return true;
                }
            }
        }
        return false;
    }
}
