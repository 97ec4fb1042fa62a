// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Impacts happen when and where mechanics says, whatever the step. */
class ImpactTimeTest {
    /** Notes the times of collisions. */
    private static final class Times implements CollisionListener {
        private static final long serialVersionUID = 1L;
        final List<Double> times = new ArrayList<>();

        @Override
        public void collided(Contact contact) {
            times.add(contact.time());
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1.0 / 60, 0.1, 0.37, 1, 10})
    void aDiskReturnsFromAWallAsIfReflected(double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.add(Body.fixed(new Rectangle(1, 100)).at(5.5, 0));
        Body disk = engine.add(new Body(new Circle(0.5)).at(0, 0).moving(5.137, 0.7));
        while (engine.getTime() < 2) {
            engine.step();
        }
        double t = engine.getTime();
        assertThat(disk.getX()).isCloseTo(2 * 4.5 - 5.137 * t, within(1e-13 * (5 + 5.137 * t)));
        assertThat(disk.getY()).isCloseTo(0.7 * t, within(1e-13 * (1 + t)));
        assertThat(disk.getVelocityX()).isCloseTo(-5.137, within(2e-15));
        assertThat(disk.getAngularVelocity()).isZero();
    }

    @ParameterizedTest
    @ValueSource(doubles = {1.0 / 240, 1.0 / 60, 0.1, 0.9})
    void aRodBouncesAtTheReferenceTimes(double step) {
        // hard case I02: L = m = 1, y0 = 1.5, angle 0.3, smooth floor, e = 1; the references are for a rod without width
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.add(new Gravity(0, -9.81));
        engine.add(Body.fixed(new Rectangle(100, 2)).at(0, -1));
        Body rod = new Body(new Rectangle(1, 1e-13)).at(0, 1.5, 0.3);
        rod.setMass(1, 1.0 / 12);
        engine.add(rod);
        Times times = new Times();
        engine.addListener(times);
        while (engine.getTime() < 0.9) {
            engine.step();
        }
        assertThat(times.times.get(0)).isCloseTo(0.525058104967551426, within(1e-12));
        assertThat(times.times.get(1)).isCloseTo(0.5536245351263932, within(1e-11));
    }

    @ParameterizedTest
    @CsvSource({"1, 3", "100, 31", "10000, 314", "1000000, 3141", "100000000, 31415"})
    void twoBlocksCountTheDigitsOfPi(double ratio, int digits) {
        assertBlocksCount(ratio, digits);
    }

    @ParameterizedTest
    @Tag("soak")
    @CsvSource({"1e10, 314159", "1e12, 3141592"})
    void twoBlocksCountMoreDigitsOfPi(double ratio, int digits) {
        assertBlocksCount(ratio, digits);
    }

    private static void assertBlocksCount(double ratio, int digits) {
        // hard case I03, Galperin 2003
        PhysicsEngine engine = new PhysicsEngine();
        engine.setWorkLimit(Long.MAX_VALUE);
        engine.add(Body.fixed(new Rectangle(1, 100)).at(-0.5, 0));
        Body small = new Body(new Rectangle(1, 1)).at(1, 0);
        Body large = new Body(new Rectangle(1, 1)).at(3, 0).moving(-1, 0);
        small.setMass(1);
        large.setMass(ratio);
        engine.add(small);
        engine.add(large);
        for (int k = 0; k < 100; k++) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isEqualTo(digits);
        assertThat(large.getVelocityX()).isPositive();
    }

    @Test
    void bulletsHitThinWallsAndOneAnother() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(Body.fixed(new Rectangle(0.01, 10)).at(5000.3, 0));
        Body bullet = engine.add(new Body(new Circle(0.05)).at(0, 0).moving(1000, 0));
        Body left = engine.add(new Body(new Circle(0.05)).at(0, 100).moving(1000, 0));
        Body right = engine.add(new Body(new Circle(0.05)).at(3333, 100).moving(-1000, 0));
        for (int k = 0; k < 10; k++) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isEqualTo(2);
        assertThat(bullet.getVelocityX()).isEqualTo(-1000);
        assertThat(left.getVelocityX()).isCloseTo(-1000, within(1e-9));
        assertThat(right.getVelocityX()).isCloseTo(1000, within(1e-9));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 30, 1000})
    void aSpinningRodNeverPassesAPost(double spin) {
        for (int phase = 0; phase < 20; phase++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.add(Body.fixed(new Circle(0.01)).at(1.5, 0));
            Body rod = new Body(new Rectangle(4, 0.02)).at(0, 0, 0.1 + 0.13 * phase).moving(0, 0, spin);
            engine.add(rod);
            while (engine.getTime() * spin < 3.2) {
                engine.step(); // half a turn and a little
            }
            assertThat(engine.getImpacts()).isPositive();
        }
    }

    @Test
    void aBallComesToRestOnTheFloorAndStaysThere() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.add(new Gravity(0, -9.81));
        engine.add(Body.fixed(new Rectangle(100, 2)).at(0, -1));
        Body ball = new Body(new Circle(0.5)).at(0, 2.5);
        ball.setRestitution(0.5);
        engine.add(ball);
        for (int k = 0; k < 60 * 100; k++) {
            engine.step();
        }
        assertThat(ball.getY()).isCloseTo(0.5, within(1e-13));
        assertThat(ball.getVelocityY()).isZero();
        assertThat(engine.getImpacts()).isBetween(20L, 40L);
    }

    @Test
    void circlesThatAForceSetsInMotionAreLookedAtAFewTimesOnly() {
        PhysicsEngine engine = new PhysicsEngine();
        Body pushed = engine.add(new Body(new Circle(1)));
        Body target = engine.add(new Body(new Circle(1)).at(5, 0));
        engine.add(new sim.physics.motion.Spring(pushed, 0, 0, null, 40, 0, 0, 0.001, 0));
        engine.add(new sim.physics.motion.Spring(target, 0, 0, null, 5, 0, 0, 0.001, 0));
        engine.setTimeStep(0.25);
        for (int k = 0; k < 100; k++) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isPositive();
        assertThat(engine.getNarrowPhaseEvaluations()).isLessThan(2000);
    }
}
