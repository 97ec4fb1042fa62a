// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Heaps of bodies welded to one another come to rest, cost nothing then, and wake when something happens to them. */
class LyingHeapTest {
    private static final double G = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();
    private Body floor;

    @BeforeEach
    void begin() {
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -G));
        floor = put(Body.fixed(new Rectangle(400, 2)).at(0, -1));
    }

    private Body put(Body body) {
        body.setFriction(0.5);
        body.setRestitution(0);
        return engine.add(body);
    }

    /** A foot, and a bar upright on it. */
    private Body angle(double x, double y, double side) {
        Body foot = put(new Body(new Rectangle(1, 0.3)).at(x, y));
        Body bar = put(new Body(new Rectangle(0.3, 0.7)).at(x + 0.35 * side, y + 0.5));
        engine.add(new WeldJoint(foot, bar, x, y + 0.15));
        return foot;
    }

    private void heap(int count, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double half = 0.8 * Math.sqrt(count);
        put(Body.fixed(new Rectangle(2, 60)).at(-half - 1, 29));
        put(Body.fixed(new Rectangle(2, 60)).at(half + 1, 29));
        int row = (int) (half / 0.8);
        for (int k = 0; k < count; k++) {
            angle(-half + 0.9 + k % row * 1.6, 1 + k / row * 1.7, random.nextBoolean() ? 1 : -1);
        }
    }

    private void run(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    @ParameterizedTest
    @CsvSource({"8, 1", "20, 1", "20, 2", "20, 3", "40, 1"})
    void theyComeToRestAndCostNothingThen(int count, long seed) {
        heap(count, seed);
        for (int k = 0; k < 20 && (k == 0 || engine.kineticEnergy() > 0); k++) {
            run(60);
        }
        assertThat(engine.kineticEnergy()).isZero();
        run(60); // those that stand still see others stop
        long looks = engine.getNarrowPhaseEvaluations();
        run(300);
        assertThat(engine.kineticEnergy()).isZero();
        assertThat(engine.getNarrowPhaseEvaluations() - looks).isLessThan(4L * engine.bodies().size()); // a last one at each pair
        double mass = engine.bodies().stream().filter(b -> !b.isFixed()).mapToDouble(Body::getMass).sum();
        double borne = engine.bodies().stream().filter(Body::isFixed).flatMap(b -> engine.contacts(b).stream().map(c -> -c.forceY(b)))
                .mapToDouble(f -> f).sum();
        assertThat(borne).isEqualTo(mass * G, within(1e-6 * mass * G));
    }

    /** Each of these finds an angle at rest for a long time, and moves it as if it had never rested. */
    @Test
    void oneFallsWhenItsFloorIsTakenAwayBeTheStepAnother() {
        Body foot = angle(0, 0.15, 1);
        run(60);
        assertThat(engine.kineticEnergy()).isZero();
        double y = foot.getY();
        engine.setTimeStep(1 / 30.0);
        run(5);
        assertThat(foot.getY()).isEqualTo(y, within(1e-11));
        engine.remove(floor);
        run(30);
        assertThat(foot.getY()).isEqualTo(y - G / 2, within(1e-9));
    }

    @Test
    void oneIsStruckByWhatFliesAndByWhatIsTied() {
        Body foot = angle(0, 0.15, 1);
        Body ball = put(new Body(new Circle(0.2)).at(-30, 0.2));
        Body other = put(new Body(new Rectangle(1, 0.3)).at(30, 0.15));
        Body hinged = put(new Body(new Rectangle(1, 0.3)).at(31, 0.15));
        engine.add(new PinJoint(other, hinged, 30.5, 0.15));
        ball.setRestitution(1);
        for (Body body : engine.bodies()) {
            body.setFriction(0);
        }
        run(60);
        assertThat(engine.kineticEnergy()).isZero();
        long looks = engine.getNarrowPhaseEvaluations();
        run(30);
        assertThat(engine.getNarrowPhaseEvaluations()).isEqualTo(looks);
        ball.setVelocity(20, 0);
        double momentum = ball.getMass() * 20;
        run(120);
        assertThat(foot.getVelocityX()).isGreaterThan(0.1);
        assertThat(momentum()).isEqualTo(momentum, within(1e-9));
        other.setVelocity(-10, 0);
        hinged.setVelocity(-10, 0);
        momentum = momentum();
        double before = foot.getVelocityX();
        run(180);
        assertThat(foot.getVelocityX()).isLessThan(before - 0.1);
        assertThat(momentum()).isEqualTo(momentum, within(1e-8));
    }

    private double momentum() {
        return engine.bodies().stream().filter(b -> !b.isFixed()).mapToDouble(b -> b.getMass() * b.getVelocityX()).sum();
    }

    @Test
    void oneThatIsPutElsewhereIsSeenThere() {
        Body foot = angle(0, 0.15, 1);
        angle(3, 0.15, 1);
        Body below = engine.bodies().get(4);
        run(60);
        assertThat(engine.kineticEnergy()).isZero();
        Body bar = engine.bodies().get(2);
        foot.setPosition(foot.getX() + 3, foot.getY() + 5);
        bar.setPosition(bar.getX() + 3, bar.getY() + 5);
        boolean isMet = false;
        for (int k = 0; k < 90; k++) {
            engine.step();
            isMet |= engine.contacts(foot).stream().anyMatch(c -> c.a() == below || c.b() == below);
        }
        assertThat(isMet).isTrue();
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-6);
    }

    @Test
    void aCheckpointOfAHeapAtRestGoesOnAsItDoes() {
        heap(8, 4);
        run(400);
        PhysicsEngine copy = Checkpoint.copy(engine);
        for (PhysicsEngine one : new PhysicsEngine[] {engine, copy}) {
            one.bodies().get(4).setVelocity(1, 3);
            for (int k = 0; k < 20; k++) {
                one.step();
            }
        }
        Checkpoint.assertSameBodies(engine, copy);
        assertThat(engine.kineticEnergy()).isPositive();
    }
}
