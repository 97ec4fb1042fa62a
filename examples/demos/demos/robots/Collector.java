// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.robots;

import java.util.ArrayList;
import java.util.List;
import sim.engine.SimState;
import sim.engine.Steppable;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;

/**
 * A robot that fetches cans and carries them home, one after the other, and returns to where it was when there are none
 * left. It holds the can that it was after and no other, and gives way when it gets nowhere.
 */
public final class Collector extends Robot implements Steppable {
    private static final long serialVersionUID = 1L;

    private static final double FRONT = Math.toRadians(22.5);
    private static final double DROP_LINE = 40;
    private static final double STILL = 0.01;

    /** Steps without progress after which it tries something else, and for how long it does. */
    private static final int PATIENCE = 400;
    private static final int STANDSTILL = 30;

    private static final int DETOUR = 60;

    /** What it is about. */
    public enum Task {
        SEARCHING,
        APPROACHING,
        CARRYING,
        RELEASING,
        RETURNING
    }

    private final PhysicsEngine physics;
    private final List<Can> cans;
    private final Body[] effectors = new Body[2];
    private double homeX;
    private double homeY;
    private Task task = Task.SEARCHING;
    private Can can;
    private PinJoint grip;

    /** Progress: the least distance to the goal, and how long ago it was reached. */
    private double closest;

    private int idle;
    private int still;
    private int detour;
    private double detourX;
    private double detourY;

    /** Where it brings the can that it carries. */
    private double lane;

    private boolean hasLane;
    private boolean isParked;

    Collector(PhysicsEngine physics, List<Can> cans) {
        super(10, 300);
        this.physics = physics;
        this.cans = cans;
        setSurfaceFriction(0.2);
    }

    /** Adds the robot where it is, with its effectors. */
    void assemble() {
        homeX = getX();
        homeY = getY();
        physics.add(this);
        for (int k = 0; k < 2; k++) {
            double side = k == 0 ? 6 : -6;
            effectors[k] = physics.add(new Body(new Circle(1)).at(getX() + 12, getY() + side));
            physics.add(new PinJoint(this, effectors[k], getX() + 12, getY() + side));
        }
    }

    public Task getTask() {
        return task;
    }

    public Body[] getEffectors() {
        return effectors.clone();
    }

    /** Whether it has nothing left to do, and does nothing. */
    public boolean isHome() {
        return task == Task.RETURNING && distance(homeX, homeY) <= 30 && speed() < 0.05;
    }

    @Override
    public void step(SimState state) {
        Robots model = (Robots) state;
        if (detour > 0) {
            detour--;
            if (detour > DETOUR) {
                backUp();
            } else {
                goTo(detourX, detourY);
            }
            return;
        }
        switch (task) {
            case SEARCHING -> search(model);
            case APPROACHING -> approach(model);
            case CARRYING -> carry(model);
            case RELEASING -> release();
            default -> returnHome(model);
        }
    }

    private void begin(Task next) {
        task = next;
        closest = Double.POSITIVE_INFINITY;
        idle = 0;
        still = 0;
        hasLane = false;
        isParked = false;
    }

    private void search(Robots model) {
        List<Can> free = new ArrayList<>();
        for (Can one : cans) {
            if (!one.isHome() && one.taker == null) {
                free.add(one);
            }
        }
        if (free.isEmpty()) {
            begin(Task.RETURNING);
            return;
        }
        can = free.get(0);
        for (Can one : free) {
            if (distance(one.getX(), one.getY()) < distance(can.getX(), can.getY())) {
                can = one;
            }
        }
        can.taker = this;
        begin(Task.APPROACHING);
    }

    private void approach(Robots model) {
        if (can.isHome()) {
            letGo();
            begin(Task.SEARCHING);
            return;
        }
        head(model, can.getX(), can.getY());
        if (isStuck(distance(can.getX(), can.getY()))) {
            goAround(model);
            if (model.random.nextBoolean(0.5)) {
                letGo();
                begin(Task.SEARCHING);
            }
        }
    }

    private void letGo() {
        can.taker = null;
        can = null;
    }

    private void carry(Robots model) {
        if (!hasLane) {
            lane = freeLane(model);
            hasLane = true;
        }
        boolean high = getY() <= DROP_LINE;
        if (!high && isStuck(distance(lane, DROP_LINE))) {
            if (can.getY() <= Can.HOME - 5) {
                high = true;
            } else {
                lane = inside(getX() + (model.random.nextDouble() - 0.5) * 120);
                goAround(model);
                return;
            }
        }
        if (high) {
            stop();
            if (speed() <= STILL && Math.abs(getAngularVelocity()) <= STILL) {
                if (can.getY() <= Can.HOME) {
                    drop();
                } else {
                    face(-Math.PI / 2);
                }
            }
            return;
        }
        head(model, lane, DROP_LINE - 8);
    }

    /** A place at the top, near where the robot is, at which there is no can yet and no other robot goes to. */
    private double freeLane(Robots model) {
        for (int k = 0; k < 40; k++) {
            double x = getX() + (k % 2 == 0 ? k / 2 : -k / 2 - 1) * 8.0;
            boolean free = x == inside(x);
            for (Can one : cans) {
                free &= one == can || one.getY() > Can.HOME || Math.abs(one.getX() - x) > 6;
            }
            for (Collector other : model.robots) {
                free &= other == this || other.task != Task.CARRYING || Math.abs(other.lane - x) > 26;
            }
            if (free) {
                return x;
            }
        }
        return inside(getX());
    }

    private void drop() {
        physics.remove(grip);
        grip = null;
        collide(true);
        can.isHeld = false;
        setLoaded(false);
        begin(Task.RELEASING);
    }

    private void release() {
        if (distance(can.getX(), can.getY()) <= 30 && idle++ < 400) {
            backUp();
        } else {
            letGo();
            begin(Task.SEARCHING);
        }
    }

    private void returnHome(Robots model) {
        for (Can one : cans) {
            if (!one.isHome() && one.taker == null) {
                begin(Task.SEARCHING);
                return;
            }
        }
        double way = distance(homeX, homeY);
        if (way <= 6 || isParked && way <= 28) {
            isParked = true;
            face(0);
            return;
        }
        head(model, homeX, homeY);
        if (isStuck(way)) {
            if (way <= 28) {
                isParked = true; // as near as it gets
            } else {
                goAround(model);
            }
        }
    }

    /** Goes to a place, around cans that lie in its way, and keeps to the right of robots that come its way. */
    private void head(Robots model, double x, double y) {
        double way = distance(x, y);
        for (Collector other : model.robots) {
            if (other != this && isInTheWay(other, 45, 0.7, way)) {
                double bearing = bearing(other.getX(), other.getY());
                aside(other.speed() > 0.05 || bearing < 0 ? bearing + 0.9 : bearing - 0.9);
                return;
            }
        }
        for (Can one : cans) {
            if (one != can && isInTheWay(one, 26, 0.6, way - 4)) {
                double bearing = bearing(one.getX(), one.getY());
                aside(bearing > 0 ? bearing - 0.9 : bearing + 0.9);
                return;
            }
        }
        goTo(x, y);
    }

    private boolean isInTheWay(Body body, double near, double angle, double way) {
        double distance = distance(body.getX(), body.getY());
        return distance < near && distance < way && Math.abs(bearing(body.getX(), body.getY())) < angle;
    }

    private void aside(double bearing) {
        double angle = getAngle() + bearing;
        goTo(inside(getX() + 40 * StrictMath.cos(angle)), inside(getY() + 40 * StrictMath.sin(angle)));
    }

    private static double inside(double coordinate) {
        return Math.max(16, Math.min(Robots.WORLD - 16, coordinate));
    }

    /** Whether it stands still, or has come no nearer for long; turning takes its time. */
    private boolean isStuck(double distance) {
        still = speed() < 0.03 && Math.abs(getAngularVelocity()) < 0.002 ? still + 1 : 0;
        if (distance < closest - 0.5) {
            closest = distance;
            idle = 0;
        } else {
            idle++;
        }
        return idle > PATIENCE || still > STANDSTILL;
    }

    /** Backs up a little, and then goes somewhere else for a while. */
    private void goAround(Robots model) {
        closest = Double.POSITIVE_INFINITY;
        idle = 0;
        still = 0;
        detour = DETOUR + 30 + model.random.nextInt(30);
        double angle = model.random.nextDouble() * 2 * Math.PI;
        detourX = inside(getX() + 50 * StrictMath.cos(angle));
        detourY = inside(getY() + 50 * StrictMath.sin(angle));
    }

    /** Lets the can in its grip collide with it, or not. */
    private void collide(boolean yes) {
        physics.setCollisions(can, this, yes);
        for (Body effector : effectors) {
            physics.setCollisions(can, effector, yes);
        }
    }

    /** Whether a body touches it at its front and is the can that it is after. */
    boolean wants(Body body) {
        return body == can && task == Task.APPROACHING && Math.abs(bearing(body.getX(), body.getY())) <= FRONT;
    }

    private void pickUp() {
        can.isHeld = true;
        grip = physics.add(new PinJoint(can, this, can.getX(), can.getY()));
        collide(false);
        detour = 0;
        setLoaded(true);
        begin(Task.CARRYING);
    }

    /** Picks cans up at the instant at which they touch. */
    static final class Grip implements CollisionListener {
        private static final long serialVersionUID = 1L;

        @Override
        public Decision colliding(Contact contact) {
            return taker(contact) == null ? Decision.BOUNCE : Decision.STICK;
        }

        @Override
        public void collided(Contact contact) {
            Collector taker = taker(contact);
            if (taker != null) {
                taker.pickUp();
            }
        }

        private static Collector taker(Contact contact) {
            if (contact.a() instanceof Collector robot && robot.wants(contact.b())) {
                return robot;
            }
            return contact.b() instanceof Collector robot && robot.wants(contact.a()) ? robot : null;
        }
    }
}
