// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.io.IOException;
import java.io.ObjectOutputStream;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import sim.engine.Schedule;
import sim.engine.SimState;
import sim.engine.Steppable;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.Overlap;
import sim.physics.collision.Overlaps;
import sim.physics.collision.broad.BroadPhase;
import sim.physics.collision.broad.BruteForce;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.ConstraintException;
import sim.physics.constraint.ConstraintSolver;
import sim.physics.constraint.Constraints;
import sim.physics.constraint.DirectSolver;
import sim.physics.constraint.Joint;
import sim.physics.constraint.Reaction;
import sim.physics.constraint.Stabilization;
import sim.physics.internal.Check;
import sim.physics.internal.Squeezed;
import sim.physics.internal.Team;
import sim.physics.internal.Tolerances;
import sim.physics.internal.Work;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Steering;
import sim.physics.motion.Trajectories;
import sim.physics.query.Queries;
import sim.physics.response.CollisionListener;
import sim.physics.response.CollisionResponse;
import sim.physics.response.ContactListener;
import sim.physics.response.ImpulseSolver;
import sim.physics.response.LastingContact;
import sim.physics.response.PairRule;
import sim.physics.stepping.TimeStepping;

/**
 * A two-dimensional physics engine for MASON. Add bodies to it and schedule it: in each step they move, collide and bounce.
 *
 * <p>{@link #step()} follows the write-up: motion, collision detection (broad phase and narrow phase), collision response.
 * Engines are independent of one another. Use each from one thread at a time. An engine is serializable, and a restored one
 * continues bit for bit.
 */
public final class PhysicsEngine implements Steppable {
    private static final long serialVersionUID = 4L;

    /** The ordering at which {@link #scheduleOn(Schedule)} runs the engine. Agents that steer bodies come before it. */
    public static final int ORDERING = 10;

    /** Depth in what no force moves, relative to the smaller body, at which its middle is all but in: what moves elsewhere would drive it through. */
    private static final double CRUSHED = 0.8;

    /** Substeps beyond which a step would seem to hang. */
    private static final int MOST_SUBSTEPS = 10_000;

    private final State state = new State();
    private final Trajectories trajectories = new Trajectories();
    private final Work work = new Work();
    private final Motion motion = new Motion(state, trajectories, work);
    private final Steering steering = new Steering(state, trajectories, motion);
    private final CollisionDetection detection = new CollisionDetection(state, trajectories, new BruteForce());
    private final CollisionResponse response = new CollisionResponse(state, trajectories, motion, detection);

    /** What repeats the steps on a schedule; null before {@link #scheduleOn}. */
    private Repeating scheduled;

    private final Admission admission = new Admission(
            state, trajectories, motion, detection, response.resting(), response.heaps());

    /** What a step by events consists of. */
    private final EventStep events = new EventStep(state, trajectories, work, motion, detection, response, admission, steering);

    /** Null until the first constraint is added. */
    private Constraints constraints;

    /** Null until somebody asks. */
    private transient Queries queries;

    /** Null unless it is asked for. */
    private Audit audit;

    /** Null until it is asked for the first time; and whether it moves the bodies now. */
    private TimeStepping timeStepping;

    private boolean isStepped;

    /** Whether, and for how long, it does so because events would cost too much. */
    private final Relief relief = new Relief();

    /** Whether it lets bodies sleep. */
    private boolean isSleepAllowed = true;

    private ConstraintSolver constraintSolver = new DirectSolver();

    /** Null while the stepping thread does all the work. */
    private Team team;

    private boolean stepping;

    /** Whether listeners are asked what to do about collisions in the step of time stepping that begins. */
    private transient boolean asking;

    /** Whether listeners are told of what happened when a step is over; and whether it was a part of one, which goes on. */
    private transient boolean telling;

    private transient boolean goesOn;

    private double timeStep = 1;
    private long steps;
    private double epoch;
    private long epochStep;

    /** Creates an empty engine with a time step of 1 and the integrator RK4. */
    public PhysicsEngine() {
        trajectories.begin(0, timeStep);
        detection.begin(0, timeStep);
    }

    /**
     * Advances the bodies by one time step. A time step of 0 changes nothing.
     *
     * <p>If a listener or other code of yours throws an exception, the step ends there. The bodies stay where they are at that
     * instant, the step is not counted, and the next one goes on from there.
     *
     * <p>Joints of bodies that were moved since the last step, such as by {@link Body#setPosition}, are closed first, as
     * {@link #assemble} does it.
     *
     * @throws ConstraintException if there are no places that satisfy the joints, or the step is much too long for them. You are
     *     told once: the next step, if it would throw that again, is {@linkplain #setWorkLimit relieved} instead, in which time
     *     stepping pulls the bodies together as far as they go. Audited engines throw it each time
     * @throws IllegalStateException if a listener or other code calls this within a step; or if time stepping throws a body beyond all
     *     numbers, as the step is too long or a mass too small for what acts on it: all are where the step began then
     */
    public void step() {
        if (stepping || asking || telling) {
            throw new IllegalStateException("the engine was asked to step within its own step, or by a listener");
        }
        if (timeStep == 0) {
            return;
        }
        if (relief.isOver(steps)) {
            resume(false);
        }
        steering.begin(steps, timeStep, isStepped);
        if (isStepped) {
            stepWithoutEvents(0);
        } else {
            stepByEvents();
        }
    }

    /** Motion, collision detection, and in time order the events with their collision response. */
    private void stepByEvents() {
        stepping = true;
        boolean isOver = false;
        boolean isFailed = false;
        try {
            events.begin(steps, timeStep, getTime(), relief.limit(state.bodyCount(), steering.areSomeMoving(), audit != null));
            events.drive(); // motion, (5)–(15)
            detection.look(); // collision detection: broad phase and narrow phase
            while (detection.hasEvent()) {
                events.handleEvent(); // collision response, (16)–(24)
            }
            events.finish();
            steps++;
            relief.goOn();
            isOver = true;
        } catch (Work.Spent | Squeezed | ConstraintException e) {
            if (e instanceof ConstraintException && events.isRefusal() && relief.tells(audit != null)) {
                throw e; // the author's: what he has set, or a step that is too long
            }
            isFailed = !(e instanceof Work.Spent) && !events.isAdmitting();
            relief.begin(steps); // time stepping makes the rest of the step, or all of it
        } finally {
            events.end();
            if (!isOver) {
                events.breakOff(isFailed, relief.isOn());
            }
            stepping = false;
        }
        if (isOver) {
            events.judgeJoints(getTime());
            tell();
        } else {
            relieve();
        }
    }

    /** Events have cost as much as they may in the step: time stepping takes over from here. */
    private void relieve() {
        refine();
        change(true);
        if (events.instant() < timeStep) {
            stepWithoutEvents(events.instant());
        } else {
            relief.count();
            steps++;
        }
    }

    /** Events are to be found again, if they can be from where the bodies are: joints can be closed, and bodies are not deep in one another then. */
    private void resume(boolean isAsked) {
        breakOverloaded();
        if (constraints != null && constraints.isChanged()) {
            admission.regroup();
        }
        if (timeStepping.deepestTied() <= 0.5 * Tolerances.PUT
                && (isAsked || timeStepping.deepestInGround() <= CRUSHED)
                && (constraints == null || new WayBack(state, constraints, new Overlaps(detection.filter()), bodies()).go(isAsked))) {
            relief.end(steps);
            timeStepping.sleep().setAllowed(isSleepAllowed);
            change(false);
        } else {
            relief.extend(steps);
            refine();
        }
    }

    /** Time stepping is to be as exact as it can be in the place of events, and lets nobody sleep. */
    private void refine() {
        timeStepping().setSubsteps(Relief.SUBSTEPS);
        timeStepping.setPace(timeStep);
        timeStepping.sleep().setAllowed(false);
    }

    /** Removes the joints that broke in the last step of time stepping. */
    private void breakOverloaded() {
        List<Constraint> broken = timeStepping.overloaded();
        for (int k = 0; k < broken.size(); k++) {
            constraints.remove(broken.get(k));
        }
    }

    /** A step of time stepping, from an offset in it on; in parts where it stands in for events, and bodies go far in it. */
    private void stepWithoutEvents(double from) {
        relief.count();
        timeStepping.decisions().beginStep(timeStep);
        if (from > 0) {
            timeStepping.decisions().takeOver(response.lasting().all());
        }
        double to;
        for (double at = from; at < timeStep; at = to) {
            to = timeStep;
            if (relief.isOn()) {
                to = Relief.partEnd(state, motion.generators(), at, timeStep);
                boolean isPart = to - at < timeStep - from;
                timeStepping.setSubsteps(isPart ? Relief.substeps(state, motion.generators(), to - at, timeStep) : Relief.SUBSTEPS);
            }
            partWithoutEvents(at, to);
        }
    }

    /** A part of such a step, or all of it; listeners are asked when it begins, after which it begins anew, and told when it is over. */
    private void partWithoutEvents(double from, double to) {
        beginWithoutEvents(from, to);
        if (timeStepping.decisions().areOpen()) {
            asking = true;
            try {
                timeStepping.decisions().ask();
            } finally {
                asking = false;
            }
            beginWithoutEvents(from, to);
        }
        stepping = true;
        state.setPresence(null, true);
        try {
            timeStepping.solve(getTime() + from, to == timeStep);
            steps += to == timeStep ? 1 : 0;
            if (to < timeStep) {
                timeStepping.decisions().keepPart();
            }
        } finally {
            state.setPresence(null, false);
            stepping = false;
        }
        telling = true;
        goesOn = to < timeStep;
        try {
            timeStepping.decisions().tell(to == timeStep);
        } finally {
            telling = false;
            goesOn = false;
        }
    }

    private void beginWithoutEvents(double from, double to) {
        stepping = true;
        state.setPresence(null, true);
        try {
            trajectories.begin(steps, timeStep);
            detection.begin(steps, timeStep);
            breakOverloaded();
            admission.admit(0);
            timeStepping.begin(getTime() + from, to - from);
        } finally {
            state.setPresence(null, false);
            stepping = false;
        }
    }

    /** The step is over; listeners of contacts that last may change anything, but for stepping the engine. */
    private void tell() {
        telling = true;
        try {
            response.lasting().tell();
        } finally {
            telling = false;
        }
    }

    /** What is saved is the same whether somebody has looked at all paths or not. Half a step is refused: its copy could not go on. */
    private void writeObject(ObjectOutputStream out) throws IOException {
        if (stepping || goesOn) {
            throw new IllegalStateException("the engine was saved within a step: save it between steps");
        }
        state.settle(true); // whether somebody has read it makes no other checkpoint
        events.makeLatePaths();
        out.defaultWriteObject();
    }

    /**
     * Adds a body. One that was removed within the collision that is being handled comes back when that is over.
     *
     * @param <B> class of the body
     * @param body a body that is in no engine
     * @return the body
     * @throws IllegalStateException if the body is already in this engine or in another one
     */
    public <B extends Body> B add(B body) {
        Objects.requireNonNull(body, "body");
        if (isGone(body)) {
            state.write(body.index(), true); // it comes back where it is now
            admission.leaving().takeBack(body);
            return body;
        }
        if (!body.state().isOwn()) {
            String where = body.state() == state ? "this engine" : "another engine";
            throw new IllegalStateException("body is " + body + ": it is in " + where + " already");
        }
        state.requireOpen();
        state.add(body);
        steering.note(body);
        return body;
    }

    /**
     * Removes a body, and the constraints and springs that it is part of. Within a step by events, it leaves when the collision that is
     * being handled is over; until then it may be removed again, without effect, as by another listener that is told of it.
     *
     * @param body a body of this engine
     * @throws IllegalStateException if the body is not in this engine
     */
    public void remove(Body body) {
        requireIn("body", body);
        state.requireOpen();
        response.lasting().leave(body);
        if (stepping) {
            admission.leaving().add(body);
        } else {
            if (constraints != null) {
                events.makeLatePaths(); // while islands are what they were in the last step
            }
            admission.drop(body);
        }
    }

    /**
     * Returns whether a body is in this engine.
     *
     * @param body any body
     * @return true from the time it is added until it is removed, also within a step
     */
    public boolean contains(Body body) {
        return body != null && body.state() == state && !isGone(body);
    }

    private void requireMine(Body body) {
        requireMine("body", body);
    }

    private void requireIn(String name, Body body) {
        Objects.requireNonNull(body, name);
        if (body.state() != state) {
            throw new IllegalStateException(name + " is " + body + ": it is not in this engine");
        }
    }

    private void requireMine(String name, Body body) {
        requireIn(name, body);
        if (isGone(body)) {
            throw new IllegalStateException(name + " is " + body + ": it was removed, and leaves when the collision is over");
        }
    }

    private static void requireNoneNull(String name, List<Body> named) {
        for (int k = 0; named != null && k < named.size(); k++) {
            if (named.get(k) == null) {
                throw new NullPointerException(name + "[" + k + "]");
            }
        }
    }

    /** Whether a body was removed within the collision that is being handled, and is not to come back. */
    private boolean isGone(Body body) {
        return body.state() == state && admission.leaving().has(body) && !admission.leaving().comesBack(body);
    }

    /**
     * Returns an object that answers questions about where the bodies are: rays, overlaps, neighbours, fields of view.
     *
     * @return queries, each answered for the bodies as they are when it is asked
     */
    public Queries queries() {
        queries = queries == null ? new Queries(state) : queries;
        return queries;
    }

    /**
     * Returns the bodies, in the order of their blocks.
     *
     * @return a copy of the list
     */
    public List<Body> bodies() {
        List<Body> all = new ArrayList<>(state.bodyCount());
        for (int i = 0; i < state.size(); i++) {
            if (state.body(i) != null && !isGone(state.body(i))) {
                all.add(state.body(i));
            }
        }
        return all;
    }

    /**
     * Adds a force generator.
     *
     * @param <G> class of the generator
     * @param generator the generator, not null; it may name bodies that are added later, or are in another engine: it acts on them while they are here
     * @return the generator
     * @throws IllegalStateException if it was added already
     * @throws NullPointerException if it names a body that is null
     */
    public <G extends ForceGenerator> G add(G generator) {
        Objects.requireNonNull(generator, "generator");
        state.requireOpen();
        requireNoneNull("generator.getBodies()", generator.getBodies());
        requireNoneNull("generator.getCoupledBodies()", generator.getCoupledBodies());
        if (!(generator instanceof Gravity)) { // a uniform field asks nobody
            events.askAuthors();
        }
        if (!motion.add(generator)) {
            throw new IllegalStateException("force generator is " + generator + ": it was added already");
        }
        touch(motion.groups().bodies(generator));
        return generator;
    }

    /**
     * Removes a force generator.
     *
     * @param generator a generator that was added
     * @throws IllegalStateException if it was not added
     */
    public void remove(ForceGenerator generator) {
        state.requireOpen();
        List<Body> named = motion.groups().bodies(generator);
        if (!motion.remove(generator)) {
            throw new IllegalStateException("force generator is " + generator + ": it is not in this engine");
        }
        touch(named);
    }

    /**
     * Returns the force generators, in the order in which they were added.
     *
     * @return a copy of the list
     */
    public List<ForceGenerator> allForceGenerators() {
        return motion.generators();
    }

    /** Lets all bodies start anew from their places. */
    private void touchAll() {
        for (Body body : bodies()) {
            state.touch(body.index());
        }
    }

    /** Lets the bodies start anew from their places that a generator has named, or all. */
    private void touch(List<Body> named) {
        for (Body body : named == null ? bodies() : named) {
            if (contains(body)) {
                state.touch(body.index());
            }
        }
    }

    /**
     * Adds a constraint, such as a joint. Within a step, this happens when the collision that is being handled is over.
     *
     * <p>The constraint's bodies no longer collide with each other, unless {@link Joint#setCollideConnected} lets them.
     * Velocities that the constraint does not allow are changed by the least amount.
     *
     * @param <C> class of the constraint
     * @param constraint a constraint between bodies of this engine, which are where its equations require them to be
     * @return the constraint
     * @throws IllegalStateException if it was added already, or one of its bodies is not in this engine, or not before the collision is over
     * @throws IllegalArgumentException if the constraint's equations are not satisfied or have infinite coefficients, none of its bodies can move,
     *     or both are the same
     */
    public <C extends Constraint> C add(C constraint) {
        checkBodies(constraint);
        state.requireOpen();
        check(constraint, true);
        constraints().add(constraint);
        return constraint;
    }

    private void checkBodies(Constraint constraint) {
        Objects.requireNonNull(constraint, "constraint");
        requireHere(constraint.getBodyA());
        if (constraint.getBodyB() != null) {
            requireHere(constraint.getBodyB());
        }
    }

    /** What comes back when the collision is over would lose a constraint that it had until then, as those from before. */
    private void requireHere(Body body) {
        requireMine(body);
        if (admission.leaving().has(body)) {
            throw new IllegalStateException("body is " + body + ": it was removed, and comes back when the collision is over; it may have constraints then");
        }
    }

    private Constraints constraints() {
        if (constraints == null) {
            constraints = new Constraints(state);
            constraints.setSolver(constraintSolver);
            admission.setConstraints(constraints);
            if (timeStepping != null) {
                timeStepping.setConstraints(constraints);
            }
            events.setConstraints(constraints);
        }
        return constraints;
    }

    /**
     * Adds constraints, and moves their bodies to places where all the equations are satisfied. Of all such displacements, the
     * mass-weighted least one is taken.
     *
     * @param constraints constraints between bodies of this engine
     * @throws IllegalStateException if a constraint was added already or is named twice, if there are no such places, or within a
     *     step
     */
    public void assemble(Constraint... constraints) {
        Objects.requireNonNull(constraints, "constraints");
        requireBetweenSteps("constraints were to be assembled");
        Set<Constraint> named = Collections.newSetFromMap(new IdentityHashMap<>());
        for (int k = 0; k < constraints.length; k++) {
            Constraint constraint = Objects.requireNonNull(constraints[k], "constraints[" + k + "]");
            checkBodies(constraint);
            check(constraint, false);
            if (!named.add(constraint)) {
                throw new IllegalStateException("constraint is " + constraint + ": it is named twice");
            }
        }
        constraints();
        admission.forgetAnswers();
        admission.assemble(constraints);
    }

    /** What is refused leaves the engine as it was, so without constraints if it has none. */
    private void check(Constraint constraint, boolean closed) {
        (constraints == null ? new Constraints(state) : constraints).check(constraint, closed);
    }

    /**
     * Removes a constraint. Within a step, this happens when the collision that is being handled is over.
     *
     * @param constraint a constraint of this engine
     * @throws IllegalStateException if the constraint is not in this engine
     */
    public void remove(Constraint constraint) {
        state.requireOpen();
        if (constraints == null || !constraints.remove(constraint)) {
            throw new IllegalStateException("constraint is " + constraint + ": it is not in this engine");
        }
    }

    /**
     * Returns whether a constraint is in this engine.
     *
     * @param constraint any constraint
     * @return true from the time it is added until it is removed, or until the joint breaks
     */
    public boolean contains(Constraint constraint) {
        return constraints != null && constraints.contains(constraint);
    }

    /**
     * Returns the constraints, in the order in which they were added.
     *
     * @return a copy of the list
     */
    public List<Constraint> allConstraints() {
        return constraints == null ? new ArrayList<>() : constraints.all();
    }

    /**
     * Returns the force of a constraint where the bodies are now, or with time stepping its mean over the last step. Call this
     * between steps. Forces that were applied to a body for the last step ({@link Body#addForce}) count, until others are applied
     * to it.
     *
     * @param constraint a constraint of this engine
     * @return its effect on its first body
     * @throws IllegalStateException if the constraint is not in this engine, or within a step
     */
    public Reaction getReaction(Constraint constraint) {
        requireBetweenSteps("a reaction was asked for");
        if (!contains(constraint)) {
            throw new IllegalStateException("constraint is " + constraint + ": it is not in this engine");
        }
        Reaction mean = isStepped ? timeStepping.reaction(constraint) : null;
        return mean == null ? admission.reaction(constraint, getTime()) : mean;
    }

    /**
     * Returns the number of constraint equations that only repeat what others say, as a door's second hinge does. They do no
     * harm: of all forces with the same effect, the smallest are used.
     *
     * @return number of rows, as found by the last step; a {@link sim.physics.constraint.GlobalSolver} does not look for them
     */
    public int getRedundantEquations() {
        return constraints == null ? 0 : constraints.redundant();
    }

    /**
     * Sets the solver for the constraint forces, (41).
     *
     * @param solver the solver, not null; it works in memory of its own, so engines in different threads need one each
     * @throws IllegalStateException within a step
     */
    public void setConstraintSolver(ConstraintSolver solver) {
        Objects.requireNonNull(solver, "solver");
        requireBetweenSteps("the constraint solver was set");
        constraintSolver = solver;
        admission.forgetAnswers();
        motion.late().forget();
        if (constraints != null) {
            constraints.setSolver(solver);
        }
    }

    /**
     * Sets the method that keeps constraints closed despite the errors of the integrator.
     *
     * @param stabilization the method; projection unless set
     * @throws IllegalStateException within a step
     */
    public void setStabilization(Stabilization stabilization) {
        Objects.requireNonNull(stabilization, "stabilization");
        requireBetweenSteps("the stabilization was set");
        admission.forgetAnswers();
        constraints().setStabilization(stabilization);
    }

    /**
     * Adds a listener for collisions. Within a step, it is told from the next collision on.
     *
     * @param listener the listener, not null
     * @throws IllegalStateException if it was added already
     */
    public void addListener(CollisionListener listener) {
        state.requireOpen();
        requireNew(response.laws().add(listener), listener);
        events.askAuthors();
        if (timeStepping != null) {
            timeStepping.sleep().wakeAll(); // it is asked about all that touches
        }
    }

    /**
     * Removes a listener for collisions.
     *
     * @param listener a listener that was added
     * @throws IllegalStateException if it was not added
     */
    public void removeListener(CollisionListener listener) {
        state.requireOpen();
        requireKnown(response.laws().remove(listener), listener);
    }

    /**
     * Adds a listener for lasting contacts, which is told when a step is over. When the first listener is added, contacts that
     * last already count as beginning then.
     *
     * @param listener the listener, not null
     * @throws IllegalStateException if it was added already
     */
    public void addContactListener(ContactListener listener) {
        state.requireOpen();
        requireNew(response.lasting().add(listener), listener);
    }

    /**
     * Removes a listener for lasting contacts.
     *
     * @param listener a listener that was added
     * @throws IllegalStateException if it was not added
     */
    public void removeContactListener(ContactListener listener) {
        state.requireOpen();
        requireKnown(response.lasting().remove(listener), listener);
    }

    private static void requireNew(boolean isNew, Object listener) {
        if (!isNew) {
            throw new IllegalStateException("listener is " + listener + ": it was added already");
        }
    }

    private static void requireKnown(boolean wasThere, Object listener) {
        if (!wasThere) {
            throw new IllegalStateException("listener is " + listener + ": it is not in this engine");
        }
    }

    /**
     * Returns the contacts that last at the end of the last step: which bodies rest or lie on one another, and with what force.
     * Bodies that bounce are not listed; {@link CollisionListener}s are told of those.
     *
     * @return a new list, with each contact once
     * @throws IllegalStateException within a step
     */
    public List<LastingContact> contacts() {
        requireBetweenSteps("contacts were asked for");
        return isStepped ? timeStepping.contacts(null) : response.lasting().all();
    }

    /**
     * Returns the contacts of one body that last at the end of the last step: what a bumper or a foot feels.
     *
     * @param body a body of this engine
     * @return a new list, empty if the body has no lasting contact
     * @throws IllegalStateException if the body is not in this engine, or within a step
     */
    public List<LastingContact> contacts(Body body) {
        requireMine(body);
        requireBetweenSteps("contacts were asked for");
        return isStepped ? timeStepping.contacts(body) : response.lasting().of(body.index());
    }

    /**
     * Sets whether two bodies collide, or pass through one another.
     *
     * @param a a body of this engine
     * @param b another body of this engine
     * @param collide false to let them pass through one another
     * @throws IllegalArgumentException if both bodies are the same
     * @throws IllegalStateException if one of them is not in this engine
     */
    public void setCollisions(Body a, Body b, boolean collide) {
        requireMine("a", a);
        requireMine("b", b);
        if (a == b) {
            throw new IllegalArgumentException("b is " + b + ": a pair that collides needs two different bodies");
        }
        state.write(a.index(), false);
        detection.filter().set(a, b, collide);
    }

    /**
     * Returns the time step.
     *
     * @return simulated time per call of {@link #step()}
     */
    public double getTimeStep() {
        return timeStep;
    }

    /**
     * Sets the time step.
     *
     * @param timeStep simulated time per step, not negative; 0 stops time for the bodies
     * @throws IllegalArgumentException if the time step is negative or not finite
     * @throws IllegalStateException within a step
     */
    public void setTimeStep(double timeStep) {
        Check.notNegative("time step", timeStep);
        requireStepOver("the time step was set");
        epoch = getTime();
        epochStep = steps;
        this.timeStep = timeStep;
        touchAll();
    }

    /**
     * Returns the number of substeps of time stepping.
     *
     * @return substeps per step; 0 unless set, which means that events are found in continuous time
     */
    public int getTimeStepping() {
        return isStepped && !relief.isOn() ? timeStepping.getSubsteps() : 0;
    }

    /**
     * Moves the bodies by time stepping, as game engines do, instead of by events. Each step is made of equal substeps. In each
     * substep, contacts, joints, motors, stops and friction are solved once, for impulses. The method is of second order in the
     * substep with joints, springs and lasting contacts, and of first order where something strikes or slips. The cost of a step
     * is known beforehand and small, however many bodies press on one another. Use it for crowds, and for machines whose looks
     * count more than their places.
     *
     * <p>Bodies may overlap by some hundredths of their size, and joints may be off by some thousandths of theirs, but for those
     * without loops that touch nothing. Elastic bodies lose or gain energy. Something fast and thin can pass through something
     * thin. {@link CollisionListener}s are asked when a step begins in which bodies would touch. They are told when the step is
     * over, as if between steps. Threads and the {@link Integrator} have no effect.
     *
     * <p>When you switch back to events, they are found again as soon as the joints can be closed and jointed bodies do not
     * overlap deeply. Until then steps of 32 substeps are made, which {@link #getRelievedSteps()} counts.
     *
     * @param substeps number of substeps in a step; 4 is usual, and more are more accurate, up to 10,000; 0 for events
     * @throws IllegalArgumentException if the number is negative or greater than 10,000
     * @throws IllegalStateException within a step, or if the engine is audited
     */
    public void setTimeStepping(int substeps) {
        if (substeps < 0 || substeps > MOST_SUBSTEPS) {
            throw new IllegalArgumentException("substeps are " + substeps + ": there must be 0, for events, or up to " + MOST_SUBSTEPS
                    + "; for more, make the time step shorter");
        }
        requireStepOver("time stepping was set");
        if (substeps > 0 && audit != null) {
            throw new IllegalStateException("time stepping was set while the engine is audited: call setAudited(false) before");
        }
        if (substeps > 0) {
            timeStepping().setSubsteps(substeps);
            timeStepping.sleep().setAllowed(isSleepAllowed);
            relief.end(steps);
            if (!isStepped) {
                change(true);
            }
        } else if (isStepped && !relief.isOn()) {
            resume(false);
        }
    }

    private TimeStepping timeStepping() {
        if (timeStepping == null) {
            timeStepping = new TimeStepping(state, motion, detection.filter(), response.laws());
            timeStepping.setConstraints(constraints);
            timeStepping.sleep().setAllowed(isSleepAllowed);
        }
        return timeStepping;
    }

    /** Lets time stepping move the bodies, or events. */
    private void change(boolean toStepping) {
        isStepped = toStepping;
        events.makeLatePaths();
        state.settle(true);
        timeStepping.forget();
        admission.setStepped(isStepped ? timeStepping : null);
    }

    /**
     * Returns the limit of the work that a step by events may cost.
     *
     * @return the limit, in units of {@link #getWork()}
     */
    public long getWorkLimit() {
        return relief.limit(state.bodyCount(), steering.areSomeMoving());
    }

    /**
     * Bounds the work that a step by events may cost. When a step is about to cost more, {@link #setTimeStepping time stepping}
     * with 32 substeps makes the rest of it and some steps more. These steps are said to be relieved: their cost is known
     * beforehand, but they are less exact. So a step ends in time even where bodies jam.
     *
     * <p>{@link #getRelievedSteps()} counts the relieved steps. As long as there are none, the limit changes no bit of a run.
     * Work is counted, not timed, so a run is the same on any machine.
     *
     * <p>Steps are relieved from their beginning on in which the motion of joints gets lost, in a pose that lets nothing pass, so that
     * a {@link ConstraintException} were thrown; but not if the step is too long for the motion that it begins with, or if joints cannot be
     * closed that were added or whose bodies were written. Once a step has been relieved, those are too, since joints may be where
     * time stepping has left them. So is a step that you make after one that has thrown it, without having changed what it was thrown for.
     *
     * <p>Unless set, the limit is 10 million units plus 200 for each body, which is some seconds; while a kinematic body moves, a
     * twentieth of that. The step in which the limit is met and the eight after it are relieved. If events cost too much again within as many steps, twice as many are relieved, up
     * to 256. Events are found again as soon as the joints can be closed, and no two jointed bodies overlap more deeply than they
     * may by events. While the engine is audited, there is no limit.
     *
     * @param units the limit, in units of some tenths of a microsecond each; {@link Long#MAX_VALUE} for no limit
     * @throws IllegalArgumentException if the limit is not at least 1
     * @throws IllegalStateException within a step
     */
    public void setWorkLimit(long units) {
        if (units < 1) {
            throw new IllegalArgumentException("work limit is " + units + ": it must be at least 1");
        }
        requireBetweenSteps("the work limit was set");
        relief.setLimit(units);
    }

    /**
     * Returns the work of all steps by events, an exact measure of what happens in them. A unit is the acceleration of one body,
     * or a look at a pair. An event counts as 8 units, and a solution of a heap as the number of units that take the same time.
     * What every step costs anyway, such as the paths and boxes with which it begins, is not counted.
     *
     * @return number of units since the engine was made
     */
    public long getWork() {
        return work.done();
    }

    /**
     * Returns the number of steps that time stepping has made, in whole or in part, because events would have cost more than the
     * {@link #setWorkLimit limit}, or could not be found yet.
     *
     * @return number of steps since the engine was made
     */
    public long getRelievedSteps() {
        return relief.relieved();
    }

    /**
     * Returns whether time stepping lets bodies sleep.
     *
     * @return true unless set
     */
    public boolean isSleepAllowed() {
        return isSleepAllowed;
    }

    /**
     * Sets whether time stepping lets bodies sleep. Bodies that touch, are tied together or pull at one another by springs form
     * an island; fixed bodies belong to none.
     *
     * <p>An island sleeps when all its bodies have stayed where they are, to two thousandths of their radius, for as long as they
     * would take to fall by two radii. Its velocities are then zero, and its places do not change by a bit. Its contacts and
     * reactions are those of its last step, and a step costs nothing for it.
     *
     * <p>An island wakes as a whole when something comes near, or when any of its bodies, forces, joints or motors, or what bears
     * it, is changed. These keep islands awake: motors that want to run, forces that do not say that they are
     * {@link ForceGenerator#isAutonomous() autonomous}, and constraints of your own.
     *
     * @param allowed false to wake all bodies and let none sleep, for scenes where things move very slowly
     * @throws IllegalStateException within a step
     */
    public void setSleepAllowed(boolean allowed) {
        requireBetweenSteps("sleep was set");
        isSleepAllowed = allowed;
        if (timeStepping != null && !relief.isOn()) {
            timeStepping.sleep().setAllowed(allowed);
        }
    }

    /**
     * Returns whether a body sleeps under time stepping. A change wakes bodies only when the next step begins.
     *
     * @param body a body of this engine
     * @return whether it sleeps; false by events, where bodies at rest cost nothing anyway
     * @throws IllegalStateException if the body is not in this engine
     */
    public boolean isAsleep(Body body) {
        requireMine(body);
        return isStepped && timeStepping.sleep().isAsleep(body.index());
    }

    /** The same for what makes steps others: listeners may not set it where they are told of a part of a step. */
    private void requireStepOver(String what) {
        requireBetweenSteps(what);
        if (goesOn) {
            throw new IllegalStateException(what + " within a step");
        }
    }

    private void requireBetweenSteps(String what) {
        if (stepping || asking) {
            throw new IllegalStateException(what + " within a step");
        }
    }

    /**
     * Returns the simulated time. It is the number of steps times their length, so it does not drift. Within a step, it is the
     * time at which that began; {@link sim.physics.response.Contact#time()} says when a collision is.
     *
     * @return time; 0 for a new engine
     */
    public double getTime() {
        return epoch + (steps - epochStep) * timeStep;
    }

    /**
     * Returns the number of steps taken.
     *
     * @return number of steps; 0 for a new engine
     */
    public long getSteps() {
        return steps;
    }

    /**
     * Returns the integrator of bodies under forces.
     *
     * @return the integrator; RK4 unless set
     */
    public Integrator getIntegrator() {
        return motion.getIntegrator();
    }

    /**
     * Sets the integrator of bodies under forces. Free bodies, and bodies under uniform fields only, need none: their paths are
     * exact with any integrator.
     *
     * @param integrator the integrator, not null
     * @throws IllegalStateException within a step
     */
    public void setIntegrator(Integrator integrator) {
        requireBetweenSteps("the integrator was set");
        motion.setIntegrator(integrator);
    }

    /**
     * Returns the number of threads that may share the work of a step.
     *
     * @return number of threads; 1 unless set
     */
    public int getThreads() {
        return team == null ? 1 : team.size();
    }

    /** How often work was shared by threads. */
    long sharedWorks() {
        return team == null ? 0 : team.works();
    }

    /** How many groups of bodies have gone through the last step without paths. */
    int latePaths() {
        return motion.late().count();
    }

    /**
     * Sets how many threads may share the work of a step. They share the islands of joints and the single bodies that the
     * integrator drives, the boxes of bodies, and the searches for impacts that begin with the step. The results are the same bit
     * for bit whatever the number, and so are the counts of work, the order of events and the exceptions thrown.
     *
     * <p>What happens within the step, impact by impact, stays with the stepping thread. So does all code of your own: bodies
     * under a {@link ForceGenerator} that does not say that it {@link ForceGenerator#isConcurrent() is concurrent}, and islands
     * with a constraint that is not of this library. A step with too little to share is not shared.
     *
     * <p>The helpers are threads of {@link java.util.concurrent.ForkJoinPool#commonPool()}, or of the pool in which the step is
     * made; the engine owns none. If they are busy elsewhere, the stepping thread does the work. But it waits for a helper that
     * has taken a portion. While the engine is audited, the stepping thread integrates the driven bodies.
     *
     * @param threads their number, including the stepping thread; 1 for that one alone
     * @throws IllegalArgumentException if the number is less than 1
     * @throws IllegalStateException within a step
     */
    public void setThreads(int threads) {
        if (threads < 1) {
            throw new IllegalArgumentException("threads are " + threads + ": there must be at least 1");
        }
        requireBetweenSteps("the number of threads was set");
        setThreads(threads, false);
    }

    /** The same, for tests: works are shared that are too small for it to pay, too. */
    void setThreads(int threads, boolean always) {
        team = threads == 1 ? null : new Team(threads, always);
        events.setTeam(team);
    }

    /**
     * Sets the solver for the equations of an impact.
     *
     * @param solver the solver, not null; engines in different threads need one each, as it may have memory of its own
     * @throws IllegalStateException if a force, a constraint or a curve calls it within a step
     */
    public void setImpulseSolver(ImpulseSolver solver) {
        state.requireOpen();
        response.setSolver(solver);
        events.askAuthors();
    }

    /**
     * Sets the rules by which the coefficients of two bodies make those of their contact. They hold for lasting contacts too.
     *
     * @param restitution rule for restitution; the smaller coefficient unless set
     * @param friction rule for friction; the geometric mean unless set
     * @throws IllegalStateException if a force, a constraint or a curve calls it within a step
     */
    public void setPairRules(PairRule restitution, PairRule friction) {
        state.requireOpen();
        response.laws().setRules(restitution, friction);
        events.askAuthors();
        admission.stirAll();
    }

    /**
     * Sets the broad phase. Unless set, the engine chooses one by the number of bodies. The write-up's is
     * {@link sim.physics.collision.broad.SortAndSweep}.
     *
     * @param broadPhase a new broad phase
     * @throws IllegalStateException within a step, or if an engine uses or has used this broad phase, even if it is this engine
     */
    public void setBroadPhase(BroadPhase broadPhase) {
        Objects.requireNonNull(broadPhase, "broadPhase");
        requireBetweenSteps("the broad phase was set");
        broadPhase.claim();
        events.setBroadPhase(broadPhase);
    }

    /**
     * Sets how impacts are found: in continuous time, so that nothing tunnels, or by the write-up's bisection over the last step,
     * which looks at the bodies only when a step is over.
     *
     * @param continuous true for continuous time, false for bisection; true unless set
     * @throws IllegalStateException within a step
     */
    public void setContinuousDetection(boolean continuous) {
        requireBetweenSteps("the way to find impacts was set");
        detection.narrowPhase().setContinuous(continuous);
        touchAll();
    }

    /**
     * Returns the pairs of bodies that overlap where they are now. Only bodies that collide count; those with a joint between
     * them normally do not. Bodies that touch or lie on one another may be listed with a depth of rounding, see
     * {@link #getDeepestPenetration()}. Bodies that overlapped when they were added are driven apart only by their own motion, so
     * it is better to call {@link #separate()} before the first step.
     *
     * @return one entry per pair, deepest first
     */
    public List<Overlap> overlaps() {
        return (stepping ? new Overlaps(detection.filter()) : admission.overlaps()).find(bodies());
    }

    /**
     * Moves overlapping bodies apart, without a gain of kinetic energy. Each pair is moved by the shortest distance that parts
     * it, the lighter body farther than the heavier. Joints that this opens are closed, and bodies that then overlap are parted
     * again.
     *
     * @return number of sweeps over all pairs; 0 if nothing overlapped
     * @throws IllegalStateException if there is no room, as bodies overlap no less after hundreds of sweeps; all is as before then
     */
    public int separate() {
        requireBetweenSteps("bodies were to be separated");
        admission.forgetAnswers();
        return admission.separate(bodies());
    }

    /**
     * Returns the number of collisions.
     *
     * @return number since the engine was made
     */
    public long getImpacts() {
        return response.impacts() + (timeStepping == null ? 0 : timeStepping.decisions().impacts());
    }

    /**
     * Returns the deepest penetration at which a collision was ever solved.
     *
     * @return length, not negative; a matter of rounding
     */
    public double getDeepestPenetration() {
        return 0 - Math.min(response.deepest(), timeStepping == null ? 0 : timeStepping.deepest());
    }

    /**
     * Returns the number of poses at which the narrow phase looked at a pair, an exact measure of its work.
     *
     * @return number since the engine was made or restored
     */
    public long getNarrowPhaseEvaluations() {
        return detection.narrowPhase().evaluations() + (timeStepping == null ? 0 : timeStepping.looks());
    }

    /**
     * Sets whether the engine audits its steps: by how much bodies miss their places, and where energy goes. An audit changes no
     * bit of the run. Steps of bodies that an integrator drives take ten times as long with methods of high order, and fifty
     * times as long with RK4. When it is off, the audit costs nothing.
     *
     * @param audited true to begin a new audit, false to end it; false unless set
     * @throws IllegalStateException within a step
     */
    public void setAudited(boolean audited) {
        requireStepOver("the audit was set");
        if (audited && relief.isOn()) {
            resume(true);
        }
        if (audited && isStepped) {
            throw new IllegalStateException("an audit was asked for under time stepping: call setTimeStepping(0) before");
        }
        audit = audited ? new Audit(state, trajectories, motion) : null;
        motion.setObserver(audit);
        admission.setAudit(audit);
        events.setAudit(audit);
    }

    /**
     * Returns the audit's report on the last step.
     *
     * @return the report; all zero before the first step
     * @throws IllegalStateException if the engine is not audited
     */
    public StepReport getStepReport() {
        return audit().step();
    }

    /**
     * Returns the audit's report on all steps since it began.
     *
     * @return sums over the steps, and the energies at both ends
     * @throws IllegalStateException if the engine is not audited
     */
    public StepReport getRunReport() {
        return audit().run();
    }

    /** {@return whether MASON's inspectors leave out the audit's report on the last step, since there is none} */
    public boolean hideStepReport() {
        return audit == null;
    }

    /** {@return whether MASON's inspectors leave out the audit's report on all steps, since there is none} */
    public boolean hideRunReport() {
        return audit == null;
    }

    private Audit audit() {
        if (audit == null) {
            throw new IllegalStateException("a report was asked for: call setAudited(true) before");
        }
        return audit;
    }

    /**
     * Returns the kinetic energy of all bodies.
     *
     * @return Σ m v²/2 + I ω²/2
     */
    public double kineticEnergy() {
        double sum = 0;
        for (int i = 0; i < state.size(); i++) {
            Body body = state.body(i);
            sum += body == null ? 0 : body.kineticEnergy();
        }
        return sum;
    }

    /**
     * Schedules the engine, to make one step in each unit of schedule time. If it was scheduled before, on this schedule or on
     * another, that ends: no engine makes two steps at a time.
     *
     * @param schedule MASON's schedule
     * @return an object that stops the engine
     * @throws IllegalStateException if the schedule has come to its end, as it does when nothing is left on it; all is as before then
     */
    public Repeating scheduleOn(Schedule schedule) {
        Objects.requireNonNull(schedule, "schedule");
        Repeating repeating = new Repeating(this, ORDERING, 1);
        double next = schedule.getTime() < Schedule.EPOCH ? Schedule.EPOCH : schedule.getTime() + 1;
        if (!schedule.scheduleOnce(next, ORDERING, repeating)) {
            throw new IllegalStateException("the schedule is at its end, as nothing was left on it: it takes the engine after reset(), or SimState.start()");
        }
        if (scheduled != null) {
            scheduled.stop();
        }
        scheduled = repeating;
        return repeating;
    }

    @Override
    public void step(SimState model) {
        step();
    }
}
