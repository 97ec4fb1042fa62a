// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * Steps of integrators that choose them, which go on beyond the engine's: where the engine's ends, and where an impact is
 * looked for, is read from the method's dense output. So neither cost nor error depend on the engine's step.
 *
 * <p>A stride is made only where the forces depend on nothing but the state ({@link ForceGenerator#isAutonomous}), and it is
 * given up as soon as something is written or happens: a body of the group is admitted anew, struck or pushed, a fixed one is
 * moved, forces or joints change, or the group is not, to the bit, where it was left on it. Then a new one begins from
 * there. What others are near follows strides within the engine's step.
 *
 * <p>What is read is brought onto the joints, unless the stride is one in coordinates that keep them; the stride itself goes
 * on as it was.
 */
final class Strides implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Steps of the engine for which a stride may last. */
    private static final double LONGEST = 1024;

    /** How much shorter a stride is to be whose dense output was not accurate enough. */
    private static final double SHORTER = 0.7;

    /** And how much longer than one that was the next may be. */
    private static final double LONGER = 1.1;

    private static final int NOBODY = -1;

    private final Motion motion;
    private final State state;
    private final Trajectories trajectories;
    private final Path path;

    /** By first body of a group; and that of each body. */
    private Stride[] strides = {};

    private int[] firsts = {};

    Strides(Motion motion, State state, Trajectories trajectories, Path path) {
        this.motion = motion;
        this.state = state;
        this.trajectories = trajectories;
        this.path = path;
    }

    /** Whether steps are chosen by what the motion of a group asks for: nobody follows one that creeps. */
    boolean follows(IntList group) {
        return motion.getIntegrator().isAdaptive() && !(motion.isTiedGroup(group) && motion.ties.halvings(group, 0, false) < 0);
    }

    /** Whether a group may move in strides that go on beyond the engine's step. */
    private boolean mayGoBeyond(IntList group) {
        if (!(motion.getIntegrator() instanceof AdaptiveIntegrator)) {
            return false;
        }
        for (int k = 0; k < group.size; k++) {
            int body = group.values[k];
            if (state.body(body).isPushed() || motion.support.pushes(body)) {
                return false;
            }
        }
        return motion.ground().surfaceUnder(group) == null
                && motion.generators.areAutonomous(state, group)
                && (!motion.isTiedGroup(group) || motion.ties.isAutonomous(group));
    }

    /**
     * Advances a group from its anchors over what is left of the engine's step, or to the end of its stride.
     *
     * @param tied advances those that are tied; may be null if none is
     * @return how far; 0 if it must be done otherwise
     */
    double advance(IntList group, double tau, double rest, TiedMotion tied) {
        if (!mayGoBeyond(group)) {
            cut(group.values[0]);
            return 0;
        }
        GroupPaths.restore(trajectories, state, group);
        Stride stride = at(group.values[0]);
        double from = stride.time(trajectories, tau);
        if (!stride.isFollowed(motion.getIntegrator(), state, group, trajectories, from) || stride.isOver(from)) {
            double length = begin(stride, group, tau, rest, tied);
            if (length <= rest) {
                return length;
            }
            GroupPaths.restore(trajectories, state, group);
            from = 0;
        }
        double length = stride.has(from + rest) ? rest : stride.dense.length - from;
        return read(stride, group, from, length, tied) ? length : 0;
    }

    /** Makes a stride; the path is set if it does not go beyond the engine's step. Returns its length, 0 if there is none. */
    private double begin(Stride stride, IntList group, double tau, double rest, TiedMotion tied) {
        stride.isLive = false;
        AdaptiveIntegrator method = (AdaptiveIntegrator) motion.getIntegrator();
        int first = group.values[0];
        double wanted = wanted(stride, method, first);
        if (wanted == 0) {
            return 0;
        }
        path.knowsFirst = false;
        double t = motion.time(tau);
        double length = motion.isTiedGroup(group)
                ? tied.goOn(motion, method, group, t, wanted, path)
                : method.goOn(motion, state, group, t, wanted, path);
        stride.wanted = path.proposed[first];
        if (length <= rest) {
            return length;
        }
        if (!method.makeDense(motion, state, group, t, length, path, stride.dense)) {
            stride.longest = SHORTER * length;
            return 0;
        }
        stride.longest = Math.max(stride.longest, LONGER * length);
        stride.begin(method, state, group, trajectories, tau, path.stages.isTied());
        for (int k = 0; k < group.size; k++) {
            firsts[group.values[k]] = first;
        }
        return length;
    }

    /** How long a stride should be; 0 if it would be too short to pay. */
    private double wanted(Stride stride, AdaptiveIntegrator method, int first) {
        path.ensure(state.x().length);
        double h = trajectories.h();
        double least = method.worthwhile() * h;
        boolean isKnown = stride.wanted > 0 && !method.hasFixedOrder();
        double wanted = Math.min(isKnown ? stride.wanted : path.proposed[first], stride.longest);
        if (wanted >= (isKnown || method.hasFixedOrder() ? least : h)) {
            return Math.min(wanted, LONGEST * h);
        }
        stride.wanted = later(stride.wanted, least);
        stride.longest = later(stride.longest, least);
        return 0;
    }

    /** What was too short is tried again some time. */
    private static double later(double length, double least) {
        return length < least ? LONGER * length : length;
    }

    /** Brings a group from its anchors, where the state vectors have it, to an instant; false if it is on no stride then. */
    boolean bring(IntList group, double tau, TiedMotion tied) {
        int first = group.values[0];
        if (first >= strides.length || strides[first] == null || !strides[first].isLive) {
            return false;
        }
        Stride stride = strides[first];
        double from = stride.time(trajectories, trajectories.offset(first));
        double to = stride.time(trajectories, tau);
        return stride.isFollowed(motion.getIntegrator(), state, group, trajectories, from)
                && stride.has(to)
                && read(stride, group, from, to - from, tied);
    }

    /** Puts a group where its stride has it, and sets its path from where the state vectors have it to there. */
    private boolean read(Stride stride, IntList group, double from, double length, TiedMotion tied) {
        path.ensure(state.x().length);
        stride.enter(state, group, from);
        path.start(state, group);
        boolean isThere = stride.isInTiedCoordinates
                ? readTied(stride, group, from, length, tied.coordinates(motion, group, path))
                : readBodies(stride, group, from, length);
        if (!isThere) {
            stride.isLive = false;
            GroupPaths.restore(trajectories, state, group);
            return false;
        }
        path.join(state, group, length);
        path.knowsFirst = true;
        stride.isUnderWay = from > 0;
        stride.leave(state, group, from + length);
        return true;
    }

    private boolean readBodies(Stride stride, IntList group, double from, double length) {
        boolean isTied = motion.isTiedGroup(group);
        if (isTied) {
            motion.ties.begin(group, !motion.hasForces());
        }
        stride.put(state, group, from + length);
        stride.dense.accelerations(group, from / stride.dense.length, path.first);
        return !isTied || stride.isOver(from + length) || motion.ties.project(group);
    }

    /** Where the coordinates of ties say: there is nothing to bring onto them. */
    private boolean readTied(Stride stride, IntList group, double from, double length, TiedCoordinates coordinates) {
        if (coordinates == null) {
            return false;
        }
        Stages s = path.stages;
        s.ensure(group);
        DenseOutput dense = stride.dense;
        dense.at(from / dense.length, s.x, s.v);
        dense.slopes(from / dense.length, s.a);
        coordinates.accelerations(s.x, s.v, s.a, path.first);
        double to = from + length;
        if (stride.isOver(to)) {
            stride.put(state, group, to);
        } else {
            dense.at(to / dense.length, s.x, s.v);
            coordinates.put(s.x, s.v);
            coordinates.end();
        }
        return true;
    }

    /** Whether a group was last read from a stride that had begun before. */
    boolean goesOn(int first) {
        return first < strides.length && strides[first] != null && strides[first].isLive && strides[first].isUnderWay;
    }

    private Stride at(int first) {
        if (strides.length <= first) {
            int room = Math.max(first + 1, state.size());
            strides = Arrays.copyOf(strides, room);
        }
        if (firsts.length < state.size()) {
            int had = firsts.length;
            firsts = Arrays.copyOf(firsts, state.size());
            Arrays.fill(firsts, had, firsts.length, NOBODY);
        }
        strides[first] = strides[first] == null ? new Stride() : strides[first];
        return strides[first];
    }

    /** Something has happened to a body: its stride is over. That of a fixed one may bear on any other. */
    void cut(int body) {
        if (body < firsts.length && firsts[body] != NOBODY) {
            strides[firsts[body]].isLive = false;
        }
        if (firsts.length > 0 && (state.body(body) == null || state.body(body).isImmobile())) {
            cutAll();
        }
    }

    private void cutAll() {
        for (Stride stride : strides) {
            if (stride != null) {
                stride.isLive = false;
            }
        }
    }
}
