// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Cosines and sines from the table against {@code StrictMath}'s; mirror images have mirrored bits. */
class SineTableTest {
    private static double[] of(double x) {
        double[] out = new double[5];
        SineTable.turn(x, 3, -2, out, 1);
        assertThat(out[3]).isEqualTo(Double.valueOf(3 * out[1] + 2 * out[2]));
        assertThat(out[4]).isEqualTo(Double.valueOf(3 * out[2] - 2 * out[1]));
        return new double[] {out[1], out[2]};
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 4, 300, 1.9e4, 1e6})
    void areRightToRoundingOfTheRadius(double range) {
        SplittableRandom random = new SplittableRandom(3);
        for (int k = 0; k < 200_000; k++) {
            double x = range * (2 * random.nextDouble() - 1);
            double[] found = of(x);
            assertThat(found[0]).isCloseTo(StrictMath.cos(x), within(0x1p-51));
            assertThat(found[1]).isCloseTo(StrictMath.sin(x), within(0x1p-51));
        }
    }

    @Test
    void areThoseOfTheMirrorImage() {
        SplittableRandom random = new SplittableRandom(4);
        for (int k = 0; k < 100_000; k++) {
            double x = 100 * random.nextDouble();
            assertThat(of(-x)).containsExactly(of(x)[0], -of(x)[1]);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {4, 1.9e4, 1e6})
    void quarterTurnsAddNoError(double range) {
        SplittableRandom random = new SplittableRandom(5);
        double[] out = new double[2];
        for (int k = 0; k < 10_000; k++) {
            double x = range * (2 * random.nextDouble() - 1);
            double[] known = of(x);
            for (int quarters = 0; quarters < 4; quarters++) {
                SineTable.direct(x, SineTable.quarters(quarters), out, 0);
                assertThat(out).containsExactly(known, within(0.0));
                known = new double[] {-known[1], known[0]};
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 4, 300, 1.9e4, 1e6})
    void partsOfATurnAddTheRoundingOfTheAngle(double range) {
        SplittableRandom random = new SplittableRandom(6);
        double[] out = new double[2];
        for (int k = 0; k < 100_000; k++) {
            double x = range * (2 * random.nextDouble() - 1);
            int quarters = random.nextInt(4);
            SineTable.directParts(SineTable.parts(x), SineTable.quarters(quarters), out, 0);
            double cos = StrictMath.cos(x);
            double sin = StrictMath.sin(x);
            double[] right = quarters % 2 == 0 ? new double[] {cos, sin} : new double[] {-sin, cos};
            double sign = quarters < 2 ? 1 : -1;
            assertThat(out[0]).isCloseTo(sign * right[0], within(0x1p-51 + 0x1p-52 * Math.abs(x)));
            assertThat(out[1]).isCloseTo(sign * right[1], within(0x1p-51 + 0x1p-52 * Math.abs(x)));
        }
    }

    @Test
    void areNothingForNoAngle() {
        assertThat(of(Double.NaN)).containsOnly(Double.NaN);
        assertThat(of(Double.POSITIVE_INFINITY)).containsOnly(Double.NaN);
        assertThat(of(0)).containsExactly(1, 0);
        double[] out = new double[2];
        SineTable.directParts(SineTable.parts(Double.NaN), SineTable.quarters(0), out, 0);
        assertThat(out).containsOnly(Double.NaN);
        SineTable.directParts(SineTable.parts(Double.NEGATIVE_INFINITY), SineTable.quarters(1), out, 0);
        assertThat(out).containsOnly(Double.NaN);
    }
}
