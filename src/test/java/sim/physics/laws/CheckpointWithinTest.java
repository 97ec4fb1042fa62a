// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;

/** An engine that a listener saves goes on as the original does, or is not saved: there is no copy that stands in the middle of a step. */
class CheckpointWithinTest {
    /** Saves the engine, and goes on saving the first of its copies. */
    private static final class Saves implements CollisionListener {
        private static final long serialVersionUID = 1L;

        private final PhysicsEngine engine;
        private final boolean before;
        private transient PhysicsEngine copy;
        private transient int refused;

        Saves(PhysicsEngine engine, boolean before) {
            this.engine = engine;
            this.before = before;
        }

        @Override
        public Decision colliding(Contact contact) {
            save(before);
            return Decision.BOUNCE;
        }

        @Override
        public void collided(Contact contact) {
            save(!before);
        }

        private void save(boolean now) {
            if (now && copy == null) {
                try {
                    copy = Checkpoint.copy(engine);
                } catch (IllegalStateException e) {
                    assertThat(e).hasMessageContaining("within a step");
                    refused++;
                }
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"0, false", "0, true", "4, false", "4, true"})
    void aListenerSavesAWholeStepOrNone(int substeps, boolean before) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStepping(substeps);
        engine.setTimeStep(0.5);
        engine.add(new Body(new Circle(0.5)).moving(2, 0));
        engine.add(new Body(new Circle(0.5)).at(2.03, 0));
        Saves saves = new Saves(engine, before);
        engine.addListener(saves);
        for (int k = 0; k < 4; k++) {
            engine.step();
        }
        assertThat(saves.refused).isEqualTo(substeps == 0 ? 1 : 0);
        PhysicsEngine copy = substeps == 0 ? Checkpoint.copy(engine) : saves.copy;
        while (copy.getSteps() < 6) {
            copy.step();
        }
        engine.step();
        engine.step();
        Checkpoint.assertSameBodies(copy, engine);
    }
}
