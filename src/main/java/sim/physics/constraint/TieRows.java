// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import sim.physics.internal.Freshness;
import sim.physics.internal.IntList;
import sim.physics.internal.OpenGroups;
import sim.physics.internal.Softness;
import sim.physics.motion.State;

/**
 * The equations of constraints, motors and stops as time stepping solves them: one after the other for impulses that act in a
 * substep, each with those of its own rows together.
 */
public final class TieRows implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int BLOCK = State.BLOCK;
    private static final int ROWS = Equations.ROWS;

    /** How often trees are brought onto their joints in a substep at most: each time, what is left is about the square of what was open. */
    private static final int CLOSINGS = 2;

    private final State state;
    final TieEquations equations;

    /** The pins, which have a loop of their own; and all others. */
    private final TieOrder order = new TieOrder();

    private final PinImpulses pinImpulses;
    private final StopRows stops;
    private final TieSolver solver;
    private final HeldMotors held;
    private final TurningRows turning;
    private final TieTrees trees;

    /** Impulses of this substep; of a stop that of its lower and its upper bound. */
    private double[] impulse = {};

    private double h;

    /** Impulses with which the step began. */
    private double[] kept = {};

    /** What the first bodies got in the step: impulse, and turning impulse about the centre. */
    private double[] sum = {};

    /** Bounds of motors at the start of the step. */
    private double[] limits = {};

    /** The changes that these rows are for. */
    private long version = -1;

    /**
     * Makes rows of no constraint.
     *
     * @param state the state vectors
     */
    public TieRows(State state) {
        this.state = state;
        equations = new TieEquations(state);
        held = new HeldMotors(state, equations);
        pinImpulses = new PinImpulses(state);
        turning = new TurningRows(state, equations, pinImpulses);
        trees = new TieTrees(state, equations, pinImpulses);
        stops = new StopRows(state, equations, held, turning);
        solver = new TieSolver(state, equations, turning, stops, trees);
    }

    /** What is known of a constraint from earlier steps: impulses and what else is kept, and the blocks of its bodies. */
    private record Before(double[] values, int first, int second) {}

    /**
     * Takes the constraints of an engine; impulses of those that stay are kept, and of sleeping bodies all that was done.
     *
     * @param constraints all of them, regrouped
     * @param asleep by body
     * @param areOthersAsleep whether these are others than before
     * @param changed takes the bodies of constraints that are new, or gone
     * @return whether there are other constraints than before
     */
    public boolean gather(Constraints constraints, boolean[] asleep, boolean areOthersAsleep, IntList changed) {
        boolean isNew = version != constraints.grouping();
        if (!isNew && !areOthersAsleep) {
            return false;
        }
        version = constraints.grouping();
        trees.note(order.pins);
        Map<Constraint, Before> before = new IdentityHashMap<>();
        for (int k = 0; k < equations.ties.length; k++) {
            before.put(equations.ties[k], new Before(record(k), equations.blocks[2 * k], equations.blocks[2 * k + 1]));
        }
        for (int k = 0; k < order.pins.size(); k++) {
            before.put(order.pins.get(k), new Before(pinImpulses.record(k), pinImpulses.block(k, 0), pinImpulses.block(k, 1)));
        }
        order.sort(constraints.all(), asleep);
        pinImpulses.gather(order.pins, order.awakePins);
        for (int k = 0; k < order.pins.size(); k++) {
            Before old = before.remove(order.pins.get(k));
            if (old != null) {
                pinImpulses.setRecord(k, old.values);
            } else {
                change(changed, pinImpulses.block(k, 0), pinImpulses.block(k, 1));
            }
        }
        gather(order.others, before, changed);
        trees.gather(order.pins, order.awakePins);
        trees.pressed().gather(impulse);
        for (Before gone : before.values()) {
            change(changed, gone.first, gone.second);
        }
        return isNew;
    }

    private static void change(IntList changed, int first, int second) {
        changed.add(first / BLOCK);
        changed.add(Math.max(first, second) / BLOCK); // there may be no second one
    }

    private void gather(List<Constraint> others, Map<Constraint, Before> before, IntList changed) {
        equations.gather(others, order.awakeOthers);
        int n = others.size();
        impulse = new double[ROWS * n];
        kept = new double[ROWS * n];
        sum = new double[BLOCK * n];
        limits = new double[n];
        solver.gather(impulse);
        stops.gather(impulse, jointed());
        held.gather();
        turning.gather(order.pins, order.awakePins);
        for (int k = 0; k < n; k++) {
            Before old = before.remove(others.get(k));
            if (old != null) {
                System.arraycopy(old.values, 0, impulse, ROWS * k, ROWS);
                System.arraycopy(old.values, ROWS, sum, BLOCK * k, BLOCK);
                limits[k] = old.values[ROWS + BLOCK];
            } else {
                change(changed, equations.blocks[2 * k], equations.blocks[2 * k + 1]);
            }
        }
    }

    private boolean[] jointed() {
        boolean[] marks = new boolean[state.x().length / BLOCK];
        pinImpulses.mark(marks);
        for (int k = 0; k < equations.count(); k++) {
            if (equations.kinds[k].ties()) {
                equations.mark(k, marks);
            }
        }
        return marks;
    }

    /** Impulses, what they did in the step, and the bound of a constraint. */
    private double[] record(int k) {
        double[] record = new double[ROWS + BLOCK + 1];
        System.arraycopy(impulse, ROWS * k, record, 0, ROWS);
        System.arraycopy(sum, BLOCK * k, record, ROWS, BLOCK);
        record[ROWS + BLOCK] = limits[k];
        return record;
    }

    /** Forgets all constraints and what they did. */
    public void forget() {
        order.clear();
        equations.gather(List.of(), 0);
        pinImpulses.gather(List.of(), 0);
        held.gather();
        turning.gather(List.of(), 0);
        trees.gather(List.of(), 0);
        version = -1;
    }

    /**
     * Marks the bodies that are tied.
     *
     * @param marks by body
     */
    public void mark(boolean[] marks) {
        pinImpulses.mark(marks);
        equations.mark(marks);
    }

    /**
     * Marks the bodies that do not stay where they are: those of motors that want to run, and of constraints of authors, which may say
     * something else in each step.
     *
     * @param marks by body
     */
    public void markDriven(boolean[] marks) {
        equations.markDriven(limits, marks);
    }

    /**
     * Finds the bodies of sleeping motors that were set.
     *
     * @param found takes their indices, of fixed ones, too
     */
    public void findSet(IntList found) {
        equations.findSet(limits, found);
    }

    /**
     * Begins a step.
     *
     * @param growth how many times longer its substeps are than those of the last one: impulses grow with them
     * @param substep the length of one
     */
    public void begin(double growth, double substep) {
        h = substep;
        trees.begin();
        pinImpulses.begin(growth, h);
        for (int k = 0; growth != 1 && k < ROWS * equations.count(); k++) {
            impulse[k] *= growth;
        }
        equations.evaluate(true, h, null);
        turning.evaluate();
        held.share(impulse, h);
        Arrays.fill(sum, 0, BLOCK * equations.count(), 0);
        stops.begin(h);
        for (int k = 0; k < equations.count(); k++) {
            limits[k] = equations.ties[k] instanceof Motor motor ? motor.getLimit() : 0;
        }
    }

    /**
     * Evaluates equations of some bodies where the state vectors say that these are, within a step.
     *
     * @param marks by body
     */
    public void evaluate(boolean[] marks) {
        pinImpulses.evaluate(0, marks);
        equations.evaluate(false, h, marks);
        turning.evaluate();
    }

    /** The same, when the bodies have moved: half of what they were given at the start of the substep follows them. */
    public void follow() {
        pinImpulses.evaluate(0.5, null);
        equations.follow(h);
        turning.evaluate();
        for (int n = 0; n < CLOSINGS && trees.straighten(impulse, h); n++) {
            evaluate(trees.moved());
        }
    }

    /** Gives the bodies the impulses of the substep before. */
    public void start() {
        pinImpulses.start();
        Arrays.fill(equations.given, 0);
        System.arraycopy(impulse, 0, kept, 0, ROWS * equations.count());
        for (int k = 0; k < equations.count(); k++) {
            boolean isStop = equations.kinds[k] == TieEquations.Kind.STOP;
            for (int o = ROWS * k, r = 0; r < equations.rows[k]; r++) {
                equations.start(k, r, isStop ? impulse[o] - impulse[o + 1] : impulse[o + r]);
            }
        }
    }

    /**
     * Finds the bodies that are tied to the world, or to what cannot move.
     *
     * @param found takes them, each with the body that it is tied to, −1 for the world
     */
    public void findFastened(IntList found) {
        pinImpulses.findFastened(found);
        equations.findFastened(found);
    }

    /**
     * Joins the sets of movable bodies that are tied to one another.
     *
     * @param parent sets of bodies
     */
    public void join(int[] parent) {
        pinImpulses.join(parent);
        TieEquations.join(parent, equations.blocks, equations.count(), state.w().values());
    }

    /**
     * Takes the impulses of some bodies away, without a change of their velocities.
     *
     * @param marks by body
     */
    public void clear(boolean[] marks) {
        pinImpulses.clear(marks);
        for (int k = 0; k < equations.count(); k++) {
            if (equations.isMarked(k, marks)) {
                Arrays.fill(impulse, ROWS * k, ROWS * k + ROWS, 0);
                Arrays.fill(equations.given, BLOCK * k, BLOCK * k + BLOCK, 0);
            }
        }
    }

    /**
     * Takes a part of the impulses of the substep back, of whose velocities that was taken.
     *
     * @param shares what each body keeps
     */
    public void limit(double[] shares) {
        pinImpulses.limit(shares);
        for (int k = 0; k < equations.count(); k++) {
            double share = TieEquations.share(equations.blocks, k, shares);
            for (int r = 0; share < 1 && r < ROWS; r++) {
                impulse[ROWS * k + r] *= share;
                equations.given[BLOCK * k + r] *= share;
            }
        }
    }

    /**
     * Solves the constraints of some bodies once: places alone, or velocities alone, with wheels and motors.
     *
     * @param marks by body
     * @param softness how places are regained; {@link Softness#RIGID} if they are not
     * @param h substep
     */
    public void solve(boolean[] marks, Softness softness, double h) {
        trees.solve(impulse, marks, softness.rate() > 0, softness, h);
        solver.solve(marks, softness.rate() > 0, softness, h);
        pinImpulses.solve(marks, softness);
    }

    /**
     * Adds what motors may have given bodies in the substep: impulse times speed.
     *
     * @param group group of each movable body
     * @param given takes twice the energy, by group
     */
    public void give(int[] group, double[] given) {
        equations.give(impulse, group, given);
    }

    /**
     * Adds the impulses with which motors press.
     *
     * @param group group of each movable body
     * @param pressed takes them, by group
     */
    public void press(int[] group, double[] pressed) {
        equations.press(impulse, group, pressed);
    }

    /**
     * Solves the constraints of some bodies once, as {@link #solve(Softness, double)} does.
     *
     * @param marks by body
     * @param softness how places are regained; {@link Softness#RIGID} if they are not
     * @param h substep
     */
    public void solveAll(boolean[] marks, Softness softness, double h) {
        trees.solve(impulse, marks, false, softness, h);
        solver.solve(marks, false, softness, h);
        pinImpulses.solve(marks, softness);
    }

    /**
     * Solves all constraints once.
     *
     * @param softness how places are regained; {@link Softness#RIGID} if they are not
     * @param h substep
     */
    public void solve(Softness softness, double h) {
        trees.ask(impulse, softness, h);
        trees.solve(impulse, null, false, softness, h);
        solver.solve(softness, h);
        pinImpulses.solve(softness); // last, as what is solved last is right
        trees.judge(impulse, softness, h);
    }

    /** Adds the impulses of a substep to those of the step. */
    public void add() {
        pinImpulses.add();
        for (int k = 0; k < BLOCK * equations.count(); k++) {
            sum[k] += equations.given[k];
        }
        stops.add();
    }

    /** {@return the trees of joints} */
    public TieTrees trees() {
        return trees;
    }

    /** {@return what pins give where something pushes their bodies} */
    public PinLevers levers() {
        return turning.levers();
    }

    /** {@return the stops, and what strikes them} */
    public StopRows stops() {
        return stops;
    }

    /**
     * Begins to add up what bounces give.
     *
     * @param groups group of each movable body
     * @param marks by body, of those that are of a group in which something has met
     */
    public void keep(int[] groups, boolean[] marks) {
        Arrays.fill(equations.given, 0);
        pinImpulses.keep(groups, marks);
        solver.keep(groups, marks);
    }

    /**
     * Adds what was given since the impulses were kept to what was done in the step: none of it will be taken back.
     *
     * @param shares what each body keeps of it; null for all
     */
    public void note(double[] shares) {
        add(shares);
        pinImpulses.note(shares);
    }

    /**
     * Adds what was given since then, and puts back the impulses with which the substep began: what impacts take is no guess for the next one.
     *
     * @param marks bodies that something has struck
     * @param shares what each body keeps of what it was given
     */
    public void putBack(boolean[] marks, double[] shares) {
        add(shares);
        pinImpulses.note(shares);
        for (int k = 0; k < equations.count(); k++) {
            if (equations.isMarked(k, marks)) {
                System.arraycopy(kept, ROWS * k, impulse, ROWS * k, ROWS);
            }
        }
        pinImpulses.putBack(marks);
    }

    private void add(double[] shares) {
        for (int k = 0; k < equations.count(); k++) {
            double share = shares == null ? 1 : TieEquations.share(equations.blocks, k, shares);
            for (int o = BLOCK * k; o < BLOCK * k + BLOCK; o++) {
                sum[o] += share * equations.given[o];
            }
        }
        Arrays.fill(equations.given, 0);
    }

    /**
     * Solves joints of groups that have not settled for velocities once more, since they were {@linkplain #keep kept}, and says of which some were off.
     *
     * @param turns those that are solved
     * @param fresh which bodies have changed
     */
    public void settle(OpenGroups turns, Freshness fresh) {
        solver.settle(turns, fresh);
        pinImpulses.settle(turns, fresh);
    }

    /**
     * What a constraint did in the last step, in the mean.
     *
     * @param constraint one of them
     * @param time the step
     * @return its force; null if it has not been solved
     */
    public Reaction reaction(Constraint constraint, double time) {
        int k = order.place(constraint);
        return k == TieOrder.NONE ? null : k >= 0 ? pinImpulses.reaction(k, time) : reaction(~k, time);
    }

    private Reaction reaction(int k, double time) {
        return new Reaction(sum[BLOCK * k] / time, sum[BLOCK * k + 1] / time, sum[BLOCK * k + 2] / time);
    }

    /**
     * The joints that broke under what they did in the last step.
     *
     * @param time the step
     * @return those; empty if none did
     */
    public List<Constraint> overloaded(double time) {
        List<Constraint> those = List.of();
        boolean areAll = state.touchedCount() > 0; // else sleepers bear what they bore when they were judged
        for (int k = 0; k < (areAll ? order.pins.size() : order.awakePins); k++) {
            if (order.pins.get(k).isBreakable() && order.pins.get(k).breaksUnder(pinImpulses.reaction(k, time))) {
                those = those.isEmpty() ? new ArrayList<>() : those;
                those.add(order.pins.get(k));
            }
        }
        for (int k = 0; k < (areAll ? equations.ties.length : equations.count()); k++) {
            if (equations.ties[k] instanceof Joint joint && joint.isBreakable() && joint.breaksUnder(reaction(k, time))) {
                those = those.isEmpty() ? new ArrayList<>() : those;
                those.add(joint);
            }
        }
        return those;
    }
}
