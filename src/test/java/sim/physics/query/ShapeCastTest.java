// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.narrow.Distance;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Shapes that move straight on, against bisection on distances, against one another, and against rays. */
class ShapeCastTest {
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private final SplittableRandom random = new SplittableRandom(23);
    private final Distance distance = new Distance();

    private Shape convex() {
        return switch (random.nextInt(4)) {
            case 0 -> new Circle(random.nextDouble(0.3, 1.5));
            case 1 -> new Rectangle(random.nextDouble(0.3, 3), random.nextDouble(0.3, 2));
            case 2 -> new Rectangle(random.nextDouble(3, 8), random.nextDouble(0.01, 0.2));
            default -> Polygon.regular(3 + random.nextInt(6), random.nextDouble(0.4, 1.5));
        };
    }

    private Shape compound() {
        return random.nextBoolean()
                ? new Compound(Compound.box(0, 0, 3, 0.5), Compound.box(-1.25, 0.75, 0.5, 1), Compound.box(1.25, 0.75, 0.5, 1))
                : new Compound(Compound.disc(0, 0, 0.6), Compound.box(0.9, 0.35, 0.8, 0.15), Compound.box(0.9, -0.35, 0.8, 0.15));
    }

    private Body scattered(Shape shape, double half) {
        double angle = random.nextInt(5) == 0 ? 0.5 * Math.PI * random.nextInt(4) : random.nextDouble(-4, 4);
        return new Body(shape).at(random.nextDouble(-half, half), random.nextDouble(-half, half), angle);
    }

    /** What a shape that a body has meets when that moves, if there is but one other body. */
    private static Hit cast(Body moves, Body other, double dx, double dy, double range) {
        PhysicsEngine engine = new PhysicsEngine();
        boolean isFree = !engine.contains(other);
        Body stands = isFree ? engine.add(new Body(other.getShape()).at(other.getX(), other.getY(), other.getAngle())) : other;
        return engine.queries().shapeCast(moves.getShape(), moves.getX(), moves.getY(), moves.getAngle(), dx, dy, range, b -> b == stands);
    }

    private double gap(Body moves, Body other, double dx, double dy, double t) {
        return distance.between(new Body(moves.getShape()).at(moves.getX() + t * dx, moves.getY() + t * dy, moves.getAngle()), other);
    }

    /**
     * The gap of two convex bodies, negative where they overlap, is a convex function of the way: it is least at one place, and the
     * first zero lies before that.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1e-6, 1e9})
    void convexBodiesMeetWhereBisectionSays(double unit) {
        int hits = 0;
        for (int k = 0; k < 6000; k++) {
            Body moves = scaled(scattered(convex(), 6), unit);
            Body other = scaled(scattered(convex(), 6), unit);
            double angle = StrictMath.atan2(other.getY() - moves.getY(), other.getX() - moves.getX()) + random.nextDouble(-0.6, 0.6);
            double dx = k % 7 == 0 ? 1 : StrictMath.cos(angle);
            double dy = k % 7 == 0 ? 0 : StrictMath.sin(angle);
            double range = 20 * unit;
            double low = 0;
            double high = range;
            for (int m = 0; m < 120; m++) {
                double one = low + (high - low) / 3;
                double two = high - (high - low) / 3;
                if (gap(moves, other, dx, dy, one) < gap(moves, other, dx, dy, two)) {
                    high = two;
                } else {
                    low = one;
                }
            }
            double deepest = gap(moves, other, dx, dy, low);
            Hit hit = cast(moves, other, dx, dy, range);
            if (Math.abs(deepest) < 1e-6 * unit) {
                continue; // it grazes
            }
            assertThat(hit != null).isEqualTo(deepest < 0);
            if (hit == null) {
                continue;
            }
            hits++;
            double start = gap(moves, other, dx, dy, 0);
            if (start < 0) {
                assertThat(hit.distance()).isZero();
                assertThat(hit.nx()).isCloseTo(-dx, within(1e-15));
                assertThat(hit.ny()).isCloseTo(-dy, within(1e-15));
                assertThat(hit.x()).isEqualTo(moves.getX());
                assertThat(hit.y()).isEqualTo(moves.getY());
                continue;
            }
            high = low;
            low = 0;
            for (int m = 0; m < 80; m++) {
                double middle = 0.5 * (low + high);
                if (gap(moves, other, dx, dy, middle) > 0) {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            double sine = -(hit.nx() * dx + hit.ny() * dy); // a gap that is off by rounding is met earlier or later by more
            assertThat(sine).isPositive();
            assertThat((hit.distance() - high) * sine).isCloseTo(0, within(1e-13 * unit));
            assertThat(hit.nx() * hit.nx() + hit.ny() * hit.ny()).isCloseTo(1, within(1e-13));
            assertThat(gap(moves, other, dx, dy, hit.distance())).isCloseTo(0, within(1e-13 * unit));
            Body point = new Body(new Circle(1e-3 * unit)).at(hit.x(), hit.y());
            assertThat(distance.between(point, other)).isCloseTo(-1e-3 * unit, within(1e-13 * unit));
            double way = hit.distance();
            point.at(hit.x() - way * dx, hit.y() - way * dy);
            assertThat(distance.between(point, moves)).isCloseTo(-1e-3 * unit, within(1e-13 * unit));
            double off = 1e-3 * unit; // the normal leads out of the body: a point beyond the surface is as far from it
            point.at(hit.x() + off * hit.nx(), hit.y() + off * hit.ny());
            assertThat(distance.between(point, other)).isCloseTo(0, within(1e-13 * unit));
        }
        assertThat(hits).isGreaterThan(3000);
    }

    private static Body scaled(Body body, double unit) {
        Shape shape = body.getShape();
        double[] xy = shape.copyVertices();
        for (int k = 0; k < xy.length; k++) {
            xy[k] *= unit;
        }
        Shape large = shape.vertexCount() == 1 ? new Circle(shape.radius() * unit) : new Polygon(xy);
        return new Body(large).at(body.getX() * unit, body.getY() * unit, body.getAngle());
    }

    /** Whether one moves on or the other comes to it is the same. */
    @Test
    void castsAreMirrorImages() {
        int hits = 0;
        for (int k = 0; k < 8000; k++) {
            Body a = scattered(k % 3 == 0 ? compound() : convex(), 5);
            Body b = scattered(k % 4 == 0 ? compound() : convex(), 5);
            double angle = random.nextDouble(-4, 4);
            double dx = StrictMath.cos(angle);
            double dy = StrictMath.sin(angle);
            double range = k % 2 == 0 ? INFINITE : random.nextDouble(8);
            Hit there = cast(a, b, dx, dy, range);
            Hit back = cast(b, a, -dx, -dy, range);
            assertThat(back == null).isEqualTo(there == null);
            if (there == null) {
                continue;
            }
            hits++;
            double sine = Math.abs(there.nx() * dx + there.ny() * dy);
            assertThat((back.distance() - there.distance()) * sine).isCloseTo(0, within(1e-13));
            if (there.distance() > 0 && sine > 1e-6) {
                assertThat(StrictMath.hypot(back.nx() + there.nx(), back.ny() + there.ny())).isLessThan(1e-8);
                double x = there.x() - there.distance() * dx;
                double y = there.y() - there.distance() * dy;
                assertThat(StrictMath.hypot(back.x() - x, back.y() - y)).isLessThan(1e-8);
            }
        }
        assertThat(hits).isGreaterThan(1500);
    }

    /** Each part as a body of its own. */
    @Test
    void compoundsMeetWhatTheirPartsMeet() {
        int hits = 0;
        for (int k = 0; k < 1500; k++) {
            Body cup = scattered(compound(), 4);
            PhysicsEngine parts = new PhysicsEngine();
            for (int m = 0; m < cup.getShape().partCount(); m++) {
                Shape part = cup.getShape().part(m);
                Shape own = part.vertexCount() == 1 ? new Circle(part.radius()) : new Polygon(part.copyVertices());
                double px = part.vertexCount() == 1 ? part.vertexX(0) : own.massProperties().centroidX();
                double py = part.vertexCount() == 1 ? part.vertexY(0) : own.massProperties().centroidY();
                parts.add(new Body(own).at(cup.worldX(px, py), cup.worldY(px, py), cup.getAngle()));
            }
            Body moves = scattered(k % 2 == 0 ? convex() : compound(), 6);
            double angle = random.nextDouble(-4, 4);
            double dx = StrictMath.cos(angle);
            double dy = StrictMath.sin(angle);
            Hit whole = cast(moves, cup, dx, dy, INFINITE);
            Hit one = parts.queries().shapeCast(moves.getShape(), moves.getX(), moves.getY(), moves.getAngle(), dx, dy, INFINITE, null);
            assertThat(whole == null).isEqualTo(one == null);
            if (whole != null) {
                hits++;
                double sine = Math.max(1e-6, Math.abs(one.nx() * dx + one.ny() * dy));
                assertThat(whole.distance()).isCloseTo(one.distance(), within(1e-13 / sine));
            }
        }
        assertThat(hits).isGreaterThan(300);
    }

    /** A shape that is next to a point is next to a ray. */
    @Test
    void whatIsSmallMovesLikeARay() {
        PhysicsEngine engine = new PhysicsEngine();
        for (int k = 0; k < 60; k++) {
            engine.add(scattered(k % 3 == 0 ? compound() : convex(), 20));
        }
        Queries ask = engine.queries();
        double tiny = 1e-13;
        int hits = 0;
        for (int k = 0; k < 3000; k++) {
            double x = random.nextDouble(-25, 25);
            double y = random.nextDouble(-25, 25);
            double angle = random.nextDouble(-4, 4);
            double dx = StrictMath.cos(angle);
            double dy = StrictMath.sin(angle);
            Hit ray = ask.rayCast(x, y, dx, dy, 30, null);
            Shape shape = k % 2 == 0 ? new Circle(tiny) : new Rectangle(tiny, tiny);
            Hit hit = ask.shapeCast(shape, x, y, angle, dx, dy, 30, null);
            double sine = ray == null ? 0 : Math.abs(ray.nx() * dx + ray.ny() * dy);
            if (ray != null && sine > 1e-3) {
                hits++;
                assertThat(hit.body()).isEqualTo(ray.body());
                assertThat(hit.distance()).isCloseTo(ray.distance(), within(1e-12 / sine));
                assertThat(StrictMath.hypot(hit.x() - ray.x(), hit.y() - ray.y())).isLessThan(1e-12 / sine);
            } else {
                assertThat(hit == null).isEqualTo(ray == null);
            }
        }
        assertThat(hits).isGreaterThan(1000);
    }

    @Test
    void knownPlaces() {
        PhysicsEngine engine = new PhysicsEngine();
        Body box = engine.add(new Body(new Rectangle(2, 2)).at(10, 0));
        Body disc = engine.add(new Body(new Circle(1)).at(20, 0));
        Queries ask = engine.queries();
        assertThat(ask.shapeCast(new Rectangle(2, 1), 0, 0, 0, 3, 0, INFINITE, null)).isEqualTo(new Hit(box, 9, 0, -1, 0, 8));
        assertThat(ask.shapeCast(new Rectangle(2, 1), 0, 1, 0, 1, 0, 8, null)).isEqualTo(new Hit(box, 9, 0.75, -1, 0, 8)); // along an edge
        assertThat(ask.shapeCast(new Rectangle(2, 1), 0, 1, 0, 1, 0, 7.99, null)).isNull();
        assertThat(ask.shapeCast(new Circle(1), 0, 0.5, 0, 1, 0, INFINITE, null)).isEqualTo(new Hit(box, 9, 0.5, -1, 0, 8));
        Hit corner = ask.shapeCast(new Circle(1), 0, 1.6, 0, 1, 0, INFINITE, null); // 3, 4, 5
        assertThat(corner.distance()).isCloseTo(8.2, within(1e-15 * 10));
        assertThat(new double[] {corner.x(), corner.y(), corner.nx(), corner.ny()}).containsExactly(new double[] {9, 1, -0.8, 0.6}, within(1e-14));
        assertThat(ask.shapeCast(new Circle(4), 20, 11, 0, 0, -2, INFINITE, null)).isEqualTo(new Hit(disc, 20, 1, 0, 1, 6));
        assertThat(ask.shapeCast(new Rectangle(2, 2), 20, 11, 0, 0, -2, INFINITE, null)).isEqualTo(new Hit(disc, 20, 1, 0, 1, 9));
        assertThat(ask.shapeCastAll(new Rectangle(1, 1), 0, 0, 0, 1, 0, INFINITE, null))
                .extracting(Hit::body).containsExactly(box, disc);
        assertThat(ask.shapeCastAll(new Rectangle(1, 1), 0, 0, 0, 1, 0, 18, null)).extracting(Hit::distance).containsExactly(8.5);
        assertThat(ask.shapeCast(box, 1, 0, INFINITE, null)).isEqualTo(new Hit(disc, 19, 0, -1, 0, 8));
        assertThat(ask.shapeCast(box, 1, 0, INFINITE, b -> b != disc)).isNull();
        assertThat(ask.shapeCast(new Body(new Circle(1)).at(10, 9), 0, -1, 7.5, null)).isEqualTo(new Hit(box, 10, 1, 0, 1, 7));
    }

    @Test
    void whatOverlapsAtTheStartIsAtDistanceZero() {
        PhysicsEngine engine = new PhysicsEngine();
        Body box = engine.add(new Body(new Rectangle(2, 2)));
        Queries ask = engine.queries();
        for (Shape shape : List.of(new Circle(0.1), new Circle(9), new Rectangle(0.1, 0.1), new Rectangle(9, 9), compound())) {
            for (double range : new double[] {0, 1, INFINITE}) {
                assertThat(ask.shapeCast(shape, 0.5, -0.25, 1, 0, -4, range, null)).isEqualTo(new Hit(box, 0.5, -0.25, 0, 1, 0));
            }
        }
    }

    /** What lies on a floor of tiles slides along it, and away from it; it is stopped by what stands on it, and by the floor itself. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, 1, 2.5})
    void whatTouchesIsMetOnlyByMovingIntoIt(double turn) {
        double cos = StrictMath.cos(turn);
        double sin = StrictMath.sin(turn);
        for (Shape shape : List.of(new Rectangle(1, 1), new Circle(0.5))) {
            PhysicsEngine engine = new PhysicsEngine();
            for (int k = 0; k < 40; k++) {
                engine.add(Body.fixed(new Rectangle(1, 1)).at(7 + k * cos, -3 + k * sin, turn));
            }
            Body wall = engine.add(Body.fixed(new Rectangle(1, 1)).at(7 + 30 * cos - sin, -3 + 30 * sin + cos, turn));
            double x = 7 + 3.3 * cos - sin;
            double y = -3 + 3.3 * sin + cos;
            Queries ask = engine.queries();
            Hit stop = ask.shapeCast(shape, x, y, turn, cos, sin, INFINITE, null);
            assertThat(stop.body()).isEqualTo(wall);
            assertThat(stop.distance()).isCloseTo(25.7, within(1e-13));
            assertThat(ask.shapeCast(shape, x, y, turn, cos, sin, 25, null)).isNull();
            assertThat(ask.shapeCast(shape, x, y, turn, -cos, -sin, INFINITE, null)).isNull();
            assertThat(ask.shapeCast(shape, x, y, turn, -sin, cos, INFINITE, null)).isNull();
            Hit floor = ask.shapeCast(shape, x, y, turn, sin + 0.5 * cos, -cos + 0.5 * sin, 0.1, null);
            assertThat(floor.distance()).isCloseTo(0, within(1e-14));
            assertThat(floor.nx()).isCloseTo(-sin, within(1e-14));
            assertThat(floor.ny()).isCloseTo(cos, within(1e-14));
            assertThat(ask.shapeCast(shape, x, y, turn, -cos + 1e-3 * sin, -sin - 1e-3 * cos, 0.1, null).distance()).isCloseTo(0, within(1e-12));
        }
    }

    /** From where it has met a convex body a convex one moves off freely to any side but into the surface. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e5})
    void whatHasMetABodyIsFreeButForMovingIntoIt(double off) {
        int freed = 0;
        int stopped = 0;
        for (int k = 0; k < 4000; k++) {
            Body moves = scattered(convex(), 6);
            Body other = scattered(convex(), 6);
            moves.setPosition(moves.getX() + off, moves.getY() - off);
            other.setPosition(other.getX() + off, other.getY() - off);
            double angle = StrictMath.atan2(other.getY() - moves.getY(), other.getX() - moves.getX()) + random.nextDouble(-0.6, 0.6);
            double dx = StrictMath.cos(angle);
            double dy = StrictMath.sin(angle);
            Hit hit = cast(moves, other, dx, dy, INFINITE);
            if (hit == null || hit.distance() == 0 || hit.nx() * dx + hit.ny() * dy > -1e-2) {
                continue;
            }
            moves.setPosition(moves.getX() + hit.distance() * dx, moves.getY() + hit.distance() * dy);
            double to = random.nextDouble(-4, 4);
            double along = hit.nx() * StrictMath.cos(to) + hit.ny() * StrictMath.sin(to);
            Hit then = cast(moves, other, StrictMath.cos(to), StrictMath.sin(to), INFINITE);
            if (along > 1e-6) {
                assertThat(then).isNull();
                freed++;
            } else if (along < -1e-2) {
                assertThat(then.distance()).isLessThan(1e-11 + 1e-13 * off);
                assertThat(StrictMath.hypot(then.nx() - hit.nx(), then.ny() - hit.ny())).isLessThan(1e-6 + 1e-7 * off);
                stopped++;
            }
            assertThat(cast(moves, other, -hit.ny(), hit.nx(), INFINITE)).isNull();
            assertThat(cast(moves, other, hit.ny(), -hit.nx(), INFINITE)).isNull();
        }
        assertThat(freed).isGreaterThan(500);
        assertThat(stopped).isGreaterThan(500);
    }

    /** Wherever the engine lets bodies come to rest, they lie on one another by rounding. */
    @Test
    void whatHasComeToRestMaySlide() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.02);
        engine.add(new Gravity(0, -9.8));
        Body floor = engine.add(Body.fixed(new Rectangle(100, 1)).at(0, -0.5));
        List<Body> rest = new ArrayList<>();
        for (int k = 0; k < 8; k++) {
            Body body = engine.add(new Body(k % 2 == 0 ? new Rectangle(1, 1) : new Circle(0.5)).at(6 * k - 20, 1 + 0.1 * k, 0.05 * k));
            body.setRestitution(0.2);
            body.setFriction(0.5);
            rest.add(body);
        }
        for (int k = 0; k < 200; k++) {
            engine.step();
        }
        for (Body body : rest) {
            assertThat(engine.contacts(body)).isNotEmpty();
            Hit hit = engine.queries().shapeCast(body, 1, 0, 3, null);
            assertThat(hit).as(body.toString()).isNull();
            assertThat(engine.queries().shapeCast(body, 1, -0.01, 3, null).body()).isEqualTo(floor);
        }
    }

    @Test
    void directionsOfAnyLength() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(new Body(new Circle(1)).at(3, 4));
        Queries ask = engine.queries();
        Hit ray = ask.rayCast(0, 0, 3, 4, INFINITE, null);
        Hit hit = ask.shapeCast(new Circle(1), 0, 0, 0, 3, 4, INFINITE, null);
        assertThat(hit.distance()).isEqualTo(3);
        for (double factor : new double[] {0x1p-1060, 0x1p-700, 0x1p-300, 0x1p300, 0x1p700, 0x1p1020}) {
            assertThat(ask.rayCast(0, 0, 3 * factor, 4 * factor, INFINITE, null)).isEqualTo(ray);
            assertThat(ask.shapeCast(new Circle(1), 0, 0, 0, 3 * factor, 4 * factor, INFINITE, null)).isEqualTo(hit);
        }
    }

    @Test
    void badQuestionsAreRefused() {
        Queries ask = new PhysicsEngine().queries();
        Shape disc = new Circle(1);
        double nan = Double.NaN;
        refused("x is NaN", disc, nan, 0, 0, 1, 0, 1);
        refused("y is Infinity", disc, 0, INFINITE, 0, 1, 0, 1);
        refused("angle is NaN", disc, 0, 0, nan, 1, 0, 1);
        refused("directionX is NaN", disc, 0, 0, 0, nan, 0, 1);
        refused("directionY is -Infinity", disc, 0, 0, 0, 0, -INFINITE, 1);
        refused("direction is (0.0, 0.0)", disc, 0, 0, 0, 0, 0, 1);
        refused("range is NaN", disc, 0, 0, 0, 1, 0, nan);
        refused("range is -1.0", disc, 0, 0, 0, 1, 0, -1);
        assertThatNullPointerException().isThrownBy(() -> ask.shapeCast((Shape) null, 0, 0, 0, 1, 0, 1, null)).withMessage("shape");
        assertThatNullPointerException().isThrownBy(() -> ask.shapeCast((Body) null, 1, 0, 1, null)).withMessage("body");
        assertThatNullPointerException().isThrownBy(() -> ask.shapeCast(disc, 0, 0, 0, 1, 0, 1, null, null)).withMessage("into");
    }

    private void refused(String message, Shape shape, double x, double y, double angle, double dx, double dy, double range) {
        Queries ask = new PhysicsEngine().queries();
        assertThatIllegalArgumentException().isThrownBy(() -> ask.shapeCast(shape, x, y, angle, dx, dy, range, null)).withMessageContaining(message);
        assertThatIllegalArgumentException().isThrownBy(() -> ask.shapeCastAll(shape, x, y, angle, dx, dy, range, null)).withMessageContaining(message);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> ask.shapeCast(shape, x, y, angle, dx, dy, range, null, new RayHit()))
                .withMessageContaining(message);
    }
}
