// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;

/** What collision detection notes of each body, a byte per body. */
public final class BodyNotes implements Serializable {
    private static final long serialVersionUID = 1L;

    /** It has been taken in. */
    public static final int KNOWN = 1;

    /** None of its pairs need be looked at. */
    public static final int IDLE = 2;

    /** It collides with nothing, and may leave its box. */
    public static final int ALOOF = 4;

    /** It is a wall. */
    static final int FIXED = 8;

    /** Many are near it. */
    public static final int CROWDED = 16;

    private byte[] notes = new byte[8];

    BodyNotes() {
        // the array grows with the bodies
    }

    void ensure(int bodies) {
        if (bodies > notes.length) {
            notes = Arrays.copyOf(notes, Growth.length(notes.length, bodies));
        }
    }

    /**
     * Whether something is noted of a body.
     *
     * @param body index
     * @param what one of the constants
     * @return true from the one {@link #set} to the other
     */
    public boolean has(int body, int what) {
        return (notes[body] & what) != 0;
    }

    /**
     * Whether something is noted of all of some bodies.
     *
     * @param what one of the constants
     * @param bodies indices
     * @return true if there is none of which it is not noted
     */
    public boolean areAll(int what, IntList bodies) {
        byte[] all = notes;
        int yes = what;
        for (int k = 0; k < bodies.size; k++) {
            yes &= bodies.values[k] < all.length ? all[bodies.values[k]] : 0; // of one that is about to come in nothing is noted
        }
        return yes == what;
    }

    /**
     * Adds those of some bodies to a list of which something is not noted.
     *
     * @param what one of the constants
     * @param bodies indices
     * @param list grows
     */
    public void addWithout(int what, IntList bodies, IntList list) {
        byte[] all = notes;
        for (int k = 0; k < bodies.size; k++) {
            int body = bodies.values[k];
            if ((all[body] & what) == 0) {
                list.add(body);
            }
        }
    }

    /**
     * Notes something of a body.
     *
     * @param body index
     * @param what one of the constants
     * @param yes whether it is so
     */
    public void set(int body, int what, boolean yes) {
        notes[body] = (byte) (yes ? notes[body] | what : notes[body] & ~what);
    }

    /**
     * Whether a body has been taken in.
     *
     * @param body any index
     * @return true if it is {@link #KNOWN}
     */
    public boolean knows(int body) {
        return body < notes.length && has(body, KNOWN);
    }
}
