// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import java.util.function.UnaryOperator;
import org.hipparchus.analysis.integration.gauss.FieldGaussIntegratorFactory;
import org.hipparchus.dfp.Dfp;
import org.hipparchus.dfp.DfpField;

/**
 * The motion of what has one coordinate q, and whose energy says how fast q grows at q: the time is the integral of 1/q̇ over q.
 * In decimal numbers of 28 digits, by panels of Gauss and Legendre, so that nothing of it is lost to rounding or to steps.
 */
final class Quadrature {
    private static final int DIGITS = 28;
    private static final int NODES = 20;

    private final UnaryOperator<Dfp> slowness;
    private final Dfp start;
    private final boolean fromRest;
    private final double panel;

    /**
     * A motion.
     *
     * @param slowness 1/q̇ at q
     * @param start q at time 0
     * @param fromRest whether q̇ is 0 there, so that 1/q̇ is as 1/√(q − start)
     * @param panel of q that 20 nodes resolve, or of √(q − start) from rest
     */
    Quadrature(UnaryOperator<Dfp> slowness, Dfp start, boolean fromRest, double panel) {
        this.slowness = slowness;
        this.start = start;
        this.fromRest = fromRest;
        this.panel = panel;
    }

    /** The numbers that references of this kind are made of. */
    static DfpField digits() {
        return new DfpField(DIGITS);
    }

    /** The decimal number that a double stands for where it was written down. */
    static Dfp decimal(DfpField field, double x) {
        return field.newDfp(Double.toString(x));
    }

    /**
     * Where it is.
     *
     * @param t times, ascending
     * @param near q at these times to 10⁻⁹ or better, from elsewhere
     * @return q at these times
     */
    Dfp[] coordinates(double[] t, double[] near) {
        Dfp[] q = new Dfp[t.length];
        Dfp time = start.getZero();
        Dfp from = start.getZero();
        for (int k = 0; k < t.length; k++) {
            Dfp guess = start.newInstance(near[k]);
            Dfp to = fromRest ? guess.subtract(start).sqrt() : guess.subtract(start);
            time = time.add(between(from, to));
            from = to;
            // one step of Newton: what is left is of the order of the guess's error squared
            q[k] = guess.add(decimal(start.getField(), t[k]).subtract(time).divide(slowness.apply(guess)));
        }
        return q;
    }

    private Dfp between(Dfp from, Dfp to) {
        int panels = 1 + (int) (to.subtract(from).toDouble() / panel);
        Dfp width = to.subtract(from).divide(panels);
        var gauss = new FieldGaussIntegratorFactory<>(start.getField());
        Dfp sum = start.getZero();
        for (int k = 0; k < panels; k++) {
            Dfp a = from.add(width.multiply(k));
            sum = sum.add(gauss.legendre(NODES, a, a.add(width)).integrate(this::weight));
        }
        return sum;
    }

    /** dt/du, where q = start + u², or start + u. */
    private Dfp weight(Dfp u) {
        return fromRest
                ? slowness.apply(start.add(u.multiply(u))).multiply(u).multiply(2)
                : slowness.apply(start.add(u));
    }
}
