// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.List;
import sim.physics.internal.IntList;

/** The forces of an engine as time stepping asks for them. */
public final class SteppedForces implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Forces forces;
    private final Generators generators;
    private final Applied pushed;
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
        pushed = new Applied(state);
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
        pushed.forget();
    }

    /** {@return whether forces may change within a step: some generator acts beside uniform fields and friction with the plane} */
    public boolean areUneven() {
        return generators.driving().size() > (generators.surface == null ? 0 : 1);
    }

    /** {@return whether some force on a body may change as another one is moved by forces} */
    public boolean areCoupled() {
        boolean any = false;
        for (int k = 0; !any && generators.coupled && k < generators.driving().size(); k++) {
            Generators.Entry entry = generators.driving().get(k);
            any = entry.isCoupled && (entry.couples == null || couplesSeveral(entry.couples));
        }
        return any;
    }

    private static boolean couplesSeveral(List<Body> bodies) {
        int count = 0;
        for (int k = 0; k < bodies.size(); k++) {
            count += bodies.get(k).isDynamic() ? 1 : 0;
        }
        return count > 1;
    }

    /**
     * The accelerations of all forces but friction with the plane.
     *
     * @param bodies movable ones
     * @param t simulated time
     * @param a takes the accelerations, [x″, y″, θ″] per body of the state
     */
    public void load(IntList bodies, double t, double[] a) {
        forces.soften(0, Double.POSITIVE_INFINITY); // or a second friction with the plane is what was asked for last, by events or a reaction
        generators.accelerate(state, bodies, t, forces, a, generators.surface, ++generators.askings);
    }

    /** {@return the acceleration of the uniform fields} */
    public double evenPull() {
        return Math.sqrt(generators.gravityX * generators.gravityX + generators.gravityY * generators.gravityY);
    }

    /**
     * The acceleration against which friction with the plane holds a body.
     *
     * @param body a movable one
     * @return 0 if it does not
     */
    public double hold(Body body) {
        boolean isHeld = generators.surface != null && generators.surface.actsOn(body);
        return isHeld ? body.getSurfaceStaticFriction() * generators.surface.getGravity() : 0;
    }

    /**
     * Whether a force on a body may change though all bodies stay where they are.
     *
     * @param body index of a movable one
     * @return true for forces of authors that do not say that they are autonomous, and for those that couple all bodies
     */
    public boolean mayChange(int body) {
        boolean may = false;
        for (Generators.Entry entry : generators.acting(state.body(body))) {
            ForceGenerator generator = entry.generator;
            boolean couplesAll = entry.couples == null && generator.isCoupled();
            may |= generator != generators.surface && (couplesAll || !generator.isAutonomous());
        }
        return may;
    }

    /**
     * Whether a force on a body may depend on a fixed one.
     *
     * @param body index of a movable one
     * @param fixed another body
     * @return true for springs between them, and for forces of authors
     */
    public boolean feels(int body, Body fixed) {
        boolean may = false;
        for (Generators.Entry entry : generators.acting(state.body(body))) {
            boolean isElsewhere = entry.generator instanceof Spring && !entry.bodies.contains(fixed);
            may |= !isElsewhere && entry.generator != generators.surface && !(entry.generator instanceof ViscousFriction);
        }
        return may;
    }

    /** {@return number of generators that may couple bodies} */
    public int couplings() {
        return generators.driving().size();
    }

    /**
     * The bodies that a generator couples.
     *
     * @param k 0 … couplings() − 1
     * @return live; null if it couples none, or all
     */
    public List<Body> coupled(int k) {
        Generators.Entry entry = generators.driving().get(k);
        return entry.generator.isCoupled() ? entry.couples : null;
    }

    /**
     * Takes a body in that was written: what is applied to it acts for a step.
     *
     * @param body index
     */
    public void admit(int body) {
        pushed.admit(body);
    }

    /** Begins a step, within which bodies change their places without notice. */
    public void begin() {
        state.setUnsettled(true);
    }

    /**
     * Ends it, or a part of it.
     *
     * @param isOver whether it is over: then the forces that were applied for it have acted
     */
    public void end(boolean isOver) {
        if (isOver) {
            pushed.clear();
            pushed.forget();
        }
        state.setUnsettled(false);
    }
}
