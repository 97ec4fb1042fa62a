// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

/**
 * What a method that chooses its steps integrates: coordinates of a group of bodies and their rates, without gaps, and what
 * the bodies' places have to do with them.
 */
public interface Coordinates {
    /**
     * Number of coordinates.
     *
     * @return at most three per body
     */
    int size();

    /**
     * Takes over where the state vectors have the bodies.
     *
     * @param x takes the coordinates
     * @param v takes their rates
     */
    void read(double[] x, double[] v);

    /**
     * The longest step from there after which one knows how the bodies got to where they are.
     *
     * @return time, greater than 0; infinite if there is none
     */
    double longest();

    /**
     * The accelerations of the coordinates; the state vectors are left anywhere.
     *
     * @param x coordinates
     * @param v their rates
     * @param t simulated time
     * @param a takes them
     */
    void accelerate(double[] x, double[] v, double t, double[] a);

    /**
     * Writes where the bodies are into the state vectors.
     *
     * @param x coordinates
     * @param v their rates
     */
    void put(double[] x, double[] v);

    /**
     * The accelerations of the bodies.
     *
     * @param x coordinates
     * @param v their rates
     * @param a their accelerations
     * @param byBlock takes [x″, y″, θ″] per body of the state
     */
    void accelerations(double[] x, double[] v, double[] a, double[] byBlock);

    /**
     * What small changes of the coordinates do to the bodies, near to where accelerations were asked for last.
     *
     * @param x changes of coordinates
     * @param v changes of rates; null for none
     * @param byX takes the bodies' changes without gaps, 3 per body; may be returned as it is
     * @param byV takes those of their velocities
     * @return whether there is something in them; false if coordinates are the bodies' own, so that x and v say it
     */
    boolean spread(double[] x, double[] v, double[] byX, double[] byV);

    /**
     * Takes from small changes, such as errors, what is taken away when the bodies are brought back to where their ties want
     * them.
     *
     * @param change of coordinates or of rates, near to where accelerations were asked for last
     * @return false if nothing is taken away of any change, or nobody knows what; then nothing has changed
     */
    default boolean pass(double[] change) {
        return false; // ties let any change of their coordinates pass
    }
}
