// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.constraint.tree.ServoStep;
import sim.physics.motion.Loads;
import sim.physics.motion.State;

/**
 * The quick way of an island of pins that form a tree, with motors and stops of the angles of these pins, while nothing switches: a motor
 * that has its speed and a stop that is pressed hold their pins, and others push with forces that are known.
 */
final class Servos implements Serializable {
    private static final long serialVersionUID = 1L;

    /** What is left of a stop's gap, in rad, and of a speed, relative to those of both bodies, by rounding. */
    private static final double CLOSED = 1e-13;

    private static final double SLIP = 1e-13;

    private final Island island;
    private final ServoStep step;
    private final Switched[] rows;

    /** By row: its link, and whether its force is a torque on that; else it is one on the link before. */
    private final int[] link;

    private final boolean[] isOnLink;

    /** The node of a row, and the blocks of its bodies. */
    private final int[] node;

    private final int[] blockA;
    private final int[] blockB;

    /** Whether some joint can break; null when it is not known. */
    private Boolean breakable;

    private Servos(Island island, ServoStep step, Switched[] rows, int[] nodes) {
        this.island = island;
        this.step = step;
        this.rows = rows;
        int n = rows.length;
        link = new int[n];
        isOnLink = new boolean[n];
        node = nodes;
        blockA = new int[n];
        blockB = new int[n];
        for (int k = 0; k < n; k++) {
            blockA[k] = island.blockA[nodes[k]];
            blockB[k] = island.blockB[nodes[k]];
            link[k] = step.link(blockA[k], blockB[k]);
            isOnLink[k] = link[k] >= 0 && step.is(link[k], blockA[k]);
            rows[k].turn(blockA[k], blockB[k]);
        }
    }

    /** Those of an island; null if it is none of these. */
    static Servos of(Island island, PinRows pins, Switched[] rows, int[] nodes) {
        boolean isOne = rows.length > 0 && !island.isMoved;
        for (int k = 0; isOne && k < island.constraints.length; k++) {
            Constraint one = island.constraints[k];
            isOne = one instanceof PinJoint || one instanceof Switched s && s.coordinate() instanceof GearJoint gear && gear.getRatio() == -1;
        }
        ServoStep step = isOne ? pins.servos() : null;
        if (step == null) {
            return null;
        }
        Servos servos = new Servos(island, step, rows, nodes);
        for (int k = 0; k < rows.length; k++) {
            isOne &= servos.link[k] >= 0;
        }
        return isOne ? servos : null;
    }

    /** Forgets what a body or a constraint that was written may have changed. */
    void forget() {
        breakable = null;
        step.forgetMasses();
    }

    long takePassed() {
        return step.takePassed();
    }

    /** A step of RK4 in a uniform field; false if there is no quick way. */
    boolean advance(State state, ConstraintSolver solver, double gx, double gy, double h) {
        return begin(state, solver) && step.advance(state, gx, gy, h);
    }

    /** The same under any loads. */
    boolean advance(State state, ConstraintSolver solver, Loads loads, double[] a, double t, double h) {
        return begin(state, solver) && step.advance(state, loads, a, t, h);
    }

    /**
     * The accelerations with the rows that act now, and the forces of these; false if they must be found otherwise. Those of the pins are
     * not found.
     */
    boolean accelerate(State state, ConstraintSolver solver, double[] a) {
        if (!isFor(state, solver) || island.effort.isFree() || isBreakable()) {
            return false;
        }
        step.clear();
        for (int k = 0; k < rows.length; k++) {
            if (!rows[k].isOnNow && rows[k].forceNow != 0) {
                step.push(link[k], isOnLink[k] ? rows[k].forceNow : -rows[k].forceNow);
            }
        }
        boolean isWell = true;
        for (int k = 0; k < rows.length && isWell; k++) {
            isWell = !rows[k].isOnNow || step.hold(link[k], Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
        }
        if (!isWell || !step.accelerate(state, a)) {
            return false;
        }
        island.switches.measure(state);
        for (int k = 0; k < rows.length; k++) {
            double torque = rows[k].isOnNow ? step.holds(link[k]) : 0;
            island.lambda[2 * node[k]] = isOnLink[k] ? torque : -torque;
        }
        return true;
    }

    /** Gives the bodies the velocities that the rows which act now ask for, as {@link Projection#settle} does; false if that must do it. */
    boolean settle(State state, ConstraintSolver solver) {
        if (!isFor(state, solver)) {
            return false;
        }
        double[] bias = island.switches.bias();
        boolean isSettled = true;
        boolean isWell = true;
        step.clear();
        for (int k = 0; k < rows.length && isWell; k++) {
            if (rows[k].isOnNow) {
                double turning = turning(state, blockA[k]);
                double other = turning(state, blockB[k]);
                double wanted = -bias[2 * node[k]];
                double missing = wanted - (turning - other);
                isSettled &= Math.abs(missing) <= Projection.ROUNDING * (Math.abs(turning) + Math.abs(other) + Math.abs(wanted));
                isWell = step.hold(link[k], Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
                step.jump(link[k], isOnLink[k] ? missing : -missing);
            }
        }
        return isWell && (isSettled || step.jump(state));
    }

    private static double turning(State state, int block) {
        return block < 0 ? 0 : state.v()[block + State.THETA];
    }

    /** Whether somebody may want to know what the pins bear. */
    private boolean isBreakable() {
        breakable = breakable == null ? Grouping.isBreakable(island.inOrder) : breakable;
        return breakable;
    }

    private boolean isFor(State state, ConstraintSolver solver) {
        return solver.isDirect() && !DirectSolver.isSpread(island, state.w().values());
    }

    /** Tells the tree what its pins do; false if that is nothing for it. */
    private boolean begin(State state, ConstraintSolver solver) {
        if (!isFor(state, solver)) {
            return false;
        }
        step.clear();
        for (int k = 0; k < rows.length; k++) {
            if (!rows[k].isOn && rows[k].force != 0) {
                step.push(link[k], isOnLink[k] ? rows[k].force : -rows[k].force);
            }
        }
        boolean isWell = true;
        for (int k = 0; k < rows.length && isWell; k++) {
            isWell = !rows[k].isOn || isHeld(rows[k], state, blockA[k], blockB[k]) && hold(k);
        }
        return isWell;
    }

    private boolean hold(int k) {
        double least = island.switches.isLimited() ? rows[k].least() : Double.NEGATIVE_INFINITY;
        double greatest = island.switches.isLimited() ? rows[k].greatest() : Double.POSITIVE_INFINITY;
        return step.hold(link[k], isOnLink[k] ? least : -greatest, isOnLink[k] ? greatest : -least);
    }

    /** Whether a row that acts has its coordinate where and as fast as it should be. */
    private static boolean isHeld(Switched row, State state, int a, int b) {
        GearJoint gear = (GearJoint) row.coordinate();
        double first = a < 0 ? row.getBodyA().getAngle() : state.x()[a + State.THETA];
        double second = b < 0 ? Joint.angle(row.getBodyB()) : state.x()[b + State.THETA];
        double gap = row.gap(gear.open(first, second));
        double turning = turning(state, a);
        double other = turning(state, b);
        double slip = turning - other - row.target();
        return Math.abs(gap) <= CLOSED * (1 + Math.abs(first) + Math.abs(second))
                && Math.abs(slip) <= SLIP * (Math.abs(turning) + Math.abs(other) + Math.abs(row.target()));
    }
}
