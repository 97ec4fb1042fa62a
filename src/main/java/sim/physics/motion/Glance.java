// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.Tolerances;

/**
 * Where bodies are at an instant within a step, for a listener that reads them then: the state vectors are brought there for those
 * that collide only, and nothing is written for the others.
 */
public final class Glance implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Trajectories trajectories;
    private double now;

    /**
     * Makes one.
     *
     * @param trajectories of the bodies
     */
    public Glance(Trajectories trajectories) {
        this.trajectories = trajectories;
    }

    /**
     * Sets the instant.
     *
     * @param tau offset in the present step
     */
    public void setNow(double tau) {
        now = tau;
    }

    double x(int body, int c) {
        return trajectories.x(body, c, duration(body));
    }

    double v(int body, int c) {
        return trajectories.v(body, c, duration(body));
    }

    /** What collides now may be anchored a little before or after: it is where it was found to touch. */
    private double duration(int body) {
        double d = trajectories.duration(body, now);
        return d > Tolerances.SOON * trajectories.h() ? d : 0;
    }
}
