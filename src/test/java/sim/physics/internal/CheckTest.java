// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;

/** Good values come back, bad ones are named. */
class CheckTest {
    private static void refused(String message, ThrowingCallable call) {
        assertThatIllegalArgumentException().isThrownBy(call).withMessage(message);
    }

    @Test
    void goodValuesComeBack() {
        assertThat(Check.finite("x", -Double.MAX_VALUE)).isEqualTo(-Double.MAX_VALUE);
        assertThat(Check.positive("x", Double.MIN_VALUE)).isEqualTo(Double.MIN_VALUE);
        assertThat(Check.notNegative("x", 0)).isZero();
        assertThat(Check.between("x", 1, 1, 2)).isEqualTo(1);
        assertThat(Check.between("x", 2, 1, 2)).isEqualTo(2);
    }

    @Test
    void whatIsNotFiniteIsRefused() {
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY}) {
            refused("x is " + bad + ": it must be finite", () -> Check.finite("x", bad));
            refused("x is " + bad + ": it must be a finite number greater than 0", () -> Check.positive("x", bad));
            refused("x is " + bad + ": it must be a finite number, not negative", () -> Check.notNegative("x", bad));
            refused("x is " + bad + ": it must be from 0.0 to 1.0", () -> Check.between("x", bad, 0, 1));
        }
    }

    @Test
    void whatIsOutOfRangeIsRefused() {
        refused("mass is 0.0: it must be a finite number greater than 0", () -> Check.positive("mass", 0));
        refused("mass is -1.0: it must be a finite number greater than 0", () -> Check.positive("mass", -1));
        refused("friction is -4.9E-324: it must be a finite number, not negative",
                () -> Check.notNegative("friction", -Double.MIN_VALUE));
        refused("restitution is 1.1: it must be from 0.0 to 1.0", () -> Check.between("restitution", 1.1, 0, 1));
        refused("restitution is -0.1: it must be from 0.0 to 1.0", () -> Check.between("restitution", -0.1, 0, 1));
    }
}
