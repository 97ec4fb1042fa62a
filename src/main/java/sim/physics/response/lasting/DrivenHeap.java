// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.Probes;
import sim.physics.motion.State;
import sim.physics.motion.Ties;
import sim.physics.motion.Trajectories;

/**
 * Heaps with bodies that the integrator drives: what their contacts push them with is found by integrating under the last
 * forces and solving for what is missing, again and again.
 */
final class DrivenHeap implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Times that the forces of driven bodies are found, and their change at which they are right, as a share of the scale. */
    private static final int PROBES = 6;

    private static final double SAME = 1e-9;

    /** The same from which on the next one can be told from the last two. */
    private static final double SMALL = 1e-3;

    /** The same at which the last integration is as good as one under the forces that were found from it. */
    private static final double EQUAL = 1e-11;

    /** Error of velocities at the end of their time, relative to them, with which forces may go on until then. */
    private static final double DRIFT = 1e-5;

    /** How many times faster than at the start and than expected bodies are that forces throw about: those balance one another no more. */
    private static final double FAST = 10;

    /** Change of velocities, relative to them, from which it costs too much to regain gaps: stops and friction all but hold them. */
    private static final double COSTLY = 10;

    /**
     * Change of velocities, relative to them, with which impulses that are not right are of no use: where stops and the ground
     * ask for what cannot be, they grow with every turn of the solution, and no integration would bear such forces.
     */
    private static final double WILD = 1e3;

    /** How far beyond the end of a path its change of velocity is believed, relative to the path. */
    private static final double MOST_SHARE = 100;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final HeapBodies by;
    private final HeapSystem system;
    private final HeapNotes notes;
    private final BodyScale scales;
    private final double[] fall = new double[State.BLOCK];

    /** What velocities differ by as points were not where the last integration had them. */
    private double turned;
    private double[] impulses = {};

    /** Whether the impulses are right or nearly so, and whether the last integration was made under them. */
    private boolean isRight;
    private boolean isProbed;

    /** Whether missing gaps cannot be regained. */
    private boolean isReleased;

    /** Whether no impulses were found but those of points that are a little soft. */
    private boolean isSoft;

    /** Null while nothing ties bodies of the heap together. */
    private transient Ties ties;

    private final HeapSwitches switches;
    private final Probes probes;
    private final KeptImpulses kept;
    private final HeapTurn turning;
    private final HeapShare share = new HeapShare();

    private final HeapHistory history = new HeapHistory();

    /** What tells the points of a heap from others. */
    private final IntList names = new IntList();

    DrivenHeap(
            State state,
            Trajectories trajectories,
            Motion motion,
            HeapBodies by,
            HeapSystem system,
            HeapNotes notes,
            BodyScale scales) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.by = by;
        this.system = system;
        this.notes = notes;
        this.scales = scales;
        this.switches = new HeapSwitches(by, system);
        this.probes = new Probes(state, motion, trajectories);
        this.kept = new KeptImpulses(system);
        this.turning = new HeapTurn(trajectories, system);
    }

    /** Takes in a point of the heap, the gap that there may be at the end, and how far forces take its bodies in a step, relative to their size. */
    void turn(int p, Manifold manifold, int k, double deepest, double roam) {
        turning.set(p, manifold, k, deepest, roam);
    }

    /** Takes from bodies what forces have given them for the time that is left: it is found anew, with those of driven ones. */
    void unpay(IntList heap, double tau, Ties those) {
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            probes.stir(body);
            motion.ground().resume(body);
            if (!trajectories.isDriven(body)) {
                by.unpay(body, tau, trajectories.data(), body * Trajectories.STRIDE + Trajectories.VX);
            }
            by.paidUntil[body] = 0;
            if (isFirstTied(body)) {
                motion.restore(those.island(body));
                those.prepareImpact(those.island(body));
            }
        }
    }

    /** Whether a body of the heap is the first of those that move with it. */
    private boolean isFirst(int body) {
        return trajectories.isDriven(body) && motion.companions(body).values[0] == body;
    }

    /**
     * Takes in the motors and stops of tied bodies, and finds what impulses do to these, as their ties are prepared.
     *
     * @param regain has the time for which forces are to act
     * @param fall speed that they give to bodies in it
     */
    void gather(IntList heap, Ties those, Regain regain, double fall) {
        ties = those;
        switches.clear();
        for (int k = 0; k < heap.size; k++) {
            if (isFirstTied(heap.values[k])) {
                switches.gather(ties.switched(ties.island(heap.values[k])), regain, fall);
            }
        }
        for (int p = 0; p < system.size(); p++) {
            if ((p < system.contacts() || !switches.shares(p)) && HeapReplies.areNeeded(system, p, heap, motion)) {
                system.replies().find(system, p, heap, motion, ties, by.place);
            }
            system.measure(p);
        }
    }

    /** Speeds at which motors and stops, in their order behind the contacts, are left by what strikes them now. */
    double[] rebounds() {
        return switches.rebounds();
    }

    private boolean isFirstTied(int body) {
        return motion.isTied(body) && isFirst(body);
    }

    /** Solves for the forces of driven bodies, which change with their way under them, with gaps regained or not; returns the largest speed. */
    double drive(IntList heap, double length, double scale, boolean regains) {
        Extrapolation extrapolation = begin(heap, length, regains);
        double most = scale;
        boolean isSame = false;
        double before = Double.POSITIVE_INFINITY;
        double first = Math.max(scale, scales.fastestNow(heap));
        double expected = first;
        for (int k = 0; k < PROBES && !isSame; k++) {
            if (!look(heap, length, FAST * expected, k > 0)) {
                break; // for no forces: bounces are left
            }
            system.renew();
            extrapolation.next(system.w, system.v);
            if (!(scales.fastest(heap, system.v) <= FAST * expected)) {
                extrapolation.unlearn(system.v); // differences that are next to none lead anywhere
            }
            most = Math.max(most, scales.fastest(heap, system.v));
            first = k == 0 ? Math.max(first, scales.fastest(heap, system.v)) : first; // what forces alone give
            kept.keep();
            boolean isShared = !isSoft && share.solve(system);
            isRight = isShared || (isSoft ? system.solveSoftly(most) : system.solveUnlessFair(most, EQUAL * most));
            double change = kept.change();
            double error = isSoft || isShared ? change : Math.min(change, system.missed());
            if (!isReleased && !(isRight && change <= COSTLY * most)) {
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
        }
        restore(heap);
        return most;
    }

    private Extrapolation begin(IntList heap, double length, boolean regains) {
        for (int p = 0; p < system.contacts(); p++) {
            notes.start(p, length);
        }
        switches.start();
        forecast(heap, length);
        isReleased = !regains;
        isSoft = false;
        turning.begin(heap, length, regains);
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
        HeapStart.leaveNoneOut(system);
    }

    /** The middle of a time from the anchor of a body on, in steps. */
    private double middle(int body, double length) {
        return trajectories.step() + (trajectories.offset(body) + 0.5 * length) / trajectories.h();
    }

    /** Whether the impulses that were found last are right or nearly so. */
    boolean isRight() {
        return isRight;
    }

    /**
     * Lets bodies be pushed evenly over a time as was found, also those that nothing drives: if these moved at once as they do
     * at its end, they would run into those that do not yet. Integrations under the same forces go for the bodies' motion.
     */
    void publish(IntList heap, double time) {
        double[] pushes = turning.pushes(heap.size);
        support(heap, time, pushes);
        turning.keep(heap, system.v, time);
        history.forecast(heap.values[0]).keep(system, middle(heap.values[0], time), time);
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            if (!trajectories.isDriven(body)) {
                motion.support(body, pushes[3 * k] / time, pushes[3 * k + 1] / time, pushes[3 * k + 2] / time);
                continue;
            }
            System.arraycopy(system.v, 3 * k, by.expected, 3 * body, State.BLOCK);
            if (isProbed && isFirst(body)) {
                probes.keep(body, time);
            }
        }
    }

    /**
     * Lets bodies stand still from now on, if they do so at the start and at the end of a step, under forces that were found right by
     * an integration; false if they do not.
     *
     * @param none speed that is none
     */
    boolean rest(IntList heap, double time, double none) {
        double[] d = trajectories.data();
        boolean yes = isProbed && !isReleased && time == trajectories.h();
        for (int k = 0; yes && k < heap.size; k++) {
            int body = heap.values[k];
            int o = body * Trajectories.STRIDE + Trajectories.VX;
            yes = scales.speed(body, system.v, 3 * k) <= none && scales.speed(body, d, o) <= none;
            yes &= !trajectories.isDriven(body) || probes.mayRest(body);
            yes &= !isFirstTied(body) || switches.areHere(ties.switched(ties.island(body)));
        }
        for (int k = 0; yes && k < heap.size; k++) {
            int body = heap.values[k];
            int o = body * Trajectories.STRIDE + Trajectories.VX;
            Arrays.fill(d, o, o + State.BLOCK, 0);
            if (trajectories.isDriven(body)) {
                probes.rest(body);
            } else {
                motion.fall(body, fall, 0);
                motion.support(body, -fall[0], -fall[1], -fall[2]);
            }
            if (isFirstTied(body)) {
                switches.keep(ties.switched(ties.island(body)), body);
            }
        }
        return yes;
    }

    /** Lets a body move again, and those that move with it. */
    void stir(int body) {
        probes.stir(body);
    }

    /** Whether something has happened to a body that stands still, or its motors or stops have been set. */
    boolean stirs(int body, Ties those) {
        return motion.isTied(body) && (!probes.rests(body) || isFirst(body) && !switches.areKept(those.switched(those.island(body)), body));
    }

    /**
     * Whether forces may go on until their time is over, where the path of a body has ended before: if what moves with it comes
     * to the velocities for which they were found. The error of one long step may be more than that of two short ones.
     */
    boolean goesOn(int body, double tau) {
        motion.bring(body, tau);
        IntList group = motion.companions(body);
        double length = by.paidUntil[body] - tau;
        boolean goesOn = probes.probe(body, length) == length;
        double most = 0;
        double error = 0;
        for (int k = 0; k < group.size; k++) {
            int one = group.values[k];
            most = Math.max(most, scales.speed(one, by.expected, State.BLOCK * one));
            for (int c = 0; c < State.BLOCK; c++) {
                fall[c] = state.v()[State.BLOCK * one + c] - by.expected[State.BLOCK * one + c];
            }
            error = Math.max(error, scales.speed(one, fall, 0));
        }
        motion.restore(group);
        goesOn &= error <= DRIFT * most;
        if (goesOn) {
            probes.keep(body, length);
        }
        return goesOn;
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
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            int o = body * Trajectories.STRIDE + Trajectories.VX;
            if (isFirst(body)) {
                share = Math.min(MOST_SHARE, length / probes.probe(body, length)); // it may end early, at a stop
            }
            most = trajectories.isDriven(body) ? Math.max(most, scales.speed(body, state.v(), State.BLOCK * body)) : most;
            motion.fall(body, fall, 0);
            for (int c = 0; c < State.BLOCK; c++) {
                double gained = trajectories.isDriven(body)
                        ? share * (state.v()[State.BLOCK * body + c] - d[o + c])
                        : fall[c] * length + pushes[3 * k + c];
                system.v[3 * k + c] = d[o + c] + gained;
            }
        }
        turning.turn(system.v, length, !isReleased);
        turned = scales.fastest(heap, turning.makeUp(heap.size));
        system.unpush();
        return most;
    }

    /** Lets driven bodies, and their motors and stops, be pushed evenly over a time. */
    private void support(IntList heap, double time, double[] pushes) {
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
}
