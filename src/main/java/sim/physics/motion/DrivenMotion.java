// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * Moves bodies that the integrator drives from their anchors on, sets their paths, and brings them to instants between.
 *
 * <p>An integrator of fixed step makes one path of what is left of the engine's step. One that chooses its steps itself
 * makes a path of each of its own, up to the end of the engine's, or of what of it lies in that ({@link Strides}).
 */
final class DrivenMotion implements Serializable {
    private static final long serialVersionUID = 1L;

    /** How far the path of a body that others are near may be from its motion, relative to its size. */
    private static final double FINE = 1e-7;

    /** The same with steps of fixed length, where the instant of an impact is corrected by the motion itself. */
    private static final double COARSE = 1e-6;

    /** Part of such a step that is not divided. */
    private static final double LEAST = 1.0 / 64;

    private final Motion motion;
    private final State state;
    private final Trajectories trajectories;
    private final Path path = new Path();
    private final PathError pathError;
    private final Sliding sliding;
    private final Strides strides;

    /** The last probe, where it may be what is to be done. */
    final Probe probed = new Probe();

    /** Null while nothing ties bodies together. */
    private TiedMotion tied;

    /** Null unless somebody audits the engine. */
    private CourseObserver observer;

    /** Where the driven bodies are at the end of their paths, 3n each. */
    private double[] endX = {};

    private double[] endV = {};

    /** Offset at which a body's path ends; NaN if its course has changed. */
    private double[] endAt = {};

    /** Lengths of paths that are near enough to the motion, by the first body of a group; 0: not known. */
    private double[] fineLength = {};

    /** The step that the integrator makes of itself, at most that of the engine, by body. */
    private double[] pace = {};

    private final Strikes strikes = new Strikes();

    /** Which bodies stand still. */
    final Repose repose = new Repose();

    private boolean isCoarse;

    /** Whether the arrays above hold the ends; if not, the state vectors still do. */
    private boolean areEndsKept;

    /** What threads have done before it was the groups' turn; null unless they have in this step. */
    private transient Ahead ahead;

    DrivenMotion(Motion motion, State state, Trajectories trajectories) {
        this.motion = motion;
        this.state = state;
        this.trajectories = trajectories;
        this.pathError = new PathError(trajectories, path);
        this.sliding = new Sliding(motion, state, path);
        this.strides = new Strides(motion, state, trajectories, path);
    }

    void setTies(Ties ties) {
        tied = ties == null ? null : new TiedMotion(state, trajectories, ties);
        setObserver(observer);
    }

    boolean isObserved() {
        return observer != null;
    }

    void setObserver(CourseObserver who) {
        observer = who;
        if (tied != null) {
            tied.setObserver(who);
        }
    }

    /** Whether the last paths may be too far from the motion for bodies that others are near. */
    boolean isCoarse() {
        return isCoarse;
    }

    /**
     * Advances a group.
     *
     * @param group the bodies
     * @param neighbours asked whether others are near only if it matters; null if they are, and this is done again for that
     * @return the offset up to which its paths hold
     */
    double advance(IntList group, Neighbours neighbours) {
        ensure();
        int first = group.values[0];
        int done = motion.late().takeRefused(first) ? Ahead.REFUSAL : ahead == null ? Ahead.NOTHING : ahead.take(first, motion.work);
        if ((done == Ahead.NOTHING || done == Ahead.REFUSAL) && (repose.hasAll(group) || motion.ground().stops(group))) {
            return stay(group); // else a thread has asked that, and the vectors hold where it has moved the bodies
        }
        if (done == Ahead.REFUSAL) {
            tied.setRefused(true);
        } else if (done != Ahead.NOTHING && (!ahead.isCoarse(first) || !areNear(group, neighbours))) {
            fineLength[first] = done == Ahead.STRIDE ? ahead.fineLength(first) : fineLength[first];
            isCoarse = ahead.isCoarse(first);
            return ahead.length(first);
        }
        boolean isProbed = done == Ahead.NOTHING && probed.take(group, state);
        if (done == Ahead.NOTHING && !isProbed && tied != null && leaps(group, first, neighbours)) {
            return trajectories.h();
        }
        return lay(group, done == Ahead.STRIDE, isProbed, neighbours);
    }

    /** Lays a path for a group from its anchors on, which may be made ahead, or probed; and shorter ones while it is too far from the motion and others are near. */
    private double lay(IntList group, boolean isAhead, boolean isProbed, Neighbours neighbours) {
        int first = group.values[0];
        double tau = trajectories.offset(first);
        double rest = trajectories.h() - tau;
        double known = motion.getIntegrator().isAdaptive() && !strides.follows(group) ? 0 : fineLength[first];
        path.knowsFirst = isProbed ? probed.knowsFirst() : path.knowsFirst;
        boolean isKnown = !isProbed && known > 0 && known < rest && !isAhead && areNear(group, neighbours);
        double length = isAhead ? ahead.length(first) : isProbed ? rest : isKnown ? stride(group, tau, known) : goOn(group, tau, rest);
        double error = isAhead ? ahead.error(first) : pathError(group, length);
        double shortest = strides.follows(group) ? 0 : LEAST * trajectories.h();
        while (error > 1 && length > shortest && areNear(group, neighbours)) {
            length = stride(group, tau, length * PathError.root(error));
            error = pathError(group, length);
        }
        double fine = Math.max(length * PathError.root(error), error > 1 ? shortest : 0);
        boolean isCut = isKnown && length < known && error <= 1; // the path says nothing against longer ones
        fineLength[first] = isCut ? Math.max(known, fine) : fine;
        isCoarse = error > 1;
        double step = shortest == 0 ? Math.min(trajectories.h(), Math.max(length, path.next[first])) : trajectories.h();
        GroupPaths.set(pace, group, step);
        return publish(group, length == rest ? trajectories.h() : tau + length);
    }

    /** Lets a group stay where it is, which rests. */
    private double stay(IntList group) {
        restore(group);
        repose.stay(group, state, path);
        GroupPaths.set(pace, group, trajectories.h());
        isCoarse = false;
        return publish(group, trajectories.h());
    }

    /** Shares the arrays of another one, which has room for all bodies then, to do what it would do with other groups. */
    void match(DrivenMotion other, Ties ties, Ties otherTies) {
        other.ensure();
        other.path.ensure(state.x().length);
        path.match(other.path);
        endX = other.endX;
        endV = other.endV;
        endAt = other.endAt;
        fineLength = other.fineLength;
        pace = other.pace;
        strikes.match(other.strikes);
        repose.match(other.repose);
        areEndsKept = other.areEndsKept;
        if (tied != null) {
            ties.match(otherTies);
            tied.match(other.tied);
        }
    }

    /** Whether the first stride of a group's step is the same whether the path is to be fine or not. */
    boolean hasOneBeginning(int first) {
        return first >= fineLength.length || !(fineLength[first] > 0 && fineLength[first] < trajectories.h());
    }

    /** Does what {@link #advance} does first with a group at the start of a step, in whatever thread; it may be known to have no quick way. */
    void advanceAhead(IntList group, boolean isRefused, Ahead notes) {
        int first = group.values[0];
        double h = trajectories.h();
        if (repose.hasAll(group) || motion.ground().stops(group)) {
            return;
        }
        if (tied != null && !isRefused && leaps(group, first, Neighbours.NONE)) {
            notes.leap(first, h, isCoarse);
            return;
        }
        if (!hasOneBeginning(first)) {
            if (tied != null && tied.isRefused()) {
                notes.refuse(first);
                tied.setRefused(false);
            }
            return;
        }
        double length = stride(group, 0, h);
        double error = pathError(group, length);
        GroupPaths.set(pace, group, h);
        notes.stride(first, publish(group, length), error, length * PathError.root(error));
    }

    /** Takes note of what threads have done with groups in this step. */
    void setAhead(Ahead notes) {
        ahead = notes;
    }

    /** Whether nothing but making use of it is left to do with a group, be bodies near or not. */
    boolean isDone(int first) {
        return ahead != null && ahead.isFine(first);
    }

    /** Puts a group back to its anchors, at the start of a step, as if no thread had come to it. */
    void undo(IntList group) {
        restore(group);
        for (int k = 0; k < group.size; k++) {
            trajectories.anchor(group.values[k], 0, state);
            endAt[group.values[k]] = Double.NaN;
        }
    }

    /** Integrates a group from its anchors into the state vectors; returns how far. */
    double probe(IntList group, double length) {
        double done = stride(group, trajectories.offset(group.values[0]), length);
        probed.note(group, state, done, path.knowsFirst);
        return done;
    }

    private static boolean areNear(IntList group, Neighbours neighbours) {
        return neighbours == null || neighbours.hasNeighbours(group);
    }

    /** Makes the whole step of a group at once, from the state vectors, if nothing has happened in it so far. */
    private boolean leaps(IntList group, int first, Neighbours neighbours) {
        double h = trajectories.h();
        boolean isFresh = !areEndsKept && trajectories.offset(first) == 0 && motion.isTiedGroup(group);
        if (neighbours == null && isFresh) {
            restore(group); // the vectors may hold the ends of paths that were not fine enough
        }
        path.knowsFirst = false;
        if (!isFresh || !tied.leap(motion, group, motion.time(0), h, path)) {
            return false;
        }
        double fastest = GroupPaths.lead(trajectories, group, 1 / h, state);
        GroupPaths.set(endAt, group, h);
        GroupPaths.set(pace, group, h);
        isCoarse = path.knowsFirst ? pathError.of(group, trajectories.bends(), Trajectories.STRIDE, h, near(group)) > 1 : turnsCoarsely(group, h * fastest);
        return !isCoarse || !areNear(group, neighbours);
    }

    /** Makes the whole step of a group at once, at its start, without a path; false if there is no quick way. */
    boolean leapsBlindly(IntList group) {
        path.knowsFirst = false;
        return tied.leap(motion, group, motion.time(0), trajectories.h(), path);
    }

    /** Gives a group that has done so the path from its anchors to where the state vectors have it. */
    void lead(IntList group) {
        ensure();
        double h = trajectories.h();
        GroupPaths.lead(trajectories, group, 1 / h, state);
        GroupPaths.set(endAt, group, h);
        GroupPaths.set(pace, group, h);
    }

    /** The step that the integrator makes of itself with a body, at most that of the engine. */
    double pace(int body) {
        return pace[body];
    }

    /** Advances a group from its anchors on the stride that it is on, or on a new one; returns how far. */
    private double goOn(IntList group, double tau, double rest) {
        boolean isRigid = tied != null && tied.isRigid(motion, group);
        boolean mayGoBeyond = motion.getIntegrator().isAdaptive() && !isRigid && !isStruck(group);
        double length = mayGoBeyond ? strides.advance(group, tau, rest, tied) : 0;
        return length > 0 ? length : stride(group, tau, rest);
    }

    /** Whether something has happened to a group in this step, which may well happen again in the next one, or acts in it alone. */
    private boolean isStruck(IntList group) {
        boolean yes = false;
        for (int k = 0; k < group.size; k++) {
            int body = group.values[k];
            yes |= strikes.has(body, trajectories.step()) || state.isPushed(body);
        }
        return yes;
    }

    /** Integrates a group from its anchors; returns how far. */
    private double stride(IntList group, double tau, double limit) {
        strides.cut(group.values[0]);
        probed.cut(group.values[0]);
        restore(group);
        path.knowsFirst = false;
        double t = motion.time(tau);
        if (motion.isTiedGroup(group)) {
            return tied.advanceUntilSwitch(motion, group, t, tau, limit, path);
        }
        SurfaceFriction surface = motion.ground().surfaceUnder(group);
        if (surface != null && limit > 0) {
            return sliding.advance(state.body(group.values[0]), surface, group, t, limit, isPressed(group));
        }
        return RungeKutta4.stays(motion, state, group, t, path) ? limit : motion.getIntegrator().advance(motion, state, group, t, limit, path);
    }

    private double pathError(IntList group, double length) {
        return pathError.of(group, length, near(group));
    }

    /** Whether the paths are too far from the motion by how far the fastest body turns. */
    private boolean turnsCoarsely(IntList group, double turn) {
        double fourth = turn * turn * turn * turn;
        return fourth > 384 * FINE && fourth / (384 * near(group)) > 1;
    }

    /** How far from the motion is near enough. */
    private double near(IntList group) {
        return isPressed(group) || motion.getIntegrator().isAdaptive() ? FINE : COARSE;
    }

    /** Whether contacts push a body of the group, or have struck it often of late: then it is pressed against something. */
    private boolean isPressed(IntList group) {
        boolean yes = false;
        for (int k = 0; k < group.size; k++) {
            int body = group.values[k];
            yes |= motion.support.pushes(body);
            yes |= strikes.areOften(body, trajectories.step());
        }
        return yes;
    }

    private double publish(IntList group, double end) {
        double[] bends = trajectories.unfold();
        for (int k = 0; k < group.size; k++) {
            int o = Trajectories.STRIDE * group.values[k];
            int b = State.BLOCK * group.values[k];
            GroupPaths.copy(path.a, b, bends, o + Trajectories.AX);
            GroupPaths.copy(path.j, b, bends, o + Trajectories.JX);
            if (areEndsKept) {
                GroupPaths.copy(state.x(), b, endX, b);
                GroupPaths.copy(state.v(), b, endV, b);
            }
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
            if (!repose.hasAll(group) && !strides.bring(group, tau, tied)) {
                if (Double.isNaN(endAt[first]) && motion.isTiedGroup(group) && strikes.areAtAnchors(group, trajectories)) {
                    tied.decide(group);
                }
                cover(group, trajectories.offset(first), tau);
            }
        }
        if (observer != null) {
            observer.covered(group, trajectories.offset(first), tau);
        }
        for (int k = 0; k < group.size; k++) {
            trajectories.anchor(group.values[k], tau, state);
            endAt[group.values[k]] = Double.NaN;
        }
    }

    /** Integrates a group from one offset to another, which may be an earlier one. */
    void cover(IntList group, double from, double to) {
        probed.cut(group.values[0]);
        double t = motion.time(from);
        double length = to - from;
        SurfaceFriction surface = motion.ground().surfaceUnder(group);
        if (motion.isTiedGroup(group)) {
            tied.advance(motion, group, t, length, path);
        } else if (surface != null && length > 0) {
            sliding.advance(state.body(group.values[0]), surface, group, t, length, isPressed(group));
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
        GroupPaths.restore(trajectories, state, group);
    }

    /** Begins a step. */
    void begin() {
        areEndsKept = false;
        ahead = null;
    }

    /** The state vectors, which hold where the paths of driven bodies end, are about to be used otherwise. */
    void keepEnds(IntList driven) {
        if (areEndsKept) {
            return;
        }
        areEndsKept = true;
        if (trajectories.areStraight()) {
            return; // nothing has ever been driven
        }
        ensure();
        for (int k = 0; k < driven.size; k++) {
            int b = State.BLOCK * driven.values[k];
            GroupPaths.copy(state.x(), b, endX, b);
            GroupPaths.copy(state.v(), b, endV, b);
        }
    }

    /** Writes where paths end into the state vectors, unless that is what they hold. */
    void finish(IntList driven) {
        for (int k = 0; areEndsKept && k < driven.size; k++) {
            finish(driven.values[k]);
        }
        if (observer != null) {
            finished(driven);
        }
    }

    /** Writes where a body's path ends into the state vectors. */
    private void finish(int body) {
        int b = State.BLOCK * body;
        GroupPaths.copy(endX, b, state.x(), b);
        GroupPaths.copy(endV, b, state.v(), b);
    }

    /** The state vectors hold the ends of all paths. */
    private void finished(IntList driven) {
        for (int k = 0; k < driven.size; k++) {
            IntList group = motion.companions(driven.values[k]);
            if (group.values[0] == driven.values[k]) {
                observer.covered(group, trajectories.offset(driven.values[k]), trajectories.h());
            }
        }
    }

    /** Takes note that forces on a body change at its anchor, or that it is about to be removed. */
    void push(int body) {
        strides.cut(body);
        probed.cut(body);
        repose.end(body);
        if (body < endAt.length) {
            endAt[body] = Double.NaN;
        }
    }

    /** Takes note that a body's course has changed at its anchor. */
    void forget(int body) {
        push(body);
        strikes.note(body, trajectories.step(), trajectories.offset(body));
    }

    /** Whether the path of a group began in the middle of a stride. */
    boolean goesOn(IntList group) {
        return strides.goesOn(group.values[0]);
    }

    /** The offset of a body's last change of course in this step, 0 if there was none. */
    double smoothSince(int body) {
        return strikes.last(body, trajectories.step());
    }

    /** Makes room for all bodies. */
    void ensure() {
        int n = state.x().length;
        if (endX.length < n) {
            endX = Arrays.copyOf(endX, n);
            endV = Arrays.copyOf(endV, n);
            int bodies = endAt.length;
            endAt = Arrays.copyOf(endAt, n / State.BLOCK);
            Arrays.fill(endAt, bodies, endAt.length, Double.NaN);
            fineLength = Arrays.copyOf(fineLength, n / State.BLOCK);
            pace = Arrays.copyOf(pace, n / State.BLOCK);
            strikes.ensure(n / State.BLOCK);
        }
    }
}
