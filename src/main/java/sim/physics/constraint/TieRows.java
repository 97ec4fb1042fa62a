// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import sim.physics.internal.IntList;
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

    /** Values of J of a constraint: for its first body, and for its second one. */
    private static final int J = 2 * BLOCK * ROWS;

    /** What a constraint is. */
    private enum Kind {
        JOINT,
        MOTOR,
        STOP
    }

    private final State state;
    private final Equations equations = new Equations();

    /** The pins, which have a loop of their own; and all others. */
    private final TieOrder order = new TieOrder();

    private final PinImpulses pinImpulses;
    private Constraint[] ties = {};
    private Kind[] kinds = {};
    private int[] rows = {};

    /** The turn that a constraint is about, whose J does not change; null for others. */
    private GearJoint[] gears = {};

    /** Per constraint: the blocks of its bodies, −1 for the world. */
    private int[] blocks = {};

    private double[] j = {};
    private double[] c = {};
    /** The inverse of J W Jᵀ, 3 × 3. */
    private double[] inverse = {};
    /** Impulses of this substep; of a stop that of its lower and its upper bound. */
    private double[] impulse = {};
    /** The same, to be put back. */
    private double[] kept = {};
    /** Their sums over the substeps, along J. */
    private double[] sum = {};
    /** Speeds of stops, and bounds of motors, at the start of the step. */
    private double[] approach = {};

    /** Whether a bound of a stop has borne something in this step. */
    private boolean[] hit = {};

    /** The changes that these rows are for. */
    private long version = -1;

    /**
     * Makes rows of no constraint.
     *
     * @param state the state vectors
     */
    public TieRows(State state) {
        this.state = state;
        pinImpulses = new PinImpulses(state);
    }

    /**
     * Takes the constraints of an engine; impulses of those that stay are kept, and of sleeping bodies all that was done.
     *
     * @param constraints all of them, regrouped
     * @param asleep by body
     * @param areOthersAsleep whether these are others than before
     * @return whether there are other constraints than before
     */
    public boolean gather(Constraints constraints, boolean[] asleep, boolean areOthersAsleep) {
        boolean isNew = version != constraints.grouping();
        if (!isNew && !areOthersAsleep) {
            return false;
        }
        version = constraints.grouping();
        Map<Constraint, double[]> before = new IdentityHashMap<>();
        for (int k = 0; k < ties.length; k++) {
            before.put(ties[k], record(k));
        }
        for (int k = 0; k < order.pins.size(); k++) {
            before.put(order.pins.get(k), pinImpulses.record(k));
        }
        order.sort(constraints.all(), asleep);
        pinImpulses.gather(order.pins, order.awakePins);
        for (int k = 0; k < order.pins.size(); k++) {
            double[] old = before.get(order.pins.get(k));
            if (old != null) {
                pinImpulses.setRecord(k, old);
            }
        }
        gather(order.others, before);
        return isNew;
    }

    private void gather(List<Constraint> others, Map<Constraint, double[]> before) {
        int n = others.size();
        ties = others.toArray(new Constraint[0]);
        kinds = new Kind[n];
        rows = new int[n];
        gears = new GearJoint[n];
        blocks = new int[2 * n];
        impulse = new double[ROWS * n];
        kept = new double[ROWS * n];
        j = new double[J * n];
        c = new double[ROWS * n];
        inverse = new double[ROWS * ROWS * n];
        sum = new double[ROWS * n];
        approach = new double[n];
        hit = new boolean[2 * n];
        for (int k = 0; k < n; k++) {
            Constraint tie = ties[k];
            Constraint one = tie instanceof Switched s ? s.coordinate() : tie;
            kinds[k] = tie instanceof Motor ? Kind.MOTOR : tie instanceof Limit ? Kind.STOP : Kind.JOINT;
            rows[k] = tie.getRows();
            gears[k] = one instanceof GearJoint gear ? gear : null;
            blocks[2 * k] = BLOCK * tie.getBodyA().index();
            blocks[2 * k + 1] = tie.getBodyB() == null ? -1 : BLOCK * tie.getBodyB().index();
            double[] old = before.get(tie);
            if (old != null) {
                System.arraycopy(old, 0, impulse, ROWS * k, ROWS);
                System.arraycopy(old, ROWS, sum, ROWS * k, ROWS);
                System.arraycopy(old, 2 * ROWS, j, J * k, J);
                approach[k] = old[2 * ROWS + J];
            }
        }
    }

    /** Impulses, their sums, J and the bound of a constraint. */
    private double[] record(int k) {
        double[] record = new double[2 * ROWS + J + 1];
        System.arraycopy(impulse, ROWS * k, record, 0, ROWS);
        System.arraycopy(sum, ROWS * k, record, ROWS, ROWS);
        System.arraycopy(j, J * k, record, 2 * ROWS, J);
        record[2 * ROWS + J] = approach[k];
        return record;
    }

    /** Forgets all constraints and what they did. */
    public void forget() {
        order.clear();
        ties = new Constraint[0];
        pinImpulses.gather(List.of(), 0);
        version = -1;
    }

    /**
     * Marks the bodies that are tied.
     *
     * @param marks by body
     */
    public void mark(boolean[] marks) {
        for (int k = 0; k < order.awakePins; k++) {
            mark(marks, order.pins.get(k));
        }
        for (int k = 0; k < order.awakeOthers; k++) {
            mark(marks, ties[k]);
        }
    }

    /**
     * Marks the bodies that do not stay where they are: those of motors that want to run, and of constraints of authors, which may say
     * something else in each step.
     *
     * @param marks by body
     */
    public void markDriven(boolean[] marks) {
        for (int k = 0; k < order.awakeOthers; k++) {
            if (isSet(k) || !Joint.isOwn(ties[k])) {
                mark(marks, ties[k]);
            }
        }
    }

    /**
     * Finds the bodies of sleeping motors that were set.
     *
     * @param found takes their indices, of fixed ones, too
     */
    public void findSet(IntList found) {
        found.clear();
        for (int k = order.awakeOthers; k < ties.length; k++) {
            if (isSet(k)) {
                found.add(ties[k].getBodyA().index());
                found.add(ties[k].getBodyB() == null ? ties[k].getBodyA().index() : ties[k].getBodyB().index());
            }
        }
    }

    /** Whether a constraint is a motor that wants to run, or is of another strength than in its last step. */
    private boolean isSet(int k) {
        return ties[k] instanceof Motor motor && (motor.getSpeed() != 0 || motor.getLimit() != approach[k]);
    }

    private static void mark(boolean[] marks, Constraint tie) {
        marks[tie.getBodyA().index()] = true;
        if (tie.getBodyB() != null) {
            marks[tie.getBodyB().index()] = true;
        }
    }

    /**
     * Begins a step.
     *
     * @param growth how many times longer its substeps are than those of the last one: impulses grow with them
     */
    public void begin(double growth) {
        pinImpulses.begin(growth);
        for (int k = 0; growth != 1 && k < ROWS * order.awakeOthers; k++) {
            impulse[k] *= growth;
        }
        evaluate(true);
        Arrays.fill(sum, 0, ROWS * order.awakeOthers, 0);
        Arrays.fill(hit, false);
        for (int k = 0; k < order.awakeOthers; k++) {
            approach[k] = kinds[k] == Kind.STOP ? speed(k, 0, state.v()) : ties[k] instanceof Motor motor ? motor.getLimit() : 0;
        }
    }

    /** Evaluates all equations where the state vectors say that the bodies are, within a step. */
    public void evaluate() {
        pinImpulses.evaluate();
        evaluate(false);
    }

    private void evaluate(boolean isFirst) {
        double[] x = state.x();
        double[] w = state.w().values();
        for (int k = 0; k < order.awakeOthers; k++) {
            if (gears[k] != null && !isFirst) {
                int b = blocks[2 * k + 1];
                c[ROWS * k] = gears[k].open(x[blocks[2 * k] + State.THETA], b < 0 ? 0 : x[b + State.THETA]);
                continue;
            }
            equations.clear();
            (kinds[k] == Kind.JOINT ? ties[k] : ((Switched) ties[k]).coordinate()).evaluate(equations);
            System.arraycopy(equations.c, 0, c, ROWS * k, rows[k]);
            System.arraycopy(equations.jA, 0, j, J * k, BLOCK * rows[k]);
            System.arraycopy(equations.jB, 0, j, J * k + BLOCK * ROWS, BLOCK * rows[k]);
            RowInverse.invert(rows[k], w, blocks[2 * k], blocks[2 * k + 1], j, J * k, inverse, ROWS * ROWS * k);
        }
    }

    /** Gives the bodies the impulses of the substep before. */
    public void start() {
        pinImpulses.start();
        for (int k = 0; k < order.awakeOthers; k++) {
            if (kinds[k] == Kind.STOP) {
                push(k, 0, impulse[ROWS * k] - impulse[ROWS * k + 1]);
            } else {
                for (int r = 0; r < rows[k]; r++) {
                    push(k, r, impulse[ROWS * k + r]);
                }
            }
        }
    }

    private double speed(int k, int row, double[] v) {
        int o = J * k + BLOCK * row;
        int a = blocks[2 * k];
        int b = blocks[2 * k + 1];
        double speed = j[o] * v[a] + j[o + 1] * v[a + 1] + j[o + 2] * v[a + 2];
        if (b >= 0) {
            o += BLOCK * ROWS;
            speed += j[o] * v[b] + j[o + 1] * v[b + 1] + j[o + 2] * v[b + 2];
        }
        return speed;
    }

    private void push(int k, int row, double by) {
        double[] v = state.v();
        double[] w = state.w().values();
        int o = J * k + BLOCK * row;
        int a = blocks[2 * k];
        int b = blocks[2 * k + 1];
        v[a] += w[a] * j[o] * by;
        v[a + 1] += w[a + 1] * j[o + 1] * by;
        v[a + 2] += w[a + 2] * j[o + 2] * by;
        if (b >= 0) {
            o += BLOCK * ROWS;
            v[b] += w[b] * j[o] * by;
            v[b + 1] += w[b + 1] * j[o + 1] * by;
            v[b + 2] += w[b + 2] * j[o + 2] * by;
        }
    }

    /**
     * Solves all constraints once.
     *
     * @param softness how places are regained; {@link Softness#RIGID} if they are not
     * @param h substep
     */
    public void solve(Softness softness, double h) {
        for (int k = 0; k < order.awakeOthers; k++) {
            switch (kinds[k]) {
                case JOINT -> join(k, softness);
                case MOTOR -> drive(k, (Motor) ties[k], h);
                case STOP -> stop(k, (Limit) ties[k], softness, h);
            }
        }
        pinImpulses.solve(softness); // last, as what is solved last is right
    }

    private void join(int k, Softness softness) {
        double[] v = state.v();
        int o = ROWS * k;
        int m = ROWS * o;
        int count = rows[k];
        double mass = softness.mass();
        double back = softness.impulse();
        double r0 = speed(k, 0, v) + softness.rate() * c[o];
        if (count == 1) {
            take(k, 0, -mass * inverse[m] * r0 - back * impulse[o]);
            return;
        }
        double r1 = speed(k, 1, v) + softness.rate() * c[o + 1];
        if (count == 2) {
            take(k, 0, -mass * (inverse[m] * r0 + inverse[m + 1] * r1) - back * impulse[o]);
            take(k, 1, -mass * (inverse[m + 3] * r0 + inverse[m + 4] * r1) - back * impulse[o + 1]);
            return;
        }
        double r2 = speed(k, 2, v) + softness.rate() * c[o + 2];
        for (int r = 0; r < ROWS; r++, m += ROWS) {
            double by = inverse[m] * r0 + inverse[m + 1] * r1 + inverse[m + 2] * r2;
            take(k, r, -mass * by - back * impulse[o + r]);
        }
    }

    private void take(int k, int row, double by) {
        impulse[ROWS * k + row] += by;
        push(k, row, by);
    }

    private void drive(int k, Motor motor, double h) {
        double most = motor.getLimit() * h;
        double old = impulse[ROWS * k];
        double asked = old - inverse[ROWS * ROWS * k] * (speed(k, 0, state.v()) - motor.getSpeed());
        take(k, 0, Math.max(-most, Math.min(most, asked)) - old);
    }

    private void stop(int k, Limit stop, Softness softness, double h) {
        double q = c[ROWS * k];
        bound(k, 0, q - stop.getLower(), 1, softness, h);
        bound(k, 1, stop.getUpper() - q, -1, softness, h);
    }

    /** One bound of a stop: what is left of the way may be gone in the substep, what is beyond it is regained. */
    private void bound(int k, int side, double gap, int sign, Softness softness, double h) {
        int o = ROWS * k + side;
        if (gap == Double.POSITIVE_INFINITY) {
            return;
        }
        double speed = sign * speed(k, 0, state.v());
        boolean isOpen = gap > 0;
        double aim = isOpen ? gap / h : softness.rate() * gap;
        double mass = isOpen ? 1 : softness.mass();
        double back = isOpen ? 0 : softness.impulse();
        double old = impulse[o];
        double now = Math.max(0, old - mass * inverse[ROWS * ROWS * k] * (speed + aim) - back * old);
        impulse[o] = now;
        hit[2 * k + side] |= now > 0;
        push(k, 0, sign * (now - old));
    }

    /** Adds the impulses of a substep to those of the step. */
    public void add() {
        pinImpulses.add();
        for (int k = 0; k < order.awakeOthers; k++) {
            int o = ROWS * k;
            boolean isStop = kinds[k] == Kind.STOP;
            sum[o] += isStop ? impulse[o] - impulse[o + 1] : impulse[o];
            sum[o + 1] += isStop ? 0 : impulse[o + 1];
            sum[o + 2] += isStop ? 0 : impulse[o + 2];
        }
    }

    /** Lets coordinates bounce off stops that they have hit. */
    public void bounce() {
        for (int k = 0; k < order.awakeOthers; k++) {
            if (kinds[k] != Kind.STOP || ((Limit) ties[k]).getRestitution() == 0) {
                continue;
            }
            double aim = -((Limit) ties[k]).getRestitution() * approach[k];
            double speed = speed(k, 0, state.v());
            boolean isLower = hit[2 * k] && aim > speed && approach[k] < 0;
            boolean isUpper = hit[2 * k + 1] && aim < speed && approach[k] > 0;
            if (isLower || isUpper) {
                double by = inverse[ROWS * ROWS * k] * (aim - speed);
                push(k, 0, by);
                sum[ROWS * k] += by;
            }
        }
    }

    /** Keeps the impulses of now, since what bounces take is no guess for the step to come. */
    public void keep() {
        System.arraycopy(impulse, 0, kept, 0, impulse.length);
        pinImpulses.exchange(false);
    }

    /** Puts back the impulses that were kept. */
    public void putBack() {
        System.arraycopy(kept, 0, impulse, 0, impulse.length);
        pinImpulses.exchange(true);
    }

    /** Solves joints for velocities once more. */
    public void settle() {
        for (int k = 0; k < order.awakeOthers; k++) {
            if (kinds[k] == Kind.JOINT) {
                join(k, Softness.RIGID);
            }
        }
        pinImpulses.solve(Softness.RIGID);
    }

    /**
     * What a constraint did in the last step, in the mean.
     *
     * @param constraint one of them
     * @param time the step
     * @return its force; null if it has not been solved
     */
    public Reaction reaction(Constraint constraint, double time) {
        int pin = order.pins.indexOf(constraint);
        if (pin >= 0) {
            return pinReaction(pin, time);
        }
        int k = Arrays.asList(ties).indexOf(constraint);
        return k < 0 ? null : reaction(k, time);
    }

    private Reaction pinReaction(int k, double time) {
        double x = pinImpulses.sum(k, 0) / time;
        double y = pinImpulses.sum(k, 1) / time;
        return new Reaction(x, y, pinImpulses.arm(k, 0) * y - pinImpulses.arm(k, 1) * x);
    }

    private Reaction reaction(int k, double time) {
        double x = 0;
        double y = 0;
        double turn = 0;
        for (int r = 0; r < rows[k]; r++) {
            int o = J * k + BLOCK * r;
            double force = sum[ROWS * k + r] / time;
            x += j[o] * force;
            y += j[o + 1] * force;
            turn += j[o + 2] * force;
        }
        return new Reaction(x, y, turn);
    }

    /**
     * The joints that broke under what they did in the last step.
     *
     * @param time the step
     * @return those; empty if none did
     */
    public List<Constraint> overloaded(double time) {
        List<Constraint> those = List.of();
        for (int k = 0; k < order.awakePins; k++) {
            if (order.pins.get(k).isBreakable() && order.pins.get(k).breaksUnder(pinReaction(k, time))) {
                those = those.isEmpty() ? new ArrayList<>() : those;
                those.add(order.pins.get(k));
            }
        }
        for (int k = 0; k < order.awakeOthers; k++) {
            if (ties[k] instanceof Joint joint && joint.isBreakable() && joint.breaksUnder(reaction(k, time))) {
                those = those.isEmpty() ? new ArrayList<>() : those;
                those.add(joint);
            }
        }
        return those;
    }
}
