// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.pendulum;

import demos.Scene;
import java.awt.Color;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.Stabilization;
import sim.physics.motion.Body;
import sim.physics.motion.Euler;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * The write-up's pendulum, Figure 3: a bar that is let go from the horizontal. With Euler's method and the feedback that
 * many engines keep their joints closed with it ends its first swing 28 degrees above; with RK4 it does not.
 */
public class Pendulum extends Scene {
    private static final long serialVersionUID = 1L;

    private static final double FORCE = 5;

    public Body bar;
    private boolean usesEuler;

    public Pendulum(long seed) {
        super(seed);
    }

    @Override
    protected void build() {
        Body anchor = physics.add(Body.fixed(new Circle(5)).at(100, 50));
        bar = physics.add(new Body(new Rectangle(20, 5)).at(80, 50));
        bar.setMass(100);
        physics.add(new PinJoint(anchor, bar, 100, 50));
        physics.add(new Gravity(0, FORCE / 100));
        if (usesEuler) {
            physics.setIntegrator(new Euler());
            physics.setStabilization(Stabilization.feedback(0.3, 0.3));
        }
    }

    @Override
    public Color ground() {
        return Color.WHITE;
    }

    @Override
    public Color colour(Body body) {
        return body == bar ? Color.RED : Color.GRAY;
    }

    public boolean isUseEuler() {
        return usesEuler;
    }

    /** Takes effect at the next start. */
    public void setUseEuler(boolean yes) {
        usesEuler = yes;
    }

    /** Kinetic energy and that in the field of force; 0 at the start. */
    public double getEnergy() {
        return bar == null ? 0 : bar.kineticEnergy() - FORCE * (bar.getY() - 50);
    }

    public static void main(String[] args) {
        doLoop(Pendulum.class, args);
        System.exit(0);
    }
}
