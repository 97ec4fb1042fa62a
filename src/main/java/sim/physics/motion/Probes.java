// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;

/** Integrations of driven bodies that show where forces would lead. */
public final class Probes implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Motion motion;
    private final Trajectories trajectories;

    /**
     * Makes the probes of an engine.
     *
     * @param motion moves the bodies
     * @param trajectories has their anchors
     */
    public Probes(Motion motion, Trajectories trajectories) {
        this.motion = motion;
        this.trajectories = trajectories;
    }

    /**
     * Moves driven bodies of the state vectors from their anchors on, without paths.
     *
     * @param body index of one of them
     * @param length time
     * @return how far they came at once
     */
    public double probe(int body, double length) {
        return motion.drivenMotion.probe(motion.companions(body), length);
    }

    /**
     * Lets the last probe go for the motion, if it went to the end of the step, and nothing else moves or pushes the bodies before
     * they are advanced.
     *
     * @param body index of one of them
     * @param length time of the probe
     */
    public void keep(int body, double length) {
        IntList group = motion.companions(body);
        int first = group.values[0];
        Probe last = motion.drivenMotion.probed;
        if (last.isOf(first, length) && length == trajectories.h() - trajectories.offset(first)) {
            last.keep(group);
        }
    }
}
