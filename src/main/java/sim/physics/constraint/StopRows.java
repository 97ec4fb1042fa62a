// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.internal.Freshness;
import sim.physics.internal.OpenGroups;
import sim.physics.internal.Softness;
import sim.physics.motion.State;

/**
 * Stops as time stepping solves them. In a substep they are rows among others. At its end, those that have been struck in it are solved for
 * what they gave in all of it, in turn with the joints and contacts of their bodies: first until nothing goes on into them, then until they part at
 * the speed that restitution asks for. A stop alone does not know what joints make of its impulse, and an impact has no second substep.
 */
public final class StopRows implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int ROWS = Equations.ROWS;

    /** When an impulse has settled, relative to itself. */
    private static final double SETTLED = 1e-6;

    /** Way in a step, relative to the size of a body or in rad, of speeds that are no rounding. */
    private static final double LEAST = 1e-9;

    /** How many times faster than what it bears makes it in a step something is that strikes a stop on which it lies. */
    private static final double LIES = 2;

    private final State state;
    private final TieEquations equations;
    private final HeldMotors held;
    private final TurningRows turning;

    /** The stops of bodies that are awake: their places among the constraints. */
    private int[] places = {};

    private int count;
    private boolean bounces;

    /** By stop: whether its strikes are impacts. Of ropes alone each is right as soon as it is solved, if it gives nothing back. */
    private boolean[] areImpacts = {};

    /** Impulses of the substep, of all constraints. */
    private double[] impulse = {};

    /** Two per stop, for its lower and its upper bound: impulses with which the step began, those of the substep, and the speeds of strikes. */
    private double[] loads = {};

    private double[] sums = {};
    private double[] strikes = {};

    /** What each gives back at least, once restitution has begun. */
    private double[] least = {};

    /** By stop, before the substep: coordinate and its speed, and the last two accelerations while nothing pressed or struck. */
    private double[] coordinate = {};

    private double[] speed = {};
    private double[] gain = {};
    private double[] gainBefore = {};

    /** By stop: whether something has struck in its group in this substep. */
    private boolean[] areShaken = {};

    private double h;

    /** The stops that have part in what has met, as 2 × stop + bound; and whether each is the only one in its group that is struck. */
    private int[] met = {};

    private boolean[] areAlone = {};
    private int metCount;

    /** By bound: when it was solved last; see {@link Freshness}. */
    private long[] solved = {};

    StopRows(State state, TieEquations equations, HeldMotors held, TurningRows turning) {
        this.state = state;
        this.equations = equations;
        this.held = held;
        this.turning = turning;
    }

    /**
     * Takes the stops among the constraints, whose impulses are these.
     *
     * @param jointed bodies with joints
     */
    void gather(double[] impulses, boolean[] jointed) {
        impulse = impulses;
        places = new int[equations.count()];
        count = 0;
        bounces = false;
        for (int k = 0; k < equations.count(); k++) {
            if (equations.kinds[k] == TieEquations.Kind.STOP) {
                places[count++] = k;
                bounces |= stop(count - 1).getRestitution() > 0;
            }
        }
        loads = new double[2 * count];
        sums = new double[2 * count];
        strikes = new double[2 * count];
        least = new double[2 * count];
        solved = new long[2 * count];
        coordinate = new double[count];
        speed = new double[count];
        gain = new double[count];
        gainBefore = new double[count];
        areShaken = new boolean[count];
        met = new int[2 * count];
        areAlone = new boolean[2 * count];
        areImpacts = new boolean[count];
        for (int s = 0; s < count; s++) {
            areImpacts[s] = stop(s).getRestitution() > 0 || equations.isMarked(places[s], jointed);
        }
        metCount = 0;
    }

    private Limit stop(int s) {
        return (Limit) equations.ties[places[s]];
    }

    /** Begins a step, of substeps h. */
    void begin(double substep) {
        h = substep;
        for (int s = 0; s < count; s++) {
            int k = places[s];
            loads[2 * s] = impulse[ROWS * k];
            loads[2 * s + 1] = impulse[ROWS * k + 1];
            coordinate[s] = equations.c[ROWS * k];
            speed[s] = areImpacts[s] ? equations.speed(k, 0, state.v()) : 0;
        }
    }

    /**
     * Whether something may be struck in the step, which has begun. Where stops bounce, what strikes may have got its speed in the step itself.
     *
     * @param step its length
     * @return whether that may be
     */
    public boolean mayStrike(double step) {
        boolean may = bounces;
        for (int m = 0; !may && m < 2 * count; m++) {
            may = isFast(m, step) && gap(m) < 2 * step * toward(m);
        }
        return may;
    }

    private static int sign(int m) {
        return (m & 1) == 0 ? 1 : -1;
    }

    /** The way to a bound. */
    private double gap(int m) {
        double q = coordinate[m / 2];
        return sign(m) > 0 ? q - stop(m / 2).getLower() : stop(m / 2).getUpper() - q;
    }

    /** The speed towards a bound. */
    private double toward(int m) {
        return -sign(m) * speed[m / 2];
    }

    /** The acceleration towards it, with all that ties the bodies; the smaller one of the last two, as a contact may have struck in one of them. */
    private double pull(int m) {
        double first = -sign(m) * gain[m / 2];
        double second = -sign(m) * gainBefore[m / 2];
        return first > 0 ? Math.min(first, Math.max(0, second)) : Math.max(first, Math.min(0, second));
    }

    /** Whether it comes faster than forces make it in a step: the same, in reverse, brings it back within the next ones. */
    private boolean isFast(int m, double step) {
        int k = places[m / 2];
        double inverse = equations.inverse[ROWS * ROWS * k];
        double borne = loads[m] > 0 ? LIES * loads[m] / (inverse * h) : 0;
        return areImpacts[m / 2] && toward(m) > step * Math.max(borne, pull(m)) && toward(m) * step > LEAST * equations.limited(k, 0, Double.POSITIVE_INFINITY);
    }

    /** Solves a stop once: what is left of the way may be gone in the substep, what is beyond it is regained. */
    void solve(int k, Softness softness, double substep) {
        Limit stop = (Limit) equations.ties[k];
        double q = equations.c[ROWS * k];
        bound(k, 0, q - stop.getLower(), 1, softness, substep);
        bound(k, 1, stop.getUpper() - q, -1, softness, substep);
    }

    private void bound(int k, int side, double gap, int sign, Softness softness, double substep) {
        int o = ROWS * k + side;
        double old = impulse[o];
        if (gap == Double.POSITIVE_INFINITY || gap > 0 && old == 0 && softness.rate() == 0 && comesToRest(k)) {
            return; // as a substep ends, what is open is free: the next one ends its way
        }
        double pressed = old > 0 ? held.pressed(k, sign, softness.rate() * gap, impulse) : 0;
        double now = sign * turning.speed(k, softness.rate() > 0);
        boolean isOpen = gap > 0 && pressed <= old; // else a motor holds it there, a little off the bound, as a joint would
        double aim = isOpen ? gap / substep : softness.rate() * equations.limited(k, 0, gap);
        aim += softness.rate() > 0 ? sign * equations.bend[ROWS * k] : 0;
        double mass = isOpen ? 1 : softness.mass();
        double back = isOpen ? 0 : softness.impulse();
        double given = old - mass * equations.inverse[ROWS * ROWS * k] * (now + aim) - back * (old - pressed);
        given = given > 0 ? given : 0;
        if (given > 0 || old > 0) { // else it is free, as stops mostly are
            turning.push(k, sign * (given - old));
            double more = given > 0 ? held.press(k, sign, aim, impulse, substep) : 0;
            impulse[o] = given + more;
            equations.push(k, 0, sign * more);
        }
    }

    /** Whether what comes to a stop stays there, and no motor drives it. */
    private boolean comesToRest(int k) {
        return ((Limit) equations.ties[k]).getRestitution() == 0 && !held.has(k);
    }

    /** What a bound bears, without what motors press against it. */
    private double borne(int bound, int sign) {
        double all = impulse[bound];
        return all > 0 ? Math.max(0, all - held.pressed(bound / ROWS, sign, 0, impulse)) : 0;
    }

    /** Takes note of the impulses of a substep. */
    void add() {
        for (int s = 0; s < count; s++) {
            int o = ROWS * places[s];
            sums[2 * s] = borne(o, 1);
            sums[2 * s + 1] = borne(o + 1, -1);
        }
    }

    /** Takes note of how all moves when a substep ends, and of what accelerates what is free. */
    public void note() {
        for (int s = 0; s < count; s++) {
            if (areImpacts[s]) {
                double now = equations.speed(places[s], 0, state.v());
                if (sums[2 * s] == 0 && sums[2 * s + 1] == 0 && !areShaken[s]) { // blows elsewhere in the machine are no pull
                    gainBefore[s] = gain[s];
                    gain[s] = (now - speed[s]) / h;
                }
                speed[s] = now;
                coordinate[s] = equations.c[ROWS * places[s]];
            }
            areShaken[s] = false;
        }
    }

    /**
     * Finds the stops that were struck in the substep, which is over, and those that pressed where something was struck.
     *
     * @param step the step
     * @param groups groups of bodies
     * @param counts what was struck, by group; adds these
     * @param giveBack whether something gives back, by group; adds these
     */
    public void find(double step, int[] groups, int[] counts, boolean[] giveBack) {
        metCount = 0;
        for (int m = 0; m < 2 * count; m++) {
            boolean isStruck = sums[m] > 0 && isFast(m, step);
            strikes[m] = isStruck ? strike(m) : 0;
            least[m] = 0;
            if (isStruck) {
                counts[group(m, groups)]++;
                giveBack[group(m, groups)] |= stop(m / 2).getRestitution() > 0;
            }
        }
        for (int m = 0; m < 2 * count; m++) {
            boolean presses = sums[m] > 0 || impulse[ROWS * places[m / 2] + (m & 1)] > 0;
            if (presses && counts[group(m, groups)] > 0) {
                areAlone[m] = counts[group(m, groups)] == 1;
                met[metCount++] = m;
            }
        }
    }

    /**
     * Forgets the stops that were struck in groups in which nothing has met after all, and notes in which groups something has.
     *
     * @param groups groups of bodies
     * @param counts what was struck, by group
     */
    public void drop(int[] groups, int[] counts) {
        int left = 0;
        for (int n = 0; n < metCount; n++) {
            if (counts[group(met[n], groups)] > 0) {
                met[left++] = met[n];
            }
        }
        metCount = left;
        for (int s = 0; s < count; s++) {
            areShaken[s] = areImpacts[s] && counts[group(2 * s, groups)] > 0;
        }
    }

    /** The speed of a strike: forces have gone along as far as the coordinate has, to where it bounces off; that keeps the energy of the fall. */
    private double strike(int m) {
        double way = sign(m) * (coordinate[m / 2] - equations.c[ROWS * places[m / 2]]);
        return Math.sqrt(Math.max(0, toward(m) * toward(m) + 2 * pull(m) * way));
    }

    /** {@return whether stops have part in what has met} */
    public boolean haveMet() {
        return metCount > 0;
    }

    private int group(int m, int[] groups) {
        return groups[equations.movable(places[m / 2])];
    }

    /**
     * Solves what has met, of groups that have not settled, once more so that nothing goes on into it.
     *
     * @param groups groups of bodies
     * @param turns those that are solved
     * @param fresh which bodies have changed
     */
    public void compress(int[] groups, OpenGroups turns, Freshness fresh) {
        solve(groups, turns, fresh, false);
    }

    private void solve(int[] groups, OpenGroups turns, Freshness fresh, boolean parts) {
        for (int n = 0; n < metCount; n++) {
            int m = met[n];
            int first = equations.end(2 * places[m / 2]);
            int second = equations.end(2 * places[m / 2] + 1);
            int group = groups[first >= 0 ? first : second];
            if (turns.isOpen(group) && fresh.isStale(solved[m], first, second)) {
                boolean changes = parts ? part(m, Softness.EAGER.mass()) : solve(m, 0, Softness.EAGER.mass());
                solved[m] = fresh.solve(first, second, changes, true);
                turns.change(group, changes);
            }
        }
    }

    /** Begins to give back: where several were struck together, each a part of what it took, less what forces gave after the strike. */
    public void restore() {
        for (int n = 0; n < metCount; n++) {
            int m = met[n];
            double taken = sums[m];
            sums[m] = 0;
            least[m] = 0;
            if (!areAlone[m] && strikes[m] > 0) {
                double after = Math.max(0, pull(m)) * Math.max(0, h - Math.max(0, gap(m)) / strikes[m]);
                give(m, stop(m / 2).getRestitution() * taken * strikes[m] / (strikes[m] + after));
                least[m] = sums[m];
            }
        }
    }

    /**
     * Lets what was struck alone part at its speed, and holds all others, into which what others give back may push.
     *
     * @param groups groups of bodies
     * @param turns those that are solved
     * @param fresh which bodies have changed
     */
    public void part(int[] groups, OpenGroups turns, Freshness fresh) {
        solve(groups, turns, fresh, true);
    }

    /** The same of all of them, as what is solved last is right. */
    public void part() {
        for (int n = 0; n < metCount; n++) {
            part(met[n], 1);
        }
    }

    private boolean part(int m, double part) {
        return solve(m, areAlone[m] ? stop(m / 2).getRestitution() * strikes[m] : 0, part);
    }

    /** Solves a bound for what it gives in all; whether that has changed. */
    private boolean solve(int m, double opening, double part) {
        int k = places[m / 2];
        double missing = opening - sign(m) * turning.speed(k, false);
        double old = sums[m];
        give(m, Math.max(least[m] - old, part * equations.inverse[ROWS * ROWS * k] * missing));
        return Math.abs(sums[m] - old) > SETTLED * (sums[m] + old);
    }

    private void give(int m, double by) {
        sums[m] += by;
        turning.push(places[m / 2], sign(m) * by);
    }
}
