// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.Trajectories;

/** When the velocities of bodies have jumped last in a step: their motion is smooth from then on only. */
final class Strikes implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Trajectories trajectories;

    /** The number of the step, and the offset in it. */
    private double[] step = {};

    private double[] offset = {};

    Strikes(Trajectories trajectories) {
        this.trajectories = trajectories;
    }

    /** Takes note of bodies whose velocities have just been changed at their anchors. */
    void note(IntList bodies) {
        if (trajectories.areStraight()) {
            return; // nobody asks, since nothing has ever been driven
        }
        for (int k = 0; k < bodies.size; k++) {
            int body = bodies.values[k];
            if (body >= step.length) {
                step = Arrays.copyOf(step, Math.max(2 * step.length, body + 1));
                offset = Arrays.copyOf(offset, step.length);
            }
            step[body] = trajectories.step();
            offset[body] = trajectories.offset(body);
        }
    }

    /** The offset of a body's last jump in this step, 0 if there was none. */
    double last(int body) {
        return body < step.length && step[body] == trajectories.step() ? offset[body] : 0;
    }
}
