// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import java.util.Arrays;
import org.hipparchus.dfp.Dfp;
import org.hipparchus.dfp.DfpField;
import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.hipparchus.util.FastMath;
import org.hipparchus.util.FieldSinCos;

/**
 * A crank of length r that turns about the origin, a rod of length l, both uniform and of mass 1, and a block of mass 1 that
 * slides on y = 0. With θ the crank's angle the rod's is ψ = −asin(r sin θ / l), and the motion is that of the conserved energy,
 *
 * <pre>
 *   θ̇² M(θ) / 2 + g r sin θ = E,     M = r²/3 + |c′|² + ψ′² l²/12 + x′²,   c the rod's centre, x the block
 * </pre>
 */
public final class SliderCrank implements OrdinaryDifferentialEquation {
    private final double r;
    private final double l;
    private final double g;
    private final double start;
    private final double rate;
    private final double energy;

    /**
     * A slider-crank that turns on and on.
     *
     * @param r length of the crank
     * @param l length of the rod
     * @param g gravity, downwards
     * @param angle of the crank at the start
     * @param rate of that angle
     */
    public SliderCrank(double r, double l, double g, double angle, double rate) {
        this.r = r;
        this.l = l;
        this.g = g;
        this.start = angle;
        this.rate = rate;
        energy = rate * rate * inertia(angle) / 2 + g * r * Math.sin(angle);
    }

    /** M. */
    private double inertia(double angle) {
        double sin = Math.sin(angle);
        double cos = Math.cos(angle);
        double reach = Math.sqrt(l * l - r * r * sin * sin);
        double turn = -r * cos / reach;
        double slide = -r * sin - r * r * sin * cos / reach;
        double cx = (slide - r * sin) / 2;
        double cy = r * cos / 2;
        return r * r / 3 + cx * cx + cy * cy + turn * turn * l * l / 12 + slide * slide;
    }

    @Override
    public int getDimension() {
        return 1;
    }

    @Override
    public double[] computeDerivatives(double t, double[] y) {
        return new double[] {Math.sqrt(2 * (energy - g * r * Math.sin(y[0])) / inertia(y[0]))};
    }

    /**
     * The crank's angle.
     *
     * @param start at time 0
     * @param t times, ascending
     * @param gragg whether by Gragg, Bulirsch and Stoer, else by Dormand and Prince 8(5,3)
     * @param tolerance of the integrator
     * @return for each time
     */
    public double[] angles(double start, double[] t, boolean gragg, double tolerance) {
        double[][] states = RodChain.integrate(this, new double[] {start}, t, gragg, tolerance);
        double[] angles = new double[t.length];
        for (int k = 0; k < t.length; k++) {
            angles[k] = states[k][0];
        }
        return angles;
    }

    /**
     * The crank's angle from the energy alone, by {@link Quadrature}.
     *
     * @param t times, ascending
     * @param near the angles there to 10⁻⁹ or better
     * @return for each time
     */
    public double[] exactAngles(double[] t, double[] near) {
        DfpField field = Quadrature.digits();
        Dfp from = Quadrature.decimal(field, start);
        Dfp v = Quadrature.decimal(field, rate);
        Dfp gravity = Quadrature.decimal(field, g * r);
        Dfp twice = v.multiply(v).multiply(inertia(from)).add(FastMath.sin(from).multiply(gravity).multiply(2));
        Quadrature way = new Quadrature(
                q -> inertia(q).divide(twice.subtract(FastMath.sin(q).multiply(gravity).multiply(2))).sqrt(), from, false, 0.2);
        return Arrays.stream(way.coordinates(t, near)).mapToDouble(Dfp::toDouble).toArray();
    }

    /** {@link #inertia(double)} in these digits. */
    private Dfp inertia(Dfp angle) {
        FieldSinCos<Dfp> turn = FastMath.sinCos(angle);
        Dfp crank = Quadrature.decimal(angle.getField(), r);
        Dfp rod = Quadrature.decimal(angle.getField(), l);
        Dfp y = turn.sin().multiply(crank);
        Dfp x = turn.cos().multiply(crank);
        Dfp reach = rod.multiply(rod).subtract(y.multiply(y)).sqrt();
        Dfp rodTurns = x.multiply(rod).divide(reach);
        Dfp slide = y.add(y.multiply(x).divide(reach));
        Dfp cx = slide.add(y);
        return crank.multiply(crank).divide(3)
                .add(cx.multiply(cx).add(x.multiply(x)).divide(4))
                .add(rodTurns.multiply(rodTurns).divide(12))
                .add(slide.multiply(slide));
    }

    /**
     * The mechanism at an angle.
     *
     * @param angle of the crank
     * @return x, y of the crank's end, of the rod's centre, of the block
     */
    public double[] places(double angle) {
        double px = r * StrictMath.cos(angle);
        double py = r * StrictMath.sin(angle);
        double x = px + StrictMath.sqrt(l * l - py * py);
        return new double[] {px, py, (px + x) / 2, py / 2, x, 0};
    }
}
