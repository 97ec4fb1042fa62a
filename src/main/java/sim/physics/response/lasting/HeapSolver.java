// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;

/**
 * Solves {@link HeapSystem}s: where ties reply as a matrix of all rows, by {@link HeapMatrix}; else by {@link HeapPile}. What
 * these leave is left to projected relaxation, one point after the other (projected Gauss-Seidel; Jean, <i>The non-smooth
 * contact dynamics method</i>, 1999), until nothing changes any more beyond rounding or the work is spent. Between the sweeps
 * the points that they leave closed or stuck are solved for as equations, by {@link HeapFace} or {@link HeapCorner}.
 */
final class HeapSolver implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int SWEEPS = 6;

    /** The same between eliminations. */
    private static final int FEW_SWEEPS = 2;

    private static final int LEAST_SWEEPS = 20;

    /** Points that are relaxed, over all sweeps. */
    private static final int WORK = 50_000;

    /** The work on one of several solutions in turn, where the last one need not be the best. */
    private static final int LITTLE_WORK = 1000;

    /**
     * Part of the work after which impulses are good enough whose points miss their least gap by little. Where flush edges
     * leave them open, in a row of boxes, bounds contradict each other by rounding, and impulses drift on and on.
     */
    private static final double ENDLESS = 0.1;

    /** Points that are solved by relaxation alone at most; times the error that is good enough which is so in a pile. */
    private static final int FEW = 2;

    private static final double LATE = 10;

    /** Points up to which paths of pivots are followed. */
    static final int MANY = 250;

    /** Change of velocity in a sweep, relative to the largest speed, at which the impulses are right. */
    private static final double RIGHT = 1e-13;

    /** The same at which they may start the next solution. */
    private static final double NEARLY = 1e-6;

    private final HeapRelaxation relaxation = new HeapRelaxation();
    private final HeapFace face = new HeapFace();
    private final HeapCorner corner = new HeapCorner();
    private boolean isEasy;
    private long done;

    /** Null until there is work for them; they keep nothing from one heap to the next, and are too large for checkpoints. */
    private transient HeapMatrix matrix;

    private transient HeapPile pile;

    HeapSolver() {
        // grows with the heaps
    }

    /** Whether the last solution, of bodies that nothing ties, was found at once. */
    boolean wasEasy() {
        return isEasy;
    }

    /** What has been done in a matrix since this was asked last, in multiplications. */
    long takeDone() {
        long taken = done;
        done = 0;
        return taken;
    }

    /** Takes note of what the matrix has done: checkpoints do not have it. */
    private boolean count(boolean result) {
        done += matrix.takeDone();
        return result;
    }

    /** Takes note that the points have changed. */
    void forget() {
        if (matrix != null) {
            matrix.forget();
        }
        if (pile != null) {
            pile.forget();
        }
    }

    /** Takes note that the last solution is none to begin the next one with. */
    void restart() {
        if (matrix != null) {
            matrix.restart();
        }
    }

    /**
     * Solves a system whose velocities are those without impulses, from the impulses that it has.
     *
     * @param scale speed beside which errors are judged
     * @param lax error of the impulses that it has at which these are left as they are
     * @param enough error that is good enough in the end
     * @return whether the impulses are right or nearly so
     */
    boolean solve(HeapSystem s, double scale, double lax, double enough) {
        if (hasMatrix(s)) {
            return count(matrix.solve(s, RIGHT * scale, lax, enough, scale));
        }
        s.applyAll();
        isEasy = true;
        if (s.tolerance().isRough()) {
            s.tolerance().setError(relaxation.relaxFairly(s));
            return true;
        }
        if (s.isSpared() && !s.isTied()) {
            return relax(s, scale, enough, LITTLE_WORK);
        }
        if (!s.isTied() && s.size() > FEW) {
            pile = pile == null ? new HeapPile(relaxation) : pile;
            double fair = s.tolerance().fair();
            double error = pile.solve(s, RIGHT * scale, LATE * enough, fair, scale);
            isEasy = pile.isEasy() && error <= LATE * enough;
            if (error <= Math.max(LATE * enough, fair)) {
                s.tolerance().setError(error <= LATE * enough ? 0 : error);
                return true;
            }
        }
        return relax(s, scale, enough, WORK);
    }

    /** Whether ties reply, and all rows fit into a matrix, which is assembled then. */
    private boolean hasMatrix(HeapSystem s) {
        if (!s.isTied()) {
            return false;
        }
        matrix = matrix == null ? new HeapMatrix() : matrix;
        return count(matrix.assemble(s));
    }

    /** Error of velocities with the impulses that the last solution was started from; infinite if that is not known. */
    double missed(HeapSystem s) {
        return hasMatrix(s) ? matrix.missed() : Double.POSITIVE_INFINITY;
    }

    /** Speed that the last impulses would give bodies which nothing tied, if together they do next to nothing beside that; else 0. */
    double strain() {
        return matrix == null ? 0 : matrix.strain();
    }

    /** Whether impulses of bodies that are tied have jammed since the points changed. */
    boolean jams() {
        return matrix != null && matrix.jams();
    }

    /** The same of points that are a little soft, where there are no bounded impulses, or none are found, that make them right. */
    boolean solveSoftly(HeapSystem s, double scale, double enough) {
        if (hasMatrix(s)) {
            return count(matrix.solveSoftly(s, RIGHT * scale, scale));
        }
        return solve(s, scale, 0, enough);
    }

    /** The same with little work. */
    boolean solveInTurn(HeapSystem s, double scale, double enough) {
        if (hasMatrix(s)) {
            return count(matrix.solve(s, RIGHT * scale, 0, enough, scale));
        }
        s.applyAll();
        return relax(s, scale, enough, LITTLE_WORK);
    }

    private boolean relax(HeapSystem s, double scale, double enough, int work) {
        int left = Math.max(LEAST_SWEEPS, work / Math.max(1, s.size()));
        int late = (int) ((1 - ENDLESS) * left);
        int corners = work == LITTLE_WORK && !s.isTied() && s.size() <= HeapCorner.MOST ? HeapCorner.ROUNDS : 0;
        while (left > 0) {
            double nothing = left < late ? Math.max(enough, RIGHT * scale) : RIGHT * scale;
            if (relaxation.sweep(s, corners > 0 ? FEW_SWEEPS : SWEEPS, nothing) <= nothing) {
                return true;
            }
            left -= corners-- > 0 ? corner.solve(s) : SWEEPS + face.solve(s, RIGHT * scale);
        }
        double error = relaxation.sweep(s, 1, 0);
        s.tolerance().setError(error);
        return error <= NEARLY * scale;
    }
}
