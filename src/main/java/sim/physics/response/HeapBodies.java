// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.Arrays;

/** What {@link Heaps} knows of bodies, by their indices. */
final class HeapBodies implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Whether a body lies in a heap, stands still there, and is to be solved for. */
    boolean[] lies = {};

    boolean[] isStill = {};
    boolean[] isDirty = {};

    /** Until when it has got what the forces give it, as an offset in the step. */
    double[] paidUntil = {};

    /** How often something has happened to it in this step, and the energy that it has lost in heaps. */
    int[] turns = {};

    double[] lost = {};

    /** Its number in the heap that is being solved, plus 1. */
    int[] place = {};

    HeapBodies() {
        // empty until something lies on something
    }

    boolean has(int body) {
        return body < lies.length && lies[body];
    }

    void ensure(int body) {
        if (body >= lies.length) {
            int n = Math.max(2 * lies.length, body + 1);
            lies = Arrays.copyOf(lies, n);
            isStill = Arrays.copyOf(isStill, n);
            isDirty = Arrays.copyOf(isDirty, n);
            paidUntil = Arrays.copyOf(paidUntil, n);
            turns = Arrays.copyOf(turns, n);
            lost = Arrays.copyOf(lost, n);
            place = Arrays.copyOf(place, n);
        }
    }

    /** Begins a step, or a body's time in a heap. */
    void begin(int body) {
        paidUntil[body] = 0;
        turns[body] = 0;
        lost[body] = 0;
    }
}
