// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

/**
 * Solves a {@link HeapSystem} whose bodies nothing ties: sweeps of relaxation say roughly what points bear, Newton's method
 * finds it exactly if they said which points are open, stuck, or slide, and else a path of solutions leads there. When that
 * gets lost, more sweeps give it a better start.
 */
final class HeapPile {
    /** Sweeps before each attempt; and before the only one when rough impulses will do. */
    private static final int[] SWEEPS = {20, 100, 300};

    private static final int[] ROUGH_SWEEPS = {60};

    private static final int NEWTON_STEPS = 4;
    private static final int ROUGH_NEWTON_STEPS = 1;

    /** Paths in turn, each of which takes from the last one's error what the softness of its springs leaves. */
    private static final int PATHS = 5;

    /** Part of the error that the next path has to leave at most. */
    private static final double LESS = 0.3;

    private final HeapPiece piece = new HeapPiece();
    private final HeapNewton newton = new HeapNewton(piece);
    private final HeapPath path = new HeapPath(piece);
    private final HeapRelaxation relaxation;

    /** Impulses of a start, and the best ones so far, 2 per point; and the error of these. */
    private double[] start = {};

    private double[] best = {};
    private double least;

    HeapPile(HeapRelaxation relaxation) {
        this.relaxation = relaxation;
    }

    /**
     * Improves the impulses of a system, and the velocities with them.
     *
     * @param exact error of velocities at which they are right
     * @param enough error at which the next attempt is not worth its while
     * @param isRough whether there are to be no paths
     * @return whether the error is not larger than one of these
     */
    boolean solve(HeapSystem s, double exact, double enough, boolean isRough) {
        piece.lay(s);
        newton.begin(s);
        path.begin(s);
        least = Double.POSITIVE_INFINITY;
        for (int sweeps : isRough ? ROUGH_SWEEPS : SWEEPS) {
            if (relaxation.conjugate(s, sweeps) <= exact) {
                return true;
            }
            start = s.impulses(start);
            note(s, newton.solve(s, exact, isRough ? ROUGH_NEWTON_STEPS : NEWTON_STEPS));
            if (least > exact && !isRough) {
                s.put(start);
                note(s, follow(s, exact));
            }
            if (least <= enough) {
                break;
            }
        }
        if (least > enough && !isRough && s.size() <= HeapSolver.MANY) {
            note(s, path.followFromNothing(s) ? follow(s, exact) : least);
        }
        s.put(best);
        return least <= enough;
    }

    private void note(HeapSystem s, double error) {
        if (!(error >= least)) {
            least = error;
            best = s.impulses(best);
        }
    }

    /** Follows paths until one leads nowhere; returns the error that is left. */
    private double follow(HeapSystem s, double exact) {
        double error = Double.POSITIVE_INFINITY;
        for (int k = 0; k < PATHS && path.follow(s); k++) {
            double last = error;
            error = newton.classify(s);
            if (error <= exact || error > LESS * last) {
                break;
            }
        }
        return error;
    }
}
