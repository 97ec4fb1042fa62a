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
     * Adds the force on one body, and on no other: what it does to another one is asked for when it is that one's turn. The body's getters, and with {@link #isCoupled()} those of all bodies on which a
     * generator acts, give position and velocity at the instant of the evaluation.
     *
     * @param body the body
     * @param time simulated time of the evaluation
     * @param forces takes the force
     */
    void addForce(Body body, double time, Forces forces);

    /**
     * Whether this generator ever acts on a body. Bodies on which none acts move freely, without an integrator. A force that
     * begins or ends with the time, or with where a body is, must not be switched here: let {@link #addForce} add nothing.
     *
     * @param body a movable body
     * @return true for all bodies, unless overridden; asked when the body or the generator is added, and again after the
     *     body has been written, not in each step
     */
    default boolean actsOn(Body body) {
        return true;
    }

    /**
     * The only bodies that a generator ever acts on, if these are always the same: then it is not asked about others, and many
     * such generators on many bodies cost no more than there are forces.
     *
     * @return null, unless overridden: {@link #actsOn} is asked about every body
     */
    default List<Body> getBodies() {
        return null;
    }

    /**
     * Whether the force on a body depends on other bodies that move. Bodies that are coupled, directly or through others or
     * through joints, are integrated together.
     *
     * @return false, unless overridden; asked when the generator is added and at the start of each step
     */
    default boolean isCoupled() {
        return false;
    }

    /**
     * The bodies that a generator couples, if these are always the same few: other bodies move as without it. While joints tie
     * all of them together, directly or through others, it couples nothing more than they do.
     *
     * @return {@link #getBodies()}, unless overridden; null: all bodies on which it acts
     */
    default List<Body> getCoupledBodies() {
        return getBodies();
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
     * then asked for at places that the body may never reach, as is done at rejected steps. Under time stepping, bodies sleep under no
     * other forces than these.
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
