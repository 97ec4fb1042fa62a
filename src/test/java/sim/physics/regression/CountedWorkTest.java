// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What costs is counted, and ends the step where it is more than the step may cost: no step takes many times the limit. */
class CountedWorkTest {
    /** Looks of one search at most: one that is on its way is not cut short. */
    private static final int SEARCH = 1 << 20;

    private static final int LIMIT = 100_000;

    private static long workOfStep(PhysicsEngine engine) {
        long before = engine.getWork();
        engine.step();
        return engine.getWork() - before;
    }

    /** A square among others around it, on all of which a force of an author acts, so that searches cannot know that they move evenly. */
    private static PhysicsEngine ring(int others) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.setWorkLimit(LIMIT);
        engine.add(new EditedWorld.Pull(0, 0.1, true));
        engine.add(new Body(new Rectangle(1, 1)));
        for (int k = 0; k < others; k++) {
            double angle = 2 * Math.PI * k / others;
            engine.add(new Body(new Rectangle(0.05, 0.05)).at(0.75 * Math.cos(angle), 0.75 * Math.sin(angle), angle).moving(0, 0, 0.1));
        }
        return engine;
    }

    /** Three million turns a step: each of 40 pairs took a million looks before that was given up. */
    @Test
    void aSpinThatNoSearchCanFollowEndsThem() {
        PhysicsEngine engine = ring(40);
        engine.bodies().get(0).setAngularVelocity(1e9);
        assertThat(workOfStep(engine)).isLessThan(SEARCH);
    }

    /** A listener lets the square spin as a ball strikes it: its pairs are looked at one by one, until that has cost enough. */
    @Test
    void looksAtOneBodyEndTheStepBetweenTwoPairs() {
        PhysicsEngine engine = ring(40);
        Body square = engine.bodies().get(0);
        engine.add(new Body(new Circle(0.05)).at(0.1, 0.56).moving(0, -10));
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public void collided(Contact contact) {
                square.setAngularVelocity(5e6);
            }
        });
        assertThat(workOfStep(engine)).isLessThan(LIMIT + 2L * SEARCH);
        assertThat(engine.getImpacts()).isPositive();
        assertThat(engine.getRelievedSteps()).isOne();
    }

    /** Counts how often it is asked, which is when somebody finds accelerations. */
    private static final class Asked implements ForceGenerator {
        private static final long serialVersionUID = 1L;
        long times;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            times++;
            forces.add(body, 0, -10 * body.getMass());
        }
    }

    /** Light and heavy links on a floor need thousands of parts of a step, which took seconds that were not counted. */
    @Test
    void accelerationsOfATreeCount() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        Asked asked = new Asked();
        engine.add(asked);
        Body floor = engine.add(Body.fixed(new Rectangle(100, 1)).at(0, -2.5));
        floor.setRestitution(0.5);
        SplittableRandom random = new SplittableRandom(1);
        Body last = null;
        int links = 24;
        for (int k = 0; k < links; k++) {
            Body link = engine.add(new Body(new Rectangle(0.18, 0.02)).at(0.2 * k + 0.1, 0));
            link.setMass(StrictMath.pow(10, -4 * random.nextDouble()));
            link.setRestitution(0.5);
            engine.add(last == null ? new PinJoint(link, 0, 0) : new PinJoint(last, link, 0.2 * k, 0));
            last = link;
        }
        long most = 0;
        for (int k = 0; k < 75; k++) {
            asked.times = 0;
            long work = workOfStep(engine);
            long unusual = asked.times - 8000L * links; // of what a step begins with, the usual does not count
            most = Math.max(most, asked.times);
            assertThat(unusual).as("step %d", k).isLessThan(8 * work);
        }
        assertThat(most).isGreaterThan(8000L * links);
    }

    /** A machine whose step begins with millions of units, in thousands of parts: none of that counted, whatever other groups took. */
    @Test
    void whatAStepBeginsWithCountsWhereItIsMoreThanUsual() {
        RandomMachine machine = new RandomMachine(347, true);
        long most = 0;
        for (int k = 0; k < 226; k++) {
            long before = machine.engine.getWork();
            long relieved = machine.engine.getRelievedSteps();
            machine.step();
            if (k == 217 || k == 225) {
                assertThat(machine.engine.getWork() - before).as("step %d", k).isGreaterThan(1_000_000);
            }
            most = Math.max(most, machine.engine.getRelievedSteps() - relieved);
        }
        assertThat(most).isOne();
    }

    /** Each impact of tied bodies that lie on one another asks for forces of all of them; a thousand did before that was counted as it is done. */
    @Test
    void forcesOfTiedBodiesInAHeapCount() {
        EditedWorld world = new EditedWorld(1605, true, 1, 1, 1);
        SplittableRandom random = new SplittableRandom(1605 * 31 + 7);
        int rate = 1 + random.nextInt(6);
        for (int k = 0; k <= 47; k++) {
            int edits = random.nextInt(rate) == 0 ? 1 + random.nextInt(3) : 0;
            for (int m = 0; m < edits; m++) {
                world.edit(random.nextLong());
            }
            if (random.nextInt(12) == 0) {
                random.nextBoolean();
            }
            long impacts = world.engine.getImpacts();
            long before = world.engine.getWork();
            world.step();
            long work = world.engine.getWork() - before;
            if (k == 47) {
                assertThat(work).isGreaterThan(1000 * (world.engine.getImpacts() - impacts));
                assertThat(world.engine.getRelievedSteps()).isPositive();
            }
        }
    }
}
