// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import sim.physics.constraint.tree.TreeStep;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.KinematicBody;
import sim.physics.motion.State;

/**
 * Bodies that constraints tie together, and those constraints: the rows of J that concern no other body.
 *
 * <p>The rows lie in <i>nodes</i> of two, in the order of elimination: a pin is one node; a constraint of one row has an
 * empty second one, and one of three rows is two nodes. By node:
 *
 * <pre>
 *   j       [first body: x y θ of row 0, of row 1] [second body: the same]    12
 *   c, rate [row 0, row 1]                                                     2 each
 * </pre>
 */
final class Island implements Serializable {
    private static final long serialVersionUID = 2L;

    static final int J = NodeLayout.J;
    private static final int[] NONE = {};

    /** Movable bodies, ascending. */
    final IntList bodies;

    /** In the order of elimination. */
    final Constraint[] constraints;

    final int[] firstNode;
    final int nodes;

    /** Blocks of the nodes' bodies in the state vectors, −1 for what cannot move; and their numbers in the island. */
    final int[] blockA;

    final int[] blockB;
    final int[] a;
    final int[] b;

    final double[] j;
    final double[] c;
    final double[] rate;

    /** Multipliers of the last solve, 2 per node. */
    final double[] lambda;

    /** In the order in which they were added. */
    final List<Constraint> inOrder;

    /** What pushes the bodies beside the constraints, if this is an island without its motors and stops; else null. */
    Skeleton skeleton;

    /** This island as a list. */
    final List<Island> alone = new ArrayList<>(1);

    /** Whether all constraints are our own code. */
    final boolean isOwn;

    /** Whether the solves are those of a projection after a step. */
    boolean isProjected;

    /** Whether some rows depend on others; and how many did when that was found last. */
    boolean isRedundant;

    int redundantRows;

    final BlockFactor factor;

    final Turns turns;
    private final PinRows pins;
    private final JointRows joints;
    private final NodeRows rows;

    /** Constraints that must be asked themselves, and motors and stops. */
    private final int[] others;
    private final int[] switched;

    /** Wheels, and motors of wheels, which have no part where places are sought; none if there is nothing that has places. */
    private final int[] rolling;

    private boolean isPlacing;

    /** Whether a row is one between angles, 2 per node. */
    final boolean[] isAngle;

    private final boolean onlyPins;

    /** Whether an author moves some body: its mass is so large that forces between links lose digits. */
    final boolean isMoved;

    /** Null unless the constraints are pins that form a tree. */
    final TreeStep tree;

    /** Null unless the constraints are pins that form a chain between two places that do not move. */
    final ChainStep chain;

    /** Null unless the constraints are welds that make one rigid body, which moves freely. */
    final RigidStep rigid;

    final Switches switches;
    final Invariants invariants;
    final Shake shake;

    /** What is done near singular poses. */
    final Passage passage;

    final Reactions reactions;

    final Effort effort;

    private final Equations equations = new Equations();
    double leastSize;
    double mostSize;
    private double spread;

    /**
     * Makes an island.
     *
     * @param bodies indices, ascending
     * @param those the constraints between them, in the order in which they were added
     */
    Island(IntList bodies, List<Constraint> those) {
        this.bodies = bodies;
        inOrder = those;
        alone.add(this);
        NodeLayout layout = layout(those);
        constraints = new Constraint[those.size()];
        for (int k = 0; k < constraints.length; k++) {
            constraints[k] = those.get(layout.order[k]);
        }
        firstNode = layout.firstNode;
        nodes = layout.nodes;
        a = layout.a;
        b = layout.b;
        blockA = blocks(a);
        blockB = blocks(b);
        j = new double[J * nodes];
        c = new double[2 * nodes];
        rate = new double[2 * nodes];
        lambda = new double[2 * nodes];
        measure();
        isAngle = layout.isAngle;
        factor = layout.factor;
        int[] shared = layout.shared(bodies.size);
        rows = new NodeRows(j, blockA, blockB, factor, shared);
        turns = new Turns(this);
        pins = new PinRows(this, turns);
        joints = new JointRows(this, turns);
        others = others();
        switched = where(k -> constraints[k] instanceof Switched);
        rolling = rolling();
        onlyPins = pins.areAll();
        pins.setShared(onlyPins ? shared : NONE);
        isMoved = those.stream().anyMatch(Island::isMoved);
        tree = onlyPins && !isMoved ? pins.tree() : null;
        chain = onlyPins && !isMoved && tree == null ? pins.chain() : null;
        rigid = isMoved ? null : RigidStep.of(this);
        switches = new Switches(this, pins);
        invariants = new Invariants(this);
        shake = new Shake(this);
        passage = new Passage(this);
        reactions = new Reactions(this);
        effort = new Effort(nodes, factor.start);
        isOwn = those.stream().allMatch(Joint::isOwn);
    }

    private static boolean isMoved(Constraint c) {
        return isMoved(c.getBodyA()) || isMoved(c.getBodyB());
    }

    private static boolean isMoved(Body body) {
        return body instanceof KinematicBody && !body.isImmobile();
    }

    private void measure() {
        leastSize = inOrder.stream().mapToDouble(Constraint::getSize).min().orElse(Double.POSITIVE_INFINITY);
        mostSize = inOrder.stream().mapToDouble(Constraint::getSize).max().orElse(0);
    }

    private NodeLayout layout(List<Constraint> those) {
        int n = those.size();
        int[] first = new int[n];
        int[] second = new int[n];
        int[] count = new int[n];
        for (int k = 0; k < n; k++) {
            first[k] = local(those.get(k).getBodyA());
            second[k] = local(those.get(k).getBodyB());
            count[k] = those.get(k).getRows();
        }
        return new NodeLayout(first, second, count, (k, row) -> those.get(k).isAngle(row), bodies.size);
    }

    private int local(Body body) {
        return body == null || body.isImmobile() ? -1 : Arrays.binarySearch(bodies.values, 0, bodies.size, body.index());
    }

    private int[] blocks(int[] those) {
        return IntStream.of(those).map(local -> local < 0 ? -1 : State.BLOCK * bodies.values[local]).toArray();
    }

    private int[] others() {
        return where(k -> !pins.has(k) && !joints.take(constraints[k], firstNode[k]));
    }

    private int[] rolling() {
        int[] found = where(k -> Roll.isOf(constraints[k]));
        return found.length < constraints.length ? found : NONE;
    }

    private int[] where(IntPredicate what) {
        return IntStream.range(0, constraints.length).filter(what).toArray();
    }

    /** Evaluates C, J and J̇ ẋ at the positions and velocities of the state vectors. */
    void evaluate(State state) {
        effort.evaluate();
        boolean moved = turns.follow(state);
        pins.evaluate(state, moved);
        if (onlyPins) {
            return;
        }
        if (moved) {
            pins.writeRows();
        }
        joints.evaluate(state);
        for (int k : others) {
            equations.clear();
            constraints[k].evaluate(equations);
            if (!isOwn) {
                equations.check(constraints[k], constraints[k].getRows());
            }
            for (int row = 0; row < constraints[k].getRows(); row++) {
                take(firstNode[k] + (row >> 1), row & 1, row);
            }
        }
        if (turns.isCarried()) {
            rows.carry(state.carry().lowX(), pins, c);
        }
        for (int k : switched) {
            factor.rest(firstNode[k], !((Switched) constraints[k]).isOnNow);
        }
        for (int k : rolling) {
            restWhilePlacing(k);
        }
    }

    private void restWhilePlacing(int k) {
        int p = firstNode[k];
        if (isPlacing) {
            factor.rest(p, true);
            rate[2 * p] = 0;
            Arrays.fill(j, J * p, J * (p + 1), 0);
        } else if (constraints[k] instanceof Wheel) {
            factor.rest(p, false);
        }
    }

    /** Whether some constraints have no part where places are sought. */
    boolean rolls() {
        return rolling.length > 0;
    }

    /** Says whether places are sought, from the next evaluation on; returns whether they were. */
    boolean setPlacing(boolean yes) {
        boolean was = isPlacing;
        isPlacing = yes;
        return was;
    }

    /** Evaluates again after a move whose square is less than rounding. */
    void nudge(State state, double[] move) {
        turns.nudge(state.x(), move);
        evaluate(state);
    }

    /** Adds p C + v J ẋ to J̇ ẋ. */
    void feedBack(double[] v, double position, double velocity) {
        double[] open = new double[2 * nodes];
        residual(v, null, open);
        for (int k = 0; k < open.length; k++) {
            rate[k] += position * c[k] - velocity * open[k];
        }
    }

    private void take(int p, int half, int row) {
        c[2 * p + half] = equations.c[row];
        rate[2 * p + half] = equations.rate[row];
        int o = J * p + 3 * half;
        for (int k = 0; k < 3; k++) {
            j[o + k] = a[p] < 0 ? 0 : equations.jA[3 * row + k];
            j[o + 6 + k] = b[p] < 0 ? 0 : equations.jB[3 * row + k];
        }
    }

    /** A = J W Jᵀ, (41), and its factors; rows that are zero get a 1 on the diagonal. */
    void factor(double[] w, double relaxation, double least, boolean whole) {
        effort.factor();
        assemble(w, factor);
        factor.factor(relaxation, least, whole);
    }

    /** Factors A and solves A λ = b at once, b and λ in {@code right}. */
    void factorAndSolve(double[] w, double[] right, double least) {
        effort.factor();
        effort.solve();
        assemble(w, factor);
        factor.factor(right, least);
        factor.back(right);
    }

    /** A of other masses. */
    void assembleOther(double[] w, BlockFactor to) {
        pins.forgetMasses();
        assemble(w, to);
        pins.forgetMasses();
    }

    /** u += W Jᵀ λ with other masses. */
    void applyOther(double[] w, double[] multipliers, double[] u) {
        pins.forgetMasses();
        apply(w, multipliers, u);
        pins.forgetMasses();
    }

    private void assemble(double[] w, BlockFactor to) {
        to.clear();
        if (onlyPins) {
            pins.diagonal(w, to.diagonal());
            pins.couple(to.below());
        } else {
            rows.diagonal(w, to.diagonal());
            rows.couple(to.below());
        }
    }

    /** Whether all constraints are pins. */
    boolean hasOnlyPins() {
        return onlyPins;
    }

    /** Makes sure that {@code j} holds the rows of J. */
    void writeRows() {
        pins.writeRows();
    }

    /** Forgets what a body or a constraint that was written may have changed: masses, lengths, and which motors and stops act. */
    void forget() {
        if (joints.measure()) {
            measure();
        }
        switches.forget();
        spread = 0;
        passage.forget();
        pins.forgetMasses();
        if (tree != null) {
            tree.forgetMasses();
        }
        if (chain != null) {
            chain.forgetMasses();
        }
    }

    /** Ratio of the largest mass to the smallest one. */
    double spread(double[] w) {
        if (spread == 0) {
            double least = Double.POSITIVE_INFINITY;
            double most = 0;
            for (int k = 0; k < bodies.size; k++) {
                least = Math.min(least, w[State.BLOCK * bodies.values[k]]);
                most = Math.max(most, w[State.BLOCK * bodies.values[k]]);
            }
            spread = most / least;
        }
        return spread;
    }

    /** Number of rows that depend on others, as the last factorization found. */
    int redundant() {
        return factor.pivots.redundant();
    }

    /** Number of rows that depend on others, or nearly so, as the last factorization found. */
    int near() {
        return factor.pivots.near();
    }

    /** Solves A λ = b in place. */
    void solve(double[] right) {
        effort.solve();
        factor.solve(right);
    }

    /** −(J u + g) into {@code right}. */
    void residual(double[] u, double[] g, double[] right) {
        if (onlyPins) {
            pins.residual(u, g, right);
            return;
        }
        rows.residual(u, g, right);
    }

    /** u += W Jᵀ λ, (37) and (40). */
    void apply(double[] w, double[] multipliers, double[] u) {
        if (onlyPins) {
            pins.apply(w, multipliers, u);
            return;
        }
        rows.apply(w, multipliers, u);
    }
}
