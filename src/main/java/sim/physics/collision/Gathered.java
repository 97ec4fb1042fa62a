// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import sim.physics.collision.broad.BodyNotes;
import sim.physics.internal.IntList;

/** Bodies that get new paths from the start of the step on, often several one after the other: only the last one counts. */
final class Gathered implements Serializable {
    private static final long serialVersionUID = 1L;

    private final BodyNotes notes;
    private final IntList bodies = new IntList();

    Gathered(BodyNotes notes) {
        this.notes = notes;
    }

    void clear() {
        bodies.clear();
    }

    void add(int body, boolean teleported) {
        if (!notes.has(body, BodyNotes.WAITS)) {
            notes.set(body, BodyNotes.WAITS, true);
            bodies.add(body);
        }
        if (teleported) {
            notes.set(body, BodyNotes.TELEPORTED, true);
        }
    }

    /** Tells the broad phase of those that wait. */
    void enclose(Enclosures enclosures, long step, double h) {
        for (int k = 0; k < bodies.size; k++) {
            int body = bodies.values[k];
            boolean waits = notes.has(body, BodyNotes.WAITS);
            boolean teleported = notes.has(body, BodyNotes.TELEPORTED);
            notes.set(body, BodyNotes.WAITS, false);
            notes.set(body, BodyNotes.TELEPORTED, false);
            if (waits && notes.knows(body)) { // or it has been removed since
                enclosures.moved(body, 0, teleported, step, h);
            }
        }
    }

    /** All of them, and others behind them. */
    IntList with(IntList others) {
        for (int k = 0; k < others.size; k++) {
            bodies.add(others.values[k]);
        }
        return bodies;
    }
}
