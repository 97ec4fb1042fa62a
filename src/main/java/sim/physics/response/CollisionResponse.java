// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.Objects;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.broad.Pairs;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Ties;
import sim.physics.motion.Trajectories;
import sim.physics.response.lasting.ContactLedger;
import sim.physics.response.lasting.Heaps;
import sim.physics.response.lasting.RestingContacts;

/**
 * Gives colliding bodies their new velocities, the write-up's chapter <i>Collision Response</i>.
 *
 * <p>One point of two bodies is solved by the {@link ImpulseSolver}; several points that touch at the same instant are
 * solved together by {@link SimultaneousImpact}.
 */
public final class CollisionResponse implements Serializable {
    private static final long serialVersionUID = 2L;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final Pairs pairs;

    private ImpulseSolver solver = new TwoBodyImpulse();
    private final ContactLoader loader;
    private final Listeners listeners;

    private final Impact impact = new Impact();
    private final FreeBounce freeBounce;
    private final SimultaneousImpact simultaneous;
    private final SimultaneousImpact part;
    private final ApartImpacts apart;
    private final Meetings meetings = new Meetings();

    /** Null while nothing ties bodies together. */
    private JointedBodies jointed;
    private final IntList changed = new IntList();

    /** The pairs of an instant that have lasted before it: what comes to lie with another one of them strikes with that. */
    private final IntList lasted = new IntList();

    private final Bounces bounces;
    private final RestingContacts resting;
    private final Heaps heaps;
    private final LastingContacts lasting;
    private final ContactLedger ledger;
    private final ContactLaws laws;
    private final Wedged wedged;
    private final ImpactInstant instant;

    /** Where a pair touches. */
    private transient Manifold manifold;

    private long impacts;
    private double deepest;
    private double approach;

    /**
     * Makes the collision response of an engine.
     *
     * @param state the state vectors
     * @param trajectories the motion of the bodies
     * @param motion brings bodies to the instant of an impact
     * @param detection where the impacts come from
     */
    public CollisionResponse(State state, Trajectories trajectories, Motion motion, CollisionDetection detection) {
        this.motion = motion;
        this.state = state;
        this.trajectories = trajectories;
        this.detection = detection;
        this.pairs = detection.pairs();
        this.listeners = new Listeners(state, trajectories);
        this.loader = new ContactLoader(state, trajectories, detection, listeners);
        this.simultaneous = new SimultaneousImpact(state);
        this.part = new SimultaneousImpact(state);
        this.apart = new ApartImpacts(simultaneous, part);
        this.freeBounce = new FreeBounce(state, trajectories, detection.narrowPhase(), loader);
        this.bounces = new Bounces(state, trajectories, motion);
        this.ledger = new ContactLedger(trajectories, pairs);
        this.resting = new RestingContacts(state, trajectories, motion, detection, loader, ledger);
        this.heaps = new Heaps(state, trajectories, motion, detection, loader, resting, ledger);
        this.lasting = new LastingContacts(state, detection, resting, heaps, ledger);
        this.instant = new ImpactInstant(trajectories, motion, detection, loader, heaps, bounces, impact);
        this.laws = new ContactLaws(loader, listeners, lasting);
        this.wedged = new Wedged(trajectories, detection);
    }

    /** Begins a step. */
    public void begin() {
        wedged.begin();
        ledger.begin();
    }

    /** {@return what lasting pairs bear, live} */
    public ContactLedger ledger() {
        return ledger;
    }

    /**
     * When the impact was that was solved last: where driven bodies meet, a little before or after the instant that was searched for.
     *
     * @return offset in the present step
     */
    public double instant() {
        return instant.at();
    }

    /**
     * Solves the impacts of one instant.
     *
     * @param touching the pairs that touch
     * @param tau offset in the present step
     * @param time simulated time of that instant, for listeners
     * @return the bodies whose velocities have changed, each once; valid until the next call
     */
    public IntList respond(IntList touching, double tau, double time) {
        changed.clear();
        lasted.clear();
        for (int k = 0; k < touching.size && !heaps.isEmpty(); k++) {
            if (heaps.lasts(touching.values[k])) {
                lasted.add(touching.values[k]);
            }
        }
        manifold = instant.begin(touching, tau);
        wedged.stalls(tau);
        listeners.setInstant(tau, time);
        if (touching.size == 1) {
            int pair = touching.values[0];
            instant.locate(pair, tau);
            if (manifold.count == 1 && (jointed == null || !jointed.has(pairs.first(pair), pairs.second(pair)))) {
                respondToOne(pair, tau);
                wedged.settle(heaps, instant.at(), changed);
                return changed;
            }
        }
        respondToSeveral(touching);
        wedged.settle(heaps, instant.at(), changed);
        return changed;
    }

    /**
     * Solves the impact of a pair if it is plain, as {@link FreeBounce} has it, and nobody is to be told.
     *
     * @param pair the only one that touches
     * @param tau offset in the present step
     * @return the bodies whose velocities have changed, valid until the next call; none if nothing was solved
     */
    public IntList bounce(int pair, double tau) {
        changed.clear();
        if (!wedged.stalls(tau) && isFree() && solver instanceof TwoBodyImpulse && listeners.isEmpty()) {
            freeBounce.solve(pair, pairs.first(pair), pairs.second(pair), tau, changed);
        }
        impacts += changed.size > 0 ? 1 : 0;
        deepest = changed.size > 0 ? Math.min(deepest, freeBounce.gap()) : deepest;
        return changed;
    }

    /** {@return whether no body has ever been accelerated, and none is tied, rests or lies on another one} */
    public boolean isFree() {
        return trajectories.areStraight() && jointed == null && resting.isEmpty() && heaps.isEmpty();
    }

    /**
     * Sets what ties bodies together.
     *
     * @param ties null for nothing
     */
    public void setTies(Ties ties) {
        jointed = ties == null ? null : new JointedBodies(state, trajectories, motion, ties);
        simultaneous.setTies(ties);
        part.setTies(ties);
        heaps.setTies(ties);
    }

    private void respondToOne(int pair, double tau) {
        int a = pairs.first(pair);
        int b = pairs.second(pair);
        if (isLetBe(pair, a, b, tau)) {
            return;
        }
        if (!instant.polish(pair, a, b)) {
            goOn(a, b);
            return;
        }
        if (!listeners.isEmpty() && !ask(pair, a, b)) {
            return;
        }
        impacts++;
        deepest = Math.min(deepest, manifold.gap);
        boolean canRest = canRest(pair, a, b, tau, true);
        if (bounces.dampRattle(pair, a, b, impact)) {
            bounces.spend(pair, impact);
        } else if (canRest || isInHeap(a, b) || bounces.areCounted(pair, a, b, impact)) {
            bounces.count(pair);
            if (!canRest && startsToLie(pair, a, b)) {
                impact.restitution = 0;
            } else if (bounces.limit(pair, a, b, impact, canRest, isInHeap(a, b))) {
                rest(pair);
            }
            bounces.spend(pair, impact);
            bounces.part(pair, a, impact);
        }
        solver.solve(impact);
        impact.apply();
        store(a, b);
        if (!listeners.isEmpty()) {
            listeners.tell(a, b, impact, approach);
        }
    }

    /** Loads the impact of a pair, unless it is let be as deep as it is, or left to its heap. */
    private boolean isLetBe(int pair, int a, int b, double tau) {
        impact.sticky = false;
        if (jointed != null && jointed.areInOneAnother(a, b, manifold.gap, heaps.size(a, b)) && !heaps.lasts(pair)) {
            letPass(pair, a, b);
            return true;
        }
        instant.load(a, b, 0);
        if (wedged.meet(pair, tau, manifold.gap, heaps.size(a, b))) {
            goOn(a, b);
            return true;
        }
        bounces.attend(a, b, tau);
        return lasted.contains(pair) && closes(pair);
    }

    /** Whether a lasting pair is left to its heap, because a bounce at the loaded points would be short, or one too many. */
    private boolean closes(int pair) {
        int a = pairs.first(pair);
        int b = pairs.second(pair);
        boolean bounds = false;
        impact.sticky = detection.marks().isSticky(pair);
        for (int point = manifold.count - 1; point >= 0; point--) {
            instant.load(a, b, point);
            bounds |= bounces.bounds(pair, impact, heaps.pull(a, b), heaps.size(a, b));
        }
        impact.sticky = false;
        if (bounds) {
            heaps.end(pair);
        }
        return !bounds && heaps.close(pair, manifold.gap);
    }

    /** Lets a pair lie on one another from now on if its bounces have become too many and too short. */
    private boolean startsToLie(int pair, int a, int b) {
        if (!heaps.mayLie(a, b) || !bounces.jams(pair, a, b, impact, isInHeap(a, b), isPut(a, b))) {
            return false;
        }
        unstick(pair);
        heaps.add(pair);
        return true;
    }

    /** Whether two bodies that bounce, but not for ever, meet by rounding only at all of their points; the first of these is loaded afterwards. */
    private boolean isPut(int a, int b) {
        boolean is = impact.restitution > 0 && impact.restitution < 1;
        for (int point = is ? manifold.count - 1 : -1; point >= 0; point--) {
            instant.load(a, b, point);
            is &= bounces.isByRounding(a, b, impact);
        }
        return is;
    }

    private boolean isInHeap(int a, int b) {
        return heaps.has(a) || heaps.has(b);
    }

    /** Whether one of two bodies is fixed and can bear the other one at the points of the manifold, by itself or with others. */
    private boolean canRest(int pair, int a, int b, double tau, boolean alone) {
        boolean fixedA = state.body(a).isImmobile();
        int body = fixedA ? b : a;
        if (fixedA == state.body(b).isImmobile() || trajectories.isDriven(body) || heaps.has(body) || !bounces.mayRest(pair)) {
            return false;
        }
        return alone && !resting.rests(body) && manifold.bears(fixedA)
                || bounces.pressing(a, b, impact) > 0 && resting.isShared(body, tau);
    }

    /**
     * Bodies that rest on one another.
     *
     * @return live
     */
    public RestingContacts resting() {
        return resting;
    }

    /**
     * Bodies that lie on one another.
     *
     * @return live
     */
    public Heaps heaps() {
        return heaps;
    }

    /**
     * What rests and lies on one another, with its forces.
     *
     * @return live
     */
    public LastingContacts lasting() {
        return lasting;
    }

    /** The listeners want the pair to pass: both go on as they came. */
    private void letPass(int pair, int a, int b) {
        detection.marks().letPass(pair);
        goOn(a, b);
    }

    private void goOn(int a, int b) {
        changed.add(a);
        changed.add(b);
    }

    /**
     * Sets what solves the impact of one point of two bodies.
     *
     * @param solver not null
     */
    public void setSolver(ImpulseSolver solver) {
        boolean isBordered = Objects.requireNonNull(solver, "solver") instanceof BorderedImpulse;
        simultaneous.setBordered(isBordered);
        part.setBordered(isBordered);
        this.solver = solver;
    }

    /** {@return what authors say of contacts, live} */
    public ContactLaws laws() {
        return laws;
    }

    /** {@return number of pairs that have collided since the engine was made} */
    public long impacts() {
        return impacts;
    }

    /** {@return the smallest gap at which a collision was ever solved, 0 or negative} */
    public double deepest() {
        return deepest;
    }

    private void store(int a, int b) {
        Impact c = impact;
        if (c.wA != 0) {
            setVelocity(a, c.vAx, c.vAy, c.omegaA);
        }
        if (c.wB != 0) {
            setVelocity(b, c.vBx, c.vBy, c.omegaB);
        }
    }

    private void setVelocity(int body, double vx, double vy, double omega) {
        double[] d = trajectories.data();
        int o = body * Trajectories.STRIDE;
        d[o + Trajectories.VX] = vx;
        d[o + Trajectories.VY] = vy;
        d[o + Trajectories.OMEGA] = omega;
        changed.add(body);
    }

    private void respondToSeveral(IntList touching) {
        simultaneous.clear();
        meetings.count(touching, pairs, state.size());
        if (touching.size > 1) {
            instant.polish(touching);
        }
        double tau = instant.at();
        for (int k = 0; k < touching.size; k++) {
            collect(touching, touching.values[k], tau);
        }
        if (simultaneous.pointCount() == 0) {
            return;
        }
        apart.solve();
        for (int k = 0; k < simultaneous.bodyCount(); k++) {
            double[] v = simultaneous.velocity(k);
            setVelocity(simultaneous.body(k), v[0], v[1], v[2]);
        }
        if (jointed != null) {
            jointed.settle(changed);
        }
        if (!listeners.isEmpty()) {
            listeners.tell(simultaneous, impact);
        }
    }

    /** Adds the points of one pair to the simultaneous impact. */
    private void collect(IntList touching, int pair, double tau) {
        int a = pairs.first(pair);
        int b = pairs.second(pair);
        instant.locate(pair, tau);
        if (isLetBe(pair, a, b, tau)) {
            return;
        }
        if (touching.size == 1) {
            instant.polish(pair, a, b);
        }
        if (jointed != null) {
            jointed.prepare(a, b);
        }
        if (listeners.isEmpty() || ask(pair, a, b)) {
            impacts++;
            deepest = Math.min(deepest, manifold.gap);
            add(pair, a, b, tau);
        }
    }

    /** Adds the points of a pair that collides: it bounces, rattles, comes to lie in a heap, or to rest on what is fixed. */
    private void add(int pair, int a, int b, double tau) {
        boolean isEndless = jointed != null && jointed.has(a, b) && bounces.isEndless(pair);
        boolean isLocked = isEndless && heaps.resume(a, b) && startsToLie(pair, a, b);
        boolean rattles = !isLocked && bounces.dampRattle(pair, a, b, impact);
        double rattle = impact.restitution;
        double first = -impact.normalVelocity();
        bounces.count(pair);
        bounces.writeOff(pair);
        int body = state.body(a).isImmobile() ? b : a;
        boolean canRest = canRest(pair, a, b, tau, meetings.isOnly(body));
        boolean lies = isLocked || !rattles && !canRest && (heaps.lasts(pair) || startsToLie(pair, a, b));
        boolean restsNow = !rattles && !lies;
        impact.isEarly = bounces.areFew(pair);
        for (int point = 0; point < manifold.count; point++) {
            instant.load(a, b, point);
            if (rattles || lies) {
                impact.restitution = lies ? 0 : bounces.rattle(impact, rattle, first);
            } else {
                restsNow &= (canRest || impact.restitution < 1) && bounces.limit(pair, a, b, impact, canRest, isInHeap(a, b));
            }
            simultaneous.add(a, b, impact);
        }
        impact.isEarly = false;
        if (!rattles) {
            bounces.part(pair, a, impact);
        }
        if (restsNow) {
            rest(pair);
        }
    }

    /** Lets a body rest on a fixed one from now on. */
    private void rest(int pair) {
        unstick(pair);
        resting.add(pair);
        bounces.rest(pair);
    }

    /** What lies down sticks only if the listeners of now say so. */
    private void unstick(int pair) {
        if (!impact.sticky) {
            detection.marks().setSticky(pair, false);
        }
    }

    /** Asks the listeners what to do about a pair's impact, which is loaded with what they set; false if it is let be, or there is none any more. */
    private boolean ask(int pair, int a, int b) {
        CollisionListener.Decision decision = listeners.ask(a, b, impact, detection.filter());
        detection.marks().setSticky(pair, impact.sticky);
        if (decision == CollisionListener.Decision.IGNORE) {
            letPass(pair, a, b);
            return false;
        }
        boolean isSet = decision != null && (listeners.takeOver(a) | listeners.takeOver(b));
        boolean meet = decision != null && !isSet;
        for (int point = manifold.count - 1; point >= 0; point--) {
            instant.load(a, b, point);
            meet |= isSet && impact.normalVelocity() < 0;
        }
        approach = -impact.normalVelocity();
        if (!meet) {
            goOn(a, b);
        }
        return meet;
    }
}
