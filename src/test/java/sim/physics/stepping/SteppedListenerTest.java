// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.ContactListener;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping: what listeners are asked and told, and what they may do. */
class SteppedListenerTest {
    private static final double STEP = 1.0 / 60;

    /** Counts, and decides always the same. */
    private static class Judge implements CollisionListener {
        private static final long serialVersionUID = 1L;
        final Decision decision;
        int asked;
        int told;
        double impulse;

        Judge(Decision decision) {
            this.decision = decision;
        }

        @Override
        public Decision colliding(Contact contact) {
            asked++;
            assertThat(contact.impulse()).isZero();
            return decision;
        }

        @Override
        public void collided(Contact contact) {
            told++;
            impulse += contact.impulse();
        }
    }

    @Test
    void aBodyThatComesToLieIsAskedAboutOnce() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Body body = Stepped.stack(engine, 1)[0];
        body.setPosition(0, 3);
        Judge judge = new Judge(CollisionListener.Decision.BOUNCE);
        engine.addListener(judge);
        Stepped.run(engine, 600);
        assertThat(judge.asked).isEqualTo(1);
        assertThat(judge.told).isEqualTo(1);
        assertThat(judge.impulse).isCloseTo(Math.sqrt(2 * Stepped.G * 2.5), within(0.3));
        assertThat(engine.getImpacts()).isEqualTo(1);
    }

    @Test
    void whatIsIgnoredPassesAndIsAskedAboutAgainWhenItComesBack() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(Body.fixed(new Rectangle(10, 0.5)));
        Body body = engine.add(new Body(new Rectangle(1, 2)).at(0, 3, 0.4).moving(0, -4));
        Judge judge = new Judge(CollisionListener.Decision.IGNORE);
        engine.addListener(judge);
        Stepped.run(engine, 120);
        assertThat(body.getY()).isCloseTo(-5, within(1e-9));
        assertThat(judge.asked).isEqualTo(1);
        assertThat(judge.told).isZero();
        body.setVelocity(0, 4);
        Stepped.run(engine, 120);
        assertThat(body.getY()).isCloseTo(3, within(1e-9));
        assertThat(judge.asked).isEqualTo(2);
    }

    @Test
    void whatSticksDoesNotSlideAndMayBeTakenAway() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(new Gravity(0, -Stepped.G));
        engine.add(Body.fixed(new Rectangle(100, 1)).at(0, -0.5));
        Body body = engine.add(new Body(new Rectangle(2, 0.5)).at(0, 0.4).moving(3, 0)); // elastic and without friction
        engine.addListener(new Judge(CollisionListener.Decision.STICK));
        Stepped.run(engine, 60);
        double x = body.getX();
        Stepped.run(engine, 60);
        assertThat(body.getX()).isCloseTo(x, within(1e-3));
        assertThat(Stepped.fastest(engine)).isLessThan(1e-3);
        body.setVelocity(0, 5);
        Stepped.run(engine, 20);
        assertThat(body.getY()).isGreaterThan(0.9);
    }

    /** Does something to the world in a call, once. */
    private static final class Meddler extends Judge {
        private static final long serialVersionUID = 1L;
        private final PhysicsEngine engine;
        private final boolean before;
        private final int what;
        private int calls;

        Meddler(PhysicsEngine engine, boolean before, int what) {
            super(Decision.BOUNCE);
            this.engine = engine;
            this.before = before;
            this.what = what;
        }

        @Override
        public Decision colliding(Contact contact) {
            meddle(before, contact);
            return super.colliding(contact);
        }

        @Override
        public void collided(Contact contact) {
            meddle(!before, contact);
            super.collided(contact);
        }

        private void meddle(boolean isNow, Contact contact) {
            assertThat(engine.contains(contact.a()) && engine.contains(contact.b())).isTrue();
            if (!isNow || calls++ > 0) {
                return;
            }
            Body body = contact.a().isFixed() ? contact.b() : contact.a();
            switch (what) {
                case 0 -> engine.remove(body);
                case 1 -> body.setPosition(50, 50);
                case 2 -> engine.add(new Body(new Circle(0.2)).at(body.getX(), body.getY()));
                case 3 -> engine.setCollisions(contact.a(), contact.b(), false);
                case 4 -> throw new UnsupportedOperationException("for once");
                default -> engine.removeListener(this);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5})
    void listenersMayChangeTheWorldInEitherCall(int what) {
        for (boolean before : new boolean[] {true, false}) {
            PhysicsEngine engine = Stepped.engine(STEP, 4);
            Body[] stack = Stepped.stack(engine, 4);
            for (Body body : stack) {
                body.setPosition(0, 1.3 * body.getY());
            }
            engine.addListener(new Meddler(engine, before, what));
            Roll roll = new Roll();
            engine.addContactListener(roll);
            int thrown = 0;
            for (int k = 0; k < 300; k++) {
                long steps = engine.getSteps();
                try {
                    engine.step();
                } catch (UnsupportedOperationException e) {
                    thrown++;
                    assertThat(engine.getSteps() - steps).isEqualTo(before ? 0 : 1);
                }
                Checkpoint.bytes(engine);
            }
            assertThat(thrown).isEqualTo(what == 4 ? 1 : 0);
            for (Body body : engine.bodies()) {
                assertThat(what == 3 || body.isFixed() || body.getY() > 0.1).isTrue();
            }
            assertThat(roll.now).hasSize(engine.contacts().size());
        }
    }

    /** Keeps a list of who lies on whom by what it is told. */
    private static final class Roll implements ContactListener {
        private static final long serialVersionUID = 1L;
        final Set<List<Body>> now = new HashSet<>();
        int ended;

        @Override
        public void began(LastingContact contact) {
            assertThat(now.add(List.of(contact.a(), contact.b()))).isTrue();
        }

        @Override
        public void lasts(LastingContact contact) {
            assertThat(now).contains(List.of(contact.a(), contact.b()));
        }

        @Override
        public void ended(Body a, Body b) {
            assertThat(now.remove(List.of(a, b))).isTrue();
            ended++;
        }
    }

    @Test
    void contactsThatLastBeginAndEnd() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Body[] stack = Stepped.stack(engine, 3);
        Roll roll = new Roll();
        engine.addContactListener(roll);
        Stepped.run(engine, 100);
        assertThat(roll.now).hasSize(3);
        engine.remove(stack[2]);
        engine.step();
        assertThat(roll.now).hasSize(2);
        engine.setCollisions(stack[0], stack[1], false);
        Stepped.run(engine, 2);
        assertThat(roll.now).doesNotContain(List.of(stack[0], stack[1]));
        engine.removeContactListener(roll);
        Roll late = new Roll();
        Stepped.run(engine, 100);
        engine.addContactListener(late);
        engine.step();
        assertThat(late.now).hasSize(engine.contacts().size()).isNotEmpty();
        engine.setTimeStepping(0);
        Stepped.run(engine, 50);
        assertThat(late.now).hasSize(engine.contacts().size());
        engine.setTimeStepping(2);
        Stepped.run(engine, 50);
        assertThat(late.now).hasSize(engine.contacts().size());
    }

    /** What is taken out and put in again before the next step begins to lie anew; by events it does. Nothing was told by time stepping. */
    @ParameterizedTest
    @CsvSource({"0, 1, 0", "0, 3, 1", "0, 3, 2", "4, 1, 0", "4, 2, 0", "4, 2, 1", "4, 3, 0", "4, 3, 1", "4, 3, 2"})
    void whatComesAgainAtOnceBeginsToLieAnew(int substeps, int boxes, int which) {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.setTimeStepping(substeps);
        Body[] stack = Stepped.stack(engine, boxes);
        Roll roll = new Roll();
        engine.addContactListener(roll);
        Stepped.run(engine, 100);
        assertThat(roll.now).hasSize(boxes);
        assertThat(roll.ended).isZero();
        engine.remove(stack[which]);
        engine.add(stack[which]);
        Stepped.run(engine, 30);
        assertThat(roll.ended).isEqualTo(which == boxes - 1 ? 1 : 2);
        assertThat(roll.now).hasSize(boxes);
    }

    /** A body that another one removes in the same step is not told of any more. */
    @Test
    void nobodyIsToldOfABodyThatIsGone() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Body[] stack = Stepped.stack(engine, 2);
        stack[1].setPosition(0, 1.5);
        List<Body> gone = new ArrayList<>();
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public void collided(Contact contact) {
                assertThat(gone).doesNotContain(contact.a(), contact.b());
                if (gone.isEmpty()) {
                    gone.add(stack[0]);
                    engine.remove(stack[0]);
                }
            }
        });
        engine.addContactListener(new ContactListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public void began(LastingContact contact) {
                assertThat(gone).doesNotContain(contact.a(), contact.b());
            }
        });
        Stepped.run(engine, 100);
        assertThat(gone).hasSize(1);
    }

    @Test
    void whatNeedsAStepThatIsOverIsRefusedWhileListenersAreAsked() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Stepped.stack(engine, 1);
        int[] asked = {0};
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public Decision colliding(Contact contact) {
                asked[0]++;
                assertThatThrownBy(engine::step).isInstanceOf(IllegalStateException.class);
                assertThatThrownBy(() -> engine.setTimeStepping(0)).isInstanceOf(IllegalStateException.class);
                assertThatThrownBy(() -> engine.setTimeStep(1)).isInstanceOf(IllegalStateException.class);
                assertThatThrownBy(engine::contacts).isInstanceOf(IllegalStateException.class);
                return Decision.BOUNCE;
            }

            @Override
            public void collided(Contact contact) {
                assertThat(engine.contacts()).hasSize(1);
                assertThatThrownBy(engine::step).isInstanceOf(IllegalStateException.class);
            }
        });
        Stepped.run(engine, 10);
        assertThat(asked[0]).isEqualTo(1);
    }

    @Test
    void listenersThatDecideNothingChangeNothingButTheOrderOfTheFirstImpulses() {
        long[] hashes = new long[2];
        for (int k = 0; k < 2; k++) {
            PhysicsEngine engine = Stepped.engine(STEP, 4);
            Stepped.stack(engine, 1)[0].setPosition(0, 2);
            if (k == 1) {
                engine.addListener(new Judge(CollisionListener.Decision.BOUNCE));
            }
            Stepped.run(engine, 200);
            hashes[k] = Scenes.hash(engine);
        }
        assertThat(hashes[0]).isEqualTo(hashes[1]);
    }
}
