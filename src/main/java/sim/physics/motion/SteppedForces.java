// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;

/** The forces of an engine as time stepping asks for them. */
public final class SteppedForces implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Forces forces;
    private final Generators generators;
    private final IntList pushed = new IntList();
    private final SurfaceRows surface;
    private final SpringRows springs;

    /**
     * Takes the forces of a motion, live.
     *
     * @param motion that of the engine
     * @param state the state vectors
     */
    public SteppedForces(Motion motion, State state) {
        this.state = state;
        forces = motion.forces;
        generators = motion.generators;
        surface = new SurfaceRows(state, generators);
        springs = new SpringRows(state, generators);
    }

    /** {@return friction with the plane} */
    public SurfaceRows surface() {
        return surface;
    }

    /** {@return springs that are too stiff to be forces} */
    public SpringRows springs() {
        return springs;
    }

    /** Begins or ends time stepping: all forces are forces, and none was applied. */
    public void leave() {
        springs.forget();
        pushed.clear();
    }

    /** {@return whether forces may change within a step: some generator acts beside uniform fields and friction with the plane} */
    public boolean areUneven() {
        return generators.driving().size() > (generators.surface == null ? 0 : 1);
    }

    /**
     * Marks the bodies under forces that may change within a step.
     *
     * @param bodies movable ones
     * @param marks by body
     */
    public void markUneven(IntList bodies, boolean[] marks) {
        for (int k = 0; k < bodies.size; k++) {
            marks[bodies.values[k]] |= generators.drive(state.body(bodies.values[k]));
        }
    }

    /**
     * The accelerations of all forces but friction with the plane.
     *
     * @param bodies movable ones
     * @param t simulated time
     * @param a takes the accelerations, [x″, y″, θ″] per body of the state
     */
    public void load(IntList bodies, double t, double[] a) {
        generators.accelerate(state, bodies, t, forces, a, generators.surface);
    }

    /**
     * Takes a body in that was written: what is applied to it acts for a step.
     *
     * @param body index
     */
    public void admit(int body) {
        if (state.body(body).isPushed()) {
            pushed.add(body);
        }
    }

    /** Begins a step, within which bodies change their places without notice. */
    public void begin() {
        state.setUnsettled(true);
    }

    /** Ends it: the forces that were applied for it have acted. */
    public void end() {
        forces.clearApplied(pushed);
        pushed.clear();
        state.setUnsettled(false);
    }
}
