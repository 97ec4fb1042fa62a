// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;

/**
 * Lets sweeps over impulses go on along conjugate directions: what each sweep changes is taken for the gradient
 * (Silcowitz-Hansen, Niebe and Erleben, <i>A nonsmooth nonlinear conjugate gradient method for interactive contact force
 * problems</i>, 2010).
 */
final class ConjugateSweeps implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Impulses before a sweep, then what it changes. */
    double[] before = {};

    private double[] direction = {};
    private double last;
    private double beta;

    ConjugateSweeps() {
        // grows with the heaps
    }

    /** Begins with no direction. */
    void begin(int n) {
        if (direction.length < n) {
            before = new double[2 * n];
            direction = new double[2 * n];
        }
        last = 0;
    }

    /** Puts the change of an impulse in the place of what it was before the sweep. */
    double change(int i, double impulse) {
        before[i] = impulse - before[i];
        return before[i];
    }

    /** Takes in the square of all changes, as an energy; returns whether to go on along the last direction. */
    boolean goesOn(double square) {
        beta = square < last ? square / last : 0;
        last = square;
        return beta != 0;
    }

    /** How far an impulse goes on along the last direction, which becomes the next one. */
    double more(int i) {
        double more = beta == 0 ? 0 : beta * direction[i];
        direction[i] = before[i] + more;
        return more;
    }
}
