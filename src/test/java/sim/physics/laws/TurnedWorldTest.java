// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/**
 * Worlds that are turned by any angle about the origin, with all that is in them: they go on as before, but for rounding. And on tiles laid edge to edge
 * as on one floor.
 */
class TurnedWorldTest {
    private static final double G = 10;

    /** A force of an author's on one body, or on all in proportion to their masses. */
    private record Push(Body only, double fx, double fy) implements ForceGenerator {
        @Override
        public void addForce(Body body, double time, Forces forces) {
            double part = only == null ? body.getMass() : 1;
            forces.add(body, part * fx, part * fy);
        }

        @Override
        public boolean actsOn(Body body) {
            return only == null || body == only;
        }
    }

    /** A world that is turned, with bodies given as in one that is not. */
    private static final class World {
        final PhysicsEngine engine = new PhysicsEngine();
        final List<Body> bodies = new ArrayList<>();
        final double angle;
        final double cos;
        final double sin;
        final double friction;

        double restitution;

        World(double angle, double friction, boolean isAuthors) {
            this.angle = angle;
            this.friction = friction;
            cos = StrictMath.cos(angle);
            sin = StrictMath.sin(angle);
            engine.setTimeStep(1.0 / 60);
            engine.add(isAuthors ? new Push(null, G * sin, -G * cos) : new Gravity(G * sin, -G * cos));
        }

        double x(double x, double y) {
            return cos * x - sin * y;
        }

        double y(double x, double y) {
            return sin * x + cos * y;
        }

        void floor(boolean isTiled) {
            for (int k = -3; isTiled && k < 12; k++) {
                take(Body.fixed(new Rectangle(1, 1)), k + 0.5, -0.5);
            }
            if (!isTiled) {
                take(Body.fixed(new Rectangle(15, 1)), 4.5, -0.5);
            }
        }

        Body put(Shape shape, double x, double y, double speed, double spin) {
            Body body = new Body(shape);
            bodies.add(body);
            take(body, x, y);
            body.setVelocity(x(speed, 0), y(speed, 0));
            body.setAngularVelocity(spin);
            return body;
        }

        private void take(Body body, double x, double y) {
            engine.add(body.at(x(x, y), y(x, y), angle));
            body.setFriction(friction);
            body.setRestitution(restitution);
        }

        void pin(Body a, Body b, double x, double y) {
            engine.add(new PinJoint(a, b, x(x, y), y(x, y)));
        }
    }

    private static World plank(World w) {
        Body first = w.put(new Rectangle(1, 0.4), 0.3, 0.2, 3, 0);
        w.pin(first, w.put(new Rectangle(1, 0.4), 1.3, 0.2, 3, 0), 0.8, 0.2);
        return w;
    }

    private static World box(World w, double push) {
        Body box = w.put(new Rectangle(1, 0.4), 0.3, 0.2, 2, 0);
        if (push > 0) {
            w.engine.add(new Push(box, w.x(push, 0), w.y(push, 0)));
        }
        return w;
    }

    private static World table(World w) {
        Body top = w.put(new Rectangle(2, 0.2), 0.3, 1.4, 2, 0);
        for (int side = -1; side <= 1; side += 2) {
            double x = 0.3 + 0.8 * side;
            w.engine.add(new WeldJoint(top, w.put(new Rectangle(0.2, 0.8), x, 0.9, 2, 0), w.x(x, 1.3), w.y(x, 1.3)));
        }
        return w;
    }

    private static World car(World w, boolean hasMotors) {
        double speed = hasMotors ? 0 : 3;
        Body chassis = w.put(new Rectangle(2, 0.4), 0.3, 0.9, speed, 0);
        for (int side = -1; side <= 1; side += 2) {
            double x = 0.3 + 0.7 * side;
            Body wheel = w.put(new Circle(0.3), x, 0.3, speed, -speed / 0.3);
            w.pin(chassis, wheel, x, 0.3);
            if (hasMotors) {
                w.engine.add(Motor.turning(chassis, wheel, 10, 3));
            }
        }
        return w;
    }

    private static World chain(World w) {
        Body last = w.put(new Rectangle(0.8, 0.2), 0.3, 0.6, 2, 0);
        for (int k = 1; k < 6; k++) {
            Body next = w.put(new Rectangle(0.8, 0.2), 0.3 + 0.8 * k, 0.6, 2, 0);
            w.pin(last, next, 0.8 * k - 0.1, 0.6);
            last = next;
        }
        return w;
    }

    private static World rod(World w) {
        Body first = w.put(new Rectangle(1, 0.4), 0.3, 0.2, 3, 0);
        Body second = w.put(new Rectangle(1, 0.4), 2.3, 0.2, 3, 0);
        w.engine.add(new RodJoint(first, w.x(0.3, 0.2), w.y(0.3, 0.2), second, w.x(2.3, 0.2), w.y(2.3, 0.2)));
        return w;
    }

    private static World row(World w) {
        for (int k = 0; k < 4; k++) {
            w.put(new Rectangle(1, 1), k, 0.5, 0, 0);
        }
        w.engine.add(new Push(w.bodies.get(0), w.x(20, 0), w.y(20, 0)));
        return w;
    }

    private static List<Body> run(World world) {
        for (int k = 0; k < 120; k++) {
            world.engine.step();
        }
        return world.bodies;
    }

    private static World make(String name, double angle, boolean isTiled) {
        boolean isAuthors = name.startsWith("author's ");
        double friction = name.endsWith("car") ? 0.8 : name.endsWith("row") ? 0.3 : name.contains("smooth") ? 0 : 0.2;
        World world = new World(angle, friction, isAuthors);
        world.floor(isTiled);
        return switch (name.replace("author's ", "").replace("smooth ", "")) {
            case "plank" -> plank(world);
            case "box" -> box(world, 0);
            case "pushed box" -> box(world, 1.2);
            case "table" -> table(world);
            case "car" -> car(world, false);
            case "motor car" -> car(world, true);
            case "chain" -> chain(world);
            case "rod" -> rod(world);
            default -> row(world);
        };
    }

    /** Seams under them were points that bear a part or none by rounding: 10⁻⁶ to 10⁻³ off, a row up to 0.1, some stopped. */
    @ParameterizedTest
    @CsvSource({
        "plank, 1e-8", "author's plank, 1e-8", "smooth plank, 1e-7", "author's smooth plank, 1e-7", "author's smooth box, 1e-9",
        "author's box, 1e-8", "pushed box, 1e-6", "table, 1e-10", "chain, 1e-8", "rod, 1e-8", "car, 1e-8", "author's motor car, 1e-7", "row, 3e-6",
        "author's row, 3e-6"
    })
    void onTilesAsOnOneFloorAtAnyAngle(String name, double bound) {
        List<Body> on = run(make(name, 0, false));
        for (int k = 0; k < 12; k++) {
            World world = make(name, k == 0 ? 0 : 0.05 + 0.5 * k, true);
            List<Body> turned = run(world);
            for (int n = 0; n < on.size(); n++) {
                Body body = turned.get(n);
                assertThat(world.cos * body.getX() + world.sin * body.getY()).as("x %d, %d", k, n).isCloseTo(on.get(n).getX(), within(bound));
                assertThat(world.cos * body.getY() - world.sin * body.getX()).as("y %d, %d", k, n).isCloseTo(on.get(n).getY(), within(bound));
                assertThat(body.getAngle() - world.angle).as("angle %d, %d", k, n).isCloseTo(on.get(n).getAngle(), within(bound));
            }
        }
    }

    private static World pyramid(int rows, double width, double height, double friction, double restitution, double angle) {
        World world = new World(angle, friction, false);
        world.restitution = restitution;
        world.floor(false);
        for (int row = 0; row < rows; row++) {
            for (int k = 0; k < rows - row; k++) {
                world.put(new Rectangle(width, height), 0.3 + (k + 0.5 * row) * width, (row + 0.5) * height, 0, 0);
            }
        }
        return world;
    }

    private static double energy(World world) {
        double sum = world.engine.kineticEnergy();
        for (Body body : world.bodies) {
            sum += G * body.getMass() * (world.cos * body.getY() - world.sin * body.getX());
        }
        return sum;
    }

    /** Bodies that bounce and are put on one another meet by rounding only. They hopped, by bounces of rounding that were too short: up to 5 · 10⁻³ J. */
    @ParameterizedTest
    @CsvSource({"2, 0.7, 0.4, 0.6, 0.5", "4, 0.7, 0.4, 0.3, 0.5", "6, 1, 1, 0, 0.5", "4, 1, 1, 0.6, 0.9"})
    void whatBouncesAndIsPutOnOneAnotherStands(int rows, double width, double height, double friction, double restitution) {
        for (int k = 0; k < 6; k++) {
            World world = pyramid(rows, width, height, friction, restitution, k == 0 ? 0 : 0.05 + k);
            double before = energy(world);
            for (int step = 0; step < 60; step++) {
                world.engine.step();
                assertThat(energy(world) - before).as("turn " + k + ", step " + step).isLessThan(1e-6);
            }
            for (int n = 0; n < world.bodies.size(); n++) {
                Body body = world.bodies.get(n);
                Body put = pyramid(rows, width, height, friction, restitution, world.angle).bodies.get(n);
                assertThat(Math.hypot(body.getX() - put.getX(), body.getY() - put.getY())).as("turn %d, %d", k, n).isLessThan(1e-6);
            }
        }
    }
}
