// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static sim.physics.regression.EditedWorld.signed;
import static sim.physics.regression.Edits.any;

import java.io.Serializable;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Curve;
import sim.physics.constraint.GearJoint;
import sim.physics.constraint.Joint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.PulleyJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.SlotJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.constraint.Wheel;
import sim.physics.constraint.WireJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Spring;

/** Joints, limits, motors and springs between bodies of an {@link EditedWorld} that are drawn at random, and what is set of them. */
final class DrawnTies implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int KINDS = 16;

    private final EditedWorld world;

    // of the last draw: the tie, a motor or a limit of it, or a spring in its place; null if there is none
    private transient Constraint tie;
    private transient Constraint extra;
    private transient Spring spring;

    // of the same: two bodies, the second one null for the world; where they are, and numbers of 0 to 1 and of -1 to 1
    private transient Body a;
    private transient Body b;
    private transient double bx;
    private transient double by;
    private transient double u;
    private transient double w;
    private transient double z;
    private transient double px;
    private transient double py;

    DrawnTies(EditedWorld world) {
        this.world = world;
    }

    /** Draws a tie between bodies of the world, and adds nothing; null if it is a spring. */
    Constraint draw(SplittableRandom r) {
        List<Body> all = world.engine.bodies();
        if (all.isEmpty()) {
            return null;
        }
        a = any(all, r);
        b = r.nextInt(4) == 0 ? null : any(all, r);
        int kind = r.nextInt(KINDS);
        u = r.nextDouble();
        w = signed(r);
        z = r.nextDouble();
        px = signed(r);
        py = signed(r);
        bx = b == null ? a.getX() + px * world.length : b.getX();
        by = b == null ? a.getY() + py * world.length : b.getY();
        extra = null;
        spring = null;
        tie = make(kind);
        return tie;
    }

    /** Adds what was drawn last; a motor or limit of it may be refused by itself. */
    void add(Consumer<ForceGenerator> forces) {
        if (spring != null) {
            forces.accept(spring);
            return;
        }
        world.engine.add(tie);
        if (extra != null) {
            try {
                world.engine.add(extra);
            } catch (IllegalArgumentException | IllegalStateException e) {
                extra = null;
            }
        }
    }

    private Constraint make(int kind) {
        double length = world.length;
        double torque = world.force() * length;
        double x = 0.5 * (a.getX() + bx);
        double y = 0.5 * (a.getY() + by);
        double dx = bx - a.getX();
        double dy = by - a.getY();
        double apart = Math.sqrt(dx * dx + dy * dy);
        if (apart == 0) {
            dx = length;
            apart = length;
        }
        switch (kind) {
            case 0, 1 -> {
                return new PinJoint(a, b, x, y);
            }
            case 2 -> {
                return new RodJoint(a, a.getX(), a.getY(), b, bx, by);
            }
            case 3 -> {
                return new WeldJoint(a, b, x, y);
            }
            case 4 -> {
                return new SlotJoint(a, b, x, y, dx / apart, dy / apart);
            }
            case 5 -> {
                return slider(new SliderJoint(a, b, x, y, dx / apart, dy / apart));
            }
            case 6 -> {
                return Limit.rope(a, 0, 0, b, b == null ? bx : 0, b == null ? by : 0, apart + u * length);
            }
            case 7 -> {
                extra = Motor.turning(a, b, 3 * w / world.time, 5 * (z + 0.01) * torque);
                return new PinJoint(a, b, a.getX(), a.getY());
            }
            case 8 -> {
                return Limit.angle(a, b, -u - 0.1, z + 0.1);
            }
            case 9 -> {
                return new GearJoint(a, b, 2 * w);
            }
            case 10 -> {
                return b == null ? new PinJoint(a, x, y) : pulley();
            }
            case 11 -> {
                return wheel();
            }
            case 12 -> {
                double radius = z * length + 0.5 * length;
                boolean isRing = u < 0.5;
                return new WireJoint(a, isRing ? Curve.circle(a.getX() + radius, a.getY(), radius) : Curve.line(a.getX(), a.getY(), 1, w));
            }
            case 13 -> {
                double stiffness = 50 * z * world.force() / length;
                spring = new Spring(a, 0, 0, b, b == null ? bx : 0, b == null ? by : 0, apart * u, stiffness, u * world.mass / world.time);
                return null;
            }
            case 14 -> {
                return Motor.turning(a, b, u < 0.5 ? 0 : 2 * w / world.time, 2 * (z + 0.01) * torque);
            }
            default -> {
                RodJoint rod = new RodJoint(a, 0.1 * px * length, 0, b, b == null ? bx : 0, b == null ? by : 0, apart + 0.3 * length);
                return new Limit(rod, -length * (0.3 + u), length * u, world.restitution);
            }
        }
    }

    private Constraint slider(SliderJoint slider) {
        double length = world.length;
        if (u < 0.4) {
            extra = Motor.sliding(slider, 2 * w * length / world.time, 20 * z * world.force() + 0.1 * world.force());
        } else if (u < 0.7) {
            extra = Limit.travel(slider, -z * length, z * length, world.restitution);
        }
        return slider;
    }

    private Constraint pulley() {
        double x = px * world.length;
        double y = 2 * world.length;
        return PulleyJoint.worldPoints(a, a.getX(), a.getY(), a.getX() + x, a.getY() + y, b, bx, by, bx + x, by + y, 0.5 + u);
    }

    private Constraint wheel() {
        Wheel wheel = new Wheel(a, px * world.length * 0.3, py * world.length * 0.3, u);
        double speed = w * world.length / world.time;
        double grip = 5 * world.force() * (u + 0.01);
        if (z < 0.4) {
            extra = u < 0.5 ? Motor.rolling(wheel, speed, grip) : null;
            return wheel;
        }
        extra = Motor.rolling(wheel, speed, 5 * world.force() * (z + 0.01));
        return Motor.gripping(wheel, grip);
    }

    /** Sets something of a constraint. */
    void set(Constraint c, double u, double v, double w) {
        if (c instanceof Motor motor) {
            if (u < 0.6) {
                motor.setSpeed(u < 0.1 ? 0 : motor.getSpeed() * 2 * v);
            } else {
                motor.setLimit(motor.getLimit() * (0.5 + u));
            }
        } else if (c instanceof Limit limit) {
            boolean isHalf = Double.isInfinite(limit.getLower()) || Double.isInfinite(limit.getUpper());
            double middle = isHalf ? 0 : 0.5 * (limit.getLower() + limit.getUpper());
            double way = isHalf ? 0 : 0.5 * (limit.getUpper() - limit.getLower());
            if (way > 0) {
                limit.setBounds(middle - way * (0.8 + 0.3 * u), middle + way * (0.8 + 0.3 * (w + 1) / 2));
            }
        } else if (c instanceof RodJoint rod && u < 0.7) {
            rod.setLength(rod.getLength() * (u < 0.35 ? 1 + 0.01 * v : 1 + 0.2 * v));
        } else if (c instanceof PulleyJoint pulley && u < 0.7) {
            pulley.setLength(pulley.getLength() * (1 + 0.05 * v));
        } else if (c instanceof Wheel wheel && u < 0.8) {
            wheel.setSteering(v);
        }
        if (c instanceof Joint joint && u > 0.5) {
            set(joint, u);
        }
    }

    private void set(Joint joint, double u) {
        if (u < 0.7) {
            joint.setCollideConnected(!joint.isCollideConnected());
        } else if (u < 0.85) {
            joint.setBreakingLoad(world.force() * 100 * u, world.force() * world.length * 100);
        } else {
            joint.setBreakingLoad(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
        }
    }
}
