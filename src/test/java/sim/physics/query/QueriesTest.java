// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.collision.narrow.Distance;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Questions, against shapes that only say whether they contain a point. */
class QueriesTest {
    private final SplittableRandom random = new SplittableRandom(5);
    private final PhysicsEngine engine = new PhysicsEngine();

    private void scatter(int count) {
        for (int k = 0; k < count; k++) {
            int kind = random.nextInt(3);
            Body body = engine.add(new Body(
                            kind == 0 ? new Circle(random.nextDouble(0.3, 1.5))
                            : kind == 1 ? new Rectangle(random.nextDouble(0.3, 3), random.nextDouble(0.3, 2))
                            : Polygon.regular(3 + random.nextInt(5), random.nextDouble(0.4, 1.5)))
                    .at(random.nextDouble(-20, 20), random.nextDouble(-20, 20)));
            body.setAngle(random.nextDouble(-4, 4));
        }
    }

    private static boolean contains(Body body, double x, double y) {
        double cos = StrictMath.cos(body.getAngle());
        double sin = StrictMath.sin(body.getAngle());
        double dx = x - body.getX();
        double dy = y - body.getY();
        return body.getShape().contains(cos * dx + sin * dy, cos * dy - sin * dx);
    }

    /** The first point inside a body along a ray, by small steps and bisection. */
    private static double walk(Body body, double x, double y, double dx, double dy, double range) {
        double last = 0;
        for (double t = 0; t <= range; t += 0.01) {
            if (contains(body, x + t * dx, y + t * dy)) {
                double high = t;
                for (int k = 0; k < 60 && t > 0; k++) {
                    double middle = 0.5 * (last + high);
                    if (contains(body, x + middle * dx, y + middle * dy)) {
                        high = middle;
                    } else {
                        last = middle;
                    }
                }
                return high;
            }
            last = t;
        }
        return Double.POSITIVE_INFINITY;
    }

    @Test
    void raysEnterBodiesWhereAWalkAlongThemDoes() {
        scatter(60);
        int hits = 0;
        for (int k = 0; k < 100; k++) {
            double x = random.nextDouble(-25, 25);
            double y = random.nextDouble(-25, 25);
            double angle = random.nextDouble(-4, 4);
            double dx = StrictMath.cos(angle);
            double dy = StrictMath.sin(angle);
            List<Hit> all = engine.queries().rayCastAll(x, y, 3 * dx, 3 * dy, 30, null);
            List<Body> hit = new ArrayList<>();
            for (Hit h : all) {
                hit.add(h.body());
                double walked = walk(h.body(), x, y, dx, dy, 30);
                if (walked < Double.POSITIVE_INFINITY) { // it may step over what it grazes
                    assertThat(h.distance()).isCloseTo(walked, within(1e-12));
                }
                assertThat(h.nx() * dx + h.ny() * dy).isNegative();
                assertThat(h.nx() * h.nx() + h.ny() * h.ny()).isCloseTo(1, within(1e-14));
                assertThat(StrictMath.hypot(h.x() - x - h.distance() * dx, h.y() - y - h.distance() * dy)).isLessThan(1e-13);
            }
            for (Body body : engine.bodies()) {
                if (walk(body, x, y, dx, dy, 30) < Double.POSITIVE_INFINITY) {
                    assertThat(hit).contains(body);
                }
            }
            Hit first = engine.queries().rayCast(x, y, dx, dy, 30, null);
            assertThat(first == null ? null : first.body()).isEqualTo(hit.isEmpty() ? null : hit.get(0));
            hits += hit.size();
        }
        assertThat(hits).isGreaterThan(100);
    }

    @Test
    void aRayThatStartsInsideIsAtDistanceZeroUnlessTheBodyIsLeftOut() {
        Body own = engine.add(new Body(new Circle(1)));
        Body other = engine.add(new Body(new Rectangle(2, 2)).at(5, 0));
        assertThat(engine.queries().rayCast(0, 0, 1, 0, 10, null)).isEqualTo(new Hit(own, 0, 0, -1, 0, 0));
        assertThat(engine.queries().rayCast(0, 0, 1, 0, 10, b -> b != own)).isEqualTo(new Hit(other, 4, 0, -1, 0, 4));
        assertThat(engine.queries().rayCast(0, 0, 1, 0, 3.99, b -> b != own)).isNull();
        double[] fan = new double[5];
        engine.queries().fan(0, 0, 0, 2 * Math.PI, 10, b -> b != own, fan);
        assertThat(fan).containsExactly(new double[] {4, 10, 10, 10, 4}, within(1e-12));
    }

    @Test
    void distancesAndNeighboursAreThoseOfAllBodies() {
        scatter(80);
        for (int k = 0; k < 50; k++) {
            double x = random.nextDouble(-22, 22);
            double y = random.nextDouble(-22, 22);
            Queries ask = engine.queries();
            List<Body> sorted = engine.bodies();
            sorted.sort(Comparator.comparingDouble(b -> ask.distance(b, x, y)));
            assertThat(ask.nearest(x, y, 7, null)).isEqualTo(sorted.subList(0, 7));
            double reach = random.nextDouble(0, 6);
            List<Body> near = new ArrayList<>(engine.bodies());
            near.removeIf(b -> ask.distance(b, x, y) > reach);
            assertThat(ask.within(x, y, reach, null)).isEqualTo(near);
            for (Body body : engine.bodies()) {
                assertThat(ask.distance(body, x, y) == 0).isEqualTo(contains(body, x, y));
            }
            double d = ask.distance(sorted.get(20), x, y); // no point nearer than that is inside, some point a little farther is
            boolean inside = false;
            for (int a = 0; a < 4000; a++) {
                double cos = StrictMath.cos(a * Math.PI / 2000);
                double sin = StrictMath.sin(a * Math.PI / 2000);
                double less = d * (1 - 1e-9);
                double more = d * (1 + 1e-2) + 1e-2;
                assertThat(contains(sorted.get(20), x + less * cos, y + less * sin)).isFalse();
                inside |= contains(sorted.get(20), x + more * cos, y + more * sin);
            }
            assertThat(inside).isTrue();
        }
    }

    @Test
    void boxesHoldWhatHasAPointInThem() {
        scatter(60);
        int found = 0;
        for (int k = 0; k < 40; k++) {
            double x = random.nextDouble(-20, 20);
            double y = random.nextDouble(-20, 20);
            double w = random.nextDouble(0, 4);
            double h = random.nextDouble(0, 4);
            List<Body> in = engine.queries().inBox(x, y, x + w, y + h, null);
            found += in.size();
            for (Body body : engine.bodies()) {
                boolean some = false;
                for (int m = 0; m < 60 * 60; m++) {
                    some |= contains(body, x + w * (m % 60) / 59, y + h * (m / 60) / 59);
                }
                if (some) {
                    assertThat(in).contains(body);
                } else if (in.contains(body)) { // met between the points of the grid, if at all
                    double near = 0.5 * StrictMath.hypot(w / 59, h / 59);
                    double least = Double.POSITIVE_INFINITY;
                    for (int m = 0; m < 60 * 60; m++) {
                        least = Math.min(least, engine.queries().distance(body, x + w * (m % 60) / 59, y + h * (m / 60) / 59));
                    }
                    assertThat(least).isLessThanOrEqualTo(near);
                }
            }
        }
        assertThat(found).isGreaterThan(10);
    }

    /** Independent of it is the narrow phase: a shape meets what it has no distance from. */
    @Test
    void shapesMeetWhatTheyAreNotApartFrom() {
        scatter(40);
        Compound cup = new Compound(Compound.box(0, 0, 3, 0.5), Compound.box(-1.25, 0.75, 0.5, 1), Compound.box(1.25, 0.75, 0.5, 1));
        Compound robot = new Compound(Compound.disc(0, 0, 0.6), Compound.box(0.9, 0.35, 0.8, 0.15), Compound.box(0.9, -0.35, 0.8, 0.15));
        for (int k = 0; k < 20; k++) {
            engine.add(new Body(k % 2 == 0 ? cup : robot)
                    .at(random.nextDouble(-20, 20), random.nextDouble(-20, 20), random.nextDouble(-4, 4)));
        }
        Distance distance = new Distance();
        Shape[] shapes = {new Circle(2), new Rectangle(4, 0.5), Polygon.regular(5, 1.5), cup, robot};
        int found = 0;
        for (int k = 0; k < 500; k++) {
            Body probe = new Body(shapes[k % shapes.length])
                    .at(random.nextDouble(-20, 20), random.nextDouble(-20, 20), random.nextDouble(-4, 4));
            List<Body> met = engine.queries().overlapping(probe, null);
            assertThat(engine.queries().overlapping(probe.getShape(), probe.getX(), probe.getY(), probe.getAngle(), null)).isEqualTo(met);
            found += met.size();
            for (Body body : engine.bodies()) {
                assertThat(met.contains(body)).isEqualTo(distance.between(probe, body) <= 0);
            }
        }
        assertThat(found).isGreaterThan(100);
    }

    @Test
    void whatTouchesMeetsAndABodyDoesNotMeetItself() {
        Body box = engine.add(new Body(new Rectangle(2, 2)).at(0, 0));
        Body disc = engine.add(new Body(new Circle(1)).at(2, 0));
        Queries ask = engine.queries();
        assertThat(ask.overlapping(box, null)).containsExactly(disc);
        assertThat(ask.overlapping(box, b -> b != disc)).isEmpty();
        assertThat(ask.overlapping(new Rectangle(2, 2), 0, 2, 0, null)).containsExactly(box);
        assertThat(ask.overlapping(new Rectangle(2, 2), 0, Math.nextUp(2.0), 0, null)).isEmpty();
        assertThat(ask.overlapping(new Circle(1), 2, 2, 0, null)).containsExactly(disc);
        assertThat(ask.overlapping(new Circle(1), -2, 0, 0, null)).containsExactly(box);
    }

    @Test
    void whatStandsBehindIsHidden() {
        Body near = engine.add(new Body(new Circle(1)).at(5, 0));
        Body hidden = engine.add(new Body(new Circle(1)).at(9, 0.1));
        Body beside = engine.add(new Body(new Circle(0.5)).at(6, 3));
        Body behind = engine.add(new Body(new Circle(1)).at(-5, 0));
        assertThat(engine.queries().visible(0, 0, 0, 0.6, 20, null)).containsExactly(near, beside);
        assertThat(engine.queries().visible(0, 0, 0, 0.1, 20, b -> b != near)).containsExactly(hidden);
        assertThat(engine.queries().visible(0, 0, 0, Math.PI, 20, null)).containsExactly(near, behind, beside);
        assertThat(engine.queries().visible(0, 0, 0, Math.PI, 5.5, null)).containsExactly(near, behind);
    }

    @Test
    void badQuestionsAreRefused() {
        Queries ask = engine.queries();
        assertThatThrownBy(() -> ask.rayCast(0, 0, 0, 0, 1, null)).hasMessageContaining("direction is (0.0, 0.0)");
        assertThatThrownBy(() -> ask.rayCast(Double.NaN, 0, 1, 0, 1, null)).hasMessageContaining("x is NaN");
        assertThatThrownBy(() -> ask.rayCast(0, 0, 1, 0, -1, null)).hasMessageContaining("range is -1.0");
        assertThatThrownBy(() -> ask.nearest(0, 0, -1, null)).hasMessageContaining("count is -1");
        assertThatThrownBy(() -> ask.inBox(1, 0, 0, 1, null)).hasMessageContaining("highX");
        assertThatThrownBy(() -> ask.overlapping(new Circle(1), 0, 0, Double.NaN, null)).hasMessageContaining("angle is NaN");
        assertThatThrownBy(() -> ask.overlapping(null, 0, 0, 0, null)).isInstanceOf(NullPointerException.class);
        assertThatThrownBy(() -> ask.visible(0, 0, 0, 4, 1, null)).hasMessageContaining("halfAngle is 4.0");
    }

    /** An agent keeps the answer of its sensor, which makes no garbage, and is saved with it. */
    @Test
    void anAnswerThatIsUsedAgainGoesIntoCheckpoints() {
        engine.add(new Body(new Circle(1)).at(5, 0));
        RayHit hit = new RayHit();
        assertThat(engine.queries().rayCast(0, 0, 1, 0, 10, null, hit)).isTrue();
        RayHit copy = Checkpoint.copy(hit);
        assertThat(copy.distance()).isEqualTo(4);
        assertThat(copy.body().getX()).isEqualTo(5);
    }
}
