// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import sim.physics.internal.IntList;
import sim.physics.matrix.BlockSparseMatrix;
import sim.physics.motion.Body;
import sim.physics.motion.Loads;
import sim.physics.motion.Reach;
import sim.physics.motion.State;
import sim.physics.motion.SwitchedTies;
import sim.physics.motion.TiedCoordinates;
import sim.physics.motion.Ties;
import sim.physics.motion.Watched;

/**
 * The constraints of an engine, the write-up's chapter <i>Constrained Dynamics</i>: their islands, and the accelerations of (37).
 */
public final class Constraints implements Ties, Serializable {
    private static final long serialVersionUID = 3L;

    private final State state;
    final Register register = new Register();
    List<TiedGroup> groups = new ArrayList<>();

    /** The group of each body. */
    TiedGroup[] of = {};

    private ConstraintSolver solver = new DirectSolver();
    private final Projection projection = new Projection();
    private Stabilization stabilization = Stabilization.projection();
    private long version;
    long grouping;
    private final Brittle brittle = new Brittle();

    /** The islands of the group of several that was asked for last. */
    private final Several several = new Several();

    /**
     * Makes an empty set of constraints.
     *
     * @param state the state vectors
     */
    public Constraints(State state) {
        this.state = state;
    }

    @Override
    public Ties helper() {
        return new Constraints(state);
    }

    @Override
    public void match(Ties first) {
        Constraints other = (Constraints) first;
        groups = other.groups;
        of = other.of;
        several.forget();
        stabilization = other.stabilization;
    }

    @Override
    public boolean mayBeShared(IntList island) {
        return of[island.values[0]].island().isOwn && solver instanceof DirectSolver;
    }

    /**
     * Sets what solves (41): a {@link DirectSolver} unless set.
     *
     * @param solver not null
     */
    public void setSolver(ConstraintSolver solver) {
        this.solver = Objects.requireNonNull(solver, "solver");
    }

    /**
     * Sets what keeps constraints closed.
     *
     * @param stabilization not null
     */
    public void setStabilization(Stabilization stabilization) {
        this.stabilization = Objects.requireNonNull(stabilization, "stabilization");
    }

    /** {@return the constraints: a copy, in the order in which they were added} */
    public List<Constraint> all() {
        return new ArrayList<>(register.all());
    }

    /**
     * {@return whether a constraint is here: true from add to remove}
     *
     * @param constraint any
     */
    public boolean contains(Constraint constraint) {
        return register.all().contains(constraint);
    }

    @Override
    public boolean areTied(Body a, Body b) {
        Body movable = a.isImmobile() ? b : a;
        TiedGroup group = groupOf(movable.index());
        return group != null && group.ties(movable, movable == a ? b : a);
    }

    /**
     * Checks that a constraint can be added.
     *
     * @param constraint not null
     * @param closed whether its equations must be satisfied
     * @throws IllegalStateException if it was added already
     * @throws IllegalArgumentException if no body of it can move, or its rows are not 1 to 3, or are not satisfied
     */
    public void check(Constraint constraint, boolean closed) {
        if (register.all().contains(constraint)) {
            throw new IllegalStateException("constraint is " + constraint + ": it was added already");
        }
        Admissible.check(constraint, closed);
    }

    /**
     * Adds a constraint that was checked; it acts from {@link #regroup()} on.
     *
     * @param constraint not null
     */
    public void add(Constraint constraint) {
        register.add(constraint);
    }

    /**
     * Removes a constraint; it acts no more from {@link #regroup()} on.
     *
     * @param constraint any
     * @return false if it was not there
     */
    public boolean remove(Constraint constraint) {
        return register.remove(constraint);
    }

    /**
     * Removes the constraints of a body that leaves.
     *
     * @param body of the state
     */
    public void removeAll(Body body) {
        register.of(body).forEach(register::remove);
    }

    /**
     * The same where the body leaves at once: what it was tied to forms no island until {@link #regroup()}.
     *
     * @param body of the state
     * @return the movable bodies that this concerns
     */
    public IntList cut(Body body) {
        IntList concerned = Grouping.cut(body, register, state, of);
        if (concerned.size > 0) {
            changeIslands();
        }
        return concerned;
    }

    /**
     * Takes note that a body was written: a fixed one carries the anchors of its constraints along.
     *
     * @param body a body of the state
     */
    public void touched(Body body) {
        version++;
        if (body.isImmobile() || state.touched().isTurned(body.index())) {
            register.changed.addAll(register.of(body));
        } else if (isTied(body.index())) {
            of[body.index()].forget();
        }
    }

    /** {@return whether constraints were added, removed or moved since the last {@link #regroup()}} */
    public boolean isChanged() {
        return !register.changed.isEmpty();
    }

    /** {@return the movable bodies that the changes concern, with those that are tied to them so far; ascending} */
    public IntList concerned() {
        return Concerned.by(register.changed, state, this);
    }

    /** Forms the islands anew that changes concern. */
    public void regroup() {
        changeIslands();
        of = Grouping.renew(groups, register, state, of);
    }

    void changeIslands() {
        version++;
        grouping++;
        several.forget();
    }

    @Override
    public boolean isTied(int body) {
        return groupOf(body) != null;
    }

    private TiedGroup groupOf(int body) {
        return body < of.length ? of[body] : null;
    }

    /** The island of a body that is to be solved now. */
    private Island active(int body) {
        return of[body].island().switches.active(state);
    }

    @Override
    public boolean pass(IntList bodies, double[] change) {
        return !stabilization.isFeedback() && solver.pass(of(bodies), state.w().values(), change);
    }

    @Override
    public double bend(IntList bodies) {
        return Grouping.bend(of(bodies), state.w().values());
    }

    @Override
    public IntList island(int body) {
        return of[body].bodies;
    }

    @Override
    public void accelerate(IntList bodies, double[] a, boolean counts) {
        List<Island> those = of(bodies);
        for (int k = 0; k < those.size(); k++) {
            those.get(k).effort.setFree(!counts);
            accelerate(those.get(k), a);
            those.get(k).effort.setFree(false);
        }
    }

    @Override
    public long takeEffort(IntList bodies) {
        return Effort.take(of(bodies));
    }

    /** The islands of a group. */
    private List<Island> of(IntList bodies) {
        TiedGroup one = groupOf(bodies.values[0]);
        return one != null && one.bodies == bodies ? one.island().switches.active(state).alone : several.of(bodies, of);
    }

    /** Adds W Jᵀ λ, (37) with (40), where λ keeps C″ = J a + J̇ ẋ = 0, (36). */
    private void accelerate(Island island, double[] a) {
        if (island.skeleton != null) {
            island.skeleton.push(a);
        }
        island.invariants.note(a);
        if (!island.switches.isEmpty()) {
            island.switches.accelerate(state, solver, a);
            return;
        }
        island.evaluate(state);
        if (stabilization.isFeedback()) {
            island.feedBack(state.v(), stabilization.position(), stabilization.velocity());
        }
        solver.accelerate(island, state, a); // (38), (39), (41)
    }

    @Override
    public void begin(IntList bodies, boolean isFree) {
        Invariants.begin(of(bodies), state, isFree);
    }

    @Override
    public boolean fly(IntList bodies, double gx, double gy, double h, double[] a) {
        return QuickStep.fly(projected(bodies), state, solver, gx, gy, h, a);
    }

    @Override
    public boolean advance(IntList bodies, double gx, double gy, double h) {
        return QuickStep.advance(projected(bodies), state, solver, gx, gy, h);
    }

    @Override
    public boolean advance(IntList bodies, Loads loads, boolean areEven, double[] a, double t, double h) {
        return QuickStep.advance(projected(bodies), state, solver, loads, areEven, a, t, h);
    }

    @Override
    public TiedCoordinates coordinates(IntList bodies) {
        return QuickStep.coordinates(projected(bodies), state, solver);
    }

    /** The island that a group is and that projection keeps closed, or null. */
    private Island projected(IntList bodies) {
        TiedGroup one = groupOf(bodies.values[0]);
        return one != null && one.bodies == bodies && !stabilization.isFeedback() ? one.island().switches.active(state) : null;
    }

    @Override
    public boolean project(IntList bodies) {
        return stabilization.isFeedback() || projection.project(of(bodies), state, solver);
    }

    @Override
    public void assemble(IntList bodies, Reach reach) {
        of(bodies).forEach(island -> projection.assemble(island, state, solver, reach));
    }

    /**
     * {@return whether hundreds of joints meet in a body, so that to close them exactly takes as long as many steps}
     *
     * @param bodies an island
     */
    public boolean haveHub(IntList bodies) {
        return of[bodies.values[0]].hasHub();
    }

    @Override
    public boolean force(IntList bodies) {
        if (stabilization.isFeedback() || !Creep.arePossible(of(bodies))) {
            assemble(bodies, Reach.NEWTON); // a step does not put bodies elsewhere
            return true;
        }
        return projection.force(of(bodies), state, solver);
    }

    @Override
    public IllegalStateException tooLong(IntList bodies) {
        return projection.tooLong(of(bodies));
    }

    @Override
    public int halvings(IntList bodies, int most, boolean fromRest) {
        return stabilization.isFeedback() ? most : Creep.halvings(of(bodies), fromRest ? state : null, solver, most);
    }

    @Override
    public int tire(IntList bodies, double step, int evaluations, boolean isTorn) {
        return Creep.tire(of(bodies), state, step, evaluations, isTorn);
    }

    @Override
    public boolean isTired(IntList bodies, double step) {
        return Creep.areTired(of(bodies), step);
    }

    @Override
    public void creep(IntList bodies, double h) {
        Creep.advance(of(bodies), state, solver, projection, h);
    }

    @Override
    public void prepareImpact(IntList bodies) {
        solver.prepare(of[bodies.values[0]].island().switches.evaluateReleased(state), state.w().values());
    }

    @Override
    public SwitchedTies switched(IntList bodies) {
        return of[bodies.values[0]].island().switches;
    }

    @Override
    public BlockSparseMatrix jacobian(IntList bodies) {
        return GlobalSolver.jacobian(active(bodies.values[0]), state.x().length);
    }

    @Override
    public void reply(int body, double px, double py, double turn, double[] velocities) {
        solver.reply(active(body), state.w().values(), body, px, py, turn, velocities);
    }

    @Override
    public void reply(int body, double[] velocities) {
        solver.correct(active(body), state.w().values(), velocities, null);
    }

    @Override
    public void settle(IntList bodies) {
        projection.settle(of(bodies), state, solver);
    }

    @Override
    public void hold(IntList bodies) {
        Shake.hold(of(bodies), state);
    }

    @Override
    public void close(IntList bodies, double h) {
        Shake.close(of(bodies), state, h);
    }

    /**
     * {@return what a constraint does, as the last evaluation of the accelerations found it: its force}
     *
     * @param constraint one that was added and regrouped
     */
    public Reaction reaction(Constraint constraint) {
        Body body = constraint.getBodyA().isImmobile() ? constraint.getBodyB() : constraint.getBodyA();
        return (constraint instanceof Switched ? of[body.index()].island() : active(body.index())).reactions.of(constraint);
    }

    /**
     * {@return the joints whose load is greater than they bear, as the last evaluation of the accelerations found it}
     *
     * @param bodies an island
     */
    public List<Constraint> overloaded(IntList bodies) {
        return active(bodies.values[0]).reactions.overloaded();
    }

    /** {@return the number of rows that depend on others, as the last solves found them} */
    public int redundant() {
        return groups.stream().mapToInt(group -> group.redundantRows(state)).sum();
    }

    /** {@return the islands that have joints which can break} */
    public List<IntList> breakable() {
        return groups.stream().filter(TiedGroup::isBreakable).map(k -> k.bodies).toList();
    }

    /** {@return whether some joint can break} */
    public boolean isBreakable() {
        return brittle.isAny(groups, version);
    }

    @Override
    public boolean isSwitched(IntList bodies) {
        return Switches.any(of(bodies));
    }

    @Override
    public boolean isAutonomous(IntList bodies) {
        return solver instanceof DirectSolver && !stabilization.isFeedback() && Grouping.areAutonomous(of(bodies));
    }

    @Override
    public boolean decide(IntList bodies, double time) {
        return projection.decide(of(bodies), state, solver, time);
    }

    @Override
    public void confirm(IntList bodies, boolean hold) {
        Switches.confirm(of(bodies), state, hold);
    }

    @Override
    public double watch(IntList bodies, boolean near) {
        return Switches.watch(of(bodies), state, near);
    }

    @Override
    public boolean reconsider(IntList bodies, double[] a) {
        return Switches.reconsider(of(bodies), a);
    }

    @Override
    public double toGo(IntList bodies, boolean near, double[] a, Watched seen) {
        return Switches.toGo(of(bodies), state, near, a, seen);
    }

    @Override
    public double push(IntList bodies, double[] a) {
        return Switches.push(of(bodies), state, a);
    }

    @Override
    public boolean limit(IntList bodies, boolean yes) {
        return Switches.limit(of(bodies), yes);
    }

    @Override
    public double spare(IntList bodies) {
        return Switches.spare(of(bodies));
    }

    @Override
    public Ties twin() {
        Constraints twin = new Constraints(state);
        groups.forEach(group -> group.constraints.forEach(twin::add)); // as they act: not those that were added since they were grouped
        twin.regroup();
        return twin;
    }

    @Override
    public long version() {
        return version;
    }

    @Override
    public long grouping() {
        return grouping;
    }

    @Override
    public double[] switches(IntList bodies, double[] kept, boolean restore) {
        return Switches.exchange(of(bodies), kept, restore);
    }
}
