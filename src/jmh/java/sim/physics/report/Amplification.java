// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.SplittableRandom;
import sim.physics.motion.DormandPrince853;

/**
 * What a scene makes of small errors on its way, its condition: the error at the end, or the largest one at the instants of
 * comparison, if in every unit of the scene's own time places go wrong by one unit of length in the next one, at random, so
 * that squares add up.
 *
 * <p>That time is the one in which velocities change as much as they are, as the methods' estimates have it: the root mean
 * square of the speeds of all bodies, turning ones with their rims, over that of their accelerations; 1/ω for an oscillator.
 * Errors are changes of velocities along themselves, of random sign, body by body, so that what a symmetry rules out stays
 * ruled out. Joints take what they do not allow, and what is left is measured: the place that is off most is off by one
 * unit of length after one unit of time. They fall at random instants, one in each of equal parts of the scene, since what
 * becomes of them depends on the phase of the motion; two runs tell what becomes of each.
 */
final class Amplification {
    /** Changes that are made: fewer where a run takes long, in steps of bodies. */
    private static final int LEAST_KICKS = 32;

    private static final int MOST_KICKS = 128;
    private static final int WORK = 200_000;

    private static final int STEPS = 64;
    private static final int STEPS_IN_UNIT = 8;
    private static final double TOLERANCE = 1e-11;
    private static final double CHANGE = 1e-6;

    private final ReportScene scene;
    private final SplittableRandom random = new SplittableRandom(1);
    private int parts;
    private double dt;
    private double time;

    Amplification(ReportScene scene) {
        this.scene = scene;
    }

    /** Length per length, both in the unit of tolerances. */
    double measure() {
        divide(Math.max(1, STEPS / scene.samples));
        double[][] plain = run(-1, 0);
        time = time(plain);
        divide(Math.max(parts, (int) Math.ceil(STEPS_IN_UNIT * scene.duration / scene.samples / time)));
        plain = run(-1, 0);
        int kicks = Math.max(LEAST_KICKS, Math.min(MOST_KICKS, WORK / (plain.length * scene.model.parts.size())));
        double[][] sums = new double[scene.samples][scene.points.length];
        for (int k = 0; k < kicks; k++) {
            int at = 1 + (int) ((k + random.nextDouble()) * (plain.length - 1) / kicks);
            add(plain, run(at, CHANGE * scene.unit / time), at, sums);
        }
        double most = 0;
        for (double[] row : sums) {
            for (double sum : row) {
                most = Math.max(most, sum);
            }
        }
        return Math.sqrt(Math.max(1, scene.duration / time) * most / kicks);
    }

    private void divide(int each) {
        parts = each;
        dt = scene.duration / scene.samples / parts;
    }

    /** States after each step, of a run that is changed before one of them. */
    private double[][] run(int at, double speed) {
        double[][] states = new double[scene.samples * parts][Model.BLOCK * scene.model.parts.size()];
        OwnWorld world = new OwnWorld(scene.model, new DormandPrince853(TOLERANCE), dt, false);
        for (int k = 0; k < states.length; k++) {
            if (k == at) {
                world.kick(speed, random);
            }
            world.step();
            world.read(states[k]);
        }
        return states;
    }

    /** Adds the squares of what became of a change, over that of the change. */
    private void add(double[][] plain, double[][] changed, int at, double[][] sums) {
        double size = 0;
        for (int part = 0; part < scene.model.parts.size(); part++) {
            size = Math.max(size, change(plain[at], changed[at], part) * time / dt);
        }
        for (int k = 0; k < scene.samples && size > 0; k++) {
            int row = (k + 1) * parts - 1;
            for (int p = 0; p < scene.points.length; p++) {
                double[] a = place(plain[row], p);
                double[] b = place(changed[row], p);
                double off = Math.hypot(b[0] - a[0], b[1] - a[1]) / size;
                sums[k][p] += off * off;
            }
        }
    }

    private double[] place(double[] state, int p) {
        double[] point = scene.points[p];
        return scene.model.local((int) point[0], point[1], point[2], state);
    }

    /** How far a part is off, its rim included, as tolerances count it. */
    private double change(double[] a, double[] b, int part) {
        int o = Model.BLOCK * part;
        double turn = scene.model.parts.get(part).rim() * Math.abs(b[o + 2] - a[o + 2]);
        return Math.max(Math.max(Math.abs(b[o] - a[o]), Math.abs(b[o + 1] - a[o + 1])), turn);
    }

    private double time(double[][] states) {
        double speeds = 0;
        double pushes = 0;
        for (int k = 1; k < states.length; k++) {
            for (int part = 0; part < scene.model.parts.size(); part++) {
                double rim = scene.model.parts.get(part).rim();
                for (int c = 3; c < Model.BLOCK; c++) {
                    double weight = c == 5 ? rim * rim : 1;
                    double v = states[k][Model.BLOCK * part + c];
                    double push = (v - states[k - 1][Model.BLOCK * part + c]) / dt;
                    speeds += weight * v * v;
                    pushes += weight * push * push;
                }
            }
        }
        return Math.sqrt(speeds / pushes);
    }
}
