// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.doors;

import demos.Scene;
import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Two doors in a wall, as in the write-up's J of two hinges, and balls that knock them open. */
public class Doors extends Scene {
    private static final long serialVersionUID = 1L;

    private static final double MIDDLE = WORLD / 2;

    public final List<Body> doors = new ArrayList<>();
    private int balls = 6;

    public Doors(long seed) {
        super(seed);
    }

    @Override
    protected void build() {
        doors.clear();
        physics.add(Body.fixed(new Rectangle(WORLD, 6)).at(MIDDLE, 0));
        physics.add(Body.fixed(new Rectangle(WORLD, 6)).at(MIDDLE, WORLD));
        physics.add(Body.fixed(new Rectangle(6, WORLD - 6)).at(0, MIDDLE));
        physics.add(Body.fixed(new Rectangle(6, WORLD - 6)).at(WORLD, MIDDLE));
        door(frame(21.5, 37), 42, 1);
        frame(99, 14);
        frame(101, 14);
        door(frame(178.5, 37), 158, -1);
        for (int k = 0; k < balls; k++) {
            double x = 15 + 170.0 * (k + 0.5) / balls;
            double y = k % 2 == 0 ? 30 + random.nextDouble() * 30 : 140 + random.nextDouble() * 30;
            physics.add(new Body(new Circle(5)).at(x, y).moving(random.nextDouble() - 0.5, k % 2 == 0 ? 1 : -1));
        }
    }

    private Body frame(double x, double width) {
        return physics.add(Body.fixed(new Rectangle(width, 6)).at(x, MIDDLE));
    }

    /** A door of length 46, hinged to a frame at its end. */
    private void door(Body frame, double hinge, int side) {
        Body door = physics.add(new Body(new Rectangle(46, 4)).at(hinge + side * 23, MIDDLE));
        physics.add(new PinJoint(frame, door, hinge, MIDDLE));
        doors.add(door);
    }

    @Override
    public Color ground() {
        return new Color(0, 80, 0);
    }

    @Override
    public Color colour(Body body) {
        return body.isFixed() ? Color.WHITE : doors.contains(body) ? Color.ORANGE : Color.RED;
    }

    public int getBalls() {
        return balls;
    }

    /** Takes effect at the next start. */
    public void setBalls(int number) {
        if (number < 0 || number > 14) {
            throw new IllegalArgumentException("balls is " + number + ": it must be from 0 to 14");
        }
        balls = number;
    }

    public double getKineticEnergy() {
        return physics == null ? 0 : physics.kineticEnergy();
    }

    public static void main(String[] args) {
        doLoop(Doors.class, args);
        System.exit(0);
    }
}
