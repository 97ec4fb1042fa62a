// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.Arrays;
import java.util.Locale;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/**
 * What sleep spares under time stepping: CPU time of the stepping thread for a step of pyramids of ten boxes that lie awake, and that sleep,
 * in µs, with four substeps of 1/240 s; least and median of rounds in turns, after 1,200 steps in which they have come to rest.
 *
 * <pre>
 * SleepRun rounds boxes ...
 * SleepRun 40 100 1000 10000
 * </pre>
 */
public final class SleepRun {
    private static final int ROWS = 4;
    private static final int PYRAMID = ROWS * (ROWS + 1) / 2;

    private SleepRun() {}

    /**
     * Runs the comparison.
     *
     * @param args rounds, and numbers of boxes
     */
    public static void main(String[] args) {
        int rounds = Integer.parseInt(args[0]);
        for (String boxes : Arrays.asList(args).subList(1, args.length)) {
            measure(Integer.parseInt(boxes), rounds);
        }
    }

    private static void measure(int boxes, int rounds) {
        PhysicsEngine[] engines = {pile(boxes, false), pile(boxes, true)};
        double[][] times = new double[engines.length][rounds];
        for (PhysicsEngine engine : engines) {
            CpuTime.of(engine::step, 1200);
        }
        for (int round = 0; round < rounds; round++) {
            times[0][round] = 1e-3 * CpuTime.of(engines[0]::step, 50) / 50;
            times[1][round] = 1e-3 * CpuTime.of(engines[1]::step, 2000) / 2000;
        }
        for (int k = 0; k < times.length; k++) {
            Arrays.sort(times[k]);
            System.out.printf(Locale.ROOT, "%6d boxes %-6s %10.3f %10.3f%n", boxes, k == 0 ? "awake" : "asleep", times[k][0], times[k][rounds / 2]);
        }
        System.out.printf(Locale.ROOT, "%6d boxes ratio  %10.0f%n", boxes, times[0][rounds / 2] / times[1][rounds / 2]);
    }

    private static PhysicsEngine pile(int boxes, boolean sleep) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.setTimeStepping(4);
        engine.setSleepAllowed(sleep);
        engine.add(new Gravity(0, -10));
        engine.add(rough(Body.fixed(new Rectangle(boxes, 2)).at(boxes / 2.0, -1)));
        for (int pile = 0; pile < boxes / PYRAMID; pile++) {
            for (int row = 0; row < ROWS; row++) {
                for (int k = 0; k < ROWS - row; k++) {
                    engine.add(rough(new Body(new Rectangle(1, 1)).at(5 * pile + 2 + 1.1 * (k + 0.5 * row), 0.5 + row)));
                }
            }
        }
        return engine;
    }

    private static Body rough(Body body) {
        body.setFriction(0.5);
        body.setRestitution(0);
        return body;
    }
}
