// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.report.Honesty.Verdict;

/** mvn -Pbench test -Dtest=HonestyTest. */
class HonestyTest {
    @Test
    void errorsAreComparedWithToleranceTimesAmplification() {
        assertThat(Honesty.verdict(4e-6, 1e-6, 8, 1)).isEqualTo(Verdict.WITHIN);
        assertThat(Honesty.verdict(7e-7, 1e-6, 8, 1)).isEqualTo(Verdict.SMALLER);
        assertThat(Honesty.verdict(9e-5, 1e-6, 8, 1)).isEqualTo(Verdict.LARGER);
        assertThat(Honesty.verdict(9e-13, 1e-13, 1, 1)).isEqualTo(Verdict.LOST);
    }

    /** Errors are relative to the unit of the scene, tolerances are lengths. */
    @Test
    void theUnitOfLengthCounts() {
        assertThat(Honesty.verdict(5e-4, 1e-6, 1, 0.01)).isEqualTo(Verdict.WITHIN);
        assertThat(Honesty.verdict(5e-4, 1e-6, 1, 0.00001)).isEqualTo(Verdict.SMALLER);
    }

    @Test
    void anErrorThatCouldBeAsLargeAsTheSceneIsNoSmallOne() {
        assertThat(Honesty.verdict(1e-3, 1e-3, 2000, 1)).isEqualTo(Verdict.SCENE);
        assertThat(Honesty.verdict(1e-3, 1e-3, 900, 1)).isEqualTo(Verdict.SMALLER);
        assertThat(Honesty.verdict(30, 1e-3, 2000, 1)).isEqualTo(Verdict.LARGER);
    }

    /**
     * A damped oscillator: a change of velocity by u ω leaves u e^(−ζωt) sin(ω′t) ω/ω′ after t. Squares, of one per 1/ω, sum
     * up to u²/(4 ζ) (1 − ζ²) (ω/ω′)² = u²/(4 ζ), as long as the first instant of comparison is late.
     */
    @Test
    void theAmplificationOfADampedOscillatorIsTheClosedForm() {
        ReportScene scene = OtherScenes.spring(100, 0.1);
        assertThat(new Amplification(scene).measure()).isCloseTo(Math.sqrt(1 / 0.4), within(0.35 * Math.sqrt(1 / 0.4)));
    }

    /** A swinging pendulum's phase goes on being wrong, so what errors leave grows with the time, and squares of it add up. */
    @Test
    void theAmplificationOfAPendulumGrowsWithTheTime() {
        double shorter = new Amplification(JointScenes.pointPendulum(20)).measure();
        double longer = new Amplification(JointScenes.pointPendulum(80)).measure();
        assertThat(longer / shorter).isBetween(4.0, 16.0); // 4 to the power 1.5, at instants at random
    }
}
