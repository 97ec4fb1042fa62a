// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.scenes;

import java.util.List;
import java.util.Locale;
import java.util.Objects;

/**
 * A gas of bodies between four static walls, as numbers only: no type of any engine, so that every engine can be given
 * the same scene.
 *
 * <p>Body i is described by the i-th entry of each array, in the scene's own units of length and time. Density is 1, so
 * a mass is an area. Friction and gravity are 0 everywhere. The arrays are not copied; nobody writes to them after the
 * scene was made.
 *
 * @param name what was asked for, for reports
 * @param kind what each body is
 * @param sizeA radius of a circle, width of a rectangle, circumradius of a polygon
 * @param sizeB height of a rectangle, number of vertices of a polygon, 0 for a circle
 * @param x centre of mass
 * @param y centre of mass
 * @param theta angle; at 0 a rectangle's width lies along x, and a polygon's first vertex on the positive x axis
 * @param vx velocity, length per unit of time
 * @param vy velocity, length per unit of time
 * @param omega angular velocity, rad per unit of time
 * @param mass masses; the inertia is that of a uniform body, {@link #inertia(int)}
 * @param walls the static rectangles, not turned
 * @param inner the space between the walls
 * @param restitution coefficient of restitution of all pairs
 * @param dt time step
 */
public record SceneData(
        String name,
        Kind[] kind,
        double[] sizeA,
        double[] sizeB,
        double[] x,
        double[] y,
        double[] theta,
        double[] vx,
        double[] vy,
        double[] omega,
        double[] mass,
        List<Box> walls,
        Box inner,
        double restitution,
        double dt) {

    /** What a body is. */
    public enum Kind {
        /** A disk. */
        CIRCLE,
        /** A rectangle about its centre. */
        RECTANGLE,
        /** A regular polygon about its centre. */
        POLYGON
    }

    /**
     * A rectangle with sides along the axes.
     *
     * @param x centre
     * @param y centre
     * @param width extent along x
     * @param height extent along y
     */
    public record Box(double x, double y, double width, double height) {
        /** {@return width × height} */
        public double area() {
            return width * height;
        }
    }

    /** Checks that all arrays have one length. */
    public SceneData {
        Objects.requireNonNull(name, "name");
        walls = List.copyOf(walls);
        double[][] columns = {sizeA, sizeB, x, y, theta, vx, vy, omega, mass};
        for (double[] column : columns) {
            if (column.length != kind.length) {
                throw new IllegalArgumentException(
                        "a column has " + column.length + " entries for " + kind.length + " bodies");
            }
        }
    }

    /** {@return the number of moving bodies} */
    public int size() {
        return kind.length;
    }

    /** {@return the vertices of polygon i about its centre at angle 0, anticlockwise: x0, y0, x1, y1 …} */
    public double[] outline(int i) {
        int n = (int) sizeB[i];
        double[] xy = new double[2 * n];
        for (int k = 0; k < n; k++) {
            // StrictMath: the same bits on every JVM
            xy[2 * k] = sizeA[i] * StrictMath.cos(2 * Math.PI * k / n);
            xy[2 * k + 1] = sizeA[i] * StrictMath.sin(2 * Math.PI * k / n);
        }
        return xy;
    }

    /** {@return the area of body i} */
    public double area(int i) {
        double a = sizeA[i];
        return switch (kind[i]) {
            case CIRCLE -> Math.PI * a * a;
            case RECTANGLE -> a * sizeB[i];
            case POLYGON -> 0.5 * sizeB[i] * a * a * StrictMath.sin(2 * Math.PI / sizeB[i]);
        };
    }

    /** {@return the moment of inertia of body i about its centre} */
    public double inertia(int i) {
        double a = sizeA[i];
        return mass[i] * switch (kind[i]) {
            case CIRCLE -> a * a / 2;
            case RECTANGLE -> (a * a + sizeB[i] * sizeB[i]) / 12;
            case POLYGON -> a * a * (2 + StrictMath.cos(2 * Math.PI / sizeB[i])) / 6;
        };
    }

    /** {@return the radius of the least circle about the centre that holds body i} */
    public double boundingRadius(int i) {
        return kind[i] == Kind.RECTANGLE ? 0.5 * Math.sqrt(sizeA[i] * sizeA[i] + sizeB[i] * sizeB[i]) : sizeA[i];
    }

    /** {@return the area of all moving bodies} */
    public double bodyArea() {
        double sum = 0;
        for (int i = 0; i < size(); i++) {
            sum += area(i);
        }
        return sum;
    }

    /** {@return the share of the space between the walls that bodies cover} */
    public double areaFraction() {
        return bodyArea() / inner.area();
    }

    /** {@return Σ m v²/2 + I ω²/2 at the start} */
    public double kineticEnergy() {
        double sum = 0;
        for (int i = 0; i < size(); i++) {
            sum += 0.5 * mass[i] * (vx[i] * vx[i] + vy[i] * vy[i]) + 0.5 * inertia(i) * omega[i] * omega[i];
        }
        return sum;
    }

    @Override
    public String toString() {
        return String.format(
                Locale.ROOT,
                "%s: %d bodies of total area %.6g in %.6g x %.6g (fraction %.4f), kinetic energy %.6g, dt %.6g",
                name, size(), bodyArea(), inner.width(), inner.height(), areaFraction(), kineticEnergy(), dt);
    }
}
