// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

/**
 * An engine that a machine is built in: bodies of density 1 without restitution, under gravity, numbered from 0. A hinge has
 * the number of the body that was hung on another by it.
 */
interface MachineWorld {
    /** Time step, s. */
    double STEP = 1.0 / 60;

    /** Uniform field, m/s². */
    double GRAVITY = 9.81;

    /** Adds a box; returns its number. */
    int box(double width, double height, double x, double y, double friction, boolean fixed);

    /** Adds a disc; returns its number. */
    int disc(double radius, double x, double y, double friction);

    /**
     * Adds a body of several boxes, which need not be convex; returns its number.
     *
     * @param boxes of each its centre, from the centroid of all, its width and its height
     */
    int boxes(double[][] boxes, double x, double y, double friction);

    /** Takes a body away. */
    void remove(int body);

    /** Hangs a body on another by a hinge. */
    void pin(int on, int body, double x, double y);

    /**
     * Hangs a wheel on another body by a vertical rail with a spring that is at rest where the wheel is, and a hinge.
     *
     * @param hub mass of what carries the wheel: it is added to the wheel's, which turns as before
     */
    void suspend(int on, int wheel, double x, double y, double hub, double stiffness, double damping);

    /** Puts a motor at a hinge: of the body against the one that it hangs on. */
    void motor(int hinge, double speed, double torque);

    /** Sets a motor's speed. */
    void drive(int hinge, double speed);

    /** Puts stops at a hinge: for the angle of the body against the one that it hangs on. */
    void stops(int hinge, double lower, double upper);

    /** Sets all velocities. */
    void launch(double vx, double vy);

    /** Goes on for a step. */
    void step();

    /** Centre. */
    double x(int body);

    /** Centre. */
    double y(int body);

    /** Angle, possibly with full turns missing. */
    double angle(int body);

    /** Velocity. */
    double vx(int body);
}
