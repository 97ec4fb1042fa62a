// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;

/** The islands of some constraints, kept for when what is tried between steps is refused: they know more than how to form them. */
public final class Formation {
    private final Constraints constraints;
    private final List<TiedGroup> groups;
    private final TiedGroup[] of;
    private final long grouping;
    private final LinkedHashSet<Constraint> changed;
    private final boolean isSomeDissolved;

    /**
     * Keeps those of the moment.
     *
     * @param constraints whose
     */
    public Formation(Constraints constraints) {
        this.constraints = constraints;
        groups = new ArrayList<>(constraints.groups);
        of = constraints.of.clone();
        grouping = constraints.grouping;
        changed = new LinkedHashSet<>(constraints.register.changed);
        isSomeDissolved = constraints.register.isSomeDissolved;
    }

    /**
     * Removes constraints that were added since, and puts the islands back.
     *
     * @param those all of these
     */
    public void putBack(Constraint... those) {
        for (Constraint c : those) {
            constraints.remove(c);
        }
        constraints.changeIslands();
        constraints.groups = groups;
        constraints.of = of;
        constraints.grouping = grouping; // nobody has asked for the others
        constraints.register.changed.clear();
        constraints.register.changed.addAll(changed);
        constraints.register.isSomeDissolved = isSomeDissolved;
        for (int k = 0; k < of.length; k++) {
            if (of[k] != null) {
                of[k].isDissolved = false;
            }
        }
    }
}
