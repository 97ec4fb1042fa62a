// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;

/** How far the cubic paths of a group are from its motion. */
final class PathError implements Serializable {
    private static final long serialVersionUID = 1L;

    /** The path's error is of fourth order in its length; this much less than allowed is aimed at. */
    private static final double SAFE = 0.5;

    private static final double GROWTH = 4;

    private final Trajectories trajectories;
    private final Path path;

    PathError(Trajectories trajectories, Path path) {
        this.trajectories = trajectories;
        this.path = path;
    }

    /** How much longer a path may be that has an error. */
    static double root(double error) {
        double fourth = SAFE / Math.max(error, 1e-6);
        return Math.min(GROWTH, Math.sqrt(Math.sqrt(fourth)));
    }

    /**
     * How far the cubic paths may be from the motion, in units of what is near enough: a motion whose fourth derivative is
     * constant is off by c s²(h − s)², so its second derivative at the start by 2 c h².
     */
    double of(IntList group, double length, double near) {
        if (!path.knowsFirst) {
            return ofTurn(group, length, near);
        }
        return of(group, path.a, State.BLOCK, length, near);
    }

    /** The same, given where half the second derivatives at the start are. */
    double of(IntList group, double[] half, int stride, double length, double near) {
        double most = 0;
        for (int k = 0; k < group.size; k++) {
            int b = State.BLOCK * group.values[k];
            int o = stride * group.values[k];
            double radius = trajectories.radius(group.values[k]);
            double way = Math.abs(path.first[b] - 2 * half[o]) + Math.abs(path.first[b + 1] - 2 * half[o + 1]);
            double turn = Math.abs(path.first[b + 2] - 2 * half[o + 2]);
            most = Math.max(most, Math.max(way / radius, turn));
        }
        return most * length * length / (32 * near);
    }

    /** The same by how far the fastest body turns, where nothing is known of accelerations. */
    private double ofTurn(IntList group, double length, double near) {
        double turn = length * GroupPaths.fastestTurn(trajectories, group);
        return turn * turn * turn * turn / (384 * near);
    }
}
