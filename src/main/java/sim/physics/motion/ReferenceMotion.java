// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * Goes once more the way that driven bodies have gone, by a method of high order, with a tolerance far below the error of
 * the first: how far off they are, and the work of their forces along it,
 *
 * <pre>
 *   ∫ (Σ F·v + τ ω) dt
 * </pre>
 *
 * <p>by the quadrature of Lobatto with seven points. It has a workspace of its own and leaves everything as it was.
 */
public final class ReferenceMotion implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Of the whole way; exact to degree 11. */
    private static final double[] NODE = {
        0, 0.08488805186071653506, 0.26557560326464289310, 0.5, 0.73442439673535710690, 0.91511194813928346494, 1
    };

    private static final double[] WEIGHT = {
        1.0 / 42, 0.13841302368078297401, 0.21587269060493131171, 128.0 / 525, 0.21587269060493131171,
        0.13841302368078297401, 1.0 / 42
    };

    /** Tolerance beside that of the method that is audited. */
    private static final double FINER = 1e-3;

    /** The same, relative to the size of the bodies, where that has none; and the least that is of use. */
    private static final double FINE = 1e-12;

    private static final double FINEST = 1e-13;

    /** Energy, relative to what there is, that the quadrature may miss; at the least, and by the relative tolerance. */
    private static final double MISSING = 1e-11;

    private static final double COARSE = 10;
    private static final int DEEPEST = 14;

    /** Parts of a way at most; what is sudden at one instant needs two of each depth. */
    private static final int PANELS = 40;

    private final Motion original;
    private final Motion twin;
    private final State state;
    private final Trajectories trajectories;

    /** What the twin was made for. */
    private Integrator audited;

    private Ties ties;
    private long version;

    private double[] startSwitches = {};
    private double[] switches = {};
    private double[][] decided = {};
    private double[] x = {};
    private double[] v = {};
    private double[] f = {};
    private double[] a = {};
    private double[] free = {};

    /** What the steps of a stride miss, by coordinate, and the most of it so far, place and angle by first body of a group. */
    private double[] missed = {};

    private double[] most = {};
    private double missing;
    private int budget;
    private double work;
    private double place;
    private double angle;

    /**
     * Makes a reference.
     *
     * @param original the motion that is audited
     * @param state its state vectors
     * @param trajectories its paths
     */
    public ReferenceMotion(Motion original, State state, Trajectories trajectories) {
        this.original = original;
        this.state = state;
        this.trajectories = trajectories;
        twin = new Motion(original);
    }

    /**
     * The work of all forces along the last way, but for those that have a potential.
     *
     * @return energy
     */
    public double work() {
        return work;
    }

    /**
     * How far a body was off at the end of the last way.
     *
     * @return length, the largest of a body
     */
    public double place() {
        return place;
    }

    /**
     * How far a body had turned too far at the end of the last way.
     *
     * @return rad, the largest of a body
     */
    public double angle() {
        return angle;
    }

    /**
     * The energy that a body has in uniform fields.
     *
     * @param body index
     * @param px place
     * @param py place
     * @return −m g · x; 0 for a fixed body
     */
    public double fieldEnergy(int body, double px, double py) {
        double w = state.w().values()[State.BLOCK * body];
        Generators g = original.generators;
        return w == 0 ? 0 : -(g.gravityX * px + g.gravityY * py) / w;
    }

    /**
     * The acceleration of the uniform fields.
     *
     * @param isY the component
     * @return length/time²
     */
    public double field(boolean isY) {
        return isY ? original.generators.gravityY : original.generators.gravityX;
    }

    /**
     * The energy that generators store where the state vectors have the bodies.
     *
     * @return sum over all
     */
    public double storedEnergy() {
        return original.generators.storedEnergy();
    }

    /**
     * Takes note which motors and stops of a group act from its anchors on.
     *
     * @param group driven bodies
     */
    public void decided(IntList group) {
        int first = group.values[0];
        if (decided.length <= first) {
            decided = Arrays.copyOf(decided, 2 * first + 8);
        }
        double[] kept = decided[first] == null ? new double[0] : decided[first];
        decided[first] = original.ties.switches(group, kept, false);
    }

    /**
     * Goes from a group's anchors to an instant at which the state vectors have it.
     *
     * @param those driven bodies
     * @param from offset of the anchors
     * @param to offset of where they are
     * @return false if the way could not be gone; then there is no result
     */
    public boolean cover(IntList those, double from, double to) {
        prepare();
        keep(those);
        boolean isSwitched = original.isTiedGroup(those) && original.ties.isSwitched(those);
        if (isSwitched) {
            switches = original.ties.switches(those, switches, false);
            startSwitches = those.values[0] < decided.length ? decided[those.values[0]] : null;
        }
        try {
            if (isSwitched && startSwitches != null) {
                original.ties.switches(those, startSwitches, true);
            }
            go(those, from, to, isSwitched);
            return true;
        } catch (IllegalStateException | ArithmeticException e) {
            return false; // the forces are not smooth enough for a method of this order
        } finally {
            restore(those);
            if (isSwitched) {
                original.ties.switches(those, switches, true);
            }
        }
    }

    private void go(IntList those, double from, double to, boolean isSwitched) {
        GroupPaths.restore(trajectories, state, those);
        IntList group = twin.companions(those.values[0]);
        if (isSwitched) {
            ties.confirm(group, false);
        }
        budget = PANELS;
        work = panel(group, from, to, isSwitched, 0);
        compare(those);
    }

    /**
     * Goes a part of the way; returns the work. Energy tells when the quadrature has missed something sudden, a motor that
     * begins to yield for instance: then the part is gone once more in halves.
     */
    private double panel(IntList group, double from, double to, boolean isSwitched, int depth) {
        budget--;
        double[] start = copy(group, null);
        double[] switched = isSwitched ? ties.switches(group, new double[0], false) : null;
        double before = energy(group);
        double stored = original.generators.storedEnergy(state, group);
        double sum = 0;
        double scale = 0;
        double last = from;
        for (int k = 0; k < NODE.length; k++) {
            double at = k + 1 < NODE.length ? from + NODE[k] * (to - from) : to;
            if (at != last) {
                twin.cover(group, original.time, last, at);
            }
            last = at;
            double power = power(group, original.time + at);
            sum += WEIGHT[k] * power;
            scale = Math.max(scale, Math.abs(power * (to - from)));
        }
        double change = original.generators.storedEnergy(state, group) - stored;
        double after = energy(group);
        double missed = Math.abs(after - before - sum * (to - from));
        if (missed <= missing * (scale + Math.abs(before) + Math.abs(after)) || depth == DEEPEST || budget < 0) {
            return sum * (to - from) + change;
        }
        copy(group, start);
        if (isSwitched) {
            ties.switches(group, switched, true);
            ties.confirm(group, false);
        }
        double middle = from + 0.5 * (to - from);
        double first = panel(group, from, middle, isSwitched, depth + 1);
        return first + panel(group, middle, to, isSwitched, depth + 1);
    }

    /** Energy of motion and in uniform fields. */
    private double energy(IntList group) {
        double sum = 0;
        for (int k = 0; k < group.size; k++) {
            int b = State.BLOCK * group.values[k];
            for (int c = b; c < b + State.BLOCK; c++) {
                sum += 0.5 * state.v()[c] * state.v()[c] / state.w().values()[c];
            }
            sum += fieldEnergy(group.values[k], state.x()[b], state.x()[b + 1]);
        }
        return sum;
    }

    /** Copies positions and velocities; or puts them back. */
    private double[] copy(IntList group, double[] kept) {
        double[] values = kept == null ? new double[2 * State.BLOCK * group.size] : kept;
        for (int k = 0; k < group.size; k++) {
            int b = State.BLOCK * group.values[k];
            int at = 2 * State.BLOCK * k;
            if (kept == null) {
                System.arraycopy(state.x(), b, values, at, State.BLOCK);
                System.arraycopy(state.v(), b, values, at + State.BLOCK, State.BLOCK);
            } else {
                System.arraycopy(values, at, state.x(), b, State.BLOCK);
                System.arraycopy(values, at + State.BLOCK, state.v(), b, State.BLOCK);
            }
        }
        return values;
    }

    private double power(IntList group, double t) {
        twin.acceleration(group, t, a); // tells motors that are on from those that are overloaded
        boolean pushes = twin.fields() == null;
        if (pushes) {
            original.generators.accelerate(state, group, t, twin.forces, free);
        } else {
            original.generators.fall(group, free);
        }
        boolean isTied = twin.isTiedGroup(group) || twin.support.pushesDriven;
        double sum = 0;
        for (int k = 0; k < group.size; k++) {
            int b = State.BLOCK * group.values[k];
            for (int end = b + State.BLOCK; b < end; b++) {
                sum += pushes ? state.f()[b] * state.v()[b] : 0;
                sum += isTied ? (a[b] - free[b]) / state.w().values()[b] * state.v()[b] : 0;
            }
        }
        return sum;
    }

    /**
     * How far the bodies are off. What is read from a stride that goes on is not added up: of all that its steps miss, signs
     * and all, only what is more than before counts.
     */
    private void compare(IntList those) {
        boolean goesOn = original.drivenMotion.goesOn(those);
        place = 0;
        angle = 0;
        for (int k = 0; k < those.size; k++) {
            int b = State.BLOCK * those.values[k];
            for (int c = b; c < b + State.BLOCK; c++) {
                missed[c] = state.x()[c] - x[c] + (goesOn ? missed[c] : 0);
            }
            place = Math.max(place, Math.sqrt(missed[b] * missed[b] + missed[b + 1] * missed[b + 1]));
            angle = Math.max(angle, Math.abs(missed[b + State.THETA]));
        }
        int o = 2 * those.values[0];
        double placed = goesOn ? most[o] : 0;
        double turned = goesOn ? most[o + 1] : 0;
        most[o] = Math.max(placed, place);
        most[o + 1] = Math.max(turned, angle);
        place = most[o] - placed;
        angle = most[o + 1] - turned;
    }

    private void prepare() {
        int n = state.x().length;
        if (x.length < n) {
            x = new double[n];
            v = new double[n];
            f = new double[n];
            a = new double[n];
            missed = Arrays.copyOf(missed, n);
            most = Arrays.copyOf(most, 2 * (n / State.BLOCK));
            free = new double[n];
        }
        if (audited != original.getIntegrator()) {
            audited = original.getIntegrator();
            double size = size();
            double tolerance = audited instanceof AdaptiveIntegrator method
                    ? Math.max(FINER * method.getTolerance(), FINEST * size)
                    : FINE * size;
            missing = Math.max(MISSING, COARSE * tolerance / size);
            twin.setIntegrator(new Automatic(tolerance));
        }
        Ties now = original.ties;
        if (now == null ? ties != null : ties == null || version != now.version()) {
            ties = now == null ? null : now.twin();
            version = now == null ? 0 : now.version();
            twin.setTies(ties);
        }
    }

    private double size() {
        double size = 0;
        for (int k = 0; k < state.size(); k++) {
            Body body = state.body(k);
            if (body != null && !body.isImmobile()) {
                double reach = body.getShape().boundingRadius();
                size = Math.max(size, Math.max(reach, Math.max(Math.abs(body.getX()), Math.abs(body.getY()))));
            }
        }
        return size;
    }

    private void keep(IntList those) {
        for (int k = 0; k < those.size; k++) {
            int b = State.BLOCK * those.values[k];
            System.arraycopy(state.x(), b, x, b, State.BLOCK);
            System.arraycopy(state.v(), b, v, b, State.BLOCK);
            System.arraycopy(state.f(), b, f, b, State.BLOCK);
        }
    }

    private void restore(IntList those) {
        for (int k = 0; k < those.size; k++) {
            int b = State.BLOCK * those.values[k];
            System.arraycopy(x, b, state.x(), b, State.BLOCK);
            System.arraycopy(v, b, state.v(), b, State.BLOCK);
            System.arraycopy(f, b, state.f(), b, State.BLOCK);
        }
    }
}
