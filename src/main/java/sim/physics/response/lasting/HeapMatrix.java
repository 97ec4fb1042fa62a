// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.util.Arrays;

/**
 * Solves a {@link HeapSystem} of not too many rows as a whole, where ties reply: each row's impulse moves all others then, so
 * that a matrix of what they do to one another costs no more than bodies do, and sweeps over it cost little. Sweeps of
 * projected relaxation guess which rows are at a bound; the others are equations, which are solved by elimination, friction
 * that slides following its normal impulse (a Newton method on the natural map of the problem: Alart and Curnier 1991). What
 * turns out to be at another bound is put there. If that is not the end of it, which in larger heaps may run in circles, a path leads there
 * ({@link MatrixPath}).
 *
 * <p>Where impulses are not unique, the system is made a little heavier on its diagonal, and refined until that has no
 * effect: of all changes that do the same, about the smallest is taken.
 */
final class HeapMatrix extends HeapRows {
    private static final long serialVersionUID = 1L;

    private static final int REFINEMENTS = 3;

    /** Rounds of sweeps and Newton's method where there is no path. */
    private static final int ROUNDS = 3;

    /** How many times larger an error is, at most, of which sweeps make none. */
    private static final double CLOSE = 1000;

    /** The same of one that is left by the rounding of eliminations. */
    private static final double ROUNDING = 100;

    /** Sweeps before the path, and without one. */
    private static final int FEW = 6;
    private static final int SWEEPS = 30;

    /** Steps of Newton's method in a round, and those in a row that may be in vain. */
    private static final int NEWTON_STEPS = 12;

    private static final int VAIN = 3;

    /** How often the end of a path is made better. */
    private static final int PROXIMAL = 3;

    /** Error at which the impulses may start the next solution, as a part of the scale. */
    private static final double NEARLY = 1e-6;

    /** By how much softer than stiff points are, relative to what an impulse does to them. */
    private static final double SOFT = 0x1p-10;

    /** By how much of that those are stiffer which are tried next where impulses jam, and the stiffest. */
    private static final double STIFFER = 0x1p-5;

    private static final double STIFF = 0x1p-30;

    /** Speed beside which a motor's or friction's is that of one which holds, relative to the scale. */
    private static final double HARDLY = 1e-3;

    /** What impulses do together, as a part of what each does alone, where they jam; and what those are relative to others that are much less. */
    private static final double JAMMED = 1e-3;

    private static final double LESS = 0.25;
    private static final double ALIKE = 4;

    /** Multiplications in the time in which a row's impulse is put between its bounds. */
    private static final int BOUNDED = 8;

    /** Speed that impulses give to bodies alone, relative to what speeds are. */
    private static final double ABSURD = 1e4;

    /** Impulses that jam, others in place of these, and whether there were any. */
    private double[] strong = {};

    private double[] mild = {};
    private boolean jams;

    /** By rows: what a unit does there while points give way, without that. */
    private double[] stiff = {};

    /** Whether points are a little soft. */
    private boolean isSoft;

    /** The bound at which a row is, −1 or +1, 0 for none. */
    private double[] side = {};

    /** The equations. */
    private int[] unknown = {};

    private final ContactEquations equations = new ContactEquations(true, REFINEMENTS);
    private final ConjugateSweeps sweeps = new ConjugateSweeps();
    private double[] rest = {};

    /** Null until there is work for it. */
    private MatrixPath path;

    /** Error of velocities with the impulses that the last solution was started from. */
    private double missed;

    /** Speed that its impulses would give bodies which nothing tied, if together they do next to nothing beside that; else 0. */
    private double strain;

    @Override
    void forget() {
        super.forget();
        jams = false;
        strain = 0;
        restart();
    }

    /** Takes note that the last solution is none to begin the next one with. */
    void restart() {
        if (path != null) {
            path.forget();
        }
    }

    @Override
    void grow(int n) {
        side = new double[n];
        unknown = new int[n];
        rest = new double[n];
        strong = new double[n];
        mild = new double[n];
        stiff = new double[n];
        equations.ensure(n);
    }

    /**
     * Solves for the impulses, from those that the system has; its velocities are those without any.
     *
     * @param exact error of velocities at which they are right
     * @param lax error of those that the system has at which these are left as they are
     * @param enough error that is good enough in the end
     * @param scale speed beside which errors are judged
     * @return whether they are right or nearly so
     */
    boolean solve(HeapSystem s, double exact, double lax, double enough, double scale) {
        take(s);
        double close = Math.max(enough, ROUNDING * exact);
        double least = keep(Double.POSITIVE_INFINITY);
        missed = least;
        if (least > Math.max(exact, lax)) {
            least = newton(afresh(least, scale), exact, 1); // impulses of before may be at the same bounds
            if (least > exact) {
                restore();
                least = newton(relax(least <= CLOSE * exact ? FEW : 1, least), exact, 1);
            }
        }
        if (least > ROUNDING * exact) {
            least = follow(least, exact, close);
        }
        for (int round = 0; round < ROUNDS && least > close; round++) {
            restore();
            least = newton(relax(SWEEPS, least), exact, VAIN);
        }
        double together = together();
        jams |= together < JAMMED * squares(best); // they press against one another
        if (together < JAMMED * load(best)) {
            double fair = isSoft ? Math.max(close, NEARLY * scale) : close;
            least = loosen(least, exact, fair, isAbsurd(s, scale));
        }
        strain = together() < JAMMED * load(best) ? fastestAlone(best) : 0;
        give(s);
        return least <= NEARLY * scale;
    }

    /**
     * The same of a system that is heavier on its diagonal, as if points were a little soft: there are always impulses for that which no
     * lever makes large, and if no point has to part they give no energy.
     *
     * @return whether they are right, or nearly so, for what is that soft
     */
    boolean solveSoftly(HeapSystem s, double exact, double scale) {
        restart();
        for (int i = 0; i < rows; i++) {
            replies[i * rows + i] *= 1 + SOFT;
        }
        isSoft = true;
        boolean right = solve(s, exact, 0, 0, scale);
        isSoft = false;
        for (int i = 0; i < rows; i++) {
            replies[i * rows + i] /= 1 + SOFT;
        }
        restart();
        return right;
    }

    /** What the best impulses do together, as a square. */
    private double together() {
        restore();
        double sum = 0;
        for (int i = 0; i < rows; i++) {
            sum += impulse[i] * (velocity[i] - without[i]);
        }
        return sum;
    }

    /** The greatest speed that one of some impulses would give if nothing tied the bodies. */
    private double fastestAlone(double[] impulses) {
        double most = 0;
        for (int i = 0; i < rows; i++) {
            most = impulses[i] == 0 ? most : Math.max(most, Math.abs(impulses[i]) * alone(i));
        }
        return most;
    }

    /** Whether they would make bodies so fast that nothing ties that no lever makes so much of how fast they are. */
    private boolean isAbsurd(HeapSystem s, double scale) {
        double most = 0;
        for (int p = 0; p < s.contacts(); p++) {
            most = normal[p] < 0 ? most : Math.max(most, impulse[normal[p]] * s.rows().normalMobility(p, s.w));
        }
        return most > ABSURD * scale;
    }

    /** What each of some impulses does by itself, as a square. */
    private double squares(double[] impulses) {
        double sum = 0;
        for (int i = 0; i < rows; i++) {
            sum += impulses[i] == 0 ? 0 : own(i) * impulses[i] * impulses[i];
        }
        return sum;
    }

    /** The same if nothing tied the bodies. */
    private double load(double[] impulses) {
        double sum = 0;
        for (int i = 0; i < rows; i++) {
            sum += impulses[i] == 0 ? 0 : alone(i) * impulses[i] * impulses[i];
        }
        return sum;
    }

    /**
     * Looks for impulses that are about as good and much less. Where friction locks a point whose normal ties hardly let move any amount
     * holds, as a wedge does; and sweeps make it larger and larger, until the slightest motion would throw the bodies about. What is the least is
     * judged by what impulses would do to the bodies alone: along the normal of such a point ties make them do next to nothing, so that
     * by what they do with these a thousand times of what friction needs would cost no more than friction itself.
     *
     * @param fair error with which impulses are about as good, if those at hand have a smaller one
     */
    private double loosen(double least, double exact, double fair, boolean isAbsurd) {
        System.arraycopy(best, 0, strong, 0, rows);
        double strength = load(strong);
        double good = ALIKE * Math.max(fair, least);
        double found = Double.POSITIVE_INFINITY;
        for (double soft = SOFT; soft >= STIFF && !(found <= good); soft *= STIFFER) {
            double error = giveWay(soft, exact, fair);
            if (ALIKE * error < found && load(best) < LESS * strength) {
                System.arraycopy(best, 0, mild, 0, rows);
                found = error;
            }
        }
        boolean isTaken = found <= good || isAbsurd && found < Double.POSITIVE_INFINITY;
        System.arraycopy(isTaken ? mild : strong, 0, best, 0, rows);
        return isTaken ? found : least;
    }

    /**
     * Solves from no impulses with points that give way as bodies would that nothing ties, by a part of that; returns the error that the impulses have
     * where none does.
     */
    private double giveWay(double part, double exact, double close) {
        restart();
        for (int i = 0; i < rows; i++) {
            stiff[i] = own(i);
            replies[i * rows + i] += part * alone(i);
        }
        Arrays.fill(impulse, 0, rows, 0);
        evaluate();
        follow(newton(keep(Double.POSITIVE_INFINITY), exact, 1), exact, close);
        for (int i = 0; i < rows; i++) {
            replies[i * rows + i] = stiff[i];
        }
        restart();
        restore();
        return keep(Double.POSITIVE_INFINITY);
    }

    double missed() {
        return missed;
    }

    double strain() {
        return strain;
    }

    /** Whether impulses have pressed against one another since what the rows do has changed. */
    boolean jams() {
        return jams;
    }

    /** Newton's method, until some steps were in vain; returns the least error so far. */
    private double newton(double error, double exact, int most) {
        double least = error;
        int vain = 0;
        for (int k = 0; k < NEWTON_STEPS && least > exact && vain < most && newton(); k++) {
            double before = least;
            least = keep(least);
            vain = least < before ? 0 : vain + 1;
        }
        return least;
    }

    /** Relaxes by sweeps along conjugate directions; returns the least error so far. */
    private double relax(int times, double least) {
        double best = least;
        sweeps.begin(rows);
        for (int k = 0; k < times; k++) {
            System.arraycopy(impulse, 0, sweeps.before, 0, rows);
            sweep();
            double square = 0;
            for (int i = 0; i < rows; i++) {
                double change = sweeps.change(i, impulse[i]);
                square += change * change * own(i);
            }
            best = keep(best);
            boolean goesOn = sweeps.goesOn(square);
            for (int i = 0; i < rows; i++) {
                impulse[i] += sweeps.more(i);
            }
            if (goesOn) {
                evaluate();
            }
        }
        return best;
    }

    /** The impulse that makes a row right while others keep theirs, within its bounds. */
    private double wanted(int row) {
        double free = impulse[row] - (velocity[row] - bound[row]) / own(row);
        return Math.max(lower(row), Math.min(upper(row), free));
    }

    private void sweep() {
        count((long) BOUNDED * rows);
        for (int i = 0; i < rows; i++) {
            set(i, wanted(i));
            if (against[i] >= 0) {
                settle(i, against[i]);
            }
        }
    }

    /**
     * Finds the impulses of a stop and of the motor of its coordinate together. One after the other they would yield to each
     * other by little in each sweep, since both can be strong and what they move light.
     */
    private void settle(int stop, int motor) {
        double both = replies[stop * rows + motor];
        double alone = velocity[stop] - own(stop) * impulse[stop] - both * impulse[motor];
        double target = bound[motor] * both / own(motor);
        double force = Math.max(least[motor], Math.min(most[motor], (target - alone) / both));
        double missing = bound[stop] - (alone + both * force);
        if (missing > 0 && target < bound[stop]) { // the motor drives it against the stop, as strongly as it can
            force = both > 0 ? least[motor] : most[motor];
            missing = bound[stop] - (alone + both * force);
        }
        set(stop, Math.max(0, missing / own(stop)));
        set(motor, force);
    }

    /** Keeps the impulses if they are the best so far; returns the least error of velocities so far. */
    private double keep(double before) {
        count((long) BOUNDED * rows);
        double worst = 0;
        for (int i = 0; i < rows; i++) {
            worst = Math.max(worst, Math.abs(wanted(i) - impulse[i]) * own(i));
        }
        if (!(worst < before)) {
            return before;
        }
        System.arraycopy(impulse, 0, best, 0, rows);
        return worst;
    }

    private void restore() {
        System.arraycopy(best, 0, impulse, 0, rows);
        evaluate();
    }

    /**
     * Solves the rows that are at no bound with the impulses at hand, or hardly at one, for the least impulses: what presses against one
     * another without any effect is not carried on, and grows in no direction. Returns the least error so far.
     */
    private double afresh(double error, double scale) {
        int n = part(HARDLY * scale);
        for (int i = 0; i < rows; i++) {
            impulse[i] = unknown[i] >= 0 ? 0 : impulse[i];
        }
        evaluate();
        double least = solve(n) ? keep(error) : error;
        restore();
        return least;
    }

    /** Solves the rows that are at no bound as equations; false if they cannot be solved. */
    private boolean newton() {
        return solve(part(0));
    }

    /** Tells the rows that are at no bound from the others; given a speed that is none where both bounds are apart. Returns how many. */
    private int part(double none) {
        int n = 0;
        for (int i = 0; i < rows; i++) {
            double over = velocity[i] - bound[i];
            double free = impulse[i] - over / own(i);
            double up = bearer[i] < 0 ? most[i] : friction[i] * Math.max(0, rest[bearer[i]]);
            double down = bearer[i] < 0 ? least[i] : -up;
            boolean isBetween = free > down && free < up || up < Double.POSITIVE_INFINITY && Math.abs(over) < none;
            boolean isFree = isBetween && (bearer[i] < 0 || unknown[bearer[i]] >= 0);
            rest[i] = free;
            unknown[i] = isFree ? n++ : -1;
            side[i] = isFree ? 0 : free <= down ? -1 : 1;
        }
        return n;
    }

    private boolean solve(int n) {
        for (int i = 0; i < rows; i++) {
            set(i, bearer[i] >= 0 || unknown[i] >= 0 ? impulse[i] : side[i] < 0 ? least[i] : most[i]);
        }
        slide(true);
        assemble(n);
        count((long) BOUNDED * rows + (long) rows * rows + equations.cost(n));
        if (!equations.solve(n)) {
            return false;
        }
        for (int i = 0; i < rows; i++) {
            impulse[i] += unknown[i] >= 0 ? equations.solution(unknown[i]) : 0;
        }
        slide(false);
        evaluate();
        return true;
    }

    /** Goes to the end of a path, first of one from the end of the last one; returns the least error so far. */
    private double follow(double least, double exact, double enough) {
        path = path == null ? new MatrixPath() : path;
        double error = path.resume(this, side) ? refine(least, exact) : least;
        return error > enough && path.follow(this, side) ? refine(error, exact) : error;
    }

    private double refine(double least, double exact) {
        double error = least;
        int left = PROXIMAL;
        do {
            evaluate();
            error = keep(error);
        } while (error > exact && left-- > 0 && path.refine(side));
        return error;
    }

    /** Lets friction that slides follow what bears it. */
    private void slide(boolean pushes) {
        for (int i = 0; i < rows; i++) {
            if (bearer[i] >= 0 && unknown[i] < 0) {
                double next = side[i] * friction[i] * impulse[bearer[i]];
                if (pushes) {
                    push(i, next - impulse[i]);
                }
                impulse[i] = next;
            }
        }
    }

    private void set(int row, double value) {
        push(row, value - impulse[row]);
        impulse[row] = value;
    }

    private void assemble(int n) {
        for (int j = 0; j < rows; j++) {
            int column = unknown[j];
            for (int i = 0; column >= 0 && i < rows; i++) {
                if (unknown[i] >= 0) {
                    equations.set(unknown[i] * n + column, replies[j * rows + i]);
                }
            }
        }
        for (int j = 0; j < rows; j++) {
            int column = bearer[j] >= 0 && unknown[j] < 0 ? unknown[bearer[j]] : -1;
            for (int i = 0; column >= 0 && i < rows; i++) {
                if (unknown[i] >= 0) {
                    equations.add(unknown[i] * n + column, side[j] * friction[j] * replies[j * rows + i]);
                }
            }
        }
        for (int i = 0; i < rows; i++) {
            if (unknown[i] >= 0) {
                equations.setRight(unknown[i], bound[i] - velocity[i], own(i));
            }
        }
    }
}
