// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * Driven bodies that stand still on others: their contacts and joints hold them where they are, with forces that were found when they
 * came to rest. They stay there, and nothing is integrated, until something happens to one of them.
 */
final class Repose implements Serializable {
    private static final long serialVersionUID = 2L;

    /** A body rests, and its path says so already. */
    private static final byte STAYS = 2;

    private static final byte RESTS = 1;

    private byte[] rests = {};

    Repose() {
        // grows when one rests
    }

    /** Shares what another one notes. */
    void match(Repose other) {
        rests = other.rests;
    }

    void begin(int body) {
        rests = body < rests.length ? rests : Arrays.copyOf(rests, 2 * body + 1);
        rests[body] = RESTS;
    }

    /** Something happens to a body. */
    void end(int body) {
        if (body < rests.length) {
            rests[body] = 0;
        }
    }

    boolean has(int body) {
        return body < rests.length && rests[body] != 0;
    }

    /** Whether all bodies of a group rest. */
    boolean hasAll(IntList group) {
        boolean yes = has(group.values[0]);
        for (int k = 1; yes && k < group.size; k++) {
            yes = has(group.values[k]);
        }
        return yes;
    }

    /** Whether all bodies of a group rest, and have been given paths that say so since they do. */
    boolean areStaying(IntList group) {
        boolean yes = true;
        for (int k = 0; yes && k < group.size; k++) {
            yes = group.values[k] < rests.length && rests[group.values[k]] == STAYS;
        }
        return yes;
    }

    /** The paths of bodies that rest, or do so for now, and stay where the state vectors have them. */
    void stay(IntList group, State state, Path path) {
        path.ensure(state.x().length);
        for (int k = 0; k < group.size; k++) {
            if (has(group.values[k])) {
                rests[group.values[k]] = STAYS;
            }
            int b = State.BLOCK * group.values[k];
            for (int c = b; c < b + State.BLOCK; c++) {
                path.straight(c);
                state.v()[c] = 0;
            }
        }
    }
}
