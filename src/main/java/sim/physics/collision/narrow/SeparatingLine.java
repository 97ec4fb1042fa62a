// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import sim.physics.internal.Tolerances;
import sim.physics.internal.Trig;
import sim.physics.motion.Trajectories;

/**
 * Finds the first contact of two bodies that spin uniformly and whose centres move uniformly to one another: free
 * flight, also in a uniform field.
 *
 * <p>A line that touches one body, its owner, and turns with it has all of the other body beyond it. In the owner's frame
 * the height of each vertex of the other body over that line is
 *
 * <pre>
 *   g(s)  ≥  g + g' s + g″ s²/2 + g‴ s³/6 − T s⁴/24
 * </pre>
 *
 * <p>with derivatives that are known exactly and T a bound of |g⁗|. Until the first root of the right side nothing can
 * touch. The bodies are moved on to that root and looked at again, which gains four digits out of one; when the last term
 * is less than rounding, the root is the contact. Lines are edges of the owner, or the tangent where a disc is about to
 * touch a corner. What is not plain (bodies that touch already and slide, penetration) is left to {@link TimeOfImpact}.
 */
final class SeparatingLine {
    /** Looks after which the search is left to the other method. */
    private static final int PATIENCE = 12;

    /** How many steps beyond the end to look for a contact in passing, to save looks in the steps to come. */
    private static final double BEYOND = 8;

    /** Gap, relative to the sizes of the bodies, from which any edge will do that has all of the other body beyond it. */
    private static final double LOOSE = 0.1;

    /** How far outside a region a point may lie and still count as inside, relative to the sizes of the bodies. */
    private static final double REGION_TOLERANCE = 1e-13;

    private final ShapeTable shapes;
    private final Trajectories trajectories;
    private final Pose pose;
    private final ClosestFeatures features;

    /** Whether the bodies touch and approach at the instant that {@link #search} returned. */
    boolean touching;

    /** Whether they are sure not to graze one another then. */
    boolean clean;

    /** Whether {@link #search} got only so far, and another method has to go on from there. */
    boolean undecided;

    /** Code of the closest features at that instant. */
    int code;

    /** Number of poses looked at since the engine was made; a count of work. */
    long evaluations;

    private double[] m;
    /** Acceleration of both, halved. */
    private double ax;
    private double ay;
    private double[] shape;
    private int oa;
    private int ob;
    private int baseA;
    private int baseB;
    private int countA;
    private int countB;

    /** Centre of B relative to the centre of A, its velocity and speed. */
    private double px;
    private double py;
    private double ux;
    private double uy;
    private double speed;
    private double rounding;
    private double bounding;
    private double slowness;

    /** From when on the bounding circles are apart for good. */
    private double parted;
    private double tolerance;
    /** Cosine and sine of A's and of B's orientation. */
    private final double[] turn = new double[4];

    // the owner of the line and the other body, in the owner's frame: centre, velocity, spins
    private int owner;
    private int other;
    private int count;
    private double qx;
    private double qy;
    private double wx;
    private double wy;
    private double spin;
    private double relative;

    /** Cosine and sine of the other body's orientation in the owner's frame. */
    private double cos;
    private double sin;

    // the line: normal, height over the owner's centre; the closest vertex and whether the line is an edge
    private double nx;
    private double ny;
    private double height;
    private int closest;
    private boolean onEdge;

    /** Height of the closest vertex, and its place along the edge. */
    private double gap;
    private double along;

    /** The owner's vertex where the line begins or which it touches, and the normal in the other body's frame. */
    private int vertex;
    private double ox;
    private double oy;

    // derivatives of the other body's centre in the owner's frame, and of its height h0 over the line by 1, 2, 6
    private final CentrePath path = new CentrePath();
    private double h0;
    private double h1;
    private double h2;
    private double h3;
    private final GapRoot root = new GapRoot();

    SeparatingLine(ShapeTable shapes, Trajectories trajectories, Pose pose, ClosestFeatures features) {
        this.shapes = shapes;
        this.trajectories = trajectories;
        this.pose = pose;
        this.features = features;
    }

    /**
     * Searches for the first contact of a pair with approaching surfaces.
     *
     * @param i body A
     * @param partA where its part begins in the table of shapes
     * @param j body B
     * @param partB where its part begins
     * @param start offset τ to start from; the bodies are known not to touch before
     * @param end offset at which the search may stop
     * @param cached features that were closest last time
     * @return offset of the contact if {@link #touching}, else an offset up to which they do not touch: ≥ end unless
     *     {@link #undecided}
     */
    double search(int i, int partA, int j, int partB, double start, double end, int cached) {
        baseA = partA;
        baseB = partB;
        double tau = start;
        code = cached;
        touching = false;
        clean = false;
        undecided = false;
        if (load(i, j)) {
            for (int k = 0; k < PATIENCE; k++) {
                place(tau, k == 0);
                evaluations++;
                if (!findLine(i, j, tau)) {
                    break;
                }
                expand();
                double away = parted - tau;
                double s = advance(Math.min(end - tau, away), away);
                if (touching) {
                    return tau + s;
                }
                if (s >= away) {
                    return Double.POSITIVE_INFINITY;
                }
                if (s >= end - tau) {
                    return Math.max(end, tau + s);
                }
                if (!(tau + s > tau)) {
                    break;
                }
                tau += s;
            }
        }
        undecided = true;
        return tau;
    }

    /** Turns to a pair; false if their motion is not uniform, both are circles, or one is a disc whose centre goes round with its body. */
    private boolean load(int i, int j) {
        if (m != trajectories.data()) { // a reference that is written costs more than one that is compared
            m = trajectories.data();
        }
        oa = i * Trajectories.STRIDE;
        ob = j * Trajectories.STRIDE;
        if (!trajectories.areStraight() && !CentrePath.isStraight(trajectories, i, j)) {
            return false;
        }
        ax = trajectories.bends()[(oa & trajectories.bendMask()) + Trajectories.AX];
        ay = trajectories.bends()[(oa & trajectories.bendMask()) + Trajectories.AY];
        if (shape != shapes.data()) {
            shape = shapes.data();
        }
        countA = (int) shape[baseA + ShapeTable.COUNT];
        countB = (int) shape[baseB + ShapeTable.COUNT];
        rounding = shape[baseA + ShapeTable.ROUNDING] + shape[baseB + ShapeTable.ROUNDING];
        bounding = shape[baseA + ShapeTable.BOUNDING] + shape[baseB + ShapeTable.BOUNDING];
        return (countA > 1 || countB > 1) && !shapes.goesRound(baseA) && !shapes.goesRound(baseB);
    }

    /** Places both bodies at an instant. */
    private void place(double tau, boolean first) {
        double step = trajectories.step();
        double h = trajectories.h();
        double da = (step - m[oa + Trajectories.STEP]) * h + (tau - m[oa + Trajectories.OFFSET]);
        double db = (step - m[ob + Trajectories.STEP]) * h + (tau - m[ob + Trajectories.OFFSET]);
        double xa = m[oa] + da * (m[oa + Trajectories.VX] + da * ax);
        double ya = m[oa + 1] + da * (m[oa + Trajectories.VY] + da * ay);
        double xb = m[ob] + db * (m[ob + Trajectories.VX] + db * ax);
        double yb = m[ob + 1] + db * (m[ob + Trajectories.VY] + db * ay);
        px = xb - xa;
        py = yb - ya;
        double spinA = m[oa + Trajectories.OMEGA];
        double spinB = m[ob + Trajectories.OMEGA];
        if (first) {
            ux = m[ob + Trajectories.VX] + 2 * db * ax - (m[oa + Trajectories.VX] + 2 * da * ax);
            uy = m[ob + Trajectories.VY] + 2 * db * ay - (m[oa + Trajectories.VY] + 2 * da * ay);
            speed = Math.sqrt(ux * ux + uy * uy);
            double turning = Math.abs(spinA) * shape[baseA + ShapeTable.CORE]
                    + Math.abs(spinB) * shape[baseB + ShapeTable.CORE];
            slowness = Tolerances.APPROACH * (speed + turning);
        }
        tolerance = Tolerances.GAP * (Math.abs(xa) + Math.abs(ya) + Math.abs(xb) + Math.abs(yb) + bounding);
        if (first) {
            parted = tau + CentrePath.timeToPart(px, py, ux, uy, CentrePath.reach(bounding, tolerance));
        }
        root.tolerance = tolerance;
        if (countA > 1 && (first || spinA != 0)) {
            Trig.sinCos(m[oa + 2] + da * spinA, turn, 0);
        }
        if (countB > 1 && (first || spinB != 0)) {
            Trig.sinCos(m[ob + 2] + db * spinB, turn, 2);
        }
    }

    /** Takes the line of the features that were closest last, or looks for others. */
    private boolean findLine(int i, int j, double tau) {
        if (code >= 0 && takeLine()) {
            return true;
        }
        if (countA == 1 || countB == 1) {
            return findDiscLine();
        }
        if (faceOther(false) || faceOther(true)) {
            return true;
        }
        pose.load(i, baseA, j, baseB);
        pose.moveTo(tau);
        pose.turn();
        code = features.find(ClosestFeatures.NO_FEATURES);
        return features.gap >= -tolerance && takeLine();
    }

    /** Tries the edge of one polygon that faces the other one's centre, and the vertex that is farthest down. */
    private boolean faceOther(boolean ofB) {
        frame(ofB);
        onEdge = true;
        vertex = shapes.facingEdge(owner, qx, qy);
        int e = owner + ShapeTable.FIRST + ShapeTable.VERTEX * vertex;
        setNormal(shape[e + ShapeTable.NX], shape[e + ShapeTable.NY]);
        closest = shapes.lowestVertex(other, ox, oy);
        int edge = 2 * vertex + 1;
        code = ofB ? 2 * closest << 16 | edge : edge << 16 | 2 * closest;
        return takeEdge();
    }

    /** Looks for the feature of a polygon in whose Voronoi region the centre of a disc is. */
    private boolean findDiscLine() {
        boolean ofB = countA == 1;
        int n = ofB ? countB : countA;
        frame(ofB);
        closest = 0;
        int facing = shapes.facingEdge(owner, qx, qy);
        for (int k = 0; k < n; k++) {
            vertex = facing + k < n ? facing + k : facing + k - n;
            onEdge = takeEdge();
            if (onEdge || takeCorner()) {
                int feature = onEdge ? 2 * vertex + 1 : 2 * vertex;
                code = ofB ? feature : feature << 16;
                return true;
            }
        }
        return false;
    }

    /** Sets the line by the closest features; false if they are not the closest ones. */
    private boolean takeLine() {
        int featureA = code >> 16;
        int featureB = code & 0xffff;
        onEdge = ((featureA | featureB) & 1) != 0;
        boolean ofB = (featureB & 1) != 0 || countA == 1;
        frame(ofB);
        closest = (ofB ? featureA : featureB) >> 1;
        vertex = (ofB ? featureB : featureA) >> 1;
        return onEdge ? takeEdge() : takeCorner();
    }

    /** Goes to the frame of the line's owner. */
    private void frame(boolean ofB) {
        owner = ofB ? baseB : baseA;
        other = ofB ? baseA : baseB;
        count = ofB ? countA : countB;
        double sign = ofB ? -1 : 1;
        double c = turn[ofB ? 2 : 0];
        double s = turn[ofB ? 3 : 1];
        qx = sign * (c * px + s * py);
        qy = sign * (c * py - s * px);
        wx = sign * (c * ux + s * uy);
        wy = sign * (c * uy - s * ux);
        double spinA = m[oa + Trajectories.OMEGA];
        double spinB = m[ob + Trajectories.OMEGA];
        spin = ofB ? spinB : spinA;
        relative = sign * (spinB - spinA);
        if (count > 1) {
            double co = turn[ofB ? 0 : 2];
            double so = turn[ofB ? 1 : 3];
            cos = c * co + s * so;
            sin = c * so - s * co;
        } else {
            cos = 1;
            sin = 0;
            relative = 0;
        }
    }

    private boolean takeEdge() {
        int e = owner + ShapeTable.FIRST + ShapeTable.VERTEX * vertex;
        setNormal(shape[e + ShapeTable.NX], shape[e + ShapeTable.NY]);
        height = shape[e + ShapeTable.H];
        int v = other + ShapeTable.FIRST + ShapeTable.VERTEX * closest;
        double a = ox * shape[v] + oy * shape[v + 1];
        double b = oy * shape[v] - ox * shape[v + 1];
        gap = nx * qx + ny * qy + a - height - rounding;
        along = nx * (qy - shape[e + 1]) - ny * (qx - shape[e]) - b;
        double limit = REGION_TOLERANCE * bounding;
        boolean above = along >= -limit && along <= shape[e + ShapeTable.LENGTH] + limit;
        return (above || count > 1 && gap > LOOSE * bounding)
                && gap + rounding >= -Tolerances.CORNERS * bounding
                && shapes.isLowest(other, closest, ox, oy, a - limit);
    }

    private void setNormal(double x, double y) {
        nx = x;
        ny = y;
        ox = cos * x + sin * y;
        oy = cos * y - sin * x;
    }

    private boolean takeCorner() {
        int o = owner + ShapeTable.FIRST + ShapeTable.VERTEX * vertex;
        int v = other + ShapeTable.FIRST + ShapeTable.VERTEX * closest;
        double dx = qx + (cos * shape[v] - sin * shape[v + 1]) - shape[o];
        double dy = qy + (sin * shape[v] + cos * shape[v + 1]) - shape[o + 1];
        double limit = REGION_TOLERANCE * bounding;
        if (!VoronoiRegion.ofVertexContains(shape, owner, vertex, dx, dy, limit)) {
            return false;
        }
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (distance <= Tolerances.CORNERS * bounding) {
            return false;
        }
        gap = distance - rounding;
        setNormal(dx / distance, dy / distance);
        height = nx * shape[o] + ny * shape[o + 1];
        return shapes.isLowest(other, closest, ox, oy, ox * shape[v] + oy * shape[v + 1] - limit);
    }

    /** The height of the other body's centre as a series in time. */
    private void expand() {
        double spin2 = spin * spin;
        path.expand(qx, qy, wx, wy, spin);
        if (!onEdge && count == 1) {
            lookAhead();
        }
        h0 = nx * qx + ny * qy - height - rounding;
        h1 = nx * path.q1x + ny * path.q1y;
        h2 = (nx * path.q2x + ny * path.q2y) * 0.5;
        h3 = (nx * path.q3x + ny * path.q3y) * (1.0 / 6);
        root.fourth = 0;
        if (spin != 0 || relative != 0) {
            // the bounding circles overlap until they part for good, so the centres stay this close
            double reach = Math.max(Math.abs(px) + Math.abs(py), bounding);
            double turning = relative * relative;
            root.fourth = (Math.abs(spin) * spin2 * (4 * speed + Math.abs(spin) * reach)
                    + turning * turning * shape[other + ShapeTable.CORE]) * (1.0 / 24);
        }
    }

    /** Turns the line at a corner to where a disc will touch it or pass it, if that is still at the corner. */
    private void lookAhead() {
        int o = owner + ShapeTable.FIRST + ShapeTable.VERTEX * vertex;
        double dx = qx - shape[o];
        double dy = qy - shape[o + 1];
        double f0 = gap * (gap + 2 * rounding);
        double f1 = dx * path.q1x + dy * path.q1y;
        double f2 = path.q1x * path.q1x + path.q1y * path.q1y + dx * path.q2x + dy * path.q2y;
        if (!(f1 < 0 && f0 > 0 && f2 > 0)) {
            return;
        }
        double d = f1 * f1 - f2 * f0;
        double s = d > 0 ? f0 / (Math.sqrt(d) - f1) : -f1 / f2;
        double x = dx + s * (path.q1x + 0.5 * s * path.q2x);
        double y = dy + s * (path.q1y + 0.5 * s * path.q2y);
        if (VoronoiRegion.ofVertexContains(shape, owner, vertex, x, y, 0)) {
            double distance = Math.sqrt(x * x + y * y);
            if (x * dx + y * dy > distance * (rounding + 2 * tolerance)) {
                setNormal(x / distance, y / distance);
                height = nx * shape[o] + ny * shape[o + 1];
            }
        }
    }

    /**
     * The time that surely passes before a contact, 0 if that cannot be said; or the time of the contact, if the bodies
     * are {@link #touching} then. Nothing touches from {@code away} on.
     */
    private double advance(double rest, double away) {
        double beyond = Math.min(rest + BEYOND * trajectories.h(), away);
        int v = other + ShapeTable.FIRST + ShapeTable.VERTEX * closest;
        double a = ox * shape[v] + oy * shape[v + 1];
        double b = relative * (oy * shape[v] - ox * shape[v + 1]);
        double turning = relative * relative;
        double g = h0 + a;
        double c1 = h1 + b;
        double c2 = h2 - 0.5 * turning * a;
        double c3 = h3 - turning * b * (1.0 / 6);
        double s;
        if (gap <= tolerance) {
            if (gap < -tolerance || Math.abs(c1) <= slowness || count > 1 && !onEdge) {
                return 0;
            }
            touching = c1 < 0;
            s = touching ? 0 : root.parting(c1, c2, c3, beyond);
            root.sharp = false;
        } else {
            s = root.before(g, c1, c2, c3, beyond, rest);
        }
        boolean sharpest = root.sharp;
        if (!touching && count > 1) {
            double least = Math.min(s, beyond);
            s = advanceOthers(s, beyond, rest);
            sharpest &= s >= least;
        }
        if (sharpest && isContact(s, a, c1, c2, c3)) {
            touching = true;
        }
        return Math.min(s, beyond);
    }

    /** The same for the vertices that are not the closest one. */
    private double advanceOthers(double first, double beyond, double rest) {
        double s = first;
        double turning = relative * relative;
        for (int k = 0, v = other + ShapeTable.FIRST; k < count; k++, v += ShapeTable.VERTEX) {
            if (k == closest) {
                continue;
            }
            double a = ox * shape[v] + oy * shape[v + 1];
            double b = relative * (oy * shape[v] - ox * shape[v + 1]);
            double g = h0 + a;
            if (g <= tolerance) {
                return 0;
            }
            double c1 = h1 + b;
            double c2 = h2 - 0.5 * turning * a;
            double c3 = h3 - turning * b * (1.0 / 6);
            if (!root.isPositive(g, c1, c2, c3, Math.min(s, beyond))) {
                s = Math.min(s, root.before(g, c1, c2, c3, Math.min(s, beyond), Math.min(s, rest)));
            }
        }
        return s;
    }

    /** Whether the bodies touch and approach after a time at which the closest vertex reaches the line. */
    private boolean isContact(double s, double a, double c1, double c2, double c3) {
        if (!(c1 + s * (2 * c2 + 3 * s * c3) < -slowness)) {
            return false;
        }
        if (onEdge) {
            int e = owner + ShapeTable.FIRST + ShapeTable.VERTEX * vertex;
            double reach = Math.max(Math.abs(px) + Math.abs(py), bounding);
            double margin = 0.5 * s * s * (2 * Math.abs(spin) * speed + spin * spin * reach
                    + relative * relative * shape[other + ShapeTable.CORE]);
            double at = along + s * (nx * path.q1y - ny * path.q1x + relative * a);
            boolean within = at > margin && at < shape[e + ShapeTable.LENGTH] - margin;
            clean = within && count > 1 && CleanHit.is(
                    shape, owner, vertex, at, margin, other, closest, ox, oy, Math.abs(relative) * s, tolerance);
            return within;
        }
        int o = owner + ShapeTable.FIRST + ShapeTable.VERTEX * vertex;
        double x = qx - shape[o] + s * (path.q1x + s * (0.5 * path.q2x + s * path.q3x / 6));
        double y = qy - shape[o + 1] + s * (path.q1y + s * (0.5 * path.q2y + s * path.q3y / 6));
        return count == 1
                && VoronoiRegion.ofVertexContains(shape, owner, vertex, x, y, 0)
                && Math.sqrt(x * x + y * y) - rounding <= 0.5 * tolerance;
    }
}
