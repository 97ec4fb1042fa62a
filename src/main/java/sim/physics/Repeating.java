// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.util.Objects;
import sim.engine.SimState;
import sim.engine.Steppable;
import sim.engine.Stoppable;
import sim.physics.internal.Check;

/**
 * Repeats a Steppable on MASON's schedule, by scheduling itself again each time. The schedule's own methods for that are not
 * used, because they changed between versions of MASON in a way that breaks compiled libraries.
 */
public final class Repeating implements Steppable, Stoppable {
    private static final long serialVersionUID = 1L;

    private Steppable target;
    private final int ordering;
    private final double interval;

    /**
     * Creates a repetition. Schedule it once to start it.
     *
     * @param target the object to step repeatedly
     * @param ordering ordering on the schedule
     * @param interval schedule time between repetitions, greater than 0
     * @throws IllegalArgumentException if the interval is not a finite number greater than 0
     */
    public Repeating(Steppable target, int ordering, double interval) {
        this.target = Objects.requireNonNull(target, "target");
        this.ordering = ordering;
        this.interval = Check.positive("interval", interval);
    }

    @Override
    public void step(SimState model) {
        if (target != null) {
            model.schedule.scheduleOnce(model.schedule.getTime() + interval, ordering, this);
            target.step(model);
        }
    }

    @Override
    public void stop() {
        target = null;
    }
}
