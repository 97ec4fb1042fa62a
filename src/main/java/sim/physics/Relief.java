// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.io.Serializable;
import java.util.List;
import sim.physics.internal.Work;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Gravity;
import sim.physics.motion.State;

/**
 * When the events of a step cost more than they may, time stepping makes the rest of it and some steps more: this says how much they
 * may, and for how many. If events cost too much again soon after, twice as many; so that, in the mean, a step costs little more than
 * one of time stepping as long as bodies are jammed, and is found by events again when they are not.
 */
final class Relief implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Substeps that a step is made of meanwhile. */
    static final int SUBSTEPS = 32;

    /** Work that a step may cost unless set, and that for each body: some seconds. */
    static final long USUAL = 10_000_000;

    private static final long USUAL_PER_BODY = 200;

    private static final int SOONER = 20;

    /** Parts of a step at most that begin with a look at where bodies are, and the fewest substeps of one. */
    private static final int MOST_PARTS = 32;

    private static final int LEAST_SUBSTEPS = 8;

    /**
     * What a body may fall by in a substep, relative to its size, as long as that takes no more of them than a step has. Where it is
     * ten times as much, what lies under something ten times as heavy is pressed in by a hundredth of its size.
     */
    private static final double FALL = 5e-4;

    /** Way in a part, relative to the size of a body, and turn, rad: what bodies touch, and where, is found at its beginning. */
    private static final double WAY = 0.25;

    private static final int LEAST = 8;
    private static final int MOST = 256;

    /** 0 for the usual one. */
    private long limit;

    private boolean isOn;

    /** How many steps time stepping makes, until which one, and which step was the first one by events after it. */
    private int length;

    private long until;
    private long last = Long.MIN_VALUE / 2;
    private long relieved;

    /** Whether the last step by events has ended in an exception that the author was told. */
    private boolean hasTold;

    void setLimit(long units) {
        limit = units;
    }

    /**
     * Work that a step may cost. Bodies that nothing moves jam others sooner than all else does.
     *
     * @param areSome whether there are such bodies that move
     */
    long limit(int bodies, boolean areSome) {
        long usual = USUAL + USUAL_PER_BODY * bodies;
        return limit > 0 ? limit : areSome ? usual / SOONER : usual;
    }

    /** The same, if there is anything that may take over. */
    long limit(int bodies, boolean areSome, boolean isAudited) {
        return isAudited ? Work.UNLIMITED : limit(bodies, areSome);
    }

    boolean isOn() {
        return isOn;
    }

    /** Time stepping takes over in a step. */
    void begin(long step) {
        length = step - last <= length ? Math.min(MOST, 2 * length) : LEAST;
        until = step + length;
        isOn = true;
    }

    /** A step, or the rest of one, is made by time stepping. */
    void count() {
        relieved += isOn ? 1 : 0;
    }

    /**
     * Until when the next part of a step goes: a long step in which bodies go far, or turn far, is made in parts.
     *
     * @param from offset of its beginning
     * @param step length of a whole step
     */
    static double partEnd(State state, List<ForceGenerator> forces, double from, double step) {
        double pull = pull(forces);
        double part = step - from;
        for (int k = 0; k < state.size(); k++) {
            if (state.body(k) != null && !state.body(k).isImmobile()) {
                part = Math.min(part, mostTime(state, k, pull));
            }
        }
        double end = from + Math.max(part, step / MOST_PARTS);
        return end < step - 0.5 * step / MOST_PARTS ? end : step;
    }

    /** The time in which a body goes as far as it may in a part. */
    private static double mostTime(State state, int body, double pull) {
        double[] v = state.v();
        int b = State.BLOCK * body;
        double way = WAY * state.body(body).getShape().boundingRadius();
        double speed = Math.abs(v[b]) + Math.abs(v[b + 1]);
        double time = 2 * way / (speed + Math.sqrt(speed * speed + 2 * pull * way));
        return Math.min(time, WAY / Math.abs(v[b + State.THETA]));
    }

    /** The acceleration of bodies on which nothing acts but fields. */
    static double pull(List<ForceGenerator> forces) {
        double pull = 0;
        for (ForceGenerator one : forces) {
            pull += one instanceof Gravity field ? Math.abs(field.getX()) + Math.abs(field.getY()) : 0;
        }
        return pull;
    }

    /** Substeps of a part: as many as a whole step has in its time, or more, as nothing is to fall far in one. */
    static int substeps(State state, List<ForceGenerator> forces, double part, double step) {
        double size = Double.POSITIVE_INFINITY;
        for (int k = 0; k < state.size(); k++) {
            if (state.body(k) != null && !state.body(k).isImmobile()) {
                size = Math.min(size, state.body(k).getShape().boundingRadius());
            }
        }
        double falling = Math.min(SUBSTEPS, part * Math.sqrt(pull(forces) / (2 * FALL * size)));
        return Math.max(LEAST_SUBSTEPS, (int) Math.ceil(Math.max(SUBSTEPS * part / step, falling)));
    }

    boolean isOver(long step) {
        return isOn && step >= until;
    }

    /**
     * Whether the author is to be told that constraints cannot be kept: what he has set may contradict itself, or a step is too long.
     * He is told once; if he makes the next step all the same, he gets as much of it as there is.
     */
    boolean tells(boolean isAudited) {
        boolean isNews = relieved == 0 && (!hasTold || isAudited);
        hasTold = true;
        return isNews;
    }

    /** A step has been made by events. */
    void goOn() {
        hasTold = false;
    }

    /** Events cannot go on from where bodies are. */
    void extend(long step) {
        isOn = true;
        until = step + LEAST;
    }

    void end(long step) {
        isOn = false;
        last = step;
    }

    /** How many steps were made by time stepping, in whole or in part. */
    long relieved() {
        return relieved;
    }
}
