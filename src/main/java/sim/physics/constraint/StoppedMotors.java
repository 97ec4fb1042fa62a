// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.internal.IntList;

/**
 * Motors whose coordinate has a stop. Where the stop asks for another speed than the motor keeps, what both ask for contradicts: a bounce would have
 * been halved, or not be one at all. No motor is as strong as an impact.
 */
final class StoppedMotors implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Switched[] rows;
    private final int[] nodes;

    /** Places of motors and stops of the same coordinates, in turn; ~ a stop whose coordinate goes the other way. */
    private final IntList pairs = new IntList();

    StoppedMotors(Switched[] rows, int[] nodes) {
        this.rows = rows;
        this.nodes = nodes;
        for (int k = 0; k < rows.length; k++) {
            for (int m = 0; rows[k] instanceof Motor && m < rows.length; m++) {
                double sense = rows[m] instanceof Limit ? rows[k].sense(rows[m]) : 0;
                if (sense != 0) {
                    pairs.add(k);
                    pairs.add(sense > 0 ? m : ~m);
                }
            }
        }
    }

    /**
     * Lets motors keep no speed that a stop of their coordinate does not allow: they push from then on.
     *
     * @param bias −(the speed that a row keeps), 2 per node
     */
    void giveWay(double[] bias) {
        for (int k = 0; k < pairs.size; k += 2) {
            Switched motor = rows[pairs.values[k]];
            int at = pairs.values[k + 1];
            int stop = at < 0 ? ~at : at;
            double allowed = at < 0 ? bias[2 * nodes[stop]] : -bias[2 * nodes[stop]];
            if (motor.isOnNow && rows[stop].isOnNow && motor.target() != allowed) {
                motor.isOn = false;
                motor.isOnNow = false;
                motor.force = motor.target() > allowed ? motor.greatest() : motor.least();
                bias[2 * nodes[pairs.values[k]]] = 0;
            }
        }
    }
}
