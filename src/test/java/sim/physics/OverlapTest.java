// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.collision.CollisionFilter;
import sim.physics.collision.Overlap;
import sim.physics.collision.Overlaps;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Bodies that overlap are reported, and parted on request. */
class OverlapTest {
    @Test
    void anOverlapIsReportedWithItsDepth() {
        PhysicsEngine engine = new PhysicsEngine();
        Body a = engine.add(new Body(new Circle(1)).at(0, 0));
        Body b = engine.add(new Body(new Rectangle(2, 2)).at(1.75, 0));
        assertThat(engine.overlaps()).hasSize(1);
        assertThat(engine.overlaps().get(0).depth()).isCloseTo(0.25, within(1e-15));
        assertThat(engine.separate()).isEqualTo(1);
        assertThat(engine.overlaps()).isEmpty();
        // the lighter body went the farther, and the common centre of mass stayed
        assertThat(Math.abs(a.getX()) / (b.getX() - 1.75)).isCloseTo(b.getMass() / a.getMass(), within(1e-6));
    }

    /** Some bodies of very unlike size anywhere in a square, or in a column. */
    private static List<Body> strewn(PhysicsEngine engine, int n, double width, double height) {
        SplittableRandom random = new SplittableRandom(7);
        List<Body> bodies = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            double size = k % 50 == 0 ? 8 : 0.25 + random.nextDouble();
            Shape shape = k % 3 == 0 ? new Rectangle(size, 0.5 * size) : new Circle(0.5 * size);
            Body body = k % 7 == 0 ? Body.fixed(shape) : new Body(shape);
            body.setAngle(k);
            bodies.add(engine.add(body.at(width * random.nextDouble(), height * random.nextDouble())));
        }
        return bodies;
    }

    @ParameterizedTest
    @CsvSource({"20, 20", "0, 200", "200, 1e9"})
    void whatIsFoundAmongManyIsFoundPairByPair(double width, double height) {
        PhysicsEngine engine = new PhysicsEngine();
        List<Body> bodies = strewn(engine, 300, width, height);
        Overlaps one = new Overlaps(new CollisionFilter());
        List<Overlap> pairs = new ArrayList<>();
        for (int k = 0; k < bodies.size(); k++) {
            for (int m = 0; m < k; m++) {
                pairs.addAll(one.find(List.of(bodies.get(m), bodies.get(k))));
            }
        }
        pairs.sort((p, q) -> Double.compare(q.depth(), p.depth()));
        assertThat(engine.overlaps()).isEqualTo(pairs);
    }

    /** As pairs of 150,000 bodies, these would not be done with before the tests' time is over. */
    @Test
    void aCrowdIsParted() {
        PhysicsEngine engine = new PhysicsEngine();
        for (int k = 0; k < 150_000; k++) {
            engine.add(new Body(new Circle(0.5)).at(2 * (k % 400) + 1e-3 * (k % 7), 1.2 * (k / 400) + 0.25 * (k % 11 / 10)));
        }
        assertThat(engine.overlaps()).isNotEmpty();
        assertThat(engine.separate()).isPositive();
        assertThat(engine.overlaps()).isEmpty();
    }

    /** Two rods that welds hold across one another: to part them opens the welds, and to close these brings them back, for ever. */
    @Test
    void whatHasNoRoomIsGivenUpAndPutBack() {
        PhysicsEngine engine = new PhysicsEngine();
        Body trunk = engine.add(new Body(new Rectangle(4, 0.2)).at(0, 1));
        for (int side = -1; side <= 1; side += 2) {
            Body limb = engine.add(new Body(new Rectangle(2, 0.2)).at(0.4 * side, 0.1, 1.2 * side).moving(1, 2, 0));
            engine.add(new WeldJoint(trunk, limb, 0.7 * side, 0.95));
        }
        List<double[]> before = places(engine);
        assertThat(engine.overlaps()).hasSize(1);
        assertThatThrownBy(engine::separate).isInstanceOf(IllegalStateException.class).hasMessageContaining("is there room?");
        assertThat(places(engine)).usingRecursiveComparison().isEqualTo(before);
        assertThat(engine.overlaps()).hasSize(1);
    }

    private static List<double[]> places(PhysicsEngine engine) {
        return engine.bodies().stream()
                .map(b -> new double[] {b.getX(), b.getY(), b.getAngle(), b.getVelocityX(), b.getVelocityY(), b.getAngularVelocity()})
                .toList();
    }

    @Test
    void aHeapIsPartedWithoutGainOfEnergy() {
        PhysicsEngine engine = new PhysicsEngine();
        SplittableRandom random = new SplittableRandom(1);
        for (int k = 0; k < 30; k++) {
            Body body = new Body(k % 2 == 0 ? new Circle(1) : new Rectangle(1, 2));
            engine.add(body.at(6 * random.nextDouble(), 6 * random.nextDouble(), random.nextDouble()).moving(1, 0));
        }
        double energy = engine.kineticEnergy();
        assertThat(engine.overlaps()).isNotEmpty();
        engine.separate();
        assertThat(engine.overlaps()).isEmpty();
        assertThat(engine.kineticEnergy()).isEqualTo(energy);
        for (int k = 0; k < 20; k++) {
            engine.step();
        }
        assertThat(Scenes.smallestGap(engine)).isGreaterThan(-1e-9);
    }

    @Test
    void jointedBodiesArePartedFromOthersAndStayJointed() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        Body ground = engine.add(Body.fixed(new Rectangle(200, 2)).at(0, -1));
        Body chassis = engine.add(new Body(new Rectangle(3, 0.5)).at(0, 0.6));
        Body wheel = engine.add(new Body(new Circle(0.4)).at(-1, 0.2));
        PinJoint pin = engine.add(new PinJoint(chassis, wheel, -1, 0.2));
        assertThat(engine.overlaps()).extracting(Overlap::a, Overlap::b).containsExactly(tuple(ground, wheel));
        engine.separate();
        assertThat(engine.overlaps()).isEmpty();
        double apart = Math.hypot(wheel.getX() - chassis.getX(), wheel.getY() - chassis.getY());
        assertThat(apart).isCloseTo(Math.hypot(1, 0.4), within(1e-12));
        double y = wheel.getY();
        engine.step(); // closes joints: there was nothing left to close
        assertThat(wheel.getY()).isCloseTo(y, within(1e-12));
        assertThat(engine.contains(pin)).isTrue();
    }

    /** Two bodies that lie in one another part by the least way, which their masses share; nothing else changes. */
    private static void assertParted(PhysicsEngine engine, Body a, Body b, double depth) {
        double energy = engine.kineticEnergy();
        double middleX = a.getMass() * a.getX() + b.getMass() * b.getX();
        double middleY = a.getMass() * a.getY() + b.getMass() * b.getY();
        double[] from = {a.getX(), a.getY(), b.getX(), b.getY()};
        double mass = a.getMass() + b.getMass();
        assertThat(engine.overlaps()).hasSize(1);
        assertThat(engine.overlaps().get(0).depth()).isCloseTo(depth, within(1e-14 * depth));
        assertThat(engine.separate()).isEqualTo(1);
        assertThat(engine.overlaps()).isEmpty();
        assertThat(engine.kineticEnergy()).isEqualTo(energy);
        double wayA = StrictMath.hypot(a.getX() - from[0], a.getY() - from[1]);
        double wayB = StrictMath.hypot(b.getX() - from[2], b.getY() - from[3]);
        assertThat(wayA + wayB).isCloseTo(depth, within(1e-9 * depth));
        assertThat(wayA).isCloseTo(depth * b.getMass() / mass, within(1e-9 * depth));
        assertThat(a.getMass() * a.getX() + b.getMass() * b.getX()).isCloseTo(middleX, within(1e-13 * mass));
        assertThat(a.getMass() * a.getY() + b.getMass() * b.getY()).isCloseTo(middleY, within(1e-13 * mass));
    }

    @ParameterizedTest
    @CsvSource({"1, 0", "1, 0.3", "0.1, 0", "1e-3, 0.3", "1e-9, 0"})
    void aBodyWithinAnotherIsPartedFromIt(double size, double off) {
        PhysicsEngine discs = new PhysicsEngine();
        Body disc = discs.add(new Body(new Circle(2)).at(0, 0).moving(1, 2, 3));
        assertParted(discs, disc, discs.add(new Body(new Circle(size)).at(off, 0)), 2 + size - off);
        PhysicsEngine squares = new PhysicsEngine();
        Body square = squares.add(new Body(new Rectangle(4, 4)).at(0, 0).moving(1, 2, 3));
        assertParted(squares, square, squares.add(new Body(new Rectangle(size, size)).at(off, 0)), 2 + size / 2 - off);
    }

    @Test
    void twoBodiesInOnePlaceArePartedTheShortestWay() {
        PhysicsEngine engine = new PhysicsEngine();
        Body disc = engine.add(new Body(new Circle(1)).at(3, 4).moving(1, 0));
        assertParted(engine, disc, engine.add(new Body(new Circle(1)).at(3, 4).moving(1, 0)), 2);
        PhysicsEngine rods = new PhysicsEngine();
        Body rod = rods.add(new Body(new Rectangle(1, 2)).at(30, 4));
        assertParted(rods, rod, rods.add(new Body(new Rectangle(1, 2)).at(30, 4)), 1);
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 5, 20})
    void manyBodiesInOnePlaceAreParted(int count) {
        PhysicsEngine engine = new PhysicsEngine();
        for (int k = 0; k < count; k++) {
            engine.add(new Body(k % 2 == 0 ? new Circle(1) : new Rectangle(2, 0.5)).at(3, 4).moving(1, 2));
        }
        double energy = engine.kineticEnergy();
        assertThat(engine.overlaps()).hasSize(count * (count - 1) / 2);
        engine.separate();
        assertThat(engine.overlaps()).isEmpty();
        assertThat(engine.kineticEnergy()).isEqualTo(energy);
        double mass = engine.bodies().stream().mapToDouble(Body::getMass).sum();
        double x = engine.bodies().stream().mapToDouble(body -> body.getMass() * body.getX()).sum() / mass;
        assertThat(x).isCloseTo(3, within(1e-12));
        assertThat(Scenes.smallestGap(engine)).isGreaterThan(0);
    }

    @Test
    void noRoomIsSaid() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(Body.fixed(new Rectangle(1, 1)).at(0, 0));
        engine.add(Body.fixed(new Rectangle(1, 1)).at(2, 0));
        engine.add(Body.fixed(new Rectangle(1, 1)).at(1, 1));
        engine.add(Body.fixed(new Rectangle(1, 1)).at(1, -1));
        engine.add(new Body(new Rectangle(1.2, 1.2)).at(1, 0));
        assertThatThrownBy(engine::separate).isInstanceOf(IllegalStateException.class).hasMessageContaining("room");
    }

    @Test
    void bisectionFindsAContactThatIsDeepEnoughAndMissesABullet() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setContinuousDetection(false);
        engine.setTimeStep(0.1);
        engine.add(Body.fixed(new Rectangle(1, 10)).at(5, 0));
        Body slow = engine.add(new Body(new Rectangle(1, 1)).at(0, 0).moving(3, 0));
        Body bullet = engine.add(new Body(new Circle(0.1)).at(0, 3).moving(1000, 0));
        for (int k = 0; k < 20; k++) {
            engine.step();
        }
        assertThat(slow.getVelocityX()).isCloseTo(-3, within(1e-14));
        assertThat(slow.getX()).isCloseTo(8 - 6, within(1e-12));
        assertThat(bullet.getVelocityX()).isEqualTo(1000);
    }
}
