// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import sim.physics.motion.Body;

/**
 * The constraints of an engine in the order in which time stepping solves them: pins apart, stops after the motors of their bodies, and those of
 * sleeping bodies last.
 */
final class TieOrder implements Serializable {
    private static final long serialVersionUID = 1L;

    /** No place. */
    static final int NONE = Integer.MIN_VALUE;

    final List<PinJoint> pins = new ArrayList<>();
    final List<Constraint> others = new ArrayList<>();

    /** How many of both, from the first one on, are of bodies that are awake. */
    int awakePins;

    int awakeOthers;

    /** The place of each, of those that are no pins ~ its place; null until somebody asks. */
    private transient Map<Constraint, Integer> places;

    void clear() {
        places = null;
        pins.clear();
        others.clear();
        awakePins = 0;
        awakeOthers = 0;
    }

    /**
     * Takes constraints.
     *
     * @param asleep by body
     */
    void sort(List<Constraint> all, boolean[] asleep) {
        clear();
        sort(all, asleep, false);
        awakePins = pins.size();
        awakeOthers = others.size();
        sort(all, asleep, true);
    }

    /** The place of a constraint among the pins, or ~ that among the others, or {@link #NONE}. */
    int place(Constraint constraint) {
        if (places == null) {
            places = new HashMap<>();
            for (int k = 0; k < pins.size(); k++) {
                places.put(pins.get(k), k);
            }
            for (int k = 0; k < others.size(); k++) {
                places.put(others.get(k), ~k);
            }
        }
        return places.getOrDefault(constraint, NONE);
    }

    /** The bodies of a constraint that can move, in whichever order: a key for those between the same ones. */
    static long bodies(Constraint tie) {
        long a = index(tie.getBodyA());
        long b = index(tie.getBodyB());
        return Math.min(a, b) << Integer.SIZE | Math.max(a, b) & 0xFFFFFFFFL;
    }

    private static int index(Body body) {
        return body == null || body.isImmobile() ? -1 : body.index();
    }

    private void sort(List<Constraint> all, boolean[] asleep, boolean areAsleep) {
        Set<Long> driven = new HashSet<>();
        for (Constraint tie : all) {
            if (tie instanceof Motor) {
                driven.add(bodies(tie));
            }
        }
        List<Constraint> stops = new ArrayList<>();
        for (Constraint tie : all) {
            boolean isAsleep = asleep[tie.getBodyA().index()] || tie.getBodyB() != null && asleep[tie.getBodyB().index()];
            if (isAsleep == areAsleep && tie instanceof PinJoint pin) {
                pins.add(pin);
            } else if (isAsleep == areAsleep) {
                (tie instanceof Limit && driven.contains(bodies(tie)) ? stops : others).add(tie);
            }
        }
        others.addAll(stops);
    }
}
