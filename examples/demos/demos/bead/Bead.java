// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.bead;

import demos.Scene;
import java.awt.Color;
import sim.engine.SimState;
import sim.engine.Steppable;
import sim.physics.constraint.Curve;
import sim.physics.constraint.WireJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.shape.Circle;

/** The write-up's bead on a wire, (25)–(33): a force pulls it down, and the wire y = x turns it aside. */
public class Bead extends Scene {
    private static final long serialVersionUID = 1L;

    public Body bead;
    private boolean isConstrained = true;

    public Bead(long seed) {
        super(seed);
    }

    /** A force of 1 downwards. */
    private static final class Pull implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, 0, 1);
        }
    }

    /** Ends the run when the bead leaves the picture. */
    private static final class End implements Steppable {
        private static final long serialVersionUID = 1L;

        @Override
        public void step(SimState state) {
            if (((Bead) state).bead.getY() > WORLD - 5) {
                state.kill();
            }
        }
    }

    @Override
    protected void build() {
        bead = physics.add(new Body(new Circle(3)).at(50, 50));
        physics.add(new Pull());
        repeat(new End(), 20);
        if (isConstrained) {
            physics.add(new WireJoint(bead, Curve.line(0, 0, 1, 1)));
        }
    }

    @Override
    public Color ground() {
        return Color.LIGHT_GRAY;
    }

    @Override
    public Color colour(Body body) {
        return Color.RED;
    }

    public boolean isApplyConstraints() {
        return isConstrained;
    }

    /** Takes effect at the next start. */
    public void setApplyConstraints(boolean yes) {
        isConstrained = yes;
    }

    /** How far the bead is off the wire. */
    public double getGap() {
        return bead == null ? 0 : Math.abs(bead.getY() - bead.getX()) / Math.sqrt(2);
    }

    public static void main(String[] args) {
        doLoop(Bead.class, args);
        System.exit(0);
    }
}
