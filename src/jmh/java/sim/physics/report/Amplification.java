// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.SplittableRandom;
import sim.physics.motion.DormandPrince853;

/**
 * What a scene makes of small errors on its way, its condition: the error at the end, or the largest one at the instants of
 * comparison, if in every unit of the scene's own time places go wrong by one unit of length in the next one.
 *
 * <p>That time is the one in which velocities change as much as they are, as the methods' estimates have it: the root mean
 * square of the speeds of all bodies, turning ones with their rims, over that of their accelerations; 1/ω for an oscillator.
 * Errors are changes of velocities along themselves, of random sign, body by body, so that what a symmetry rules out stays
 * ruled out. Joints take what they do not allow, and what is left is measured: the place that is off most is off by one
 * unit of length after one unit of time. They fall at random instants, one in each of equal parts of the scene, since what
 * becomes of them depends on the phase of the motion; two runs tell what becomes of each.
 *
 * <p>The error of a method's step depends on the state that it begins in. So those in different states have nothing to do
 * with one another, and their squares add up; but where a motion comes back to a state, so does the error, and over many periods
 * of a pendulum errors of the same sign add up: its phase is off by the square of the time (Cano and Sanz-Serna 1997), and
 * not by its power 3/2. Here errors are a random field over the states, of a correlation that falls with the square
 * of their distance to e⁻² at what the motion covers in a unit of time.
 */
final class Amplification {
    /** Changes that are made: fewer where a run takes long, in steps of bodies. */
    private static final int LEAST_KICKS = 32;

    private static final int MOST_KICKS = 256;
    private static final int WORK = 400_000;

    private static final int STEPS = 64;
    private static final int STEPS_IN_UNIT = 8;
    private static final double TOLERANCE = 1e-11;
    private static final double CHANGE = 1e-6;

    /** Number of ways to give signs to bodies: what becomes of changes of the same signs in two states can be compared. */
    private static final int MOST_PATTERNS = 4;

    private static final double LIKENESS = 2;

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
        time = time(run(-1, 0, 0));
        divide(Math.max(parts, (int) Math.ceil(STEPS_IN_UNIT * scene.duration / scene.samples / time)));
        double[][] plain = run(-1, 0, 0);
        double units = Math.max(1, scene.duration / time);
        int most = (int) Math.min(MOST_KICKS, WORK / ((long) plain.length * scene.model.parts.size()));
        int[] at = new int[Math.max(LEAST_KICKS, most)];
        double[][] left = new double[at.length][];
        for (int k = 0; k < at.length; k++) {
            at[k] = 1 + (int) ((k + random.nextDouble()) * (plain.length - 1) / at.length);
            left[k] = left(plain, run(at[k], CHANGE * scene.unit / time, k % patterns()), at[k]);
        }
        return Math.sqrt(most(left, weights(plain, at, units)));
    }

    /**
     * By how much the product of what two changes leave counts: of a change with itself as often as there are units of time
     * for each, of two alike ones that are not of the same unit as often as there are pairs of units.
     */
    private double[][] weights(double[][] plain, int[] at, double units) {
        double[][] weight = new double[at.length][at.length];
        int groups = patterns();
        double pairs = at.length * (at.length / (double) groups - 1);
        for (int k = 0; k < at.length; k++) {
            for (int l = k % groups; l < at.length; l += groups) {
                boolean isOther = Math.abs(at[k] - at[l]) * dt >= time;
                double alike = isOther ? likeness(plain, at[k], at[l]) : 0;
                weight[k][l] = k == l ? units / at.length : units * (units - 1) / pairs * alike;
            }
        }
        return weight;
    }

    /** The correlation of the errors that begin in two states. */
    private double likeness(double[][] plain, int k, int l) {
        double moved = Math.min(moved(plain, k), moved(plain, l));
        return moved > 0 ? Math.exp(-LIKENESS * distance(plain[k], plain[l]) / moved) : 0;
    }

    /** The largest sum of squares at an instant of comparison. */
    private double most(double[][] left, double[][] weight) {
        double most = 0;
        for (int m = 0; m < left[0].length; m += 2) {
            double sum = 0;
            double alone = 0;
            for (int k = 0; k < left.length; k++) {
                for (int l = 0; l < left.length; l++) {
                    sum += weight[k][l] * (left[k][m] * left[l][m] + left[k][m + 1] * left[l][m + 1]);
                }
                alone += weight[k][k] * (left[k][m] * left[k][m] + left[k][m + 1] * left[k][m + 1]);
            }
            most = Math.max(most, Math.max(alone, sum));
        }
        return most;
    }

    /** The square of how far the state moves in the unit of time about a step. */
    private double moved(double[][] plain, int step) {
        int half = (int) Math.max(1, Math.round(0.5 * time / dt));
        return distance(plain[Math.max(0, step - half)], plain[Math.min(plain.length - 1, step + half)]);
    }

    /** The square of the distance of two states: places, rims, and velocities times the unit of time. */
    private double distance(double[] a, double[] b) {
        double sum = 0;
        for (int part = 0; part < scene.model.parts.size(); part++) {
            int o = Model.BLOCK * part;
            double rim = scene.model.parts.get(part).rim();
            sum += square(b[o] - a[o]) + square(b[o + 1] - a[o + 1]);
            sum += square(2 * rim * Math.sin(0.5 * (b[o + 2] - a[o + 2])));
            sum += square(time * (b[o + 3] - a[o + 3])) + square(time * (b[o + 4] - a[o + 4]));
            sum += square(time * rim * (b[o + 5] - a[o + 5]));
        }
        return sum;
    }

    private static double square(double d) {
        return d * d;
    }

    private int patterns() {
        return Math.min(MOST_PATTERNS, 2 * scene.model.parts.size());
    }

    private void divide(int each) {
        parts = each;
        dt = scene.duration / scene.samples / parts;
    }

    /** States after each step, of a run that is changed before one of them. */
    private double[][] run(int at, double speed, long pattern) {
        double[][] states = new double[scene.samples * parts][Model.BLOCK * scene.model.parts.size()];
        OwnWorld world = new OwnWorld(scene.model, new DormandPrince853(TOLERANCE), dt, false);
        for (int k = 0; k < states.length; k++) {
            if (k == at) {
                world.kick(speed, new SplittableRandom(pattern));
            }
            world.step();
            world.read(states[k]);
        }
        return states;
    }

    /** What became of a change, over its size: x and y of each point at each instant of comparison. */
    private double[] left(double[][] plain, double[][] changed, int at) {
        double size = 0;
        for (int part = 0; part < scene.model.parts.size(); part++) {
            size = Math.max(size, change(plain[at], changed[at], part) * time / dt);
        }
        double[] left = new double[2 * scene.samples * scene.points.length];
        for (int k = 0, m = 0; k < scene.samples && size > 0; k++) {
            int row = (k + 1) * parts - 1;
            for (int p = 0; p < scene.points.length; p++) {
                double[] a = place(plain[row], p);
                double[] b = place(changed[row], p);
                left[m++] = (b[0] - a[0]) / size;
                left[m++] = (b[1] - a[1]) / size;
            }
        }
        return left;
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
