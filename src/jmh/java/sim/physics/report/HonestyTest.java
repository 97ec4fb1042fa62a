// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
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

    private static Point point(double tolerance, double error, long forces) {
        Point point = new Point(tolerance);
        point.error = error;
        point.counts = Map.of("forces", forces);
        return point;
    }

    /** A run whose setting is multiplied by 10^(k/4): error and evaluations by k. */
    private static boolean isCoarsest(double asked, double[] errors, long[] forces) {
        return Held.isCoarsest(point(1e-6, 1e-9, 100), tolerance -> {
            int k = (int) Math.round(4 * Math.log10(tolerance / 1e-6)) - 1;
            return k < errors.length ? point(tolerance, errors[k], forces[k]) : null;
        }, asked);
    }

    /** A run is the coarsest that will do if errors become larger than was asked for before a tenth is saved. */
    @Test
    void theCoarsestRunThatWillDoIsHeld() {
        assertThat(isCoarsest(1e-6, new double[] {1e-7, 2e-6}, new long[] {95, 89})).isTrue();
        assertThat(isCoarsest(1e-6, new double[] {1e-7, 9e-7}, new long[] {95, 89})).isFalse();
        assertThat(isCoarsest(1e-6, new double[] {1e-7, 1e-7}, new long[] {95, 91})).isTrue(); // and none is coarser
    }

    /** What is cheaper and good by luck, beyond a setting that is not good, cannot be relied on. */
    @Test
    void aSettingThatIsGoodByChanceDoesNotCount() {
        assertThat(isCoarsest(1e-6, new double[] {2e-6, 1e-7}, new long[] {95, 50})).isTrue();
    }

    /** s² + 2 ζ ω s + ω² = 0 has the roots −ω (ζ ± √(ζ² − 1)). */
    @Test
    void theFastestDecayIsThatOfTheSpring() {
        assertThat(Held.decay(OtherScenes.spring(100, 0.1).model)).isCloseTo(10, within(1e-12));
        assertThat(Held.decay(OtherScenes.spring(100, 1.25).model)).isCloseTo(200, within(1e-9));
        assertThat(Held.decay(JointScenes.chain(2, 1).model)).isZero();
    }

    /** 12 stages a step: 1,200 evaluations in 2 s are steps of 0.02 s. */
    @Test
    void stepsOfTheExplicitMethodAreToldByItsStages() {
        ReportScene scene = OtherScenes.spring(100, 0.1);
        for (Curve curve : Curve.all(scene, new PythonPeers("none"))) {
            double step = Held.step(point(1e-6, 0, 1200), curve, 2);
            assertThat(step).isEqualTo(curve.method().equals("DOP853") ? 0.02 : 0);
        }
    }

    /**
     * A damped oscillator: a change of velocity by u ω leaves u e^(−ζωt) sin(ω′t) ω/ω′ after t. Squares, of one per 1/ω, sum
     * up to u²/(4 ζ) (1 − ζ²) (ω/ω′)² = u²/(4 ζ), as long as the first instant of comparison is late. It does not come back to
     * where it was: nothing else adds up.
     */
    @Test
    void theAmplificationOfADampedOscillatorIsTheClosedForm() {
        ReportScene scene = OtherScenes.spring(100, 0.1);
        assertThat(new Amplification(scene).measure()).isCloseTo(Math.sqrt(1 / 0.4), within(0.35 * Math.sqrt(1 / 0.4)));
    }

    /**
     * A swinging pendulum comes back to the same states, and steps make the same errors there: its phase is off by the square
     * of the time, not by its power of 3/2 as by errors that have nothing to do with one another.
     */
    @Test
    void theAmplificationOfAPendulumGrowsWithTheSquareOfTheTime() {
        double shorter = new Amplification(JointScenes.pointPendulum(20)).measure();
        double longer = new Amplification(JointScenes.pointPendulum(160)).measure();
        assertThat(Math.log(longer / shorter) / Math.log(8)).isBetween(1.75, 2.25);
    }

    /** So what a tolerance gives over a long time can be told from a short one. */
    @Test
    void errorsOverTheAmplificationAreAsLargeInLongRunsAsInShortOnes() {
        double[] ratios = new double[2];
        for (int k = 0; k < 2; k++) {
            ReportScene scene = JointScenes.pointPendulum(k == 0 ? 20 : 320);
            double grown = new Amplification(scene).measure();
            for (Curve curve : Curve.all(scene, new PythonPeers("none"))) {
                if (curve.method().equals("Radau IIA")) {
                    ratios[k] = Measurement.untimed(scene, curve, 1e-7, scene.expected.get()).error / (1e-7 * grown);
                }
            }
        }
        assertThat(ratios[1] / ratios[0]).isBetween(0.5, 2.0);
    }
}
