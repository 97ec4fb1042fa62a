// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.Probes;
import sim.physics.motion.State;
import sim.physics.motion.Ties;
import sim.physics.motion.Trajectories;

/**
 * The search for the forces of a heap with bodies that the integrator drives: these are integrated under the last forces, what is missing
 * is solved for, and again, until both say the same. Where that leads nowhere missing gaps are let be, then points are made a little soft.
 */
final class ForceSearch implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Times that the forces of driven bodies are found, and their change at which they are right, as a share of the scale. */
    private static final int PROBES = 6;

    private static final double SAME = 1e-9;

    /** The same from which on the next one can be told from the last two. */
    private static final double SMALL = 1e-3;

    /** The same at which the last integration is as good as one under the forces that were found from it. */
    private static final double EQUAL = 1e-11;

    /** How many times faster than at the start and than expected bodies are that forces throw about: those balance one another no more. */
    private static final double FAST = 10;

    /** Change of velocities, relative to them, from which it costs too much to regain gaps: stops and friction all but hold them. */
    private static final double COSTLY = 10;

    /**
     * Change of velocities, relative to them, with which impulses that are not right are of no use: where stops and the ground
     * ask for what cannot be, they grow with every turn of the solution, and no integration would bear such forces.
     */
    private static final double WILD = 1e3;

    /**
     * Speed, relative to that which forces give in a step, of what is about to come to rest: under forces that are found exactly it does,
     * under those that are good enough a large heap quivers on, by as much as these are wrong.
     */
    private static final double SETTLING = 1e-5;

    /** How far beyond the end of a path its change of velocity is believed, relative to the path. */
    private static final double MOST_SHARE = 100;

    /** Energy, relative to all, that contacts do not give by what rounding or a long time makes of it; and the same where belts move bodies. */
    private static final double LITTLE = 1e-4;

    private static final double MUCH = 1e-3;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final HeapSystem system;
    private final HeapNotes notes;
    private final BodyScale scales;
    private final HeapPull pulls;
    private final KeptImpulses kept;
    private final HeapShare share = new HeapShare();
    private final double[] fall = new double[State.BLOCK];

    /** What the search and its results need of the heap. */
    final HeapSwitches switches;

    final Probes probes;
    final HeapTurn turning;
    final HeapHistory history = new HeapHistory();

    /** What velocities differ by as points were not where the last integration had them. */
    private double turned;
    private double[] impulses = {};
    private double[] velocities = {};

    /** Whether the impulses are right or nearly so, and whether the last integration was made under them. */
    private boolean isRight;
    private boolean isProbed;

    /** Whether missing gaps cannot be regained. */
    private boolean isReleased;

    /** Whether no impulses were found but those of points that are a little soft. */
    private boolean isSoft;

    /** Null while nothing ties bodies of the heap together. */
    private transient Ties ties;

    /** What tells the points of a heap from others. */
    private final IntList names = new IntList();

    ForceSearch(
            State state,
            Trajectories trajectories,
            Motion motion,
            HeapBodies by,
            HeapSystem system,
            HeapNotes notes,
            BodyScale scales,
            HeapPull pulls,
            Regain regain) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.system = system;
        this.notes = notes;
        this.scales = scales;
        this.pulls = pulls;
        switches = new HeapSwitches(by, system);
        probes = new Probes(state, motion, trajectories);
        turning = new HeapTurn(trajectories, system, regain);
        this.kept = new KeptImpulses(system);
    }

    /** Takes what ties bodies of the heap together; null for nothing. */
    void take(Ties those) {
        ties = those;
    }

    /** Whether a body of the heap is the first of those that move with it. */
    boolean isFirst(int body) {
        return trajectories.isDriven(body) && motion.companions(body).values[0] == body;
    }

    /** Whether it is the first of those that it is tied to: a spring between machines makes these move together, and ties none of them. */
    boolean isFirstTied(int body) {
        return motion.isTied(body) && trajectories.isDriven(body) && ties.island(body).values[0] == body;
    }

    /** Solves for the forces of driven bodies, which change with their way under them, with gaps regained or not; returns the largest speed. */
    double drive(IntList heap, double length, double scale, boolean regains) {
        Extrapolation extrapolation = begin(heap, length, regains);
        double most = scale;
        boolean isSame = false;
        double before = Double.POSITIVE_INFINITY;
        double first = Math.max(scale, fastest(heap, scale));
        double expected = first;
        for (int k = 0; k < PROBES && !isSame; k++) {
            if (!look(heap, length, FAST * expected, k > 0)) {
                break; // for no forces: bounces are left
            }
            system.renew();
            extrapolation.next(system.w, system.v);
            if (system.strain() > 0 || !(scales.fastest(heap, system.v) <= FAST * expected)) {
                extrapolation.unlearn(system.v); // differences that are next to none lead anywhere, as do those beside which a gap is closed by next to none
            }
            most = Math.max(most, scales.fastest(heap, system.v));
            first = k == 0 ? Math.max(first, scales.fastest(heap, system.v)) : first; // what forces alone give
            kept.keep();
            boolean isShared = !isSoft && share.solve(system);
            isRight = isShared || (isSoft ? system.solveSoftly(most) : system.solveUnlessFair(most, EQUAL * most));
            double change = kept.change();
            double error = isSoft || isShared ? change : Math.min(change, system.missed());
            system.tolerance().setNear(isRight && !isSoft && LargeHeaps.isLarge(heap.size));
            if (!isReleased && !(isRight && Math.max(change, system.strain()) <= COSTLY * most)) {
                release(most);
                change = kept.change();
                error = change;
            }
            first = k == 0 ? Math.max(first, scales.fastest(heap, system.v)) : first;
            if (!isRight && !(change <= WILD * most)) {
                stay();
                break;
            } else if (kept.tear(first)) {
                beginAnew(heap, length, first);
                break;
            }
            if (k == 0 && isRight && !isReleased && error > SAME * most && extrapolation.isLearned()) {
                improve(extrapolation, heap, most);
                change = kept.change();
            }
            expected = Math.max(expected, scales.fastest(heap, system.v));
            double next = before <= SMALL * most ? error * (error / before) : error; // if errors go on to shrink at least evenly
            isSame = Math.max(system.isTied() ? turned : 0, Math.min(error, next)) <= Math.max(SAME * most, system.tolerance().enough());
            before = error;
            isProbed = Math.max(change, turned) <= EQUAL * most;
            if (!isProbed) {
                turning.aim(system.v, length);
            }
        }
        if (isProbed) {
            kept.goBack();
        } else if (!isSame && system.jams() && isGainful(heap, length)) {
            isRight = false;
        }
        restore(heap);
        return most;
    }

    /** How fast the bodies are; where that is next to nothing they are to come to rest, and forces to be exact. */
    private double fastest(IntList heap, double scale) {
        double now = scales.fastestNow(heap);
        if (now <= SETTLING * scale) {
            system.tolerance().allow(0);
        }
        return now;
    }

    /**
     * Whether contacts whose forces were not found right give energy, which bodies have neither now nor without them: these give none then,
     * and what they are to bear strikes. Where friction locks what ties hardly let move, forces that are out by next to nothing do much.
     */
    private boolean isGainful(IntList heap, double length) {
        velocities = velocities.length < 3 * heap.size ? new double[6 * heap.size] : velocities;
        System.arraycopy(system.v, 0, velocities, 0, 3 * heap.size);
        double gained = energyAfter(heap, length);
        if (gained > (1 + LITTLE) * HeapEnergy.of(system, turning.before())) {
            kept.keep();
            system.liftContacts();
            double without = energyAfter(heap, length);
            double most = system.fastestBelt() > 0 ? 1 + MUCH : 1 + LITTLE;
            if (!(gained <= most * without)) {
                return true;
            }
            kept.goBack();
        }
        System.arraycopy(velocities, 0, system.v, 0, 3 * heap.size);
        turning.aim(system.v, length);
        return false;
    }

    /** Twice the kinetic energy after a time under the impulses at hand, and leaves the velocities there; infinite where these tear ties. */
    private double energyAfter(IntList heap, double length) {
        double fastest = tryProbe(heap, length);
        system.applyAll();
        return fastest < Double.POSITIVE_INFINITY ? HeapEnergy.of(system, system.v) : Double.POSITIVE_INFINITY;
    }

    private Extrapolation begin(IntList heap, double length, boolean regains) {
        for (int p = 0; p < system.contacts(); p++) {
            notes.start(p, length);
        }
        switches.start();
        forecast(heap, length);
        isReleased = !regains;
        isSoft = false;
        turning.begin(heap, length, regains, false);
        history.extrapolation(heap.values[0]).begin(heap, length);
        return history.extrapolation(heap.values[0]);
    }

    private void restore(IntList heap) {
        for (int k = 0; k < heap.size; k++) {
            if (isFirst(heap.values[k])) {
                motion.restore(motion.companions(heap.values[k]));
            }
        }
    }

    /**
     * Integrates under the last forces, or under none if those throw bodies about with more than a speed: what they held in balance is
     * not there any more, or they are not those from which the search has set out. False if even soft points tear ties.
     */
    private boolean look(IntList heap, double length, double most, boolean isLate) {
        double fastest = tryProbe(heap, length);
        if (fastest <= most) {
            return true;
        }
        boolean isVain = isSoft && fastest == Double.POSITIVE_INFINITY;
        isProbed &= !isVain;
        isReleased |= isLate;
        isSoft |= isLate;
        forget();
        probe(heap, length);
        return !isVain;
    }

    /** Improves the solution after the first integration by what is known of how impulses act over the time. */
    private void improve(Extrapolation extrapolation, IntList heap, double scale) {
        impulses = system.impulses(impulses);
        kept.takeAway(system.v);
        extrapolation.learn(system.w, system.v);
        system.renew();
        if (!(share.solve(system) || system.solve(scale, true)) || !(scales.fastest(heap, system.v) <= FAST * scale)) {
            extrapolation.unlearn(system.free());
            system.put(impulses);
        }
    }

    /**
     * Solves without speeds of parting, with which gaps are regained: where these contradict one another or stops there are no impulses
     * for them, and what is found grows with every turn. Without them there are always some.
     */
    private void release(double scale) {
        system.tolerance().setNear(false);
        kept.goBack();
        system.restart();
        system.again();
        isRight = system.solve(scale, false);
        isReleased = true;
        if (!isRight) {
            isRight = system.solveSoftly(scale);
            isSoft = true;
        }
    }

    /** Solves for impulses of points that are a little soft, under none to begin with; where these tear bodies about too, for none. */
    private void beginAnew(IntList heap, double length, double expected) {
        forget();
        kept.keep();
        double most = Math.max(probe(heap, length), scales.fastest(heap, system.v));
        system.renew();
        isRight = system.solveSoftly(most);
        isReleased = true;
        isSoft = true;
        isProbed = false;
        if (kept.tear(expected)) {
            stay();
        }
    }

    private void forget() {
        system.tolerance().setNear(false);
        system.startFromNothing();
        system.restart();
    }

    /** Takes the forces of before again. */
    private void stay() {
        kept.goBack();
        system.refresh();
        system.restart();
    }

    /** Solves for impulses that give no energy, which is more than regained gaps are worth; returns whether these are right or nearly so. */
    boolean regainNothing(double scale) {
        kept.keep();
        release(scale);
        if (!isRight && !(kept.change() <= WILD * scale)) {
            stay();
        }
        isProbed &= kept.change() <= EQUAL * scale;
        return isRight;
    }

    /** Whether missing gaps cannot be regained. */
    boolean isReleased() {
        return isReleased;
    }

    /** Starts from the forces that are to be expected. */
    private void forecast(IntList heap, double length) {
        names.clear();
        notes.name(names);
        switches.name(names);
        HeapForecast forecast = history.forecast(heap.values[0]);
        forecast.begin(names);
        forecast.start(system, middle(heap.values[0], length), length);
        boolean isLarge = LargeHeaps.isLarge(heap.size); // there, what points have borne is nearer to what they will than nothing is
        system.tolerance().setNear(isLarge && !system.isTied());
        if (!isLarge) {
            HeapStart.leaveNoneOut(system);
        }
    }

    /** The middle of a time from the anchor of a body on, in steps. */
    double middle(int body, double length) {
        return trajectories.step() + (trajectories.offset(body) + 0.5 * length) / trajectories.h();
    }

    /** Whether the impulses that were found last are right or nearly so. */
    boolean isRight() {
        return isRight;
    }

    /** The same; an infinite speed where ties cannot be kept closed under the last forces, which throw their bodies about then. */
    private double tryProbe(IntList heap, double length) {
        try {
            return probe(heap, length);
        } catch (IllegalStateException tooStrong) {
            return Double.POSITIVE_INFINITY;
        }
    }

    /**
     * Finds the velocities with which the bodies would be at the end without the heap, from those with its last forces; returns the
     * largest speed that they have with these.
     */
    private double probe(IntList heap, double length) {
        double[] d = trajectories.data();
        double[] pushes = turning.pushes(heap.size);
        support(heap, length, pushes);
        double share = 1;
        double most = 0;
        boolean bends = system.strain() > 0 && system.size() == system.contacts(); // motors and stops act evenly no more where they change
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            int o = body * Trajectories.STRIDE + Trajectories.VX;
            if (isFirst(body)) {
                share = Math.min(MOST_SHARE, length / probes.probe(body, length)); // it may end early, at a stop
            }
            boolean isDriven = trajectories.isDriven(body);
            pulls.give(body, fall);
            for (int c = 0; c < State.BLOCK; c++) {
                double gained = isDriven
                        ? share * (state.v()[State.BLOCK * body + c] - d[o + c])
                        : fall[c] * length + pushes[3 * k + c];
                system.v[3 * k + c] = d[o + c] + gained;
                if (bends && isDriven && share == 1) {
                    turning.bend(k, c, state.x()[State.BLOCK * body + c] - d[o - Trajectories.VX + c], system.v[3 * k + c], length);
                }
            }
            most = Math.max(most, scales.speed(body, isDriven ? state.v() : system.v, isDriven ? State.BLOCK * body : 3 * k));
        }
        turnSwitches(heap);
        turning.turn(system.v, length, !isReleased);
        turned = scales.fastest(heap, turning.makeUp(heap.size));
        system.unpush();
        return most;
    }

    private void turnSwitches(IntList heap) {
        int island = 0;
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            if (isFirstTied(body)) {
                switches.turn(ties.switched(ties.island(body)), island++, system.v);
            }
        }
    }

    /** Lets driven bodies, and their motors and stops, be pushed evenly over a time. */
    void support(IntList heap, double time, double[] pushes) {
        int island = 0;
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            if (trajectories.isDriven(body)) {
                motion.support(body, pushes[3 * k] / time, pushes[3 * k + 1] / time, pushes[3 * k + 2] / time);
            }
            if (isFirstTied(body)) {
                switches.freeze(ties.switched(ties.island(body)), island++, time);
            }
        }
    }

    /** Whether the last integration was made under the forces that were found. */
    boolean isProbed() {
        return isProbed;
    }
}
