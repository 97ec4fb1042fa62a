// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import sim.physics.internal.Trig;
import sim.physics.motion.Trajectories;

/**
 * Where two bodies and their vertices are at an instant, and how they move. Coordinates are relative to the centre of
 * body A, so that nothing is lost far from the origin. One object serves all pairs in turn.
 */
final class Pose {

    /** One of the two bodies. */
    static final class Placed {
        private double[] shape;
        private int base;

        /** Number of vertices of the core. */
        int n;

        /** Vertices of the core, relative to the centre of A. */
        double[] vx = new double[8];

        double[] vy = new double[8];

        /** Cosine and sine of the orientation. */
        double cos;

        double sin;

        private final double[] turn = new double[2];

        /** Centre, relative to the centre of A. */
        double cx;

        double cy;


        /** Angular velocity. */
        double omega;

        /** Farthest vertex of the core from the centre. */
        double core;

        /** Bounds of angular speed and acceleration while the trajectories hold. */
        double maxOmega;

        double maxAlpha;

        /** Angular acceleration, where it is constant. */
        double alpha;

        private void load(ShapeTable shapes, int at) {
            double[] values = shapes.data();
            if (shape != values) { // a reference that is written costs more than one that is compared
                shape = values;
            }
            base = at;
            n = (int) shape[base + ShapeTable.COUNT];
            core = shape[base + ShapeTable.CORE];
            if (vx.length < n) {
                vx = new double[n];
                vy = new double[n];
            }
        }

        double rounding() {
            return shape[base + ShapeTable.ROUNDING];
        }

        /** Whether it is a circle that is a whole body: where it touches it is as far from its centre as anywhere. */
        boolean isRound() {
            return shape[base + ShapeTable.ROUND] == 1;
        }

        double bounding() {
            return shape[base + ShapeTable.BOUNDING];
        }

        double normalX(int edge) {
            int o = base + ShapeTable.FIRST + ShapeTable.VERTEX * edge;
            return cos * shape[o + ShapeTable.NX] - sin * shape[o + ShapeTable.NY];
        }

        double normalY(int edge) {
            int o = base + ShapeTable.FIRST + ShapeTable.VERTEX * edge;
            return sin * shape[o + ShapeTable.NX] + cos * shape[o + ShapeTable.NY];
        }

        /** Distance of an edge's line from the centre. */
        double offset(int edge) {
            return shape[base + ShapeTable.FIRST + ShapeTable.VERTEX * edge + ShapeTable.H];
        }

        double length(int edge) {
            return shape[base + ShapeTable.FIRST + ShapeTable.VERTEX * edge + ShapeTable.LENGTH];
        }

        /** How far a vertex of a body is over the line of an edge. */
        double height(int edge, Placed other, int vertex) {
            return (other.vx[vertex] - vx[edge]) * normalX(edge) + (other.vy[vertex] - vy[edge]) * normalY(edge);
        }

        /** Where a vertex of a body is along an edge, from its beginning. */
        double along(int edge, Placed other, int vertex) {
            return (other.vy[vertex] - vy[edge]) * normalX(edge) - (other.vx[vertex] - vx[edge]) * normalY(edge);
        }

        /** Whether a vertex of a body is over an edge, and not beyond its ends. */
        boolean isOver(int edge, Placed other, int vertex) {
            double along = along(edge, other, vertex);
            return along >= 0 && along <= length(edge);
        }

        /** The vertex that is farthest in a direction. */
        int support(double dx, double dy) {
            int best = 0;
            double most = vx[0] * dx + vy[0] * dy;
            for (int k = 1; k < n; k++) {
                double s = vx[k] * dx + vy[k] * dy;
                if (s > most) {
                    most = s;
                    best = k;
                }
            }
            return best;
        }

        private void turnTo(double theta) {
            if (n == 1 && core == 0) {
                vx[0] = cx;
                vy[0] = cy;
                return;
            }
            Trig.sinCos(theta, turn, 0);
            cos = turn[0];
            sin = turn[1];
            for (int k = 0, o = base + ShapeTable.FIRST; k < n; k++, o += ShapeTable.VERTEX) {
                vx[k] = cx + (cos * shape[o] - sin * shape[o + 1]);
                vy[k] = cy + (sin * shape[o] + cos * shape[o + 1]);
            }
        }
    }

    private final ShapeTable shapes;
    private final Trajectories trajectories;
    private double[] m;
    private double[] bends;
    private int bendMask;
    private int oa;
    private int ob;

    /** Part of the step within which a path has its own bounds. */
    private static final double SHORT = 1.0 / 64;

    /** The instant at which the bodies were placed; NaN for none. */
    private double placedAt = Double.NaN;

    final Placed a = new Placed();
    final Placed b = new Placed();

    /** Centre of B relative to the centre of A, and its velocity. */
    double px;

    double py;
    double ux;
    double uy;

    /** Sum of the rounding radii, and of the bounding radii. */
    double rounding;

    double bounding;

    /** Scale of the two bodies, for tolerances on lengths of theirs. */
    double size;

    /** Scale of the rounding of their coordinates, for tolerances on the gap. */
    double extent;

    /** Relative acceleration of the centres: its value where it is constant, and a bound of its size. */
    double ax;

    double ay;
    double maxAcceleration;
    boolean accelerationIsConstant;

    /** Whether both bodies move and spin uniformly. */
    private boolean linear;

    /** Whether both angular accelerations are constant. */
    private boolean spinIsQuadratic;

    /** Whether the bodies lie on one another; to be said of each pair anew. */
    boolean lies;

    Pose(ShapeTable shapes, Trajectories trajectories) {
        this.shapes = shapes;
        this.trajectories = trajectories;
    }

    /** Turns to another pair, of bodies that have one part each. */
    void load(int bodyA, int bodyB) {
        load(bodyA, shapes.base(bodyA), bodyB, shapes.base(bodyB));
    }

    /** Turns to another pair, of parts of two bodies that begin at two places of the table. */
    void load(int bodyA, int partA, int bodyB, int partB) {
        if (m != trajectories.data()) { // see above
            m = trajectories.data();
        }
        if (bends != trajectories.bends()) {
            bends = trajectories.bends();
        }
        bendMask = trajectories.bendMask();
        oa = bodyA * Trajectories.STRIDE;
        ob = bodyB * Trajectories.STRIDE;
        placedAt = Double.NaN;
        lies = false;
        a.load(shapes, partA);
        b.load(shapes, partB);
        rounding = a.rounding() + b.rounding();
        bounding = a.bounding() + b.bounding();
        size = bounding;
        if (trajectories.areStraight()) {
            loadStraight();
        } else {
            loadBends();
        }
    }

    private void loadStraight() {
        a.maxOmega = Math.abs(m[oa + Trajectories.OMEGA]);
        b.maxOmega = Math.abs(m[ob + Trajectories.OMEGA]);
        a.maxAlpha = 0;
        b.maxAlpha = 0;
        a.alpha = 0;
        b.alpha = 0;
        ax = 0;
        ay = 0;
        accelerationIsConstant = true;
        linear = true;
        spinIsQuadratic = true;
        maxAcceleration = 0;
    }

    private void loadBends() {
        double h = trajectories.h();
        bound(a, oa, h);
        bound(b, ob, h);
        ax = 2 * (bends[(ob & bendMask) + Trajectories.AX] - bends[(oa & bendMask) + Trajectories.AX]);
        ay = 2 * (bends[(ob & bendMask) + Trajectories.AY] - bends[(oa & bendMask) + Trajectories.AY]);
        double jerk = Math.abs(bends[(oa & bendMask) + Trajectories.JX]) + Math.abs(bends[(oa & bendMask) + Trajectories.JY])
                + Math.abs(bends[(ob & bendMask) + Trajectories.JX]) + Math.abs(bends[(ob & bendMask) + Trajectories.JY]);
        accelerationIsConstant = jerk == 0;
        linear = isLinear(oa) && isLinear(ob);
        spinIsQuadratic = bends[(oa & bendMask) + Trajectories.JTHETA] == 0 && bends[(ob & bendMask) + Trajectories.JTHETA] == 0;
        maxAcceleration = ax == 0 && ay == 0 ? 0 : Math.sqrt(ax * ax + ay * ay);
        if (!accelerationIsConstant) {
            maxAcceleration += 6 * jerk * h;
        }
    }

    /**
     * Takes note that only instants up to one count. The paths of bodies that are struck again and again, or that joints cannot
     * follow, are short and bend sharply: over the whole step their speeds would be bounded by next to nothing.
     *
     * @return until when the bounds hold
     */
    double until(double end) {
        if (linear) {
            return Double.POSITIVE_INFINITY;
        }
        double h = trajectories.h();
        double restA = rest(oa, end);
        double restB = rest(ob, end);
        if (!(restA < SHORT * h || restB < SHORT * h)) {
            return Double.POSITIVE_INFINITY;
        }
        bound(a, oa, restA);
        bound(b, ob, restB);
        if (!accelerationIsConstant) {
            maxAcceleration = Math.sqrt(ax * ax + ay * ay) + 6 * (jerk(oa) * restA + jerk(ob) * restB);
        }
        return end;
    }

    /** How long a path is followed, if that is known to be shorter than the step. */
    private double rest(int o, double end) {
        boolean isOfThisStep = m[o + Trajectories.STEP] == trajectories.step();
        return isOfThisStep ? Math.min(end - m[o + Trajectories.OFFSET], trajectories.h()) : trajectories.h();
    }

    private double jerk(int o) {
        return Math.abs(bends[(o & bendMask) + Trajectories.JX]) + Math.abs(bends[(o & bendMask) + Trajectories.JY]);
    }

    /** Whether both bodies move and spin uniformly. */
    boolean isLinear() {
        return linear;
    }

    /** Whether all accelerations of both bodies are constant. */
    boolean isQuadratic() {
        return accelerationIsConstant && spinIsQuadratic;
    }

    /** Whether bodies that lie on one another are pushed evenly: they stay where they are on one another, where others part. */
    boolean isPushed() {
        return lies && (a.alpha != 0 || b.alpha != 0);
    }

    private boolean isLinear(int o) {
        return bends[(o & bendMask) + Trajectories.AX] == 0
                && bends[(o & bendMask) + Trajectories.AY] == 0
                && bends[(o & bendMask) + Trajectories.ATHETA] == 0
                && bends[(o & bendMask) + Trajectories.JX] == 0
                && bends[(o & bendMask) + Trajectories.JY] == 0
                && bends[(o & bendMask) + Trajectories.JTHETA] == 0;
    }

    private void bound(Placed body, int o, double h) {
        double alpha = Math.abs(bends[(o & bendMask) + Trajectories.ATHETA]);
        double jerk = Math.abs(bends[(o & bendMask) + Trajectories.JTHETA]);
        body.maxOmega = Math.abs(m[o + Trajectories.OMEGA]);
        body.maxAlpha = 0;
        body.alpha = 2 * bends[(o & bendMask) + Trajectories.ATHETA];
        if (alpha != 0 || jerk != 0) {
            body.maxOmega += h * (2 * alpha + 3 * h * jerk);
            body.maxAlpha = 2 * alpha + 6 * h * jerk;
        }
    }

    /** Whether these two bodies were placed last, at that instant. */
    boolean isOf(int bodyA, int partA, int bodyB, int partB, double tau) {
        return oa == bodyA * Trajectories.STRIDE && ob == bodyB * Trajectories.STRIDE && placedAt == tau && a.base == partA && b.base == partB;
    }

    /** Places both bodies' centres at an instant. */
    void moveTo(double tau) {
        placedAt = tau;
        double step = trajectories.step();
        double h = trajectories.h();
        double da = (step - m[oa + Trajectories.STEP]) * h + (tau - m[oa + Trajectories.OFFSET]);
        double db = (step - m[ob + Trajectories.STEP]) * h + (tau - m[ob + Trajectories.OFFSET]);
        double xa = position(oa, da);
        double ya = position(oa + 1, da);
        double xb = position(ob, db);
        double yb = position(ob + 1, db);
        px = xb - xa;
        py = yb - ya;
        ux = velocity(ob, db) - velocity(oa, da);
        uy = velocity(ob + 1, db) - velocity(oa + 1, da);
        extent = Math.abs(xa) + Math.abs(ya) + Math.abs(xb) + Math.abs(yb) + bounding;
        b.cx = px;
        b.cy = py;
        a.omega = velocity(oa + 2, da);
        b.omega = velocity(ob + 2, db);
        thetaA = position(oa + 2, da);
        thetaB = position(ob + 2, db);
    }

    private double thetaA;
    private double thetaB;

    /** Places both bodies' vertices too; after {@link #moveTo}. */
    void turn() {
        a.turnTo(thetaA);
        b.turnTo(thetaB);
    }

    private double position(int o, double d) {
        if (linear) {
            return m[o] + d * m[o + Trajectories.VX];
        }
        return m[o] + d * (m[o + Trajectories.VX] + d * (bends[(o & bendMask) + Trajectories.AX] + d * bends[(o & bendMask) + Trajectories.JX]));
    }

    private double velocity(int o, double d) {
        if (linear) {
            return m[o + Trajectories.VX];
        }
        return m[o + Trajectories.VX] + d * (2 * bends[(o & bendMask) + Trajectories.AX] + 3 * d * bends[(o & bendMask) + Trajectories.JX]);
    }
}
