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
    void isThatOfTheLibrary(@ForAll @DoubleRange(min = -300, max = 300) double exponent) {
        double x = Math.pow(10, exponent);
        compare(x, 1, StrictMath.log(x));
    }

    @Property(seed = "6")
    void isThatOfTheLibraryForOrdinaryArguments(@ForAll @DoubleRange(min = 0.01, max = 10) double x) {
        compare(x, 1, StrictMath.log(x));
    }

    /** Where the two are nearly the same, what counts is their difference, which is exact. */
    @Property(seed = "7")
    void isThatOfTheLibraryNearOne(@ForAll @DoubleRange(min = -15, max = -1) double exponent, @ForAll boolean above) {
        double a = 1 + (above ? 1 : -1) * Math.pow(10, exponent);
        compare(a, 1, StrictMath.log1p(a - 1));
    }

    @Property(seed = "8")
    void isOfTheRatioAlone(@ForAll @DoubleRange(min = 1, max = 4) double a, @ForAll @DoubleRange(min = -300, max = 300) double power) {
        double b = Math.scalb(1.0, (int) power);
        compare(a * b, b, StrictMath.log(a));
        compare(b, a * b, -StrictMath.log(a));
    }

    private static void compare(double a, double b, double expected) {
        assertThat(Logarithm.ofRatio(a, b)).isCloseTo(expected, within(3 * Math.ulp(expected)));
    }
}
