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
        for (int k = 0, m = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++, m++) {
                x[m] = fromX[b];
                v[m] = fromV[b];
            }
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
        for (int k = 0, m = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++, m++) {
                a[m] = from[b];
            }
        }
    }

    @Override
    public void put(double[] x, double[] v) {
        double[] toX = state.x();
        double[] toV = state.v();
        for (int k = 0, m = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++, m++) {
                toX[b] = x[m];
                toV[b] = v[m];
            }
        }
    }

    @Override
    public void accelerations(double[] x, double[] v, double[] a, double[] byBlock) {
        for (int k = 0, m = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++, m++) {
                byBlock[b] = a[m];
            }
        }
    }

    @Override
    public boolean spread(double[] x, double[] v, double[] byX, double[] byV) {
        return false;
    }
}
