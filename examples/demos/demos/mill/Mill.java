// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.mill;

import demos.Scene;
import java.awt.Color;
import java.util.List;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Shape;

/**
 * A motor turns a toothed wheel, whose teeth turn a drum, in which hooks, dumbbells and balls tumble. y points down as on the screen, a step
 * is 1/60 s.
 */
public class Mill extends Scene {
    private static final long serialVersionUID = 1L;

    /** Teeth of the drum and of the wheel. */
    public static final int DRUM = 48;

    public static final int WHEEL = 12;

    private static final double MODULE = 2.9;

    /** How much farther apart the two are than where they would roll on one another. */
    private static final double PLAY = 1.01;

    private static final double X = 118;
    private static final double Y = 96;

    public Body drum;
    public Body wheel;
    public Motor motor;

    private int pieces = 20;
    private double motorSpeed = 4;

    public Mill(long seed) {
        super(seed);
    }

    @Override
    protected void build() {
        physics.setTimeStep(1.0 / 60);
        physics.add(new Gravity(0, 98.1));
        double apart = PLAY * (Toothed.pitchRadius(DRUM, MODULE) + Toothed.pitchRadius(WHEEL, MODULE));
        double angle = 0.8 * Math.PI; // from the drum to the wheel
        double pitch = 2 * Math.PI / DRUM;
        drum = physics.add(new Body(Toothed.drum(DRUM, MODULE, 24, 6, 4, 11)).at(X, Y, angle - 0.5 * pitch)); // a gap faces the wheel
        wheel = physics.add(new Body(Toothed.pinion(WHEEL, MODULE))
                .at(X + apart * StrictMath.cos(angle), Y + apart * StrictMath.sin(angle), angle + Math.PI)); // and this a tooth
        for (Body body : List.of(drum, wheel)) {
            physics.add(new PinJoint(body, body.getX(), body.getY()));
            rough(body, 0);
        }
        motor = physics.add(Motor.turning(wheel, null, motorSpeed, 1e9));
        for (int k = 0; k < pieces; k++) {
            rough(physics.add(new Body(piece(k)).at(X - 30 + 15 * (k % 5), Y - 28 + 14 * (k / 5), random.nextDouble())), 0.2);
        }
    }

    private static void rough(Body body, double restitution) {
        body.setFriction(0.5);
        body.setRestitution(restitution);
    }

    private static Shape piece(int k) {
        return switch (k % 3) {
            case 0 -> Compound.outline(0, 0, 10, 0, 10, 3, 3, 3, 3, 8, 0, 8);
            case 1 -> new Compound(Compound.disc(-4, 0, 2.5), Compound.disc(4, 0, 2.5), Compound.box(0, 0, 4, 1.5));
            default -> new Circle(3.5);
        };
    }

    @Override
    public Color ground() {
        return Color.WHITE;
    }

    @Override
    public Color colour(Body body) {
        if (body == drum) {
            return Color.GRAY;
        }
        return body == wheel ? Color.RED : body.getShape() instanceof Circle ? Color.ORANGE : Color.BLUE;
    }

    public int getPieces() {
        return pieces;
    }

    /** Takes effect at the next start. */
    public void setPieces(int number) {
        if (number < 0 || number > 25) {
            throw new IllegalArgumentException("pieces is " + number + ": it must be from 0 to 25");
        }
        pieces = number;
    }

    /** rad/s. */
    public double getMotorSpeed() {
        return motorSpeed;
    }

    /** Takes effect at once. */
    public void setMotorSpeed(double speed) {
        if (motor != null) {
            motor.setSpeed(speed);
        }
        motorSpeed = speed;
    }

    public double getDrumSpeed() {
        return drum == null ? 0 : drum.getAngularVelocity();
    }

    public static void main(String[] args) {
        doLoop(Mill.class, args);
        System.exit(0);
    }
}
