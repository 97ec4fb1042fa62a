// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import sim.physics.PhysicsEngine;
import sim.physics.constraint.Equations;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Rail;

/** A {@link Limit} of an engine as MASON's inspectors see it. */
public class InspectedLimit extends InspectedConstraint {
    private final Limit limit;

    /**
     * Makes the view of stops.
     *
     * @param engine that they are, or were, in
     * @param limit live
     */
    public InspectedLimit(PhysicsEngine engine, Limit limit) {
        super(engine, limit);
        this.limit = limit;
    }

    /** {@return where the coordinate is between its bounds: the travel of a rail, an angle, or by how much a rope is longer than its rod} */
    public double getCoordinate() {
        if (limit.getCoordinate() instanceof Rail rail) {
            return rail.getTravel();
        }
        Equations now = new Equations();
        limit.getCoordinate().evaluate(now);
        return now.value(0);
    }

    /** {@return the lower bound} */
    public double getLower() {
        return limit.getLower();
    }

    /** {@return the upper bound} */
    public double getUpper() {
        return limit.getUpper();
    }

    /** {@return by how much the coordinate is out of its bounds} */
    @Override
    public double getGap() {
        double now = getCoordinate();
        return Math.max(0, Math.max(limit.getLower() - now, now - limit.getUpper()));
    }
}
