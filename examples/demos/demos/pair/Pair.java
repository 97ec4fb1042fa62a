// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.pair;

import demos.Scene;
import java.awt.Color;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Two bars that are pinned together, with a disc on the pin, and a box, between four walls. Their energy is kept. */
public class Pair extends Scene {
    private static final long serialVersionUID = 1L;

    public Body disc;

    public Pair(long seed) {
        super(seed);
    }

    @Override
    protected void build() {
        physics.add(Body.fixed(new Rectangle(180, 6)).at(100, 10));
        physics.add(Body.fixed(new Rectangle(180, 6)).at(100, 190));
        physics.add(Body.fixed(new Rectangle(6, 180)).at(10, 100));
        physics.add(Body.fixed(new Rectangle(6, 180)).at(190, 100));
        physics.add(new Body(new Rectangle(10, 20)).at(100, 100).moving(1, 1)).setMass(200);
        Body left = physics.add(new Body(new Rectangle(20, 10)).at(50, 50).moving(0.5, 0.5));
        Body right = physics.add(new Body(new Rectangle(20, 10)).at(90, 50).moving(0.5, 0.5));
        disc = physics.add(new Body(new Circle(3)).at(70, 50).moving(0.5, 0.5));
        left.setMass(200);
        right.setMass(200);
        PinJoint pin = new PinJoint(left, right, 70, 50);
        pin.setCollideConnected(true);
        physics.add(pin);
        physics.add(new PinJoint(left, disc, 70, 50));
        physics.setCollisions(right, disc, false);
    }

    @Override
    public Color ground() {
        return new Color(0, 80, 0);
    }

    @Override
    public Color colour(Body body) {
        return body.isFixed() ? Color.WHITE : body == disc ? Color.BLUE : Color.RED;
    }

    public double getKineticEnergy() {
        return physics == null ? 0 : physics.kineticEnergy();
    }

    public static void main(String[] args) {
        doLoop(Pair.class, args);
        System.exit(0);
    }
}
