// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.motion.State;

/** Where the links of a {@link HungChain} are at the end of a step, in blocks as the state vectors have them. */
final class HungEnds implements Serializable {
    private static final long serialVersionUID = 1L;

    /** What the energy may be off by after a step, relative to the kinetic energy; a step that is off by more was too long. */
    private static final double WRONG = 0.05;

    private final PinTree tree;

    /** The values of the links. */
    private final double[] link;

    private final double[] calm;

    private final double[] endX;
    private final double[] endV;

    /** How far centres of mass are beside the lines between the pins; null if none is. */
    private double[] asides;

    /** The pin that the next link to be placed hangs on, and how fast it moves. */
    private double pinX;

    private double pinY;
    private double pinU;
    private double pinV;

    /** Whether that is the end of the last step; zeros are none. */
    private boolean isEnd;

    /** Whether the blocks lie in the state vectors one behind the other. */
    private final boolean isRow;

    HungEnds(PinTree tree, double[] link, double[] calm) {
        this.tree = tree;
        this.link = link;
        this.calm = calm;
        endX = new double[State.BLOCK * tree.links];
        endV = new double[State.BLOCK * tree.links];
        boolean row = true;
        for (int k = 0; k < tree.links; k++) {
            row &= tree.block[k] == tree.block[0] + State.BLOCK * k;
        }
        isRow = row;
    }

    /** Takes note of whether centres of mass are beside the lines between the pins. */
    void weigh() {
        asides = HungMasses.asides(tree, calm);
    }

    /** Takes a state over. */
    void take(State state) {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0; k < tree.links; k++) {
            System.arraycopy(x, tree.block[k], endX, State.BLOCK * k, State.BLOCK);
            System.arraycopy(v, tree.block[k], endV, State.BLOCK * k, State.BLOCK);
        }
        isEnd = true;
    }

    /** The links are to be placed, from the root on. */
    void begin() {
        pinX = tree.places.hangsAtX();
        pinY = tree.places.hangsAtY();
        pinU = 0;
        pinV = 0;
        isEnd = true;
    }

    /** Where the angles say that the next links are, and how fast they move at the end of a step; (42), (43). */
    void place(int from, int to) {
        double[] l = link;
        double[] rest = calm;
        double[] x = endX;
        double[] v = endV;
        double px = pinX;
        double py = pinY;
        double pu = pinU;
        double pv = pinV;
        int o = HungChain.STRIDE * from;
        int q = HungChain.CALM * from;
        for (int b = State.BLOCK * from; b < State.BLOCK * to; b += State.BLOCK, o += HungChain.STRIDE, q += HungChain.CALM) {
            double c = l[o + HungChain.COS];
            double s = l[o + HungChain.SIN];
            double turn = l[o + HungChain.OMEGA];
            double near = rest[q + HungChain.REACH];
            double far = rest[q + HungChain.LENGTH];
            x[b] = px + near * c;
            x[b + 1] = py + near * s;
            x[b + 2] = rest[q + HungChain.ANGLE];
            v[b] = pu - turn * (near * s);
            v[b + 1] = pv + turn * (near * c);
            v[b + 2] = turn;
            px += far * c;
            py += far * s;
            pu -= turn * (far * s);
            pv += turn * (far * c);
        }
        pinX = px;
        pinY = py;
        pinU = pu;
        pinV = pv;
        if (asides != null) {
            placeAside(from, to);
        }
    }

    private void placeAside(int from, int to) {
        for (int k = from; k < to; k++) {
            int b = State.BLOCK * k;
            int o = HungChain.STRIDE * k;
            double ax = -asides[k] * link[o + HungChain.SIN];
            double ay = asides[k] * link[o + HungChain.COS];
            endX[b] += ax;
            endX[b + 1] += ay;
            endV[b] -= link[o + HungChain.OMEGA] * ay;
            endV[b + 1] += link[o + HungChain.OMEGA] * ax;
        }
    }

    /**
     * Gives the chain the energy of the start of a step back, as {@link TreeEnergy} does.
     *
     * @param state at the start, while the links are at the end
     * @param gx the field
     * @param gy the field
     * @return false if it is off by too much; then nothing is changed
     */
    boolean restoreEnergy(State state, double gx, double gy) {
        double[] x = endX;
        double[] v = endV;
        double[] x0 = state.x();
        double[] v0 = state.v();
        double kinetic = 0;
        double growth = 0;
        for (int k = 0, e = 0; k < tree.links; k++, e += State.BLOCK) {
            int b = tree.block[k];
            double m = calm[HungChain.CALM * k + HungChain.MASS];
            double inertia = calm[HungChain.CALM * k + HungChain.INERTIA];
            double turn = v[e + 2];
            kinetic += m * (v[e] * v[e] + v[e + 1] * v[e + 1]) + inertia * turn * turn;
            growth += m * ((v[e] - v0[b]) * (v[e] + v0[b]) + (v[e + 1] - v0[b + 1]) * (v[e + 1] + v0[b + 1]))
                    + inertia * (turn - v0[b + 2]) * (turn + v0[b + 2])
                    - 2 * m * (gx * (x[e] - x0[b]) + gy * (x[e + 1] - x0[b + 1]));
        }
        if (!(Math.abs(growth) <= WRONG * kinetic)) {
            return false;
        }
        double scale = Math.sqrt(1 - growth / kinetic);
        for (int o = 0, e = 0; kinetic > 0 && e < v.length; o += HungChain.STRIDE, e += State.BLOCK) {
            v[e] *= scale;
            v[e + 1] *= scale;
            v[e + 2] *= scale;
            link[o + HungChain.OMEGA] = v[e + 2];
            link[o + HungChain.TURNING] = v[e + 2];
        }
        return true;
    }

    /** Whether a state is, to the bit, that of the end of the last step. */
    boolean isAt(State state) {
        return isEnd && isAt(endX, state.x()) && isAt(endV, state.v());
    }

    private boolean isAt(double[] end, double[] now) {
        int b = tree.block[0];
        if (isRow) {
            return Arrays.equals(end, 0, end.length, now, b, b + end.length);
        }
        long different = 0;
        for (int k = 0, e = 0; k < tree.links; k++, e += State.BLOCK) {
            b = tree.block[k];
            different |= bits(end[e]) ^ bits(now[b]) | bits(end[e + 1]) ^ bits(now[b + 1]) | bits(end[e + 2]) ^ bits(now[b + 2]);
        }
        return different == 0;
    }

    private static long bits(double value) {
        return Double.doubleToRawLongBits(value);
    }

    /** Lets the next state be one that is not where the last step ended. */
    void forget() {
        isEnd = false;
    }

    /** Writes where the links are into the state vectors. */
    void scatter(State state) {
        scatter(endX, state.x());
        scatter(endV, state.v());
    }

    private void scatter(double[] end, double[] to) {
        if (isRow) {
            System.arraycopy(end, 0, to, tree.block[0], end.length);
            return;
        }
        for (int k = 0, e = 0; k < tree.links; k++, e += State.BLOCK) {
            int b = tree.block[k];
            to[b] = end[e];
            to[b + 1] = end[e + 1];
            to[b + 2] = end[e + 2];
        }
    }
}
