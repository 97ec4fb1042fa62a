// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.util.Arrays;
import sim.physics.constraint.Curve;
import sim.physics.internal.Growth;

/** Follows a curve from a point of it, by steps along its tangent that are brought back onto it. */
final class WirePath {
    private static final int MOST = 4000;

    /** Turn of the curve in a step, rad. */
    private static final double TURN = 0.1;

    private final Curve curve;
    private final double[] f = new double[6];
    private double[] xy = new double[64];
    private int size;

    private WirePath(Curve curve) {
        this.curve = curve;
    }

    /**
     * The curve through a point, both ways as far as it is near.
     *
     * @param length of a step at most
     * @param reach how far from the point it is followed
     */
    static double[][] through(Curve curve, double x, double y, double length, double reach) {
        WirePath path = new WirePath(curve);
        double[] forth = path.follow(x, y, length, reach);
        boolean isClosed = forth[forth.length - 2] == forth[0] && forth[forth.length - 1] == forth[1];
        return isClosed ? new double[][] {forth} : new double[][] {forth, path.follow(x, y, -length, reach)};
    }

    private double[] follow(double startX, double startY, double length, double reach) {
        size = 0;
        add(startX, startY);
        double x = startX;
        double y = startY;
        double gone = 0;
        for (int k = 0; k < MOST && gone < 8 * reach; k++) {
            curve.evaluate(x, y, f);
            double g = Math.sqrt(f[1] * f[1] + f[2] * f[2]);
            if (!(g > 0)) {
                break;
            }
            double bend = Math.abs(f[3] * f[2] * f[2] - 2 * f[4] * f[1] * f[2] + f[5] * f[1] * f[1]) / (g * g * g);
            double step = bend * Math.abs(length) > TURN ? Math.signum(length) * TURN / bend : length;
            x -= step * f[2] / g;
            y += step * f[1] / g;
            bringBack(x, y);
            x = f[0];
            y = f[1];
            gone += Math.abs(step);
            double away = distance(x, y, startX, startY);
            if (gone > 2.5 * Math.abs(step) && away < 0.75 * Math.abs(step)) {
                add(startX, startY); // all around
                break;
            }
            add(x, y);
            if (away > reach) {
                break;
            }
        }
        return Arrays.copyOf(xy, size);
    }

    /** Leaves the point of the curve near a point in f. */
    private void bringBack(double x, double y) {
        double px = x;
        double py = y;
        for (int k = 0; k < 3; k++) {
            curve.evaluate(px, py, f);
            double g2 = f[1] * f[1] + f[2] * f[2];
            double back = g2 > 0 ? f[0] / g2 : 0;
            px -= back * f[1];
            py -= back * f[2];
        }
        f[0] = px;
        f[1] = py;
    }

    private static double distance(double x, double y, double otherX, double otherY) {
        return Math.sqrt((x - otherX) * (x - otherX) + (y - otherY) * (y - otherY));
    }

    private void add(double x, double y) {
        if (size + 2 > xy.length) {
            xy = Arrays.copyOf(xy, Growth.length(size, size + 2));
        }
        xy[size++] = x;
        xy[size++] = y;
    }
}
