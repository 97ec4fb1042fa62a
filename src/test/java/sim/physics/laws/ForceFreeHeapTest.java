// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Bodies that lie on one another and turn, and on which no force acts, or the same on all: they keep their momenta, and gain no energy. */
class ForceFreeHeapTest {
    /** From the centre of a bar to that of what slides on it. */
    static final double HEIGHT = 0.3;

    /** A box slides outwards on a heavy bar that turns at 1 rad/s: r″ = r − μ (2 r′ − d), from r = r′ = 1. */
    static double outwards(double friction, double time) {
        double fast = -friction + Math.sqrt(friction * friction + 1);
        double slow = -friction - Math.sqrt(friction * friction + 1);
        double rest = -friction * HEIGHT; // where it would stay
        double a = (1 - slow * (1 - rest)) / (fast - slow);
        return rest + a * Math.exp(fast * time) + (1 - rest - a) * Math.exp(slow * time);
    }

    @ParameterizedTest
    @CsvSource({"60, 0", "60, 0.2", "60, 0.5", "960, 0", "960, 1e-9", "960, 0.2"})
    void aBoxSlidesOutwardsOnATurningBar(double stepsInASecond, double friction) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / stepsInASecond);
        Body bar = put(engine, new Body(new Rectangle(20, 0.2)).moving(0, 0, 1), friction, 0);
        bar.setMass(4e7);
        Body box = put(engine, new Body(new Rectangle(0.4, 0.4)).at(1, HEIGHT).moving(1 - HEIGHT, 1, 1), friction, 0);
        for (int k = 0; k < stepsInASecond; k++) {
            engine.step();
        }
        double along = box.getX() * Math.cos(bar.getAngle()) + box.getY() * Math.sin(bar.getAngle());
        assertThat(along).isCloseTo(outwards(friction, 1), within(2e-4));
        assertThat(bar.getAngularVelocity()).isCloseTo(1, within(1e-6));
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0, 240, 60", "0, 0.3, 240, 40", "0, 0, 60, 100", "9.81, 0, 240, 60", "9.81, 0.3, 240, 40", "9.81, 0, 60, 100", "9.81, 0.3, 60, 60"
    })
    void bodiesThatFlyTogetherKeepTheirMomenta(double gravity, double restitution, double stepsInASecond, int seeds) {
        for (int seed = 0; seed < seeds; seed++) {
            PhysicsEngine engine = thrownTogether(new Random(seed), gravity, restitution);
            engine.setTimeStep(1 / stepsInASecond);
            double[] before = books(engine, 0, 0);
            double energy = before[3];
            for (int k = 0; k < 2 * stepsInASecond; k++) {
                engine.step();
                double[] now = books(engine, gravity, engine.getTime());
                assertThat(now[0]).as("seed %d, step %d", seed, k).isCloseTo(before[0], within(1e-11));
                assertThat(now[1]).as("seed %d, step %d", seed, k).isCloseTo(before[1], within(1e-11));
                assertThat(now[2]).as("seed %d, step %d", seed, k).isCloseTo(before[2], within(1e-3));
                assertThat(now[3]).as("seed %d, step %d", seed, k).isLessThanOrEqualTo(energy + (gravity == 0 ? 1e-12 : 1e-10) * before[3]);
                energy = now[3];
            }
        }
    }

    /** What tumbles makes much of rounding, so not all of them: a fifth did. */
    @ParameterizedTest
    @CsvSource({"60, 1e-4", "240, 1e-5"})
    void whoFallsAlongSeesNoGravity(double stepsInASecond, double error) {
        int same = 0;
        int scenes = 40;
        for (int seed = 0; seed < scenes; seed++) {
            PhysicsEngine falling = thrownTogether(new Random(seed), 9.81, 0);
            PhysicsEngine floating = thrownTogether(new Random(seed), 0, 0);
            falling.setTimeStep(1 / stepsInASecond);
            floating.setTimeStep(1 / stepsInASecond);
            for (int k = 0; k < 2 * stepsInASecond; k++) {
                falling.step();
                floating.step();
            }
            double way = 0.5 * 9.81 * falling.getTime() * falling.getTime();
            double most = 0;
            for (int k = 0; k < falling.bodies().size(); k++) {
                Body one = falling.bodies().get(k);
                Body other = floating.bodies().get(k);
                most = Math.max(most, Math.hypot(one.getX() - other.getX(), one.getY() + way - other.getY()));
            }
            same += most <= error ? 1 : 0;
        }
        assertThat(same).isGreaterThanOrEqualTo(scenes * 4 / 5);
    }

    /** What was pushed evenly in flight is borne as any pile when it has landed. */
    @Test
    void whatFliesTogetherLandsAndLies() {
        for (int seed = 0; seed < 12; seed++) {
            PhysicsEngine engine = thrownTogether(new Random(seed), 9.81, 0);
            engine.setTimeStep(1.0 / 240);
            put(engine, Body.fixed(new Rectangle(200, 2)).at(0, -9), 0.5, 0);
            double first = energy(engine);
            for (int k = 0; k < 960; k++) {
                engine.step();
                assertThat(energy(engine)).as("seed %d, step %d", seed, k).isLessThanOrEqualTo(first + 1e-9);
            }
            assertThat(engine.overlaps()).as("seed %d", seed).allSatisfy(overlap -> assertThat(overlap.depth()).isLessThan(1e-9));
        }
    }

    private static double energy(PhysicsEngine engine) {
        double sum = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            sum += body.isFixed() ? 0 : 9.81 * body.getMass() * body.getY();
        }
        return sum;
    }

    @Test
    void whatIsThrownAtASmoothWallSlidesOnAlongIt() {
        for (int seed = 0; seed < 40; seed++) {
            PhysicsEngine engine = thrownTogether(new Random(seed), 0, 0);
            engine.setTimeStep(1.0 / 240);
            for (Body body : engine.bodies()) {
                body.setFriction(0);
                body.setVelocity(body.getVelocityX() + 1, body.getVelocityY() - 3);
            }
            put(engine, Body.fixed(new Rectangle(200, 2)).at(0, -8), 0, 0);
            double before = books(engine, 0, 0)[0];
            for (int k = 0; k < 720; k++) {
                engine.step();
                assertThat(books(engine, 0, 0)[0]).as("seed %d, step %d", seed, k).isCloseTo(before, within(1e-9));
            }
        }
    }

    /** A heap that was solved for the last 4 · 10⁻¹⁷ s of a step started the next one from forces that were rounding errors by that time. */
    @Test
    void aHeapThatIsSolvedAtTheVeryEndOfAStepGainsNoEnergy() {
        Random random = new Random(2);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        for (int k = 0; k < 49; k++) {
            double x = 1.8 * (k % 7 - 3.5);
            double y = 1.8 * (k / 7 - 3.5);
            Shape shape = random.nextInt(3) == 0 ? new Circle(0.4) : new Rectangle(0.5 + 0.5 * random.nextDouble(), 0.4 + 0.4 * random.nextDouble());
            double angle = 6 * random.nextDouble();
            put(engine, new Body(shape).at(x, y, angle).moving(-0.3 * x, -0.3 * y, random.nextDouble() - 0.5), 0.5, 0);
        }
        double first = books(engine, 0, 0)[3];
        double energy = first;
        for (int k = 0; k < 290; k++) {
            engine.step();
            double now = books(engine, 0, 0)[3];
            assertThat(now).as("step %d", k).isLessThanOrEqualTo(energy + 1e-12 * first);
            energy = now;
        }
    }

    private static PhysicsEngine thrownTogether(Random random, double gravity, double restitution) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(new Gravity(0, -gravity));
        int n = 2 + random.nextInt(4);
        double friction = random.nextInt(3) == 0 ? 0 : random.nextDouble();
        for (int k = 0; k < n; k++) {
            double turn = 2 * Math.PI * k / n;
            double x = (1.2 + 0.5 * n) * Math.cos(turn + 0.3 * random.nextDouble());
            double y = (1.2 + 0.5 * n) * Math.sin(turn);
            double angle = 6 * random.nextDouble();
            double part = (1 + random.nextDouble()) / (1.2 + 0.5 * n);
            put(engine, new Body(shape(random)).at(x, y, angle).moving(-part * x, -part * y, 4 * random.nextDouble() - 2), friction, restitution);
        }
        return engine;
    }

    private static Shape shape(Random random) {
        double which = random.nextDouble();
        if (which < 0.55) {
            return new Rectangle(0.3 + random.nextDouble() * (random.nextInt(3) == 0 ? 2 : 0.7), 0.2 + 0.6 * random.nextDouble());
        }
        double size = 0.25 + 0.3 * random.nextDouble();
        return which < 0.75 ? new Circle(size) : Polygon.regular(3 + random.nextInt(4), size);
    }

    private static Body put(PhysicsEngine engine, Body body, double friction, double restitution) {
        body.setFriction(friction);
        body.setRestitution(restitution);
        return engine.add(body);
    }

    /** Momentum, angular momentum about the origin and kinetic energy, seen by one who falls with the bodies. */
    private static double[] books(PhysicsEngine engine, double gravity, double time) {
        double[] sums = new double[4];
        for (Body body : engine.bodies()) {
            double m = body.isFixed() ? 0 : body.getMass();
            double spin = body.isFixed() ? 0 : body.getInertia() * body.getAngularVelocity();
            double vx = body.getVelocityX();
            double vy = body.getVelocityY() + gravity * time;
            sums[0] += m * vx;
            sums[1] += m * vy;
            sums[2] += m * (body.getX() * vy - (body.getY() + 0.5 * gravity * time * time) * vx) + spin;
            sums[3] += 0.5 * m * (vx * vx + vy * vy) + 0.5 * spin * body.getAngularVelocity();
        }
        return sums;
    }
}
