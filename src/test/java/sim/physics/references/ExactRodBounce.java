// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import org.hipparchus.dfp.Dfp;
import org.hipparchus.dfp.DfpField;

/**
 * {@link RodBounce} in 60 decimal digits, which leave 50 after the 25th impact: the times of the impacts are bracketed in
 * doubles and polished by Newton's method.
 */
public final class ExactRodBounce {
    private static final DfpField FIELD = new DfpField(60);
    private static final int NEWTON = 8;

    private final Dfp[] cornerX = new Dfp[4];
    private final Dfp[] cornerY = new Dfp[4];
    private final Dfp g;
    private final Dfp inertia;
    private Dfp t = FIELD.getZero();
    private Dfp y;
    private Dfp theta;
    private Dfp v = FIELD.getZero();
    private Dfp omega = FIELD.getZero();

    /** Height, angle, velocity, spin, gravity, and the corners, rounded. */
    private double[] near = {};

    private final double[] nearX = new double[4];
    private final double[] nearY = new double[4];

    /**
     * A rectangle of mass 1 at rest.
     *
     * @param length of the rectangle
     * @param width of the rectangle
     * @param inertia about the centre
     * @param height of the centre
     * @param angle of its length from the x axis
     * @param higher is added to the height, however small it is
     * @param more is added to the angle
     * @param g gravity, downwards
     */
    public ExactRodBounce(double length, double width, double inertia, double height, double higher, double angle, double more, double g) {
        this.g = FIELD.newDfp(g);
        this.inertia = FIELD.newDfp(inertia);
        y = FIELD.newDfp(height).add(FIELD.newDfp(higher));
        theta = FIELD.newDfp(angle).add(FIELD.newDfp(more));
        for (int k = 0; k < 4; k++) {
            nearX[k] = (k & 1) == 0 ? length / 2 : -length / 2;
            nearY[k] = (k & 2) == 0 ? width / 2 : -width / 2;
            cornerX[k] = FIELD.newDfp(nearX[k]);
            cornerY[k] = FIELD.newDfp(nearY[k]);
        }
    }

    /**
     * Goes on to the next impact and over it.
     *
     * @return its time
     */
    public Dfp next() {
        double[] found = bracket();
        int corner = (int) found[0];
        Dfp s = FIELD.newDfp(found[1]);
        for (int k = 0; k < NEWTON; k++) {
            Dfp[] turn = turn(theta.add(omega.multiply(s)));
            s = s.subtract(gap(corner, s, turn).divide(gapRate(corner, s, turn)));
        }
        y = y.add(v.multiply(s)).subtract(g.multiply(s).multiply(s).divide(2));
        v = v.subtract(g.multiply(s));
        theta = theta.add(omega.multiply(s));
        t = t.add(s);
        Dfp[] turn = turn(theta);
        Dfp arm = cornerX[corner].multiply(turn[0]).subtract(cornerY[corner].multiply(turn[1]));
        Dfp impulse = v.add(omega.multiply(arm)).multiply(-2).divide(arm.multiply(arm).divide(inertia).add(1));
        v = v.add(impulse);
        omega = omega.add(impulse.multiply(arm).divide(inertia));
        return t;
    }

    private static Dfp[] turn(Dfp angle) {
        return new Dfp[] {angle.cos(), angle.sin()};
    }

    private Dfp gap(int corner, Dfp s, Dfp[] turn) {
        Dfp low = cornerX[corner].multiply(turn[1]).add(cornerY[corner].multiply(turn[0]));
        return y.add(v.multiply(s)).subtract(g.multiply(s).multiply(s).divide(2)).add(low);
    }

    private Dfp gapRate(int corner, Dfp s, Dfp[] turn) {
        Dfp arm = cornerX[corner].multiply(turn[0]).subtract(cornerY[corner].multiply(turn[1]));
        return v.subtract(g.multiply(s)).add(omega.multiply(arm));
    }

    /** The corner that hits the floor next, and about when. */
    private double[] bracket() {
        near = new double[] {y.toDouble(), theta.toDouble(), v.toDouble(), omega.toDouble(), g.toDouble()};
        double pace = 1e-3 / (1 + Math.abs(near[3]));
        for (int k = 1; k < 1_000_000; k++) {
            double[] first = {-1, Double.POSITIVE_INFINITY};
            for (int corner = 0; corner < 4; corner++) {
                double[] now = approximately(corner, k * pace);
                double before = Math.max(approximately(corner, (k - 1) * pace)[0], 0);
                double at = (k - 1 + before / (before - now[0])) * pace;
                if (now[0] < 0 && now[1] < 0 && at < first[1]) {
                    first[0] = corner;
                    first[1] = at;
                }
            }
            if (first[0] >= 0) {
                return first;
            }
        }
        throw new IllegalStateException("no impact after " + t);
    }

    private double[] approximately(int corner, double s) {
        double angle = near[1] + near[3] * s;
        double x = nearX[corner];
        double h = nearY[corner];
        double sin = StrictMath.sin(angle);
        double cos = StrictMath.cos(angle);
        double fall = near[4] * s;
        return new double[] {
            near[0] + (near[2] - fall / 2) * s + x * sin + h * cos, near[2] - fall + near[3] * (x * cos - h * sin)
        };
    }
}
