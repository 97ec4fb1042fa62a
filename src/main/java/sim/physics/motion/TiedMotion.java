// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * Advances bodies that ties hold together: by the integrator, and then back onto what the ties ask for. A step whose
 * correction is more than its error should be is made again in halves, so that a step that is too long for a scene costs
 * time and not the scene.
 */
final class TiedMotion implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final double HALF = 0.5;
    private static final int MOST_HALVINGS = 14;
    private static final int MOST_PARTS = 1 << MOST_HALVINGS;

    /**
     * The same for a step that goes on beyond the engine's, and for one that is short anyway: it may be so by the method's own
     * choice. And how much longer than one that was not too long the next is.
     */
    private static final int FEW_HALVINGS = 6;
    private static final double LONGER = 1.25;

    /** Parts of a step that are too long and yet gone; with more the pose is one that lets nothing pass. */
    private static final int MOST_FORCED = 8;

    /** Sizes of a body in a step of the engine, by which no forced projection may move it or change its velocity. */
    private static final double FAR = 30;

    /** Part of a step in which the correction at its end does not matter to the path. */
    private static final double SHORT = 1e-3;

    /** Way of a stride, in rad or relative to the size of a body, that is next to none: what moves otherwise makes longer ones. */
    private static final double NO_WAY = 1e-5;

    /** Halvings of what a method has chosen that are not those of a motion which goes on. */
    private static final int MANY_TEARS = 4;

    /** More evaluations than may ever be made in vain. */
    private static final int ALL = 1 << 20;

    private final State state;
    private final Trajectories trajectories;
    private final Ties ties;
    private final SwitchedMotion switched;
    private double[] startX = {};
    private double[] startV = {};
    private double[] strideX = {};
    private double[] strideV = {};
    private double[] pieceX = {};
    private double[] pieceV = {};

    /** How often the last piece of a stride was too long for the ties; whether the method found no step that was short enough. */
    private int tears;

    private boolean hasGivenUp;

    /** Whether the accelerations at the start of the path at hand are known; whether its step was found to have no quick way. */
    private boolean isStartKnown;

    private boolean isRefused;

    TiedMotion(State state, Trajectories trajectories, Ties ties) {
        this.state = state;
        this.trajectories = trajectories;
        this.ties = ties;
        switched = new SwitchedMotion(state, trajectories, ties, this);
    }

    /** Shares the workspace of another one, which has room for all bodies then. */
    void match(TiedMotion first) {
        first.ensure();
        startX = first.startX;
        startV = first.startV;
        strideX = first.strideX;
        strideV = first.strideV;
        pieceX = first.pieceX;
        pieceV = first.pieceV;
    }

    boolean isRefused() {
        return isRefused;
    }

    /** Sets whether the next stride need not look for a quick way. */
    void setRefused(boolean yes) {
        isRefused = yes;
    }

    void setObserver(CourseObserver who) {
        switched.setObserver(who);
    }

    /**
     * Advances a group from an offset until a motor reaches its speed or a joint its stop, or to the end of the step.
     *
     * @return how long
     */
    double advanceUntilSwitch(Motion motion, IntList group, double t, double tau, double limit, Path path) {
        boolean isSwitched = ties.isSwitched(group);
        isRefused &= !isSwitched; // of the whole step that was known, and not of its parts
        try {
            return isSwitched
                    ? switched.advance(motion, group, t, tau, limit, path)
                    : stride(motion, group, t, limit, path);
        } finally {
            isRefused = false;
            isStartKnown = false;
        }
    }

    /** Decides which motors and stops of a group act, where its velocities are not those that were decided for. */
    void decide(IntList group) {
        if (ties.isSwitched(group)) {
            ties.decide(group, trajectories.h());
        }
    }

    /** Sets whether accelerations at the start of the next strides are known. */
    void setStartKnown(boolean yes) {
        isStartKnown = yes;
    }

    void again(IntList group) {
        GroupPaths.copy(group, startX, state.x());
        GroupPaths.copy(group, startV, state.v());
    }

    /** Advances a group by at most a time, as far as the integrator does at once; returns how far. */
    double stride(Motion motion, IntList group, double t, double limit, Path path) {
        if (!motion.getIntegrator().isAdaptive() || isRigid(motion, group)) {
            advance(motion, group, t, limit, path);
            return limit;
        }
        begin(group);
        double length = chosenStride(motion, group, t, limit, path);
        join(group, length, path);
        return length;
    }

    /** Advances a group over a time of either sign; the path is the cubic between its ends. */
    void advance(Motion motion, IntList group, double t, double length, Path path) {
        if (length == 0) {
            return;
        }
        begin(group);
        path.ensure(state.x().length);
        if (fly(motion, group, length, path)) {
            path.knowsFirst = true;
        } else if (motion.getIntegrator().isAdaptive()) {
            for (double done = 0; done != length; ) {
                double left = length - done;
                double stride = chosenStride(motion, group, t + done, left, path);
                done = stride == left ? length : done + stride;
            }
        } else if (advanceInParts(motion, group, t, length, path) == 1 && Math.abs(length) < SHORT * trajectories.h()) {
            return; // it has its path: the ends are too near for a difference
        }
        join(group, length, path);
    }

    /** Advances a group in as many parts as it takes; returns how many, or 0 if it has crept. */
    private int advanceInParts(Motion motion, IntList group, double t, double length, Path path) {
        int halvings = ties.halvings(group, MOST_HALVINGS, false);
        if (halvings < 0) {
            creep(motion, group, t, length, path);
            return 0;
        }
        int parts = 1;
        while (!advance(motion, group, t, length, parts, 1 << halvings, path)) {
            again(group);
            parts *= 2;
            if (parts == 1 << FEW_HALVINGS && stands(group)) {
                halvings = ties.halvings(group, halvings, true);
            }
        }
        return parts;
    }

    /** Whether the bodies of a group stood at the start of the path at hand. */
    private boolean stands(IntList group) {
        boolean yes = true;
        for (int k = 0; yes && k < group.size; k++) {
            int b = State.BLOCK * group.values[k];
            yes = startV[b] == 0 && startV[b + 1] == 0 && startV[b + State.THETA] == 0;
        }
        return yes;
    }

    private void begin(IntList group) {
        ensure();
        GroupPaths.copy(group, state.x(), startX);
        GroupPaths.copy(group, state.v(), startV);
    }

    private void ensure() {
        if (startX.length < state.x().length) {
            startX = Arrays.copyOf(startX, state.x().length);
            startV = Arrays.copyOf(startV, state.x().length);
            strideX = Arrays.copyOf(strideX, state.x().length);
            strideV = Arrays.copyOf(strideV, state.x().length);
            pieceX = Arrays.copyOf(pieceX, state.x().length);
            pieceV = Arrays.copyOf(pieceV, state.x().length);
        }
    }

    /** The cubics from the start to where the bodies are now. */
    private void join(IntList group, double length, Path path) {
        path.join(group, startX, startV, state, 1 / length);
    }

    /**
     * Coordinates in which a method that chooses its steps moves a group from where the state vectors have it, so that there
     * is nothing to correct; null if it must move the bodies.
     */
    TiedCoordinates coordinates(Motion motion, IntList group, Path path) {
        path.ensure(state.x().length);
        AdaptiveIntegrator method = (AdaptiveIntegrator) motion.getIntegrator();
        TiedCoordinates tied = method.takesTiedCoordinates(group, path) ? ties.coordinates(group) : null;
        if (tied == null) {
            return null;
        }
        Generators fields = motion.generators;
        boolean isFalling = fallsFreely(motion, group);
        boolean isThere = tied.begin(isFalling ? null : motion, fields.gravityX, fields.gravityY, path.stage);
        return isThere ? tied : null;
    }

    /**
     * One step of a method that chooses it; a shorter one if its correction is rough. In a pose that lets nothing pass steps get ever
     * shorter: there it goes on until the end, or creeps all of the way. Returns how far.
     */
    private double chosenStride(Motion motion, IntList group, double t, double length, Path path) {
        GroupPaths.copy(group, state.x(), strideX);
        GroupPaths.copy(group, state.v(), strideV);
        int most = ties.halvings(group, MOST_HALVINGS, false);
        TiedCoordinates tied = most < 0 ? null : coordinates(motion, group, path);
        if (tied != null) {
            double done = ((AdaptiveIntegrator) motion.getIntegrator()).advance(tied, motion, state, group, t, length, false, path);
            tied.end();
            motion.work.spend(ties.takeEffort(group));
            return done;
        }
        double done = 0;
        while (most >= 0) {
            double left = length - done;
            int before = motion.work.evaluations();
            double piece = piece(motion, group, t + done, left, most, path);
            done = piece == left ? length : done + piece;
            boolean isTorn = tears >= MANY_TEARS;
            if (piece != 0 && (done == length || !isTorn && !isNextToNoWay(group))) {
                return done;
            }
            if (piece == 0) {
                motion.acceleration(group, t + done, path.stage); // the last attempt may have ended anywhere
            }
            int spare = ties.tire(group, trajectories.step(), piece == 0 ? ALL : motion.work.evaluations() - before, isTorn);
            if (spare == Integer.MAX_VALUE && piece != 0) {
                return done;
            }
            if (spare == Integer.MAX_VALUE && hasGivenUp) {
                throw ((AdaptiveIntegrator) motion.getIntegrator()).failure(t + done);
            }
            most = piece == 0 || spare == 0 ? -1 : most;
        }
        GroupPaths.copy(group, strideX, state.x());
        GroupPaths.copy(group, strideV, state.v());
        creep(motion, group, t, length, path);
        return length;
    }

    /** One step of a method that chooses it; 0 if none is short enough. */
    private double piece(Motion motion, IntList group, double t, double length, int most, Path path) {
        GroupPaths.copy(group, state.x(), pieceX);
        GroupPaths.copy(group, state.v(), pieceV);
        double limit = length;
        tears = 0;
        for (int halvings = 0; ; halvings++) {
            ties.begin(group, !motion.hasForces());
            path.stages.bend = ties.bend(group);
            path.stages.mayGiveUp = true;
            path.stages.isBlurred = ties.isTired(group, trajectories.step());
            double done = motion.getIntegrator().advance(motion, state, group, t, limit, path);
            hasGivenUp = done == 0;
            if (done != 0 && ties.project(group)) {
                return done;
            }
            tears = halvings + 1;
            boolean isTiny = halvings >= FEW_HALVINGS && Math.abs(done) <= trajectories.h() / MOST_PARTS; // or it went on for ever
            boolean isLast = hasGivenUp || halvings == most || isTiny;
            if (isLast && !hasGivenUp && ties.force(group)) {
                requireNear(group, pieceX, pieceV);
                return done;
            }
            GroupPaths.copy(group, pieceX, state.x());
            GroupPaths.copy(group, pieceV, state.v());
            if (isLast) {
                return 0;
            }
            limit = HALF * done;
        }
    }

    /** Whether a group has hardly moved in its last piece of a stride. */
    private boolean isNextToNoWay(IntList group) {
        double way = 0;
        for (int k = 0; k < group.size; k++) {
            int b = State.BLOCK * group.values[k];
            double moved = Math.abs(state.x()[b] - pieceX[b]) + Math.abs(state.x()[b + 1] - pieceX[b + 1]);
            double turned = Math.abs(state.x()[b + State.THETA] - pieceX[b + State.THETA]);
            way = Math.max(way, moved / state.body(group.values[k]).getShape().boundingRadius() + turned);
        }
        return way < NO_WAY;
    }

    /**
     * One step of a method that chooses it, wherever the engine's ends; a shorter one if its correction is rough.
     *
     * @return how far; 0 if none is short enough, and nothing has changed
     */
    double goOn(Motion motion, AdaptiveIntegrator method, IntList group, double t, double wanted, Path path) {
        begin(group);
        TiedCoordinates tied = coordinates(motion, group, path);
        if (tied != null) {
            double done = method.advance(tied, motion, state, group, t, wanted, true, path);
            tied.end();
            motion.work.spend(ties.takeEffort(group));
            join(group, done, path);
            return done;
        }
        double limit = 0;
        for (int halvings = 0; halvings <= FEW_HALVINGS; halvings++) {
            ties.begin(group, !motion.hasForces());
            path.stages.bend = ties.bend(group);
            path.stages.mayGiveUp = true;
            double done = halvings == 0
                    ? method.goOn(motion, state, group, t, wanted, path)
                    : method.advance(motion, state, group, t, limit, path);
            if (done != 0 && ties.project(group)) {
                int first = group.values[0];
                path.proposed[first] = halvings == 0 ? path.proposed[first] : Math.min(path.proposed[first], LONGER * done);
                join(group, done, path);
                return done;
            }
            again(group);
            limit = HALF * done;
            halvings = done == 0 ? FEW_HALVINGS : halvings;
        }
        path.proposed[group.values[0]] = limit;
        return 0;
    }

    /** Goes on where no step is short enough. */
    private void creep(Motion motion, IntList group, double t, double length, Path path) {
        ties.begin(group, false);
        path.ensure(state.x().length);
        motion.acceleration(group, t, path.stage);
        ties.creep(group, length);
        motion.work.spend(ties.takeEffort(group));
        path.forgetSteps(group.values[0]);
        for (int k = 0; k < group.size; k++) {
            if (!ties.isTied(group.values[k])) {
                fly(State.BLOCK * group.values[k], path.stage, length);
            }
        }
    }

    /** Moves a body to first order, as {@link Ties#creep} does with those that it moves. */
    private void fly(int b, double[] a, double length) {
        for (int s = b; s < b + State.BLOCK; s++) {
            state.v()[s] += length * a[s];
            state.x()[s] += length * state.v()[s];
        }
    }

    /**
     * Advances a group over a step, if there is a quick way; else nothing is changed, and of the path only its workspace. Where motors and
     * stops decide when they act, it must be seen first how far.
     */
    boolean leap(Motion motion, IntList group, double t, double length, Path path) {
        return !ties.isSwitched(group) && leapOn(motion, group, t, length, path);
    }

    private boolean leapOn(Motion motion, IntList group, double t, double length, Path path) {
        Generators fields = motion.generators;
        if (fly(motion, group, length, path)) {
            path.knowsFirst = true;
            isRefused = false;
            return true;
        }
        isRefused = !(motion.getIntegrator() instanceof RungeKutta4);
        if (!isRefused && fallsFreely(motion, group)) {
            isRefused = !ties.advance(group, fields.gravityX, fields.gravityY, length);
        } else if (!isRefused) {
            path.ensure(state.x().length);
            isRefused = !ties.advance(group, motion, isEven(motion, group, true), path.stage, t, length);
            if (!isRefused) {
                path.takeFirst(group);
            }
        }
        motion.work.spend(ties.takeEffort(group));
        return !isRefused;
    }

    /** Whether a group falls freely as one rigid body: its motion is known for any time. */
    boolean isRigid(Motion motion, IntList group) {
        return fallsFreely(motion, group) && ties.fly(group, 0, 0, 0, startX);
    }

    /** Moves it so, over a time of either sign; false if it is none. */
    private boolean fly(Motion motion, IntList group, double length, Path path) {
        if (!fallsFreely(motion, group)) {
            return false;
        }
        path.ensure(state.x().length);
        return ties.fly(group, motion.generators.gravityX, motion.generators.gravityY, length, path.first);
    }

    /** Whether nothing but uniform fields acts on any body of a group, beside its ties. */
    private boolean fallsFreely(Motion motion, IntList group) {
        return isEven(motion, group, false);
    }

    /** The same; or whether nothing but these and what contacts give, which is even over a step, does. */
    private boolean isEven(Motion motion, IntList group, boolean withContacts) {
        boolean yes = true;
        for (int k = 0; motion.fields() == null && yes && k < group.size; k++) {
            int body = group.values[k];
            Body view = state.body(body);
            yes = !view.isPushed() && !motion.generators.drive(view) && (withContacts || !motion.support.pushes(body));
        }
        return yes;
    }

    private boolean advance(Motion motion, IntList group, double t, double length, int parts, int most, Path path) {
        boolean isShort = Math.abs(length) < SHORT * trajectories.h();
        if (parts == 1 && !isRefused && (!isShort || isStartKnown && path.knowsFirst)) {
            if (leapOn(motion, group, t, length, path)) {
                path.joinBriefly(group, startV, state, isShort ? length : 0);
                return true;
            }
            isRefused = false;
        }
        int forced = 0;
        for (int k = 0; k < parts; k++) {
            double from = length * k / parts;
            double to = length * (k + 1) / parts;
            ties.begin(group, !motion.hasForces());
            path.isAtStart = isStartKnown && k == 0;
            integrate(motion, group, t + from, to - from, path);
            if (!ties.project(group)) {
                if (parts < most) {
                    return false;
                }
                forced++;
                if (forced <= MOST_FORCED && ties.force(group)) {
                    requireNear(group, startX, startV);
                    continue;
                }
                again(group);
                creep(motion, group, t, length, path);
                return true;
            }
        }
        return true;
    }

    /** What was forced onto its ties must not have been thrown by that: in a pose that lets nothing pass it may lead anywhere. */
    private void requireNear(IntList group, double[] fromX, double[] fromV) {
        for (int k = 0; k < group.size; k++) {
            int b = State.BLOCK * group.values[k];
            double most = FAR * state.body(group.values[k]).getShape().boundingRadius();
            double way = Math.abs(state.x()[b] - fromX[b]) + Math.abs(state.x()[b + 1] - fromX[b + 1]);
            double change = Math.abs(state.v()[b] - fromV[b]) + Math.abs(state.v()[b + 1] - fromV[b + 1]);
            if (!(way <= most + trajectories.h() * (Math.abs(fromV[b]) + Math.abs(fromV[b + 1])) && change * trajectories.h() <= most)) {
                again(group);
                throw ties.tooLong(group);
            }
        }
    }

    /** A step of the integrator; where it is long enough the path is made of its ends, afterwards. */
    private void integrate(Motion motion, IntList group, double t, double h, Path path) {
        if (motion.getIntegrator() instanceof RungeKutta4 method && Math.abs(h) >= SHORT * trajectories.h()) {
            method.advanceWithoutPath(motion, state, group, t, h, path);
        } else {
            motion.getIntegrator().advance(motion, state, group, t, h, path);
        }
    }
}
