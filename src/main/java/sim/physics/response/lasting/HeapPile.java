// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

/**
 * Solves a {@link HeapSystem} whose bodies nothing ties: sweeps of relaxation say roughly what points bear, and Newton's method
 * finds it exactly if they said which points are open, stuck, or slide. Else the central path says that, or a path of solutions
 * gets there, or more sweeps give a better start.
 */
final class HeapPile {
    /** Sweeps before each attempt. */
    private static final int[] SWEEPS = {20, 100, 300};

    private static final int NEWTON_STEPS = 4;

    /** Points up to which central paths have to do with the second attempt only, since paths of pivots are cheaper then. */
    private static final int SMALL = 100;

    /** Paths in turn, each of which takes from the last one's error what the softness of its springs leaves. */
    private static final int PATHS = 5;

    /** Part of the error that the next path has to leave at most. */
    private static final double LESS = 0.3;

    /** Error, relative to the largest speed, as of which central paths begin at least. */
    private static final double OFF = 1e-3;

    private final HeapPiece piece = new HeapPiece();
    private final HeapNewton newton = new HeapNewton(piece);
    private final HeapPath path = new HeapPath(piece);
    private final CentralPath central = new CentralPath(piece);
    private final HeapRelaxation relaxation;

    /** Impulses of a start, and the best ones so far, 2 per point; and the error of these. */
    private double[] start = {};

    private double[] best = {};
    private double least;

    private boolean isEasy;

    /** Points for which the equations are laid out, 0 for none. */
    private int laid;

    HeapPile(HeapRelaxation relaxation) {
        this.relaxation = relaxation;
    }

    /**
     * Improves the impulses of a system, and the velocities with them.
     *
     * @param exact error of velocities at which they are right
     * @param enough error at which the next attempt is not worth its while
     * @param fair error at which other attempts are not
     * @param speed of the bodies
     * @return the error
     */
    double solve(HeapSystem s, double exact, double enough, double fair, double speed) {
        begin(s);
        if (s.tolerance().isNear() && goOn(s, exact, enough)) {
            return least;
        }
        boolean isBrief = s.tolerance().isBrief();
        for (int sweeps : SWEEPS) {
            if (relaxation.conjugate(s, sweeps) <= exact) {
                return 0;
            }
            start = s.impulses(start);
            note(s, newton.solve(s, exact, NEWTON_STEPS));
            isEasy &= least <= enough;
            if (least > enough && isCentral(s, sweeps) && !goCentrally(s, exact, OFF * speed, speed)) {
                goCentrally(s, exact, speed, speed);
            }
            if (least > enough && s.size() <= HeapSolver.MANY) {
                s.put(start);
                note(s, follow(s, exact));
            }
            if (least <= enough || least <= fair && s.size() > HeapSolver.MANY || isBrief && sweeps > SWEEPS[0]) {
                break;
            }
        }
        if (least > Math.max(enough, fair) && s.size() <= HeapSolver.MANY && !isBrief) {
            note(s, path.followFromNothing(s) ? follow(s, exact) : least);
        }
        s.put(best);
        return least;
    }

    /** Takes note that the points have changed. */
    void forget() {
        laid = 0;
    }

    private void begin(HeapSystem s) {
        if (!s.tolerance().isNear() || laid != s.size()) {
            piece.lay(s);
            newton.begin(s);
            path.begin(s);
            central.begin(s);
            laid = s.size();
        }
        least = Double.POSITIVE_INFINITY;
        isEasy = true;
    }

    /** Goes on from impulses that are nearly right: most points do what they did. If what it finds is not right, they are as before. */
    private boolean goOn(HeapSystem s, double exact, double enough) {
        start = s.impulses(start);
        note(s, newton.solve(s, exact, NEWTON_STEPS));
        if (least > exact) {
            s.put(start);
            note(s, path.followShortly(s) ? newton.solve(s, exact, NEWTON_STEPS) : least);
        }
        s.put(least <= enough ? best : start);
        return least <= enough;
    }

    /** Whether the first attempt of the last solution was enough, without any path. */
    boolean isEasy() {
        return isEasy;
    }

    /** Whether an attempt is to do with central paths, once: from another start they seldom get farther, and then it takes long. */
    private static boolean isCentral(HeapSystem s, int sweeps) {
        return sweeps == SWEEPS[s.size() <= SMALL ? 1 : 0];
    }

    /** Goes along the central path from the impulses of the start; false if it is blocked. */
    private boolean goCentrally(HeapSystem s, double exact, double off, double speed) {
        s.put(start);
        boolean free = central.follow(s, Math.max(off, Math.min(speed, newton.classify(s))));
        note(s, newton.solve(s, exact, NEWTON_STEPS));
        return free;
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
