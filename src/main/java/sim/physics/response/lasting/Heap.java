// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Ties;
import sim.physics.motion.Trajectories;

/**
 * The heap that is being solved: finds its bodies and points, and gives it new velocities. One solution holds for a step, or
 * for as long as the bodies turn little.
 */
final class Heap implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Gap from which a lasting pair has parted, relative to the smaller body. */
    private static final double PARTED = 1e-2;

    /** Change of velocity that is none, relative to the speeds. */
    private static final double SAME = 1e-13;

    /** Speed that is none, relative to what forces give, at the start and at the end of a step of bodies that the integrator drives. */
    private static final double RESTING = 1e-9;

    /** Turn of a body, rad, for which a solution holds; how many there are in a step at most. */
    private static final double TURN = 0.1;

    private static final int SOLUTIONS = 1000;

    /** Part of a step in which forces are but the rounding of impulses: none are to start from those. */
    static final double SLIVER = 5e-5;

    /** Part of the work of contacts in a time which it is at least in a shorter one where that is of no use. */
    private static final double HARDLY_LESS = 0.25;

    /** Times that something may happen to a body in a step before its heap hops for the rest of it. */
    private static final int MOST = 50;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final ContactPoints points;
    private final HeapBodies by;
    private final ContactLedger ledger;
    final BodyScale scales;
    final HeapSystem system = new HeapSystem();
    private final HeapStrike striking;
    private final HeapClosing closing;
    final HeapPull pulls;
    private final HeapEffort effort;
    private final FlushGround flush;
    final HeapMembers members;
    private final IntList heap;
    private final Regain regain = new Regain();
    private final HeapNotes notes;
    final DrivenHeap driving;
    private final RubbedHeap rubbing;
    private final FreeHeap free;
    private final HeapCourses courses;
    private final HeapEnd ending;
    final LargeHeaps large;
    final LastingPairs lasting;
    private final double[] fall = new double[State.BLOCK];
    private final ContactPoint point = new ContactPoint();
    private transient Manifold manifold;

    /** Until when the velocities are to hold, and whether those before held until now. */
    private double until;
    private boolean isFresh;

    /** Whether bodies that have got what the forces give them until then are solved for anew, because one has been struck. */
    private boolean isResumed;

    /** Whether bodies of the heap are driven. */
    private boolean isDriven;

    /** Whether bodies rub on the plane on which they lie, or are driven over one on which others rub, and none is tied; in the end not this and driven. */
    private boolean isRubbed;

    /** Whether bodies are tied to others. */
    private boolean isTied;

    /** Whether the heap is so large that it is solved roughly, and whether its pairs may be as deep as if it was. */
    private boolean isRough;
    private boolean isLax;

    /** How much of gaps the paths of driven bodies may take while forces hold, relative to the smaller body. */
    private double sag;

    /** Points of tied bodies that are deeper than they may be, by the error of an instant. */
    private final IntList deep = new IntList();

    /** Whether bodies get half of what forces give them in the time, and the second half when it is over. */
    private boolean isHalf;

    /** Whether it hops or is halted, and whether so much has happened to it in the step that rounding may hold it where it is. */
    private boolean halts;
    private boolean isStuck;
    private double scale;

    Heap(
            State state, Trajectories trajectories, Motion motion, CollisionDetection detection,
            ContactPoints points, HeapBodies by, ContactLedger ledger) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        this.points = points;
        this.by = by;
        this.ledger = ledger;
        this.flush = new FlushGround(state, trajectories, detection);
        this.notes = new HeapNotes(system, ledger);
        this.scales = new BodyScale(state, trajectories);
        this.pulls = new HeapPull(state, motion);
        this.effort = new HeapEffort(scales);
        this.driving = new DrivenHeap(state, trajectories, motion, by, system, notes, scales, pulls, regain);
        this.free = new FreeHeap(detection, by, system, notes, scales);
        this.courses = new HeapCourses(trajectories, by);
        this.lasting = new LastingPairs(trajectories, detection, scales, ledger);
        this.closing = new HeapClosing(trajectories, by, system, courses, scales, new HeapMeeting(state, motion, detection, points, by, lasting));
        this.striking = new HeapStrike(system, notes, courses, scales);
        this.members = new HeapMembers(state, trajectories, motion, detection, by, lasting, scales, pulls);
        this.heap = members.bodies();
        this.ending = new HeapEnd(state, trajectories, motion, detection, points, by, system, members, scales, ledger, flush.seams());
        this.large = new LargeHeaps(trajectories, by, new Foresight(state, trajectories, pulls, detection, points, scales));
        this.rubbing = new RubbedHeap(trajectories, motion, by, system, notes, scales, driving.search().turning);
    }

    void setTies(Ties those) {
        members.setTies(those);
    }

    /** Solves the heap of a body; notes those whose courses change, and those that have parted from it. */
    void settle(int seed, double tau, IntList changed, IntList parted) {
        complete(seed, tau, changed);
        find(seed, tau);
        if (!isEven() && large.leaves(heap)) {
            return;
        }
        if (isFresh && !isEven() && heap.size <= FreeHeap.FEW && members.split(tau, PARTED, parted)) {
            find(seed, tau);
        }
        flush.spread(heap, tau, HeapGaps.depth(isEven(), 1), lasting);
        if (isDriven) {
            driving.unpay(heap, tau, members.ties());
        } else if (isRubbed) {
            rubbing.unpay(heap, tau);
        }
        isResumed = !isFresh;
        courses.begin();
        press(tau, true);
        moderate(tau);
        solve(tau);
        publish(tau, changed);
    }

    /** Gives the heap of a body the second half of what it is given, if the time of its solution is over. */
    void complete(int seed, double tau, IntList changed) {
        if (!ending.isDue(seed, tau)) {
            return;
        }
        find(seed, tau);
        ending.complete(tau, changed);
    }

    /**
     * Lets forces hold for a shorter time if contacts give too much in theirs. Where normals turn away that falls with the square of it; where
     * levers make work of gaps that are regained it is as large in any, and these are let be, once, before the time is made shorter still.
     */
    private void moderate(double tau) {
        double first = until - tau;
        double work = Double.POSITIVE_INFINITY;
        boolean regains = true;
        while (isDriven && effort.isTooMuch(system, courses.before(), pulls, heap, until - tau, trajectories.h())) {
            boolean isStiff = regains && effort.work() > HARDLY_LESS * work;
            regains &= !isStiff;
            work = effort.work();
            until = tau + (isStiff ? first : Math.max(effort.shorter(), trajectories.h() / SOLUTIONS));
            by.hold(heap, until - tau);
            driving.unpay(heap, tau, members.ties());
            press(tau, !isStiff);
        }
    }

    /** Takes in the heap, ends what closes too fast in it, and finds what drives it; gaps are regained or not. */
    private void press(double tau, boolean regains) {
        gather(tau);
        if (isDriven) {
            driving.gather(heap, members.ties(), regain, scale);
        }
        if (isRubbed && by.mostTurns(heap) > MOST) {
            closing.hop(deep);
        }
        if (isEven() && striking.act(heap, deep, scale, closing.rebounds(), driving.rebounds()) && isDriven) {
            gather(tau);
            driving.gather(heap, members.ties(), regain, scale); // which stops are within reach is another question now
        }
        effort.setReach(isDriven ? driving.reach(heap, until - tau) : 0);
        if (isDriven) {
            if (!regains) {
                system.regainNothing();
            }
            scale = driving.search().drive(heap, until - tau, Math.max(scale, isTied ? effort.reach() : closing.known(heap, until - tau)), regains);
            closing.learn(heap, until - tau);
        }
    }

    /** Whether what the heap does to its bodies acts evenly over the time of the solution; else it does at its start. */
    private boolean isEven() {
        return isDriven || isRubbed;
    }

    /** Finds the heap of a body, and until when the velocities of its bodies are to hold. */
    private void find(int seed, double tau) {
        members.find(seed, tau);
        isTied = members.isTied();
        boolean isAlone = !isTied && !members.isCoupled(); // only what moves by itself can be stopped
        isStuck = by.mostTurns(heap) > MOST;
        isRubbed = isAlone && (members.isRubbed() || members.isDriven() && isStuck);
        isDriven = !isRubbed && (members.isDriven() || isAlone && members.areFollowed() && !isStuck);
        isRough = !isEven() && !isTied && large.isRough(heap);
        isFresh = !members.isStruck() || isEven();
        isHalf = isFresh && !isEven() && !pulls.isFalling() && !isTied && !isRough && !LargeHeaps.isLarge(heap.size) && !large.wasRough(heap);
        double h = trajectories.h();
        double length = members.bending() * h > TURN && !isRough ? TURN / members.bending() : h;
        length = Math.max(isEven() ? Math.min(length, by.pace(heap, h, h / SOLUTIONS)) : length, h / SOLUTIONS);
        sag = isDriven ? by.sag[seed] : 0;
        until = Math.min(isEven() ? h : members.paidUntil(), tau + length);
        until = h - until < 0.5 * h / SOLUTIONS ? h : until;
    }

    /** Takes in the bodies of the heap and their points; the time ends where the first of these strikes. */
    private void gather(double tau) {
        take(tau);
        if (!isRough && heap.size <= FreeHeap.FEW && by.mostTurns(heap) <= MOST && strikes(tau, trajectories.h() / SOLUTIONS)) {
            take(tau);
        }
    }

    /** Lets points strike that do so now, or else the time end where the first of them does; whether there were any. */
    private boolean strikes(double tau, double shortest) {
        if (isResumed) {
            closing.bounce(pulls.most(heap), shortest);
        } else {
            double first = closing.first(heap, scale, until - tau, shortest);
            if (first < until - tau) {
                until = tau + first;
                take(tau);
            } else if (closing.gathers(heap, members.ties(), tau)) {
                take(tau);
                closing.first(heap, scale, until - tau, shortest);
            }
            closing.hold(heap);
        }
        return !isEven() && closing.strikes() && striking.actFirst(heap, deep, scale, closing.rebounds());
    }

    /** Takes in the bodies of the heap and their points. */
    private void take(double tau) {
        manifold = manifold == null ? new Manifold() : manifold;
        notes.clear();
        system.clear();
        deep.clear();
        scale = 0;
        isLax = isRough || !isEven() && !isTied && large.isLax(heap);
        large.begin();
        flush.seams().forget();
        system.tolerance().hurry(!isRough && large.wasRough(heap));
        system.tolerance().roughen(isRough);
        if (!isEven()) {
            free.begin(heap);
        }
        boolean isPaid = isResumed && (pulls.isOnAny(heap) || pulls.isFalling()); // else what contacts give is given at once
        for (int k = 0; k < heap.size; k++) {
            enter(k, tau, isPaid);
        }
        regain.set(Math.max(until - tau, SLIVER * trajectories.h()), trajectories.h(), scale);
        IntList pairs = members.pairs(tau);
        for (int k = 0; k < pairs.size; k++) {
            collect(pairs.values[k], tau);
        }
    }

    private void enter(int k, double tau, boolean isPaid) {
        int body = heap.values[k];
        double[] w = state.w().values();
        system.enter(k, w[State.BLOCK * body], w[State.BLOCK * body + State.THETA]);
        pulls.give(body, fall);
        double pull = Math.sqrt(fall[0] * fall[0] + fall[1] * fall[1]) + scales.radius(body) * Math.abs(fall[2]);
        scale = Math.max(scale, pull * (until - tau));
        courses.enter(k, body, tau, system.v, isPaid);
        for (int c = 0; c < State.BLOCK && !isEven(); c++) {
            system.v[3 * k + c] += fall[c] * FreeHeap.given(until - tau, isHalf);
        }
    }

    /** Takes in the points of a pair, or finds that it has parted. */
    private void collect(int pair, double tau) {
        int a = detection.pairs().first(pair);
        int b = detection.pairs().second(pair);
        double size = scales.size(a, b);
        detection.narrowPhase().contact(pair, tau, manifold, HeapGaps.flat(size, scales.radius(a) + scales.radius(b)));
        if (manifold.gap > PARTED * size && !(isRough && large.foresees(pair))) {
            members.part(pair, tau, isFresh);
            return;
        }
        large.meet(manifold.gap, size);
        ledger.open(pair, tau, manifold, !state.body(a).isImmobile());
        double left = regain.time();
        double rounding = detection.narrowPhase().roundingOfGap();
        double depth = isEven() ? HeapGaps.depth(!pulls.isFalling(), size, rounding) : HeapGaps.depth(manifold.gap, size, rounding);
        detection.marks().setDepth(pair, isLax ? HeapGaps.depthOfMany(manifold.gap, size) : isRubbed || isDriven && isStuck
                ? HeapGaps.slack(manifold.gap, depth) : isDriven && !members.isDriven() ? HeapGaps.watched(manifold.gap, depth) : depth);
        system.tolerance().allow(HeapGaps.littleSpeed(depth, left), HeapGaps.isDeeper(depth, size, rounding));
        for (int k = 0; k < manifold.count && !manifold.isAtEnds; k++) {
            if (flush.seams().has(pair, k, tau)) {
                ledger.setStart(pair, k, 0, 0);
                continue;
            }
            points.load(manifold, pair, k, point);
            manifold.slide(k, point.slip);
            flush.seams().follow(pair, k, manifold);
            int p = system.size();
            system.add(members.number(a), members.number(b), point);
            notes.add(pair, k, manifold.gaps[k]);
            if (isTied && manifold.gaps[k] < -depth || isRubbed && HeapGaps.isNearly(manifold.gaps[k], depth)) {
                deep.add(p);
            }
            double roam = isDriven ? scales.roam(a, b, scale / left) : 0;
            double full = scales.bend(manifold, point, a, b, left);
            double bend = isDriven ? scales.bendOfTurned(point, full, roam) + size * regain.sag(sag)
                    : isRubbed ? 0 : isHalf ? free.follow(p, manifold, k, point, depth, full, size, left) : full;
            double any = isLax ? HeapGaps.leastSpeedOfMany(manifold.gaps[k], bend, size, regain)
                    : HeapGaps.leastSpeed(manifold.gaps[k], depth, bend, regain, isFresh, isEven(), isTied);
            boolean isKnown = isResumed && any > 0 && !isLax;
            system.bound(p, isKnown ? HeapGaps.asFound(any, system.normal(p, courses.before()), manifold.gaps[k] + depth, bend, left) : any);
            closing.set(p, manifold.gaps[k], full, size, points.restitution(a, b),
                    ledger.presses(pair) && manifold.gaps[k] <= manifold.gap + HeapGaps.fairDepth(size));
            if (isEven()) {
                double kept = isRubbed ? HeapGaps.room(depth) : roam > HeapTurn.LONG ? bend : size * regain.sag(sag);
                driving.turn(p, manifold, k, Math.min(-depth, manifold.gaps[k]) + kept, roam);
            }
            system.drift(p, isHalf ? 0.5 * left * point.drifting() : 0);
            if (!isEven()) {
                free.take(p, size, left, FreeHeap.given(left, isHalf), isFresh || scale > 0);
            }
        }
    }

    private void solve(double tau) {
        boolean done = findImpulses(tau);
        if (isHalf && tau == 0 && heap.size <= FreeHeap.FEW) {
            done = findUntilStop(tau, until - tau, done);
        }
        if (!isEven() && !isRough && !large.judge(heap, system, done, scales.fastest(heap, system.v))) {
            isRough = true;
            take(tau);
            done = findImpulses(tau);
        }
        halts = by.mostTurns(heap) > MOST && !isDriven;
        boolean isPressed = pulls.isOnAny(heap); // else it would hop deeper and deeper, and is halted
        boolean isDear = isDear(tau, isPressed);
        boolean mayShorten = isDear && !halts && !isDriven && !isRough && (isRubbed ? isPressed : free.isShort(heap, pulls));
        while (isDear && mayShorten && until - tau > FreeHeap.SHORTEST * trajectories.h() / SOLUTIONS) {
            double shorter = Math.max(effort.shorter(), trajectories.h() / SOLUTIONS);
            done = findImpulses(tau, isRubbed ? rubbing.hold(heap, shorter) : FreeHeap.SHORTER * (until - tau)); // what lifting takes falls with it
            isDear = isDear(tau, isPressed);
        }
        if (isDear) {
            system.unwedge(isDriven);
        }
        if (halts && isPressed) {
            done = isRubbed ? regainNothing() : free.hop(heap, courses.before(), from(), scale, regain.time());
            notes.deepen(detection, scales);
        } else if (isDear) {
            done = regainNothing(); // that must not add energy
            by.afford(heap, HeapEnergy.gained(system, from()), 0);
        }
        if (isDriven && !members.isDriven()) {
            driving.settle(heap, courses.before(), until - tau);
        }
        notes.press(pulls.isFalling() && !isEven() ? 0 : FreeHeap.given(until - tau, isHalf), isEven());
        if (isDriven) {
            driving.note(detection);
        }
        if (isFresh && until - tau >= SLIVER * trajectories.h()) {
            notes.note(FreeHeap.given(until - tau, isHalf), done || !system.isTied());
        }
        if (isRubbed) {
            rubbing.end(heap, until - tau);
        }
        if (halts && !isPressed) {
            driving.halt(heap);
        }
    }

    /** Whether contacts give more than they may. */
    private boolean isDear(double tau, boolean isPressed) {
        if (isRubbed && isPressed) {
            effort.isTooMuch(system, courses.before(), pulls, heap, until - tau, trajectories.h());
        }
        return isDriven || isRubbed && isPressed ? effort.isOver() : HeapEnergy.isWedged(system, from()) || !free.affords(heap, pulls, from(), isHalf);
    }

    /** Solves for the impulses of the points that have been taken in; false if they are not right. */
    private boolean findImpulses(double tau) {
        scale = isDriven ? scale : Math.max(scale, scales.fastest(heap, system.v));
        boolean done = isDriven ? driving.search().isRight()
                : isRubbed ? rubbing.solve(heap, tau, until - tau, scale) : free.solve(heap, scale, regain.time(), isHalf);
        return isDriven || !HeapEnergy.locks(system, isRubbed ? HeapEnergy.HELD : HeapEnergy.LOCKED) ? done
                : isRubbed ? rubbing.giveWay(heap, scale, detection) : free.giveWay(scale, regain.time(), done);
    }

    /** The same for another time. */
    private boolean findImpulses(double tau, double time) {
        until = tau + time;
        gather(tau);
        return findImpulses(tau);
    }

    /** The same until a point first stops sliding, if one does within the time: from then on friction holds, or acts the other way. */
    private boolean findUntilStop(double tau, double time, boolean isDone) {
        double least = FreeHeap.SLIDES * pulls.most(heap) * time;
        double stop = free.firstStop(courses.before(), time, least, trajectories.h() / SOLUTIONS);
        if (stop <= FreeHeap.STUCK * time) {
            findImpulses(tau, FreeHeap.SOON * stop);
            stop = Math.min(time, free.firstStop(courses.before(), until - tau, least, trajectories.h() / SOLUTIONS));
        }
        return until - tau == time && stop >= time ? isDone : findImpulses(tau, stop);
    }

    /** The velocities from which on energy is counted. */
    private double[] from() {
        return isRubbed ? rubbing.alone() : isResumed && system.fastestBelt() == 0 ? courses.before() : system.free();
    }

    private boolean regainNothing() {
        return isDriven ? driving.search().regainNothing(scale)
                : !isRubbed ? free.regainNothing(scale, regain.time())
                : halts ? rubbing.hop(heap, deep, scale) : rubbing.regainNothing(heap, regain.time(), scale);
    }

    /** Whether something has happened to a body of a heap that stands still. */
    boolean stirs(int body) {
        return driving.stirs(body, members.ties());
    }

    private void publish(double tau, IntList changed) {
        double pull = pulls.most(heap);
        boolean isDissolved = system.contacts() == 0 && isFresh;
        boolean still = system.contacts() > 0 && !halts && isFresh && !isEven() && free.isStill(scales.fastest(heap, system.v), pull * (until - tau));
        still = still && free.bear(heap, motion, scale, until - tau, pull, isHalf);
        if (!still && until < trajectories.h()) {
            members.plan(until);
        }
        if (isDriven && !isDissolved) {
            driving.publish(heap, until - tau, members.isDriven());
        }
        boolean stands = isRubbed && !halts && rubbing.isStill(heap);
        stands |= isDriven && isFresh && system.contacts() > 0 && driving.rest(heap, until - tau, RESTING * Math.max(pull * (until - tau), effort.reach()));
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            by.place[body] = 0;
            by.isStill[body] = still || stands;
            large.solved(body, isRough && !still);
            boolean isChanged = true;
            if (isDissolved) {
                driving.dissolve(body, members.ties());
            } else if (isRubbed) {
                rubbing.publish(k, body, until - tau, halts, fall);
            } else if (isDriven) {
                by.isHalf[body] = false;
                by.paidUntil[body] = trajectories.isDriven(body) && !stands ? until : 0;
            } else {
                isChanged = send(k, body, tau, still);
            }
            if (isChanged) {
                changed.add(body);
            }
        }
    }

    /** Gives a body that nothing drives its velocity; false if it goes on as it did. */
    private boolean send(int k, int body, double tau, boolean isStill) {
        by.isHalf[body] = false;
        if (isResumed && !members.areTurned() && courses.keeps(k, body, tau, until, system.v, SAME * scale)) {
            return false;
        }
        by.paidUntil[body] = isStill || pulls.isFalling() ? 0 : until;
        courses.set(k, body, tau, system.v, isHalf && !isStill);
        pulls.endSeen(body);
        return true;
    }
}
