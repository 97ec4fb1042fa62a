// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos;

import java.awt.Color;
import sim.engine.SimState;
import sim.engine.Steppable;
import sim.physics.PhysicsEngine;
import sim.physics.Repeating;
import sim.physics.motion.Body;

/** What the demos have in common: an engine, and what its picture looks like. */
public abstract class Scene extends SimState {
    private static final long serialVersionUID = 1L;

    /** The world is a square of this size. */
    public static final double WORLD = 200;

    public PhysicsEngine physics;

    private int substeps;

    protected Scene(long seed) {
        super(seed);
    }

    @Override
    public void start() {
        super.start();
        physics = new PhysicsEngine();
        physics.setTimeStepping(substeps);
        build();
        physics.scheduleOn(schedule);
    }

    /** Substeps of time stepping; 0: events. */
    public int getSubsteps() {
        return substeps;
    }

    /** Takes effect at once. */
    public void setSubsteps(int number) {
        if (number < 0 || number > 100) {
            throw new IllegalArgumentException("substeps is " + number + ": it must be from 0 to 100");
        }
        if (physics != null) {
            physics.setTimeStepping(number);
        }
        substeps = number;
    }

    /** Puts the bodies into the engine. */
    protected abstract void build();

    public abstract Color ground();

    public abstract Color colour(Body body);

    /** Runs something in every step of the schedule from its start on. */
    protected final void repeat(Steppable agent, int ordering) {
        schedule.scheduleOnce(schedule.getTime() < 0 ? 0 : schedule.getTime() + 1, ordering, new Repeating(agent, ordering, 1));
    }
}
