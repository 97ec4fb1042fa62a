// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Joints that can be closed are closed, however far they are open; and those that cannot be are told of once. */
class AssemblyTest {
    private static final double CLOSED = 1e-10;

    private static Body somewhere(PhysicsEngine engine, Random random, Body body) {
        return engine.add(body.at(12 * random.nextDouble() - 6, 12 * random.nextDouble() - 6, 6 * random.nextDouble() - 3));
    }

    private static double gap(Constraint constraint) {
        Equations equations = new Equations();
        constraint.evaluate(equations);
        double most = 0;
        for (int row = 0; row < constraint.getRows(); row++) {
            most = Math.max(most, Math.abs(equations.c[row]));
        }
        return most;
    }

    private static double[] places(PhysicsEngine engine) {
        return engine.bodies().stream()
                .flatMapToDouble(b -> java.util.stream.DoubleStream.of(
                        b.getX(), b.getY(), b.getAngle(), b.getVelocityX(), b.getVelocityY(), b.getAngularVelocity()))
                .toArray();
    }

    /** A translation closes the pin; Newton's method turns the second disc, whose arm is long, to and fro. */
    @Test
    void aPinAtALongArm() {
        PhysicsEngine engine = new PhysicsEngine();
        Body a = engine.add(new Body(new Circle(0.2)).at(2.773, -5.148));
        Body b = engine.add(new Body(new Circle(0.27)).at(2, 0));
        PinJoint pin = PinJoint.bodyPoints(a, 0, 0, b, -2, 0);
        engine.assemble(pin);
        assertThat(gap(pin)).isLessThan(CLOSED);
        double first = a.getMass();
        double second = b.getMass();
        assertThat(first * a.getX() + second * b.getX()).isCloseTo(2.773 * first + 2 * second, within(1e-9));
        assertThat(first * a.getY() + second * b.getY()).isCloseTo(-5.148 * first, within(1e-9));
    }

    /** What is found is the least mass-weighted displacement: any other along the pin is larger. */
    @Test
    void theDisplacementIsTheLeastOneAround() {
        PhysicsEngine engine = new PhysicsEngine();
        Body a = engine.add(new Body(new Circle(0.2)).at(2.773, -5.148));
        Body b = engine.add(new Body(new Circle(0.27)).at(2, 0));
        engine.assemble(PinJoint.bodyPoints(a, 0, 0, b, -2, 0));
        double found = cost(a, b, b.getAngle());
        for (double turn : new double[] {-0.1, -1e-3, 1e-3, 0.1}) {
            assertThat(cost(a, b, b.getAngle() + turn)).isGreaterThan(found);
        }
    }

    /** The least cost of a closed pin at an angle of the second body: the gap is shared as the masses are unlike. */
    private static double cost(Body a, Body b, double angle) {
        double gx = 2 - 2 * StrictMath.cos(angle) - 2.773;
        double gy = -2 * StrictMath.sin(angle) + 5.148;
        double reduced = a.getMass() * b.getMass() / (a.getMass() + b.getMass());
        return reduced * (gx * gx + gy * gy) + b.getInertia() * angle * angle;
    }

    /** The issue: of 500 random places, up to 153 could not be closed by events. */
    @ParameterizedTest
    @CsvSource({"1.4, pin", "1.6, pin", "2.0, pin", "2.2, pin", "2.0, weld"})
    void aTiedBodyIsPutElsewhere(double distance, String kind) {
        for (int seed = 0; seed < 200; seed++) {
            Random random = new Random(seed);
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1 / 60.0);
            Body a = engine.add(new Body(new Circle(0.2)).at(0, 0));
            Body b = engine.add(new Body(new Circle(0.27)).at(distance, 0));
            Constraint joint = engine.add(kind.equals("pin") ? new PinJoint(a, b, 0, 0) : new WeldJoint(a, b, 0, 0));
            a.setPosition(12 * random.nextDouble() - 6, 12 * random.nextDouble() - 6);
            engine.step();
            assertThat(gap(joint)).isLessThan(CLOSED);
        }
    }

    private static Constraint joint(Random random, Body a, Body b, double arm) {
        double ax = arm * random.nextGaussian();
        double ay = arm * random.nextGaussian();
        double bx = arm * random.nextGaussian();
        double by = arm * random.nextGaussian();
        int kind = random.nextInt(5);
        if (kind == 0) {
            return PinJoint.bodyPoints(a, ax, ay, b, bx, by);
        }
        if (kind == 1) {
            return RodJoint.bodyPoints(a, ax, ay, b, bx, by, 0.3 + 2 * random.nextDouble());
        }
        double x = b.getX();
        double y = b.getY();
        b.setPosition(a.getX() + ax + bx, a.getY() + ay + by); // where the joint is made, and closed
        double px = a.getX() + ax;
        double py = a.getY() + ay;
        Constraint made = kind == 2
                ? new WeldJoint(a, b, px, py)
                : kind == 3 ? new SliderJoint(a, b, px, py, bx, by) : new SlotJoint(a, b, px, py, bx, by);
        b.setPosition(x, y);
        return made;
    }

    /** Trees of joints can always be closed. */
    @ParameterizedTest
    @CsvSource({"0.3, false", "1, false", "3, false", "0.3, true", "1, true", "3, true"})
    void treesOfAllJointsFromAnywhere(double arm, boolean isHeld) {
        for (int seed = 0; seed < 200; seed++) {
            Random random = new Random(seed);
            PhysicsEngine engine = new PhysicsEngine();
            List<Body> bodies = new ArrayList<>();
            List<Constraint> joints = new ArrayList<>();
            for (int k = 0, n = 2 + random.nextInt(9); k < n; k++) {
                Circle disc = new Circle(0.1 + random.nextDouble());
                bodies.add(somewhere(engine, random, k == 0 && isHeld ? Body.fixed(disc) : new Body(disc)));
                if (k > 0) {
                    joints.add(joint(random, bodies.get(random.nextInt(k)), bodies.get(k), arm));
                }
            }
            for (Body body : bodies) {
                if (!body.isFixed()) {
                    body.setPosition(12 * random.nextDouble() - 6, 12 * random.nextDouble() - 6);
                    body.setAngle(6 * random.nextDouble() - 3);
                }
            }
            engine.assemble(joints.toArray(new Constraint[0]));
            assertThat(joints).allSatisfy(k -> assertThat(gap(k)).isLessThan(CLOSED));
        }
    }

    /** Polygons of bars on a fixed one, from anywhere: where one way leads into a valley, another is taken. */
    @ParameterizedTest
    @ValueSource(ints = {3, 4, 5, 7})
    void loopsOfBarsFromAnywhere(int bars) {
        for (int seed = 0; seed < 200; seed++) {
            Random random = new Random(seed);
            PhysicsEngine engine = new PhysicsEngine();
            double[] length = random.doubles(bars, 0.5, 2.5).toArray();
            double sum = 0;
            double most = 0;
            for (double k : length) {
                sum += k;
                most = Math.max(most, k);
            }
            if (most > 0.97 * (sum - most)) {
                continue; // no polygon has such sides
            }
            Body[] bar = new Body[bars];
            for (int k = 0; k < bars; k++) {
                Rectangle shape = new Rectangle(length[k], 0.1);
                bar[k] = somewhere(engine, random, k == 0 ? Body.fixed(shape) : new Body(shape));
            }
            Constraint[] pins = new Constraint[bars];
            for (int k = 0; k < bars; k++) {
                int next = (k + 1) % bars;
                pins[k] = PinJoint.bodyPoints(bar[k], length[k] / 2, 0, bar[next], -length[next] / 2, 0);
            }
            engine.assemble(pins);
            assertThat(pins).allSatisfy(k -> assertThat(gap(k)).isLessThan(CLOSED));
        }
    }

    /** A straight chain that is to hang between two places nearer to one another than it is long. */
    @Test
    void aStraightChainBuckles() {
        PhysicsEngine engine = new PhysicsEngine();
        List<Constraint> pins = new ArrayList<>();
        Body last = null;
        for (int k = 0; k < 20; k++) {
            Body bar = engine.add(new Body(new Rectangle(1, 0.1)).at(k + 0.5, 0));
            pins.add(last == null ? PinJoint.bodyPoints(bar, -0.5, 0, null, 0, 0) : PinJoint.bodyPoints(last, 0.5, 0, bar, -0.5, 0));
            last = bar;
        }
        pins.add(PinJoint.bodyPoints(last, 0.5, 0, null, 18, 0));
        engine.assemble(pins.toArray(new Constraint[0]));
        assertThat(pins).allSatisfy(k -> assertThat(gap(k)).isLessThan(CLOSED));
    }

    /** Where Newton's method finds a place, that is the one. */
    @Test
    void whatNewtonsMethodClosesIsAsItWas() {
        PhysicsEngine engine = new PhysicsEngine();
        Body a = engine.add(new Body(new Circle(1)).at(0, 0));
        engine.assemble(PinJoint.bodyPoints(a, 1, 0, null, 2, 0.5));
        assertThat(new double[] {a.getX(), a.getY(), a.getAngle()})
                .containsExactly(1.0524112653771285, 0.18050729270322122, 0.3251940878110461);
    }

    /** Sides of 1, 1 and 2.5: there is no such triangle, wherever one begins. */
    @Test
    void whatCannotBeIsRefusedAndLeavesAllAsItWas() {
        for (int seed = 0; seed < 20; seed++) {
            Random random = new Random(seed);
            PhysicsEngine engine = new PhysicsEngine();
            Body a = somewhere(engine, random, new Body(new Circle(0.3)).moving(1, 2));
            Body b = somewhere(engine, random, new Body(new Circle(0.3)).moving(-1, 2));
            Body c = somewhere(engine, random, new Body(new Circle(0.3)));
            double[] before = places(engine);
            assertThatThrownBy(() -> engine.assemble(
                            RodJoint.bodyPoints(a, 0, 0, b, 0, 0, 1),
                            RodJoint.bodyPoints(b, 0, 0, c, 0, 0, 1),
                            RodJoint.bodyPoints(c, 0, 0, a, 0, 0, 2.5)))
                    .isInstanceOf(ConstraintException.class)
                    .hasMessageContaining("cannot be satisfied");
            assertThat(places(engine)).isEqualTo(before);
            assertThat(engine.allConstraints()).isEmpty();
        }
    }

    /**
     * An end of a chain is put where the chain does not reach. The step says so; the one after it is relieved; and when the end is
     * put back, the joints are closed, and events are found again.
     */
    @Test
    void whatCannotBeIsToldOnce() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        Body end = engine.add(Body.fixed(new Circle(0.1)).at(3, 0));
        Body a = engine.add(new Body(new Circle(0.1)).at(1, -1));
        Body b = engine.add(new Body(new Circle(0.1)).at(2, -1));
        List<Constraint> rods = List.of(
                engine.add(RodJoint.bodyPoints(a, 0, 0, null, 0, 0)),
                engine.add(RodJoint.bodyPoints(a, 0, 0, b, 0, 0)),
                engine.add(RodJoint.bodyPoints(b, 0, 0, end, 0, 0)));
        engine.step();
        double[] before = places(engine);
        end.setPosition(20, 0);
        assertThatThrownBy(engine::step).isInstanceOf(ConstraintException.class).hasMessageContaining("cannot be satisfied");
        end.setPosition(3, 0);
        assertThat(places(engine)).isEqualTo(before);
        engine.step(); // he has understood
        assertThat(engine.getRelievedSteps()).isZero();
        end.setPosition(20, 0);
        assertThatThrownBy(engine::step).isInstanceOf(ConstraintException.class);
        long steps = engine.getSteps();
        engine.step(); // he has not
        engine.step();
        assertThat(engine.getSteps()).isEqualTo(steps + 2);
        assertThat(engine.getRelievedSteps()).isEqualTo(2);
        end.setPosition(3, 0);
        for (int k = 0; k < 20; k++) {
            engine.step();
        }
        long relieved = engine.getRelievedSteps();
        engine.step();
        assertThat(engine.getRelievedSteps()).isEqualTo(relieved);
        assertThat(rods).allSatisfy(k -> assertThat(gap(k)).isLessThan(CLOSED));
    }
}
