// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.function.BiConsumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;

/** What listeners remove, and add again, is taken alike by events and by time stepping; and generators name no null. */
class RemovedWithinTest {
    private static final double STEP = 1.0 / 60;

    /** Edits once, before the first collision or after it. */
    private static final class Editor implements CollisionListener {
        private static final long serialVersionUID = 1L;
        private final boolean isBefore;
        private final transient Runnable edit;
        private boolean isDone;

        Editor(boolean isBefore, Runnable edit) {
            this.isBefore = isBefore;
            this.edit = edit;
        }

        @Override
        public Decision colliding(Contact contact) {
            edit(isBefore);
            return Decision.IGNORE;
        }

        @Override
        public void collided(Contact contact) {
            edit(!isBefore);
        }

        private void edit(boolean isNow) {
            if (isNow && !isDone) {
                isDone = true;
                edit.run();
            }
        }
    }

    /** A disc comes to one that stands and is tied to a third; the listener does something to that in the middle of a step. */
    private static PhysicsEngine run(boolean isStepped, BiConsumer<PhysicsEngine, Body> edit) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(STEP);
        if (isStepped) {
            engine.setTimeStepping(4);
        }
        engine.add(new Body(new Circle(1)).moving(3, 0));
        Body struck = engine.add(new Body(new Circle(1)).at(3, 0));
        Body third = engine.add(new Body(new Circle(1)).at(3, 2.5));
        engine.add(new PinJoint(struck, third, 3, 1.25));
        engine.addListener(new Editor(true, () -> edit.accept(engine, struck)));
        for (int k = 0; k < 60; k++) {
            engine.step();
        }
        return engine;
    }

    /** What is removed is gone at once, however bodies are moved; it is back at once, too. */
    @ParameterizedTest
    @CsvSource({"false, false", "true, false", "false, true", "true, true"})
    void whatIsRemovedIsGoneAtOnce(boolean isStepped, boolean comesBack) {
        Body[] gone = new Body[1];
        PhysicsEngine engine = run(isStepped, (e, struck) -> {
            gone[0] = struck;
            assertThat(e.contains(struck)).isTrue();
            e.remove(struck);
            assertThat(e.contains(struck)).isFalse();
            assertThat(e.bodies()).hasSize(2).doesNotContain(struck);
            if (comesBack) {
                e.add(struck);
                assertThat(e.contains(struck)).isTrue();
                assertThat(e.bodies()).hasSize(3).containsOnlyOnce(struck);
            }
        });
        assertThat(engine.contains(gone[0])).isEqualTo(comesBack);
        assertThat(engine.bodies()).hasSize(comesBack ? 3 : 2);
    }

    /** By events, bodies are part of the collision until it is over, and may be removed while they are: another listener may be told of them. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whatIsNotThereCannotBeRemoved(boolean isStepped) {
        PhysicsEngine engine = run(isStepped, (e, struck) -> {
            e.remove(struck);
            if (!isStepped) {
                e.remove(struck);
            } else {
                assertThatIllegalStateException().isThrownBy(() -> e.remove(struck)).withMessageContaining("body is " + struck);
            }
            assertThatIllegalStateException().isThrownBy(() -> e.add(new PinJoint(struck, 3, 0))).withMessageContaining("body is " + struck);
        });
        assertThat(engine.bodies()).hasSize(2);
        assertThat(engine.allConstraints()).isEmpty();
        assertThat(engine.bodies().get(0).getX()).isCloseTo(3, within(1e-12));
    }

    @ParameterizedTest
    @CsvSource({"false, false", "true, false", "false, true", "true, true"})
    void whatIsAddedAgainComesBackWithoutItsJoints(boolean isStepped, boolean isElsewhere) {
        Body[] back = new Body[1];
        PhysicsEngine engine = run(isStepped, (e, struck) -> {
            back[0] = struck;
            e.remove(struck);
            if (isElsewhere) {
                struck.setPosition(20, 0);
                struck.setVelocity(0, 6);
            }
            assertThat(e.add(struck)).isSameAs(struck);
            assertThatIllegalStateException().isThrownBy(() -> e.add(struck)).withMessageContaining("in this engine already");
        });
        assertThat(engine.contains(back[0])).isTrue();
        assertThat(engine.bodies()).hasSize(3).containsOnlyOnce(back[0]);
        assertThat(engine.allConstraints()).isEmpty();
        if (isElsewhere) {
            assertThat(back[0].getX()).isEqualTo(20);
            assertThat(back[0].getY()).isCloseTo(6 * (1 - 1.0 / 3), within(6 * STEP)); // it has gone on since the instant, or the step, of the collision
        }
        engine.remove(back[0]);
        assertThat(engine.bodies()).hasSize(2);
    }

    /** By events, all of its constraints are cut when it leaves, and it is back only then: one that was added before would be gone without a word. */
    @Test
    void aJointOfWhatComesBackIsRefusedUntilThen() {
        PhysicsEngine engine = run(false, (e, struck) -> {
            e.remove(struck);
            e.add(struck);
            assertThatIllegalStateException().isThrownBy(() -> e.add(new PinJoint(struck, 3, 0))).withMessageContaining("comes back");
        });
        Body back = engine.bodies().get(engine.bodies().size() - 1);
        engine.add(new PinJoint(back, back.getX(), back.getY()));
        engine.step();
        assertThat(engine.allConstraints()).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whatComesBackMayBeRemovedAgain(boolean isStepped) {
        Body[] gone = new Body[1];
        PhysicsEngine engine = run(isStepped, (e, struck) -> {
            gone[0] = struck;
            e.remove(struck);
            e.add(struck);
            e.remove(struck);
        });
        assertThat(engine.contains(gone[0])).isFalse();
        assertThat(engine.bodies()).hasSize(2);
        engine.add(gone[0]);
        engine.step();
        assertThat(engine.bodies()).hasSize(3);
    }

    private static ForceGenerator naming(List<Body> bodies) {
        return new ForceGenerator() {
            private static final long serialVersionUID = 1L;

            @Override
            public void addForce(Body body, double time, Forces forces) {
                forces.add(body, 1, 0);
            }

            @Override
            public List<Body> getBodies() {
                return bodies;
            }
        };
    }

    @Test
    void aGeneratorNamesNoNull() {
        PhysicsEngine engine = new PhysicsEngine();
        Body body = engine.add(new Body(new Circle(1)));
        assertThatNullPointerException().isThrownBy(() -> engine.add(naming(Arrays.asList(body, null)))).withMessage("generator.getBodies()[1]");
        assertThat(engine.allForceGenerators()).isEmpty();
        engine.step();
        assertThat(body.getX()).isZero();
    }
}
