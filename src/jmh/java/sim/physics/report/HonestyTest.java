// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
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

    /** A run is the coarsest that will do if what is cheaper by a tenth misses what was asked for; finer ones do not count. */
    @Test
    void theCoarsestRunThatWillDoIsHeld() {
        Point run = point(1e-6, 1e-9, 100);
        Point cheaper = point(1e-5, 2e-6, 89);
        Point asDear = point(1e-4, 1e-7, 91);
        Point finer = point(1e-7, 1e-12, 50);
        List<Point> all = List.of(run, cheaper, asDear, finer);
        assertThat(Held.isCoarsest(run, all, 1e-6)).isTrue();
        assertThat(Held.isCoarsest(run, all, 3e-6)).isFalse();
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
