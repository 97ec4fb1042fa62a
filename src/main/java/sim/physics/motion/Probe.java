// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * Where probes of groups have ended. The last one that was made, to find what contacts push with, is the step itself if the
 * forces turned out to be those under which it was made.
 */
final class Probe implements Serializable {
    private static final long serialVersionUID = 1L;

    private double[] endX = {};
    private double[] endV = {};

    /** By the first body of a group: how far the last probe went. */
    private double[] length = {};

    /** By body: whether the last probe is to count. */
    private boolean[] counts = {};

    /** Whether accelerations at the start are known of a probe, by the first body; and of the one that was taken. */
    private boolean[] knows = {};

    private boolean knowsFirst;

    Probe() {
        // grows with the state
    }

    /** Takes note of where a probe has ended. */
    void note(IntList group, State state, double done, boolean isFirstKnown) {
        if (endX.length < state.x().length) {
            endX = Arrays.copyOf(endX, state.x().length);
            endV = Arrays.copyOf(endV, state.x().length);
            length = Arrays.copyOf(length, state.x().length / State.BLOCK);
            counts = Arrays.copyOf(counts, length.length);
            knows = Arrays.copyOf(knows, length.length);
        }
        for (int k = 0; k < group.size; k++) {
            int b = State.BLOCK * group.values[k];
            counts[group.values[k]] = false;
            System.arraycopy(state.x(), b, endX, b, State.BLOCK);
            System.arraycopy(state.v(), b, endV, b, State.BLOCK);
        }
        length[group.values[0]] = done;
        knows[group.values[0]] = isFirstKnown;
    }

    /** Whether the last probe of a group went that far, and nothing has moved it since. */
    boolean isOf(int first, double time) {
        return first < length.length && length[first] == time;
    }

    /** Lets the last probe of a group count. */
    void keep(IntList group) {
        for (int k = 0; k < group.size; k++) {
            counts[group.values[k]] = true;
        }
    }

    /** Puts the end of a probe that counts into the state vectors; false if there is none. */
    boolean take(IntList group, State state) {
        int first = group.values[0];
        if (!doesCount(group)) {
            return false;
        }
        for (int k = 0; k < group.size; k++) {
            int b = State.BLOCK * group.values[k];
            System.arraycopy(endX, b, state.x(), b, State.BLOCK);
            System.arraycopy(endV, b, state.v(), b, State.BLOCK);
        }
        knowsFirst = knows[first];
        cut(first);
        return true;
    }

    /** Whether the last probe of a group is the motion itself. */
    boolean doesCount(IntList group) {
        boolean yes = group.values[0] < counts.length;
        for (int k = 0; yes && k < group.size; k++) {
            yes = counts[group.values[k]];
        }
        return yes;
    }

    /** Whether accelerations at the start are known of the probe that was taken. */
    boolean knowsFirst() {
        return knowsFirst;
    }

    /** Something happens to a body: probes of its group do not count any more. */
    void cut(int body) {
        if (body < length.length) {
            counts[body] = false;
        }
    }
}
