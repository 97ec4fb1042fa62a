// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.List;

/**
 * A source of forces, evaluated at every stage of the integrator: the f and τ of (5) and (6).
 *
 * <p>Generators are part of a checkpoint: make them named classes, not lambdas, whose serialized form depends on the
 * compiler. A generator must not keep state that changes from call to call, since stages may be evaluated again.
 */
public interface ForceGenerator extends Serializable {

    /**
     * Adds the force on one body. The body's getters, and with {@link #isCoupled()} those of all bodies on which a
     * generator acts, give position and velocity at the instant of the evaluation.
     *
     * @param body the body
     * @param time simulated time of the evaluation
     * @param forces takes the force
     */
    void addForce(Body body, double time, Forces forces);

    /**
     * Whether this generator ever acts on a body. Bodies on which none acts move freely, without an integrator.
     *
     * @param body a movable body
     * @return true for all bodies, unless overridden; asked again after a body's properties have been set
     */
    default boolean actsOn(Body body) {
        return true;
    }

    /**
     * Whether the force on a body depends on other bodies that move.
     *
     * @return false, unless overridden
     */
    default boolean isCoupled() {
        return false;
    }

    /**
     * The bodies that a generator couples, if these are always the same few: while joints tie all of them together, directly
     * or through others, it couples nothing more than they do, and other bodies move as without it.
     *
     * @return null, unless overridden: it may couple any bodies
     */
    default List<Body> getCoupledBodies() {
        return null;
    }

    /**
     * The energy that the generator stores now, so that an audit of the engine takes what it does for no loss. Uniform
     * fields are known.
     *
     * @return potential energy where its bodies are; 0, unless overridden: all that the forces do is work
     */
    default double energy() {
        return 0;
    }

    /**
     * Whether the forces depend on nothing but positions, velocities and properties of bodies, so that they are the same
     * whenever these are: not on the time, nor on anything that is changed from outside without a body being written. A method
     * that chooses its steps may then follow them beyond the end of the engine's step, as far as its tolerance allows, which
     * costs less where the engine's step is short; and what is written between steps acts at once all the same. Forces are
     * then asked for at places that the body may never reach, as is done at rejected steps.
     *
     * @return false, unless overridden: then no force is asked for beyond the engine's step
     */
    default boolean isAutonomous() {
        return false;
    }

    /**
     * Whether several threads may ask for the forces on different bodies at the same time, see
     * {@code PhysicsEngine.setThreads}: {@link #addForce} and {@link #actsOn} write nothing but the force on that body, and
     * read nothing that changes within a step but that body.
     *
     * @return false, unless overridden; then the stepping thread alone calls
     */
    default boolean isConcurrent() {
        return false;
    }
}
