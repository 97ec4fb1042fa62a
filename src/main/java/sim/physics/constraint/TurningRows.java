// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import sim.physics.motion.State;

/**
 * Motors and stops of an angle between two bodies that a pin ties, as arms have them: each is solved together with its pin. A torque alone turns an
 * arm about its centre, and the pin then takes three quarters of that back; what a motor or a stop asks for would be reached in many substeps. So an
 * impulse of theirs comes with that of the pin which keeps the pin's velocity as it is, and what the pin is about to change is seen beforehand.
 */
final class TurningRows implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int ROWS = Equations.ROWS;
    private static final int BLOCK = State.BLOCK;

    /** What is left of a turning mass at least, relative to itself: less is rounding. */
    private static final double SINGULAR = 1e-9;

    private final State state;
    private final TieEquations equations;
    private final PinImpulses pins;
    private final PinLevers pinLevers;

    /** By constraint: its pin, −1 for none; empty if there is no such constraint. */
    private int[] pinOf = {};

    /** By constraint: what its pin gives, and its own mass, for a unit of its impulse. */
    private double[] levers = {};

    TurningRows(State state, TieEquations equations, PinImpulses pins) {
        this.state = state;
        this.equations = equations;
        this.pins = pins;
        pinLevers = new PinLevers(state, pins);
    }

    /** What pins give where something pushes their bodies. */
    PinLevers levers() {
        return pinLevers;
    }

    /** Finds them. */
    void gather(List<PinJoint> all, int awakePins) {
        pinOf = new int[0];
        Map<Long, Integer> places = null;
        for (int k = 0; k < equations.count(); k++) {
            if (equations.kinds[k] == TieEquations.Kind.JOINT || !equations.isTurn(k)) {
                continue;
            }
            if (places == null) {
                places = new HashMap<>();
                for (int p = 0; p < awakePins; p++) {
                    places.putIfAbsent(TieOrder.bodies(all.get(p)), p);
                }
            }
            Integer pin = places.get(TieOrder.bodies(equations.ties[k]));
            if (pin != null) {
                if (pinOf.length == 0) {
                    pinOf = new int[equations.count()];
                    Arrays.fill(pinOf, -1);
                    levers = new double[2 * equations.count()];
                }
                pinOf[k] = pin;
            }
        }
    }

    /** Finds masses where the bodies are, whose pins have been evaluated there. */
    void evaluate() {
        double[] w = state.w().values();
        for (int k = 0; k < pinOf.length; k++) {
            if (pinOf[k] >= 0) {
                int o = TieEquations.J * k + State.THETA;
                int a = equations.blocks[2 * k];
                int b = equations.blocks[2 * k + 1];
                double turnA = w[a + State.THETA] * equations.j[o];
                double turnB = b < 0 ? 0 : w[b + State.THETA] * equations.j[o + BLOCK * ROWS];
                double own = turnA * equations.j[o] + turnB * (b < 0 ? 0 : equations.j[o + BLOCK * ROWS]);
                double left = own - pinLevers.couple(pinOf[k], pins.isFirst(pinOf[k], a) ? turnA : turnB, pins.isFirst(pinOf[k], a) ? turnB : turnA, levers, 2 * k);
                if (!(left > SINGULAR * own)) {
                    levers[2 * k] = 0;
                    levers[2 * k + 1] = 0;
                    left = own;
                }
                equations.inverse[ROWS * ROWS * k] = left > 0 ? 1 / left : 0;
            }
        }
    }

    /** The speed of the one row of a constraint, as its pin will have it. */
    double speed(int k, boolean bends) {
        double now = equations.speed(k, 0, state.v());
        return pinOf.length == 0 || pinOf[k] < 0 ? now : now - pins.speed(pinOf[k], levers[2 * k], levers[2 * k + 1], bends);
    }

    /** Gives the bodies an impulse along the row of a constraint, and what its pin makes of it. */
    void push(int k, double by) {
        equations.push(k, 0, by);
        if (pinOf.length > 0 && pinOf[k] >= 0) {
            pins.give(pinOf[k], -levers[2 * k] * by, -levers[2 * k + 1] * by);
        }
    }
}
