// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/** What the constraints of an island do, as its last solve left it. */
final class Reactions implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Constraints that are found one after the other. */
    private static final int FEW = 8;

    private final Island island;
    private final Equations equations = new Equations();

    /** The places of the constraints; null until somebody asks in an island of many. */
    private transient Map<Constraint, Integer> places;

    Reactions(Island island) {
        this.island = island;
    }

    private int place(Constraint constraint) {
        Constraint[] all = island.constraints;
        if (all.length > FEW) {
            if (places == null) {
                places = new IdentityHashMap<>(all.length);
                for (int k = 0; k < all.length; k++) {
                    places.put(all[k], k);
                }
            }
            return places.get(constraint);
        }
        int k = 0;
        while (all[k] != constraint) {
            k++;
        }
        return k;
    }

    /** Jᵀ λ of one constraint on its first body. */
    Reaction of(Constraint constraint) {
        return at(place(constraint));
    }

    private Reaction at(int k) {
        Constraint constraint = island.constraints[k];
        if (constraint instanceof Switched s && !s.isOnNow) {
            return s.reaction(s.forceNow);
        }
        equations.clear();
        constraint.evaluate(equations);
        double[] f = new double[3];
        for (int row = 0; row < constraint.getRows(); row++) {
            double l = island.lambda[2 * island.firstNode[k] + row];
            for (int m = 0; m < 3; m++) {
                f[m] += equations.jA[3 * row + m] * l;
            }
        }
        return new Reaction(f[0], f[1], f[2]);
    }

    /** The joints whose load is greater than they bear. */
    List<Constraint> overloaded() {
        List<Constraint> breaking = new ArrayList<>();
        for (Constraint k : island.inOrder) {
            if (k instanceof Joint joint && joint.isBreakable() && joint.breaksUnder(of(k))) {
                breaking.add(k);
            }
        }
        return breaking;
    }
}
