// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.io.Serializable;

/**
 * How exact a step was, or all steps of an audited run together: errors against a motion made anew, and where the energy
 * went,
 *
 * <pre>
 *   energyAfter = energyBefore + work + impacts + authored + drift
 * </pre>
 *
 * <p>Energies are those of motion, of uniform fields with the origin as their level, and what generators say that they
 * store ({@link sim.physics.motion.ForceGenerator#energy()}). Nobody knows how much of the latter the program changes within a step, as a
 * listener does that removes a body with a stretched spring: that is part of the drift.
 *
 * @param energyBefore at the start
 * @param energyAfter at the end
 * @param work of all forces that have no potential: friction, dampers, motors, what was applied, and contacts of bodies that
 *     rest on fixed ones; negative if they took energy
 * @param impacts change by impacts, of stops too, and by contacts within heaps; negative if energy was lost
 * @param authored change by the program: bodies written, added and removed, and joints that were closed
 * @param drift what remains: the error of the integrator, and of the search for impacts
 * @param placeError distance by which a body missed its place, length: the largest of a body in each path that the
 *     integrator made, and the sum of those
 * @param angleError the same of angles, rad
 * @param unresolved number of paths that could not be followed, because forces are not smooth; they have no errors here, and
 *     all their change of energy is drift
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
