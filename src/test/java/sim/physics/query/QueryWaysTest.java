// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Questions answered by the cells, and by a look at all bodies: to the bit the same, whatever happens in between. */
class QueryWaysTest {
    private static final double[] SLOPES = {0, 1, -1, 1e-17, -1e-300, 1e-9, Double.MIN_VALUE};

    private final SplittableRandom random = new SplittableRandom(11);
    private final PhysicsEngine engine = new PhysicsEngine();
    private Queries all;
    private Queries cells;

    /** As an author has them, by the rule of cost. */
    private Queries usual;

    /** What the scenes look like. */
    enum Scene {
        CROWD,
        GRID,
        WALLS,
        SIZES,
        FAR,
        FLOWN,
        CLUSTERS,
        VILLAGES,
        HEAP,
        LINE
    }

    private Body make(Scene scene, int k) {
        double size = scene == Scene.SIZES ? StrictMath.pow(10, random.nextDouble(-2, 1)) : random.nextDouble(0.3, 1.5);
        size = scene == Scene.GRID ? 0.5 : size;
        Body body = new Body(
                k % 3 == 0 ? new Circle(size)
                : k % 3 == 1 ? new Rectangle(2 * size, size)
                : Polygon.regular(3 + random.nextInt(5), size));
        if (scene == Scene.WALLS && k % 10 == 0) {
            body = Body.fixed(new Rectangle(k % 20 == 0 ? 60 : 15, 0.2));
        }
        place(scene, body, k);
        return body;
    }

    private void place(Scene scene, Body body, int k) {
        double x = random.nextDouble(-20, 20);
        double y = random.nextDouble(-20, 20);
        switch (scene) {
            case GRID -> body.at(2 * (k % 14) - 13, 2 * (k / 14) - 13, 0.5 * Math.PI * random.nextInt(4));
            case FAR -> body.at(1e7 + x, y - 3e6, random.nextDouble(-4, 4));
            case FLOWN -> body.at(k % 40 == 0 ? x * 1e4 : x, k % 50 == 0 ? y * 1e8 : y, random.nextDouble(-4, 4));
            case CLUSTERS -> body.at(k % 5 == 0 ? 50 * x : 0.1 * x, k % 5 == 0 ? 50 * y : 0.1 * y + 100, x);
            case VILLAGES -> body.at(0.2 * x + (k % 7) * 4e3, 0.2 * y + (k % 7) * (k % 7) * 900, random.nextDouble(-4, 4));
            case HEAP -> body.at(3, 4, k % 2 == 0 ? 0 : x);
            case LINE -> body.at(x, 2, k % 2 == 0 ? 0 : y);
            default -> body.at(x, y, random.nextInt(4) == 0 ? 0 : random.nextDouble(-4, 4));
        }
    }

    private void scatter(Scene scene, int count) {
        for (int k = 0; k < count; k++) {
            engine.add(make(scene, k));
        }
        State state = engine.bodies().get(0).state();
        all = new Queries(state, Integer.MAX_VALUE, Integer.MAX_VALUE);
        cells = new Queries(state, 0, 1);
        usual = new Queries(state);
    }

    private Body any() {
        List<Body> bodies = engine.bodies();
        return bodies.get(random.nextInt(bodies.size()));
    }

    /** A start that is likely to make trouble. */
    private double start(boolean horizontal) {
        Body body = any();
        double at = horizontal ? body.getX() : body.getY();
        Lines lines = horizontal ? cells.cells.xs : cells.cells.ys;
        return switch (random.nextInt(7)) {
            case 0 -> lines.line(random.nextInt(1 + Math.min(12, lines.count)));
            case 1 -> at;
            case 2 -> at + body.getShape().boundingRadius();
            case 3 -> at + body.getShape().radius();
            case 4 -> at + random.nextDouble(-100, 100);
            default -> at + random.nextDouble(-5, 5);
        };
    }

    private double slope() {
        return random.nextInt(3) == 0 ? SLOPES[random.nextInt(SLOPES.length)] : random.nextDouble(-1, 1);
    }

    private double range() {
        return switch (random.nextInt(4)) {
            case 0 -> Double.POSITIVE_INFINITY;
            case 1 -> random.nextDouble(1e6);
            default -> random.nextDouble(8);
        };
    }

    private int compareRays(int count) {
        int hits = 0;
        for (int k = 0; k < count; k++) {
            double x = start(true);
            double y = start(false);
            double dx = slope();
            double dy = dx == 0 || random.nextBoolean() ? slope() : random.nextDouble(-1, 1);
            if (k % 5 == 0) { // along the tangent of a circle, or an edge
                Body body = any();
                y = body.getY() + body.getShape().boundingRadius();
                dx = 1;
                dy = 0;
            }
            if (Math.sqrt(dx * dx + dy * dy) == 0) {
                dx = 1;
            }
            double range = range();
            Hit hit = all.rayCast(x, y, dx, dy, range, null);
            assertThat(cells.rayCast(x, y, dx, dy, range, null)).isEqualTo(hit);
            assertThat(usual.rayCast(x, y, dx, dy, range, null)).isEqualTo(hit);
            assertThat(cells.rayCast(x, y, dx, dy, range, b -> b.index() % 2 == 0))
                    .isEqualTo(all.rayCast(x, y, dx, dy, range, b -> b.index() % 2 == 0));
            List<Hit> hits1 = all.rayCastAll(x, y, dx, dy, range, null);
            assertThat(cells.rayCastAll(x, y, dx, dy, range, null)).isEqualTo(hits1);
            assertThat(hit).isEqualTo(hits1.isEmpty() ? null : hits1.get(0));
            hits += hits1.size();
        }
        return hits;
    }

    private int compareSweeps(int count) {
        int hits = 0;
        for (int k = 0; k < count; k++) {
            double x = start(true);
            double y = start(false);
            double dx = slope();
            double dy = Math.abs(dx) < 1e-200 ? random.nextDouble(0.1, 1) : slope();
            double angle = k % 4 == 0 ? 0 : random.nextDouble(-4, 4);
            Shape like = k % 9 == 0 ? new Rectangle(random.nextDouble(1, 90), 0.1) : any().getShape();
            double range = range();
            Hit hit = all.shapeCast(like, x, y, angle, dx, dy, range, null);
            assertThat(cells.shapeCast(like, x, y, angle, dx, dy, range, null)).isEqualTo(hit);
            assertThat(usual.shapeCast(like, x, y, angle, dx, dy, range, null)).isEqualTo(hit);
            assertThat(cells.shapeCast(like, x, y, angle, dx, dy, range, b -> b.index() % 3 == 0))
                    .isEqualTo(all.shapeCast(like, x, y, angle, dx, dy, range, b -> b.index() % 3 == 0));
            List<Hit> every = all.shapeCastAll(like, x, y, angle, dx, dy, range, null);
            assertThat(cells.shapeCastAll(like, x, y, angle, dx, dy, range, null)).isEqualTo(every);
            assertThat(hit).isEqualTo(every.isEmpty() ? null : every.get(0));
            Body body = any();
            assertThat(cells.shapeCast(body, dx, dy, range, null)).isEqualTo(all.shapeCast(body, dx, dy, range, null));
            hits += every.size();
        }
        return hits;
    }

    private int comparePlaces(int count) {
        int found = 0;
        for (int k = 0; k < count; k++) {
            double x = start(true);
            double y = start(false);
            double d = random.nextInt(5) == 0 ? 0 : random.nextDouble(k % 7 == 0 ? 100 : 4);
            List<Body> near = all.within(x, y, d, null);
            found += near.size();
            assertThat(cells.within(x, y, d, null)).isEqualTo(near);
            assertThat(usual.within(x, y, d, null)).isEqualTo(near);
            assertThat(cells.inBox(x, y, x + d, y + 2, null)).isEqualTo(all.inBox(x, y, x + d, y + 2, null));
            Body like = any();
            assertThat(cells.overlapping(like.getShape(), x, y, d, null)).isEqualTo(all.overlapping(like.getShape(), x, y, d, null));
            assertThat(usual.overlapping(like, null)).isEqualTo(all.overlapping(like, null));
            int many = random.nextInt(k % 9 == 0 ? 300 : 12);
            assertThat(cells.nearest(x, y, many, null)).isEqualTo(all.nearest(x, y, many, null));
            assertThat(cells.nearest(x, y, 3, b -> b.index() % 9 == 0))
                    .isEqualTo(all.nearest(x, y, 3, b -> b.index() % 9 == 0));
            assertThat(cells.visible(x, y, 0.3, 1, 3 * d, null)).isEqualTo(all.visible(x, y, 0.3, 1, 3 * d, null));
        }
        return found;
    }

    @ParameterizedTest
    @EnumSource(Scene.class)
    void theAnswersAreTheSame(Scene scene) {
        scatter(scene, 196);
        assertThat(compareRays(3000)).isGreaterThan(1000);
        assertThat(comparePlaces(500)).isGreaterThan(100);
        assertThat(compareSweeps(1000)).isGreaterThan(1000);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 31, 33, 34, 1000})
    void theyAreTheSameForAnyNumberOfBodies(int count) {
        scatter(Scene.CROWD, count);
        compareRays(300);
        comparePlaces(100);
        compareSweeps(100);
    }

    /** Bodies that touch a border of cells to within rounding, and rays along it. */
    @ParameterizedTest
    @EnumSource(names = {"CROWD", "FAR"})
    void bordersOfCellsHaveNoGaps(Scene scene) {
        scatter(scene, 640);
        List<Body> bodies = engine.bodies();
        int hits = 0;
        for (int k = 0; k < 4000; k++) {
            cells.rayCast(0, 0, 1, 0, 1, null);
            Cells grid = cells.cells;
            int sampled = 10; // the others do not shift the grid
            Body body = bodies.get(sampled * random.nextInt(64) + 1 + random.nextInt(sampled - 1));
            double extent = body.getShape().radius();
            if (extent == 0) {
                extent = -body.getShape().vertexY(0);
                for (int v = 1; v < body.getShape().vertexCount(); v++) {
                    extent = Math.max(extent, -body.getShape().vertexY(v));
                }
            }
            double border = grid.ys.line(1 + random.nextInt(grid.rows - 1));
            double y = border + extent + random.nextInt(-4, 5) * Math.ulp(border);
            double old = body.getY();
            body.at(body.getX(), y, 0);
            body.state().placedAll(); // so that the grid is laid anew
            double x = body.getX() - random.nextDouble(200);
            double from = border + random.nextInt(-1, 2) * Math.ulp(border);
            double slope = random.nextInt(-2, 3) * 1e-17;
            Hit hit = all.rayCast(x, from, 1, slope, 1000, b -> b == body);
            hits += hit == null ? 0 : 1;
            assertThat(cells.rayCast(x, from, 1, slope, 1000, b -> b == body)).isEqualTo(hit);
            assertThat(cells.rayCast(x, from, 1, slope, 1000, null)).isEqualTo(all.rayCast(x, from, 1, slope, 1000, null));
            double away = 15 * (Math.abs(grid.xs.low) + Math.abs(grid.ys.low));
            double over = from - body.getY() + body.getY();
            hit = all.rayCast(body.getX() - away, over - away * 1e-3, 1, 1e-3, 2 * away, b -> b == body);
            assertThat(cells.rayCast(body.getX() - away, over - away * 1e-3, 1, 1e-3, 2 * away, b -> b == body)).isEqualTo(hit);
            assertThat(cells.within(body.getX(), from - 1, 1, null)).isEqualTo(all.within(body.getX(), from - 1, 1, null));
            assertThat(cells.inBox(x, from - 1, x + 200, from, null)).isEqualTo(all.inBox(x, from - 1, x + 200, from, null));
            Shape slab = new Rectangle(0.5, 2);
            assertThat(cells.shapeCast(slab, x, from - 1, 0, 1, slope, 1000, b -> b == body)).isEqualTo(all.shapeCast(slab, x, from - 1, 0, 1, slope, 1000, b -> b == body));
            body.setPosition(body.getX(), old);
        }
        assertThat(hits).isBetween(500, 3500);
    }

    @Test
    void whatMovesComesAndGoesIsNoticed() {
        scatter(Scene.CROWD, 150);
        List<Body> gone = new ArrayList<>();
        for (int k = 0; k < 600; k++) {
            int changes = random.nextInt(10) == 0 ? 100 : random.nextInt(3);
            for (int c = 0; c < changes; c++) {
                switch (random.nextInt(5)) {
                    case 0 -> any().setPosition(random.nextDouble(-30, 30), random.nextDouble(-30, 30));
                    case 1 -> any().setAngle(random.nextDouble(-4, 4));
                    case 2 -> engine.add(gone.isEmpty() ? make(Scene.SIZES, k) : gone.remove(gone.size() - 1));
                    case 3 -> {
                        Body body = any();
                        engine.remove(body);
                        gone.add(body);
                    }
                    default -> any().addForce(0.1, 0);
                }
            }
            compareRays(random.nextInt(12));
            comparePlaces(random.nextInt(4));
            compareSweeps(random.nextInt(4));
        }
    }

    @Test
    void stepsAreNoticedAndQuestionsWithinThem() {
        scatter(Scene.GRID, 196);
        for (Body body : engine.bodies()) {
            body.setVelocity(random.nextDouble(-1, 1), random.nextDouble(-1, 1));
        }
        engine.setTimeStep(0.1);
        engine.addListener(new CollisionListener() {
            @Override
            public void collided(Contact contact) {
                compareRays(1);
                contact.a().setPosition(contact.a().getX(), contact.a().getY());
                compareRays(1);
                compareSweeps(1);
            }
        });
        for (int k = 0; k < 60; k++) {
            compareRays(k % 20);
            comparePlaces(k % 5);
            engine.step();
        }
        assertThat(engine.getImpacts()).isGreaterThan(50);
    }

    @Test
    void anAssemblyIsNoticed() {
        scatter(Scene.CROWD, 50);
        Body a = engine.add(new Body(new Rectangle(1, 3)).at(60, 0));
        Body b = engine.add(new Body(new Rectangle(1, 3)).at(60, 4));
        PinJoint pin = new PinJoint(a, b, 60, 2);
        b.setPosition(-60, 5);
        compareRays(20);
        engine.assemble(pin);
        Hit hit = cells.rayCast(b.getX(), b.getY() + 50, 0, -1, 100, null);
        assertThat(hit.body()).isEqualTo(b);
        assertThat(hit).isEqualTo(all.rayCast(b.getX(), b.getY() + 50, 0, -1, 100, null));
        compareRays(200);
    }

    @Test
    void aFilterMayAskItself() {
        scatter(Scene.CROWD, 150);
        for (int k = 0; k < 100; k++) {
            double x = start(true);
            double y = start(false);
            for (Queries outer : List.of(cells, usual)) {
                assertThat(outer.rayCast(x, y, 1, 0.3, 50, b -> outer.within(b.getX(), b.getY(), 2, null).size() > 2))
                        .isEqualTo(all.rayCast(x, y, 1, 0.3, 50, b -> all.within(b.getX(), b.getY(), 2, null).size() > 2));
                assertThat(outer.shapeCast(new Circle(1), x, y, 0, 1, 0.3, 50, b -> outer.shapeCast(b, 0, 1, 1, null) != null))
                        .isEqualTo(all.shapeCast(new Circle(1), x, y, 0, 1, 0.3, 50, b -> all.shapeCast(b, 0, 1, 1, null) != null));
            }
        }
    }

    @Test
    void aQuestionThatAFilterEndedDoesNoHarm() {
        scatter(Scene.CROWD, 150);
        for (int k = 0; k < 20; k++) {
            try {
                cells.nearest(start(true), start(false), 3, b -> {
                    throw new IllegalStateException();
                });
            } catch (IllegalStateException expected) {
                compareRays(3);
                comparePlaces(2);
            }
        }
    }

    @Test
    void questionsWithAnswersToUseAgainAllocateNothing() {
        scatter(Scene.CROWD, 400);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        RayHit hit = new RayHit();
        List<Body> found = new ArrayList<>(500);
        double[] fan = new double[20];
        Shape shape = new Compound(Compound.box(0, 0, 4, 1), Compound.disc(0, 2, 1));
        for (Queries ask : List.of(all, cells, usual)) {
            long least = Long.MAX_VALUE;
            for (int window = 0; window < 40; window++) {
                long before = threads.getCurrentThreadAllocatedBytes();
                for (int k = 0; k < 100; k++) {
                    double x = 0.4 * k - 20;
                    ask.rayCast(x, 3, 1, 0.2, 100, null, hit);
                    found.clear();
                    ask.within(x, 3, 5, null, found);
                    ask.inBox(x, 3, x + 5, 8, null, found);
                    ask.nearest(x, 3, 5, null, found);
                    ask.overlapping(shape, x, 3, 0.1 * k, null, found);
                    ask.shapeCast(shape, x, 3, 0.1 * k, 1, 0.1, 100, null, hit);
                    ask.fan(x, 3, 0, 6, 20, null, fan);
                }
                least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
            }
            assertThat(least).isZero();
        }
    }

    @Test
    void answersToUseAgainSayTheSame() {
        scatter(Scene.CROWD, 100);
        RayHit into = new RayHit();
        for (int k = 0; k < 200; k++) {
            double x = start(true);
            double y = start(false);
            Hit hit = cells.rayCast(x, y, 1, 2, 15, null);
            assertThat(cells.rayCast(x, y, 1, 2, 15, null, into)).isEqualTo(hit != null);
            if (hit == null) {
                assertThat(into.body()).isNull();
                assertThat(into.distance()).isEqualTo(15);
            } else {
                assertThat(new Hit(into.body(), into.x(), into.y(), into.nx(), into.ny(), into.distance())).isEqualTo(hit);
            }
            hit = cells.shapeCast(new Rectangle(1, 2), x, y, 0.2, 1, 2, 15, null);
            assertThat(cells.shapeCast(new Rectangle(1, 2), x, y, 0.2, 1, 2, 15, null, into)).isEqualTo(hit != null);
            assertThat(into.body()).isEqualTo(hit == null ? null : hit.body());
            assertThat(into.distance()).isEqualTo(hit == null ? 15 : hit.distance());
        }
    }

    @Test
    void laysTheGridOnlyWhenItPays() {
        scatter(Scene.CROWD, 100);
        for (int k = 1; k < Cells.LAYING; k++) {
            assertThat(usual.cells.columns).isZero();
            usual.rayCast(0, 0, 1, 0, 5, null);
        }
        assertThat(usual.cells.columns).isZero();
        usual.rayCast(0, 0, 1, 0, 5, null);
        assertThat(usual.cells.columns).isGreaterThan(3);
    }

    /** Of bodies in villages far from one another each shares its cell with few, though all of a village would be in one of even cells. */
    @ParameterizedTest
    @ValueSource(ints = {700, 7000})
    void villagesAreNotInOneCell(int n) {
        scatter(Scene.VILLAGES, n);
        cells.rayCast(0, 0, 1, 1, 10, null);
        Cells laid = cells.cells;
        long sum = 0;
        double squares = 0;
        for (int c = 0; c < laid.columns * laid.rows; c++) {
            long in = laid.first[c + 1] - laid.first[c];
            sum += in;
            squares += in * in;
        }
        double bodiesUnder = n / 7.0 * 2.2 / 64; // bodies over an area of one, in a village
        assertThat(squares / sum).isLessThan(30 + 10 * bodiesUnder);
    }
}
