// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
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

    private static final int FILL = 24;

    /** Rows whose pivots, as if all masses were alike, are this part of their diagonal get half of what they ask for; and those of so many times the square of what joints are open. */
    private static final double DEPENDENT = 1e-3;

    private static final double TIMES = 10;

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
        return loops == null || loops.factor.work() > (long) FILL * loops.bonds.length ? null : loops;
    }

    private TieLoops(TieBonds those, int[] ids) {
        bodies = bodies(those, ids);
        sizes = Arrays.stream(bodies).mapToDouble(those::size).toArray();
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
        for (int p = 0; p < bonds.length; p++) {
            int o = TreeRows.STRIDE * bonds[p] + BLOCK * first[p];
            System.arraycopy(d, o + TreeRows.CHILD, j, J * p, 2 * BLOCK);
            System.arraycopy(d, o + TreeRows.PARENT, j, J * p + 2 * BLOCK, 2 * BLOCK);
            if (first[p] > 0) {
                Arrays.fill(j, J * p + BLOCK, J * p + 2 * BLOCK, 0);
                Arrays.fill(j, J * p + 3 * BLOCK, J * (p + 1), 0);
                factor.rest(p, j[J * p + 2] == 0); // a motor that slips, or has no part in places
            }
        }
        for (int k = 0; k < bodies.length; k++) {
            System.arraycopy(w, bodies[k], masses, BLOCK * k, BLOCK);
        }
        eliminate(null);
        if (factor.pivots.isBeside()) {
            judge(open);
            eliminate(even.pivots);
        }
    }

    private void eliminate(Pivots shares) {
        factor.pivots.obey(shares);
        assemble(factor, masses);
        factor.factor(0, Pivots.NOISE, true);
    }

    /** Finds which rows depend on others, or nearly so, whatever the masses are. */
    private void judge(double open) {
        even = even == null ? new BlockFactor(factor.start, factor.row, factor.rows, isAngle) : even;
        even.pivots.judge(Math.max(DEPENDENT, TIMES * open * open));
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

    /** Finds what the bodies are to get, so that rows have what they ask for. */
    void solve(double[] d) {
        for (int p = 0; p < bonds.length; p++) {
            int o = TreeRows.STRIDE * bonds[p] + TreeRows.ASKED + first[p];
            right[2 * p] = factor.rows(p) > 0 ? d[o] : 0;
            right[2 * p + 1] = factor.rows(p) > 1 ? d[o + 1] : 0;
        }
        factor.solve(right);
        apply(d);
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

    /** Whether the bodies would move by more than a part of their sizes, or turn by as much, if they moved by what they are to get. */
    boolean isFar(double part, double h) {
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
