// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import sim.physics.internal.Growth;
import sim.physics.internal.Softness;
import sim.physics.motion.State;

/**
 * Joints that hang together, and the motors of their angles, solved at once: from the tips of a tree to its root and back (Featherstone, <i>Rigid
 * body dynamics algorithms</i>, 2008, chapter 7; with all coordinates of the bodies, Baraff, <i>Linear-time dynamics using Lagrange multipliers</i>, 1996), or
 * by {@link TieLoops} if there are loops. This is done before the move for places, and after it for velocities, which is RATTLE (Andersen 1983).
 *
 * <p>In turns, what one end of a chain says gets to the other one by a joint or two in a solution. A tree is solved at once from where turns have left
 * something until they would have nothing to do. It does not yield then. Motors that push as hard as they can, stops and all else come after it, in turns. So do
 * trees of which something is touched, or lies at a stop; but structures, whose joints hold all where it is, would sag ({@link PressedTrees}).
 */
public final class TieTrees implements Serializable {
    private static final long serialVersionUID = 2L;

    /** Joints of a tree from which on it is worth it: with two, turns are as good. */
    private static final int FEW = 3;

    /** What turns have left of the speeds of rows, relative to what bodies have and get, from which on trees are solved at once; and at which they no longer are. */
    private static final double OPEN = 1e-3;

    private static final double CLOSED = 1e-7;

    /** What joints bear, as a part of all that their rows have to do with, in energies, from which on turns would let them sag. */
    private static final double LOADED = 1e-4;

    /** How far joints may be open, relative to their smaller bodies, that are solved in turns. */
    private static final double AJAR = 1e-7;

    /** What bodies may turn by in a substep, and how far joints may be open relative to their smaller bodies, where trees are solved at once. */
    private static final double TURN = 1;

    private static final double WIDE = 0.05;

    /** How far joints are open, relative to their smaller bodies, of a tree that is solved at once though it is touched; and what its joints bear, in energies. */
    private static final double SAGGING = 1e-4;

    private static final double HEAVY = 0.5;

    /** How often a tree is solved anew in which motors would have to give more than they can. */
    private static final int SLIPS = 4;

    /** Steps for which a tree that has got energy for nothing among others is solved in turns. */
    private static final int PAUSE = 16;

    /**
     * How far joints with loops may send their bodies in a substep, relative to their size, or turn them: beside a pose in which they go no farther, what is off by
     * little asks for much.
     */
    private static final double FAR = 0.05;

    private final State state;
    private final TieEquations equations;
    private final PinImpulses pins;
    private final TieBonds bonds;
    private final PressedTrees pressed;

    /** By tree: the end of its bonds, whether it is solved at once, and whether that had something to do in this step. */
    private int[] ends = {};

    private boolean[] isOpen = {};
    private boolean[] isAsked = {};

    /** By tree: the stops of its bodies, which may push after it has been solved; and the steps for which it is solved in turns in any case. */
    private int[][] stops = {};

    private int[] waits = {};

    /** By tree: whether something touches one of its bodies. */
    private boolean[] isTouched = {};

    /** By constraint that is no pin: whether its tree is solved at once; and whether that leaves nothing to do in turns. */
    private boolean[] isStiff = {};

    private boolean[] isSolved = {};

    /** By tree: whether it is solved at once with what touches it, and whether it is to be from the next step on. */
    private boolean[] isPressed = {};

    private boolean[] isSagging = {};

    /** By tree: whether its joints leave its bodies no way to move. */
    private boolean[] isStructure = {};

    /** By tree: its equations if it has loops, and was solved at once; whether it has loops, and whether these are too many for that. */
    private TieLoops[] loops = {};

    private boolean[] haveLoops = {};
    private boolean[] areTooMany = {};

    private final KnownTrees known = new KnownTrees();

    /** By body: whether it was brought onto its joints. */
    private boolean[] moved = {};

    private boolean isJudged;

    /** Energies: of what rows are off, of what their impulses give, and of all that they have to do with. */
    private final double[] off = new double[3];

    TieTrees(State state, TieEquations equations, PinImpulses pins) {
        this.state = state;
        this.equations = equations;
        this.pins = pins;
        bonds = new TieBonds(state, equations, pins);
        pressed = new PressedTrees(state, this, bonds);
    }

    /** Takes note of what is known of the trees of constraints, before others are taken. */
    void note(List<PinJoint> all) {
        for (int t = 0; t < ends.length; t++) {
            for (int k = from(t); note(t) != 0 && k < ends[t]; k++) {
                if (bonds.pin(k) >= 0) {
                    known.put(all.get(bonds.pin(k)), note(t));
                }
                if (bonds.tie(k) >= 0) {
                    known.put(equations.ties[bonds.tie(k)], note(t));
                }
            }
        }
    }

    private int note(int t) {
        return isPressed[t] || isSagging[t] ? KnownTrees.PRESSED : isOpen[t] ? KnownTrees.AT_ONCE : waits[t];
    }

    /**
     * Finds the trees, with loops or without. Those of which a part was solved at once are solved so again.
     *
     * @param all the pins
     * @param awakePins how many of them, from the first one on, are awake
     */
    void gather(List<PinJoint> all, int awakePins) {
        TieForest forest = new TieForest(state, equations, pins, awakePins);
        forest.find(FEW);
        int n = forest.trees.size();
        isSolved = new boolean[equations.ties.length];
        isStiff = new boolean[equations.ties.length];
        ends = new int[n];
        isOpen = new boolean[n];
        isAsked = new boolean[n];
        waits = new int[n];
        isTouched = new boolean[n];
        stops = forest.stops();
        loops = new TieLoops[n];
        isPressed = new boolean[n];
        isSagging = new boolean[n];
        isStructure = new boolean[n];
        haveLoops = new boolean[n];
        areTooMany = new boolean[n];
        for (int t = 0; t < n; t++) {
            ends[t] = from(t) + forest.trees.get(t).size();
        }
        bonds.clear(n == 0 ? 0 : ends[n - 1]);
        for (int t = 0; t < n; t++) {
            bonds.put(forest.trees.get(t), ends[t] - 1);
            haveLoops[t] = forest.haveLoops.get(t);
            isStructure[t] = bonds.isStructure(from(t), ends[t]);
            recall(t, forest.trees.get(t), all);
        }
        List<Constraint> others = new ArrayList<>(all.subList(awakePins, all.size()));
        others.addAll(Arrays.asList(equations.ties).subList(equations.count(), equations.ties.length));
        known.keep(others);
    }

    private void recall(int t, List<TieForest.Bond> tree, List<PinJoint> all) {
        boolean opens = false;
        for (TieForest.Bond bond : tree) {
            int ofPin = bond.pin < 0 ? 0 : known.of(all.get(bond.pin));
            int ofTie = bond.tie < 0 ? 0 : known.of(equations.ties[bond.tie]);
            opens |= Math.min(ofPin, ofTie) == KnownTrees.AT_ONCE;
            isSagging[t] |= Math.min(ofPin, ofTie) == KnownTrees.PRESSED;
            waits[t] = Math.max(waits[t], Math.max(ofPin, ofTie));
        }
        isSagging[t] &= waits[t] == 0;
        set(t, opens && !isSagging[t] && waits[t] == 0);
    }

    /** Says whether a tree is solved at once. */
    private void set(int t, boolean wanted) {
        boolean opens = wanted && (!haveLoops[t] || canOpen(t));
        isOpen[t] = opens;
        for (int k = from(t); k < ends[t]; k++) {
            if (bonds.pin(k) >= 0) {
                pins.setStiff(bonds.pin(k), opens);
            }
            if (bonds.tie(k) >= 0) {
                isStiff[bonds.tie(k)] = opens;
                isSolved[bonds.tie(k)] = false;
            }
        }
    }

    private boolean canOpen(int t) {
        if (loops[t] == null && !areTooMany[t]) {
            loops[t] = TieLoops.of(bonds, IntStream.range(from(t), ends[t]).toArray());
            areTooMany[t] = loops[t] == null;
        }
        return !areTooMany[t];
    }

    private boolean canPress(int t) {
        return !haveLoops[t] || canOpen(t) && loops[t].areFew();
    }

    private void factor(int t, double open) {
        if (haveLoops[t]) {
            loops[t].factor(bonds.data(), state.w().values(), open);
        } else {
            bonds.factor(from(t), ends[t]);
        }
    }

    /** Gives bodies what the joints of a tree ask for; nothing where that would throw them about, and turns do it for some time. */
    private boolean give(int t, double[] impulse, double h) {
        if (!haveLoops[t]) {
            bonds.give(from(t), ends[t], impulse);
            return true;
        }
        if (!loops[t].solveNear(bonds.data(), FAR, h)) {
            pause(t);
            return false;
        }
        book(t, impulse);
        return true;
    }

    /** Gives bodies what the equations of joints with loops have found, and takes note of it. */
    private void book(int t, double[] impulse) {
        loops[t].give(state.v());
        bonds.book(from(t), ends[t], impulse);
    }

    /** Whether a constraint that is no pin does not yield. */
    boolean isStiff(int tie) {
        return isStiff[tie];
    }

    /** Whether a constraint that is no pin needs no turn. */
    boolean hasSolved(int tie) {
        return isSolved[tie];
    }

    /**
     * Marks the bodies of trees that are solved at once.
     *
     * @param marks by body
     */
    public void markOpen(boolean[] marks) {
        for (int t = 0; t < ends.length; t++) {
            bonds.mark(from(t), isOpen[t] ? ends[t] : 0, marks);
        }
    }

    /**
     * Solves trees that turns would not.
     *
     * @param impulse of the other constraints
     * @param marks by body, of those whose trees are meant; null for all
     * @param placesOnly whether motors have no part in it
     */
    void solve(double[] impulse, boolean[] marks, boolean placesOnly, Softness softness, double h) {
        for (int t = 0; t < ends.length; t++) {
            if (isOpen[t] && !isPressed[t] && (marks == null || marks[bonds.child(from(t)) / State.BLOCK])) {
                solve(t, impulse, placesOnly, softness, h);
            }
        }
    }

    private void solve(int t, double[] impulse, boolean placesOnly, Softness softness, double h) {
        double open = haveLoops[t] ? bonds.widest(from(t), ends[t]) : 0;
        bonds.read(from(t), ends[t], impulse, placesOnly, softness, h);
        if (softness.rate() > 0) {
            bonds.leave(from(t), ends[t], 1 - softness.rate() * h);
        }
        factor(t, open);
        if (haveLoops[t] && softness.rate() > 0) {
            loops[t].release(bonds.data());
            book(t, impulse);
            bonds.read(from(t), ends[t], impulse, placesOnly, softness, h);
        }
        give(t, impulse, h);
        for (int n = 0; n < SLIPS && isOpen[t] && !placesOnly && bonds.slip(from(t), ends[t], impulse, h); n++) {
            bonds.read(from(t), ends[t], impulse, false, softness, h);
            factor(t, open);
            give(t, impulse, h);
        }
        boolean isMet = isOpen[t] && stops[t].length == 0 && bonds.areMotorsMet(from(t), ends[t], impulse, h);
        for (int k = from(t); k < ends[t]; k++) {
            if (bonds.tie(k) >= 0) {
                isSolved[bonds.tie(k)] = isMet;
            }
        }
    }

    /** Whether the speeds of a tree's rows are off by more than a part of all that they have to do with. */
    private boolean isOff(int t, double part, double[] impulse, double h) {
        measure(t, impulse, h);
        return off[0] > part * part * off[2];
    }

    private void measure(int t, double[] impulse, double h) {
        bonds.read(from(t), ends[t], impulse, false, Softness.RIGID, h);
        Arrays.fill(off, 0);
        for (int k = from(t); k < ends[t]; k++) {
            bonds.measure(k, off);
        }
    }

    /** Begins a step, in which it is judged once which trees are solved at once. */
    void begin() {
        isJudged = false;
    }

    /** Finds out, before velocities are solved for the first time, which of the trees that are solved at once have something to do. */
    void ask(double[] impulse, Softness softness, double h) {
        for (int t = 0; !isJudged && softness.rate() == 0 && t < ends.length; t++) {
            isAsked[t] = isOpen[t] && (isOff(t, CLOSED, impulse, h) || off[1] > LOADED * off[2]);
        }
    }

    /** Finds trees that turns have not solved, and those that they would, when velocities have been solved for the first time. */
    void judge(double[] impulse, Softness softness, double h) {
        if (isJudged || softness.rate() > 0) {
            return;
        }
        isJudged = true;
        for (int t = 0; t < ends.length; t++) {
            double widest = bonds.widest(from(t), ends[t]);
            boolean isCalm = waits[t] == 0 && !isStopped(t, impulse) && widest < WIDE && bonds.areSlow(from(t), ends[t], TURN / h);
            waits[t] = Math.max(0, waits[t] - 1);
            if (isTouched[t]) {
                boolean isHeavy = isStructure[t] && isCalm && (isPressed[t] || widest > SAGGING) && bears(t, HEAVY, impulse, h);
                isSagging[t] = isHeavy && !isPressed[t] && canPress(t);
                if (isOpen[t] && !(isHeavy && isAsked[t])) {
                    shut(t);
                }
            } else if (isOpen[t]) {
                set(t, isAsked[t] && isCalm);
            } else if (isCalm && !areTooMany[t]) {
                set(t, widest >= AJAR || isOff(t, OPEN, impulse, h));
            }
        }
    }

    /** Whether what joints bear is so much of all that their rows have to do with. */
    private boolean bears(int t, double part, double[] impulse, double h) {
        measure(t, impulse, h);
        return off[1] > part * off[2];
    }

    /** Has a tree solved in turns. */
    private void shut(int t) {
        set(t, false);
        isPressed[t] = false;
    }

    /** The same for some time. */
    void pause(int t) {
        shut(t);
        waits[t] = PAUSE;
    }

    /** Whether a stop bears something: it yields, and what presses on it has to. */
    private boolean isStopped(int t, double[] impulse) {
        boolean yes = false;
        for (int stop : stops[t]) {
            yes |= impulse[Equations.ROWS * stop] != 0 || impulse[Equations.ROWS * stop + 1] != 0;
        }
        return yes;
    }

    /** Begins a step in which it is known what touches what: trees that sag under it are solved with it. */
    void press() {
        for (int t = 0; t < ends.length; t++) {
            if (isSagging[t]) {
                isSagging[t] = false;
                set(t, true);
                isPressed[t] = isOpen[t] && isTouched[t];
            }
        }
    }

    /** Whether a tree is solved with what touches it. */
    boolean isPressed(int t) {
        return isPressed[t];
    }

    /** {@return number of trees} */
    public int count() {
        return ends.length;
    }

    /** The bonds of a tree: from this one to that before {@link #end}. */
    int from(int t) {
        return t == 0 ? 0 : ends[t - 1];
    }

    int end(int t) {
        return ends[t];
    }

    /** {@return the trees that are solved with what touches them} */
    public PressedTrees pressed() {
        return pressed;
    }

    /**
     * Marks the bodies of trees that are solved with what touches them.
     *
     * @param marks by body
     */
    public void markPressed(boolean[] marks) {
        for (int t = 0; t < ends.length; t++) {
            bonds.mark(from(t), isPressed[t] || isSagging[t] ? ends[t] : 0, marks);
        }
    }

    /**
     * Takes note of what touches something, when a step begins. Contacts are solved in turns, with the joints of their bodies: there, what yields least
     * would press all else out of its place.
     *
     * @param marks by body
     */
    public void touch(boolean[] marks) {
        for (int t = 0; t < ends.length; t++) {
            isTouched[t] = false;
            for (int k = from(t); k < ends[t]; k++) {
                isTouched[t] |= marks[bonds.child(k) / State.BLOCK];
            }
            isPressed[t] &= isTouched[t];
            if (isTouched[t] && isOpen[t] && !isPressed[t]) {
                set(t, false);
            }
        }
    }

    /**
     * Has trees of some bodies solved in turns for some time: what strikes and is struck in them is better off with joints that yield.
     *
     * @param marks by body
     */
    public void close(boolean[] marks) {
        for (int t = 0; t < ends.length; t++) {
            if (marks[bonds.child(from(t)) / State.BLOCK]) {
                pause(t);
            }
        }
    }

    /**
     * Brings bodies where the joints of trees wanted them when they began to move, by impulses in the directions of before the move (SHAKE; Ryckaert, Ciccotti and
     * Berendsen, <i>Numerical integration of the Cartesian equations of motion of a system with constraints</i>, 1977).
     *
     * @return whether there are any
     */
    boolean straighten(double[] impulse, double h) {
        boolean any = false;
        for (int t = 0; t < ends.length; t++) {
            if (isOpen[t] && bonds.haveParted(from(t), ends[t], h)) {
                if (!any) {
                    moved = moved.length < state.size() ? new boolean[Growth.length(moved.length, state.size())] : moved;
                    Arrays.fill(moved, false);
                }
                any |= isPressed[t] ? pressed.close(t, h, moved) : close(t, impulse, h);
            }
        }
        return any;
    }

    private boolean close(int t, double[] impulse, double h) {
        boolean isGiven = give(t, impulse, h);
        if (isGiven && haveLoops[t]) {
            loops[t].move(state.x(), h, moved);
        } else if (isGiven) {
            bonds.move(from(t), ends[t], h, moved);
        }
        return isGiven;
    }

    /** The bodies that were brought there. */
    boolean[] moved() {
        return moved;
    }
}
