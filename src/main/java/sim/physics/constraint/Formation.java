// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;

/** The islands of some constraints, kept for when what is tried between steps is refused: they know more than how to form them. */
public final class Formation {
    private final Constraints constraints;
    private final List<TiedGroup> groups = new ArrayList<>();
    private final LinkedHashSet<Constraint> changed = new LinkedHashSet<>();
    private TiedGroup[] of = {};
    private long grouping;
    private boolean isSomeDissolved;

    private Formation(Constraints constraints) {
        this.constraints = constraints;
    }

    /**
     * Keeps those of the moment, until others are kept.
     *
     * @param constraints whose
     * @return what puts them back
     */
    public static Formation keep(Constraints constraints) {
        Register register = constraints.register;
        register.formation = register.formation == null ? new Formation(constraints) : register.formation;
        register.formation.keep();
        return register.formation;
    }

    private void keep() {
        groups.clear();
        groups.addAll(constraints.groups);
        of = of.length == constraints.of.length ? of : new TiedGroup[constraints.of.length];
        System.arraycopy(constraints.of, 0, of, 0, of.length);
        grouping = constraints.grouping;
        changed.clear();
        changed.addAll(constraints.register.changed);
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
        constraints.groups = new ArrayList<>(groups);
        constraints.of = of.clone();
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
