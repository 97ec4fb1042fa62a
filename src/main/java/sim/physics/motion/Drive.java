// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;

/** What forces, but for those of ties, give driven bodies where they are: it bounds how fast what they press together may hop. */
public final class Drive implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Motion motion;
    private final Trajectories trajectories;
    private double[] a = {};
    private int block;

    /**
     * Makes one that has found nothing.
     *
     * @param motion the motion of the bodies
     * @param trajectories their paths
     */
    public Drive(Motion motion, Trajectories trajectories) {
        this.motion = motion;
        this.trajectories = trajectories;
    }

    /**
     * Finds it for a body.
     *
     * @param body index of a driven one
     */
    public void find(int body) {
        int n = trajectories.data().length / Trajectories.STRIDE * State.BLOCK;
        a = a.length < n ? new double[n] : a;
        block = State.BLOCK * body;
        IntList group = motion.companions(body);
        motion.restore(group);
        motion.load(group, motion.time(trajectories.offset(body)), a);
    }

    /**
     * The acceleration of its centre.
     *
     * @return its size
     */
    public double acceleration() {
        return Math.sqrt(a[block] * a[block] + a[block + 1] * a[block + 1]);
    }

    /**
     * That of its turn.
     *
     * @return its size
     */
    public double turning() {
        return Math.abs(a[block + State.THETA]);
    }
}
