// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;

class LogarithmTest {
    @Property(seed = "5")
    void isThatOfTheLibraryToTwoUlps(@ForAll @DoubleRange(min = -320, max = 308) double exponent) {
        compare(Math.pow(10, exponent));
    }

    @Property(seed = "6")
    void isThatOfTheLibraryForOrdinaryArguments(@ForAll @DoubleRange(min = 0, max = 10) double x) {
        compare(x);
    }

    private static void compare(double x) {
        double expected = StrictMath.log1p(x);
        assertThat(Logarithm.ofOnePlus(x)).isCloseTo(expected, within(2 * Math.ulp(expected)));
    }
}
