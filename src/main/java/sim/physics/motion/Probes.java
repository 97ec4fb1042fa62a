// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;

/** Integrations of driven bodies that show where forces would lead. */
public final class Probes implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Motion motion;
    private final Trajectories trajectories;

    /**
     * Makes the probes of an engine.
     *
     * @param state the state vectors
     * @param motion moves the bodies
     * @param trajectories has their anchors
     */
    public Probes(State state, Motion motion, Trajectories trajectories) {
        this.state = state;
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

    /**
     * Whether a body, where it stands still, would stay there under its contacts: nothing acts on it but those, uniform fields and ties.
     *
     * @param body index of a driven body
     * @return false also where constraints are an author's, which may change by themselves, and while somebody audits the engine
     */
    public boolean mayRest(int body) {
        boolean isAlone = !state.isPushed(body) && !motion.generators.drive(state.body(body));
        return isAlone && motion.isTied(body) && motion.ties.mayBeShared(motion.companions(body)) && !motion.drivenMotion.isObserved();
    }

    /**
     * Lets a body stay where it is, with those that move with it if they all do, until something happens to it.
     *
     * @param body index
     */
    public void rest(int body) {
        motion.drivenMotion.repose.begin(body);
    }

    /**
     * Ends that.
     *
     * @param body index
     */
    public void stir(int body) {
        motion.drivenMotion.repose.end(body);
    }

    /**
     * Whether a body stays where it is.
     *
     * @param body index
     * @return false if something has happened to it, or somebody audits the engine
     */
    public boolean rests(int body) {
        return motion.drivenMotion.repose.has(body) && !motion.drivenMotion.isObserved();
    }
}
