// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;

/** The plane on which bodies lie: which of them it holds, and which others push over it, its friction found with theirs. */
public final class Ground implements Serializable {
    private static final long serialVersionUID = 1L;

    /**
     * By how much a velocity may change that turns round, in units of that up to which friction grows: two of them are within what it
     * grows in.
     */
    private static final double SLOW = 2;

    /** Part of the speed up to which friction grows at which bodies are stopped that it can hold. */
    private static final double STANDS = 1;

    private final Motion motion;
    private final State state;
    private final Trajectories trajectories;
    private final IntList alone = new IntList();
    private double[] all = {};

    Ground(Motion motion, State state, Trajectories trajectories) {
        this.motion = motion;
        this.state = state;
        this.trajectories = trajectories;
    }

    /**
     * Whether there is friction on the plane.
     *
     * @return false without a {@link SurfaceFriction}
     */
    public boolean isRough() {
        return motion.generators.surface != null;
    }

    /**
     * Whether a body rubs on the plane and could be carried.
     *
     * @param body index
     * @return false for bodies that are tied to others, or coupled to them by forces
     */
    public boolean rubs(int body) {
        SurfaceFriction surface = motion.generators.surface;
        return surface != null && !motion.groups().isCoupled(body) && surface.actsOn(state.body(body)) && !motion.isTied(body);
    }

    /**
     * The deceleration of a body that slides on the plane without spinning.
     *
     * @param body index of one that rubs
     * @return μ g, length/time²
     */
    public double deceleration(int body) {
        return state.body(body).getSurfaceFriction() * motion.generators.surface.getGravity();
    }

    /**
     * Whether the integrator is to move a body for more than the friction of the plane.
     *
     * @param body index
     * @return true for bodies that are tied to others, and those that generators of authors act on
     */
    public boolean isDrivenByOthers(int body) {
        return motion.isTied(body) || motion.generators.drivesOtherThan(motion.generators.surface, state.body(body));
    }

    /**
     * Finds the acceleration that all but the friction of the plane and contacts give to a body where it is.
     *
     * @param body index, anchored at an offset in the present step, and not tied to others
     * @param tau that offset
     * @param a takes x″, y″, θ″
     * @param at where in it
     */
    public void accelerate(int body, double tau, double[] a, int at) {
        if (!isDrivenByOthers(body)) {
            motion.fall(body, a, at);
            return;
        }
        alone.only(body);
        soften(motion.forces, false); // or a second friction with the plane is what was asked for last
        load(alone, tau);
        System.arraycopy(all, State.BLOCK * body, a, at, State.BLOCK);
    }

    /** Finds what all but the friction of the plane and contacts gives to some bodies, where they are anchored. */
    private void load(IntList bodies, double tau) {
        motion.restore(bodies);
        all = all.length < State.BLOCK * state.size() ? new double[state.x().length] : all;
        motion.generators.accelerate(state, bodies, motion.time(tau), motion.forces, all, motion.generators.surface, 0);
    }

    /**
     * Lets the friction of bodies that move together grow from rest on: which of them is held there, and by how much, depends on all of
     * them, and friction that turned round at once would never let them rest. Bodies that move alone stop as {@link Sliding} finds.
     */
    void soften(Forces forces, boolean areTogether) {
        boolean isSoft = areTogether && isRough();
        Integrator method = motion.getIntegrator();
        double step = method instanceof RungeKutta4 ? 0.5 * motion.step() : motion.step(); // the others would turn it round
        double way = isSoft && method instanceof AdaptiveIntegrator chosen ? 0.25 * chosen.getTolerance() : Double.POSITIVE_INFINITY;
        forces.soften(isSoft ? step : 0, way);
    }

    /** Whether there is friction that grows from rest on, under bodies that move together. */
    boolean isSoft(IntList bodies) {
        boolean areTogether = isRough() && (bodies.size > 1 || motion.isTiedGroup(bodies));
        if (areTogether) {
            soften(motion.forces, true);
        }
        return areTogether;
    }

    /**
     * Whether friction of some body has turned round between two velocities, and takes a good part of their difference to do so: what is
     * evaluated on the way may all lie on one side of that.
     *
     * @param before velocities of the group's bodies, one after the other; those after it are in the state vectors
     */
    boolean turnsRound(IntList bodies, double[] before) {
        double[] v = state.v();
        for (int k = 0; k < bodies.size; k++) {
            Body body = state.body(bodies.values[k]);
            if (!motion.generators.surface.actsOn(body)) {
                continue;
            }
            int b = State.BLOCK * bodies.values[k];
            int o = State.BLOCK * k;
            double arm = body.getInertia() / body.getMass();
            double along = v[b] * before[o] + v[b + 1] * before[o + 1] + arm * v[b + 2] * before[o + 2];
            double dx = v[b] - before[o];
            double dy = v[b + 1] - before[o + 1];
            double turn = v[b + 2] - before[o + 2];
            double slow = SLOW * motion.forces.slow(body.getSurfaceFriction() * motion.generators.surface.getGravity());
            if (along < 0 && dx * dx + dy * dy + arm * turn * turn > slow * slow) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether bodies that move together come to a standstill now: all are so slow that friction, which grows from rest on under them, would
     * stop them in no time if it did not, and static friction bears what acts on each. Then nothing flows, and none of them creeps.
     */
    boolean stops(IntList group) {
        SurfaceFriction surface = motion.generators.surface;
        if (!isSoft(group) || !areSlow(group, surface) || motion.isTiedGroup(group) && motion.ties.isSwitched(group)) {
            return false;
        }
        load(group, trajectories.offset(group.values[0]));
        boolean yes = true;
        for (int k = 0; k < group.size; k++) {
            Body body = state.body(group.values[k]);
            int b = State.BLOCK * group.values[k];
            double mass = body.getMass();
            yes &= surface.holds(body, mass * all[b], mass * all[b + 1], body.getInertia() * all[b + 2]);
        }
        return yes;
    }

    private boolean areSlow(IntList group, SurfaceFriction surface) {
        double[] d = trajectories.data();
        boolean yes = true;
        for (int k = 0; yes && k < group.size; k++) {
            Body body = state.body(group.values[k]);
            int o = Trajectories.STRIDE * group.values[k] + Trajectories.VX;
            double arm = body.getInertia() / body.getMass();
            double square = d[o] * d[o] + d[o + 1] * d[o + 1] + arm * d[o + 2] * d[o + 2];
            double slow = STANDS * motion.forces.slow(body.getSurfaceFriction() * surface.getGravity());
            yes = surface.actsOn(body) && square <= slow * slow && !motion.support.pushes(group.values[k]);
        }
        return yes;
    }

    /** The friction that acts on a body which moves alone, or null. */
    SurfaceFriction surfaceUnder(IntList group) {
        SurfaceFriction surface = motion.generators.surface;
        return surface == null || group.size > 1 || !surface.actsOn(state.body(group.values[0])) ? null : surface;
    }

    /**
     * Takes a driven body that has come to rest and that constant static friction holds off the integrator.
     *
     * @param body index, anchored at the present instant
     * @return whether it is at rest until something happens to it
     */
    public boolean hold(int body) {
        if (trajectories.isMoving(body) || motion.isTied(body) || !motion.generators.holds(state.body(body))) {
            return false;
        }
        motion.setDriven(body, false);
        motion.support.hold(body);
        motion.course(body);
        return true;
    }

    /**
     * Takes a body off the integrator, until it is written or struck.
     *
     * @param body index, anchored at the present instant, and not tied to others
     */
    public void carry(int body) {
        if (motion.generators.drive(state.body(body))) {
            motion.setDriven(body, false);
            motion.support.carry(body);
        }
    }

    /**
     * Leaves a body to the integrator again.
     *
     * @param body index, anchored at the present instant; any
     */
    public void resume(int body) {
        if (motion.support.carries(body)) {
            motion.deflect(body);
        }
    }

    /**
     * Whether the plane can hold a body.
     *
     * @param body index, anchored at the present instant
     * @param fx force on it
     * @param fy force on it
     * @param torque torque on it
     * @param moves whether it slides until it is held
     * @return whether they lie within the limit surface, of static friction unless it slides
     */
    public boolean holds(int body, double fx, double fy, double torque, boolean moves) {
        return motion.generators.surface.holds(state.body(body), theta(body), fx, fy, torque, moves);
    }

    /**
     * The friction of a motion.
     *
     * @param body index, anchored at the present instant
     * @param vx velocity
     * @param vy velocity
     * @param omega angular velocity
     * @param isStatic whether it is that of the onset of the motion, which static friction resists
     * @param out takes force x, force y and torque
     */
    public void friction(int body, double vx, double vy, double omega, boolean isStatic, double[] out) {
        motion.generators.surface.friction(state.body(body), vx, vy, omega, theta(body), isStatic, out);
    }

    private double theta(int body) {
        return trajectories.data()[body * Trajectories.STRIDE + Trajectories.THETA0];
    }
}
