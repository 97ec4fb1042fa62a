// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.SplittableRandom;
import sim.physics.motion.DormandPrince853;

/**
 * What a scene makes of small errors on its way: the error at the end, or the largest one at the instants of comparison, if
 * in every unit of the scene's own time velocities are changed so that places change by one unit of length in the next
 * one, at random, so that squares add up.
 *
 * <p>That time is τ = r/v, with the root mean squares of the distance of the observed points from their mean place and of
 * their speed: 1/ω for an oscillator. The changes of velocity, by δ/τ, are along it and of random sign, body by body, at
 * one of eight instants; two runs tell what becomes of each.
 */
final class Amplification {
    private static final int KICKS = 8;
    private static final int STEPS = 64;
    private static final double TOLERANCE = 1e-12;
    private static final double CHANGE = 1e-6;

    private final ReportScene scene;
    private final int parts;
    private final double dt;

    Amplification(ReportScene scene) {
        this.scene = scene;
        parts = Math.max(1, STEPS / scene.samples);
        dt = scene.duration / scene.samples / parts;
    }

    /** Length per length, both in the unit of tolerances. */
    double measure() {
        double[][] plain = run(-1, 0);
        double time = time(plain);
        double sum = 0;
        for (int k = 0; k < KICKS; k++) {
            int at = (2 * k + 1) * plain.length / (2 * KICKS);
            double[][] kicked = run(at, CHANGE * scene.unit / time);
            double most = 0;
            for (int row = parts - 1; row < plain.length; row += parts) {
                for (int c = 0; c < plain[row].length; c += 2) {
                    most = Math.max(most, Math.hypot(
                            kicked[row][c] - plain[row][c], kicked[row][c + 1] - plain[row][c + 1]));
                }
            }
            sum += most / (CHANGE * scene.unit) * most / (CHANGE * scene.unit);
        }
        return Math.sqrt(Math.max(1, scene.duration / time) * sum / KICKS);
    }

    /** Places of the points after each step. */
    private double[][] run(int at, double speed) {
        double[][] rows = new double[scene.samples * parts][2 * scene.points.length];
        double[] state = new double[Model.BLOCK * scene.model.parts.size()];
        OwnWorld world = new OwnWorld(scene.model, new DormandPrince853(TOLERANCE), dt, false);
        for (int k = 0; k < rows.length; k++) {
            if (k == at) {
                world.kick(speed, new SplittableRandom(k));
            }
            world.step();
            world.read(state);
            for (int p = 0; p < scene.points.length; p++) {
                double[] point = scene.points[p];
                double[] place = scene.model.local((int) point[0], point[1], point[2], state);
                rows[k][2 * p] = place[0];
                rows[k][2 * p + 1] = place[1];
            }
        }
        return rows;
    }

    private double time(double[][] rows) {
        double way = 0;
        double spread = 0;
        int n = rows.length;
        for (int c = 0; c < rows[0].length; c++) {
            double mean = 0;
            for (double[] row : rows) {
                mean += row[c] / n;
            }
            for (int k = 0; k < n; k++) {
                spread += (rows[k][c] - mean) * (rows[k][c] - mean) / n;
                double speed = k == 0 ? 0 : (rows[k][c] - rows[k - 1][c]) / dt;
                way += speed * speed / (n - 1);
            }
        }
        return Math.sqrt(spread / way);
    }
}
