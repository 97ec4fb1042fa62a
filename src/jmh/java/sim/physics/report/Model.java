// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** A scene as numbers only, so that every engine is given the same one. */
final class Model {
    /** Coordinates of a part in a state: x, y, angle, and their rates. */
    static final int BLOCK = 6;

    final double gravity;
    double surfaceGravity;
    double surfaceFriction;

    /** Gravity to the right, for slopes. */
    double across;

    /** Coefficient of friction of any two parts that touch. */
    double friction;

    /** A torque that acts on the first part all the time, and a force to the right. */
    double torque;

    double push;

    final List<Part> parts = new ArrayList<>();
    final List<Pin> pins = new ArrayList<>();
    final List<Rod> rods = new ArrayList<>();
    final List<Elastic> springs = new ArrayList<>();
    final List<Slide> slides = new ArrayList<>();

    Model(double gravity) {
        this.gravity = gravity;
    }

    /** The outline of a part. */
    enum Kind {
        DISC,
        BOX,
        POLYGON
    }

    /**
     * A body.
     *
     * @param size radius; or width and height; or circumradius and number of corners
     */
    record Part(
            Kind kind, double[] size, double mass, double inertia, boolean fixed, boolean collides, double e, double[] start) {
        /** The distance of the rim from the centre. */
        double rim() {
            return kind == Kind.BOX ? Math.hypot(size[0], size[1]) / 2 : size[0];
        }
    }

    /** A hinge of two parts, or of a part and the world (−1), at a point of the world at the start. */
    record Pin(int a, int b, double x, double y) {}

    /** The centre of a part keeps its distance from a point of the world. */
    record Rod(int a, double x, double y) {}

    /** A part moves along x and does not turn. */
    record Slide(int a) {}

    /** A spring with a damper between a point of a part, given in the world at the start, and the world. */
    record Elastic(int a, double px, double py, double x, double y, double length, double stiffness, double damping) {}

    int add(Kind kind, double[] size, double mass, double inertia, boolean collides, double e, double... start) {
        double[] all = new double[BLOCK];
        System.arraycopy(start, 0, all, 0, start.length);
        parts.add(new Part(kind, size, mass, inertia, false, collides, e, all));
        return parts.size() - 1;
    }

    /** A uniform rod of mass and length 1 that does not collide. */
    int rod(double... start) {
        return add(Kind.BOX, new double[] {1, 0.02}, 1, 1 / 12.0, false, 1, start);
    }

    int wall(double x, double y, double width, double height) {
        double[] start = {x, y, 0, 0, 0, 0};
        parts.add(new Part(Kind.BOX, new double[] {width, height}, 0, 0, true, true, 1, start));
        return parts.size() - 1;
    }

    double[] start() {
        double[] state = new double[BLOCK * parts.size()];
        for (int k = 0; k < parts.size(); k++) {
            System.arraycopy(parts.get(k).start, 0, state, BLOCK * k, BLOCK);
        }
        return state;
    }

    double kinetic(double[] s) {
        double sum = 0;
        for (int k = 0; k < parts.size(); k++) {
            Part part = parts.get(k);
            if (!part.fixed) {
                int b = BLOCK * k;
                sum += part.mass * (s[b + 3] * s[b + 3] + s[b + 4] * s[b + 4]) / 2;
                sum += part.inertia * s[b + 5] * s[b + 5] / 2;
            }
        }
        return sum;
    }

    double energy(double[] s) {
        double sum = kinetic(s) - torque * s[2] - push * s[0];
        for (int k = 0; k < parts.size(); k++) {
            sum += parts.get(k).mass * (gravity * s[BLOCK * k + 1] - across * s[BLOCK * k]);
        }
        for (Elastic spring : springs) {
            double[] p = follow(spring.a, spring.px, spring.py, s);
            double stretch = Math.hypot(p[0] - spring.x, p[1] - spring.y) - spring.length;
            sum += spring.stiffness * stretch * stretch / 2;
        }
        return sum;
    }

    /** Size of the momentum and of the angular momentum. */
    double[] momentum(double[] s) {
        double[] p = new double[3];
        for (int k = 0; k < parts.size(); k++) {
            int b = BLOCK * k;
            double m = parts.get(k).mass;
            p[0] += m * s[b + 3];
            p[1] += m * s[b + 4];
            p[2] += m * (s[b] * s[b + 4] - s[b + 1] * s[b + 3]) + parts.get(k).inertia * s[b + 5];
        }
        return p;
    }

    /** Where a point of a part is now that was at (x, y) at the start. */
    double[] follow(int part, double x, double y, double[] s) {
        if (part < 0) {
            return new double[] {x, y};
        }
        double[] start = parts.get(part).start;
        return turn(s, part, x - start[0], y - start[1], s[BLOCK * part + 2] - start[2]);
    }

    /** Where a point of a part is, given in its own coordinates. */
    double[] local(int part, double x, double y, double[] s) {
        return turn(s, part, x, y, s[BLOCK * part + 2]);
    }

    private static double[] turn(double[] s, int part, double x, double y, double angle) {
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        return new double[] {s[BLOCK * part] + cos * x - sin * y, s[BLOCK * part + 1] + sin * x + cos * y};
    }

    /** The widest gap of a joint. */
    double gap(double[] s) {
        double most = 0;
        for (Pin pin : pins) {
            double[] a = follow(pin.a, pin.x, pin.y, s);
            double[] b = follow(pin.b, pin.x, pin.y, s);
            most = Math.max(most, Math.hypot(a[0] - b[0], a[1] - b[1]));
        }
        for (Rod rod : rods) {
            double[] start = parts.get(rod.a).start;
            double length = Math.hypot(start[0] - rod.x, start[1] - rod.y);
            most = Math.max(most, Math.abs(Math.hypot(s[BLOCK * rod.a] - rod.x, s[BLOCK * rod.a + 1] - rod.y) - length));
        }
        for (Slide slide : slides) {
            double[] start = parts.get(slide.a).start;
            most = Math.max(most, Math.abs(s[BLOCK * slide.a + 1] - start[1]));
        }
        return most;
    }

    boolean hasJoints() {
        return !pins.isEmpty() || !rods.isEmpty() || !slides.isEmpty();
    }

    /** The corners of a part in its own coordinates; a disc has its centre. */
    static double[][] corners(Part part) {
        switch (part.kind) {
            case DISC:
                return new double[][] {{0, 0}};
            case BOX:
                double a = part.size[0] / 2;
                double b = part.size[1] / 2;
                return new double[][] {{a, b}, {-a, b}, {-a, -b}, {a, -b}};
            default:
                int n = (int) part.size[1];
                double[][] corners = new double[n][];
                for (int k = 0; k < n; k++) {
                    double angle = 2 * Math.PI * k / n;
                    corners[k] = new double[] {part.size[0] * StrictMath.cos(angle), part.size[0] * StrictMath.sin(angle)};
                }
                return corners;
        }
    }

    /** The deepest penetration of two parts that collide. */
    double penetration(double[] s) {
        double most = 0;
        for (int i = 0; i < parts.size(); i++) {
            for (int j = i + 1; j < parts.size(); j++) {
                Part a = parts.get(i);
                Part b = parts.get(j);
                if (a.collides && b.collides && !(a.fixed && b.fixed)) {
                    most = Math.max(most, Math.min(depth(i, j, s), depth(j, i, s)));
                }
            }
        }
        return most;
    }

    /** Overlap along the normals of the edges of a part; along the line of centres for a disc. */
    private double depth(int i, int j, double[] s) {
        double[][] a = placed(i, s);
        double[][] b = placed(j, s);
        double radii = radius(parts.get(i)) + radius(parts.get(j));
        if (a.length == 1) {
            double[] near = b.length == 1 ? b[0] : nearest(a[0], b);
            return near == null ? Double.POSITIVE_INFINITY : radii - Math.hypot(near[0] - a[0][0], near[1] - a[0][1]);
        }
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < a.length; k++) {
            double[] p = a[k];
            double[] q = a[(k + 1) % a.length];
            double length = Math.hypot(q[0] - p[0], q[1] - p[1]);
            double lowest = Double.POSITIVE_INFINITY;
            for (double[] c : b) {
                lowest = Math.min(lowest, ((q[1] - p[1]) * (c[0] - p[0]) - (q[0] - p[0]) * (c[1] - p[1])) / length);
            }
            least = Math.min(least, radii - lowest);
        }
        return least;
    }

    /** The corner next to a disc's centre where the centre is beyond a corner; else edges decide. */
    private static double[] nearest(double[] centre, double[][] corners) {
        double[] best = null;
        for (double[] c : corners) {
            if (best == null || Math.hypot(c[0] - centre[0], c[1] - centre[1])
                    < Math.hypot(best[0] - centre[0], best[1] - centre[1])) {
                best = c;
            }
        }
        for (int k = 0; k < corners.length; k++) {
            double[] p = corners[k];
            double[] q = corners[(k + 1) % corners.length];
            double along = (centre[0] - p[0]) * (q[0] - p[0]) + (centre[1] - p[1]) * (q[1] - p[1]);
            double length2 = (q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]);
            if (along > 0 && along < length2) {
                return null;
            }
        }
        return best;
    }

    private double[][] placed(int part, double[] s) {
        double[][] corners = corners(parts.get(part));
        for (int k = 0; k < corners.length; k++) {
            corners[k] = local(part, corners[k][0], corners[k][1], s);
        }
        return corners;
    }

    private static double radius(Part part) {
        return part.kind == Kind.DISC ? part.size[0] : 0;
    }

    /** The scene for the driver of engines in Python. */
    String json() {
        StringBuilder text = new StringBuilder("{\"gravity\":" + gravity + ",\"across\":" + across + ",\"friction\":" + friction
                + ",\"torque\":" + torque + ",\"push\":" + push + ",\"parts\":[");
        String comma = "";
        for (Part part : parts) {
            text.append(comma).append(String.format(Locale.ROOT, "{\"kind\":\"%s\",\"mass\":%s,\"inertia\":%s,", part.kind, part.mass, part.inertia));
            text.append("\"radius\":" + radius(part) + ",\"fixed\":" + part.fixed + ",\"collides\":" + part.collides);
            text.append(",\"e\":" + part.e + ",\"corners\":" + java.util.Arrays.deepToString(corners(part)));
            text.append(",\"start\":" + java.util.Arrays.toString(part.start) + "}");
            comma = ",";
        }
        text.append("],\"pins\":[");
        comma = "";
        for (Pin pin : pins) {
            text.append(comma + "[" + pin.a + "," + pin.b + "," + pin.x + "," + pin.y + "]");
            comma = ",";
        }
        text.append("],\"rods\":[");
        comma = "";
        for (Rod rod : rods) {
            text.append(comma + "[" + rod.a + "," + rod.x + "," + rod.y + "]");
            comma = ",";
        }
        text.append("],\"springs\":[");
        comma = "";
        for (Elastic s : springs) {
            text.append(comma + java.util.Arrays.toString(new double[] {s.a, s.px, s.py, s.x, s.y, s.length, s.stiffness, s.damping}));
            comma = ",";
        }
        text.append("],\"slides\":[");
        comma = "";
        for (Slide slide : slides) {
            text.append(comma + slide.a);
            comma = ",";
        }
        return text.append("]}").toString();
    }
}
