// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import java.io.Serializable;

/**
 * A step of a {@link PinTree} in parts each of which is as short as it must be. Where a heavy link pulls light ones taut, these turn round in next
 * to no time, and even parts would all have to be as short as that.
 */
final class FineStep implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Parts that are tried in a step. */
    private static final int MOST = 8192;

    /** By how much a part may be longer than the one before. */
    private static final double LONGER = 2;

    /** How much shorter a part is than one that would be just smooth enough, as the motion changes. */
    private static final double SAFE = 0.9;

    /** From one link's place, angle and velocities to those of the next; what lies between is found from these. */
    private static final int VALUES = PinTree.OMEGA - PinTree.X + 1;

    /** A way to make parts. */
    interface Part {
        /**
         * Goes on from where the links are.
         *
         * @param done what of the step is over
         * @param length of the part
         * @return {@link PinTree#roughness}
         */
        double go(double done, double length);
    }

    private final PinTree tree;
    private final double[] start;

    FineStep(PinTree tree) {
        this.tree = tree;
        start = new double[VALUES * tree.links];
    }

    /**
     * Makes a step from where the tree is.
     *
     * @param parts how parts are made
     * @param h step
     * @param first length of the part that is tried first
     * @param most how rough a part may be, see {@link PinTree#roughness}
     * @return false if it takes too many parts
     */
    boolean advance(Part parts, double h, double first, double most) {
        double part = first;
        double done = 0;
        for (int tries = 0; tries < MOST; tries++) {
            boolean isLast = Math.abs(part) >= Math.abs(h - done);
            part = isLast ? h - done : part;
            keep();
            double rough = part * part * parts.go(done, part);
            double scale = SAFE * Math.sqrt(Math.sqrt(most / rough)); // what is rough is of fourth order
            if (!(rough <= most)) {
                putBack();
                part *= rough < Double.POSITIVE_INFINITY ? Math.max(1 / LONGER, Math.min(scale, SAFE)) : 1 / LONGER;
                continue;
            }
            if (isLast) {
                return true;
            }
            done += part;
            part *= Math.min(scale, LONGER);
        }
        return false;
    }

    private void keep() {
        for (int k = 0; k < tree.links; k++) {
            System.arraycopy(tree.link, PinTree.STRIDE * k + PinTree.X, start, VALUES * k, VALUES);
        }
    }

    private void putBack() {
        for (int k = 0; k < tree.links; k++) {
            System.arraycopy(start, VALUES * k, tree.link, PinTree.STRIDE * k + PinTree.X, VALUES);
        }
        tree.begin();
    }
}
