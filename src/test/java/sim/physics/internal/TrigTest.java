// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

/** Sine and cosine are right to an ulp, and the same bits on every machine. */
class TrigTest {
    /** Computed once; the same on every JDK, interpreted or compiled. */
    private static final long GOLDEN = 1040686416688260707L;

    private static final double[] NOT_FINITE = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};

    private final double[] pair = new double[2];

    private static long ulps(double a, double b) {
        return Math.abs(ordered(a) - ordered(b));
    }

    /** Neighbouring numbers get neighbouring integers. */
    private static long ordered(double value) {
        long bits = Double.doubleToLongBits(value);
        return bits < 0 ? Long.MIN_VALUE - bits : bits;
    }

    /** The larger error of sine and cosine; and that the fused form has the same bits. */
    private long error(double x) {
        double sin = Trig.sin(x);
        double cos = Trig.cos(x);
        Trig.sinCos(x, pair, 0);
        if (Double.doubleToLongBits(pair[0]) != Double.doubleToLongBits(cos)
                || Double.doubleToLongBits(pair[1]) != Double.doubleToLongBits(sin)) {
            throw new AssertionError("sinCos(" + x + ") differs");
        }
        return Math.max(ulps(sin, StrictMath.sin(x)), ulps(cos, StrictMath.cos(x)));
    }

    private static double random(SplittableRandom random, int low, int high) {
        double magnitude = Math.scalb(1 + random.nextDouble(), random.nextInt(low, high));
        return random.nextBoolean() ? magnitude : -magnitude;
    }

    @Test
    void randomArgumentsAreRightToAnUlp() {
        SplittableRandom random = new SplittableRandom(1);
        long worst = 0;
        for (int k = 0; k < 1_000_000; k++) {
            worst = Math.max(worst, error(random(random, -30, 17)));
        }
        assertThat(worst).isLessThanOrEqualTo(1);
    }

    @Test
    void argumentsNearEveryEighthOfATurnAreRightToAnUlp() {
        long worst = 0;
        for (int k = 1; k <= 127_400; k++) {
            double centre = k * (Math.PI / 4);
            for (int j = -2; j <= 2; j++) {
                double x = centre + j * Math.ulp(centre);
                worst = Math.max(worst, Math.max(error(x), error(-x)));
            }
        }
        assertThat(worst).isLessThanOrEqualTo(1);
    }

    @Property(seed = "1")
    void anyArgumentIsRightToAnUlp(@ForAll double x) {
        assertThat(error(x)).isLessThanOrEqualTo(1);
    }

    @Test
    void largeArgumentsAreThoseOfStrictMath() {
        SplittableRandom random = new SplittableRandom(2);
        for (int k = 0; k < 10_000; k++) {
            assertThat(error(random(random, 17, 1023))).isZero();
        }
        assertThat(error(Math.nextDown(1e5))).isLessThanOrEqualTo(1);
        assertThat(error(1e5)).isZero();
        assertThat(error(Double.MAX_VALUE)).isZero();
    }

    @Test
    void zerosKeepTheirSign() {
        for (double zero : new double[] {0.0, -0.0}) {
            assertThat(error(zero)).isZero();
            assertThat(Double.doubleToLongBits(Trig.sin(zero))).isEqualTo(Double.doubleToLongBits(zero));
            assertThat(Trig.cos(zero)).isEqualTo(1);
        }
    }

    @Test
    void tinyArgumentsAreTheirOwnSines() {
        for (double x : new double[] {Double.MIN_VALUE, 1e-310, Double.MIN_NORMAL, 1e-200, 1e-20, -1e-9}) {
            assertThat(Trig.sin(x)).isEqualTo(x);
            assertThat(Trig.cos(x)).isEqualTo(1);
        }
    }

    @Test
    void whatIsNotFiniteGivesNotANumber() {
        for (double x : NOT_FINITE) {
            assertThat(Trig.sin(x)).isNaN();
            assertThat(Trig.cos(x)).isNaN();
            Trig.sinCos(x, pair, 0);
            assertThat(pair).containsExactly(Double.NaN, Double.NaN);
        }
        assertThat(Trig.atan2(Double.NaN, 1)).isNaN();
        assertThat(Trig.atan2(1, Double.NaN)).isNaN();
    }

    @Test
    void mirroredAnglesHaveMirroredBits() {
        SplittableRandom random = new SplittableRandom(3);
        for (int k = 0; k < 100_000; k++) {
            double x = random(random, -20, 18);
            assertThat(Trig.sin(-x) == -Trig.sin(x) && Trig.cos(-x) == Trig.cos(x)).isTrue();
        }
    }

    @Test
    void theFusedFormWritesCosineThenSineWhereItIsTold() {
        double[] out = {7, 7, 7, 7};
        Trig.sinCos(0, out, 1);
        assertThat(out).containsExactly(7, 1, 0, 7);
        assertThatThrownBy(() -> Trig.sinCos(1, out, 3)).isInstanceOf(IndexOutOfBoundsException.class);
    }

    @Test
    void theAngleOfAVectorIsThatOfStrictMath() {
        assertThat(Trig.atan2(0, -1)).isEqualTo(Math.PI);
        assertThat(Trig.atan2(-0.0, -1)).isEqualTo(-Math.PI);
        assertThat(Trig.atan2(1, 2)).isEqualTo(StrictMath.atan2(1, 2));
    }

    @Test
    void aHundredThousandResultsHaveTheirGoldenHash() {
        SplittableRandom random = new SplittableRandom(4);
        long hash = 17;
        for (int k = 0; k < 100_000; k++) {
            double x = random(random, -30, 20);
            hash = 31 * hash + Double.doubleToLongBits(Trig.sin(x));
            hash = 31 * hash + Double.doubleToLongBits(Trig.cos(x));
        }
        assertThat(hash).isEqualTo(GOLDEN);
    }
}
