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

    /**
     * A rectangle of mass 1 at rest.
     *
     * @param length of the rectangle
     * @param width of the rectangle
     * @param inertia about the centre
     * @param height of the centre
     * @param angle of its length from the x axis
     * @param more is added to the angle, however small it is
     * @param g gravity, downwards
     */
    public ExactRodBounce(double length, double width, double inertia, double height, double angle, double more, double g) {
        this.g = FIELD.newDfp(g);
        this.inertia = FIELD.newDfp(inertia);
        y = FIELD.newDfp(height);
        theta = FIELD.newDfp(angle).add(FIELD.newDfp(more));
        for (int k = 0; k < 4; k++) {
            cornerX[k] = FIELD.newDfp((k & 1) == 0 ? length / 2 : -length / 2);
            cornerY[k] = FIELD.newDfp((k & 2) == 0 ? width / 2 : -width / 2);
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
        double pace = 1e-3 / (1 + Math.abs(omega.toDouble()));
        for (int k = 1; ; k++) {
            for (int corner = 0; corner < 4; corner++) {
                double[] now = approximately(corner, k * pace);
                double[] before = approximately(corner, (k - 1) * pace);
                if (now[0] < 0 && now[1] < 0) {
                    boolean isSteep = before[0] > 0;
                    return new double[] {lowest(k * pace), isSteep ? (k - 1) * pace + pace * before[0] / (before[0] - now[0]) : k * pace};
                }
            }
        }
    }

    private int lowest(double s) {
        int corner = 0;
        for (int k = 1; k < 4; k++) {
            corner = approximately(k, s)[0] < approximately(corner, s)[0] ? k : corner;
        }
        return corner;
    }

    private double[] approximately(int corner, double s) {
        double angle = theta.toDouble() + omega.toDouble() * s;
        double x = cornerX[corner].toDouble();
        double h = cornerY[corner].toDouble();
        double sin = StrictMath.sin(angle);
        double cos = StrictMath.cos(angle);
        double fall = g.toDouble() * s;
        return new double[] {
            y.toDouble() + (v.toDouble() - fall / 2) * s + x * sin + h * cos,
            v.toDouble() - fall + omega.toDouble() * (x * cos - h * sin)
        };
    }
}
