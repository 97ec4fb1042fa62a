// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;

/** Which errors of velocities are good enough for a heap, and that of its last solution. */
final class HeapTolerance implements Serializable {
    private static final long serialVersionUID = 1L;

    private double enough;
    private double fair;
    private double error;
    private boolean rough;
    private boolean brief;
    private boolean deep;
    private boolean near;

    HeapTolerance() {
        clear();
    }

    /** Begins to take in the points of a heap. */
    void clear() {
        enough = Double.POSITIVE_INFINITY;
        fair = 0;
        error = 0;
        rough = false;
        brief = false;
        deep = false;
        near = false;
    }

    /** Says which error is good enough in the end; the least that is said counts. */
    void allow(double most) {
        enough = Math.min(enough, most);
    }

    /** The same of a pair that may be deeper than others, or may not. */
    void allow(double most, boolean isDeeper) {
        allow(most);
        deep |= isDeeper;
    }

    /** Whether some pair is deeper than it is to be in the end. */
    boolean isDeep() {
        return deep;
    }

    double enough() {
        return enough;
    }

    /** Says with which error a solution may be kept when there is no better one; the least that is said counts. */
    void bear(double most) {
        fair = fair == 0 ? most : Math.min(fair, most);
    }

    /** What was said, or 0. */
    double fair() {
        return fair;
    }

    /** Takes note whether an error which is fair is good enough. */
    void roughen(boolean yes) {
        rough = yes;
    }

    boolean isRough() {
        return rough;
    }

    /** Takes note whether not much is to be tried, since it has been in vain. */
    void hurry(boolean yes) {
        brief = yes;
    }

    boolean isBrief() {
        return brief;
    }

    /** Takes note whether the impulses that there are will be nearly right. */
    void setNear(boolean yes) {
        near = yes;
    }

    boolean isNear() {
        return near;
    }

    /** Error of the velocities that were found last, 0 if they are right. */
    double error() {
        return error;
    }

    void setError(double velocity) {
        error = velocity;
    }
}
