// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;

/** Is told what the integrator has done with driven bodies, for an audit. It must leave everything as it is. */
public interface CourseObserver extends Serializable {
    /**
     * It has been decided which motors and stops of a group act from its anchors on.
     *
     * @param group driven bodies
     */
    void decided(IntList group);

    /**
     * A group has been moved. Its anchors are still where it started from, and the state vectors hold where it is.
     *
     * @param group driven bodies
     * @param from offset of the anchors in the present step
     * @param to offset of where they are, which may be an earlier one
     */
    void covered(IntList group, double from, double to);
}
