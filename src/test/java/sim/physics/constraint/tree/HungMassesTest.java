// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Which trees are chains that hang. */
class HungMassesTest {
    /** Three links, each with its near pin at −1 and the next link's at the end of the arm. */
    private static PinTree tree(double endX, double endY, boolean isFree) {
        double[] arms = {-1, 0, 0, 0, -1, 0, endX, endY, -1, 0, endX, endY};
        return new PinTree(new int[] {0, 3, 6}, new int[] {-1, 0, 1}, arms, isFree);
    }

    private static boolean isHung(PinTree tree, double inertia) {
        double w = 1 / inertia;
        tree.weigh(new double[] {1, 1, w, 1, 1, w, 1, 1, w});
        return HungChain.of(tree) != null;
    }

    @Test
    void areOfLinksThatArePointsAtTheirPinsAndAMomentOfInertia() {
        assertThat(isHung(tree(1, 0, false), 1 / 3.0)).isTrue();
        assertThat(isHung(tree(1, 0, true), 1 / 3.0)).isFalse(); // free
        assertThat(isHung(tree(1, 0.5, false), 1 / 3.0)).isFalse(); // masses beside the lines
        assertThat(isHung(tree(1, 0, false), 1)).isFalse(); // nothing but the points is left
        assertThat(isHung(tree(-0.5, 0, false), 1 / 3.0)).isFalse(); // centres beyond the next pins
        PinTree forked = new PinTree(
                new int[] {0, 3, 6}, new int[] {-1, 0, 0}, new double[] {-1, 0, 0, 0, -1, 0, 1, 0, -1, 0, 1, 0}, false);
        assertThat(isHung(forked, 1 / 3.0)).isFalse();
    }
}
