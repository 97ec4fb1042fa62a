// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.Set;
import java.util.TreeSet;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;

/** The movable bodies that changes of constraints concern, with those that are tied to them so far. */
final class Concerned {
    private final State state;
    private final Constraints constraints;
    private final TreeSet<Integer> found = new TreeSet<>();

    private Concerned(State state, Constraints constraints) {
        this.state = state;
        this.constraints = constraints;
    }

    /** Their indices in ascending order. */
    static IntList by(Set<Constraint> changed, State state, Constraints constraints) {
        Concerned bodies = new Concerned(state, constraints);
        for (Constraint c : changed) {
            bodies.add(c.getBodyA());
            bodies.add(c.getBodyB());
        }
        IntList list = new IntList();
        bodies.found.forEach(list::add);
        return list;
    }

    private void add(Body body) {
        if (body == null || body.isImmobile() || body.state() != state || !found.add(body.index())) {
            return;
        }
        IntList tied = constraints.isTied(body.index()) ? constraints.island(body.index()) : new IntList();
        for (int k = 0; k < tied.size; k++) {
            found.add(tied.values[k]);
        }
    }
}
