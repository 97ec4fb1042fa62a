// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

/** The energy that the impulses of a {@link HeapSystem} give, and how to take all of it. */
final class HeapEnergy {
    /** What surfaces give and take, relative to what makes bodies as fast as they are: more than their weight rubs off. */
    private static final double RUBBED = 10;

    /** Part of the squares of impulses that those are of what they give together, where they press against one another; and where a plane may hold bodies. */
    static final double LOCKED = 1e-4;

    static final double HELD = 1e-2;

    private HeapEnergy() {}

    /**
     * Twice the kinetic energy that the bodies have more than with other velocities, mostly those without impulses; without that of motors
     * and of moving surfaces, as far as bodies can bear it. What these give that is lost at once is not counted as lost.
     */
    static double gained(HeapSystem s, double[] from) {
        double fastest = s.fastestBelt();
        double gained = gainedOrLost(s, from);
        return fastest == 0 ? gained : Math.max(Math.min(0, gained), gained - 2 * Math.min(given(s), bearable(s, from, fastest)));
    }

    /**
     * Whether moving surfaces have wedged bodies: these have more from other velocities on than surfaces give that take them along, or are
     * given or lose much more.
     */
    static boolean isWedged(HeapSystem s, double[] from) {
        double fastest = s.fastestBelt();
        if (fastest == 0) {
            return false;
        }
        double bearable = bearable(s, from, fastest);
        return gainedOrLost(s, from) > 2 * bearable || exchanged(s) > RUBBED * bearable;
    }

    /** What moving surfaces give and take. */
    private static double exchanged(HeapSystem s) {
        double work = 0;
        for (int p = 0; p < s.contacts(); p++) {
            work += Math.abs(s.tangentImpulse(p) * s.belt(p));
        }
        return work;
    }

    /**
     * What surfaces give at most that make bodies as fast as the fastest of them, which had these velocities: bodies that they wedge
     * would be given any amount.
     */
    private static double bearable(HeapSystem s, double[] from, double fastest) {
        double sum = 0;
        for (int k = 0; k < s.bodyCount(); k++) {
            if (s.w[2 * k] > 0) {
                double spin = from[3 * k + 2] * from[3 * k + 2] * s.w[2 * k] / s.w[2 * k + 1];
                double speed = Math.sqrt(from[3 * k] * from[3 * k] + from[3 * k + 1] * from[3 * k + 1] + spin);
                sum += fastest * (fastest + speed) / s.w[2 * k];
            }
        }
        return sum;
    }

    /** The work of moving surfaces. */
    static double given(HeapSystem s) {
        double work = 0;
        for (int p = 0; p < s.contacts(); p++) {
            work -= s.belt(p) == 0 ? 0 : s.tangentImpulse(p) * s.belt(p);
        }
        return work;
    }

    private static double gainedOrLost(HeapSystem s, double[] from) {
        double sum = 0;
        for (int p = 0; s.isTied() && p < s.size(); p++) {
            double jn = s.isMotor(p) ? 0 : s.normalImpulse(p);
            double jt = s.tangentImpulse(p);
            sum += jn == 0 ? 0 : jn * (s.normal(p, s.v) + s.normal(p, from));
            sum += jt == 0 ? 0 : jt * (s.tangent(p, s.v) + s.tangent(p, from));
        }
        return s.isTied() ? sum : gainedAlone(s, from);
    }

    /** The work of contacts and stops over a time in which velocities change evenly from some to those of the system. */
    static double work(HeapSystem s, double[] from) {
        double sum = 0;
        for (int p = 0; p < s.size(); p++) {
            double jn = s.isMotor(p) ? 0 : s.normalImpulse(p);
            double jt = s.tangentImpulse(p);
            PointRows rows = p < s.contacts() ? s.pressing() : s.rows();
            sum += jn == 0 ? 0 : jn * (rows.normal(p, s.v) + rows.normal(p, from));
            sum += jt == 0 ? 0 : jt * (rows.tangent(p, s.v) + rows.tangent(p, from));
        }
        return 0.5 * sum;
    }

    /**
     * Whether impulses press against one another, and give bodies next to nothing together, also such as can move: they grow without end where friction locks
     * what would have to part.
     *
     * @param part of the squares of impulses that those are at most of what they give together
     */
    static boolean locks(HeapSystem s, double part) {
        double[] sum = s.scratch();
        s.momenta(sum);
        double together = 0;
        for (int k = 0; k < 3 * s.bodyCount(); k += 3) {
            together += sum[k] * sum[k] + sum[k + 1] * sum[k + 1];
        }
        return together < part * squares(s);
    }

    /** The squares of the impulses of contacts. */
    static double squares(HeapSystem s) {
        double sum = 0;
        for (int p = 0; p < s.contacts(); p++) {
            sum += s.normalImpulse(p) * s.normalImpulse(p) + s.tangentImpulse(p) * s.tangentImpulse(p);
        }
        return sum;
    }

    /** Twice the kinetic energy of the bodies that can move, with some velocities. */
    static double of(HeapSystem s, double[] v) {
        double sum = 0;
        for (int k = 0; k < s.bodyCount(); k++) {
            sum += of(s, v, k);
        }
        return sum;
    }

    /** The same, of one body. */
    static double of(HeapSystem s, double[] v, int k) {
        double way = v[3 * k] * v[3 * k] + v[3 * k + 1] * v[3 * k + 1];
        return s.w[2 * k] == 0 ? 0 : way / s.w[2 * k] + v[3 * k + 2] * v[3 * k + 2] / s.w[2 * k + 1];
    }

    private static double gainedAlone(HeapSystem s, double[] from) {
        double sum = 0;
        for (int k = 0; k < s.bodyCount(); k++) {
            sum += gainedBy(s, from, k);
        }
        return sum;
    }

    /** What one body has gained that nothing ties, twice as much. */
    static double gainedBy(HeapSystem s, double[] from, int k) {
        if (s.w[2 * k] == 0) {
            return 0; // held
        }
        double x = s.v[3 * k] - from[3 * k];
        double y = s.v[3 * k + 1] - from[3 * k + 1];
        double turn = s.v[3 * k + 2] - from[3 * k + 2];
        return (x * (s.v[3 * k] + from[3 * k]) + y * (s.v[3 * k + 1] + from[3 * k + 1])) / s.w[2 * k]
                + turn * (s.v[3 * k + 2] + from[3 * k + 2]) / s.w[2 * k + 1];
    }
}
