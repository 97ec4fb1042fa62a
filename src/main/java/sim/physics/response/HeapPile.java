// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

/**
 * Solves a {@link HeapSystem} whose bodies nothing ties: sweeps of relaxation say roughly what points bear, Newton's method
 * finds it exactly if they said which points are open, stuck, or slide, and else a path of solutions leads there. When that
 * gets lost, more sweeps give it a better start.
 */
final class HeapPile {
    /** Sweeps before each attempt. */
    private static final int[] SWEEPS = java.util.Arrays.stream(System.getProperty("sw","4,20,80,180").split(",")).mapToInt(Integer::parseInt).toArray();

    private static final int NEWTON_STEPS = 4;

    /** Paths in turn, each of which takes from the last one's error what the softness of its springs leaves. */
    private static final int PATHS = 5;

    /** Part of the error that the next path has to leave at most. */
    private static final double LESS = 0.3;

    private final HeapPiece piece = new HeapPiece();
    private final HeapNewton newton = new HeapNewton(piece);
    private final HeapPath path = new HeapPath(piece);

    /** Impulses of a start, 2 per point. */
    private double[] start = {};

    private final HeapRelaxation relaxation;

    HeapPile(HeapRelaxation relaxation) {
        this.relaxation = relaxation;
    }

    /**
     * Improves the impulses of a system, and the velocities with them.
     *
     * @param exact error of velocities at which they are right
     * @param enough error at which the next attempt is not worth its while
     * @return whether the error is not larger than one of these
     */
    boolean solve(HeapSystem s, double exact, double enough) {
        piece.lay(s);
        newton.begin(s);
        path.begin(s);
        for (int sweeps : SWEEPS) {
            if (relaxation.conjugate(s, sweeps) <= exact) {
                return true;
            }
            start = s.impulses(start);
            if (newton.solve(s, exact, NEWTON_STEPS) <= exact) {
                return true;
            }
            s.put(start);
            if (follow(s, exact) <= enough) {
                return true;
            }
        }
        return false;
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
