// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import org.hipparchus.ode.OrdinaryDifferentialEquation;

/** A box that falls over one of its corners, which stays where it is: a pendulum that stands on its head. */
public final class TippingBox {
    private final double arm;
    private final double pull;
    private final double corner;

    /**
     * A box.
     *
     * @param width of its lower side
     * @param height of the others
     * @param g gravity
     */
    public TippingBox(double width, double height, double g) {
        double square = (width * width + height * height) / 4;
        arm = Math.sqrt(square);
        pull = g * arm / (square / 3 + square);
        corner = Math.atan2(width, height);
    }

    /**
     * Where it is.
     *
     * @param turn by which it leans at time 0, at rest
     * @param t time
     * @return centre relative to the corner on which it stands, by how much it leans, and how fast that changes
     */
    public double[] at(double turn, double t) {
        return at(turn, 0, t);
    }

    /**
     * Where it is.
     *
     * @param turn by which it leans at time 0
     * @param rate how fast it falls then
     * @param t time
     * @return centre relative to the corner on which it stands, by how much it leans, and how fast that changes
     */
    public double[] at(double turn, double rate, double t) {
        OrdinaryDifferentialEquation equation = new OrdinaryDifferentialEquation() {
            @Override
            public int getDimension() {
                return 2;
            }

            @Override
            public double[] computeDerivatives(double time, double[] s) {
                return new double[] {s[1], pull * Math.sin(s[0])};
            }
        };
        double[] s = t == 0
                ? new double[] {turn - corner, rate}
                : RodChain.integrate(equation, new double[] {turn - corner, rate}, new double[] {t}, false, 1e-13)[0];
        return new double[] {arm * Math.sin(s[0]), arm * Math.cos(s[0]), s[0] + corner, s[1]};
    }
}
