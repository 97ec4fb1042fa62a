// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.List;
import java.util.function.DoubleFunction;
import sim.physics.motion.Automatic;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.Euler;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Integrator;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.Rattle;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.SymplecticEuler;

/**
 * A method of this engine: a line each.
 *
 * @param name in the plots
 * @param adaptive whether it is given a tolerance; else the step is varied
 * @param conservative whether it is only for forces that depend on places
 * @param maker makes it, of a tolerance
 */
record OwnMethod(String name, boolean adaptive, boolean conservative, DoubleFunction<Integrator> maker) {
    /** In place of events and integrators; steps of four substeps. */
    static final OwnMethod TIME_STEPPING = new OwnMethod("time stepping", false, false, tolerance -> new SymplecticEuler());

    static final int SUBSTEPS = 4;

    static final List<OwnMethod> ALL = List.of(
            new OwnMethod("Euler", false, false, tolerance -> new Euler()),
            new OwnMethod("Symplectic Euler", false, false, tolerance -> new SymplecticEuler()),
            new OwnMethod("RK4", false, false, tolerance -> new RungeKutta4()),
            new OwnMethod("Rattle 2", false, true, tolerance -> new Rattle(2)),
            new OwnMethod("Rattle 4", false, true, tolerance -> new Rattle(4)),
            new OwnMethod("Rattle 6", false, true, tolerance -> new Rattle(6)),
            new OwnMethod("DOP853", true, false, DormandPrince853::new),
            new OwnMethod("GBS", true, false, GraggBulirschStoer::new),
            new OwnMethod("Radau IIA", true, false, RadauIIA::new),
            new OwnMethod("Automatic", true, false, Automatic::new),
            TIME_STEPPING);

    /** Where contacts last: what touches is found between events, forces are constant on the way where they can be. */
    static final OwnMethod EVENTS = new OwnMethod("RK4, events", false, false, tolerance -> new RungeKutta4());

    /** Where no integrator has anything to do. */
    static final OwnMethod EXACT_PATHS = new OwnMethod("exact paths", false, false, tolerance -> new RungeKutta4());
}
