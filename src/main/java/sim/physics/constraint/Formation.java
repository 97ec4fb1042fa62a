// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import sim.physics.motion.Body;

/** The islands of some constraints, kept for when what is tried between steps is refused: they know more than how to form them. */
public final class Formation {
    private final Constraints constraints;
    private final List<TiedGroup> groups = new ArrayList<>();
    private final LinkedHashSet<Constraint> changed = new LinkedHashSet<>();
    private TiedGroup[] of = {};
    private long grouping;
    private boolean isSomeDissolved;

    /** Motors and stops, and what was decided of each: it is decided anew in islands that are formed anew. */
    private final List<Switched> switched = new ArrayList<>();

    private double[] decided = {};

    private Formation(Constraints constraints) {
        this.constraints = constraints;
    }

    /**
     * Keeps those of the moment, until others are kept.
     *
     * @param constraints whose
     * @param those that are about to be added
     * @return what puts them back
     */
    public static Formation keep(Constraints constraints, Constraint... those) {
        Register register = constraints.register;
        register.formation = register.formation == null ? new Formation(constraints) : register.formation;
        register.formation.keep(those);
        return register.formation;
    }

    private void keep(Constraint... those) {
        groups.clear();
        groups.addAll(constraints.groups);
        of = of.length == constraints.of.length ? of : new TiedGroup[constraints.of.length];
        System.arraycopy(constraints.of, 0, of, 0, of.length);
        grouping = constraints.grouping;
        changed.clear();
        changed.addAll(constraints.register.changed);
        isSomeDissolved = constraints.register.isSomeDissolved;
        switched.clear();
        for (Constraint c : changed) {
            note(c);
        }
        for (Constraint c : those) {
            note(c);
        }
        decided = decided.length < Switched.MEMORY * switched.size() ? new double[Switched.MEMORY * switched.size()] : decided;
        for (int k = 0; k < switched.size(); k++) {
            switched.get(k).keep(decided, Switched.MEMORY * k);
        }
    }

    /** Takes note of the motors and stops in the islands that a change of a constraint concerns. */
    private void note(Constraint c) {
        note(List.of(c));
        for (Body body : new Body[] {c.getBodyA(), c.getBodyB()}) {
            boolean isTied = body != null && !body.isImmobile() && body.index() < of.length && of[body.index()] != null;
            if (isTied) {
                note(of[body.index()].constraints);
            }
        }
    }

    private void note(List<Constraint> some) {
        for (int k = 0; k < some.size(); k++) {
            if (some.get(k) instanceof Switched row) {
                switched.add(row);
            }
        }
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
        for (int k = 0; k < switched.size(); k++) {
            switched.get(k).restore(decided, Switched.MEMORY * k);
        }
    }
}
