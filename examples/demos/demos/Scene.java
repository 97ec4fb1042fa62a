// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos;

import java.awt.Color;
import sim.engine.SimState;
import sim.engine.Steppable;
import sim.field.continuous.Continuous2D;
import sim.physics.PhysicsEngine;
import sim.physics.Repeating;
import sim.physics.mason.FieldMirror;
import sim.physics.motion.Body;

/** What the demos have in common: an engine, and what its picture looks like. */
public abstract class Scene extends SimState {
    private static final long serialVersionUID = 1L;

    /** The world is a square of this size. */
    public static final double WORLD = 200;

    public PhysicsEngine physics;
    public Continuous2D field;

    protected Scene(long seed) {
        super(seed);
    }

    @Override
    public void start() {
        super.start();
        physics = new PhysicsEngine();
        field = new Continuous2D(WORLD, WORLD, WORLD); // walls are as long, and are to be seen from near too
        build();
        physics.scheduleOn(schedule);
    }

    /** Puts the bodies into the engine. */
    protected abstract void build();

    public abstract Color ground();

    public abstract Color colour(Body body);

    /** Runs something in every step of the schedule from its start on. */
    protected final void repeat(Steppable agent, int ordering) {
        schedule.scheduleOnce(schedule.getTime() < 0 ? 0 : schedule.getTime() + 1, ordering, new Repeating(agent, ordering, 1));
    }

    /** Shows the bodies in the field too, for a display. */
    public final void mirror() {
        repeat(new FieldMirror(physics, field), FieldMirror.ORDERING);
    }
}
