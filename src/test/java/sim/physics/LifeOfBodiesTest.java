// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.engine.SimState;
import sim.physics.collision.broad.BruteForce;
import sim.physics.collision.broad.CellGrid;
import sim.physics.collision.broad.SortAndSweep;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.SurfaceFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What an author does to bodies in the course of a run. */
class LifeOfBodiesTest {
    private static void run(PhysicsEngine engine, int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    @Test
    void bodiesComeAndGoInTheMiddleOfARun() {
        PhysicsEngine engine = new PhysicsEngine();
        Body a = engine.add(new Body(new Circle(1)).at(0, 0).moving(1, 0));
        Body wall = engine.add(Body.fixed(new Rectangle(1, 10)).at(10, 0));
        run(engine, 3);
        engine.remove(wall);
        run(engine, 10);
        assertThat(a.getX()).isEqualTo(13);
        assertThat(engine.getImpacts()).isZero();
        Body b = engine.add(new Body(new Circle(1)).at(20, 0));
        run(engine, 10);
        assertThat(a.getVelocityX()).isCloseTo(0, within(1e-15));
        assertThat(b.getVelocityX()).isCloseTo(1, within(1e-15));
        engine.remove(a);
        assertThat(a.getX()).isCloseTo(18, within(1e-14));
        new PhysicsEngine().add(a);
        b.setPosition(-50, 0);
        run(engine, 5);
        assertThat(b.getX()).isCloseTo(-45, within(1e-13));
    }

    /** Its box has stayed behind in the meantime, and it goes back to where that is from the other side. */
    @Test
    void aBodyThatCollidesAgainOnItsWayBackMeetsWhatIsThere() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.1);
        Body stone = engine.add(new Body(new Circle(1)).at(-20, 0));
        Body ghost = engine.add(new Body(new Circle(1)).at(0, 0));
        run(engine, 3);
        ghost.setCollisionGroup(0, 0);
        ghost.setVelocity(-30, 0);
        run(engine, 10);
        ghost.setCollisionGroup(1, -1);
        ghost.setVelocity(2, 0);
        run(engine, 60);
        assertThat(engine.getImpacts()).isEqualTo(1);
        assertThat(stone.getX()).isCloseTo(-20 + 4, within(1e-12));
    }

    /** What was written before a step that fails in an author's force is known in the next one. */
    @Test
    void aVelocityThatWasSetBeforeAStepThatFailedIsMinded() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.1);
        Body driven = engine.add(new Body(new Circle(0.5)).at(0, 50));
        boolean[] fails = {false};
        engine.add(new ForceGenerator() {
            @Override
            public boolean actsOn(Body body) {
                return body == driven;
            }

            @Override
            public void addForce(Body body, double time, Forces forces) {
                if (fails[0]) {
                    throw new IllegalStateException("no force");
                }
            }
        });
        Body ram = engine.add(new Body(new Rectangle(1, 1)).at(0, 0).moving(0.001, 0));
        Body stone = engine.add(new Body(new Rectangle(1, 1)).at(1.4, 0));
        run(engine, 5);
        ram.setVelocity(3, 0);
        fails[0] = true;
        assertThatThrownBy(engine::step).hasMessage("no force");
        fails[0] = false;
        run(engine, 20);
        assertThat(engine.getImpacts()).isEqualTo(1);
        assertThat(engine.getDeepestPenetration()).isZero();
        assertThat(stone.getX()).isGreaterThan(6);
    }

    @Test
    void aBodyThatPassesThroughOthersMeetsThemWhenItIsToldTo() {
        PhysicsEngine engine = new PhysicsEngine();
        Body ghost = engine.add(new Body(new Circle(1)).at(0, 0).moving(1, 0));
        Body hung = engine.add(new Body(new Circle(1)).at(0, 20).moving(1, 0)); // driven by the integrator
        engine.add(new PinJoint(hung, 0, 1000));
        engine.add(Body.fixed(new Rectangle(1, 100)).at(30, 0));
        engine.add(Body.fixed(new Rectangle(1, 100)).at(70, 0));
        ghost.setCollisionGroup(1, 0);
        hung.setCollisionGroup(0, -1);
        run(engine, 50);
        assertThat(ghost.getX()).isEqualTo(50);
        assertThat(hung.getX()).isCloseTo(50, within(0.1));
        assertThat(engine.getImpacts()).isZero();
        ghost.setCollisionGroup(1, -1);
        hung.setCollisionGroup(2, 1 << 2);
        run(engine, 30);
        assertThat(engine.getImpacts()).isEqualTo(1);
        assertThat(ghost.getX()).isCloseTo(57, within(1e-12)); // back from 68.5 after 18.5
        hung.setCollisionGroup(1, -1);
        run(engine, 150);
        assertThat(engine.getImpacts()).isGreaterThan(1);
    }

    @Test
    void anAppliedForceActsForOneStep() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.5);
        Body body = new Body(new Circle(1)).at(0, 0);
        body.setMass(2, 3);
        engine.add(body);
        body.addForce(4, 0);
        body.addTorque(6);
        engine.step();
        assertThat(body.getX()).isEqualTo(0.25);
        assertThat(body.getVelocityX()).isEqualTo(1);
        assertThat(body.getAngularVelocity()).isEqualTo(1);
        engine.step();
        assertThat(body.getX()).isEqualTo(0.75);
        assertThat(body.getVelocityX()).isEqualTo(1);
        body.addForceAt(0, 2, body.getX() + 3, 0);
        engine.step();
        assertThat(body.getVelocityY()).isEqualTo(0.5);
        assertThat(body.getAngularVelocity()).isEqualTo(2);
    }

    /** It is the same whether a body is pushed and then added, or added and then pushed; and what is pushed while it is out waits. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aForceOnABodyOutsideOfAnEngineWaitsForItsFirstStepInOne(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStepping(substeps);
        engine.setTimeStep(0.5);
        Body body = new Body(new Circle(1)).at(0, 0);
        body.setMass(2, 3);
        body.addForce(4, 0);
        engine.step();
        engine.add(body);
        engine.step();
        assertThat(body.getVelocityX()).isCloseTo(1, within(1e-15));
        engine.step();
        assertThat(body.getVelocityX()).isCloseTo(1, within(1e-15));
        engine.remove(body);
        for (int k = 0; k < 3; k++) {
            body.addForce(4, 0);
            body.addTorque(6);
            engine.step();
        }
        engine.add(body);
        engine.step();
        engine.step();
        assertThat(body.getVelocityX()).isCloseTo(4, within(1e-14));
        assertThat(body.getAngularVelocity()).isCloseTo(3, within(1e-14));
    }

    /** What comes in its place was tied as it had been: moved to where that was, or the step threw that the joint was open. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aBodyWhoseJointIsRemovedBeforeItLeavesNothing(int substeps) {
        for (boolean isFixed : new boolean[] {false, true}) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(0.125);
            engine.setTimeStepping(substeps);
            Body door = engine.add(new Body(new Rectangle(1, 1)).at(2, 0));
            PinJoint hinge = engine.add(new PinJoint(door, 3, 0));
            run(engine, 3);
            engine.remove(hinge);
            engine.remove(door);
            Body next = isFixed ? Body.fixed(new Circle(1)) : new Body(new Circle(1)).moving(1, -2);
            engine.add(next.at(10, 5));
            run(engine, 8);
            assertThat(next.getX()).isEqualTo(isFixed ? 10 : 11);
            assertThat(next.getY()).isEqualTo(isFixed ? 5 : 3);
        }
    }

    @Test
    void aParabolaIsExactForAnyStep() {
        for (double step : new double[] {1e-3, 0.1, 1}) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(step);
            engine.add(new Gravity(0, -9.81));
            Body body = engine.add(new Body(new Circle(1)).at(1, 2).moving(3, 4, 5));
            run(engine, (int) Math.round(10 / step));
            assertThat(body.getX()).isCloseTo(31, within(1e-12));
            assertThat(body.getY()).isCloseTo(2 + 40 - 0.5 * 9.81 * 100, within(1e-12));
            assertThat(body.getAngle()).isCloseTo(50, within(1e-12));
        }
    }

    @Test
    void theClockDoesNotDrift() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.1);
        run(engine, 10_000_000);
        assertThat(engine.getTime()).isEqualTo(1_000_000);
    }

    @Test
    void aClusterThatNeverTouchesChangesNothing() {
        PhysicsEngine alone = Scenes.gas(Scenes.Kind.POLYGONS, 20, 1);
        PhysicsEngine together = Scenes.gas(Scenes.Kind.POLYGONS, 20, 1);
        for (int k = 0; k < 5; k++) {
            together.add(new Body(new Circle(1)).at(1e4 + 2.5 * k, 0).moving(k, 0));
        }
        run(alone, 200);
        run(together, 200);
        for (int k = 0; k < alone.bodies().size(); k++) {
            assertThat(together.bodies().get(k).getX()).isEqualTo(alone.bodies().get(k).getX());
            assertThat(together.bodies().get(k).getAngle()).isEqualTo(alone.bodies().get(k).getAngle());
        }
    }

    @Test
    void allBroadPhasesGiveTheSameRun() {
        PhysicsEngine sweep = Scenes.gas(Scenes.Kind.FIGURE_1, 60, 2);
        sweep.setBroadPhase(new SortAndSweep());
        PhysicsEngine grid = Scenes.gas(Scenes.Kind.FIGURE_1, 60, 2);
        grid.setBroadPhase(new CellGrid());
        PhysicsEngine all = Scenes.gas(Scenes.Kind.FIGURE_1, 60, 2);
        all.setBroadPhase(new BruteForce());
        for (int k = 0; k < 20; k++) {
            run(sweep, 10);
            run(grid, 10);
            run(all, 10);
            assertThat(grid.getImpacts()).isEqualTo(sweep.getImpacts());
            assertThat(all.getImpacts()).isEqualTo(sweep.getImpacts());
        }
    }

    @Test
    void aBroadPhaseTakesOverWhatIsNearOneAnother() {
        PhysicsEngine kept = Scenes.gas(Scenes.Kind.FIGURE_1, 45, 3);
        PhysicsEngine changed = Scenes.gas(Scenes.Kind.FIGURE_1, 45, 3);
        kept.setBroadPhase(new BruteForce());
        for (int k = 0; k < 60; k++) {
            changed.setBroadPhase(k % 3 == 0 ? new CellGrid() : k % 3 == 1 ? new SortAndSweep() : new BruteForce());
            run(kept, 1);
            run(changed, 1);
            assertThat(changed.getImpacts()).isEqualTo(kept.getImpacts());
        }
        assertThat(kept.getImpacts()).isGreaterThan(20);
        for (int k = 0; k < kept.bodies().size(); k++) {
            assertThat(changed.bodies().get(k).getX()).isCloseTo(kept.bodies().get(k).getX(), within(1e-9));
        }
    }

    /** The engine takes a grid then, of its own accord. */
    @Test
    void aSceneGrowsToACrowdWhileBodiesAreNearOneAnother() {
        PhysicsEngine engine = Scenes.gas(Scenes.Kind.FIGURE_1, 40, 3);
        run(engine, 20);
        double energy = engine.kineticEnergy();
        for (int k = 0; k < 20; k++) {
            engine.add(new Body(new Circle(1)).at(1e4 + 2.5 * k, 0));
        }
        run(engine, 20);
        assertThat(engine.kineticEnergy()).isCloseTo(energy, within(1e-12 * energy));
    }

    @Test
    void aListenerLetsPassSticksAndRemoves() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.1);
        Body wall = engine.add(Body.fixed(new Rectangle(1, 10)).at(5, 0));
        Body ghost = engine.add(new Body(new Circle(1)).at(0, 0).moving(2, 0));
        Body glue = engine.add(new Body(new Circle(1)).at(0, 3).moving(2, 1));
        Body doomed = engine.add(new Body(new Circle(1)).at(0, -3).moving(2, 0));
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public Decision colliding(Contact contact) {
                assertThat(contact.approachSpeed()).isCloseTo(2, within(1e-14));
                assertThat(contact.x()).isCloseTo(4.5, within(1e-14));
                Body mover = contact.other(wall);
                return mover == ghost ? Decision.IGNORE : mover == glue ? Decision.STICK : Decision.BOUNCE;
            }

            @Override
            public void collided(Contact contact) {
                assertThat(contact.time()).isCloseTo(1.75, within(1e-14));
                assertThat(contact.impulse()).isPositive();
                if (contact.other(wall) == doomed) {
                    engine.remove(doomed);
                    engine.add(new Body(new Circle(1)).at(-20, 0));
                }
            }
        });
        run(engine, 40);
        assertThat(ghost.getX()).isCloseTo(8, within(1e-13));
        // the point of contact stands still: the disc rolls about it
        assertThat(glue.getVelocityX()).isCloseTo(0, within(1e-14));
        assertThat(glue.getVelocityY() + glue.getAngularVelocity()).isCloseTo(0, within(1e-14));
        assertThat(engine.contains(doomed)).isFalse();
        assertThat(engine.bodies()).hasSize(4);
    }

    @Test
    void filtersKeepBodiesApart() {
        PhysicsEngine engine = new PhysicsEngine();
        Body a = engine.add(new Body(new Circle(1)).at(0, 0).moving(1, 0));
        Body b = engine.add(new Body(new Circle(1)).at(5, 0));
        engine.setCollisions(a, b, false);
        run(engine, 20);
        assertThat(engine.getImpacts()).isZero();
        a.at(0, 0);
        b.setCollisionGroup(2, 2);
        engine.setCollisions(a, b, true);
        run(engine, 20);
        assertThat(engine.getImpacts()).isZero();
        a.at(0, 0);
        b.setCollisionGroup(1, -1L);
        run(engine, 20);
        assertThat(engine.getImpacts()).isEqualTo(1);
    }

    @Test
    void frictionStopsASpinningDiscWhereTheoryDoes() {
        // hard case C21: Farkas et al. 2003, R = 0.1, mu = 0.3
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.add(new SurfaceFriction(9.81));
        Body disc = new Body(new Circle(0.1)).at(0, 0).moving(1, 0, 10);
        disc.setSurfaceFriction(0.3);
        engine.add(disc);
        Body box = new Body(new Rectangle(1, 2)).at(0, 5).moving(0, 3);
        box.setSurfaceFriction(0.5);
        engine.add(box);
        run(engine, 27);
        assertThat(disc.getVelocityX()).isPositive();
        run(engine, 1);
        assertThat(disc.getVelocityX()).isZero();
        assertThat(disc.getAngularVelocity()).isZero();
        assertThat(disc.getX()).isCloseTo(0.2165807761242, within(1e-8));
        run(engine, 60);
        assertThat(box.getY()).isCloseTo(5 + 9 / (2 * 0.5 * 9.81), within(1e-9));
        assertThat(box.getAngle()).isZero();
    }

    @Test
    void staticFrictionHoldsUpToItsLimit() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(new SurfaceFriction(10));
        Body box = new Body(new Rectangle(1, 1)).at(0, 0);
        box.setMass(2);
        box.setSurfaceFriction(0.3, 0.5);
        engine.add(box);
        for (int k = 0; k < 10; k++) {
            box.addForce(9.999, 0);
            engine.step();
        }
        assertThat(box.getX()).isZero();
        box.addForce(10.001, 0);
        engine.step();
        assertThat(box.getVelocityX()).isCloseTo((10.001 - 6) / 2, within(1e-9));
    }

    @Test
    void masonsScheduleRunsTheEngine() {
        SimState state = new SimState(1);
        state.start();
        PhysicsEngine engine = new PhysicsEngine();
        Body body = engine.add(new Body(new Circle(1)).moving(1, 0));
        Repeating repeating = engine.scheduleOn(state.schedule);
        for (int k = 0; k < 5; k++) {
            state.schedule.step(state);
        }
        assertThat(body.getX()).isEqualTo(5);
        repeating.stop();
        state.schedule.step(state);
        assertThat(body.getX()).isEqualTo(5);
        state.finish();
    }

    @Test
    void anEngineThatIsScheduledTwiceMakesOneStepAtATime() {
        SimState state = new SimState(1);
        state.start();
        PhysicsEngine engine = new PhysicsEngine();
        Body body = engine.add(new Body(new Circle(1)).moving(1, 0));
        engine.scheduleOn(state.schedule);
        engine.scheduleOn(state.schedule);
        for (int k = 0; k < 5; k++) {
            state.schedule.step(state);
        }
        assertThat(body.getX()).isEqualTo(5);
        state.finish();
    }

    /** MASON ends a schedule on which nothing is left, and takes nothing any more: an engine would silently never step. */
    @Test
    void aScheduleThatIsAtItsEndIsRefused() {
        SimState state = new SimState(1);
        state.start();
        PhysicsEngine engine = new PhysicsEngine();
        engine.scheduleOn(state.schedule).stop();
        while (state.schedule.step(state)) {
            assertThat(engine.getSteps()).isZero();
        }
        assertThatIllegalStateException().isThrownBy(() -> engine.scheduleOn(state.schedule)).withMessageContaining("at its end");
        state.schedule.reset();
        engine.scheduleOn(state.schedule);
        state.schedule.step(state);
        assertThat(engine.getSteps()).isEqualTo(1);
        state.finish();
    }

    @Test
    void aScheduleThatIsRefusedDoesNotEndTheOneBefore() {
        SimState state = new SimState(1);
        state.start();
        SimState over = new SimState(1);
        over.start();
        while (over.schedule.step(over)) {
            assertThat(over.schedule.getSteps()).isPositive();
        }
        PhysicsEngine engine = new PhysicsEngine();
        engine.scheduleOn(state.schedule);
        assertThatIllegalStateException().isThrownBy(() -> engine.scheduleOn(over.schedule)).withMessageContaining("at its end");
        for (int k = 0; k < 3; k++) {
            state.schedule.step(state);
        }
        assertThat(engine.getSteps()).isEqualTo(3);
        state.finish();
    }

    @Test
    void aStepAllocatesNothing() {
        PhysicsEngine engine = Scenes.gas(Scenes.Kind.FIGURE_1, 30, 3);
        run(engine, 60_000);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        long before = threads.getThreadAllocatedBytes(id);
        run(engine, 2_000);
        long after = threads.getThreadAllocatedBytes(id);
        assertThat(after - before).isLessThan(2_000);
    }
}
