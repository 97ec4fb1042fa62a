// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import sim.physics.PhysicsEngine;
import sim.physics.collision.narrow.Distance;
import sim.physics.motion.Body;
import sim.physics.query.Hit;
import sim.physics.query.Queries;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Compares what is asked about places with what all bodies one by one say. Lengths are in units of the world. */
final class QueryCheck {
    private static final double ROUNDING = 1e-9;
    private static final int MARKS = 50;

    private final Queries queries;
    private final List<Body> all;
    private final double unit;

    private QueryCheck(PhysicsEngine engine, double unit) {
        queries = engine.queries();
        all = engine.bodies();
        this.unit = unit;
    }

    static void check(PhysicsEngine engine, long seed, double half, double unit) {
        QueryCheck check = new QueryCheck(engine, unit);
        SplittableRandom r = new SplittableRandom(seed);
        for (int k = 0; k < 14; k++) {
            double x = half * unit * (2 * r.nextDouble() - 1);
            double y = half * unit * (2 * r.nextDouble() - 1);
            double angle = 6 * r.nextDouble();
            double way = 3 * unit * r.nextDouble();
            check.within(x, y, way);
            check.overlapping(k % 2 == 0 ? new Rectangle(way + 0.1 * unit, 0.5 * unit) : new Circle(0.5 * way + 0.1 * unit), x, y, angle);
            check.ray(x, y, StrictMath.cos(angle), StrictMath.sin(angle));
            check.sweep(k % 2 == 0 ? new Rectangle(0.8 * unit, 0.3 * unit) : new Circle(0.4 * unit), x, y, angle, StrictMath.cos(way), StrictMath.sin(way));
            check.nearest(x, y);
        }
    }

    private static void require(boolean is, String what, Object about) {
        if (!is) {
            throw new AssertionError(what + ": " + about);
        }
    }

    private void within(double x, double y, double way) {
        Set<Body> found = new HashSet<>(queries.within(x, y, way, null));
        for (Body b : all) {
            double gap = queries.distance(b, x, y);
            require(gap <= way == found.contains(b) || Math.abs(gap - way) <= ROUNDING * unit, "within", b);
        }
    }

    private void overlapping(Shape shape, double x, double y, double angle) {
        Set<Body> found = new HashSet<>(queries.overlapping(shape, x, y, angle, null));
        Body probe = new Body(shape).at(x, y, angle);
        Distance distance = new Distance();
        for (Body b : all) {
            double gap = distance.between(probe, b);
            require(gap <= 0 == found.contains(b) || Math.abs(gap) <= ROUNDING * unit, "overlapping", b);
        }
    }

    private void ray(double x, double y, double cos, double sin) {
        Hit first = queries.rayCast(x, y, cos, sin, 20 * unit, null);
        List<Hit> hits = queries.rayCastAll(x, y, cos, sin, 20 * unit, null);
        require(first == null == hits.isEmpty(), "a ray's first hit and all of them", hits);
        for (Hit hit : hits) {
            double gap = queries.distance(hit.body(), hit.x(), hit.y());
            require(hit.distance() == 0 || Math.abs(gap) <= 10 * ROUNDING * unit, "a hit off the surface", hit);
        }
        if (first == null) {
            return;
        }
        require(Math.abs(first.distance() - hits.get(0).distance()) <= ROUNDING * unit, "a ray's first hit", hits);
        for (int k = 0; k < MARKS; k++) { // nobody is on its way to there
            double t = first.distance() * (k + 0.5) / MARKS - 1e-7 * unit;
            for (Body b : all) {
                boolean isIn = t > 0 && queries.distance(b, x + t * cos, y + t * sin) < -1e-7 * unit && queries.distance(b, x, y) > 0;
                require(!isIn, "a ray has missed", b);
            }
        }
    }

    private void sweep(Shape shape, double x, double y, double angle, double cos, double sin) {
        Hit first = queries.shapeCast(shape, x, y, angle, cos, sin, 20 * unit, null);
        List<Hit> hits = queries.shapeCastAll(shape, x, y, angle, cos, sin, 20 * unit, null);
        require(first == null ? hits.isEmpty() : first.equals(hits.get(0)), "the first that a shape meets and all of them", hits);
        double clear = first == null ? 20 * unit : first.distance();
        Distance distance = new Distance();
        Body probe = new Body(shape);
        for (int k = 0; k < MARKS && clear > 0; k++) { // it overlaps nobody on its way
            double t = clear * k / MARKS;
            probe.at(x + t * cos, y + t * sin, angle);
            for (Body b : queries.overlapping(probe, null)) {
                require(distance.between(probe, b) > -1e-7 * unit, "a shape has missed", b);
            }
        }
        for (Hit hit : hits) {
            probe.at(x + hit.distance() * cos, y + hit.distance() * sin, angle);
            double gap = distance.between(probe, hit.body());
            require(hit.distance() == 0 ? gap <= ROUNDING * unit : Math.abs(gap) <= 10 * ROUNDING * unit, "a shape off the surface", hit);
        }
    }

    private void nearest(double x, double y) {
        List<Body> found = queries.nearest(x, y, 3, null);
        require(found.size() == Math.min(3, all.size()), "the number of the nearest", found);
        double last = Double.NEGATIVE_INFINITY;
        for (Body b : found) {
            double gap = queries.distance(b, x, y);
            require(gap >= last - ROUNDING * unit, "the order of the nearest", found);
            last = gap;
        }
        for (Body b : all) {
            require(found.contains(b) || queries.distance(b, x, y) >= last - ROUNDING * unit, "one of the nearest", b);
        }
    }
}
