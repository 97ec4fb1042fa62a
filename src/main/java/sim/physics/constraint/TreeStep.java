// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.motion.State;

/**
 * A step of a tree of pins under a uniform field: RK4, (13), on its angles. Its joints close of themselves, so there is no
 * projection. What is out of the ordinary it leaves to the general code: then it has changed nothing.
 */
final class TreeStep implements Serializable {
    private static final long serialVersionUID = 1L;

    /**
     * Gap, relative to the size of the bodies, that a step in places would have left, from which it is made again in halves:
     * where there is nothing to close, a step that is too long would not be seen otherwise, and could gain energy.
     */
    private static final double ROUGH = 1e-4;

    /** Gap, relative to the largest coordinate, and slip, to the speeds, that a projection leaves behind. */
    private static final double CLOSED = 0x1p-45;

    private static final double SLIP = 1e-11;

    /** What half the step does to that gap, which is of fifth order, and a little less. */
    private static final double FINER = 1.0 / 64;

    private static final int MOST_PARTS = 64;

    private final Island island;
    private final PinTree tree;
    private final double[] open = new double[2];
    private boolean isWeighed;

    /** Parts in which the next step is made at first, as the last one was enough for; and the largest gap of the last. */
    private int parts = 1;

    private double worst;

    TreeStep(Island island, PinTree tree) {
        this.island = island;
        this.tree = tree;
    }

    void forgetMasses() {
        isWeighed = false;
    }

    /**
     * Advances the tree.
     *
     * @param state its vectors are changed, if all is well
     * @param solver one whose results these are
     * @param gx the field
     * @param gy the field
     * @param h step
     * @return false if the general code must make this step
     */
    boolean advance(State state, ConstraintSolver solver, double gx, double gy, double h) {
        if (!solver.isPlain(island, state.w().values())) {
            return false;
        }
        if (!isWeighed) {
            tree.weigh(state.w().values());
            isWeighed = true;
        }
        if (!gather(state)) {
            tree.begin();
            if (!isClosed()) {
                tree.forget();
                return false;
            }
        }
        while (!isDone(gx, gy, h)) {
            if (parts == MOST_PARTS) {
                parts = 1;
                tree.forget();
                return false;
            }
            parts *= 2;
            gather(state);
            tree.begin();
        }
        parts = worst < FINER * ROUGH ? Math.max(1, parts / 2) : parts;
        boolean isUnforced = gx == 0 && gy == 0;
        if (isUnforced) {
            island.invariants.begin(state, true);
        }
        scatter(state);
        island.redundantRows = 0;
        if (isUnforced) {
            island.evaluate(state);
            island.invariants.restore(state);
            if (!gather(state)) {
                tree.begin();
            }
        }
        return true;
    }

    /** Makes the step in its parts; false if they are too long to follow the links. */
    private boolean isDone(double gx, double gy, double h) {
        double part = h / parts;
        worst = 0;
        if (tree.isFree) {
            tree.places.locate();
        }
        for (int k = 0; k < parts; k++) {
            tree.eliminate(gx, gy);
            tree.accelerate(0, 0.5 * part);
            tree.eliminate(gx, gy);
            tree.accelerate(1, 0.5 * part);
            tree.eliminate(gx, gy);
            tree.accelerate(2, part);
            tree.eliminate(gx, gy);
            tree.finish(part);
            double gap = tree.gap() / island.leastSize;
            if (!(gap <= ROUGH)) {
                return false;
            }
            worst = Math.max(worst, gap);
        }
        tree.places.place();
        if (tree.isFree) {
            tree.places.shift(gx, gy, h);
        }
        return true;
    }

    /** Takes the state over; true if it is that of the end of the last step. */
    private boolean gather(State state) {
        double[] l = tree.link;
        double[] x = state.x();
        double[] v = state.v();
        boolean same = true;
        for (int k = 0, o = 0; k < tree.links; k++, o += PinTree.STRIDE) {
            int b = tree.block[k];
            for (int c = 0; c < State.BLOCK; c++) {
                same &= l[o + PinTree.X + c] == x[b + c] & l[o + PinTree.U + c] == v[b + c];
            }
        }
        if (!same) {
            for (int k = 0, o = 0; k < tree.links; k++, o += PinTree.STRIDE) {
                System.arraycopy(x, tree.block[k], l, o + PinTree.X, State.BLOCK);
                System.arraycopy(v, tree.block[k], l, o + PinTree.U, State.BLOCK);
            }
        }
        return same;
    }

    private boolean isClosed() {
        tree.places.gaps(open);
        double place = island.mostSize;
        double speed = 0;
        for (int o = 0; o < tree.link.length; o += PinTree.STRIDE) {
            double[] l = tree.link;
            place = Math.max(place, Math.max(Math.abs(l[o + PinTree.X]), Math.abs(l[o + PinTree.Y])));
            double turning = island.leastSize * Math.abs(l[o + PinTree.OMEGA]);
            speed = Math.max(speed, Math.abs(l[o + PinTree.U]) + Math.abs(l[o + PinTree.V]) + turning);
        }
        return open[0] <= CLOSED * place && open[1] <= SLIP * speed;
    }

    private void scatter(State state) {
        double[] l = tree.link;
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0, o = 0; k < tree.links; k++, o += PinTree.STRIDE) {
            int b = tree.block[k];
            x[b] = l[o + PinTree.X];
            x[b + 1] = l[o + PinTree.Y];
            x[b + 2] = l[o + PinTree.ANGLE];
            v[b] = l[o + PinTree.U];
            v[b + 1] = l[o + PinTree.V];
            v[b + 2] = l[o + PinTree.OMEGA];
        }
    }
}
