// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The references against numbers that were computed elsewhere, against one another, and against laws. */
class ReferencesTest {
    private static final BigDecimal ROD = new BigDecimal("14.715");

    @Test
    void theRodPendulumHasTheKnownPeriodAndPlaces() {
        EllipticPendulum rod = EllipticPendulum.released(ROD, BigDecimal.ZERO);
        assertThat(rod.period()).isCloseTo(1.9333348543732457828, within(4e-16));
        assertThat(rod.angle(10)).isCloseTo(0.77095762257477313339, within(2e-15));
        assertThat(rod.velocity(10)).isCloseTo(-4.59439683301697853, within(1e-14));
        assertThat(rod.angle(2000)).isCloseTo(-1.561831324501502258336, within(2e-15));
        assertThat(rod.angle(0)).isCloseTo(Math.PI / 2, within(1e-15));
    }

    @Test
    void theTurningPendulumSolvesItsEquationAndHasTheKnownPeriod() {
        // IFToMM A02 with N = 2: (3/3 + 2) q'' = −(3/2 + 2) g cos q, started at the top with 1 rad/s
        BigDecimal w = new BigDecimal("9.81").multiply(new BigDecimal("3.5")).divide(new BigDecimal(3));
        EllipticPendulum turning = EllipticPendulum.overTheTop(w, 1);
        assertThat(turning.period()).isCloseTo(1.9425149226070836835, within(4e-16));
        double energy = 0.5 + w.doubleValue();
        for (double t = 0; t < 5; t += 0.37) {
            double v = turning.velocity(t);
            assertThat(v * v / 2 - w.doubleValue() * Math.cos(turning.angle(t))).isCloseTo(energy, within(1e-13));
        }
        assertThat(turning.velocity(0)).isCloseTo(1, within(1e-14));
        double h = 1e-5;
        assertThat((turning.angle(0.8 + h) - turning.angle(0.8 - h)) / (2 * h))
                .isCloseTo(turning.velocity(0.8), within(1e-7));
    }

    @ParameterizedTest
    @CsvSource({"10, 7.5272290155603557074, -4.9062623197150037263", "2, -1.662115135816127581, -1.04146663719322474"})
    void chainsAreWhereTwoIntegratorsAndTheKnownValuesAgree(int n, double x, double y) {
        RodChain chain = new RodChain(n, 9.81);
        for (boolean gragg : new boolean[] {true, false}) {
            double[] tip = chain.tip(chain.states(new double[] {1}, gragg, 1e-14)[0]);
            assertThat(tip[0]).isCloseTo(x, within(2e-12));
            assertThat(tip[1]).isCloseTo(y, within(2e-12));
        }
    }

    @Test
    void theRodBouncesAtTheKnownTimesAndKeepsItsEnergy() {
        RodBounce rod = new RodBounce(1, 0, 1 / 12.0, 1.5, 0.3, 9.81);
        assertThat(rod.next(9)).isCloseTo(0.525058104967551426, within(1e-15));
        assertThat(rod.next(9)).isCloseTo(0.5536245351263932, within(1e-14));
        for (int k = 2; k < 10; k++) {
            rod.next(9);
        }
        assertThat(rod.energy()).isCloseTo(14.715, within(1e-13));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 100, 1e4, 1e6})
    void blocksCountTheDigitsOfPi(double ratio) {
        int digits = (int) (Math.PI * Math.sqrt(ratio));
        assertThat(ClosedForms.blockImpacts(ratio)).isEqualTo(digits);
        double[] late = ClosedForms.blocks(ratio, 1, 2, 100);
        double[] later = ClosedForms.blocks(ratio, 1, 2, 101);
        double small = later[0] - late[0];
        double large = later[1] - late[1];
        assertThat(small * small + ratio * large * large).isCloseTo(ratio, within(1e-11 * ratio));
        assertThat(large).isGreaterThanOrEqualTo(small - 1e-12);
        double[] first = ClosedForms.blocks(ratio, 1, 2, 0.5);
        assertThat(first[0]).isCloseTo(1, within(1e-13));
        assertThat(first[1]).isCloseTo(1.5, within(1e-13));
    }

    @Test
    void ballsBounceAsTheGeometricSeriesSays() {
        double fall = Math.sqrt(2 / 9.81);
        assertThat(ClosedForms.bounce(1, 0.5, 9.81, 3 * fall)).isZero();
        assertThat(ClosedForms.bounce(1, 0.5, 9.81, 1.5 * fall)).isCloseTo(0.25, within(1e-15));
        assertThat(ClosedForms.bounce(1, 1, 9.81, 40 * fall)).isCloseTo(1, within(1e-12));
        assertThat(ClosedForms.folded(0.5, 1, 1, 1)).isCloseTo(0.5, within(1e-15));
        assertThat(ClosedForms.folded(0.5, -1, 2, 1)).isCloseTo(-0.5, within(1e-15));
    }

    @Test
    void theOscillatorSolvesItsEquation() {
        double h = 1e-4;
        for (double zeta : new double[] {0, 0.1, 1}) {
            double before = ClosedForms.oscillator(3, zeta, 0.4 - h);
            double at = ClosedForms.oscillator(3, zeta, 0.4);
            double after = ClosedForms.oscillator(3, zeta, 0.4 + h);
            double second = (after - 2 * at + before) / (h * h);
            double first = (after - before) / (2 * h);
            assertThat(second + 6 * zeta * first + 9 * at).isCloseTo(0, within(1e-5));
        }
    }

    @Test
    void discsKeepTheirEnergyAndComeBack() {
        double[] x = {-2, 0, 2, 0.3};
        double[] y = {0, 0.4, -0.2, 2};
        double[] u = {1.3, -0.2, -0.7, 0.1};
        double[] v = {0.3, 0.6, 0.2, -1};
        HardDiscs there = new HardDiscs(x, y, u, v, 0.5, 3);
        there.run(3);
        assertThat(there.impacts()).isGreaterThan(3);
        assertThat(there.energy()).isCloseTo(new HardDiscs(x, y, u, v, 0.5, 3).energy(), within(1e-14));
        HardDiscs two = new HardDiscs(new double[] {-1, 1}, new double[2], new double[] {1, 0}, new double[2], 0.5, 9);
        two.run(2);
        assertThat(two.place(0)[0]).isCloseTo(0, within(1e-15));
        assertThat(two.place(1)[0]).isCloseTo(2, within(1e-15));
    }

    @Test
    void theStiffPendulumNearlyKeepsItsLength() {
        ElasticPendulum stiff = new ElasticPendulum(1000, 1, 9.81);
        double[] t = {1, 2};
        double[][] gragg = stiff.states(stiff.start(1), t, true, 1e-13);
        double[][] dormand = stiff.states(stiff.start(1), t, false, 1e-13);
        EllipticPendulum rigid = EllipticPendulum.released(new BigDecimal("9.81"), new BigDecimal(Math.cos(1)));
        for (int k = 0; k < 2; k++) {
            assertThat(gragg[k][0]).isCloseTo(dormand[k][0], within(1e-12));
            assertThat(gragg[k][1]).isCloseTo(dormand[k][1], within(1e-11));
            assertThat(gragg[k][1]).isCloseTo(rigid.angle(t[k]), within(1e-4));
        }
    }

    @Test
    void theSqueezerIsWhereTheTestSetSays() {
        Squeezer squeezer = new Squeezer();
        double[] t = {0.03};
        double gragg = Squeezer.beta(squeezer.states(t, true, 1e-13)[0]);
        double dormand = Squeezer.beta(squeezer.states(t, false, 1e-13)[0]);
        assertThat(gragg).isCloseTo(15.8107711951, within(5e-9));
        assertThat(dormand).isCloseTo(gragg, within(1e-10));
    }

    /** The number is from a program of its own, with 30 digits and other panels. */
    @Test
    void theSqueezersEnergySaysWhereItIs() {
        Squeezer squeezer = new Squeezer();
        double[] state = squeezer.states(new double[] {0.03}, true, 1e-14)[0];
        SqueezerPath path = new SqueezerPath();
        assertThat(path.beta(0.03, Squeezer.beta(state))).isCloseTo(15.81077119515370709713, within(2e-15));
        double[] places = path.points(0.03, Squeezer.beta(state), 0.007);
        for (int k = 0; k < 7; k++) {
            assertThat(places[2 * k]).isCloseTo(state[3 * k] + 0.007 * Math.cos(state[3 * k + 2]), within(2e-14));
            assertThat(places[2 * k + 1]).isCloseTo(state[3 * k + 1] + 0.007 * Math.sin(state[3 * k + 2]), within(2e-14));
        }
    }

    @Test
    void aRodThatIsStruckTakesNewtonsImpulse() {
        // I11: J = (1 + e) v / (1 / m + 3 d² / (M L²))
        double[] state = new RodChain(new double[] {2}, 9.81).struck(0, 0.75, 0.5, 3, 0.8);
        double impulse = 1.8 * 3 / (1 / 0.5 + 3 * 0.75 * 0.75 / 2);
        assertThat(state[1]).isCloseTo(impulse * 0.75 * 3 / 2, within(1e-14));
        assertThat(state[2]).isCloseTo(3 - impulse / 0.5, within(1e-14));
    }

    /** Of a heavy chain on which a light rod ends the heavy part moves as if there were no light one. */
    @Test
    void aLightEndDoesNotMoveAHeavyRod() {
        double heavy = new RodChain(new double[] {1, 1e-9}, 9.81).states(new double[] {1}, true, 1e-13)[0][0];
        assertThat(heavy).isCloseTo(EllipticPendulum.released(ROD, BigDecimal.ZERO).angle(1) - Math.PI / 2, within(1e-7));
    }

    @Test
    void theSliderCrankKeepsItsRateWhereItHasTheSameInertia() {
        SliderCrank crank = new SliderCrank(0.6, 1, 0, 1, 5);
        assertThat(crank.computeDerivatives(0, new double[] {1 + 2 * Math.PI})[0]).isCloseTo(5, within(1e-13));
        double[] t = {0.7, 2};
        double[] gragg = crank.angles(1, t, true, 1e-14);
        double[] dormand = crank.angles(1, t, false, 1e-14);
        assertThat(gragg[1]).isCloseTo(dormand[1], within(1e-12));
        assertThat(crank.exactAngles(t, gragg)).containsExactly(gragg, within(1e-12));
        double[] p = crank.places(2);
        assertThat(Math.hypot(p[4] - p[0], p[5] - p[1])).isCloseTo(1, within(1e-15));
    }

    /** Textbook: a thin ladder leaves the wall at two thirds of its height. */
    @Test
    void aThinLadderLeavesTheWallAtTwoThirdsOfItsHeight() {
        double[] left = new Ladder(1, 0, 1 / 3.0, 9.81).leaves(1.1, 1e-13);
        assertThat(Math.sin(left[1])).isCloseTo(2.0 / 3 * Math.sin(1.1), within(1e-10));
        // (1/3 + 1) φ̇² / 2 = g (sin φ0 − sin φ)
        assertThat(left[2] * left[2]).isCloseTo(1.5 * 9.81 * (Math.sin(1.1) - Math.sin(left[1])), within(1e-10));
    }
}
