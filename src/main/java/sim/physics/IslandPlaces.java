// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Constraints;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.Reach;
import sim.physics.motion.State;

/** Where the islands of some constraints are before they are closed: theirs alone, as a scene may close thousands one by one. */
final class IslandPlaces {
    private final State state;
    private final Constraints constraints;
    private final List<IntList> islands = new ArrayList<>();
    private final List<double[]> places = new ArrayList<>();

    IslandPlaces(State state, Constraints constraints, Constraint... those) {
        this.state = state;
        this.constraints = constraints;
        for (Constraint c : those) {
            Body body = c.getBodyA().isImmobile() ? c.getBodyB() : c.getBodyA();
            islands.add(constraints.island(body.index()));
        }
        Map<IntList, double[]> found = new IdentityHashMap<>();
        for (IntList island : islands) {
            places.add(found.computeIfAbsent(island, this::copy));
        }
    }

    /** Closes the constraints, one after the other. */
    void assemble() {
        islands.forEach(island -> constraints.assemble(island, Reach.ANYWHERE));
    }

    private double[] copy(IntList island) {
        double[] kept = new double[2 * State.BLOCK * island.size];
        for (int k = 0; k < island.size; k++) {
            int b = State.BLOCK * island.values[k];
            System.arraycopy(state.x(), b, kept, 2 * State.BLOCK * k, State.BLOCK);
            System.arraycopy(state.v(), b, kept, 2 * State.BLOCK * k + State.BLOCK, State.BLOCK);
        }
        return kept;
    }

    void putBack() {
        for (int m = 0; m < islands.size(); m++) {
            IntList island = islands.get(m);
            for (int k = 0; k < island.size; k++) {
                int b = State.BLOCK * island.values[k];
                System.arraycopy(places.get(m), 2 * State.BLOCK * k, state.x(), b, State.BLOCK);
                System.arraycopy(places.get(m), 2 * State.BLOCK * k + State.BLOCK, state.v(), b, State.BLOCK);
            }
        }
        state.placedAll();
    }
}
