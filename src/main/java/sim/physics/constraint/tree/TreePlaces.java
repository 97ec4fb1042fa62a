// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import java.io.Serializable;
import sim.physics.motion.State;

/**
 * Where the links of a {@link PinTree} are, given their angles: from the root to the tips. The root of a free tree is where
 * the centre of mass, which moves as if it were a body, wants it.
 */
final class TreePlaces implements Serializable {
    private static final long serialVersionUID = 1L;

    private final PinTree tree;

    /** Where the root hangs; if the tree is free, where it was at the start, and its velocity. */
    private double rootX;

    private double rootY;
    private double rootU;
    private double rootV;

    /** Centre of mass and its velocity, from the root. */
    private double centreX;

    private double centreY;
    private double centreU;
    private double centreV;

    /** The same at the start. */
    private double startX;

    private double startY;
    private double startU;
    private double startV;


    /**
     * Makes the places of a tree.
     *
     * @param tree to come
     * @param x where its root hangs, if it is not free
     * @param y where its root hangs, if it is not free
     */
    TreePlaces(PinTree tree, double x, double y) {
        this.tree = tree;
        rootX = x;
        rootY = y;
    }

    /** Takes over the masses of the links. */
    void weigh() {
        double total = 0;
        for (int o = 0; o < tree.link.length; o += PinTree.STRIDE) {
            total += tree.link[o + PinTree.MASS];
        }
        for (int o = 0; o < tree.link.length; o += PinTree.STRIDE) {
            tree.link[o + PinTree.SHARE] = tree.link[o + PinTree.MASS] / total;
        }
    }

    /** Where the root hangs, if the tree is not free. */
    double hangsAtX() {
        return rootX;
    }

    double hangsAtY() {
        return rootY;
    }

    /** Takes note of where a free tree is: its centre of mass from the root, so that no rounding adds up. */
    void locate() {
        rootX = tree.link[PinTree.X];
        rootY = tree.link[PinTree.Y];
        rootU = tree.link[PinTree.U];
        rootV = tree.link[PinTree.V];
        centre();
        startX = centreX;
        startY = centreY;
        startU = centreU;
        startV = centreV;
    }

    private void centre() {
        centreX = 0;
        centreY = 0;
        centreU = 0;
        centreV = 0;
        for (int k = 0, o = 0; k < tree.links; k++, o += PinTree.STRIDE) {
            double m = tree.link[o + PinTree.SHARE];
            centreX += m * (tree.link[o + PinTree.X] - tree.link[PinTree.X]);
            centreY += m * (tree.link[o + PinTree.Y] - tree.link[PinTree.Y]);
            centreU += m * (tree.link[o + PinTree.U] - tree.link[PinTree.U]);
            centreV += m * (tree.link[o + PinTree.V] - tree.link[PinTree.V]);
        }
    }

    /** Where the angles say that the links are, and how fast they move at a stage or at the end; (42), (43). */
    void place() {
        tree.side[PinTree.SIDE_X] = tree.isFree ? 0 : rootX;
        tree.side[PinTree.SIDE_X + 1] = tree.isFree ? 0 : rootY;
        tree.side[PinTree.SIDE_X + 2] = 0;
        tree.side[PinTree.SIDE_X + 3] = 0;
        for (int r = 0; r < tree.runCount; r++) {
            place(tree.runs[r], tree.runs[r + 1]);
        }
    }

    private void place(int from, int to) {
        double[] l = tree.link;
        double x = tree.side[PinTree.SIDE * from + PinTree.SIDE_X];
        double y = tree.side[PinTree.SIDE * from + PinTree.SIDE_X + 1];
        double u = tree.side[PinTree.SIDE * from + PinTree.SIDE_X + 2];
        double v = tree.side[PinTree.SIDE * from + PinTree.SIDE_X + 3];
        for (int k = from, o = PinTree.STRIDE * from; k < to; k++, o += PinTree.STRIDE) {
            double cos = l[o + PinTree.COS];
            double sin = l[o + PinTree.SIN];
            double omega = l[o + PinTree.TURNING];
            for (int c = tree.child[k]; c >= 0; c = tree.sister[c]) {
                int at = PinTree.SIDE * c;
                double ex = cos * tree.side[at] - sin * tree.side[at + 1];
                double ey = sin * tree.side[at] + cos * tree.side[at + 1];
                tree.side[at + PinTree.SIDE_X] = x + ex;
                tree.side[at + PinTree.SIDE_X + 1] = y + ey;
                tree.side[at + PinTree.SIDE_X + 2] = u - omega * ey;
                tree.side[at + PinTree.SIDE_X + 3] = v + omega * ex;
            }
            double dx = cos * l[o + PinTree.DX] - sin * l[o + PinTree.DY];
            double dy = sin * l[o + PinTree.DX] + cos * l[o + PinTree.DY];
            double ex = l[o + PinTree.RX];
            double ey = l[o + PinTree.RY];
            l[o + PinTree.X] = x + dx;
            l[o + PinTree.Y] = y + dy;
            l[o + PinTree.U] = u - omega * dy;
            l[o + PinTree.V] = v + omega * dx;
            x += ex;
            y += ey;
            u -= omega * ey;
            v += omega * ex;
        }
    }

    /** Centre of mass at the start. */
    double x() {
        return rootX + startX;
    }

    double y() {
        return rootY + startY;
    }

    /** Velocity of the centre of mass at the start. */
    double velocityX() {
        return rootU + startU;
    }

    double velocityY() {
        return rootV + startV;
    }

    /** Puts the centre of mass of a free tree, which was {@link #place placed} anywhere, where it falls to in a time. */
    void shift(double gx, double gy, double h) {
        shift(h * (velocityX() + 0.5 * h * gx), h * (velocityY() + 0.5 * h * gy), h * gx, h * gy);
    }

    /** The same, given its way since the start, and the change of its velocity. */
    void shift(double wayX, double wayY, double changeX, double changeY) {
        double x = startX + wayX;
        double y = startY + wayY;
        double u = startU + changeX;
        double v = startV + changeY;
        centre();
        add(rootX + (x - centreX), rootY + (y - centreY), rootU + (u - centreU), rootV + (v - centreV));
    }

    /** Puts the centre of mass of a free tree, which was {@link #place placed} anywhere, somewhere, with a velocity. */
    void centreOn(double x, double y, double u, double v) {
        centre();
        add(x - centreX, y - centreY, u - centreU, v - centreV);
    }

    private void add(double x, double y, double u, double v) {
        for (int o = 0; o < tree.link.length; o += PinTree.STRIDE) {
            tree.link[o + PinTree.X] += x;
            tree.link[o + PinTree.Y] += y;
            tree.link[o + PinTree.U] += u;
            tree.link[o + PinTree.V] += v;
        }
    }

    /** Writes where the links were placed into the state vectors, with angles and rates that lie at a place of theirs. */
    void scatter(State state, int angle, int omega) {
        double[] l = tree.link;
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0, o = 0; k < tree.links; k++, o += PinTree.STRIDE) {
            int b = tree.block[k];
            x[b] = l[o + PinTree.X];
            x[b + 1] = l[o + PinTree.Y];
            x[b + 2] = l[o + angle];
            v[b] = l[o + PinTree.U];
            v[b + 1] = l[o + PinTree.V];
            v[b + 2] = l[o + omega];
        }
    }

    /** Writes the velocities of the links, and no places. */
    void scatterVelocities(State state) {
        double[] v = state.v();
        for (int k = 0, o = 0; k < tree.links; k++, o += PinTree.STRIDE) {
            int b = tree.block[k];
            v[b] = tree.link[o + PinTree.U];
            v[b + 1] = tree.link[o + PinTree.V];
            v[b + 2] = tree.link[o + PinTree.OMEGA];
        }
    }

    /**
     * How far the pins are open at the start, and how fast they open.
     *
     * @param out gets the largest gap, and the largest rate of one
     */
    void gaps(double[] out) {
        double gap = 0;
        double slip = 0;
        for (int k = tree.isFree ? 1 : 0; k < tree.links; k++) {
            int o = PinTree.STRIDE * k;
            int j = tree.parent[k];
            double[] l = tree.link;
            double dx = l[o + PinTree.COS] * l[o + PinTree.DX] - l[o + PinTree.SIN] * l[o + PinTree.DY];
            double dy = l[o + PinTree.SIN] * l[o + PinTree.DX] + l[o + PinTree.COS] * l[o + PinTree.DY];
            double x = l[o + PinTree.X] - dx - rootX;
            double y = l[o + PinTree.Y] - dy - rootY;
            double u = l[o + PinTree.U] + l[o + PinTree.OMEGA] * dy;
            double v = l[o + PinTree.V] - l[o + PinTree.OMEGA] * dx;
            if (j >= 0) {
                int p = PinTree.STRIDE * j;
                double ex = (j == k - 1 ? l[p + PinTree.EX] : tree.side[PinTree.SIDE * k]) - l[p + PinTree.DX];
                double ey = (j == k - 1 ? l[p + PinTree.EY] : tree.side[PinTree.SIDE * k + 1]) - l[p + PinTree.DY];
                double rx = l[p + PinTree.COS] * ex - l[p + PinTree.SIN] * ey;
                double ry = l[p + PinTree.SIN] * ex + l[p + PinTree.COS] * ey;
                x = l[o + PinTree.X] - dx - l[p + PinTree.X] - rx;
                y = l[o + PinTree.Y] - dy - l[p + PinTree.Y] - ry;
                u -= l[p + PinTree.U] - l[p + PinTree.OMEGA] * ry;
                v -= l[p + PinTree.V] + l[p + PinTree.OMEGA] * rx;
            }
            gap = Math.max(gap, Math.abs(x) + Math.abs(y)); // NaN stays
            slip = Math.max(slip, Math.abs(u) + Math.abs(v));
        }
        out[0] = gap;
        out[1] = slip;
    }
}
