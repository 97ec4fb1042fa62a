// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

/**
 * What each point of a {@link HeapSystem} is taken to do, and the equations for velocities which that makes. A closed point is
 * a stiff spring along its normal; along its tangent it is one too, or slides, and then pushes with its friction:
 *
 * <pre>
 *   M + Pᵀ D C
 * </pre>
 *
 * <p>with the rows C of what may not move, the directions P in which points push, and the stiffnesses D. Impulses need not be
 * unique, as more points may touch than bodies can move; velocities are, and who touches whom is all that this couples.
 */
final class HeapPiece {
    /** How soft a contact is, relative to what moves it. */
    static final double SOFT = 1e-8;

    final BodyMatrix matrix = new BodyMatrix();

    /** By point: whether it is closed; and the sign with which it slides, 0 if it is stuck or cannot rub. */
    boolean[] isClosed = {};

    double[] slides = {};

    /** By point: the block of its two bodies. */
    private int[] block = {};

    HeapPiece() {
        // grows with the heaps
    }

    /** Lays out the equations of a system. */
    void lay(HeapSystem s) {
        int n = s.size();
        if (block.length < n) {
            block = new int[2 * n];
            isClosed = new boolean[2 * n];
            slides = new double[2 * n];
        }
        matrix.begin(s.bodyCount());
        for (int p = 0; p < n; p++) {
            if (!s.rows().isOnFixed(p)) {
                matrix.touch(s.rows().body(p, 0), s.rows().body(p, 1));
            }
        }
        matrix.lay();
        for (int p = 0; p < n; p++) {
            block[p] = s.rows().isOnFixed(p) ? 0 : matrix.block(s.rows().body(p, 0), s.rows().body(p, 1));
        }
    }

    /** Whether a point does not move along its tangent. */
    boolean isStuck(HeapSystem s, int p) {
        return isClosed[p] && slides[p] == 0 && s.friction(p) > 0;
    }

    /** Stiffness of a closed point along its normal. */
    static double normalStiffness(HeapSystem s, int p) {
        return 1 / (SOFT * s.normalMobility(p));
    }

    /** The same along its tangent if it is stuck. */
    static double tangentStiffness(HeapSystem s, int p) {
        return 1 / (SOFT * s.tangentMobility(p));
    }

    /** The impulse along the tangent of one along the normal when a point slides. */
    double rub(HeapSystem s, int p) {
        return slides[p] * s.friction(p);
    }

    /** Sets the equations up and eliminates them; false if they cannot be solved. */
    boolean factor(HeapSystem s) {
        assemble(s);
        return matrix.factor();
    }

    /** The same when only one point has changed since. */
    boolean refactor(HeapSystem s, int p) {
        if (isClosed[p]) {
            assemble(s, p, 1);
        }
        for (int side = 0; side < 2; side++) {
            if (s.rows().body(p, side) >= 0) {
                matrix.touchUp(s.rows().body(p, side));
            }
        }
        return matrix.refactor();
    }

    /** Takes what a point does out of the equations, before it does something else. */
    void leave(HeapSystem s, int p) {
        if (isClosed[p]) {
            assemble(s, p, -1);
        }
    }

    private void assemble(HeapSystem s) {
        matrix.clear(s.w);
        for (int p = 0; p < s.size(); p++) {
            if (isClosed[p]) {
                assemble(s, p, 1);
            }
        }
    }

    private void assemble(HeapSystem s, int p, double times) {
        double along = isStuck(s, p) ? times * tangentStiffness(s, p) : 0;
        double normal = times * normalStiffness(s, p);
        assemble(s, p, normal, rub(s, p) * normal, along);
    }

    /**
     * Adds what a point does whose impulses answer to its velocities: the normal one to that along the normal, the tangential
     * one to both.
     */
    void assemble(HeapSystem s, int p, double nn, double tn, double tt) {
        PointRows rows = s.rows();
        double nx = rows.nx(p);
        double ny = rows.ny(p);
        for (int side = 0; side < 2; side++) {
            if (rows.body(p, side) >= 0) {
                double sign = side == 0 ? -1 : 1;
                double arm = sign * rows.arm(p, side);
                double lever = sign * rows.lever(p, side);
                double x = sign * nx;
                double y = sign * ny;
                add(rows, p, side, nn * x - tn * y, nn * y + tn * x, nn * lever + tn * arm, nx, ny, false);
                if (tt != 0) {
                    add(rows, p, side, -tt * y, tt * x, tt * arm, -ny, nx, true);
                }
            }
        }
    }

    /** Adds the products of a side's column with the rows of both sides. */
    private void add(PointRows rows, int p, int side, double cx, double cy, double ct, double x, double y, boolean along) {
        for (int other = 0; other < 2; other++) {
            int body = rows.body(p, other);
            if (body < 0) {
                continue;
            }
            double sign = other == 0 ? -1 : 1;
            double lever = sign * (along ? rows.arm(p, other) : rows.lever(p, other));
            if (other == side) {
                matrix.add(body, cx, cy, ct, sign * x, sign * y, lever);
            } else {
                matrix.addBeyond(side == 0 ? block[p] : ~block[p], cx, cy, ct, sign * x, sign * y, lever);
            }
        }
    }
}
