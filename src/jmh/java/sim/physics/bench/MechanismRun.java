// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import sim.physics.PhysicsEngine;

/**
 * Times scenes with joints of all kinds, without collisions: the scenes of {@link Mechanisms}, at a step of 1/240 with RK4.
 * Batches of 2,000 steps of fresh scenes take turns; times are CPU times of the stepping thread.
 *
 * <pre>
 * MechanismRun rounds [scenes …]        MechanismRun 20
 * </pre>
 */
public final class MechanismRun {
    private static final int STEPS = 2000;
    private static final double WARM_UP = 20;

    private MechanismRun() {}

    /**
     * Runs the scenes.
     *
     * @param args rounds, and names of scenes; none: all
     */
    public static void main(String[] args) {
        int rounds = Integer.parseInt(args[0]);
        Map<String, Supplier<PhysicsEngine>> scenes = new LinkedHashMap<>(Mechanisms.ALL);
        if (args.length > 1) {
            scenes.keySet().retainAll(List.of(args).subList(1, args.length));
        }
        Map<String, double[]> times = new LinkedHashMap<>();
        scenes.keySet().forEach(name -> times.put(name, new double[rounds]));
        WarmUp.run(WARM_UP, () -> scenes.values().forEach(scene -> CpuTime.of(scene.get()::step, STEPS)));
        for (int round = 0; round < rounds; round++) {
            for (String name : scenes.keySet()) {
                times.get(name)[round] = CpuTime.of(scenes.get(name).get()::step, STEPS) * 1e-3 / STEPS;
            }
        }
        times.forEach((name, time) -> print(name, scenes.get(name).get(), time));
    }

    private static void print(String name, PhysicsEngine engine, double[] time) {
        Arrays.sort(time);
        int rows = engine.allConstraints().stream().mapToInt(joint -> joint.getRows()).sum();
        System.out.printf(
                Locale.ROOT,
                "%-8s %3d bodies %3d joints %3d equations: %.2f us/step, least %.2f%n",
                name, engine.bodies().size(), engine.allConstraints().size(), rows, time[time.length / 2], time[0]);
    }
}
