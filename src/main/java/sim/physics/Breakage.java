// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Constraints;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;
import sim.physics.response.lasting.Heaps;
import sim.physics.response.lasting.RestingContacts;

/**
 * Cuts joints whose load is greater than they bear, where events are found. The load is looked at when a step begins: all that break
 * then do so at that instant, also those that bear what others bore. Where bodies lie on something, what their contacts give them is
 * known only when the step has been made. The same holds for bodies that are new where they are. So islands with such bodies are
 * looked at when the step is over.
 */
final class Breakage implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final RestingContacts resting;
    private final Heaps heaps;

    /** Bodies of which it was not known when the step began what contacts give them; nothing outlasts the step. */
    private transient boolean[] areUnsure;

    /** The accelerations that are found. */
    private transient double[] found;

    Breakage(
            State state,
            Trajectories trajectories,
            Motion motion,
            CollisionDetection detection,
            RestingContacts resting,
            Heaps heaps) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        this.resting = resting;
        this.heaps = heaps;
    }

    /** Begins a step, before changes of authors are let in. */
    void begin(Constraints constraints, Admission admission) {
        if (constraints == null || !constraints.isBreakable() && admission.areOnlyPushes()) {
            return;
        }
        int n = state.size();
        if (areUnsure == null || areUnsure.length < n) {
            areUnsure = new boolean[2 * n];
        }
        for (int k = 0; k < areUnsure.length; k++) {
            areUnsure[k] = k < n && lies(k);
        }
        for (int k = 0; k < state.touchedCount(); k++) {
            int body = state.touched(k);
            areUnsure[body] |= !detection.knows(body) || !trajectories.isAt(body, 0, state, 0);
        }
    }

    private boolean lies(int body) {
        return resting.rests(body) || heaps.has(body);
    }

    /** Cuts the joints that break at the start of a step, when changes have been let in; true if one did. */
    boolean breakJoints(Constraints constraints, double time) {
        if (constraints == null || !constraints.isBreakable()) {
            return false;
        }
        boolean broken = false;
        found = found == null || found.length < state.x().length ? new double[state.x().length] : found;
        for (IntList island : constraints.breakable()) {
            if (isUnsure(island)) {
                continue;
            }
            motion.acceleration(island, time, found);
            broken |= cut(constraints, island);
        }
        return broken;
    }

    private boolean isUnsure(IntList island) {
        boolean yes = false;
        for (int k = 0; !yes && k < island.size; k++) {
            yes = areUnsure == null || island.values[k] >= areUnsure.length || areUnsure[island.values[k]];
        }
        return yes;
    }

    private static boolean cut(Constraints constraints, IntList island) {
        boolean broken = false;
        for (Constraint c : constraints.overloaded(island)) {
            broken |= constraints.remove(c);
        }
        return broken;
    }

    /** Cuts the joints that break when a step is over, which has told what contacts give. */
    void end(Constraints constraints, Admission admission, double time) {
        if (constraints == null || constraints.isChanged() || !constraints.isBreakable()) {
            return; // a listener has changed the islands at the end of the step: they are looked at in the next one
        }
        for (IntList island : constraints.breakable()) {
            if (isUnsure(island) || lie(island)) {
                admission.answer(island, time);
                cut(constraints, island);
            }
        }
    }

    private boolean lie(IntList island) {
        boolean yes = false;
        for (int k = 0; !yes && k < island.size; k++) {
            yes = lies(island.values[k]);
        }
        return yes;
    }
}
