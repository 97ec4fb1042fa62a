// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;

/**
 * What all but the heap does to bodies. A heap on which one uniform field acts and nothing else, and which touches nothing fixed, is seen by one
 * who falls with it: no force acts on it then.
 */
final class HeapPull implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Motion motion;
    private final double[] fall = new double[State.BLOCK];
    private final double[] first = new double[State.BLOCK];

    /** Whether the heap that was found last is seen so. */
    private boolean isFalling;

    HeapPull(State state, Motion motion) {
        this.state = state;
        this.motion = motion;
    }

    /** The acceleration that a body has. */
    double of(int body) {
        if (state.body(body).isImmobile()) {
            return 0;
        }
        motion.fall(body, fall, 0);
        return Math.sqrt(fall[0] * fall[0] + fall[1] * fall[1]);
    }

    /** Sees a heap, of which nothing is known yet, as one who stands. */
    void stand() {
        isFalling = false;
    }

    /**
     * Falls with the bodies of a heap that touches nothing fixed, if all that acts on them is one field.
     *
     * @return whether it is
     */
    boolean fallWith(IntList heap) {
        isFalling = true;
        motion.fall(heap.values[0], first, 0);
        for (int k = 0; k < heap.size && isFalling; k++) {
            motion.fall(heap.values[k], fall, 0);
            isFalling = fall[0] == first[0] && fall[1] == first[1] && fall[2] == 0;
        }
        return isFalling;
    }

    /** {@return whether one falls with the heap that was found last} */
    boolean isFalling() {
        return isFalling;
    }

    /** The acceleration of a body of the heap, as it is seen. */
    void give(int body, double[] a) {
        Arrays.fill(a, 0);
        if (!isFalling) {
            motion.fall(body, a, 0);
        }
    }

    /** The same, that of its centre. */
    double seen(int body) {
        return isFalling ? 0 : of(body);
    }

    /** The greatest of these. */
    double most(IntList heap) {
        double most = 0;
        for (int k = 0; k < heap.size; k++) {
            most = Math.max(most, seen(heap.values[k]));
        }
        return most;
    }

    /** Whether a force is seen to act on a body of the heap. */
    boolean isOnAny(IntList heap) {
        boolean yes = false;
        for (int k = 0; k < heap.size && !yes; k++) {
            give(heap.values[k], fall);
            yes = fall[0] != 0 || fall[1] != 0 || fall[2] != 0;
        }
        return yes;
    }

    /** Lets a body go on without acceleration. */
    void endFor(int body) {
        motion.fall(body, fall, 0);
        motion.support(body, -fall[0], -fall[1], -fall[2]);
    }

    /** The same, as it is seen. */
    void endSeen(int body) {
        give(body, fall);
        motion.support(body, -fall[0], -fall[1], -fall[2]);
    }
}
