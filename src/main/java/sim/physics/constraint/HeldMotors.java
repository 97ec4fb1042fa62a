// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/**
 * Brakes that hold a coordinate that stands at a stop. The two say the same, and what an impact has left in one against the other no solution takes
 * out again: each finds that all is at rest. So what both bear together is shared anew in each step, with the smallest impulses that do it.
 */
final class HeldMotors implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int ROWS = Equations.ROWS;
    private static final int BLOCK = State.BLOCK;

    /** What directions may differ by that are the same, relative to themselves. */
    private static final double SAME = 1e-9;

    private final TieEquations equations;

    /** Places of motors and of stops between the same bodies, in turn. */
    private final IntList pairs = new IntList();

    HeldMotors(TieEquations equations) {
        this.equations = equations;
    }

    /** Finds motors and stops between the same bodies. */
    void gather() {
        pairs.clear();
        Map<Long, List<Integer>> motors = new HashMap<>();
        for (int k = 0; k < equations.count(); k++) {
            if (equations.kinds[k] == TieEquations.Kind.MOTOR) {
                motors.computeIfAbsent(bodies(k), key -> new ArrayList<>()).add(k);
            }
        }
        for (int k = 0; !motors.isEmpty() && k < equations.count(); k++) {
            if (equations.kinds[k] == TieEquations.Kind.STOP) {
                for (int motor : motors.getOrDefault(bodies(k), List.of())) {
                    pairs.add(motor);
                    pairs.add(k);
                }
            }
        }
    }

    /** The bodies of a constraint, in whichever order. */
    private long bodies(int k) {
        long a = equations.blocks[2 * k];
        long b = equations.blocks[2 * k + 1];
        return Math.min(a, b) << Integer.SIZE | Math.max(a, b);
    }

    /** Shares the impulses with which a step begins. */
    void share(double[] impulse, double h) {
        for (int n = 0; n < pairs.size; n += 2) {
            Motor motor = (Motor) equations.ties[pairs.values[n]];
            int o = ROWS * pairs.values[n + 1];
            if (motor.getSpeed() == 0 && impulse[o] > 0 != impulse[o + 1] > 0) { // one that wants to go on gives its limit
                share(impulse, pairs.values[n], pairs.values[n + 1], motor.getLimit() * h);
            }
        }
    }

    private void share(double[] impulse, int motor, int stop, double most) {
        double ratio = ratio(motor, stop);
        if (ratio == 0) {
            return;
        }
        int o = ROWS * stop;
        int side = impulse[o] > 0 ? 1 : -1;
        double all = impulse[o] - impulse[o + 1] + ratio * impulse[ROWS * motor];
        boolean bears = all * side > 0; // else the motor holds it off the stop
        double asked = bears ? ratio * all / (1 + ratio * ratio) : all / ratio;
        double now = Math.max(-most, Math.min(most, asked));
        double rest = Math.max(0, side * (all - ratio * now));
        impulse[ROWS * motor] = now;
        impulse[o] = side > 0 ? rest : 0;
        impulse[o + 1] = side > 0 ? 0 : rest;
    }

    /** How many times as far a motor's coordinate goes as that of a stop, wherever the bodies go; 0 if the two are others. */
    private double ratio(int motor, int stop) {
        boolean isSwapped = equations.blocks[2 * motor] != equations.blocks[2 * stop];
        double product = 0;
        double first = 0;
        double second = 0;
        for (int m = 0; m < 2 * BLOCK; m++) {
            int half = m / BLOCK;
            double a = equations.j[TieEquations.J * motor + BLOCK * ROWS * half + m % BLOCK];
            double b = equations.j[TieEquations.J * stop + BLOCK * ROWS * (isSwapped ? 1 - half : half) + m % BLOCK];
            product += a * b;
            first += a * a;
            second += b * b;
        }
        return product * product < (1 - SAME) * first * second ? 0 : product / second;
    }
}
