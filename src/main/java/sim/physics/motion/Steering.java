// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;

/** Moves the kinematic bodies of an engine, if there are any. */
public final class Steering implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Trajectories trajectories;
    private final Generators generators;
    private final Kinematics kinematics = new Kinematics();

    /**
     * That of an engine without kinematic bodies.
     *
     * @param state all bodies
     * @param trajectories where they go
     * @param motion forces on them
     */
    public Steering(State state, Trajectories trajectories, Motion motion) {
        this.state = state;
        this.trajectories = trajectories;
        generators = motion.generators;
    }

    /**
     * Takes note of a body that was added.
     *
     * @param body any body
     */
    public void note(Body body) {
        if (body instanceof KinematicBody moved) {
            kinematics.add(moved);
        }
    }

    /** {@return whether there is a kinematic body} */
    public boolean isAny() {
        return !kinematics.isEmpty();
    }

    /**
     * Whether two bodies that no force moves go on as one in the step that has begun: both are immobile, or their authors move them as a rigid body
     * would be moved, from the start of the step to its end.
     *
     * @param a a body
     * @param b another one
     * @return false if forces move one of them
     */
    public static boolean goAsOne(Body a, Body b) {
        boolean areMoving = a instanceof KinematicBody && b instanceof KinematicBody && !a.isImmobile() && !b.isImmobile();
        return areMoving ? ((KinematicBody) a).goesWith((KinematicBody) b) : a.isImmobile() && b.isImmobile();
    }

    /**
     * Whether a body that its author moves turns in the step that has begun.
     *
     * @param body a kinematic one
     * @return false if it is only shifted
     */
    public static boolean turns(Body body) {
        return ((KinematicBody) body).turns();
    }

    /**
     * The acceleration of a body that its author moves, in the step that has begun.
     *
     * @param body a kinematic one that moves
     * @param a takes it, [x″, y″, θ″] per body of the state
     */
    public static void accelerate(Body body, double[] a) {
        for (int k = 0; k < State.BLOCK; k++) {
            a[State.BLOCK * body.index() + k] = ((KinematicBody) body).acceleration(k);
        }
    }

    /** {@return whether there is one that does not stand} */
    public boolean areSomeMoving() {
        return kinematics.areSomeMoving();
    }

    /**
     * Sets kinematic bodies on their courses for a step that is about to begin.
     *
     * @param number of the step
     * @param h its length
     * @param isStepped whether it is made by time stepping
     */
    public void begin(long number, double h, boolean isStepped) {
        if (isAny()) {
            kinematics.push(state, number, generators, h, isStepped);
        }
    }

    /**
     * The acceleration of a body by forces that were applied to it.
     *
     * @param body any
     * @return that in x and that in y, added up
     */
    public static double applied(Body body) {
        return (Math.abs(body.appliedX()) + Math.abs(body.appliedY())) / body.getMass();
    }

    /**
     * The momentum that others have given the bodies that nothing moves, as their velocities of now say.
     *
     * @param part part of the step that is over
     * @return the largest of them
     */
    public double pushed(double part) {
        return kinematics.pushed(part);
    }

    /** {@return the speed of the fastest of them in the step} */
    public double fastest() {
        return kinematics.fastest();
    }

    /** {@return the acceleration of bodies on which nothing acts but fields} */
    public double pull() {
        return Math.abs(generators.gravityX) + Math.abs(generators.gravityY);
    }

    /**
     * Looks whether something is squeezed between bodies that nothing moves.
     *
     * @param tau offset of the present instant in the step
     * @param h the step
     * @param areKept whether {@link Motion#keepEnds} was called in it
     * @param strength force that motors may press with
     * @return whether they are pushed by far more than all others could push
     */
    public boolean isSqueezing(double tau, double h, boolean areKept, double strength) {
        return isAny() && kinematics.areSqueezing(state, trajectories, tau, areKept, pull(), strength, h);
    }
}
