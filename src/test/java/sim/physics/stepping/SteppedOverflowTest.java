// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Steps that throw bodies beyond all numbers are refused, and leave all where it was: bodies were nowhere from then on, without a word. */
class SteppedOverflowTest {
    private static final double STEP = 1.0 / 64;

    /** Stacks of discs and boxes, some elastic, some pinned to one another. */
    private static PhysicsEngine heap(int bodies, boolean isPinned) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(STEP);
        engine.setTimeStepping(4);
        engine.add(new Gravity(0, -10));
        Body ground = engine.add(Body.fixed(new Rectangle(200, 1)).at(0, -0.5));
        ground.setFriction(0.5);
        Body last = null;
        for (int k = 0; k < bodies; k++) {
            Body body = engine.add(new Body(k % 3 == 0 ? new Circle(0.5) : new Rectangle(1, 1)).at(1.5 * (k % 20), 0.5 + 1.01 * (k / 20)));
            body.setFriction(0.5);
            body.setRestitution(k % 5 == 0 ? 0.5 : 0);
            if (isPinned && k % 4 == 3) {
                engine.add(new PinJoint(last, body, 0.5 * (last.getX() + body.getX()), last.getY()));
            }
            last = body;
        }
        return engine;
    }

    private static void run(PhysicsEngine engine, int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e20, 1e100, 1e160, 1e300})
    void aStepThatIsFarTooLongIsRefused(double step) {
        for (int bodies : new int[] {20, 100}) {
            PhysicsEngine engine = heap(bodies, false);
            run(engine, 100);
            long before = Scenes.hash(engine);
            engine.setTimeStep(step);
            for (int k = 0; k < 3; k++) {
                assertThatIllegalStateException().isThrownBy(engine::step).withMessageContaining("thrown beyond all numbers in a step of " + step);
                assertThat(Scenes.hash(engine)).isEqualTo(before);
                assertThat(engine.getSteps()).isEqualTo(100);
                assertThat(engine.getTime()).isEqualTo(100 * STEP);
            }
            assertThat(engine.contacts()).isEmpty();
        }
    }

    /** What has been found in it is no part of what follows. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aRunGoesOnAfterIt(boolean isPinned) {
        PhysicsEngine engine = heap(100, isPinned);
        run(engine, 200);
        PhysicsEngine twin = heap(100, isPinned);
        run(twin, 200);
        engine.setTimeStep(1e100);
        assertThatIllegalStateException().isThrownBy(engine::step);
        engine.setTimeStep(STEP);
        run(engine, 200);
        run(twin, 200);
        assertThat(engine.getDeepestPenetration()).isLessThan(2 * twin.getDeepestPenetration());
        assertThat(engine.kineticEnergy()).as("of discs that roll").isLessThan(2 * twin.kineticEnergy());
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-100, 1e-200, 1e-300})
    void aMassThatIsFarTooSmallIsRefused(double mass) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(STEP);
        engine.setTimeStepping(4);
        engine.add(new Gravity(0, -10));
        engine.add(Body.fixed(new Rectangle(50, 1)).at(0, -0.5)).setRestitution(0);
        Body lower = engine.add(new Body(new Rectangle(1, 1)).at(0, 0.5));
        Body upper = engine.add(new Body(new Rectangle(1, 1)).at(0, 1.5));
        lower.setRestitution(0);
        run(engine, 5);
        long before = Scenes.hash(engine);
        lower.setMass(mass);
        assertThatIllegalStateException().isThrownBy(engine::step).withMessageContaining("a mass too small");
        assertThat(Scenes.hash(engine)).isEqualTo(before);
        lower.setMass(1);
        run(engine, 200);
        assertThat(upper.getY()).isCloseTo(1.5, within(1e-3));
    }

    /** A fixed body got a velocity that is no number where what lay on it was given one of 10¹⁰⁰. */
    @Test
    void nothingIsLeftOfItInWhatIsFixed() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(STEP);
        engine.setTimeStepping(4);
        Body floor = engine.add(Body.fixed(new Rectangle(50, 1)).at(0, -0.5));
        for (int k = 0; k < 4; k++) {
            Body body = engine.add(new Body(k % 2 == 0 ? new Rectangle(1, 1) : new Circle(0.5)).at(1.5 * k, k == 3 ? 1.5 : 0.5).moving(1, 0, 0.1));
            body.setRestitution(0.3);
            body.setFriction(0.5);
        }
        run(engine, 20);
        long before = Scenes.hash(engine);
        engine.bodies().get(2).setVelocity(1e100, -1e100);
        assertThatIllegalStateException().isThrownBy(engine::step);
        assertThat(floor.getVelocityX() + floor.getVelocityY() + floor.getAngularVelocity()).isZero();
        engine.bodies().get(2).setVelocity(1, 0);
        assertThat(Scenes.hash(engine)).isEqualTo(before);
    }

    /** A force that has become no number is refused as such; its bodies are where the step began. */
    @Test
    void theCauseIsNamed() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1e100);
        engine.setTimeStepping(4);
        Body body = engine.add(new Body(new Circle(1)).moving(1, 0));
        engine.add(new Cube());
        assertThatIllegalStateException()
                .isThrownBy(engine::step)
                .withMessageContaining("thrown beyond all numbers")
                .withCauseInstanceOf(IllegalArgumentException.class)
                .withStackTraceContaining("it must be finite");
        assertThat(List.of(body.getX(), body.getVelocityX())).containsExactly(0.0, 1.0);
    }

    /** A force that is the cube of a place. */
    private static final class Cube implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, body.getX() * body.getX() * body.getX(), 0);
        }
    }
}
