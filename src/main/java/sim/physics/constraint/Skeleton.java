// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import sim.physics.internal.DisjointSets;
import sim.physics.internal.IntList;
import sim.physics.motion.Loads;
import sim.physics.motion.State;

/**
 * An island without its motors and stops, which push its bodies with torques that are given: an island of fewer rows, often a
 * tree of pins. What they push with counts as loads.
 */
final class Skeleton implements Loads, Serializable {
    private static final long serialVersionUID = 1L;

    /** The island that is left. */
    final Island island;

    private final State state;
    private final Switches switches;

    /** Other loads; null for a uniform field. */
    private transient Loads others;

    private double gx;
    private double gy;
    private double[] accelerations = {};

    private Skeleton(Island whole, List<Constraint> left, Switches switches, State state) {
        island = new Island(whole.bodies, left);
        island.skeleton = this;
        this.switches = switches;
        this.state = state;
    }

    /** What is left of an island; null if it does not hang together, or rows depend on where bodies are. */
    static Skeleton of(Island whole, Switches switches, State state) {
        List<Constraint> left = new ArrayList<>();
        boolean areTurns = true;
        for (Constraint one : whole.inOrder) {
            if (one instanceof Switched s) {
                areTurns &= s.coordinate() instanceof GearJoint;
            } else {
                left.add(one);
            }
        }
        return areTurns && hangsTogether(whole) ? new Skeleton(whole, left, switches, state) : null;
    }

    private static boolean hangsTogether(Island whole) {
        int[] set = new int[whole.bodies.size];
        for (int k = 0; k < set.length; k++) {
            set[k] = k;
        }
        int parts = set.length;
        for (int k = 0; k < whole.constraints.length; k++) {
            int a = whole.a[whole.firstNode[k]];
            int b = whole.b[whole.firstNode[k]];
            boolean joins = a >= 0 && b >= 0 && !(whole.constraints[k] instanceof Switched);
            if (joins && DisjointSets.find(set, a) != DisjointSets.find(set, b)) {
                DisjointSets.join(set, a, b);
                parts--;
            }
        }
        return parts == 1;
    }

    /** Adds what the motors and stops do to accelerations. */
    void push(double[] a) {
        switches.push(state.w().values(), a);
    }

    /** A step under loads beside those of motors and stops; false if there is no quick way. */
    boolean advance(ConstraintSolver solver, Loads loads, double[] a, double t, double h) {
        if (island.tree == null) {
            return false;
        }
        others = loads;
        try {
            return QuickStep.advanceTree(island, state, solver, this, a, t, h);
        } finally {
            others = null;
        }
    }

    /** The same in a uniform field. */
    boolean advance(ConstraintSolver solver, double fieldX, double fieldY, double h) {
        gx = fieldX;
        gy = fieldY;
        if (accelerations.length < state.x().length) {
            accelerations = new double[state.x().length];
        }
        return advance(solver, null, accelerations, 0, h);
    }

    @Override
    public void load(IntList bodies, double t, double[] a) {
        if (others != null) {
            others.load(bodies, t, a);
        } else {
            for (int k = 0; k < bodies.size; k++) {
                int s = State.BLOCK * bodies.values[k];
                a[s] = gx;
                a[s + 1] = gy;
                a[s + 2] = 0;
            }
        }
        push(a);
    }
}
