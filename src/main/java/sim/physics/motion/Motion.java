// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.List;
import java.util.Objects;
import sim.physics.internal.IntList;
import sim.physics.internal.Work;

/**
 * Moves the bodies through a step, the write-up's chapter <i>Motion</i>: (5)–(15).
 *
 * <p>It models only what a body needs. A body under no force, or under uniform fields and the forces that were applied
 * to it for one step, follows its parabola and is not touched at all. Only bodies on which other generators act are
 * <i>driven</i> by the integrator: each alone, or with those that forces or ties connect with it.
 */
public final class Motion implements EquationsOfMotion, Loads, Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Trajectories trajectories;
    final Forces forces;
    final Generators generators;
    private final CoupledGroups groups;
    private Integrator integrator = new RungeKutta4();
    double time;

    final Work work;

    /** Driven bodies in ascending order; bodies with an applied force in this step. */
    private final IntList driven;
    private final Applied pushed;
    private final IntList alone = new IntList();
    private final double[] fallen = new double[State.BLOCK];
    final DrivenMotion drivenMotion;

    /** Null until somebody asks. */
    private transient LatePaths late;
    /** Null while nothing ties bodies together; what bears bodies at rest. */
    Ties ties;
    final Support support;
    private final Ground ground;

    /**
     * Makes the motion of an engine.
     *
     * @param state the state vectors
     * @param trajectories where the paths are written
     * @param work takes note of what it costs
     */
    public Motion(State state, Trajectories trajectories, Work work) {
        this.work = work;
        this.state = state;
        this.trajectories = trajectories;
        this.forces = new Forces(state);
        this.generators = new Generators();
        this.groups = new CoupledGroups(state, generators);
        this.driven = new IntList();
        this.pushed = new Applied(state);
        this.support = new Support();
        this.drivenMotion = new DrivenMotion(this, state, trajectories);
        this.ground = new Ground(this, state, trajectories);
    }

    /** Another motion of the same bodies under the same forces, with workspace, method and ties of its own. */
    Motion(Motion original) {
        work = new Work();
        state = original.state;
        trajectories = original.trajectories;
        forces = new Forces(state);
        generators = original.generators;
        groups = original.groups;
        driven = original.driven;
        pushed = original.pushed;
        support = original.support;
        drivenMotion = new DrivenMotion(this, state, trajectories);
        ground = new Ground(this, state, trajectories); // it works in memory of its own
    }

    /**
     * Sets who is told of what driven bodies have done.
     *
     * @param observer null for nobody
     */
    public void setObserver(CourseObserver observer) {
        drivenMotion.setObserver(observer);
    }

    /** {@return which bodies forces couple, live} */
    public CoupledGroups groups() {
        return groups;
    }

    /** {@return the groups that get their paths only when something happens, live} */
    public LatePaths late() {
        late = late == null ? new LatePaths(this, state, trajectories) : late;
        return late;
    }

    /** {@return the plane on which bodies rub, live} */
    public Ground ground() {
        return ground;
    }

    /** Goes through a time from where the state vectors have a group, whatever its paths are. */
    void cover(IntList group, double startOfStep, double from, double to) {
        time = startOfStep;
        drivenMotion.cover(group, from, to);
    }

    /**
     * Sets what ties bodies together.
     *
     * @param ties null for nothing
     */
    public void setTies(Ties ties) {
        this.ties = ties;
        drivenMotion.setTies(ties);
    }

    /**
     * {@return whether a body is tied to others; false for fixed ones}
     *
     * @param body index
     */
    public boolean isTied(int body) {
        return ties != null && ties.isTied(body);
    }

    /** {@return the integrator of driven bodies, never null} */
    public Integrator getIntegrator() {
        return integrator;
    }

    /**
     * Sets the integrator of driven bodies.
     *
     * @param integrator not null
     */
    public void setIntegrator(Integrator integrator) {
        this.integrator = Objects.requireNonNull(integrator, "integrator");
    }

    /**
     * The force generators.
     *
     * @return a copy, in the order in which they were added
     */
    public List<ForceGenerator> generators() {
        return generators.copy();
    }

    /**
     * Adds a generator; the bodies must be admitted again.
     *
     * @param generator not null
     * @return false if it was there already
     */
    public boolean add(ForceGenerator generator) {
        return generators.add(generator);
    }

    /**
     * Removes a generator; the bodies must be admitted again.
     *
     * @param generator one that was added
     * @return false if it was not there
     */
    public boolean remove(ForceGenerator generator) {
        return generators.remove(generator);
    }

    /**
     * Sets the simulated time of the start of the step.
     *
     * @param startOfStep time
     */
    public void begin(double startOfStep) {
        time = startOfStep;
        drivenMotion.begin();
        late().begin();
        state.setUnsettled(true);
    }

    /**
     * Takes a body in, or takes note that its block was written: anchors it there and decides how it moves on.
     *
     * @param body index
     * @param tau offset in the present step
     */
    public void admit(int body, double tau) {
        trajectories.anchor(body, tau, state);
        if (tau == 0 && state.isOnlyPushed(body)) {
            drivenMotion.push(body);
        } else {
            drivenMotion.forget(body);
        }
        Body view = state.body(body);
        support.release(body);
        setDriven(body, !view.isImmobile() && (isTied(body) || generators.drive(view)));
        if (view.isImmobile()) {
            return;
        }
        pushed.admit(body);
        if (!ground.hold(body)) {
            course(body);
        }
    }

    /** Sets the parabola of a body that is not driven, from its anchor on. */
    void course(int body) {
        if (trajectories.isDriven(body)) {
            return;
        }
        if (support.holds(body)) {
            trajectories.accelerate(body, 0, 0, 0);
            return;
        }
        fall(body, fallen, 0);
        double ax = fallen[0] + support.acceleration(body, 0);
        trajectories.accelerate(body, ax, fallen[1] + support.acceleration(body, 1), fallen[2] + support.acceleration(body, 2));
    }

    /** {@return whether forces were applied to a body for the last step} */
    public boolean isPushed() {
        return pushed.isAny();
    }

    /**
     * Lets the forces that were applied for the step before act no longer.
     *
     * @param changed takes the bodies whose course changes, but for those that are about to be admitted
     */
    public void endApplied(IntList changed) {
        pushed.end(this, trajectories, changed);
    }

    /** Ends the step: writes where the driven bodies are; the forces that were applied for the step have acted. */
    public void finish() {
        drivenMotion.finish(driven);
        pushed.clear();
        state.setUnsettled(false);
    }

    /** Keeps where the paths of driven bodies end, before the first event of a step uses the state vectors. */
    public void keepEnds() {
        drivenMotion.keepEnds(driven);
    }

    void setDriven(int body, boolean yes) {
        boolean was = trajectories.isDriven(body);
        trajectories.setDriven(body, yes);
        if (yes) {
            state.f(); // makes room for forces
        }
        if (yes != was) {
            late().forget();
        }
        if (yes && !was) {
            driven.insert(body);
        } else if (was && !yes) {
            driven.takeOut(body);
        }
    }

    /**
     * Forgets a body.
     *
     * @param body index
     */
    public void remove(int body) {
        setDriven(body, false);
        support.release(body);
        generators.forget(body);
        drivenMotion.push(body);
    }

    /** {@return the driven bodies: indices in ascending order, live} */
    public IntList driven() {
        return driven;
    }

    /**
     * The bodies that move together with a body, itself included: those that forces or ties connect with it.
     *
     * @param body index of a driven body
     * @return in ascending order; valid until the next call
     */
    public IntList companions(int body) {
        IntList group = groups.of(body);
        if (group != null) {
            return group;
        }
        return isTied(body) ? ties.island(body) : alone.only(body);
    }

    /**
     * Advances a driven body, and those that move with it, from their anchors on, and sets their paths.
     *
     * @param body index
     * @param neighbours says whether others are near, so that paths must be near the motion; null: they are
     * @return offset up to which the path holds: h, or less if the body stops or must be looked at again before
     */
    public double advance(int body, Neighbours neighbours) {
        return drivenMotion.advance(companions(body), neighbours);
    }

    /** {@return whether the last paths may be farther from the motion than what is near others may be; not after a step of fixed length} */
    public boolean isCoarse() {
        return drivenMotion.isCoarse();
    }

    /**
     * {@return whether bodies that move together stand still under their contacts, as in the last step, and nobody audits it}
     *
     * @param group indices
     */
    public boolean areStaying(IntList group) {
        return drivenMotion.repose.areStaying(group) && !drivenMotion.isObserved();
    }

    /**
     * {@return offset in the present step of the last change of a body's velocity, where something is driven; 0 if there was none}
     *
     * @param body index
     */
    public double smoothSince(int body) {
        return drivenMotion.smoothSince(body);
    }

    /**
     * The time in which a body's motion changes little: the step, or that of an integrator which chooses it.
     *
     * @param body index
     * @return time, greater than 0
     */
    public double pace(int body) {
        return trajectories.isDriven(body) ? drivenMotion.pace(body) : trajectories.h();
    }

    /**
     * Brings a body, and those that move with it, to an instant: driven ones by the integrator from their anchors.
     *
     * @param body index
     * @param tau offset in the present step
     */
    public void bring(int body, double tau) {
        if (!trajectories.isDriven(body)) {
            trajectories.bring(body, tau);
        } else if (tau != trajectories.offset(body)) {
            drivenMotion.bring(companions(body), tau);
        }
    }

    /**
     * Puts the anchors of bodies back into the state vectors.
     *
     * @param group driven bodies
     */
    public void restore(IntList group) {
        drivenMotion.restore(group);
    }

    /** The simulated time of an offset in the present step. */
    double time(double tau) {
        return time + tau;
    }

    boolean isTiedGroup(IntList group) {
        int first = group.values[0];
        return ties != null && (groups.isCoupled(first) ? groups.isTied(first) : ties.isTied(first));
    }

    /** Lets what contacts gave to driven bodies in the last step act no longer. */
    public void releaseDriven() {
        support.pushesDriven = false;
    }

    /** Anchors driven bodies at the start of a step where the last one left them. */
    public void anchorDriven() {
        GroupPaths.anchor(trajectories, driven, state.x(), state.v());
    }

    /**
     * Sets the acceleration that contacts at rest give to a body; a driven one must be advanced anew.
     *
     * @param body index, anchored at the present instant
     * @param ax length/time²
     * @param ay length/time²
     * @param alpha rad/time²
     */
    public void support(int body, double ax, double ay, double alpha) {
        support.set(body, ax, ay, alpha, trajectories.isDriven(body));
        drivenMotion.probed.cut(body);
        course(body);
    }

    /**
     * The acceleration that all but contacts at rest give to a body that is not driven.
     *
     * @param body index
     * @param a takes x″, y″, θ″
     * @param at where in it
     */
    public void fall(int body, double[] a, int at) {
        int b = State.BLOCK * body;
        double[] w = state.w().values();
        boolean held = support.holds(body);
        Body view = state.body(body);
        a[at] = held ? 0 : generators.gravityX + w[b] * view.appliedX(); // (5)
        a[at + 1] = held ? 0 : generators.gravityY + w[b] * view.appliedY();
        a[at + 2] = held ? 0 : w[b + State.THETA] * view.appliedTorque(); // (6)
    }

    /**
     * Takes note that the velocity of a body has changed at its anchor: it no longer rests on anything.
     *
     * @param body index
     */
    public void deflect(int body) {
        drivenMotion.forget(body);
        if (support.release(body)) {
            setDriven(body, isTied(body) || generators.drive(state.body(body)));
            course(body);
        }
    }

    /** Whether some force may act on bodies beside that of their ties. */
    boolean hasForces() {
        return fields() == null || generators.isAny();
    }

    /** The uniform fields, if nothing but them acts, or null. */
    Generators fields() {
        return !pushed.isAny() && !generators.drive() && !support.pushesDriven ? generators : null;
    }

    double step() {
        return trajectories.h();
    }

    @Override
    public void acceleration(IntList bodies, double t, double[] a) {
        work.evaluate(bodies.size + (work.isOn() && isTiedGroup(bodies) ? ties.takeEffort(bodies) : 0)); // what was solved since the last time
        load(bodies, t, a);
        if (isTiedGroup(bodies)) {
            ties.accelerate(bodies, a, work.isOn()); // (34)–(41)
        }
    }

    /**
     * Finds accelerations between steps, under what acted in the last one: forces applied for it do, unless others are applied now.
     *
     * @param bodies indices
     * @param t simulated time
     * @param a takes [x″, y″, θ″] per body of the state
     */
    public void lastAcceleration(IntList bodies, double t, double[] a) {
        pushed.again(this, bodies, t, a);
    }

    @Override
    public void load(IntList bodies, double t, double[] a) {
        if (fields() != null) {
            generators.fall(bodies, a);
            support.addTo(drivenMotion.repose, bodies, a);
        } else {
            ground.soften(forces, bodies.size > 1 || isTiedGroup(bodies));
            generators.accelerate(state, bodies, t, forces, a);
            support.add(bodies, a);
        }
    }

    @Override
    public void hold(IntList bodies) {
        if (isTiedGroup(bodies)) {
            ties.hold(bodies);
        }
    }

    @Override
    public boolean pass(IntList bodies, double[] change) {
        return isTiedGroup(bodies) && ties.pass(bodies, change);
    }

    @Override
    public void close(IntList bodies, double h) {
        if (isTiedGroup(bodies)) {
            ties.close(bodies, h);
        }
    }

    @Override
    public void settle(IntList bodies) {
        if (isTiedGroup(bodies)) {
            ties.settle(bodies);
        }
    }
}
