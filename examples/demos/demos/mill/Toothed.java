// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.mill;

import java.util.ArrayList;
import java.util.List;
import sim.physics.shape.Compound;

/** Toothed wheels, each one shape of many convex parts: a full one, and a hollow one with paddles. */
final class Toothed {
    /** Height of a tooth over and under its pitch circle, in modules. */
    private static final double ABOVE = 0.9;

    private static final double BELOW = 1.1;

    /** Half the width of a tooth at its foot and at its head, in pitches: less than a half of a gap's, so that wheels have some play. */
    private static final double FOOT = 0.34;

    private static final double HEAD = 0.12;

    /** How far a tooth's foot reaches into the wheel, so that no gap is left between the two. */
    private static final double ROOTED = 0.99;

    private Toothed() {}

    /** Radius at which two wheels roll on one another. */
    static double pitchRadius(int teeth, double module) {
        return 0.5 * teeth * module;
    }

    /** A wheel that is full. */
    static Compound pinion(int teeth, double module) {
        double inner = pitchRadius(teeth, module) - BELOW * module;
        double[] hub = new double[2 * teeth];
        for (int k = 0; k < teeth; k++) {
            hub[2 * k] = inner * StrictMath.cos(2 * Math.PI * k / teeth);
            hub[2 * k + 1] = inner * StrictMath.sin(2 * Math.PI * k / teeth);
        }
        List<double[]> parts = new ArrayList<>(List.of(hub));
        addTeeth(parts, teeth, module, teeth);
        return new Compound(parts.toArray(double[][]::new));
    }

    /** A ring of flat walls, with teeth outside and paddles inside. */
    static Compound drum(int teeth, double module, int walls, double thickness, int paddles, double reach) {
        double outer = pitchRadius(teeth, module) - BELOW * module;
        double inner = outer - thickness;
        List<double[]> parts = new ArrayList<>();
        for (int k = 0; k < walls; k++) {
            double from = 2 * Math.PI * k / walls;
            double to = 2 * Math.PI * (k + 1) / walls;
            parts.add(new double[] {
                inner * StrictMath.cos(from), inner * StrictMath.sin(from), outer * StrictMath.cos(from), outer * StrictMath.sin(from),
                outer * StrictMath.cos(to), outer * StrictMath.sin(to), inner * StrictMath.cos(to), inner * StrictMath.sin(to)
            });
        }
        for (int k = 0; k < paddles; k++) {
            double angle = 2 * Math.PI * k / paddles;
            double middle = inner - 0.5 * reach + 0.5; // half a unit into the wall
            parts.add(Compound.box(middle * StrictMath.cos(angle), middle * StrictMath.sin(angle), reach + 1, 3, angle));
        }
        addTeeth(parts, teeth, module, walls);
        return new Compound(parts.toArray(double[][]::new));
    }

    /** Teeth on a wheel that is a regular polygon of so many sides. */
    private static void addTeeth(List<double[]> parts, int teeth, double module, int sides) {
        double pitch = 2 * Math.PI / teeth;
        double foot = ROOTED * StrictMath.cos(Math.PI / sides) * (pitchRadius(teeth, module) - BELOW * module);
        double head = pitchRadius(teeth, module) + ABOVE * module;
        for (int k = 0; k < teeth; k++) {
            double a = k * pitch;
            parts.add(new double[] {
                foot * StrictMath.cos(a - FOOT * pitch), foot * StrictMath.sin(a - FOOT * pitch),
                head * StrictMath.cos(a - HEAD * pitch), head * StrictMath.sin(a - HEAD * pitch),
                head * StrictMath.cos(a + HEAD * pitch), head * StrictMath.sin(a + HEAD * pitch),
                foot * StrictMath.cos(a + FOOT * pitch), foot * StrictMath.sin(a + FOOT * pitch)
            });
        }
    }
}
