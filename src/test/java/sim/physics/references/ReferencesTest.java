// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The references against values of thirty digits that other programs found. */
class ReferencesTest {
    @ParameterizedTest
    @CsvSource({
        "2, -1.662115135816127581, -1.04146663719322474",
        "10, 7.5272290155603557074, -4.9062623197150037263"
    })
    void theTipsOfRodsAfterOneSecond(int rods, double x, double y) {
        double[] tip = RodChain.tip(rods, 1);
        assertThat(tip[0]).isCloseTo(x, within(1e-13));
        assertThat(tip[1]).isCloseTo(y, within(1e-13));
    }

    @Test
    void twoTolerancesAgreeAfterThreeSeconds() {
        double[] fine = RodChain.tip(10, 3);
        double[] finer = RodChain.tip(10, 3, 1e-14);
        assertThat(StrictMath.hypot(fine[0] - finer[0], fine[1] - finer[1])).isLessThan(2e-12);
    }

    @Test
    void aRodAfterTenSeconds() {
        double omega0 = StrictMath.sqrt(1.5 * RodChain.G);
        assertThat(Swing.angle(omega0, 10)).isCloseTo(0.77095762257477313339, within(2e-14));
        assertThat(4 * Swing.quarter(omega0)).isCloseTo(1.9333348543732457828, within(1e-15));
        double[] tip = RodChain.tip(1, 10);
        assertThat(StrictMath.atan2(tip[0], -tip[1])).isCloseTo(Swing.angle(omega0, 10), within(1e-12));
    }

    @Test
    void aRodBouncesAtTheTimesThatAreKnown() {
        assertThat(RodBounce.after(1.5, 0.3, 0, 0.53)[3]).isCloseTo(0.525058104967551426, within(1e-14));
        assertThat(RodBounce.after(1.5, 0.3, 0, 0.56)[3]).isCloseTo(0.5536245351263932, within(1e-13));
        assertThat(RodBounce.after(1.5, 0.3, 0, 0.56)[2]).isEqualTo(2);
    }
}
