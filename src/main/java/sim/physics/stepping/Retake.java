// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import sim.physics.constraint.StopRows;
import sim.physics.constraint.TieRows;
import sim.physics.internal.Freshness;
import sim.physics.internal.IntList;
import sim.physics.internal.OpenGroups;
import sim.physics.internal.Softness;
import sim.physics.motion.SpringRows;
import sim.physics.motion.State;
import sim.physics.motion.SteppedForces;
import sim.physics.motion.SurfaceRows;

/**
 * Takes a substep back for groups of tied bodies that would have got energy from what holds them, and makes it again in a way that
 * cannot give any: what is missing is regained by velocities of its own, which are forgotten, and impulses start from nothing, so that each
 * solution takes energy.
 */
final class Retake implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Solutions of such a substep. */
    private static final int TURNS = 4;

    /** How often what bounces is solved in turn at most. */
    private static final int BOUNCES = 128;

    /** The same of large groups in which nothing gives anything back. */
    private static final int FEW_BOUNCES = 32;

    private final ContactRows rows;
    private final SurfaceRows surface;
    private final SpringRows springs;
    private final TieRows ties;
    private final ContactSolver contacts;
    private final Grounds grounds;
    private final Groups groups;
    private final Balance balance;

    /** What bodies that bounce may have. */
    private final Balance bounced;

    private final Impacts impacts;
    private final FreeImpacts free;
    private final Reflections reflections;
    private final Belts belts;
    private final Crush crush;

    /** Groups in which something has met, until it has settled. */
    private final OpenGroups turns = new OpenGroups();

    /** Whether a body may be crushed in this step. */
    private boolean isCrushed;

    /** Whether joints, springs or bodies are others than when the groups were found. */
    private boolean isStale;

    Retake(State state, Poses poses, SteppedForces forces, TieRows ties, ContactRows rows, ContactSolver contacts) {
        this.rows = rows;
        surface = forces.surface();
        springs = forces.springs();
        this.ties = ties;
        this.contacts = contacts;
        grounds = new Grounds(state, poses);
        groups = new Groups(state, grounds);
        balance = new Balance(state, groups, grounds);
        bounced = new Balance(state, groups, grounds);
        Flights flights = new Flights(rows, groups);
        free = new FreeImpacts(state, rows, groups, grounds, contacts, flights);
        MetGroups facts = new MetGroups(rows, groups);
        impacts = new Impacts(state, rows, groups, facts, free, flights, contacts);
        reflections = new Reflections(state, rows, groups, free, facts, contacts);
        belts = new Belts(state, poses);
        crush = new Crush(state, poses);
    }

    /** A body was written: its mass may be another. */
    void written() {
        groups.forget();
    }

    /** A body is new, or can be moved by others now, or not any more. */
    void add(int body) {
        balance.add(body);
        bounced.add(body);
        isStale = true;
    }

    /** Nothing is known any more. */
    void forget() {
        groups.forget();
        balance.forgive();
        bounced.forgive();
        isStale = true;
    }

    /**
     * Begins a step: from now to its {@linkplain #end end} nothing moves bodies that others lie on as on the ground.
     *
     * @param isNew whether joints, springs or bodies are others than in the step before
     * @param asks whether groups are asked for in this step; they are where bodies are crushed, too
     */
    void begin(ContactRows rows, boolean isNew, boolean asks) {
        isStale |= isNew;
        isCrushed = crush.find(rows);
        boolean isNeeded = asks || isCrushed;
        grounds.hold(ties, springs, isNeeded, !surface.isEmpty());
        if (isNeeded) {
            groups.find(rows, ties, springs, isStale, !surface.isEmpty());
            groups.trees.find(ties, rows, groups);
            balance.open();
            bounced.open();
            isStale = false;
        }
    }

    /** Ends a step, or one that has failed. */
    void end() {
        grounds.release();
    }

    /** Begins a substep, in which nothing but forces has acted yet. */
    void open() {
        balance.note();
    }

    /** Takes note of what forces that change within the substep have given in its second half; see {@link Halves#reload}. */
    void reload(double[] now, double[] then, double h) {
        balance.force(now, then, 0.5 * h);
    }

    /** Solves the tied bodies that something strikes in this substep some times more: else joints and stops would give way to it, and turn its impact. */
    void bear(Softness contact, Softness joint, double h) {
        boolean[] marks = balance.marks();
        if (impacts.findStruck()) {
            impacts.mark(marks, true);
            for (int k = 0; k < TURNS; k++) {
                ties.solve(marks, joint, h);
                contacts.solve(marks, contact, true, h);
            }
            impacts.mark(marks, false);
        }
    }

    /**
     * Ends a substep.
     *
     * @param a accelerations by forces
     */
    void close(double[] a, Softness contact, Softness joint, double h) {
        if (!balance.isBroken(ties, springs, rows, a, h)) {
            return;
        }
        boolean[] marks = balance.marks();
        if (groups.trees.any() && limit(groups.trees)) {
            return;
        }
        ties.trees().close(marks);
        balance.takeBack();
        grounds.note();
        grounds.takeBack(balance.places());
        contacts.measure(marks);
        regain(marks, contact, joint, h);
        balance.bringBack();
        grounds.bringBack();
        for (int k = 0; k < TURNS; k++) {
            surface.solve(marks, h);
            springs.solve(marks);
            ties.solve(marks, Softness.RIGID, h);
            contacts.solve(marks, Softness.RIGID, false, h);
        }
        limit(null);
        balance.move(h);
        grounds.putBack();
        contacts.follow(marks);
        ties.evaluate(marks);
        balance.forget(null);
    }

    /** Takes off marked groups, or of these only some, what they have got too much; whether these were all. */
    private boolean limit(TreeGroups some) {
        if (balance.limit(some)) {
            ties.limit(balance.shares());
            springs.limit(balance.shares());
            contacts.limit(balance.shares());
        }
        return some != null && !balance.forget(some);
    }

    /** Bounds what moving surfaces give in a substep, which begins. */
    void boundBelts(double[] a, double h) {
        belts.bound(rows, groups, ties, springs, a, h);
    }

    /** Bounds what presses on crushed bodies in a substep, which begins. */
    void boundCrush(double[] a, double h) {
        if (isCrushed) {
            crush.bound(rows, groups, ties, springs, a, h);
        }
    }

    /** How deep a body is now in one that no force moves, at most, relative to the smaller one. */
    double deepestInGround() {
        return crush.deepest(rows);
    }

    /** Begins a step in which something may strike. */
    void expect() {
        impacts.begin();
    }

    /** Notes the gaps of what may strike, before a substep begins. */
    void approach() {
        impacts.approach();
    }

    /**
     * Lets bodies that have met in a substep bounce. What compression has taken, restitution gives once more, in part: of what meets at the same time, joints
     * included, that keeps the energy of elastic bodies, as v⁺ = 2 v − v⁻ is the mirror image of v⁻ in the projection v.
     *
     * @param mean accelerations by forces in the substep, in the mean
     * @param step the step, in which forces make what is no bounce
     * @param h substep
     * @return whether something has met, for which {@link #endBounces} is to be called
     */
    boolean bounce(double[] mean, double step, double h) {
        StopRows stops = ties.stops();
        if (!impacts.find(step, h, balance.speeds(), stops)) {
            return false;
        }
        bounced.bound(balance, mean, h);
        free.begin(balance, mean, step, h);
        reflections.find(step, h, balance);
        impacts.dropMissed();
        boolean[] marks = balance.marks();
        impacts.mark(marks, true);
        ties.keep(groups.slots, marks);
        boolean isDriven = rows.driven > 0;
        if (isDriven) {
            belts.strike(rows, groups, balance.speeds());
        }
        compress(isDriven);
        bounced.begin(rows);
        contacts.note();
        grounds.note();
        reflections.reflect(balance, mean);
        grounds.putBack();
        impacts.restore(turns);
        stops.restore();
        boolean goesOn = true;
        impacts.beginParting(turns);
        for (int turn = 0; goesOn && turn < BOUNCES; turn++) {
            impacts.part(turns);
            stops.part(groups.slots, turns, impacts.fresh());
            ties.settle(turns, impacts.fresh());
            goesOn = turns.goOn();
        }
        stops.part();
        contacts.straighten();
        if (bounced.limit(null)) {
            contacts.limitNoted(bounced.shares());
        }
        ties.putBack(marks, bounced.shares());
        bounced.forget(null);
        free.end(balance, mean);
        reflections.move(balance, mean, h);
        if (groups.areRubbed()) {
            rub(h);
        }
        return true;
    }

    /** Lets the plane rub what has been taken back to its impacts for the substep anew. */
    private void rub(double h) {
        boolean[] marks = free.areTakenBack();
        surface.clear(marks);
        surface.solve(marks, h);
    }

    /** Ends the bounces of a substep. */
    void endBounces() {
        impacts.end();
        reflections.endBounces();
        impacts.mark(balance.marks(), false);
    }

    /** {@return the bodies that have gone on from where they met something} */
    IntList goneOn() {
        return free.goneOn();
    }

    /** Takes note of forces, in the mean, where bodies have met, and where they have gone on from there. */
    void reloadBounced(double[] mean, double[] then, double[] now) {
        free.reload(mean, then, now);
    }

    /** Compresses what has met in turn with its joints; what that throws about, over-relaxed as it is, gets no more energy than it may have. */
    private void compress(boolean isDriven) {
        StopRows stops = ties.stops();
        Freshness fresh = impacts.fresh();
        impacts.beginCompression(turns);
        boolean mayBeLost = impacts.areJoined();
        if (mayBeLost) {
            bounced.begin();
            contacts.note();
        }
        boolean goesOn = true;
        for (int turn = 0; goesOn && turn < BOUNCES; turn++) {
            ties.settle(turns, fresh);
            stops.compress(groups.slots, turns, fresh);
            impacts.compress(turns);
            if (isDriven) {
                belts.boundDriven(rows, groups);
            }
            if (turn == FEW_BOUNCES - 1) {
                impacts.closeLarge(turns);
            }
            goesOn = turns.goOn();
        }
        contacts.straighten();
        boolean isLost = mayBeLost && bounced.takeBackLost();
        if (isLost) {
            contacts.limitNoted(bounced.shares());
        }
        ties.note(isLost ? bounced.shares() : null);
        bounced.forget(null);
    }

    private void regain(boolean[] marks, Softness contact, Softness joint, double h) {
        clear(marks);
        ties.evaluate(marks);
        ties.solve(marks, joint, h);
        contacts.solve(marks, contact, true, h);
        balance.move(h);
        contacts.measure(marks);
        clear(marks);
        ties.evaluate(marks);
    }

    private void clear(boolean[] marks) {
        surface.clear(marks);
        springs.clear(marks);
        ties.clear(marks);
        contacts.clear(marks);
    }
}
