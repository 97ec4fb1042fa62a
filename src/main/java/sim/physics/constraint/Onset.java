// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;

/** Speeds that motors may give to their bodies within a step: a flipper at rest, whose motor has just been set, is at the ball before the step is over. */
public final class Onset implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int BLOCK = State.BLOCK;

    private final State state;
    private final Equations now = new Equations();

    /** By body, and the bodies that have some. */
    private double[] gains = {};

    private final IntList found = new IntList();

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
        TieEquations those = ties.equations;
        for (int k = 0; k < those.count(); k++) {
            if (those.kinds[k] == TieEquations.Kind.MOTOR) {
                find((Motor) those.ties[k], h);
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

    private double answer(double[] row, Body body) {
        double[] w = state.w().values();
        int k = BLOCK * body.index();
        return row[0] * row[0] * w[k] + row[1] * row[1] * w[k + 1] + row[2] * row[2] * w[k + 2];
    }

    /** A body may be held at its rim, and its other end is as far away as it is wide. */
    private void add(Body body, boolean isAngle, double gain) {
        int k = body.index();
        if (body.isImmobile() || !(gain > 0)) {
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
}
