// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.List;
import sim.physics.collision.CollisionFilter;
import sim.physics.collision.broad.Pairs;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.ConstraintException;
import sim.physics.constraint.Constraints;
import sim.physics.constraint.Reaction;
import sim.physics.constraint.Onset;
import sim.physics.constraint.SetBodies;
import sim.physics.constraint.TieRows;
import sim.physics.internal.IntList;
import sim.physics.internal.Softness;
import sim.physics.motion.Body;
import sim.physics.motion.Motion;
import sim.physics.motion.Reach;
import sim.physics.motion.State;
import sim.physics.motion.SteppedForces;
import sim.physics.motion.SurfaceRows;
import sim.physics.response.ContactLaws;
import sim.physics.response.LastingContact;

/**
 * Moves the bodies by fixed substeps, in each of which contacts, joints, motors, stops and friction are solved once for
 * impulses, one after the other (Moreau, <i>Unilateral contact and dry friction in finite freedom dynamics</i>, 1988; in small
 * steps, Macklin et al., <i>Small steps in physics simulation</i>, 2019, with soft constraints and a second solution without
 * them after the places have changed, Catto, <i>Solver2D</i>, 2024), by halves ({@link Halves}): of second order in the substep for joints, forces and
 * contacts that last, of first for impacts and for friction that slips. At a cost that is known beforehand: no event is searched for, and no solution is iterated to an end.
 */
public final class TimeStepping implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Gap, relative to the smaller body, from which on a contact is kept in mind whatever the speeds are. */
    private static final double NEAR = 0.01;

    /** Depth that is regained in a step at most, relative to the smaller body. */
    static final double REGAIN = 0.1;

    /** How many times larger impulses are begun with in a longer substep at most: what a short one has not settled would grow as much. */
    private static final double MOST_GROWTH = 2;

    /** Friction of what sticks. */
    private static final double STICKS = 1e100;

    private final State state;
    private final ContactLaws laws;
    private final SteppedForces forces;
    private final SurfaceRows surface;
    private final Poses poses;
    private final Outset outset;
    private final Pace pace = new Pace();
    private final NearPairs near;
    private final Touch touch;
    private final ContactRows rows;
    private final Spinners spinners;
    private final ContactSolver contacts;
    private final TieRows ties;
    private final SetBodies setBodies = new SetBodies();
    private final Onset onset;
    private final Speeds speeds;
    private final Decisions decisions;
    private final Sleep sleep;
    private final Retake retake;
    private final Halves halves;
    private final Newcomers newcomers;
    private final Turn turn;

    /** Null until the first constraint is added. */
    private Constraints constraints;

    private int substeps;
    private double h;

    /** Whether others sleep than before. */
    private boolean areOthersAsleep;

    /** The substep that impulses are kept of, 0 if none are; and what they are to be multiplied by for the present one. */
    private double keptOf;

    private double growth;

    /** Whether the last step's impulses have been asked for joints that break. */
    private boolean isJudged = true;

    private double deepest;
    private double deepestTied;
    private long looks;

    /**
     * Makes one that knows of no body.
     *
     * @param state the state vectors
     * @param motion knows the forces
     * @param filter which bodies collide
     * @param laws what authors say of contacts
     */
    public TimeStepping(State state, Motion motion, CollisionFilter filter, ContactLaws laws) {
        this.state = state;
        this.laws = laws;
        forces = new SteppedForces(motion, state);
        surface = forces.surface();
        poses = new Poses(state);
        rows = new ContactRows(state);
        outset = new Outset(state, poses.awake, rows);
        ties = new TieRows(state);
        contacts = new ContactSolver(state, rows, ties.levers());
        onset = new Onset(state);
        near = new NearPairs(state, poses, filter, onset);
        speeds = new Speeds(state, poses, near, onset);
        decisions = new Decisions(state, laws, rows);
        sleep = new Sleep(state, poses, near, forces, rows);
        decisions.setPairs(near, sleep.kept());
        touch = new Touch(state, poses, near);
        spinners = new Spinners(state, poses, near, touch, rows);
        halves = new Halves(state, poses, forces);
        retake = new Retake(state, poses, forces, ties, rows, contacts);
        newcomers = new Newcomers(state);
        turn = new Turn(state, poses, forces, ties, rows, contacts, newcomers);
    }

    /** {@return number of substeps of a step} */
    public int getSubsteps() {
        return substeps;
    }

    /**
     * Sets the number of substeps.
     *
     * @param substeps at least 1
     */
    public void setSubsteps(int substeps) {
        if (this.substeps != substeps) {
            sleep.wakeAll();
        }
        this.substeps = substeps;
    }

    /**
     * Sets what ties bodies together.
     *
     * @param constraints live; null for nothing
     */
    public void setConstraints(Constraints constraints) {
        this.constraints = constraints;
    }

    /** Begins or ends time stepping: nothing is known of impulses, and all forces are forces. */
    public void forget() {
        forces.leave();
        rows.begin();
        ties.forget();
        keptOf = 0;
        isJudged = true;
    }

    /**
     * Takes a body in, or takes note that it was written.
     *
     * @param body index
     */
    public void admit(int body) {
        boolean isNew = !poses.knows(body);
        if (isNew || state.touched().isTurned(body)) {
            retake.add(body);
            outset.add(body);
        }
        if (isNew) {
            poses.add(body);
            poses.turn(body);
            near.add(body, h);
            sleep.admit(body, true);
            newcomers.bodies.add(body);
        } else {
            sleep.admit(body, false);
            if (!state.isOnlyPushed(body)) {
                poses.written(body);
                near.written(body, h);
                retake.written();
            }
        }
        forces.admit(body);
    }

    /**
     * Forgets a body.
     *
     * @param body index
     */
    public void remove(int body) {
        if (poses.knows(body)) {
            sleep.remove(body);
            near.remove(body);
            poses.remove(body);
        }
    }

    /** {@return which bodies are asleep} */
    public Sleep sleep() {
        return sleep;
    }

    /**
     * Closes the joints of bodies that were written, if that has opened them. Those that say the same twice may be too far open for that: substeps
     * regain it, as they do where hundreds of joints meet in one body.
     *
     * @param island the bodies
     */
    public void assemble(IntList island) {
        try {
            if (!constraints.haveHub(island) && !setBodies.follow(constraints, island, state)) {
                constraints.assemble(island, Reach.DOWNHILL);
            }
        } catch (ConstraintException e) {
            // all is as before
        }
    }

    /**
     * Sets the pace at which depths and gaps are regained, before it takes over within a step, of which little may be left.
     *
     * @param step a whole one
     */
    public void setPace(double step) {
        pace.set(step / substeps);
    }

    /** {@return what is asked and told of contacts} */
    public Decisions decisions() {
        return decisions;
    }

    /**
     * Begins a step: finds forces, and what may touch.
     *
     * @param time simulated time
     * @param step its length
     */
    public void begin(double time, double step) {
        h = step;
        forces.begin();
        outset.begin();
        growth = keptOf > 0 ? Math.min(MOST_GROWTH, step / substeps / keptOf) : 0;
        sleep.wakeDriven(ties);
        areOthersAsleep |= sleep.refresh();
        if (constraints != null) {
            onset.find(ties, step);
        }
        near.update(step);
        sleep.settle(constraints, ties);
        sleep.hasWoken();
        do {
            areOthersAsleep |= sleep.refresh();
            forces.springs().begin(step / substeps, sleep.asleep());
            halves.load(outset.a, time);
            near.drive(step, outset.a);
            rows.begin();
            decisions.begin(time, step);
            deepestTied = 0;
            look();
        } while (sleep.hasWoken());
    }

    private void look() {
        speeds.begin();
        Pairs pairs = near.pairs();
        near.order.update();
        for (int k = 0; k < near.order.size(); k++) {
            int pair = near.order.pair(k);
            if (!near.is(pair, NearPairs.FORBIDDEN)) {
                look(pair, pairs.first(pair), pairs.second(pair));
            }
        }
        IntList reached = decisions.reached();
        for (int k = 0; k < reached.size; k++) {
            look(reached.values[k], pairs.first(reached.values[k]), pairs.second(reached.values[k]));
        }
    }

    private void look(int pair, int first, int second) {
        double size = Math.min(poses.hull(first).bounding, poses.hull(second).bounding);
        looks++;
        Pairs pairs = near.pairs();
        double bounce = laws.restitution(first, second);
        double[] a = outset.a;
        double way = speeds.way(first, second, bounce > 0, a, h);
        touch.find(first, pairs.firstPart(pair), second, pairs.secondPart(pair), NEAR * size + way);
        if (touch.count == 0) {
            near.flags[pair] = 0;
            if (sleep.isIdle(first, second)) {
                near.leave(pair);
            }
            return;
        }
        decisions.recall(pair);
        if (near.is(pair, NearPairs.IGNORED) || sleep.wakes(first, second)) {
            return; // if a body wakes, the step begins anew
        }
        double friction = near.is(pair, NearPairs.STICKY) ? STICKS : laws.friction(first, second);
        double restitution = near.is(pair, NearPairs.STICKY) ? 0 : bounce;
        rows.add(pair, first, second, touch, friction, restitution, laws.belt(first, second), a, h, REGAIN * size / h, near.is(pair, NearPairs.TOUCHED));
        if (decisions.isOpen(rows.count - 1)) {
            rows.dropLast();
            return;
        }
        spinners.add(NEAR * size + way);
        boolean areTied = constraints != null && constraints.isTied(first) && constraints.isTied(second);
        for (int k = 0; k < touch.count; k++) {
            deepest = Math.min(deepest, touch.gap[k]);
            deepestTied = areTied ? Math.max(deepestTied, -touch.gap[k] / size) : deepestTied;
        }
        near.remember(pair, touch, rows, growth * near.release(pair, rows, a, outset.before, h / substeps));
    }

    /**
     * Goes through the step, or a part of it.
     *
     * @param time simulated time of its start
     * @param isLast whether no other part of the step comes after it
     */
    public void solve(double time, boolean isLast) {
        outset.note();
        try {
            solve(time);
        } catch (RuntimeException e) {
            takeBackIfLost(e);
            throw e;
        } finally {
            retake.end();
        }
        takeBackIfLost(null);
        near.keep(rows, contacts);
        sleep.watch(h, outset.a);
        keptOf = h / substeps;
        outset.end();
        newcomers.end();
        forces.end(isLast);
    }

    /** Where bodies have been thrown beyond all numbers, all go back to where the step began, and nothing is known of impulses. */
    private void takeBackIfLost(RuntimeException cause) {
        int lost = outset.lost();
        if (lost < 0) {
            return;
        }
        outset.putBack();
        String text = state.body(lost) + " has been thrown beyond all numbers in a step of " + h + " from there";
        pace.putBack();
        rows.begin();
        h = 0;
        keptOf = 0;
        ties.forget();
        forces.leave();
        retake.forget();
        newcomers.addAll();
        throw new IllegalStateException(text + ": it may be too long, or a mass too small, for what acts", cause);
    }

    private void solve(double time) {
        double d = h / substeps;
        contacts.begin(h, d, outset.a, constraints);
        boolean isTied = constraints != null;
        boolean areOthers = areOthersAsleep || forces.springs().areNew() || newcomers.any();
        if (isTied) {
            areOthers |= ties.gather(constraints, sleep.asleep(), areOthersAsleep, newcomers.bodies);
            ties.begin(growth, d);
            isJudged = false; // also if a force of an author throws in one of the substeps: that far is what is reported
        }
        areOthersAsleep = false;
        surface.begin(poses.awake);
        boolean bounces = rows.bounces > 0 || rows.fast > 0 || isTied && ties.stops().mayStrike(h);
        boolean isBalanced = bounces || isTied || rows.unlike > 0;
        retake.begin(rows, areOthers, isBalanced || rows.driven > 0);
        if (bounces) {
            retake.expect();
        }
        pace.begin(h, d);
        turn.begin(isTied);
        for (int k = 0; k < substeps; k++) {
            spinners.find(k, outset.a);
            substep(time + (k + 1) * d, d, isTied, isBalanced, bounces);
        }
    }

    private void substep(double end, double d, boolean isTied, boolean isBalanced, boolean bounces) {
        double[] a = outset.a;
        if (bounces) {
            retake.approach();
        }
        turn.note();
        halves.accelerate(a, d);
        forces.springs().evaluate(d);
        if (isBalanced) {
            retake.open();
        }
        if (rows.driven > 0) {
            retake.boundBelts(a, d);
        }
        retake.boundCrush(a, d);
        turn.start(halves.before(), d);
        halves.halve();
        turn.solve(pace.joint, pace.contact, true, d);
        if (bounces && isTied) {
            retake.bear(pace.contact, pace.joint, d);
        }
        halves.move(d);
        if (forces.areUneven()) {
            halves.reload(a, end, d);
            if (isBalanced) {
                retake.reload(a, halves.before(), d);
            }
        }
        contacts.follow();
        if (isTied) {
            ties.follow();
        }
        turn.solve(Softness.RIGID, Softness.RIGID, false, d);
        contacts.straighten();
        if (isBalanced) {
            retake.close(a, pace.contact, pace.joint, d);
        }
        if (isTied) {
            ties.add();
        }
        if (bounces) {
            bounce(a, end, d);
        }
        contacts.add();
        if (isTied) {
            ties.stops().note();
        }
    }

    /** What bounces within the substep goes another way than forces that change have been asked for. */
    private void bounce(double[] a, double end, double d) {
        boolean areUneven = forces.areUneven();
        double[] mean = areUneven ? halves.mean(a) : a;
        if (!retake.bounce(mean, h, d)) {
            return;
        }
        try {
            IntList others = areUneven ? retake.goneOn() : null;
            if (others != null && others.size > 0) {
                retake.reloadBounced(mean, halves.loadAgain(others, a, end), a);
            }
        } finally {
            retake.endBounces();
        }
    }

    /** {@return how deep two bodies of joints were in one another when the last step began, at most, relative to the smaller one} */
    public double deepestTied() {
        return deepestTied;
    }

    /** {@return how deep a body is now in one that no force moves, at most, relative to the smaller one} */
    public double deepestInGround() {
        return retake.deepestInGround();
    }

    /** {@return number of times that a pair was looked at for where it touches} */
    public long looks() {
        return looks;
    }

    /** {@return the smallest gap at which a step ever began, 0 or negative} */
    public double deepest() {
        return deepest;
    }

    /**
     * What a constraint did in the last step, in the mean.
     *
     * @param constraint one of the engine
     * @return its force; null before its first step
     */
    public Reaction reaction(Constraint constraint) {
        return ties.reaction(constraint, h);
    }

    /** {@return the joints that broke in the last step; each is named once} */
    public List<Constraint> overloaded() {
        boolean isKnown = isJudged || constraints == null;
        isJudged = true;
        return isKnown ? List.of() : ties.overloaded(h);
    }

    /**
     * The contacts of a body that last.
     *
     * @param body one of the engine; null for all contacts
     * @return a new list
     */
    public List<LastingContact> contacts(Body body) {
        return decisions.contacts(body);
    }
}
