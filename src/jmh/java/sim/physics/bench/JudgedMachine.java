// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.ArrayList;
import java.util.List;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** A machine whose places are looked at after each step, by one measure for all engines. */
final class JudgedMachine implements MachineWorld {
    /** Deepest overlap of two bodies, m; widest joint, m; farthest beyond a stop, rad. */
    double depth;

    double gap;
    double over;

    private final MachineWorld world;

    /** The same bodies without joints, put where the engine has them. */
    private final PhysicsEngine places = new PhysicsEngine();

    private final List<Body> bodies = new ArrayList<>();
    private final List<Hinge> hinges = new ArrayList<>();
    private final List<Stop> stops = new ArrayList<>();

    JudgedMachine(MachineWorld world) {
        this.world = world;
    }

    /** Points of two bodies, in their own frames, that are one; a rail lets them part along the first body's y. */
    private record Hinge(int on, int body, double ax, double ay, double bx, double by, boolean rail) {}

    private record Stop(int on, int body, double lower, double upper) {}

    private int add(Shape shape, double x, double y, boolean fixed) {
        bodies.add(places.add((fixed ? Body.fixed(shape) : new Body(shape)).at(x, y)));
        return bodies.size() - 1;
    }

    private void join(int on, int body, double x, double y, boolean rail) {
        places.setCollisions(bodies.get(on), bodies.get(body), false);
        hinges.add(new Hinge(on, body, x - x(on), y - y(on), x - x(body), y - y(body), rail));
    }

    @Override
    public int box(double width, double height, double x, double y, double friction, boolean fixed) {
        world.box(width, height, x, y, friction, fixed);
        return add(new Rectangle(width, height), x, y, fixed);
    }

    @Override
    public int disc(double radius, double x, double y, double friction) {
        world.disc(radius, x, y, friction);
        return add(new Circle(radius), x, y, false);
    }

    @Override
    public int boxes(double[][] boxes, double x, double y, double friction) {
        world.boxes(boxes, x, y, friction);
        return add(OwnMachine.compound(boxes), x, y, false);
    }

    @Override
    public void remove(int body) {
        world.remove(body);
        places.remove(bodies.get(body));
        bodies.set(body, null);
    }

    @Override
    public void pin(int on, int body, double x, double y) {
        join(on, body, x, y, false);
        world.pin(on, body, x, y);
    }

    @Override
    public void suspend(int on, int wheel, double x, double y, double hub, double stiffness, double damping) {
        join(on, wheel, x, y, true);
        world.suspend(on, wheel, x, y, hub, stiffness, damping);
    }

    @Override
    public void motor(int hinge, double speed, double torque) {
        world.motor(hinge, speed, torque);
    }

    @Override
    public void drive(int hinge, double speed) {
        world.drive(hinge, speed);
    }

    @Override
    public void stops(int hinge, double lower, double upper) {
        int on = hinges.stream().filter(h -> h.body == hinge).findFirst().orElseThrow().on;
        stops.add(new Stop(on, hinge, lower, upper));
        world.stops(hinge, lower, upper);
    }

    @Override
    public void launch(double vx, double vy) {
        world.launch(vx, vy);
    }

    @Override
    public void step() {
        world.step();
        for (int k = 0; k < bodies.size(); k++) {
            Body body = bodies.get(k);
            if (body != null && !body.isFixed()) {
                body.setPosition(x(k), y(k));
                body.setAngle(angle(k));
            }
        }
        for (Overlap overlap : places.overlaps()) {
            depth = Math.max(depth, overlap.depth());
        }
        for (Hinge hinge : hinges) {
            gap = Math.max(gap, gap(hinge));
        }
        for (Stop stop : stops) {
            double angle = Math.IEEEremainder(angle(stop.body) - angle(stop.on), 2 * Math.PI);
            over = Math.max(over, Math.max(angle - stop.upper, stop.lower - angle));
        }
    }

    private double gap(Hinge h) {
        double c = StrictMath.cos(angle(h.on));
        double s = StrictMath.sin(angle(h.on));
        double cb = StrictMath.cos(angle(h.body));
        double sb = StrictMath.sin(angle(h.body));
        double dx = x(h.body) + cb * h.bx - sb * h.by - x(h.on) - c * h.ax + s * h.ay;
        double dy = y(h.body) + sb * h.bx + cb * h.by - y(h.on) - s * h.ax - c * h.ay;
        return h.rail ? Math.abs(c * dx + s * dy) : Math.hypot(dx, dy);
    }

    @Override
    public double x(int body) {
        return world.x(body);
    }

    @Override
    public double y(int body) {
        return world.y(body);
    }

    @Override
    public double angle(int body) {
        return world.angle(body);
    }

    @Override
    public double vx(int body) {
        return world.vx(body);
    }
}
