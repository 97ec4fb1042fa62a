// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;

/** Places and angles of bodies, as the state vectors have them. */
final class BodyCoordinates implements Coordinates, Serializable {
    private static final long serialVersionUID = 1L;

    private transient EquationsOfMotion equations;
    private transient State state;
    private transient IntList bodies;
    private transient Path path;

    BodyCoordinates() {
        // of nobody yet
    }

    /** Those of a group. */
    BodyCoordinates of(EquationsOfMotion equations, State state, IntList bodies, Path path) {
        this.equations = equations;
        this.state = state;
        this.bodies = bodies;
        this.path = path;
        return this;
    }

    @Override
    public int size() {
        return State.BLOCK * bodies.size;
    }

    @Override
    public void read(double[] x, double[] v) {
        double[] fromX = state.x();
        double[] fromV = state.v();
        for (int k = 0; k < bodies.size; k++) {
            copy(fromX, State.BLOCK * bodies.values[k], x, State.BLOCK * k);
            copy(fromV, State.BLOCK * bodies.values[k], v, State.BLOCK * k);
        }
    }

    @Override
    public double longest() {
        return Double.POSITIVE_INFINITY;
    }

    @Override
    public void accelerate(double[] x, double[] v, double t, double[] a) {
        put(x, v);
        equations.acceleration(bodies, t, path.stage);
        double[] from = path.stage;
        for (int k = 0; k < bodies.size; k++) {
            copy(from, State.BLOCK * bodies.values[k], a, State.BLOCK * k);
        }
    }

    @Override
    public void put(double[] x, double[] v) {
        double[] toX = state.x();
        double[] toV = state.v();
        for (int k = 0; k < bodies.size; k++) {
            copy(x, State.BLOCK * k, toX, State.BLOCK * bodies.values[k]);
            copy(v, State.BLOCK * k, toV, State.BLOCK * bodies.values[k]);
        }
    }

    private static void copy(double[] from, int at, double[] to, int where) {
        to[where] = from[at];
        to[where + 1] = from[at + 1];
        to[where + 2] = from[at + 2];
    }

    @Override
    public void accelerations(double[] x, double[] v, double[] a, double[] byBlock) {
        for (int k = 0; k < bodies.size; k++) {
            copy(a, State.BLOCK * k, byBlock, State.BLOCK * bodies.values[k]);
        }
    }

    @Override
    public boolean pass(double[] change) {
        double[] byBlock = path.sumX;
        for (int k = 0; k < bodies.size; k++) {
            copy(change, State.BLOCK * k, byBlock, State.BLOCK * bodies.values[k]);
        }
        if (!equations.pass(bodies, byBlock)) {
            return false;
        }
        for (int k = 0; k < bodies.size; k++) {
            copy(byBlock, State.BLOCK * bodies.values[k], change, State.BLOCK * k);
        }
        return true;
    }

    @Override
    public boolean spread(double[] x, double[] v, double[] byX, double[] byV) {
        return false;
    }
}
