// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import java.util.stream.IntStream;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/**
 * Bonds that hang together with loops: J W Jᵀ λ = r, (41), by block elimination in an order of little fill-in. Rows that depend on others get nothing, and those
 * that all but depend on them get a part: what they ask for is what the others leave, which is of second order, and what they would get is without bound.
 */
final class TieLoops implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int J = NodeLayout.J;
    private static final int BLOCK = State.BLOCK;

    /** Joints of a body, and products of blocks for each node in the mean, up to which elimination is worth it. */
    private static final int HUB = 32;

    private static final int FILL = 400;

    /** The same where contacts come and go, and with them the order: joints that brace one another so often tremble under what they bear. */
    private static final int FEW = 24;

    /** Rows whose pivots, as if all masses were alike, are this part of their diagonal get half of what they ask for; and those of so many times the square of what joints are open. */
    private static final double DEPENDENT = 1e-3;

    private static final double TIMES = 10;

    /** By what part of themselves rows yield where they have to, at first, and how many times as much in each further trial. */
    private static final double SOFT = 0.01;

    private static final double SOFTER = 10;

    /** By node: its bond, and the first one of its rows in that. */
    private final int[] bonds;

    private final int[] first;

    /** By node: whether it is that of a motor. */
    private final boolean[] isMotor;

    private final int[] bodies;
    private final double[] sizes;
    private final double[] j;
    private final NodeRows rows;
    private final BlockFactor factor;
    private final double[] right;

    /** The same with bodies of mass 1, which tells the pose from the masses; null until some pivot is small. */
    private BlockFactor even;

    private final boolean[] isAngle;

    /** The part of their diagonal at which pivots are those of rows that get half; 0 if all is to be eliminated anew. */
    private double dependent;

    /** By body: inverse masses, those of bodies of mass 1 and their size, and what the last solution has given them. */
    private final double[] masses;

    private final double[] alike;
    private final double[] change;

    /** Makes the equations of bonds; null if there are so many joints around a body, or so many loops, that turns are better. */
    static TieLoops of(TieBonds bonds, int[] those) {
        int[] bodies = bodies(bonds, those);
        int[] around = new int[bodies.length];
        int most = 0;
        for (int k : those) {
            most = Math.max(most, ++around[Arrays.binarySearch(bodies, bonds.child(k))]);
            most = bonds.parent(k) < 0 ? most : Math.max(most, ++around[Arrays.binarySearch(bodies, bonds.parent(k))]);
        }
        TieLoops loops = most > HUB ? null : new TieLoops(bonds, those);
        return loops == null || !loops.takes(FILL) ? null : loops;
    }

    /** Whether there are so few loops that these may be solved with contacts. */
    boolean areFew() {
        return takes(FEW);
    }

    private boolean takes(int most) {
        return factor.work() <= (long) most * bonds.length;
    }

    private TieLoops(TieBonds those, int[] ids) {
        bodies = bodies(those, ids);
        sizes = sizes(those, ids);
        int n = ids.length;
        int[] a = new int[n];
        int[] b = new int[n];
        int[] count = new int[n];
        for (int k = 0; k < n; k++) {
            a[k] = Arrays.binarySearch(bodies, those.child(ids[k]));
            b[k] = those.parent(ids[k]) < 0 ? -1 : Arrays.binarySearch(bodies, those.parent(ids[k]));
            count[k] = those.rows(ids[k]);
        }
        NodeLayout layout = new NodeLayout(a, b, count, (k, row) -> those.isAngle(ids[k], row), bodies.length);
        factor = layout.factor;
        bonds = new int[layout.nodes];
        first = new int[layout.nodes];
        isMotor = new boolean[layout.nodes];
        for (int k = 0; k < n; k++) {
            for (int p = layout.firstNode[k]; p < layout.firstNode[k + 1]; p++) {
                bonds[p] = ids[layout.order[k]];
                first[p] = 2 * (p - layout.firstNode[k]);
                isMotor[p] = first[p] > 0 && those.pin(bonds[p]) >= 0;
            }
        }
        j = new double[J * layout.nodes];
        right = new double[2 * layout.nodes];
        isAngle = layout.isAngle;
        masses = new double[BLOCK * bodies.length];
        alike = new double[BLOCK * bodies.length];
        change = new double[BLOCK * bodies.length];
        for (int k = 0; k < bodies.length; k++) {
            alike[BLOCK * k] = 1;
            alike[BLOCK * k + 1] = 1;
            alike[BLOCK * k + 2] = 1 / (sizes[k] * sizes[k]);
        }
        rows = new NodeRows(j, blocks(layout.a), blocks(layout.b), factor, layout.shared(bodies.length));
    }

    /** Those of bodies, or of their shortest joints if these are longer: a disc among rods may go some way before these turn by much. */
    private double[] sizes(TieBonds those, int[] ids) {
        double[] least = new double[bodies.length];
        Arrays.fill(least, Double.POSITIVE_INFINITY);
        for (int k : ids) {
            int child = Arrays.binarySearch(bodies, those.child(k));
            int parent = Arrays.binarySearch(bodies, those.parent(k));
            least[child] = Math.min(least[child], those.extent(k));
            if (parent >= 0) {
                least[parent] = Math.min(least[parent], those.extent(k));
            }
        }
        return IntStream.range(0, bodies.length).mapToDouble(k -> Math.max(those.size(bodies[k]), least[k])).toArray();
    }

    private static int[] bodies(TieBonds those, int[] ids) {
        IntList found = new IntList();
        for (int k : ids) {
            found.add(those.child(k));
            if (those.parent(k) >= 0) {
                found.add(those.parent(k));
            }
        }
        return Arrays.stream(found.values, 0, found.size).sorted().distinct().toArray();
    }

    private static int[] blocks(int[] local) {
        return Arrays.stream(local).map(body -> body < 0 ? -1 : BLOCK * body).toArray();
    }

    /**
     * Eliminates all, of which J is read. Rows that depend on others where joints are closed do not where these are open, by the square of that, and ask for
     * what nothing can give.
     *
     * @param open how far joints are open at most, relative to their bodies
     */
    void factor(double[] d, double[] w, double open) {
        double part = Math.max(DEPENDENT, TIMES * open * open);
        if (!take(d, w) && part == dependent) {
            return; // velocities were solved here, and places are next
        }
        dependent = part;
        eliminate(null);
        if (factor.pivots.isBeside()) {
            judge();
            eliminate(even.pivots);
        }
    }

    /** Takes J and masses; returns whether they are others than those that were taken last. */
    private boolean take(double[] d, double[] w) {
        boolean areOthers = false;
        for (int p = 0; p < bonds.length; p++) {
            int o = TreeRows.STRIDE * bonds[p] + BLOCK * first[p];
            int rows = first[p] > 0 ? BLOCK : 2 * BLOCK;
            areOthers |= take(d, o + TreeRows.CHILD, j, J * p, rows);
            areOthers |= take(d, o + TreeRows.PARENT, j, J * p + 2 * BLOCK, rows);
            if (first[p] > 0) {
                factor.rest(p, j[J * p + 2] == 0); // a motor that slips, or has no part in places
            }
        }
        for (int k = 0; k < bodies.length; k++) {
            areOthers |= take(w, bodies[k], masses, BLOCK * k, BLOCK);
        }
        return areOthers;
    }

    private static boolean take(double[] from, int at, double[] to, int first, int count) {
        boolean areOthers = false;
        for (int k = 0; k < count; k++) {
            areOthers |= from[at + k] != to[first + k];
            to[first + k] = from[at + k];
        }
        return areOthers;
    }

    private void eliminate(Pivots shares) {
        factor.pivots.obey(shares);
        assemble(factor, masses);
        factor.factor(0, Pivots.NOISE, true);
    }

    private void soften(double part) {
        assemble(factor, masses);
        double[] d = factor.diagonal();
        for (int k = 0; k < d.length; k += 3) {
            d[k] *= 1 + part;
            d[k + 2] *= 1 + part;
        }
        factor.factor(0, Pivots.NOISE, true);
        dependent = 0;
    }

    /** Finds which rows depend on others, or nearly so, whatever the masses are. */
    private void judge() {
        even = even == null ? new BlockFactor(factor.start, factor.row, factor.rows, isAngle) : even;
        even.pivots.judge(dependent);
        assemble(even, alike);
        even.factor(0, Pivots.NOISE, true);
    }

    private void assemble(BlockFactor to, double[] w) {
        to.clear();
        rows.diagonal(w, to.diagonal());
        rows.couple(to.below());
    }

    /** Finds what takes back all that joints have been given, but not motors: of what has no effect, the next solution would take nothing back. */
    void release(double[] d) {
        for (int p = 0; p < bonds.length; p++) {
            int o = TreeRows.STRIDE * bonds[p] + TreeRows.GIVEN + first[p];
            right[2 * p] = isMotor[p] ? 0 : -d[o];
            right[2 * p + 1] = first[p] > 0 ? 0 : -d[o + 1];
        }
        apply(d);
    }

    private void solve(double[] d) {
        for (int p = 0; p < bonds.length; p++) {
            int o = TreeRows.STRIDE * bonds[p] + TreeRows.ASKED + first[p];
            right[2 * p] = factor.rows(p) > 0 ? d[o] : 0;
            right[2 * p + 1] = factor.rows(p) > 1 ? d[o + 1] : 0;
        }
        factor.solve(right);
        apply(d);
    }

    /**
     * Finds what the bodies are to get, so that rows have what they ask for. Where they would go far by that, rows yield by a part of what they are pushed: beside
     * a pose in which bodies go no farther, they ask for more than anything should get.
     *
     * @param far parts of their sizes that bodies may go in a substep, if they go by what they get, and angles that they may turn
     * @return whether they then go less far
     */
    boolean solveNear(double[] d, double far, double h) {
        solve(d);
        for (double part = SOFT; part <= 1 && isFar(far, h); part *= SOFTER) {
            soften(part);
            solve(d);
        }
        return !isFar(far, h);
    }

    /** Takes note of impulses, and of what bodies get by them. */
    private void apply(double[] d) {
        for (int p = 0; p < bonds.length; p++) {
            int o = TreeRows.STRIDE * bonds[p] + TreeRows.GIVEN + first[p];
            d[o] = right[2 * p];
            d[o + 1] = first[p] > 0 ? d[o + 1] : right[2 * p + 1];
        }
        Arrays.fill(change, 0);
        rows.apply(masses, right, change);
    }

    private boolean isFar(double part, double h) {
        boolean yes = false;
        for (int k = 0; k < bodies.length && !yes; k++) {
            double most = part * sizes[k] / h;
            yes = !(Math.abs(change[BLOCK * k]) < most && Math.abs(change[BLOCK * k + 1]) < most && Math.abs(change[BLOCK * k + 2]) < part / h);
        }
        return yes;
    }

    /** Gives the bodies that. */
    void give(double[] v) {
        add(1, v);
    }

    /** Moves the bodies by what was given last, and marks them. */
    void move(double[] x, double h, boolean[] marks) {
        add(h, x);
        for (int body : bodies) {
            marks[body / BLOCK] = true;
        }
    }

    private void add(double times, double[] to) {
        for (int k = 0; k < bodies.length; k++) {
            for (int m = 0; m < BLOCK; m++) {
                to[bodies[k] + m] += times * change[BLOCK * k + m];
            }
        }
    }
}
