// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.ObjIntConsumer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.DirectSolver;
import sim.physics.constraint.Equations;
import sim.physics.constraint.GlobalSolver;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.Euler;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.SymplecticEuler;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.scenes.Deed;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Threads share islands that go from state to state without paths, and nobody can tell. */
class LateThreadsTest {
    private static final int[] NUMBERS = {2, 3, 16};
    private static final int ISLANDS = 30;
    private static final int KINDS = 6;

    /** As in {@link ThreadsTest}: more threads than processors. */
    private static final ForkJoinPool POOL = new ForkJoinPool(16);

    @AfterAll
    static void close() {
        POOL.shutdown();
    }

    /** A length between two bodies as an author would keep it, so that no other thread may ask. */
    private static final class Wand implements Constraint {
        private static final long serialVersionUID = 1L;

        private final RodJoint like;
        private boolean isBroken;

        private Wand(RodJoint like) {
            this.like = like;
        }

        @Override
        public Body getBodyA() {
            return like.getBodyA();
        }

        @Override
        public Body getBodyB() {
            return like.getBodyB();
        }

        @Override
        public int getRows() {
            return 1;
        }

        @Override
        public void evaluate(Equations equations) {
            if (isBroken) {
                throw new IllegalStateException("broken at " + like.getBodyA().index());
            }
            like.evaluate(equations);
        }
    }

    /** A drag on some bodies that fails on some. */
    private static final class Drag implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final List<Body> slow = new ArrayList<>();
        private final List<Body> failing = new ArrayList<>();
        private final AtomicLong calls = new AtomicLong();

        @Override
        public boolean actsOn(Body body) {
            return slow.contains(body);
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            calls.incrementAndGet();
            if (failing.contains(body)) {
                throw new IllegalStateException("no force on " + body.index());
            }
            forces.add(body, -0.1 * body.getVelocityX(), -0.1 * body.getVelocityY());
        }

        @Override
        public boolean isConcurrent() {
            return true;
        }
    }

    /** Islands of all kinds that collide with nobody, and a ball and a pinned pair that strike walls in some of the steps. */
    private static final class Hall implements CollisionListener {
        private static final long serialVersionUID = 1L;

        private final PhysicsEngine engine = new PhysicsEngine();
        private final List<List<Body>> islands = new ArrayList<>();
        private final Drag drag = new Drag();
        private final List<Wand> wands = new ArrayList<>();
        private final List<Serializable> seen = new ArrayList<>();
        private Deed deed = Deed.NOTHING;
        private int collisions;

        private Hall(int count) {
            engine.setTimeStep(1 / 60.0);
            engine.add(new Gravity(0.5, -9.81));
            for (int c = 0; c < count; c++) {
                islands.add(island(c % KINDS, 20 * (c % 6), 20 * (c / 6)));
            }
            for (int c = 0; c < count; c++) {
                if (c / KINDS % 2 == 1) {
                    drag.slow.addAll(islands.get(c));
                }
            }
            engine.add(drag);
            box();
            engine.addListener(this);
        }

        private void box() {
            engine.add(Body.fixed(new Rectangle(10, 1)).at(-20, -3));
            engine.add(Body.fixed(new Rectangle(1, 10)).at(-24, 0));
            engine.add(Body.fixed(new Rectangle(1, 10)).at(-16, 0));
            Body one = engine.add(new Body(new Circle(0.3)).at(-22, 0.5).moving(-4, 0, 0));
            Body two = engine.add(new Body(new Circle(0.3)).at(-21, 0.5));
            List<Body> all = new ArrayList<>(List.of(one, two));
            for (int k = 0; k < 4; k++) {
                all.add(engine.add(new Body(new Circle(0.3)).at(-20, 1.5 + 0.8 * k).moving(k % 2 == 0 ? 9 + k : -8, 0, 1)));
            }
            all.forEach(body -> body.setRestitution(1));
            engine.add(new PinJoint(one, two, -21.5, 0.5));
        }

        private List<Body> island(int kind, double x, double y) {
            List<Body> links = new ArrayList<>();
            double px = x;
            double py = y;
            for (int k = 0; k < 4; k++) {
                double angle = kind == 2 ? 0.4 * (k - 1.5) : 0; // a bridge sags
                double ex = px + StrictMath.cos(angle);
                double ey = py + StrictMath.sin(angle);
                Body last = k == 0 ? null : links.get(k - 1);
                Body link = engine.add(new Body(new Rectangle(1, 0.1 + 0.02 * k)).at(0.5 * (px + ex), 0.5 * (py + ey), angle));
                link.setCollisionGroup(1, 0);
                links.add(link);
                if (k == 0) {
                    engine.add(new PinJoint(link, px, py));
                } else if (k == 3 && kind == 1) {
                    engine.add(new PinJoint(links.get(0), link, x + 1, y)); // the joint is beside it
                } else if (k == 3 && kind == 4) {
                    engine.add(new RodJoint(last, px - 0.5, py, link, px + 0.5, py));
                } else if (k == 3 && kind == 5) {
                    wands.add(engine.add(new Wand(new RodJoint(last, px - 0.5, py, link, px + 0.5, py))));
                } else {
                    engine.add(new PinJoint(last, link, px, py));
                }
                px = ex;
                py = ey;
            }
            if (kind == 2) {
                engine.add(new PinJoint(links.get(3), px, py));
            } else if (kind == 3) {
                engine.add(Motor.turning(links.get(0), null, 2, 30));
                engine.add(Limit.angle(links.get(1), links.get(2), -0.4, 0.3));
            }
            return links;
        }

        @Override
        public void collided(Contact contact) {
            List<Body> island = islands.get(collisions++ % islands.size());
            Body tip = island.get(3);
            seen.add(contact.time());
            seen.add(tip.getX());
            seen.add(tip.getVelocityY());
            if (!engine.contains(tip)) {
                return;
            }
            if (deed == Deed.NOTHING) {
                seen.add(tip.getAngle());
            }
            deed.act(engine, island.get(0), tip);
        }
    }

    /** All that is seen in a run in which something is done before some steps. */
    private static List<Serializable> run(Hall hall, int threads, int steps, ObjIntConsumer<Hall> before) {
        hall.engine.setThreads(threads, true);
        return POOL.submit(() -> steps(hall, steps, before)).join();
    }

    private static List<Serializable> steps(Hall hall, int steps, ObjIntConsumer<Hall> before) {
        List<Serializable> seen = new ArrayList<>();
        Hall now = hall;
        for (int k = 0; k < steps; k++) {
            before.accept(now, k);
            now.engine.step();
            seen.add(Scenes.hash(now.engine));
            seen.add(now.engine.getNarrowPhaseEvaluations());
        }
        seen.addAll(now.seen);
        return seen;
    }

    private static void assertSameBits(Deed deed, int steps, ObjIntConsumer<Hall> before) {
        List<Serializable> alone = null;
        for (int threads : new int[] {1, 2, 3, 16}) {
            Hall hall = new Hall(ISLANDS);
            hall.deed = deed;
            List<Serializable> seen = run(hall, threads, steps, before);
            seen.add(hall.drag.calls.get());
            alone = alone == null ? seen : alone;
            assertThat(seen).as("%d threads", threads).isEqualTo(alone);
            assertThat(hall.collisions).as("collisions").isGreaterThan(steps / 8);
            assertThat(hall.engine.sharedWorks()).as("shared").isGreaterThan(threads > 1 ? steps / 4 : -1);
        }
    }

    private static void nothing(Hall hall, int step) {
        // it goes on as it is
    }

    @ParameterizedTest
    @EnumSource(Deed.class)
    void nobodyCanTell(Deed deed) {
        assertSameBits(deed, 200, LateThreadsTest::nothing);
    }

    @Test
    void islandsStayWithoutPathsWhereNothingHappens() {
        List<Integer> alone = new ArrayList<>();
        run(new Hall(ISLANDS), 1, 100, (hall, k) -> alone.add(hall.engine.latePaths()));
        assertThat(alone).filteredOn(late -> late >= ISLANDS / 3).hasSizeGreaterThan(50);
        assertThat(alone).filteredOn(late -> late == 0).hasSizeGreaterThan(20);
        for (int threads : NUMBERS) {
            List<Integer> late = new ArrayList<>();
            run(new Hall(ISLANDS), threads, 100, (hall, k) -> late.add(hall.engine.latePaths()));
            assertThat(late).as("%d threads", threads).isEqualTo(alone);
        }
    }

    @Test
    void whatIsWrittenBetweenSteps() {
        assertSameBits(Deed.NOTHING, 150, (hall, k) -> {
            List<Body> island = hall.islands.get(k % ISLANDS);
            if (k % 3 == 0) {
                island.get(2).addForce(2, 1);
            } else if (k % 7 == 0) {
                island.get(3).setVelocity(1, 1);
            } else if (k % 31 == 0) {
                hall.engine.remove(island.get(3));
            }
        });
    }

    @Test
    void anAuditInTheMiddle() {
        List<Serializable> unaudited = run(new Hall(4), 1, 60, LateThreadsTest::nothing);
        for (int threads : new int[] {1, 2, 16}) {
            List<Serializable> audited = run(new Hall(4), threads, 60, (hall, k) -> {
                if (k == 40 || k == 43) {
                    hall.engine.setAudited(k == 40);
                }
            });
            assertThat(audited).as("%d threads", threads).isEqualTo(unaudited);
        }
    }

    @Test
    void anotherSolverInTheMiddle() {
        assertSameBits(Deed.NOTHING, 120, (hall, k) -> {
            if (k == 40 || k == 80) {
                hall.engine.setConstraintSolver(k == 40 ? new GlobalSolver() : new DirectSolver());
            }
        });
    }

    @Test
    void anotherNumberInEachStep() {
        List<Serializable> changing = run(new Hall(ISLANDS), 1, 120, (hall, k) -> hall.engine.setThreads(1 + k % 4, k % 3 > 0));
        assertThat(changing).isEqualTo(run(new Hall(ISLANDS), 1, 120, LateThreadsTest::nothing));
    }

    @Test
    void afterACheckpoint() {
        List<Serializable> alone = run(new Hall(ISLANDS), 1, 120, LateThreadsTest::nothing);
        for (int threads : NUMBERS) {
            Hall hall = new Hall(ISLANDS);
            List<Serializable> first = run(hall, threads, 70, LateThreadsTest::nothing);
            Hall restored = Checkpoint.copy(hall);
            assertThat(restored.engine.getThreads()).isEqualTo(threads);
            List<Serializable> hashes = new ArrayList<>();
            POOL.submit(() -> {
                for (int k = 70; k < 120; k++) {
                    restored.engine.step();
                    hashes.add(Scenes.hash(restored.engine));
                }
            }).join();
            assertThat(first.subList(0, 140)).isEqualTo(alone.subList(0, 140));
            for (int k = 70; k < 120; k++) {
                assertThat(hashes.get(k - 70)).as("step %d", k).isEqualTo(alone.get(2 * k));
            }
        }
    }

    @Test
    void anyMethod() {
        for (Integrator method : List.of(new Euler(), new SymplecticEuler(), new DormandPrince853(1e-6))) {
            Hall alone = new Hall(ISLANDS);
            Hall shared = new Hall(ISLANDS);
            alone.engine.setIntegrator(method);
            shared.engine.setIntegrator(method);
            List<Serializable> seen = run(shared, 3, 100, LateThreadsTest::nothing);
            assertThat(seen).as("%s", method).isEqualTo(run(alone, 1, 100, LateThreadsTest::nothing));
        }
    }

    /** Runs in which forces on some islands, and an author's constraint, fail in one step; then they go on. */
    private static void assertSameFailure(List<Integer> failing, int broken) {
        List<Serializable> alone = null;
        for (int threads : new int[] {1, 2, 3, 16}) {
            Hall hall = new Hall(ISLANDS);
            List<Serializable> seen = run(hall, threads, 30, LateThreadsTest::nothing);
            failing.forEach(c -> hall.drag.failing.add(hall.islands.get(c).get(2)));
            hall.wands.get(broken / KINDS).isBroken = broken % KINDS == KINDS - 1;
            Throwable thrown = POOL.submit(() -> catchThrowable(() -> steps(hall, 10, LateThreadsTest::nothing))).join();
            assertThat(thrown).isNotNull();
            seen.add(thrown.toString());
            seen.add(hall.engine.getSteps());
            seen.add(Scenes.hash(hall.engine));
            hall.drag.failing.clear();
            hall.wands.forEach(wand -> wand.isBroken = false);
            seen.addAll(run(hall, threads, 60, LateThreadsTest::nothing));
            alone = alone == null ? seen : alone;
            assertThat(seen).as("%d threads", threads).isEqualTo(alone);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {6, 7, 8, 9, 10, 11, 23})
    void anIslandWhoseForceFails(int island) {
        assertSameFailure(List.of(island), 0);
    }

    @Test
    void severalIslandsWhoseForcesFail() {
        assertSameFailure(List.of(20, 9), 0);
        assertSameFailure(List.of(11, 19), 0);
        assertSameFailure(List.of(18, 22, 23), 0);
        assertSameFailure(List.of(20), 17);
        assertSameFailure(List.of(), 11);
        assertSameFailure(List.of(9), 23);
    }
}
