// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;

/**
 * Speeds that motors may give to their bodies within a step: a flipper at rest, whose motor has just been set, is at the ball before the step is over.
 * And speeds that stops may take from theirs.
 */
public final class Onset implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int BLOCK = State.BLOCK;

    /** Steps in which a stop is reached that may be struck in this one: forces make what comes faster. */
    private static final int SOON = 2;

    private final State state;
    private final Equations now = new Equations();

    /** By body, and the bodies that have some. */
    private double[] gains = {};

    private final IntList found = new IntList();

    /** The same of stops. */
    private double[] stops = {};

    private final IntList stopped = new IntList();

    /**
     * Makes the onsets of an engine.
     *
     * @param state the state vectors
     */
    public Onset(State state) {
        this.state = state;
    }

    /**
     * Finds them, of motors that do not have the speed that is asked for.
     *
     * @param ties rows that know their motors since the last step
     * @param h the step
     */
    public void find(TieRows ties, double h) {
        for (int k = 0; k < found.size; k++) {
            gains[found.values[k]] = 0;
        }
        found.clear();
        for (int k = 0; k < stopped.size; k++) {
            stops[stopped.values[k]] = 0;
        }
        stopped.clear();
        TieEquations those = ties.equations;
        for (int k = 0; k < those.count(); k++) {
            if (those.kinds[k] == TieEquations.Kind.MOTOR) {
                find((Motor) those.ties[k], h);
            } else if (those.kinds[k] == TieEquations.Kind.STOP) {
                find((Limit) those.ties[k], h);
            }
        }
    }

    private void find(Motor motor, double h) {
        Body a = motor.getBodyA();
        Body b = motor.getBodyB();
        if (a.state() != state || b != null && b.state() != state) {
            return; // removed since
        }
        now.clear();
        motor.coordinate().evaluate(now);
        double lack = Math.abs(motor.getSpeed() - now.speed(a, b));
        double answer = answer(now.jA, a) + (b == null ? 0 : answer(now.jB, b));
        double gain = Math.min(lack, motor.getLimit() * answer * h);
        boolean isAngle = motor.isAngle(0);
        add(a, isAngle, gain);
        if (b != null) {
            add(b, isAngle, gain);
        }
    }

    /** A stop that is reached within the step. */
    private void find(Limit limit, double h) {
        Body a = limit.getBodyA();
        Body b = limit.getBodyB();
        if (a.state() != state || b != null && b.state() != state) {
            return; // removed since
        }
        now.clear();
        limit.coordinate().evaluate(now);
        double rate = now.speed(a, b);
        double gap = rate < 0 ? now.c[0] - limit.getLower() : limit.getUpper() - now.c[0];
        if (rate != 0 && gap > 0 && gap < SOON * h * Math.abs(rate)) {
            stop(a, limit.isAngle(0), Math.abs(rate));
            if (b != null) {
                stop(b, limit.isAngle(0), Math.abs(rate));
            }
        }
    }

    private void stop(Body body, boolean isAngle, double rate) {
        if (body.isFixed()) {
            return;
        }
        int k = body.index();
        if (k >= stops.length) {
            stops = Arrays.copyOf(stops, state.size());
        }
        double speed = isAngle ? 2 * body.getShape().boundingRadius() * rate : rate;
        stops[k] = Math.max(stops[k], speed);
        stopped.add(k);
    }

    private double answer(double[] row, Body body) {
        double[] w = state.w().values();
        int k = BLOCK * body.index();
        return row[0] * row[0] * w[k] + row[1] * row[1] * w[k + 1] + row[2] * row[2] * w[k + 2];
    }

    /** A body may be held at its rim, and its other end is as far away as it is wide. */
    private void add(Body body, boolean isAngle, double gain) {
        int k = body.index();
        if (body.isFixed() || !(gain > 0)) {
            return;
        }
        if (k >= gains.length) {
            gains = Arrays.copyOf(gains, state.size());
        }
        gains[k] += isAngle ? 2 * body.getShape().boundingRadius() * gain : gain;
        found.add(k);
    }

    /**
     * Says what a body may get.
     *
     * @param body index
     * @return a speed
     */
    public double of(int body) {
        return body < gains.length ? gains[body] : 0;
    }

    /** {@return bodies whose stops are struck in this step, some of them twice} */
    public IntList stopped() {
        return stopped;
    }

    /**
     * Says what may be taken from one of them.
     *
     * @param body index
     * @return a speed
     */
    public double stop(int body) {
        return stops[body];
    }
}
