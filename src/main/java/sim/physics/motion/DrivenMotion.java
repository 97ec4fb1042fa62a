// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.internal.Team;

/**
 * Moves bodies that the integrator drives from their anchors on, sets their paths, and brings them to instants between.
 *
 * <p>An integrator of fixed step makes one path of what is left of the engine's step. One that chooses its steps itself
 * makes a path of each of its own, up to the end of the engine's.
 */
final class DrivenMotion implements Serializable {
    private static final long serialVersionUID = 1L;

    /** How far the path of a body that others are near may be from its motion, relative to its size. */
    private static final double FINE = 1e-7;

    /** The path's error is of fourth order in its length; this much less than allowed is aimed at. */
    private static final double SAFE = 0.5;

    private static final double GROWTH = 4;

    private final Motion motion;
    private final State state;
    private final Trajectories trajectories;
    private final Path path;
    private final Sliding sliding;

    /** Null while nothing ties bodies together. */
    private TiedMotion tied;

    /** Where the driven bodies are at the end of their paths, 3n each. */
    private double[] endX = {};

    private double[] endV = {};

    /** Offset at which a body's path ends; NaN if its course has changed. */
    private double[] endAt = {};

    /** Lengths of paths that are near enough to the motion, by the first body of a group; 0: not known. */
    private double[] fineLength = {};

    /** The step that the integrator makes of itself, at most that of the engine, by body. */
    private double[] pace = {};

    private boolean isCoarse;

    /** Up to which offset threads have advanced groups in this step, by their first bodies; 0 if they have not. */
    private double[] sharedEnd = {};

    private boolean isShared;

    /** What integrating a group there has thrown, if one has, and its first body. */
    private transient Throwable failure;

    private int failed;

    DrivenMotion(Motion motion, State state, Trajectories trajectories, Path path) {
        this.path = path;
        this.motion = motion;
        this.state = state;
        this.trajectories = trajectories;
        this.sliding = new Sliding(motion, state, trajectories, path);
    }

    void setTies(Ties ties) {
        tied = ties == null ? null : new TiedMotion(state, trajectories, ties);
    }

    /** Whether the last paths may be too far from the motion for bodies that others are near. */
    boolean isCoarse() {
        return isCoarse;
    }

    Path path() {
        return path;
    }

    /** Shares the workspace of another one; now or never it has room for all bodies. */
    void match(DrivenMotion first, Ties ties, Ties firstTies) {
        first.ensure();
        path.ensure(state.x().length);
        if (tied != null) {
            ties.match(firstTies);
            tied.match(first.tied);
        }
    }

    /** Makes room for what other threads find. */
    void expectShared() {
        ensure();
        if (sharedEnd.length < endAt.length) {
            sharedEnd = new double[endAt.length];
        }
        isShared = true;
    }

    /** Takes note that integrating a group has thrown something, which is thrown when it is the group's turn. */
    void setFailure(int first, Throwable thrown) {
        sharedEnd[first] = 0;
        failed = first;
        failure = thrown;
    }

    /** Integrates a group from its anchors by another one's means. */
    void advanceShared(IntList group, DrivenMotion means) {
        double tau = trajectories.offset(group.values[0]);
        double rest = trajectories.h() - tau;
        double length = means.stride(group, tau, rest);
        for (int k = 0; k < group.size; k++) {
            pace[group.values[k]] = trajectories.h();
        }
        sharedEnd[group.values[0]] = publish(group, tau, length == rest ? trajectories.h() : tau + length);
    }

    /** Takes back what a thread has done to a group. */
    void undoShared(IntList group) {
        sharedEnd[group.values[0]] = 0;
        restore(group);
        for (int k = 0; k < group.size; k++) {
            trajectories.anchor(group.values[k], 0, state);
        }
    }

    /** Forgets what other threads have found, at the start of a step. */
    void forgetShared() {
        if (isShared) {
            Arrays.fill(sharedEnd, 0); // the last step was not finished
        }
        failure = null;
        isShared = false;
    }

    /** Takes note that all that other threads have found has been made use of. */
    void endShared() {
        isShared = false;
    }

    /** Advances a group; returns the offset up to which its paths hold. */
    double advance(IntList group, boolean fine) {
        int first = group.values[0];
        if (isShared && sharedEnd[first] > 0) {
            double end = sharedEnd[first];
            sharedEnd[first] = 0;
            isCoarse = false;
            return end;
        }
        if (failure != null && failed == first) {
            Team.rethrow(failure);
        }
        ensure();
        double tau = trajectories.offset(first);
        double rest = trajectories.h() - tau;
        boolean chooses = motion.getIntegrator().isAdaptive();
        double known = fine && chooses ? fineLength[first] : 0;
        double length = stride(group, tau, known > 0 ? Math.min(known, rest) : rest);
        isCoarse = false;
        if (chooses) {
            double error = pathError(group, length);
            while (fine && error > 1) {
                length = stride(group, tau, length * root(error));
                error = pathError(group, length);
            }
            fineLength[first] = length * root(error);
            isCoarse = error > 1;
        }
        double step = chooses ? Math.min(trajectories.h(), Math.max(length, path.next[first])) : trajectories.h();
        for (int k = 0; k < group.size; k++) {
            pace[group.values[k]] = step;
        }
        return publish(group, tau, length == rest ? trajectories.h() : tau + length);
    }

    /** The step that the integrator makes of itself with a body, at most that of the engine. */
    double pace(int body) {
        return pace[body];
    }

    private static double root(double error) {
        double fourth = SAFE / Math.max(error, 1e-6);
        return Math.min(GROWTH, Math.sqrt(Math.sqrt(fourth)));
    }

    /** Integrates a group from its anchors; returns how far. */
    private double stride(IntList group, double tau, double limit) {
        restore(group);
        double t = motion.time(tau);
        if (motion.isTiedGroup(group)) {
            return tied.advanceUntilSwitch(motion, group, t, tau, limit, path);
        }
        SurfaceFriction surface = motion.surfaceUnder(group);
        if (surface != null && limit > 0) {
            return sliding.advance(state.body(group.values[0]), surface, group, t, limit);
        }
        return motion.getIntegrator().advance(motion, state, group, t, limit, path);
    }

    /**
     * How far the cubic paths may be from the motion, in units of what is near enough: a motion whose fourth derivative is
     * constant is off by c s²(h − s)², so its second derivative at the start by 2 c h².
     */
    private double pathError(IntList group, double length) {
        double[] m = trajectories.data();
        double most = 0;
        for (int k = 0; k < group.size; k++) {
            int b = State.BLOCK * group.values[k];
            double radius = m[Trajectories.STRIDE * group.values[k] + Trajectories.RADIUS];
            double way = Math.abs(path.first[b] - 2 * path.a[b]) + Math.abs(path.first[b + 1] - 2 * path.a[b + 1]);
            double turn = Math.abs(path.first[b + 2] - 2 * path.a[b + 2]);
            most = Math.max(most, Math.max(way / radius, turn));
        }
        return most * length * length / (32 * FINE);
    }

    private double publish(IntList group, double tau, double end) {
        double[] m = trajectories.data();
        for (int k = 0; k < group.size; k++) {
            int o = Trajectories.STRIDE * group.values[k];
            int b = State.BLOCK * group.values[k];
            copy(path.a, b, m, o + Trajectories.AX);
            copy(path.j, b, m, o + Trajectories.JX);
            copy(state.x(), b, endX, b);
            copy(state.v(), b, endV, b);
            endAt[group.values[k]] = end;
        }
        return end;
    }

    /** Brings a group to an instant. */
    void bring(IntList group, double tau) {
        int first = group.values[0];
        if (endAt[first] == tau) {
            for (int k = 0; k < group.size; k++) {
                finish(group.values[k]);
            }
        } else {
            restore(group);
            cover(group, trajectories.offset(first), tau);
        }
        for (int k = 0; k < group.size; k++) {
            trajectories.anchor(group.values[k], tau, state);
            endAt[group.values[k]] = Double.NaN;
        }
    }

    /** Integrates a group from one offset to another, which may be an earlier one. */
    private void cover(IntList group, double from, double to) {
        double t = motion.time(from);
        double length = to - from;
        SurfaceFriction surface = motion.surfaceUnder(group);
        if (motion.isTiedGroup(group)) {
            tied.advance(motion, group, t, length, path);
        } else if (surface != null && length > 0) {
            sliding.advance(state.body(group.values[0]), surface, group, t, length);
        } else {
            cover(motion, state, group, t, length, path);
        }
    }

    /** Integrates a group over a time, in as many strides as the integrator takes. */
    static void cover(Motion motion, State state, IntList group, double t, double length, Path path) {
        double done = 0;
        do {
            double left = length - done;
            double stride = motion.getIntegrator().advance(motion, state, group, t + done, left, path);
            done = stride == left ? length : done + stride;
        } while (done != length);
    }

    /** Puts the anchors of bodies back into the state vectors. */
    void restore(IntList group) {
        double[] m = trajectories.data();
        for (int k = 0; k < group.size; k++) {
            int o = Trajectories.STRIDE * group.values[k];
            int b = State.BLOCK * group.values[k];
            copy(m, o, state.x(), b);
            copy(m, o + Trajectories.VX, state.v(), b);
        }
    }

    /** Copies a block; a call of the system's takes longer. */
    private static void copy(double[] from, int at, double[] to, int where) {
        to[where] = from[at];
        to[where + 1] = from[at + 1];
        to[where + 2] = from[at + 2];
    }

    /** Writes where a body's path ends into the state vectors. */
    void finish(int body) {
        int b = State.BLOCK * body;
        copy(endX, b, state.x(), b);
        copy(endV, b, state.v(), b);
    }

    /** Takes note that a body's course has changed at its anchor. */
    void forget(int body) {
        if (body < endAt.length) {
            endAt[body] = Double.NaN;
        }
    }

    private void ensure() {
        int n = state.x().length;
        if (endX.length < n) {
            endX = Arrays.copyOf(endX, n);
            endV = Arrays.copyOf(endV, n);
            int bodies = endAt.length;
            endAt = Arrays.copyOf(endAt, n / State.BLOCK);
            Arrays.fill(endAt, bodies, endAt.length, Double.NaN);
            fineLength = Arrays.copyOf(fineLength, n / State.BLOCK);
            pace = Arrays.copyOf(pace, n / State.BLOCK);
        }
    }
}
