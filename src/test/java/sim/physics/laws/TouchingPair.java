// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import java.util.Arrays;
import java.util.SplittableRandom;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Shape;

/** Two random bodies that just touch in a given way and approach: an impact that is about to happen. */
final class TouchingPair {
    /** How they touch. */
    enum Kind {
        CIRCLE_CIRCLE,
        CORNER_EDGE,
        PARALLEL_EDGES,
        CIRCLE_CORNER,
        CIRCLE_EDGE
    }

    /** Body a, the one whose surface has the normal, and body b. */
    final Body a;

    final Body b;

    /** Unit normal from a to b. */
    double nx;

    double ny;

    /** The points where they touch: one, or the two ends of a stretch. */
    double[][] points;

    private final SplittableRandom random;

    TouchingPair(SplittableRandom random, Kind kind, boolean fixed) {
        this.random = random;
        boolean roundA = kind == Kind.CIRCLE_CIRCLE;
        boolean roundB = roundA || kind == Kind.CIRCLE_CORNER || kind == Kind.CIRCLE_EDGE;
        Shape shapeA = roundA ? new Circle(size()) : polygon();
        Shape shapeB = roundB ? new Circle(size()) : polygon();
        a = fixed ? Body.fixed(shapeA) : new Body(shapeA);
        a.at(10 * signed(), 10 * signed(), 4 * signed());
        b = new Body(shapeB);
        b.setAngle(4 * signed());
        switch (kind) {
            case CIRCLE_CIRCLE -> onCircle();
            case CIRCLE_CORNER -> onCorner();
            default -> onEdge(kind);
        }
        setMassesAndVelocities(fixed);
    }

    private double signed() {
        return 2 * random.nextDouble() - 1;
    }

    private double size() {
        return StrictMath.pow(10, signed());
    }

    /** A convex polygon with 3 to 10 vertices on an ellipse. */
    private Shape polygon() {
        int n = 3 + random.nextInt(8);
        double width = size();
        double height = width * (0.2 + random.nextDouble());
        double[] angles = new double[n];
        for (int k = 0; k < n; k++) {
            angles[k] = 2 * Math.PI * (k + 0.7 * random.nextDouble()) / n;
        }
        double[] xy = new double[2 * n];
        Arrays.setAll(xy, k -> k % 2 == 0 ? width * StrictMath.cos(angles[k / 2]) : height * StrictMath.sin(angles[k / 2]));
        return new Polygon(xy);
    }

    private void onCircle() {
        double angle = 4 * signed();
        nx = StrictMath.cos(angle);
        ny = StrictMath.sin(angle);
        double r = a.getShape().radius();
        double distance = r + b.getShape().radius();
        b.setPosition(a.getX() + distance * nx, a.getY() + distance * ny);
        points = new double[][] {{a.getX() + r * nx, a.getY() + r * ny}};
    }

    /** A circle on a corner of a, in a direction between the normals of the edges that meet there. */
    private void onCorner() {
        int i = random.nextInt(a.getShape().vertexCount());
        double[] n = between(a, i);
        nx = n[0];
        ny = n[1];
        double[] p = world(a, i);
        double r = b.getShape().radius();
        b.setPosition(p[0] + r * nx, p[1] + r * ny);
        points = new double[][] {p};
    }

    private void onEdge(Kind kind) {
        int i = random.nextInt(a.getShape().vertexCount());
        double[] n = normal(a, i);
        nx = n[0];
        ny = n[1];
        double[] from = world(a, i);
        double[] to = world(a, (i + 1) % a.getShape().vertexCount());
        double share = 0.1 + 0.8 * random.nextDouble();
        double[] p = {from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])};
        points = new double[][] {p};
        if (kind == Kind.CIRCLE_EDGE) {
            double r = b.getShape().radius();
            b.setPosition(p[0] + r * nx, p[1] + r * ny);
            return;
        }
        int j = random.nextInt(b.getShape().vertexCount());
        double[] m = kind == Kind.CORNER_EDGE ? between(b, j) : normal(b, j);
        b.setAngle(b.getAngle() + StrictMath.atan2(-ny, -nx) - StrictMath.atan2(m[1], m[0]));
        double[] q = world(b, j);
        b.setPosition(b.getX() + p[0] - q[0], b.getY() + p[1] - q[1]);
        if (kind == Kind.PARALLEL_EDGES) {
            stretch(from, to, world(b, j), world(b, (j + 1) % b.getShape().vertexCount()));
        }
    }

    /** The ends of the stretch that two edges on one line have in common; b's edge runs the other way. */
    private void stretch(double[] from, double[] to, double[] start, double[] end) {
        double tx = -ny;
        double ty = nx;
        double edge = along(from, to, tx, ty);
        double first = Math.max(0, along(from, end, tx, ty));
        double last = Math.min(edge, along(from, start, tx, ty));
        points = new double[][] {
            {from[0] + first * tx, from[1] + first * ty}, {from[0] + last * tx, from[1] + last * ty}
        };
    }

    private static double along(double[] from, double[] to, double tx, double ty) {
        return (to[0] - from[0]) * tx + (to[1] - from[1]) * ty;
    }

    private static double[] world(Body body, int vertex) {
        double cos = StrictMath.cos(body.getAngle());
        double sin = StrictMath.sin(body.getAngle());
        double x = body.getShape().vertexX(vertex);
        double y = body.getShape().vertexY(vertex);
        return new double[] {body.getX() + cos * x - sin * y, body.getY() + sin * x + cos * y};
    }

    private static double[] normal(Body body, int edge) {
        double[] p = world(body, edge);
        double[] q = world(body, (edge + 1) % body.getShape().vertexCount());
        double length = Math.hypot(q[0] - p[0], q[1] - p[1]);
        return new double[] {(q[1] - p[1]) / length, (p[0] - q[0]) / length};
    }

    /** A direction well inside the cone of normals of a vertex. */
    private double[] between(Body body, int vertex) {
        int n = body.getShape().vertexCount();
        double[] in = normal(body, (vertex + n - 1) % n);
        double[] out = normal(body, vertex);
        double share = 0.1 + 0.8 * random.nextDouble();
        double x = share * in[0] + (1 - share) * out[0];
        double y = share * in[1] + (1 - share) * out[1];
        double length = Math.hypot(x, y);
        return new double[] {x / length, y / length};
    }

    /** Masses over twelve decades; velocities over some, turned round if the bodies part, drawn again if they slide. */
    private void setMassesAndVelocities(boolean fixed) {
        b.setMass(StrictMath.pow(10, 6 * signed()));
        if (!fixed) {
            a.setMass(StrictMath.pow(10, 6 * signed()));
        }
        double scale;
        do {
            scale = 0;
            for (Body body : new Body[] {a, b}) {
                double speed = body.isFixed() ? 0 : size();
                double spin = speed / body.getShape().boundingRadius();
                body.moving(speed * signed(), speed * signed(), spin * signed());
                scale = Math.max(scale, speed);
            }
            if (mean() > 0) {
                a.moving(-a.getVelocityX(), -a.getVelocityY(), -a.getAngularVelocity());
                b.moving(-b.getVelocityX(), -b.getVelocityY(), -b.getAngularVelocity());
            }
        } while (mean() > -1e-3 * scale);
    }

    private double mean() {
        double sum = 0;
        for (double[] p : points) {
            sum += approach(p[0], p[1]);
        }
        return sum / points.length;
    }

    /** Velocity of b's point relative to a's along the normal. */
    private double approach(double x, double y) {
        double vx = b.getVelocityX() - b.getAngularVelocity() * (y - b.getY())
                - (a.getVelocityX() - a.getAngularVelocity() * (y - a.getY()));
        double vy = b.getVelocityY() + b.getAngularVelocity() * (x - b.getX())
                - (a.getVelocityY() + a.getAngularVelocity() * (x - a.getX()));
        return vx * nx + vy * ny;
    }
}
