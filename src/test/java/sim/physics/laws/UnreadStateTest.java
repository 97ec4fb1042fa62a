// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Where nobody reads the state vectors after a step they are not written; nobody who reads them later can tell. */
class UnreadStateTest {
    private static final int BODIES = 25;

    /** A gas of which all bodies are read after each step, or none. */
    private static final class Gas {
        private PhysicsEngine engine = new PhysicsEngine();
        private List<Body> bodies = new ArrayList<>();
        private final boolean isRead;

        private Gas(boolean isRead) {
            this(isRead, false);
        }

        /** The same, or one that falls, loses its energy, and lies down. */
        private Gas(boolean isRead, boolean falls) {
            this.isRead = isRead;
            engine.setTimeStep(falls ? 1.0 / 32 : 0.25);
            if (falls) {
                engine.add(new Gravity(0, -5));
            }
            for (int side = -1; side <= 1; side += 2) {
                engine.add(Body.fixed(new Rectangle(14, 1)).at(0, 6 * side));
                engine.add(Body.fixed(new Rectangle(1, 14)).at(6 * side, 0));
            }
            SplittableRandom random = new SplittableRandom(11);
            for (int k = 0; k < BODIES; k++) {
                Body body = new Body(k % 2 == 0 ? new Circle(0.5) : new Rectangle(1, 0.5));
                body.at(2 * (k % 5) - 4, 2 * (k / 5) - 4, random.nextDouble(-1, 1));
                body.moving(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
                bodies.add(engine.add(body));
            }
            if (falls) {
                engine.bodies().forEach(body -> body.setRestitution(0.5));
            }
        }

        private void run(int steps) {
            for (int k = 0; k < steps; k++) {
                engine.step();
                if (isRead) {
                    values();
                }
            }
        }

        private List<Double> values() {
            List<Double> all = new ArrayList<>();
            for (Body body : bodies) {
                all.add(body.getX());
                all.add(body.getY());
                all.add(body.getAngle());
                all.add(body.getVelocityX());
                all.add(body.getVelocityY());
                all.add(body.getAngularVelocity());
            }
            return all;
        }
    }

    private static void assertSame(Gas read, Gas unread) {
        assertThat(unread.values()).isEqualTo(read.values());
        assertThat(unread.engine.getImpacts()).isEqualTo(read.engine.getImpacts()).isGreaterThan(100);
    }

    @Test
    void theStateIsThatOfAGasThatIsReadAfterEachStep() {
        Gas read = new Gas(true);
        Gas unread = new Gas(false);
        for (int k = 0; k < 5; k++) {
            read.run(60);
            unread.run(60);
            assertSame(read, unread);
        }
    }

    @Test
    void theStateIsThatOfAHeapThatIsReadAfterEachStep() {
        Gas read = new Gas(true, true);
        Gas unread = new Gas(false, true);
        for (int k = 0; k < 2; k++) {
            read.run(40);
            unread.run(40);
            assertThat(unread.values()).isEqualTo(read.values());
            for (Gas gas : List.of(read, unread)) {
                gas.run(13);
                gas.engine.remove(gas.bodies.remove(k));
                gas.run(5);
                gas.bodies.add(gas.engine.add(new Body(new Circle(0.25)).at(3 - 0.7 * k, 4)));
                gas.run(1);
                gas.bodies.get(2).addForce(0.5, 0.25);
                gas.run(1);
                gas.bodies.get(5).setVelocity(1, 1);
                gas.run(7);
                gas.engine.setTimeStepping(k % 2 == 0 ? 2 : 0);
                gas.run(3);
                gas.engine.setTimeStepping(0);
            }
        }
        assertSame(read, unread);
    }

    @Test
    void bodiesComeAndGoAndArePushedAfterStepsThatNobodyRead() {
        Gas[] gases = {new Gas(true), new Gas(false)};
        for (Gas gas : gases) {
            gas.run(83);
            gas.engine.remove(gas.bodies.remove(3));
            gas.run(31);
            Body heavy = gas.bodies.get(4);
            heavy.setMass(3, 2); // writes no vector that lags
            gas.run(17);
            gas.bodies.add(gas.engine.add(Body.fixed(new Circle(0.125)).at(40, 0)));
            gas.run(9);
            gas.engine.setTimeStep(0.125);
            gas.run(23);
            gas.bodies.get(7).addForce(0.5, 0.25); // from here on the paths are not straight
            gas.run(40);
        }
        assertSame(gases[0], gases[1]);
    }

    @Test
    void aListenerReadsWhereOthersWereAtTheEndOfTheLastStep() {
        List<List<Double>> seen = new ArrayList<>();
        for (int k = 0; k < 2; k++) {
            Gas gas = new Gas(k == 0);
            gas.run(40);
            List<Double> of = new ArrayList<>();
            gas.engine.addListener(new CollisionListener() {
                @Override
                public void collided(Contact contact) {
                    of.addAll(gas.values());
                }
            });
            gas.run(40);
            seen.add(of);
        }
        assertThat(seen.get(0)).hasSizeGreaterThan(1000);
        assertThat(seen.get(1)).isEqualTo(seen.get(0));
    }

    @Test
    void aCheckpointOfStepsThatNobodyReadGoesOnAsTheyDo() {
        Gas read = new Gas(true);
        Gas unread = new Gas(false);
        read.run(120);
        unread.run(50);
        unread.engine = Checkpoint.copy(unread.engine);
        unread.bodies = unread.engine.bodies().subList(4, 4 + BODIES);
        unread.run(70);
        assertSame(read, unread);
    }
}
