// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.assertj.core.api.Assertions.within;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import sim.physics.constraint.ConstraintException;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Euler;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.Rattle;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.SurfaceFriction;
import sim.physics.motion.SymplecticEuler;
import sim.physics.motion.ViscousFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Steps that threads share give the same bits, the same counts, the same events and the same exceptions. */
class ThreadsTest {
    private static final int[] NUMBERS = {2, 3, 16};

    /** Sixteen threads, however few processors there are, so that they do get in each other's way. */
    private static final ForkJoinPool POOL = new ForkJoinPool(16);

    @AfterAll
    static void close() {
        POOL.shutdown();
    }

    /** A drag that says whether any thread may ask for it, and notes who does. */
    private static final class Drag implements ForceGenerator {
        private static final long serialVersionUID = 1L;
        private final boolean isConcurrent;
        private final double failsBeyond;
        private transient volatile Thread allowed;
        private transient volatile boolean wasMet;

        Drag(boolean isConcurrent, double failsBeyond) {
            this.isConcurrent = isConcurrent;
            this.failsBeyond = failsBeyond;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            wasMet |= allowed != null && Thread.currentThread() != allowed;
            if (body.getX() > failsBeyond) {
                throw new IllegalStateException("no force at " + body.getX());
            }
            double k = 0.05 * body.getMass();
            forces.add(body, -k * body.getVelocityX(), -k * body.getVelocityY());
        }

        @Override
        public boolean isConcurrent() {
            return isConcurrent;
        }
    }

    /** Keeps all that it is told, in its order. */
    private static final class Diary implements CollisionListener {
        private static final long serialVersionUID = 1L;
        private long hash = 1;
        private int count;

        @Override
        public void collided(Contact contact) {
            count++;
            hash = 31 * hash + Double.doubleToLongBits(contact.time());
            hash = 31 * hash + Double.doubleToLongBits(contact.impulse());
            hash = 31 * hash + contact.a().index();
            hash = 31 * hash + contact.b().index();
        }
    }

    /** Chains under gravity between bodies that slide and hit them; some with motors, stops and rods. */
    private static PhysicsEngine workshop() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 120.0);
        engine.add(new Gravity(0.3, -2));
        engine.add(new SurfaceFriction(0.5));
        engine.add(new ViscousFriction(0.1));
        for (int c = 0; c < 40; c++) {
            double x = 12 * (c % 8);
            double y = 12 * (c / 8);
            Body last = null;
            for (int k = 0; k < 5; k++) {
                Body body = engine.add(new Body(new Rectangle(1, 0.2)).at(x + k + 0.5, y));
                if (k == 0) {
                    engine.add(new PinJoint(body, x, y));
                } else if (c % 5 == 4 && k == 3) {
                    engine.add(new RodJoint(last, x + k - 0.5, y, body, x + k + 0.5, y));
                } else {
                    engine.add(new PinJoint(last, body, x + k, y));
                }
                if (c % 5 == 1 && k == 0) {
                    engine.add(Motor.turning(body, null, 2, 5));
                }
                if (c % 5 == 2 && k == 1) {
                    engine.add(Limit.angle(last, body, -0.4, 0.4));
                }
                last = body;
            }
            for (int k = 0; k < 6; k++) {
                Body body = new Body(k % 2 == 0 ? new Circle(0.4) : new Rectangle(0.8, 0.5));
                engine.add(body.at(x + 1.7 * k, y + 2 + k % 3).moving(3 * k - 7, -5 - 0.9 * (c % 4), 0.8 * k));
                body.setRestitution(0.8);
                body.setSurfaceFriction(0.02);
            }
        }
        return engine;
    }

    private static void run(PhysicsEngine engine, int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    /** What can be seen of a run. */
    private static List<Long> seen(PhysicsEngine engine, Diary diary) {
        return List.of(
                Scenes.hash(engine), engine.getImpacts(), engine.getNarrowPhaseEvaluations(), diary.hash, (long) diary.count);
    }

    private static List<Long> run(Supplier<PhysicsEngine> scene, int threads, int steps, boolean isWatched) {
        PhysicsEngine engine = scene.get();
        engine.setThreads(threads, true);
        Diary diary = new Diary();
        if (isWatched) {
            engine.addListener(diary);
        }
        POOL.submit(() -> run(engine, steps)).join();
        assertThat(engine.sharedWorks()).isGreaterThan(threads > 1 ? steps / 2 : -1);
        return seen(engine, diary);
    }

    private static void assertSameBits(Supplier<PhysicsEngine> scene, int steps, long impacts) {
        List<Long> alone = run(scene, 1, steps, true);
        assertThat(alone.get(1)).isGreaterThan(impacts);
        for (int threads : NUMBERS) {
            assertThat(run(scene, threads, steps, true)).as("%d threads", threads).isEqualTo(alone);
        }
        assertThat(run(scene, 2, steps, false).subList(0, 3)).as("unwatched").isEqualTo(alone.subList(0, 3));
    }

    @Test
    void aGas() {
        assertSameBits(() -> Scenes.s3(2000, 5), 60, 2000);
    }

    @Test
    void aCrowd() {
        assertSameBits(() -> {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1.0 / 60);
            for (int k = 0; k < 900; k++) {
                Body disk = new Body(new Circle(0.5)).at(1.06 * (k % 30), 1.06 * (k / 30));
                engine.add(disk.moving(StrictMath.sin(k), StrictMath.sin(1.7 * k)));
            }
            return engine;
        }, 100, 2000);
    }

    @Test
    void chainsWithMotorsAndStopsAmongBodiesThatSlide() {
        assertSameBits(ThreadsTest::workshop, 200, 300);
    }

    @Test
    void chainsWithEveryMethodOfFixedStep() {
        assertSameBits(() -> {
            PhysicsEngine engine = workshop();
            engine.setIntegrator(new Euler());
            return engine;
        }, 100, 150);
        assertSameBits(() -> {
            PhysicsEngine engine = workshop();
            engine.setIntegrator(new Rattle(4));
            return engine;
        }, 60, 70);
        assertSameBits(() -> {
            PhysicsEngine engine = workshop();
            engine.setIntegrator(new SymplecticEuler());
            return engine;
        }, 60, 70);
    }

    /** Chains and boxes under drag that fall on the ground and stay there, so that contacts push what the integrator drives. */
    private static PhysicsEngine ground() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -9.81));
        engine.add(new ViscousFriction(0.05));
        engine.add(Body.fixed(new Rectangle(400, 2)).at(80, -1));
        for (int c = 0; c < 24; c++) {
            Body last = null;
            for (int k = 0; k < 4; k++) {
                Body body = engine.add(new Body(new Rectangle(1, 0.2)).at(7 * c + k, 0.4 + 0.02 * c));
                if (last != null) {
                    engine.add(new PinJoint(last, body, 7 * c + k - 0.5, 0.4 + 0.02 * c));
                    if (c % 3 == 1 && k == 2) {
                        engine.add(Motor.turning(last, body, 1, 0.5));
                    } else if (c % 3 == 2) {
                        engine.add(Limit.angle(last, body, -0.2, 0.3));
                    }
                }
                last = body;
            }
            Body box = engine.add(new Body(new Rectangle(0.6, 0.5)).at(7 * c + 5, 0.3 + 0.03 * c));
            box.setSurfaceFriction(0.3);
        }
        return engine;
    }

    @Test
    void chainsAndBoxesThatLieOnTheGround() {
        assertSameBits(ThreadsTest::ground, 120, 100);
    }

    /** No force; counts how often it is asked for. */
    private static final class Count implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final AtomicLong calls = new AtomicLong();

        @Override
        public void addForce(Body body, double time, Forces forces) {
            calls.incrementAndGet();
        }

        @Override
        public boolean isConcurrent() {
            return true;
        }
    }

    @Test
    void forcesAreAskedForAsOftenAsByOneThread() {
        for (Supplier<PhysicsEngine> scene : List.<Supplier<PhysicsEngine>>of(ThreadsTest::ground, ThreadsTest::workshop)) {
            List<Long> calls = new ArrayList<>();
            for (int threads : new int[] {1, 2, 16}) {
                PhysicsEngine engine = scene.get();
                Count count = new Count();
                engine.add(count);
                engine.bodies().forEach(body -> body.setRestitution(0)); // what lies is probed, which may be its motion
                engine.setThreads(threads, true);
                POOL.submit(() -> run(engine, 90)).join();
                calls.add(count.calls.get());
            }
            assertThat(calls).containsOnly(calls.get(0));
        }
    }

    @Test
    void pathsThatAreTooCoarseNearOthers() {
        assertSameBits(() -> {
            PhysicsEngine engine = workshop();
            engine.setTimeStep(1 / 12.0);
            engine.bodies().forEach(body -> body.setAngularVelocity(body.getAngularVelocity() + 3));
            return engine;
        }, 40, 150);
    }

    @Test
    void anAuditSaysTheSame() {
        List<String> said = new ArrayList<>();
        for (int threads : new int[] {1, 3}) {
            PhysicsEngine engine = workshop();
            Drag drag = new Drag(true, 1e9);
            engine.add(drag);
            engine.setThreads(threads, true);
            engine.setAudited(true);
            POOL.submit(() -> {
                drag.allowed = Thread.currentThread();
                run(engine, 20);
            }).join();
            assertThat(drag.wasMet).as("by another thread").isFalse();
            said.add(Scenes.hash(engine) + " " + engine.getRunReport());
        }
        assertThat(said.get(1)).isEqualTo(said.get(0));
    }

    @Test
    void aGasUnderAForceOfAnAuthor() {
        assertSameBits(() -> {
            PhysicsEngine engine = Scenes.s3(1500, 5);
            engine.add(new Drag(true, 1e9));
            return engine;
        }, 30, 500);
    }

    @Test
    void afterACheckpoint() {
        PhysicsEngine alone = workshop();
        run(alone, 120);
        PhysicsEngine first = workshop();
        first.setThreads(3);
        run(first, 60);
        PhysicsEngine restored = Checkpoint.copy(first);
        assertThat(restored.getThreads()).isEqualTo(3);
        run(restored, 60);
        assertThat(restored.sharedWorks()).isGreaterThan(first.sharedWorks());
        assertThat(Scenes.hash(restored)).isEqualTo(Scenes.hash(alone));
    }

    @Test
    void theNumberMayChangeBetweenSteps() {
        PhysicsEngine alone = workshop();
        run(alone, 90);
        PhysicsEngine engine = workshop();
        for (int k = 0; k < 90; k++) {
            engine.setThreads(1 + k % 4, k % 3 == 0);
            engine.step();
        }
        assertThat(Scenes.hash(engine)).isEqualTo(Scenes.hash(alone));
        assertThat(engine.getNarrowPhaseEvaluations()).isEqualTo(alone.getNarrowPhaseEvaluations());
    }

    @Test
    void authorsAreCalledByTheSteppingThread() {
        for (boolean isConcurrent : new boolean[] {false, true}) {
            PhysicsEngine engine = Scenes.s3(1500, 5);
            Drag drag = new Drag(isConcurrent, 1e9);
            engine.add(drag);
            engine.setThreads(16);
            POOL.submit(() -> {
                drag.allowed = Thread.currentThread();
                run(engine, 60);
            }).join();
            assertThat(drag.wasMet && !isConcurrent).isFalse();
        }
    }

    @Test
    void theFirstExceptionIsThatOfOneThread() {
        Supplier<PhysicsEngine> scene = () -> {
            PhysicsEngine engine = Scenes.s3(2000, 5);
            engine.add(new Drag(true, 10));
            return engine;
        };
        PhysicsEngine alone = scene.get();
        Throwable expected = catchThrowable(alone::step);
        assertThat(expected).isInstanceOf(IllegalStateException.class).hasMessageContaining("no force at");
        for (int threads : NUMBERS) {
            PhysicsEngine engine = scene.get();
            engine.setThreads(threads, true);
            Throwable thrown = POOL.submit(() -> catchThrowable(engine::step)).join();
            assertThat(thrown).hasSameClassAs(expected).hasMessage(expected.getMessage());
            assertThat(Scenes.hash(engine)).isEqualTo(Scenes.hash(alone));
        }
    }

    @Test
    void aJointThatCannotBeClosedIsTheSameException() {
        Supplier<PhysicsEngine> scene = () -> {
            PhysicsEngine engine = workshop();
            for (int k = 0; k < 3; k++) {
                double x = 200 + 10 * k;
                double spin = 1e9 * (k + 1);
                Body body = engine.add(new Body(new Circle(0.3)).at(x + 0.2, 0).moving(0, 0.2 * spin, spin));
                engine.add(new PinJoint(body, x, 0));
            }
            return engine;
        };
        PhysicsEngine alone = scene.get();
        Throwable expected = catchThrowable(() -> run(alone, 20));
        for (int threads : NUMBERS) {
            PhysicsEngine engine = scene.get();
            engine.setThreads(threads, true);
            Throwable thrown = POOL.submit(() -> catchThrowable(() -> run(engine, 20))).join();
            assertThat(String.valueOf(thrown)).isEqualTo(String.valueOf(expected));
            assertThat(engine.getSteps()).isEqualTo(alone.getSteps());
        }
        assertThat(expected).isInstanceOf(ConstraintException.class);
    }

    @Test
    void smallStepsAreNotShared() {
        PhysicsEngine gas = Scenes.s3(3000, 5);
        gas.setThreads(4);
        run(gas, 20);
        assertThat(gas.sharedWorks()).isZero();
        PhysicsEngine chain = new PhysicsEngine();
        chain.add(new Gravity(0, -1));
        chain.setThreads(2);
        for (int k = 0; k < 10; k++) {
            chain.add(new PinJoint(chain.add(new Body(new Circle(0.3)).at(5 * k + 1, 0)), 5 * k, 0));
        }
        run(chain, 50);
        assertThat(chain.sharedWorks()).isZero();
    }

    @Test
    void numbersThatAreNone() {
        PhysicsEngine engine = new PhysicsEngine();
        for (int threads : new int[] {0, -1, Integer.MIN_VALUE}) {
            assertThatThrownBy(() -> engine.setThreads(threads))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("threads are " + threads);
        }
        assertThat(engine.getThreads()).isEqualTo(1);
    }

    @Test
    void aDroppedEngineIsCollected() throws InterruptedException {
        List<WeakReference<PhysicsEngine>> dropped = new ArrayList<>();
        for (int k = 0; k < 20; k++) {
            PhysicsEngine engine = workshop();
            engine.setThreads(4);
            run(engine, 2);
            dropped.add(new WeakReference<>(engine));
        }
        for (int k = 0; k < 100 && dropped.stream().anyMatch(r -> r.get() != null); k++) {
            System.gc();
            Thread.sleep(10);
        }
        assertThat(dropped).allMatch(r -> r.get() == null);
    }

    /** Pairs that are tied, stand on a rough plane, and are pulled harder than it holds them set off at g sin φ − μ g. */
    @Test
    void whatThePlaneDoesNotHold() {
        for (Integrator method : List.of(new RungeKutta4(), new Rattle(4), new SymplecticEuler())) {
            Supplier<PhysicsEngine> slope = () -> {
                PhysicsEngine engine = new PhysicsEngine();
                engine.setTimeStep(1 / 60.0);
                engine.setIntegrator(method);
                engine.add(new Gravity(3, 0));
                engine.add(new SurfaceFriction(10));
                for (int k = 0; k < 8; k++) {
                    Body a = engine.add(new Body(new Circle(0.4)).at(0, 3 * k));
                    Body b = engine.add(new Body(new Circle(0.4)).at(1, 3 * k));
                    a.setSurfaceFriction(0.2);
                    b.setSurfaceFriction(0.2);
                    engine.add(new RodJoint(a, 0, 3 * k, b, 1, 3 * k));
                }
                return engine;
            };
            assertSameBits(slope, 60, -1);
            PhysicsEngine shared = slope.get();
            shared.setThreads(3, true);
            POOL.submit(() -> run(shared, 60)).join();
            assertThat(shared.bodies().get(5).getVelocityX()).isCloseTo(1, within(0.1));
        }
    }
}
