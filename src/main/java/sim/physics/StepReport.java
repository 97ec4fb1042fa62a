// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.io.Serializable;

/**
 * A report on how exact a step was, or how exact all steps of an audited run were together. It gives the errors against a motion
 * that is computed again, and says where the energy went:
 *
 * <pre>
 *   energyAfter = energyBefore + work + impacts + authored + drift
 * </pre>
 *
 * <p>Energies are those of motion, those of uniform fields, with the origin as their level, and what generators say that they
 * store ({@link sim.physics.motion.ForceGenerator#energy()}). The engine cannot know how much of the stored energy the program
 * changes within a step, as a listener does that removes a body with a stretched spring. That is part of the drift.
 *
 * @param energyBefore energy at the start
 * @param energyAfter energy at the end
 * @param work work of all forces that have no potential: friction, dampers, motors, applied forces, and contacts of bodies that
 *     rest on fixed ones; negative if they took energy
 * @param impacts change by impacts, including those of stops, and by contacts within heaps; negative if energy was lost
 * @param authored change by the program: bodies set, added and removed, and joints that were closed
 * @param drift what remains: the error of the integrator, and of the search for impacts
 * @param placeError distance by which bodies missed their places, length: for each path that the integrator made, the largest
 *     error of any of its bodies, and the sum of these
 * @param angleError the same for angles, rad
 * @param unresolved number of paths that could not be followed, because forces are not smooth; these have no errors here, and all
 *     their change of energy is drift
 */
public record StepReport(
        double energyBefore,
        double energyAfter,
        double work,
        double impacts,
        double authored,
        double drift,
        double placeError,
        double angleError,
        long unresolved)
        implements Serializable {
    private static final long serialVersionUID = 1L;
}
