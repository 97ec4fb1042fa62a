// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.collisions;

import demos.Scene;
import ec.util.MersenneTwisterFast;
import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import sim.physics.collision.narrow.Distance;
import sim.physics.motion.Body;
import sim.physics.motion.Euler;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;
import sim.util.Interval;

/**
 * The write-up's <i>collisions</i>: circles and rectangles bounce around between four walls. Without friction and with
 * restitution 1 they do so for ever, and keep their energy.
 *
 * <p>Figure 1 of the write-up shows 50 circles and 50 rectangles of size 5 with the walls at 0.
 */
public class Collisions extends Scene {
    private static final long serialVersionUID = 1L;

    private static final int MAX_TRIES = 20_000;
    private static final double WEIGHT = 0.1;

    /** The bodies that move. */
    public final List<Body> movers = new ArrayList<>();

    private int circles = 5;
    private int rectangles = 5;
    private double size = 7;
    private double wallPosition = 10;
    private double friction;
    private double restitution = 1;

    public Collisions(long seed) {
        super(seed);
    }

    @Override
    protected void build() {
        physics.setIntegrator(new Euler());
        physics.add(new SurfaceFriction(WEIGHT));
        movers.clear();
        double inner = WORLD - 2 * wallPosition;
        wall(inner, 6, 0.5 * WORLD, wallPosition);
        wall(inner, 6, 0.5 * WORLD, WORLD - wallPosition);
        wall(6, inner, wallPosition, 0.5 * WORLD);
        wall(6, inner, WORLD - wallPosition, 0.5 * WORLD);
        for (int k = 0; k < circles; k++) {
            place(new Circle(size), 1);
        }
        for (int k = 0; k < rectangles; k++) {
            place(new Rectangle(size, 2 * size), 2);
        }
    }

    @Override
    public Color ground() {
        return new Color(0, 80, 0);
    }

    @Override
    public Color colour(Body body) {
        return body.isFixed() ? Color.WHITE : Color.RED;
    }

    private void wall(double width, double height, double x, double y) {
        physics.add(Body.fixed(new Rectangle(width, height)).at(x, y));
    }

    /** Puts a body where it touches nothing, with a random velocity. */
    private void place(Shape shape, double speed) {
        Distance distance = new Distance();
        Body body = new Body(shape);
        double low = wallPosition + 3;
        for (int tries = 0; tries < MAX_TRIES; tries++) {
            double x = low + random.nextDouble() * (WORLD - 2 * low);
            double y = low + random.nextDouble() * (WORLD - 2 * low);
            if (isFree(body.at(x, y), distance)) {
                body.setVelocity(speed * component(random), speed * component(random));
                body.setRestitution(restitution);
                body.setSurfaceFriction(friction);
                movers.add(physics.add(body));
                return;
            }
        }
        throw new IllegalStateException(circles + " circles and " + rectangles + " rectangles of size " + size
                + " were asked for: only " + movers.size() + " bodies fit without overlap");
    }

    private boolean isFree(Body body, Distance distance) {
        for (Body other : physics.bodies()) {
            if (distance.between(body, other) <= 0) {
                return false;
            }
        }
        return true;
    }

    private static double component(MersenneTwisterFast random) {
        double magnitude = random.nextDouble();
        return random.nextBoolean() ? magnitude : -magnitude;
    }

    public int getCircles() {
        return circles;
    }

    /** Takes effect at the next start. */
    public void setCircles(int number) {
        circles = notNegative("circles", number);
    }

    public int getRectangles() {
        return rectangles;
    }

    /** Takes effect at the next start. */
    public void setRectangles(int number) {
        rectangles = notNegative("rectangles", number);
    }

    private static int notNegative(String name, int number) {
        if (number < 0) {
            throw new IllegalArgumentException(name + " is " + number + ": it must not be negative");
        }
        return number;
    }

    public double getSize() {
        return size;
    }

    /** Radius of the circles and width of the rectangles; takes effect at the next start. */
    public void setSize(double length) {
        if (!(length > 0 && length < WORLD)) {
            throw new IllegalArgumentException("size is " + length + ": it must be greater than 0 and less than 200");
        }
        size = length;
    }

    public double getWallPosition() {
        return wallPosition;
    }

    /** Takes effect at the next start. */
    public void setWallPosition(double position) {
        if (!(position >= 0 && position < 0.4 * WORLD)) {
            throw new IllegalArgumentException("wall position is " + position + ": it must be from 0 to 80");
        }
        wallPosition = position;
    }

    public double getCoefficientOfFriction() {
        return friction;
    }

    /** Friction between the bodies and the ground; takes effect at once. */
    public void setCoefficientOfFriction(double mu) {
        if (!(mu >= 0 && mu <= 10)) {
            throw new IllegalArgumentException("coefficient of friction is " + mu + ": it must be from 0 to 10");
        }
        friction = mu;
        for (Body body : movers) {
            body.setSurfaceFriction(mu);
        }
    }

    public Object domCoefficientOfFriction() {
        return new Interval(0.0, 1.0);
    }

    public double getCoefficientOfRestitution() {
        return restitution;
    }

    /** How much of their speed bodies keep in a collision; takes effect at once. */
    public void setCoefficientOfRestitution(double e) {
        if (!(e >= 0 && e <= 1)) {
            throw new IllegalArgumentException("coefficient of restitution is " + e + ": it must be from 0 to 1");
        }
        restitution = e;
        for (Body body : movers) {
            body.setRestitution(e);
        }
    }

    public Object domCoefficientOfRestitution() {
        return new Interval(0.0, 1.0);
    }

    public double getKineticEnergy() {
        return physics == null ? 0 : physics.kineticEnergy();
    }

    public static void main(String[] args) {
        doLoop(Collisions.class, args);
        System.exit(0);
    }
}
