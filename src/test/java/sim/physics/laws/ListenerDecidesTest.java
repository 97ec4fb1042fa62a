// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.BiConsumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * What a listener sets on two bodies when it is asked about their collision counts in that collision, with one point or two, by events and by
 * time stepping; and what it lets pass, passes, whatever is set meanwhile.
 */
class ListenerDecidesTest {
    private static final double H = 0.01;

    /** Sets something whenever it is asked, and always answers the same. */
    private static final class Sets implements CollisionListener {
        private static final long serialVersionUID = 1L;

        private final transient Runnable deed;
        private final Decision decision;
        private int asked;
        private int told;

        Sets(Decision decision, Runnable deed) {
            this.decision = decision;
            this.deed = deed;
        }

        @Override
        public Decision colliding(Contact contact) {
            asked++;
            assertThat(asked).as("questions").isLessThan(100);
            deed.run();
            return decision;
        }

        @Override
        public void collided(Contact contact) {
            told++;
        }
    }

    private final PhysicsEngine engine = new PhysicsEngine();
    private Body one;
    private Body other;
    private Sets sets;

    /** A body of mass 1 hits another one at the speed 2 at the time 1.015; what is so after 1.5. */
    private void collide(int substeps, boolean isFlat, CollisionListener.Decision decision, BiConsumer<Body, Body> deed) {
        engine.setTimeStep(H);
        engine.setTimeStepping(substeps);
        one = engine.add(new Body(isFlat ? new Rectangle(1, 1) : new Circle(0.5)).moving(2, 0));
        other = engine.add(new Body(isFlat ? new Rectangle(1, 1) : new Circle(0.5)).at(3.03, 0));
        one.setMass(1);
        other.setMass(1);
        sets = new Sets(decision, () -> deed.accept(one, other));
        engine.addListener(sets);
        for (int k = 0; k < 150; k++) {
            engine.step();
        }
    }

    private void assertVelocities(double ofOne, double ofOther) {
        double error = engine.getTimeStepping() == 0 ? 1e-12 : 1e-5; // there a body with two points is turned a little, and back
        assertThat(one.getVelocityX()).isCloseTo(ofOne, within(error));
        assertThat(other.getVelocityX()).isCloseTo(ofOther, within(error));
    }

    @ParameterizedTest
    @CsvSource({"0, false", "0, true", "4, false", "4, true"})
    void theVelocityThatItSetsIsThatOfTheImpact(int substeps, boolean isFlat) {
        collide(substeps, isFlat, CollisionListener.Decision.BOUNCE, (a, b) -> a.setVelocity(5, 0));
        assertVelocities(0, 5);
        assertThat(sets.told).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource({"0, false", "0, true", "4, false", "4, true"})
    void whatItTurnsAwayDoesNotCollide(int substeps, boolean isFlat) {
        collide(substeps, isFlat, CollisionListener.Decision.BOUNCE, (a, b) -> a.setVelocity(-1, 1));
        assertVelocities(-1, 0);
        assertThat(one.getVelocityY()).isEqualTo(1);
        assertThat(sets.told).isZero();
    }

    @ParameterizedTest
    @CsvSource({"0, false", "0, true", "4, false", "4, true"})
    void massAndRestitutionCount(int substeps, boolean isFlat) {
        collide(substeps, isFlat, CollisionListener.Decision.BOUNCE, (a, b) -> {
            b.setMass(3);
            b.setRestitution(0.5);
        });
        double common = 2.0 / 4;
        assertVelocities(common - 0.5 * (2 - common), common + 0.5 * common);
    }

    @ParameterizedTest
    @CsvSource({"0, false", "0, true", "4, false", "4, true"})
    void whatItGivesAnotherShapeCollides(int substeps, boolean isFlat) {
        collide(substeps, isFlat, CollisionListener.Decision.BOUNCE, (a, b) -> b.setShape(isFlat ? new Rectangle(1, 1) : new Circle(0.5)));
        assertVelocities(0, 2);
        assertThat(sets.told).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource({"0, BOUNCE, 0", "4, BOUNCE, 0", "0, STICK, 1", "4, STICK, 1", "0, IGNORE, 2", "4, IGNORE, 2"})
    void whatIsAnsweredCountsWhateverShapeIsGiven(int substeps, CollisionListener.Decision decision, double speed) {
        collide(substeps, false, decision, (a, b) -> a.setShape(new Circle(0.5)));
        assertVelocities(speed, 2 - speed);
    }

    @ParameterizedTest
    @CsvSource({"0, false", "0, true", "4, false", "4, true"})
    void whatItPutsElsewhereIsThere(int substeps, boolean isFlat) {
        collide(substeps, isFlat, CollisionListener.Decision.BOUNCE, (a, b) -> a.setPosition(0, 5));
        assertVelocities(2, 0);
        assertThat(one.getX()).isCloseTo(2 * (1.5 - 1.015), within(substeps == 0 ? 1e-12 : 2 * H));
        assertThat(one.getY()).isEqualTo(5);
    }

    @ParameterizedTest
    @CsvSource({"0, false", "0, true", "4, false", "4, true"})
    void aFilterThatItSetsHolds(int substeps, boolean isFlat) {
        collide(substeps, isFlat, CollisionListener.Decision.BOUNCE, (a, b) -> b.setCollisionGroup(0, 0));
        assertVelocities(2, 0);
    }

    @ParameterizedTest
    @CsvSource({"0, false", "0, true", "4, false", "4, true"})
    void whatItLetsPassAndSetsPasses(int substeps, boolean isFlat) {
        collide(substeps, isFlat, CollisionListener.Decision.IGNORE, (a, b) -> {
            a.setVelocity(3, 0);
            b.setMass(2);
        });
        assertVelocities(3, 0);
        assertThat(sets.asked).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aBarrierCountsOnceWhatIsPushedSetAndPutWhileItPasses(int substeps) {
        engine.setTimeStep(H);
        engine.setTimeStepping(substeps);
        Body barrier = engine.add(Body.fixed(new Rectangle(1, 10)).at(3, 0));
        Body robot = engine.add(new Body(new Circle(0.5)).moving(2, 0));
        sets = new Sets(CollisionListener.Decision.IGNORE, () -> { });
        engine.addListener(sets);
        for (int k = 0; k < 800; k++) {
            robot.addForce(k % 2 == 0 ? 0.1 : -0.1, 0);
            robot.setFriction(1e-3 * k);
            robot.setPosition(robot.getX(), 1e-4 * k);
            barrier.setRestitution(1e-3 * k);
            if (k == 400) {
                robot.setVelocity(-2, 0); // back again
            }
            engine.step();
        }
        assertThat(sets.asked).isEqualTo(2);
        assertThat(robot.getX()).isCloseTo(0, within(0.1));
    }

    @Test
    void whatIsPutBesideWhatItPassesIsAskedAgain() {
        engine.setTimeStep(H);
        engine.add(Body.fixed(new Rectangle(1, 10)).at(3, 0));
        Body ball = engine.add(new Body(new Circle(0.5)).moving(2, 0));
        sets = new Sets(CollisionListener.Decision.IGNORE, () -> { });
        engine.addListener(sets);
        while (ball.getX() < 2.5) {
            engine.step();
        }
        ball.setPosition(1.99, 0);
        for (int k = 0; k < 10; k++) {
            engine.step();
        }
        assertThat(sets.asked).isEqualTo(2);
    }

    @Test
    void whatIsTakenAwayFromAnImpactOfThreeMeetsNobody() {
        engine.setTimeStep(H);
        one = engine.add(new Body(new Circle(0.5)).moving(2, 0));
        Body low = engine.add(new Body(new Circle(0.5)).at(3, -0.5));
        Body high = engine.add(new Body(new Circle(0.5)).at(3, 0.5));
        sets = new Sets(CollisionListener.Decision.BOUNCE, () -> one.setPosition(-9, 0));
        engine.addListener(sets);
        for (int k = 0; k < 150; k++) {
            engine.step();
        }
        assertThat(sets.asked).as("by the first pair").isEqualTo(1);
        assertThat(one.getX()).isCloseTo(-9 + 2 * 1.5 - (3 - StrictMath.sqrt(0.75)), within(1e-12));
        for (Body still : new Body[] {low, high}) {
            assertThat(still.getVelocityX()).isZero();
            assertThat(still.getX()).isEqualTo(3);
        }
    }
}
