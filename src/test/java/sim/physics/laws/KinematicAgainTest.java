// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.KinematicBody;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Kinematic bodies of an engine that is saved and read, or makes a step again, go on as if it had not been: to the bit. */
class KinematicAgainTest {
    /** The copy took bodies for as heavy as before: a crate of 10⁸ that a platform ran into threw it off its course by a ten-thousandth of its speed. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aMassThatWasSetBeforeACheckpointCounts(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 64);
        engine.setTimeStepping(substeps);
        engine.add(new KinematicBody(new Rectangle(1, 1))).moving(1, 0, 0);
        Body crate = engine.add(new Body(new Rectangle(1, 1)).at(1.17, 0.1));
        for (int k = 0; k < 10; k++) {
            engine.step();
        }
        crate.setMass(1e8);
        PhysicsEngine copy = Checkpoint.copy(engine);
        for (int k = 0; k < 3; k++) {
            engine.step();
            copy.step();
            Checkpoint.assertSameBodies(copy, engine);
        }
        assertThat(crate.getVelocityX()).isGreaterThan(1.99);
    }

    /** Throws now and then when it is asked, once each time. */
    private static final class Faulty implements CollisionListener {
        private static final long serialVersionUID = 1L;
        private final boolean isFaulty;
        private int asked;

        Faulty(boolean isFaulty) {
            this.isFaulty = isFaulty;
        }

        @Override
        public Decision colliding(Contact contact) {
            asked++;
            if (isFaulty && asked % 2 == 0) {
                throw new IllegalArgumentException("an author's mistake");
            }
            return Decision.BOUNCE;
        }
    }

    private static void step(PhysicsEngine engine) {
        try {
            engine.step();
        } catch (IllegalArgumentException e) {
            step(engine);
        }
    }

    /** A platform that has been struck goes back on its course; it forgot that when a step was made again in which nothing had moved yet. */
    @Test
    void aStepThatIsMadeAgainIsTheSame() {
        PhysicsEngine[] engines = {new PhysicsEngine(), new PhysicsEngine()};
        KinematicBody[] platforms = new KinematicBody[2];
        for (int n = 0; n < 2; n++) {
            engines[n].setTimeStep(1.0 / 64);
            engines[n].setTimeStepping(4);
            engines[n].add(new Gravity(0, -10));
            engines[n].addListener(new Faulty(n == 1));
            platforms[n] = engines[n].add(new KinematicBody(new Rectangle(4, 0.2)));
            for (int k = 0; k < 3; k++) {
                engines[n].add(new Body(k == 1 ? new Rectangle(0.4, 0.4) : new Circle(0.3)).at(k - 1, 1 + 0.3 * k));
            }
        }
        for (int k = 0; k < 300; k++) {
            for (int n = 0; n < 2; n++) {
                platforms[n].setTargetVelocity(StrictMath.cos(0.1 * k), 0.2 * StrictMath.sin(0.3 * k), 0);
                step(engines[n]);
            }
            Checkpoint.assertSameBodies(engines[1], engines[0]);
        }
    }
}
