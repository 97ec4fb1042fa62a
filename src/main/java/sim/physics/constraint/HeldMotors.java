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
 * Motors whose coordinate has a stop. Where both act, they say the same of it, or the opposite, and no solution of the one and then of the other finds
 * what is common to them. So each pair is seen as one:
 *
 * <ul>
 *   <li>A brake and the stop at which it stands: what an impact has left in one against the other none takes out again, as each finds that all is at
 *       rest. What both bear together is shared anew in each step, with the smallest impulses that do it.
 *   <li>A motor that wants to go beyond a stop presses with all it has, at once, and the stop bears that. It is no load of the stop: what is soft gives
 *       way to loads, and would do so to the motor, in proportion to its limit.
 *   <li>A motor that wants to leave a stop, against which it has pressed, presses no more.
 * </ul>
 */
final class HeldMotors implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int ROWS = Equations.ROWS;
    private static final int BLOCK = State.BLOCK;

    /** What directions may differ by that are the same, relative to themselves. */
    private static final double SAME = 1e-9;

    private final State state;
    private final TieEquations equations;

    /** Places of motors and of stops between the same bodies, in turn. */
    private final IntList pairs = new IntList();

    /** How many times as far the motor's coordinate goes as the stop's in this step; 0 if they are others. */
    private double[] ratios = {};

    /** Where the pairs of each constraint begin, if it is a stop; empty if there are no motors. */
    private int[] begins = {};

    HeldMotors(State state, TieEquations equations) {
        this.state = state;
        this.equations = equations;
    }

    /** Finds motors and stops between the same bodies. */
    void gather() {
        pairs.clear();
        Map<Long, List<Integer>> motors = new HashMap<>();
        for (int k = 0; k < equations.count(); k++) {
            if (equations.kinds[k] == TieEquations.Kind.MOTOR) {
                motors.computeIfAbsent(TieOrder.bodies(equations.ties[k]), key -> new ArrayList<>()).add(k);
            }
        }
        begins = motors.isEmpty() ? new int[0] : new int[equations.count() + 1];
        for (int k = 0; !motors.isEmpty() && k < equations.count(); k++) {
            if (equations.kinds[k] == TieEquations.Kind.STOP) {
                for (int motor : motors.getOrDefault(TieOrder.bodies(equations.ties[k]), List.of())) {
                    pairs.add(motor);
                    pairs.add(k);
                }
            }
            begins[k + 1] = pairs.size;
        }
        ratios = new double[pairs.size / 2];
    }

    /** The block of the first or the second body of a constraint; −1 if it cannot move. */
    private int block(int end) {
        int block = equations.blocks[end];
        return isMovable(block) ? block : -1;
    }

    private boolean isMovable(int block) {
        return block >= 0 && state.w().values()[block] > 0;
    }

    /** Begins a step: shares the impulses with which it begins. */
    void share(double[] impulse, double h) {
        for (int n = 0; n < pairs.size; n += 2) {
            Motor motor = (Motor) equations.ties[pairs.values[n]];
            int o = ROWS * pairs.values[n + 1];
            double ratio = ratio(pairs.values[n], pairs.values[n + 1]);
            ratios[n / 2] = ratio;
            if (ratio != 0 && motor.getSpeed() == 0 && impulse[o] > 0 != impulse[o + 1] > 0) {
                share(impulse, pairs.values[n], pairs.values[n + 1], ratio, motor.getLimit() * h);
            } else if (ratio * motor.getSpeed() != 0) {
                leave(impulse, ROWS * pairs.values[n], o, ratio, ratio * motor.getSpeed() > 0 ? 1 : -1);
            }
        }
    }

    /** What wants to leave a bound presses no more against it, nor the bound against that. */
    private static void leave(double[] impulse, int motor, int stop, double ratio, int sign) {
        int bound = sign > 0 ? stop : stop + 1;
        double both = Math.max(0, Math.min(impulse[bound], -sign * ratio * impulse[motor]));
        impulse[bound] -= both;
        impulse[motor] += sign * both / ratio;
    }

    /**
     * The impulse with which motors that want to go beyond a bound press against it: the bound bears it, and no body gets it.
     *
     * @param sign 1 for the lower bound, −1 for the upper one
     * @param way speed towards the bound that it allows
     */
    double pressed(int stop, int sign, double way, double[] impulse) {
        double sum = 0;
        for (int n = begin(stop); n < end(stop); n += 2) {
            sum += wants(n, sign, way) ? Math.max(0, -sign * ratios[n / 2] * impulse[ROWS * pairs.values[n]]) : 0;
        }
        return sum;
    }

    /**
     * Lets them press as hard as they can, as they never get as fast as they want to.
     *
     * @return what the bound bears more
     */
    double press(int stop, int sign, double way, double[] impulse, double h) {
        double more = 0;
        for (int n = begin(stop); n < end(stop); n += 2) {
            if (wants(n, sign, way)) {
                int k = pairs.values[n];
                Motor motor = (Motor) equations.ties[k];
                double by = Math.signum(motor.getSpeed()) * motor.getLimit() * h - impulse[ROWS * k];
                impulse[ROWS * k] += by;
                equations.push(k, 0, by);
                more -= sign * ratios[n / 2] * by;
            }
        }
        return more;
    }

    /** Whether motors drive the coordinate of a stop. */
    boolean has(int stop) {
        return begin(stop) < end(stop);
    }

    private int begin(int stop) {
        return begins.length == 0 ? 0 : begins[stop];
    }

    private int end(int stop) {
        return begins.length == 0 ? 0 : begins[stop + 1];
    }

    /** Whether the motor of a pair is to go faster towards a bound than it may. */
    private boolean wants(int pair, int sign, double way) {
        double ratio = ratios[pair / 2];
        return ratio != 0 && -sign * ((Motor) equations.ties[pairs.values[pair]]).getSpeed() / ratio > Math.max(0, way);
    }

    private void share(double[] impulse, int motor, int stop, double ratio, double most) {
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
        boolean isSwapped = block(2 * motor) != block(2 * stop);
        double product = 0;
        double first = 0;
        double second = 0;
        for (int m = 0; m < 2 * BLOCK; m++) {
            int half = m / BLOCK;
            if (!isMovable(equations.blocks[2 * motor + half])) {
                continue;
            }
            double a = equations.j[TieEquations.J * motor + BLOCK * ROWS * half + m % BLOCK];
            double b = equations.j[TieEquations.J * stop + BLOCK * ROWS * (isSwapped ? 1 - half : half) + m % BLOCK];
            product += a * b;
            first += a * a;
            second += b * b;
        }
        return product * product < (1 - SAME) * first * second ? 0 : product / second;
    }
}
