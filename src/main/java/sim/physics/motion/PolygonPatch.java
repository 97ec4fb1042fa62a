// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.Logarithm;
import sim.physics.internal.Trig;
import sim.physics.shape.Shape;

/**
 * A convex polygon on a plane. Around the instantaneous centre c the velocities are ω (r − c)⊥. The triangle of c and
 * an edge from s to s + L along its tangent t, whose line is at distance d from c in the direction of its normal n, has
 * the area ½ dL and
 *
 * <pre>
 *   ∫ (r − c)/|r − c| dA = ½ d (t Δρ + n d Δa),    ρ = √(d² + s²)
 *   ∫ |r − c| dA         = ⅙ d (Δ(sρ) + d² Δa),    a = asinh(s/|d|),  Δa = log((Σρ + L)/(Σρ − L))
 * </pre>
 *
 * <p>with Δ for the difference between its ends and Σ for their sum. The sum over the edges is the integral over the polygon. From a centre
 * far outside, the triangles are much larger than the polygon and cancel: then {@link FarMotion} takes over, or
 * {@link SlenderBody}.
 */
final class PolygonPatch extends FlatPatch {
    private static final long serialVersionUID = 1L;

    /** Distance of the centre, relative to the bounding radius, from which the series of {@link FarMotion} is used. */
    private static final double FAR = 16;

    /** Largest loss of accuracy by cancellation that is accepted, in units of rounding. */
    private static final double LOSS = 2000;

    /** Part of a sum of lengths that is rounding. */
    private static final double NOISE = 0x1p-54;

    /** Vertices x0, y0, x1, y1 … in units. */
    private final double[] xy;

    /** Tangent x, tangent y and length of the edges. */
    private final double[] edges;

    private final double area;
    private final double reach;
    private final FarMotion farMotion;
    private final SlenderBody slenderBody;

    PolygonPatch(Shape shape) {
        this(shape, Math.scalb(1.0, Math.getExponent(shape.boundingRadius()) + 1));
    }

    private PolygonPatch(Shape shape, double unit) {
        super(unit);
        xy = shape.copyVertices();
        edges = new double[xy.length / 2 * 3];
        for (int k = 0; k < xy.length; k++) {
            xy[k] /= unit;
        }
        for (int k = 0; k < xy.length / 2; k++) {
            int next = (2 * k + 2) % xy.length;
            double ex = xy[next] - xy[2 * k];
            double ey = xy[next + 1] - xy[2 * k + 1];
            double length = StrictMath.hypot(ex, ey); // its square may underflow
            edges[3 * k] = ex / length;
            edges[3 * k + 1] = ey / length;
            edges[3 * k + 2] = length;
        }
        area = shape.area() / unit / unit;
        reach = shape.boundingRadius() / unit;
        farMotion = new FarMotion(xy, area);
        slenderBody = new SlenderBody(xy);
        spin();
    }

    @Override
    void rub(double vx, double vy, double spin, double theta, double[] out) {
        double cos = Trig.cos(theta);
        double sin = Trig.sin(theta);
        double ux = cos * vx + sin * vy;
        double uy = cos * vy - sin * vx;
        if (isFar(ux, uy, spin)) {
            farMotion.friction(vx, vy, ux, uy, spin, out);
            return;
        }
        near(-uy / spin, ux / spin, out);
        double ex = spin > 0 ? out[0] : -out[0];
        double ey = spin > 0 ? out[1] : -out[1];
        out[0] = sin * ex + cos * ey;
        out[1] = sin * ey - cos * ex;
        out[2] = spin > 0 ? -out[2] : out[2];
    }

    private boolean isFar(double ux, double uy, double spin) {
        double bound = FAR * reach * spin;
        return ux * ux + uy * uy >= bound * bound;
    }

    @Override
    void slip(double ux, double uy, double spin, double[] out) {
        if (isFar(ux, uy, spin)) {
            farMotion.friction(-ux, -uy, ux, uy, spin, out);
            out[2] = -out[2];
            return;
        }
        near(-uy / spin, ux / spin, out);
        double ex = out[0];
        out[0] = spin > 0 ? -out[1] : out[1];
        out[1] = spin > 0 ? ex : -ex;
        out[2] = spin > 0 ? out[2] : -out[2];
    }

    /** Takes the means of e = (r − c)/|r − c| and of r·e to out. */
    private void near(double cx, double cy, double[] out) {
        double x = 0;
        double y = 0;
        double moment = 0;
        double whole = 0;
        int last = xy.length - 2;
        double px = xy[last] - cx;
        double py = xy[last + 1] - cy;
        double rho = Math.sqrt(px * px + py * py);
        for (int k = 0, e = 3 * (last / 2); k <= last; e = 3 * (k / 2), k += 2) {
            double tx = edges[e];
            double ty = edges[e + 1];
            double length = edges[e + 2];
            double d = px * ty - py * tx;
            double twice = 2 * (px * tx + py * ty) + length; // s at one end and at the other
            px = xy[k] - cx;
            py = xy[k + 1] - cy;
            double rhoEnd = Math.sqrt(px * px + py * py);
            double sum = rho + rhoEnd;
            double rise = length * (twice / sum);
            // where the centre is on the edge the difference is noise, and d² so small that it does not count
            double bend = d * Logarithm.ofRatio(sum + length, Math.max(sum - length, NOISE * sum));
            double ex = 0.5 * d * (tx * rise + ty * bend);
            double ey = 0.5 * d * (ty * rise - tx * bend);
            x += ex;
            y += ey;
            moment += d * (0.5 * (length * sum + twice * rise) + d * bend) / 6 + cx * ex + cy * ey;
            whole += Math.abs(d) * length;
            rho = rhoEnd;
        }
        out[0] = x;
        out[1] = y;
        out[2] = moment;
        if (whole * (reach + Math.abs(cx) + Math.abs(cy)) > LOSS * reach * 2 * area) {
            slenderBody.integrals(cx, cy, out);
        }
        out[0] /= area;
        out[1] /= area;
        out[2] /= area;
    }
}
