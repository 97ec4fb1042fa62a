// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.SurfaceFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Bodies that get another shape. */
class ChangedShapeTest {
    private static final double G = 9.81;

    private static PhysicsEngine engine(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 64.0);
        engine.setTimeStepping(substeps);
        return engine;
    }

    private static void run(PhysicsEngine engine, int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    private static Body rough(Body body, double restitution) {
        body.setFriction(0.4);
        body.setRestitution(restitution);
        return body;
    }

    private static Shape another(Random random) {
        double size = 0.7 + 0.3 * random.nextDouble();
        return switch (random.nextInt(4)) {
            case 0 -> new Circle(0.3 * size);
            case 1 -> new Rectangle(0.5 * size, 0.4 * size);
            case 2 -> Polygon.regular(5, 0.3 * size);
            default -> new Compound(Compound.box(0, 0, 0.5 * size, 0.1), Compound.box(0, 0, 0.1, 0.5 * size));
        };
    }

    /** A body with the new shape in the place of the old one, which the author removes. */
    private static Body replaced(PhysicsEngine engine, Body body, Shape shape) {
        engine.remove(body);
        Body other = new Body(shape)
                .at(body.getX(), body.getY(), body.getAngle())
                .moving(body.getVelocityX(), body.getVelocityY(), body.getAngularVelocity());
        other.setMass(body.getMass());
        return engine.add(rough(other, body.getRestitution()));
    }

    private static List<Body> scene(long seed, PhysicsEngine engine, boolean isSet) {
        Random random = new Random(seed);
        double restitution = random.nextInt(3) / 2.0;
        engine.add(new Gravity(0, -G));
        engine.add(rough(Body.fixed(new Rectangle(8, 0.5)).at(0, -3), restitution));
        engine.add(rough(Body.fixed(new Rectangle(0.5, 8)).at(-4, 1), restitution));
        engine.add(rough(Body.fixed(new Rectangle(0.5, 8)).at(4, 1), restitution));
        List<Body> bodies = new ArrayList<>();
        for (int k = 0; k < 8; k++) {
            Body body = new Body(k % 2 == 0 ? new Circle(0.3) : new Rectangle(0.5, 0.4)).at(-3 + 0.8 * k, 3 * random.nextDouble());
            bodies.add(engine.add(rough(body.moving(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()), restitution)));
        }
        for (int k = 0; k < 120; k++) {
            if (k % 10 == 3) {
                int one = random.nextInt(8);
                Shape shape = another(random);
                if (isSet) {
                    bodies.get(one).setShape(shape);
                } else {
                    bodies.set(one, replaced(engine, bodies.get(one), shape));
                }
            }
            engine.step();
        }
        return bodies;
    }

    /** Whoever flies, lies or bounces goes on as a body of the new shape does that is put in its place. */
    @ParameterizedTest
    @CsvSource({"0, 1e-9", "4, 0"})
    void goesOnLikeOneOfThatShape(int substeps, double tolerance) {
        for (int seed = 2; seed < 7; seed++) {
            List<Body> set = scene(seed, engine(substeps), true);
            List<Body> replaced = scene(seed, engine(substeps), false);
            for (int k = 0; k < set.size(); k++) {
                assertThat(set.get(k).getX()).isCloseTo(replaced.get(k).getX(), within(tolerance));
                assertThat(set.get(k).getY()).isCloseTo(replaced.get(k).getY(), within(tolerance));
                assertThat(set.get(k).getAngle()).isCloseTo(replaced.get(k).getAngle(), within(10 * tolerance));
            }
        }
    }

    /** What stood on a body falls when that shrinks, and so does the body. */
    @ParameterizedTest
    @CsvSource({"0, 1e-9", "4, 5e-3"})
    void whatItBearsFalls(int substeps, double tolerance) {
        PhysicsEngine engine = engine(substeps);
        engine.add(new Gravity(0, -G));
        engine.setSleepAllowed(true);
        engine.add(rough(Body.fixed(new Rectangle(8, 1)), 0));
        Body box = engine.add(rough(new Body(new Rectangle(1, 1)).at(0, 1), 0));
        Body top = engine.add(rough(new Body(new Rectangle(0.5, 0.5)).at(0, 1.75), 0));
        run(engine, 128);
        box.setShape(new Rectangle(1, 0.5));
        run(engine, 8);
        assertThat(box.getY()).isCloseTo(1 - G / 128, within(tolerance));
        assertThat(top.getY()).isCloseTo(1.75 - G / 128, within(tolerance));
        run(engine, 128);
        assertThat(box.getY()).isCloseTo(0.75, within(tolerance));
        assertThat(top.getY()).isCloseTo(1.25, within(tolerance));
    }

    /** A pendulum whose bob changes swings as one that was made so. */
    @Test
    void aPendulumChangesItsBob() {
        PhysicsEngine engine = engine(0);
        engine.add(new Gravity(0, -G));
        Body bob = engine.add(new Body(new Circle(0.1)).at(0.6, -0.8));
        engine.add(new PinJoint(bob, null, 0, 0));
        bob.setMass(2);
        bob.setShape(new Rectangle(1, 0.2));
        assertThat(bob.getMass()).isEqualTo(2);
        assertThat(bob.getInertia()).isCloseTo(2 * (1 + 0.04) / 12, within(1e-15));
        PhysicsEngine other = engine(0);
        other.add(new Gravity(0, -G));
        Body second = other.add(new Body(new Rectangle(1, 0.2)).at(0.6, -0.8));
        other.add(new PinJoint(second, null, 0, 0));
        run(engine, 100);
        run(other, 100);
        assertThat(bob.getX()).isCloseTo(second.getX(), within(1e-12));
        bob.setShape(new Circle(0.3));
        run(engine, 100);
        assertThat(Math.hypot(bob.worldX(-0.6, 0.8), bob.worldY(-0.6, 0.8))).isLessThan(1e-14);
    }

    /** A disc that spins on a plane with friction stops in 3 ω R / 4 μ g; if it becomes half as large at first, in half of that. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0.5})
    void aDiscRubsWithItsNewRadius(double radius) {
        PhysicsEngine engine = engine(0);
        engine.add(new SurfaceFriction(G));
        Body disc = engine.add(new Body(new Circle(1)).moving(0, 0, 4));
        disc.setSurfaceFriction(0.1);
        run(engine, 8);
        double left = disc.getAngularVelocity();
        disc.setShape(new Circle(radius));
        run(engine, 32);
        assertThat(disc.getAngularVelocity()).isCloseTo(left - 0.5 * 4 * 0.1 * G / (3 * radius), within(1e-9));
    }

    /** A ball shrinks where it hits: it turns at the next wall by its new radius. */
    @Test
    void aListenerShrinksABall() {
        PhysicsEngine engine = engine(0);
        engine.add(Body.fixed(new Rectangle(1, 4)).at(-2, 0));
        engine.add(Body.fixed(new Rectangle(1, 4)).at(2, 0));
        Body ball = engine.add(new Body(new Circle(0.5)).at(0, 0).moving(1, 0));
        engine.addListener(new CollisionListener() {
            @Override
            public void collided(Contact contact) {
                ball.setShape(new Circle(0.25));
            }
        });
        run(engine, 64 * 4);
        // 1 to the right, then 2.25 to the left, and back
        assertThat(engine.getImpacts()).isEqualTo(2);
        assertThat(ball.getX()).isCloseTo(1 - 2.25 + 0.75, within(1e-12));
        assertThat(ball.getVelocityX()).isEqualTo(1);
    }

    @Test
    void questionsSeeTheNewShape() {
        PhysicsEngine engine = engine(0);
        Body body = engine.add(new Body(new Circle(0.5)).at(3, 0));
        assertThat(engine.queries().rayCast(0, 0, 1, 0, 10, one -> true).distance()).isCloseTo(2.5, within(1e-12));
        body.setShape(new Rectangle(4, 4));
        assertThat(engine.queries().rayCast(0, 0, 1, 0, 10, one -> true).distance()).isCloseTo(1, within(1e-12));
        assertThat(engine.queries().rayCast(0, 1.9, 1, 0, 10, one -> true).distance()).isCloseTo(1, within(1e-12));
    }

    @Test
    void aCopyGoesOnTheSame() throws Exception {
        PhysicsEngine engine = engine(0);
        scene(3, engine, true);
        engine.bodies().get(5).setShape(new Circle(0.2));
        PhysicsEngine copy = Checkpoint.copy(engine);
        run(engine, 100);
        run(copy, 100);
        for (int k = 0; k < engine.bodies().size(); k++) {
            assertThat(copy.bodies().get(k).getX()).isEqualTo(engine.bodies().get(k).getX());
            assertThat(copy.bodies().get(k).getShape()).isEqualTo(engine.bodies().get(k).getShape());
        }
    }

    @Test
    void whatIsNoShapeIsRefused() {
        Body body = new Body(new Circle(1));
        assertThatNullPointerException().isThrownBy(() -> body.setShape(null)).withMessageContaining("shape");
        body.setMass(1e-300);
        assertThatIllegalArgumentException().isThrownBy(() -> body.setShape(new Circle(1e-10))).withMessageContaining("inertia");
        assertThat(body.getShape()).isEqualTo(new Circle(1));
        assertThat(body.getInertia()).isEqualTo(0.5e-300);
        Body wall = Body.fixed(new Circle(1));
        wall.setShape(new Circle(2));
        assertThat(wall.getInertia()).isInfinite();
        assertThatNullPointerException().isThrownBy(() -> wall.setShape(null)).withMessageContaining("shape");
    }
}
