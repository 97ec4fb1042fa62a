// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import sim.physics.internal.Length;

/** What a contact did in a time in which its normal turned, as if that had been one normal. */
public final class MeanPush implements Serializable {
    private static final long serialVersionUID = 1L;

    /** The normal. */
    public double nx;

    /** Its other component. */
    public double ny;

    /** What acts along it. */
    public double normal;

    /** What acts along its tangent. */
    public double tangential;

    /** Nothing, at first. */
    public MeanPush() {
        // all is 0
    }

    /**
     * Finds the normal along which what has acted is all that it was, and has parts along it and along its tangent that are to one another as
     * the sums were: these obeyed Coulomb's law, and so do those.
     *
     * @param n0x a normal of that time
     * @param n0y its other component
     * @param sum of what acted along normals
     * @param rubbed sum of what acted along tangents
     * @param moreX what lacks on the second body if all is taken to have acted along that normal and its tangent
     * @param moreY its other component
     */
    public void find(double n0x, double n0y, double sum, double rubbed, double moreX, double moreY) {
        nx = n0x;
        ny = n0y;
        double part = 1;
        if (sum == 0) {
            findAlone(moreX, moreY);
            return;
        }
        if ((moreX != 0 || moreY != 0) && sum > Length.TINY) { // else squares are none
            double x = sum * nx - rubbed * ny + moreX;
            double y = sum * ny + rubbed * nx + moreY;
            double all = Math.sqrt(x * x + y * y);
            double sums = Math.sqrt(sum * sum + rubbed * rubbed);
            nx = (x * sum + y * rubbed) / (all * sums);
            ny = (y * sum - x * rubbed) / (all * sums);
            part = all / sums;
        }
        normal = part * sum;
        tangential = part * rubbed;
    }

    /** All of it has acted along no normal. */
    private void findAlone(double x, double y) {
        normal = Math.sqrt(x * x + y * y);
        tangential = 0;
        nx = normal > 0 ? x / normal : nx;
        ny = normal > 0 ? y / normal : ny;
    }
}
