// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.List;

/**
 * A source of forces, evaluated at every stage of the integrator: the f and τ of (5) and (6).
 *
 * <p>Generators are part of a checkpoint. So make them named classes, not lambdas, whose serialized form depends on the compiler.
 * A generator must not keep state that changes from call to call, since stages may be evaluated again.
 */
public interface ForceGenerator extends Serializable {

    /**
     * Adds the force on one body, and on no other body: each has its own turn. The body's getters give its position and velocity
     * at the instant of the evaluation. With {@link #isCoupled()}, so do those of all bodies on which a generator acts.
     *
     * @param body the body to add the force on
     * @param time simulated time of the evaluation
     * @param forces the object that takes the force
     */
    void addForce(Body body, double time, Forces forces);

    /**
     * Returns whether this generator ever acts on a body. Bodies on which no generator acts move freely, without an integrator.
     * Do not use this to switch a force that begins or ends with the time, or with the place of a body. Let {@link #addForce} add
     * nothing instead.
     *
     * <p>This is asked when the body or the generator is added, and again after properties of the body have been set, but not in
     * each step.
     *
     * @param body a movable body
     * @return true for all bodies, unless overridden
     */
    default boolean actsOn(Body body) {
        return true;
    }

    /**
     * Returns the only bodies that this generator ever acts on, if these are always the same. Then it is not asked about others,
     * and many such generators on many bodies cost no more than there are forces.
     *
     * @return the bodies; null, unless overridden: then {@link #actsOn} is asked about every body
     */
    default List<Body> getBodies() {
        return null;
    }

    /**
     * Returns whether the force on a body depends on other bodies that move. Bodies that are coupled, directly, through others or
     * through joints, are integrated together. This is asked when the generator is added and at the start of each step.
     *
     * <p>Where it should be true and is not, other bodies are read where they were at some instant of the step, and the motion is
     * right to first order in the step only, whatever the method.
     *
     * @return false, unless overridden
     */
    default boolean isCoupled() {
        return false;
    }

    /**
     * Returns the bodies that this generator couples, if these are always the same few. Other bodies move as if it were not
     * there. While joints tie all of these bodies together, directly or through others, the generator couples nothing more than
     * the joints do.
     *
     * @return {@link #getBodies()}, unless overridden; null for all bodies on which it acts
     */
    default List<Body> getCoupledBodies() {
        return getBodies();
    }

    /**
     * Returns the energy that this generator stores now, so that an audit of the engine does not take it for a loss. The engine
     * knows the energy of uniform fields.
     *
     * @return potential energy for the places where its bodies are; 0, unless overridden: then all that its forces do is work
     */
    default double energy() {
        return 0;
    }

    /**
     * Returns whether the forces depend on nothing but positions, velocities and properties of bodies. They are then the same
     * whenever these are. They must not depend on the time, nor on anything that changes from outside without a body being set.
     *
     * <p>A method that chooses its steps may follow such forces beyond the end of the engine's step, as far as its tolerance
     * allows. That costs less where the engine's step is short. Changes that are made between steps still act at once. The forces
     * are then also asked for at places that the body may never reach, as they are for rejected steps. Under time stepping,
     * bodies sleep only if all forces on them are autonomous.
     *
     * @return false, unless overridden: then no force is asked for beyond the engine's step
     */
    default boolean isAutonomous() {
        return false;
    }

    /**
     * Returns whether several threads may ask for the forces on different bodies at the same time, see
     * {@code PhysicsEngine.setThreads}. This requires that {@link #addForce} and {@link #actsOn} write nothing but the force on
     * that body, and that they read nothing else that changes within a step than that body.
     *
     * @return false, unless overridden: then only the stepping thread calls them
     */
    default boolean isConcurrent() {
        return false;
    }
}
