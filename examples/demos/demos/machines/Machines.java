// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.machines;

import demos.Scene;
import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/**
 * Machines on the ground, seen from the side: a car on springs drives to and fro through a pyramid of boxes, ragdolls fall over pegs.
 * A unit is a decimetre, y points down as on the screen, a step is 1/60 s.
 */
public class Machines extends Scene {
    private static final long serialVersionUID = 1L;

    private static final double GROUND = 190;
    private static final double FRICTION = 0.8;
    private static final double BOX = 10;

    public Car car;
    private final List<Body> boxes = new ArrayList<>();
    private int ragdolls = 3;
    private int rows = 4;

    public Machines(long seed) {
        super(seed);
    }

    @Override
    protected void build() {
        physics.setTimeStep(1 / 60.0);
        physics.add(new Gravity(0, 98.1));
        fixed(new Rectangle(WORLD, 20), WORLD / 2, GROUND + 10);
        fixed(new Rectangle(6, GROUND), 0, GROUND / 2);
        fixed(new Rectangle(6, GROUND), WORLD, GROUND / 2);
        Polygon hill = new Polygon(75, GROUND, 95, GROUND - 6, 115, GROUND);
        fixed(hill, hill.centroidX(), hill.centroidY());
        for (int row = 0; row < 3; row++) {
            for (int k = 0; k < 4; k++) {
                fixed(new Circle(3), 30 + 45 * k + (row == 1 ? -15 : 0), 65 + 25 * row);
            }
        }
        pyramid(155);
        for (int k = 0; k < ragdolls; k++) {
            double x = 40 + 120 * (k + 0.25 + 0.5 * random.nextDouble()) / ragdolls; // beside one another
            new Ragdoll(physics, FRICTION, x, 20, random.nextDouble() - 0.5);
        }
        car = new Car(physics, FRICTION, 35, GROUND);
        repeat(car, PhysicsEngine.ORDERING - 1);
    }

    private void fixed(Shape shape, double x, double y) {
        Body body = physics.add(Body.fixed(shape).at(x, y));
        body.setFriction(FRICTION);
    }

    private void pyramid(double middle) {
        boxes.clear();
        for (int row = 0; row < rows; row++) {
            for (int k = 0; k < rows - row; k++) {
                double x = middle + 1.1 * BOX * (k - 0.5 * (rows - row - 1));
                Body box = physics.add(new Body(new Rectangle(BOX, BOX)).at(x, GROUND - BOX * (row + 0.5)));
                boxes.add(box);
                box.setFriction(FRICTION);
                box.setRestitution(0);
                box.setMass(0.3 * box.getMass());
            }
        }
    }

    @Override
    public Color ground() {
        return Color.BLACK;
    }

    @Override
    public Color colour(Body body) {
        return body.isFixed() ? Color.GRAY : car.has(body) ? Color.ORANGE : boxes.contains(body) ? Color.BLUE : Color.PINK;
    }

    public int getRagdolls() {
        return ragdolls;
    }

    /** Takes effect at the next start. */
    public void setRagdolls(int number) {
        if (number < 0 || number > 6) {
            throw new IllegalArgumentException("ragdolls is " + number + ": it must be from 0 to 6");
        }
        ragdolls = number;
    }

    /** Rows of the pyramid. */
    public int getRows() {
        return rows;
    }

    /** Takes effect at the next start. */
    public void setRows(int number) {
        if (number < 0 || number > 6) {
            throw new IllegalArgumentException("rows is " + number + ": it must be from 0 to 6");
        }
        rows = number;
    }

    public double getKineticEnergy() {
        return physics == null ? 0 : physics.kineticEnergy();
    }

    public static void main(String[] args) {
        doLoop(Machines.class, args);
        System.exit(0);
    }
}
