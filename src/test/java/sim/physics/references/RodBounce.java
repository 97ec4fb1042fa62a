// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

/**
 * A smooth rod, 1 m long and of 1 kg, that falls on a smooth floor and bounces off it elastically: parabolas between the
 * impacts of its corners, whose times are found by bisection of a fine sampling.
 */
public final class RodBounce {
    private static final double G = 9.81;
    private static final double INERTIA = 1 / 12.0;
    private static final double SAMPLE = 1e-4;

    private final double halfThickness;
    private double time;
    private double y;
    private double angle;
    private double speed;
    private double spin;

    private RodBounce(double y, double angle, double halfThickness) {
        this.y = y;
        this.angle = angle;
        this.halfThickness = halfThickness;
    }

    /**
     * The state after a time.
     *
     * @param height of the centre at first, at rest
     * @param angle at first
     * @param halfThickness of the rod
     * @param end time
     * @return height, angle, number of impacts, time of the last one
     */
    public static double[] after(double height, double angle, double halfThickness, double end) {
        RodBounce rod = new RodBounce(height, angle, halfThickness);
        int impacts = 0;
        double last = 0;
        while (rod.fly(end)) {
            impacts++;
            last = rod.time;
        }
        return new double[] {rod.y, rod.angle, impacts, last};
    }

    /** The height of the lowest corner after a time of flight. */
    private double lowest(double s) {
        double theta = angle + s * spin;
        double reach = 0.5 * Math.abs(StrictMath.sin(theta)) + halfThickness * Math.abs(StrictMath.cos(theta));
        return y + s * (speed - 0.5 * G * s) - reach;
    }

    /** Flies to the next impact, and bounces; false if the end comes first. */
    private boolean fly(double end) {
        double s = 1e-9;
        while (lowest(s) >= 0) {
            s += SAMPLE;
            if (time + s >= end) {
                move(end - time);
                return false;
            }
        }
        double low = Math.max(1e-9, s - SAMPLE);
        double high = s;
        for (int k = 0; k < 80; k++) {
            double middle = 0.5 * (low + high);
            if (lowest(middle) >= 0) {
                low = middle;
            } else {
                high = middle;
            }
        }
        move(0.5 * (low + high));
        double sin = StrictMath.sin(angle);
        double cos = StrictMath.cos(angle);
        double up = cos > 0 ? -1 : 1;
        double arm = (sin > 0 ? -0.5 : 0.5) * cos - up * halfThickness * sin;
        double approach = speed + spin * arm;
        double impulse = -2 * approach / (1 + arm * arm / INERTIA);
        speed += impulse;
        spin += impulse * arm / INERTIA;
        return true;
    }

    private void move(double s) {
        y += s * (speed - 0.5 * G * s);
        speed -= G * s;
        angle += s * spin;
        time += s;
    }
}
