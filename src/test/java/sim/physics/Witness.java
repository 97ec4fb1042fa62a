// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;

/** No force on one body; counts how often it is asked for, and notes the last instant. */
public final class Witness implements ForceGenerator {
    private static final long serialVersionUID = 1L;

    private final Body watched;
    private final boolean autonomous;
    private long calls;
    private double last;

    public Witness(Body watched, boolean autonomous) {
        this.watched = watched;
        this.autonomous = autonomous;
    }

    @Override
    public boolean actsOn(Body body) {
        return body == watched;
    }

    @Override
    public boolean isAutonomous() {
        return autonomous;
    }

    @Override
    public void addForce(Body body, double time, Forces forces) {
        calls++;
        last = Math.max(last, time);
    }

    /** How often it was asked for. */
    public long calls() {
        return calls;
    }

    /** The last instant for which it was. */
    public double last() {
        return last;
    }
}
