// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.SineTable;
import sim.physics.motion.Loads;
import sim.physics.motion.State;
import sim.physics.motion.TiedCoordinates;

/**
 * The angles of a {@link PinTree}, by link, for methods that choose their steps; behind them the centre of mass of a free
 * tree, which follows the sum of the forces.
 *
 * <p>What an error of the angles does to places and velocities is found link by link from the root on, so that a tolerance is
 * that of the places, as it is for bodies that nothing ties.
 */
final class TreeCoordinates implements TiedCoordinates, Serializable {
    private static final long serialVersionUID = 1L;

    /** The largest turn of a link that is followed at once. */
    private static final double HALF_TURN = Math.PI;

    private final TreeHost island;
    private final TreeStep step;
    private final PinTree tree;

    /** By link: the place of its body's block among those of the group. */
    private final int[] slot;

    /** What the coordinates are asked for in this step. */
    private transient State state;

    private transient boolean isFit;
    private transient Loads loads;
    private transient double[] forced;
    private double gx;
    private double gy;

    TreeCoordinates(TreeHost island, TreeStep step, PinTree tree) {
        this.island = island;
        this.step = step;
        this.tree = tree;
        slot = new int[tree.links];
        for (int k = 0; k < tree.links; k++) {
            int body = tree.block[k] / State.BLOCK;
            slot[k] = State.BLOCK * Arrays.binarySearch(island.bodies().values, 0, island.bodies().size, body);
        }
    }

    /** Those of some state vectors. */
    TreeCoordinates of(State state, boolean isFit) {
        this.state = state;
        this.isFit = isFit;
        return this;
    }

    @Override
    public boolean begin(Loads loads, double gx, double gy, double[] a) {
        if (!isFit || !step.begin(state)) {
            return false;
        }
        this.loads = loads;
        this.gx = gx;
        this.gy = gy;
        forced = a;
        island.step();
        if (isUnforced()) {
            island.keepInvariants(state);
        }
        return true;
    }

    private boolean isUnforced() {
        return loads == null && gx == 0 && gy == 0;
    }

    @Override
    public void end() {
        if (isUnforced()) {
            step.keepInvariants(state);
        }
    }

    @Override
    public int size() {
        return tree.links + (tree.isFree ? 2 : 0);
    }

    @Override
    public void read(double[] x, double[] v) {
        step.gather(state);
        for (int k = 0, o = 0; k < tree.links; k++, o += PinTree.STRIDE) {
            x[k] = tree.link[o + PinTree.ANGLE];
            v[k] = tree.link[o + PinTree.OMEGA];
        }
        if (tree.isFree) {
            tree.places.locate();
            x[tree.links] = tree.places.x();
            x[tree.links + 1] = tree.places.y();
            v[tree.links] = tree.places.velocityX();
            v[tree.links + 1] = tree.places.velocityY();
        }
    }

    @Override
    public double longest() {
        double most = 0;
        for (int o = 0; o < tree.link.length; o += PinTree.STRIDE) {
            most = Math.max(most, Math.abs(tree.link[o + PinTree.OMEGA]));
        }
        return HALF_TURN / most; // infinite at rest
    }

    /** Turns the links. */
    private void pose(double[] x, double[] v) {
        tree.forget();
        double[] l = tree.link;
        for (int k = 0, o = 0; k < tree.links; k++, o += PinTree.STRIDE) {
            l[o + PinTree.TURNED] = x[k];
            l[o + PinTree.TURNING] = v[k];
            SineTable.turn(x[k], l[o + PinTree.EX], l[o + PinTree.EY], l, o + PinTree.COS); // (45), (46)
        }
    }

    /** Finds where the links are that were turned. */
    private void place(double[] x, double[] v) {
        tree.places.place();
        if (tree.isFree) {
            int n = tree.links;
            tree.places.centreOn(x[n], x[n + 1], v[n], v[n + 1]);
        }
    }

    @Override
    public void accelerate(double[] x, double[] v, double t, double[] a) {
        pose(x, v);
        int n = tree.links;
        if (loads == null) {
            tree.eliminate(gx, gy);
        } else {
            place(x, v);
            tree.places.scatter(state, PinTree.TURNED, PinTree.TURNING);
            tree.forget();
            loads.load(island.bodies(), t, forced);
            tree.eliminate(forced);
        }
        for (int r = 0; r < tree.runCount; r++) {
            accelerate(a, tree.runs[r], tree.runs[r + 1]);
        }
        if (tree.isFree) {
            a[n] = gx;
            a[n + 1] = gy;
        }
        if (tree.isFree && loads != null) {
            fall(a);
        }
    }

    private void accelerate(double[] a, int from, int to) {
        double[] l = tree.link;
        double x = tree.side[PinTree.SIDE * from + PinTree.SIDE_A];
        double y = tree.side[PinTree.SIDE * from + PinTree.SIDE_A + 1];
        for (int k = from, o = PinTree.STRIDE * from; k < to; k++, o += PinTree.STRIDE) {
            double alpha = tree.angular(o, x, y);
            double square = l[o + PinTree.TURNING] * l[o + PinTree.TURNING];
            if (tree.child[k] >= 0) {
                tree.carry(k, x, y, alpha, square);
            }
            double rx = l[o + PinTree.RX];
            double ry = l[o + PinTree.RY];
            x = x - square * rx - alpha * ry;
            y = y - square * ry + alpha * rx;
            a[k] = alpha;
        }
    }

    /** The acceleration of the centre of mass under the forces. */
    private void fall(double[] a) {
        int n = tree.links;
        a[n] = 0;
        a[n + 1] = 0;
        for (int k = 0, o = 0; k < n; k++, o += PinTree.STRIDE) {
            a[n] += tree.link[o + PinTree.SHARE] * forced[tree.block[k]];
            a[n + 1] += tree.link[o + PinTree.SHARE] * forced[tree.block[k] + 1];
        }
    }

    @Override
    public void put(double[] x, double[] v) {
        pose(x, v);
        place(x, v);
        for (int o = 0; o < tree.link.length; o += PinTree.STRIDE) {
            tree.link[o + PinTree.ANGLE] = tree.link[o + PinTree.TURNED];
            tree.link[o + PinTree.OMEGA] = tree.link[o + PinTree.TURNING];
        }
        tree.places.scatter(state, PinTree.ANGLE, PinTree.OMEGA);
    }

    @Override
    public void accelerations(double[] x, double[] v, double[] a, double[] byBlock) {
        pose(x, v);
        double[] l = tree.link;
        double[] b = tree.side;
        clear();
        double x0 = 0;
        double y0 = 0;
        for (int k = 0, o = 0; k < tree.links; k++, o += PinTree.STRIDE) {
            int at = PinTree.SIDE * k + PinTree.SIDE_X;
            boolean isFirst = k == 0 || tree.parent[k] != k - 1;
            double px = isFirst ? b[at] : x0;
            double py = isFirst ? b[at + 1] : y0;
            double square = v[k] * v[k];
            for (int c = tree.child[k]; c >= 0; c = tree.sister[c]) {
                double ex = armX(o, b[PinTree.SIDE * c], b[PinTree.SIDE * c + 1]);
                double ey = armY(o, b[PinTree.SIDE * c], b[PinTree.SIDE * c + 1]);
                b[PinTree.SIDE * c + PinTree.SIDE_X] = px - square * ex - a[k] * ey;
                b[PinTree.SIDE * c + PinTree.SIDE_X + 1] = py - square * ey + a[k] * ex;
            }
            double dx = armX(o, l[o + PinTree.DX], l[o + PinTree.DY]);
            double dy = armY(o, l[o + PinTree.DX], l[o + PinTree.DY]);
            byBlock[tree.block[k]] = px - square * dx - a[k] * dy;
            byBlock[tree.block[k] + 1] = py - square * dy + a[k] * dx;
            byBlock[tree.block[k] + State.THETA] = a[k];
            x0 = px - square * l[o + PinTree.RX] - a[k] * l[o + PinTree.RY];
            y0 = py - square * l[o + PinTree.RY] + a[k] * l[o + PinTree.RX];
        }
        if (tree.isFree) {
            centre(byBlock, tree.block, a[tree.links], a[tree.links + 1]);
        }
    }

    /** The root's pin stays. */
    private void clear() {
        for (int c = 0; c < 4; c++) {
            tree.side[PinTree.SIDE_X + c] = 0;
        }
    }

    private double armX(int o, double x, double y) {
        return tree.link[o + PinTree.COS] * x - tree.link[o + PinTree.SIN] * y;
    }

    private double armY(int o, double x, double y) {
        return tree.link[o + PinTree.SIN] * x + tree.link[o + PinTree.COS] * y;
    }

    /** Gives the centre of mass what it should have, by adding the same to all links. */
    private void centre(double[] values, int[] at, double x, double y) {
        double restX = x;
        double restY = y;
        for (int k = 0; k < tree.links; k++) {
            double share = tree.link[PinTree.STRIDE * k + PinTree.SHARE];
            restX -= share * values[at[k]];
            restY -= share * values[at[k] + 1];
        }
        for (int k = 0; k < tree.links; k++) {
            values[at[k]] += restX;
            values[at[k] + 1] += restY;
        }
    }

    @Override
    public boolean spread(double[] x, double[] v, double[] byX, double[] byV) {
        double[] b = tree.side;
        clear();
        double x0 = 0;
        double y0 = 0;
        double u0 = 0;
        double v0 = 0;
        for (int k = 0, o = 0; k < tree.links; k++, o += PinTree.STRIDE) {
            int at = PinTree.SIDE * k + PinTree.SIDE_X;
            if (k > 0 && tree.parent[k] != k - 1) {
                x0 = b[at];
                y0 = b[at + 1];
                u0 = b[at + 2];
                v0 = b[at + 3];
            }
            double turn = x[k];
            double rate = v == null ? 0 : v[k];
            double bend = v == null ? 0 : tree.link[o + PinTree.TURNING] * turn;
            for (int c = tree.child[k]; c >= 0; c = tree.sister[c]) {
                double ex = armX(o, b[PinTree.SIDE * c], b[PinTree.SIDE * c + 1]);
                double ey = armY(o, b[PinTree.SIDE * c], b[PinTree.SIDE * c + 1]);
                int to = PinTree.SIDE * c + PinTree.SIDE_X;
                b[to] = x0 - turn * ey;
                b[to + 1] = y0 + turn * ex;
                b[to + 2] = u0 - rate * ey - bend * ex;
                b[to + 3] = v0 + rate * ex - bend * ey;
            }
            double dx = armX(o, tree.link[o + PinTree.DX], tree.link[o + PinTree.DY]);
            double dy = armY(o, tree.link[o + PinTree.DX], tree.link[o + PinTree.DY]);
            int own = slot[k];
            byX[own] = x0 - turn * dy;
            byX[own + 1] = y0 + turn * dx;
            byX[own + 2] = turn;
            byV[own] = u0 - rate * dy - bend * dx;
            byV[own + 1] = v0 + rate * dx - bend * dy;
            byV[own + 2] = rate;
            double rx = tree.link[o + PinTree.RX];
            double ry = tree.link[o + PinTree.RY];
            x0 -= turn * ry;
            y0 += turn * rx;
            u0 -= rate * ry + bend * rx;
            v0 += rate * rx - bend * ry;
        }
        if (tree.isFree) {
            int n = tree.links;
            centre(byX, slot, x[n], x[n + 1]);
            centre(byV, slot, v == null ? 0 : v[n], v == null ? 0 : v[n + 1]);
        }
        return true;
    }
}
