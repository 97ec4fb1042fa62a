// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import java.io.Serializable;
import sim.physics.internal.IntList;
import sim.physics.motion.Loads;
import sim.physics.motion.State;

/**
 * RK4 steps of a {@link PinTree} under any forces: at each stage the links are put where the angles say, for who has forces to
 * look at, and what acts on each of them takes part in the elimination. The centre of mass of a free tree follows the sum of the
 * forces by the same method.
 */
class TreeLoads implements Serializable {
    private static final long serialVersionUID = 1L;

    static final int STAGES = 4;
    private static final int VALUES = 2 * State.BLOCK;

    static final double[] NODE = {0, 0.5, 0.5, 1};

    final PinTree tree;

    /** The state at the start of a step, by link. */
    private final double[] start;

    /** Accelerations of the links there, with what the pins do, by link. */
    final double[] first;

    /** Accelerations of the centre of mass at the stages. */
    final double[] fallX = new double[STAGES];

    final double[] fallY = new double[STAGES];

    TreeLoads(PinTree tree) {
        this.tree = tree;
        start = new double[VALUES * tree.links];
        first = new double[State.BLOCK * tree.links];
    }

    /** The masses have changed. */
    void weigh() {
        // they are asked for at each stage
    }

    /** Keeps the state at the start of a step. */
    void keep(State state) {
        for (int k = 0; k < tree.links; k++) {
            System.arraycopy(state.x(), tree.block[k], start, VALUES * k, State.BLOCK);
            System.arraycopy(state.v(), tree.block[k], start, VALUES * k + State.BLOCK, State.BLOCK);
        }
    }

    /** Puts it back. */
    void restore(State state) {
        for (int k = 0; k < tree.links; k++) {
            System.arraycopy(start, VALUES * k, state.x(), tree.block[k], State.BLOCK);
            System.arraycopy(start, VALUES * k + State.BLOCK, state.v(), tree.block[k], State.BLOCK);
        }
    }

    /**
     * Makes a step, or a part of one, from where the tree and the state vectors are.
     *
     * @param state its vectors are at a stage, or at the end when this returns
     * @param bodies the links
     * @param loads the forces
     * @param a takes accelerations, [x″, y″, θ″] per body of the state
     * @param t time of the start
     * @param h step
     * @param isFirst whether it begins where the state was kept
     */
    void step(State state, IntList bodies, Loads loads, double[] a, double t, double h, boolean isFirst) {
        if (tree.isFree) {
            tree.places.locate();
        }
        for (int stage = 0; stage < STAGES; stage++) {
            double c = NODE[stage] * h;
            if (stage > 0) {
                tree.places.place();
                if (tree.isFree) {
                    shift(c, fallX[stage - 1], fallY[stage - 1], NODE[stage - 1] * h, stage);
                }
                tree.places.scatter(state, PinTree.TURNED, PinTree.TURNING);
            }
            loads.load(bodies, t + c, a);
            if (tree.isFree) {
                fall(stage, a);
            }
            eliminate(a);
            if (stage == 0 && isFirst) {
                noteAccelerations();
            }
            if (stage < STAGES - 1) {
                accelerate(stage, NODE[stage + 1] * h);
            }
        }
        finish(h);
        tree.places.place();
        if (tree.isFree) {
            end(h);
        }
        tree.places.scatter(state, PinTree.ANGLE, PinTree.OMEGA);
    }

    /** The pass from the tips to the root. */
    void eliminate(double[] a) {
        tree.eliminate(a);
    }

    /** The one back, and the links at the next stage. */
    void accelerate(int stage, double c) {
        tree.accelerate(stage, c);
    }

    /** The same at the last stage, and the links at the end. */
    void finish(double h) {
        tree.finish(h);
    }

    /** Where the pass from the tips to the root has ended, and with nothing that the next stage needs changed. */
    private void noteAccelerations() {
        double[] l = tree.link;
        for (int r = 0; r < tree.runCount; r++) {
            double x = tree.side[PinTree.SIDE * tree.runs[r] + PinTree.SIDE_A];
            double y = tree.side[PinTree.SIDE * tree.runs[r] + PinTree.SIDE_A + 1];
            for (int k = tree.runs[r], o = PinTree.STRIDE * k; k < tree.runs[r + 1]; k++, o += PinTree.STRIDE) {
                double alpha = tree.angular(o, x, y);
                double square = l[o + PinTree.TURNING] * l[o + PinTree.TURNING];
                double dx = l[o + PinTree.COS] * l[o + PinTree.DX] - l[o + PinTree.SIN] * l[o + PinTree.DY];
                double dy = l[o + PinTree.SIN] * l[o + PinTree.DX] + l[o + PinTree.COS] * l[o + PinTree.DY];
                first[State.BLOCK * k] = x - square * dx - alpha * dy;
                first[State.BLOCK * k + 1] = y - square * dy + alpha * dx;
                first[State.BLOCK * k + 2] = alpha;
                tree.carry(k, x, y, alpha, square);
                double rx = l[o + PinTree.RX];
                double ry = l[o + PinTree.RY];
                x = x - square * rx - alpha * ry;
                y = y - square * ry + alpha * rx;
            }
        }
    }

    /** Says what the accelerations at the start were, by block. */
    void tellFirst(double[] a) {
        for (int k = 0; k < tree.links; k++) {
            System.arraycopy(first, State.BLOCK * k, a, tree.block[k], State.BLOCK);
        }
    }

    /** The acceleration of the centre of mass. */
    private void fall(int stage, double[] a) {
        double x = 0;
        double y = 0;
        for (int k = 0, o = 0; k < tree.links; k++, o += PinTree.STRIDE) {
            x += tree.link[o + PinTree.SHARE] * a[tree.block[k]];
            y += tree.link[o + PinTree.SHARE] * a[tree.block[k] + 1];
        }
        fallX[stage] = x;
        fallY[stage] = y;
    }

    /** Puts the centre of mass where it is at a stage: c times the rates of the stage before from the start. */
    private void shift(double c, double ax, double ay, double before, int stage) {
        double u = tree.places.velocityX() + (stage > 1 ? before * fallX[stage - 2] : 0);
        double v = tree.places.velocityY() + (stage > 1 ? before * fallY[stage - 2] : 0);
        tree.places.shift(c * u, c * v, c * ax, c * ay);
    }

    /** Puts it where it is at the end, (13). */
    private void end(double h) {
        double[] x = fallX;
        double[] y = fallY;
        double sixth = h / 6;
        tree.places.shift(
                h * (tree.places.velocityX() + sixth * (x[0] + x[1] + x[2])),
                h * (tree.places.velocityY() + sixth * (y[0] + y[1] + y[2])),
                sixth * (x[0] + 2 * (x[1] + x[2]) + x[3]),
                sixth * (y[0] + 2 * (y[1] + y[2]) + y[3]));
    }
}
