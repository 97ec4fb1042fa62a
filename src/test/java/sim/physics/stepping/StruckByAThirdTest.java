// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Rectangle;

/** Time stepping: pairs that meet only because a third body strikes one of them are solved also where somebody listens. */
class StruckByAThirdTest {
    private static final double STEP = 1.0 / 60;

    private static class Ear implements CollisionListener {
        private static final long serialVersionUID = 1L;
        int asked;
        int told;

        @Override
        public Decision colliding(Contact contact) {
            asked++;
            return Decision.BOUNCE;
        }

        @Override
        public void collided(Contact contact) {
            told++;
        }
    }

    private static Body put(PhysicsEngine engine, double width, double height, double x, double y, double restitution) {
        Body body = new Body(new Rectangle(width, height)).at(x, y);
        body.setRestitution(restitution);
        body.setFriction(0.5);
        return engine.add(body);
    }

    private static PhysicsEngine overGround() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(new Gravity(0, -9.81));
        engine.add(Body.fixed(new Rectangle(10, 2)).at(0, -1)).setFriction(0.5);
        return engine;
    }

    private static double deepest(PhysicsEngine engine) {
        return engine.overlaps().stream().mapToDouble(Overlap::depth).max().orElse(0);
    }

    /** Boxes one on the other, with gaps so small that none of them bears another, come down at 10 m/s: they went into one another by 0.1. */
    @ParameterizedTest
    @CsvSource({"0, 1e-5", "0, 1e-3", "0.3, 1e-5", "0.3, 1e-3"})
    void whatFallsTogetherIsStoppedTogether(double restitution, double gap) {
        List<List<Body>> both = new ArrayList<>();
        Ear ear = new Ear();
        for (int run = 0; run < 2; run++) {
            PhysicsEngine engine = overGround();
            List<Body> bodies = new ArrayList<>();
            for (int k = 0; k < 4; k++) {
                bodies.add(put(engine, 1, 0.4, 0, 5 + k * (0.4 + gap), restitution));
            }
            if (run == 1) {
                engine.addListener(ear);
            }
            for (int k = 0; k < 120; k++) {
                engine.step();
                if (restitution == 0) { // several that bounce at once are some hundredths deep, with a listener or without
                    assertThat(deepest(engine)).as("step %d, run %d", k, run).isLessThan(5e-3);
                }
            }
            both.add(bodies);
        }
        for (int k = 0; k < 4; k++) {
            assertThat(both.get(1).get(k).getY()).as("with a listener as without").isEqualTo(both.get(0).get(k).getY());
        }
        assertThat(ear.told).isGreaterThanOrEqualTo(4);
    }

    /**
     * Boxes put on one another at rest, with gaps of rounding or such as no step sees: nothing strikes them but what gravity gives in a step. With a listener
     * those above the first gap fell for a step, by g h² into one another.
     */
    @ParameterizedTest
    @CsvSource({"0.1, 0", "0.3, 0", "0.7, 0", "1, 0", "0.1, 1e-6", "1, 1e-6", "0.3, 1e-4", "1, 1e-4"})
    void whatIsPutOnOneAnotherIsBorneAtOnce(double size, double gap) {
        List<List<Body>> both = new ArrayList<>();
        Ear ear = new Ear();
        for (int run = 0; run < 2; run++) {
            PhysicsEngine engine = overGround();
            List<Body> bodies = new ArrayList<>();
            for (int k = 0; k < 6; k++) {
                bodies.add(put(engine, size, size, 0, size / 2 + k * (size + gap), 0));
            }
            if (run == 1) {
                engine.addListener(ear);
            }
            for (int k = 0; k < 40; k++) {
                engine.step();
                for (Body body : bodies) {
                    assertThat(body.getVelocityY()).as("step %d, run %d", k, run).isBetween(-0.3 * 9.81 * STEP, 0.3 * 9.81 * STEP);
                }
            }
            both.add(bodies);
        }
        for (int k = 0; k < 6; k++) {
            assertThat(both.get(1).get(k).getY()).as("with a listener as without").isEqualTo(both.get(0).get(k).getY());
        }
        assertThat(ear.told).isEqualTo(6);
    }

    /** A row of boxes that nearly touch, struck at its end: the last one must go on, and none through another. */
    @ParameterizedTest
    @CsvSource({"0, 1e-4", "0.5, 1e-4", "0.5, 2e-2"})
    void aRowThatIsStruck(double restitution, double gap) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(STEP);
        engine.setTimeStepping(4);
        Ear ear = new Ear();
        engine.addListener(ear);
        List<Body> row = new ArrayList<>();
        for (int k = 0; k < 5; k++) {
            row.add(put(engine, 0.2, 1, k * (0.2 + gap), 0, restitution));
        }
        Body hammer = put(engine, 1, 1, -1, 0, restitution);
        hammer.setVelocity(20, 0);
        for (int k = 0; k < 30; k++) {
            engine.step();
            assertThat(deepest(engine)).as("step %d", k).isLessThan(5e-3);
        }
        assertThat(row.get(4).getVelocityX()).isGreaterThan(5);
    }

    /** Throws now and then when it is asked. */
    private static final class Faulty extends Ear {
        private static final long serialVersionUID = 1L;
        private int thrown;

        @Override
        public Decision colliding(Contact contact) {
            if (asked % 3 == 2 && thrown < asked) {
                thrown = asked;
                throw new IllegalArgumentException("an author's mistake");
            }
            return super.colliding(contact);
        }
    }

    /** A step that a listener has stopped by an exception while it was asked is made again as it would have been; the last ones were not reached. */
    @Test
    void aStepThatIsMadeAgainIsTheSame() {
        List<Double> places = new ArrayList<>();
        for (Ear ear : new Ear[] {new Ear(), new Faulty()}) {
            PhysicsEngine engine = Stepped.engine(STEP, 4);
            engine.addListener(ear);
            for (int k = 0; k < 7; k++) {
                put(engine, 0.2, 1, k * 0.22, 0, 0.5);
            }
            put(engine, 1, 1, -1, 0, 0.5).setVelocity(20, 0);
            for (int k = 0; k < 30; k++) {
                step(engine);
            }
            engine.bodies().forEach(body -> places.add(body.getX()));
            assertThat(ear.told).isGreaterThanOrEqualTo(7);
        }
        assertThat(places.subList(8, 16)).isEqualTo(places.subList(0, 8));
    }

    private static void step(PhysicsEngine engine) {
        try {
            engine.step();
        } catch (IllegalArgumentException e) {
            step(engine);
        }
    }

    /** Nobody is asked about what stays apart. */
    @ParameterizedTest
    @CsvSource("1e-3")
    void whatDoesNotMeetIsNotAskedAbout(double gap) {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(new Gravity(0, -9.81));
        Ear ear = new Ear();
        engine.addListener(ear);
        put(engine, 1, 1, 0, 5, 0);
        put(engine, 1, 1, 0, 6 + gap, 0);
        for (int k = 0; k < 60; k++) {
            engine.step();
        }
        assertThat(ear.asked).isZero();
    }
}
