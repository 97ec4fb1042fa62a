// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.DoubleFunction;
import sim.physics.motion.Automatic;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.Euler;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Integrator;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.Rattle;
import sim.physics.motion.RungeKutta4;

/** This engine's methods, with the steps or tolerances that they are run at: the one place to add another. */
final class Methods {
    static final double[] STEPS = {1 / 30.0, 1 / 60.0, 1 / 120.0, 1 / 240.0, 1 / 480.0, 1 / 1000.0, 1 / 4000.0};

    private static final double[] TOLERANCES = {
        1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13
    };

    private Methods() {}

    /**
     * All methods in a scene.
     *
     * @param outputs the step at which adaptive methods publish their state
     * @param trial makes a run from a method and a step
     */
    static List<Contender> contenders(double outputs, BiFunction<Integrator, Double, Trial> trial) {
        List<Contender> all = new ArrayList<>();
        all.add(fixed("Euler", new Euler(), trial));
        all.add(fixed("RK4", new RungeKutta4(), trial));
        all.add(fixed("RATTLE 2", new Rattle(2), trial));
        all.add(fixed("RATTLE 4", new Rattle(4), trial));
        all.add(fixed("RATTLE 6", new Rattle(6), trial));
        all.add(adaptive("DOP853", DormandPrince853::new, outputs, trial));
        all.add(adaptive("GBS", GraggBulirschStoer::new, outputs, trial));
        all.add(adaptive("Radau IIA", RadauIIA::new, outputs, trial));
        all.add(adaptive("Automatic", Automatic::new, outputs, trial));
        return all;
    }

    private static Contender fixed(String name, Integrator method, BiFunction<Integrator, Double, Trial> trial) {
        return new Contender("mason-physics", name, false, STEPS, step -> trial.apply(method, step));
    }

    private static Contender adaptive(
            String name, DoubleFunction<Integrator> method, double outputs, BiFunction<Integrator, Double, Trial> trial) {
        return new Contender("mason-physics", name, true, TOLERANCES, t -> trial.apply(method.apply(t), outputs));
    }
}
