// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.Trig;
import sim.physics.shape.Polygon;
import sim.physics.shape.Shape;

/** Several convex polygons and discs on a plane that keep their places to one another: each rubs with its share of the area, where it is. */
final class CompoundPatch extends FlatPatch {
    private static final long serialVersionUID = 1L;

    private final double unit;
    private final SurfacePatch[] parts;

    /** Share of the area, and centroid, of each part. */
    private final double[] places;

    CompoundPatch(Shape shape) {
        this(shape, Math.scalb(1.0, Math.getExponent(shape.boundingRadius()) + 1));
    }

    private CompoundPatch(Shape shape, double unit) {
        super(unit);
        this.unit = unit;
        parts = new SurfacePatch[shape.partCount()];
        places = new double[3 * parts.length];
        for (int k = 0; k < parts.length; k++) {
            Shape part = shape.part(k);
            places[3 * k] = part.area() / shape.area();
            if (part.vertexCount() == 1) {
                parts[k] = new DiscPatch(part.radius());
                places[3 * k + 1] = part.vertexX(0);
                places[3 * k + 2] = part.vertexY(0);
            } else {
                Polygon centred = new Polygon(part.copyVertices());
                parts[k] = new PolygonPatch(centred);
                places[3 * k + 1] = centred.centroidX();
                places[3 * k + 2] = centred.centroidY();
            }
        }
        spin();
    }

    @Override
    void rub(double vx, double vy, double spin, double theta, double[] out) {
        if (spin == 0) { // all parts alike: no torque, exactly
            double speed = Math.sqrt(vx * vx + vy * vy);
            out[0] = -(vx / speed);
            out[1] = -(vy / speed);
            out[2] = 0;
            return;
        }
        double cos = Trig.cos(theta);
        double sin = Trig.sin(theta);
        double omega = spin / unit;
        double fx = 0;
        double fy = 0;
        double torque = 0;
        for (int k = 0; k < parts.length; k++) {
            double x = cos * places[3 * k + 1] - sin * places[3 * k + 2];
            double y = sin * places[3 * k + 1] + cos * places[3 * k + 2];
            parts[k].friction(vx - omega * y, vy + omega * x, omega, theta, out);
            fx += places[3 * k] * out[0];
            fy += places[3 * k] * out[1];
            torque += places[3 * k] * (out[2] + (x * out[1] - y * out[0]));
        }
        out[0] = fx;
        out[1] = fy;
        out[2] = torque / unit;
    }

    @Override
    void slip(double ux, double uy, double spin, double[] out) {
        rub(ux, uy, spin, 0, out);
        out[0] = -out[0];
        out[1] = -out[1];
        out[2] = -out[2];
    }
}
