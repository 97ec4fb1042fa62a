// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.internal.IntList;
import sim.physics.shape.Circle;

/** Between the ends of a step dense output has the order that it should have, and at both ends it is the step. */
class DenseOutputTest {
    /** A pendulum x″ = −sin x in one coordinate, a damped oscillator in another. */
    private static final EquationsOfMotion EQUATIONS = new EquationsOfMotion() {
        @Override
        public void acceleration(IntList bodies, double time, double[] a) {
            a[0] = -StrictMath.sin(STATE.x()[0]);
            a[1] = -4 * STATE.x()[1] - 0.2 * STATE.v()[1];
            a[2] = 0;
        }
    };

    private static final State STATE = new State();
    private static final IntList GROUP = new IntList();

    static {
        STATE.add(new Body(new Circle(1)));
        GROUP.add(0);
    }

    private static void start() {
        STATE.x()[0] = 1;
        STATE.x()[1] = 0.5;
        STATE.v()[0] = 0.7;
        STATE.v()[1] = -0.3;
    }

    /** Places and velocities after a time, by many steps of order 8. */
    private static double[] exact(double time) {
        start();
        AdaptiveIntegrator method = new DormandPrince853(1e-15);
        Path path = new Path();
        for (double done = 0; done != time; ) {
            double stride = method.advance(EQUATIONS, STATE, GROUP, done, time - done, path);
            done = stride == time - done ? time : done + stride;
        }
        return new double[] {STATE.x()[0], STATE.x()[1], STATE.v()[0], STATE.v()[1]};
    }

    private static double error(double[] exact) {
        return Math.max(
                Math.max(Math.abs(STATE.x()[0] - exact[0]), Math.abs(STATE.x()[1] - exact[1])),
                Math.max(Math.abs(STATE.v()[0] - exact[2]), Math.abs(STATE.v()[1] - exact[3])));
    }

    /** The output of one step of a length. */
    private static DenseOutput step(AdaptiveIntegrator method, double length) {
        start();
        Path path = new Path();
        assertThat(method.goOn(EQUATIONS, STATE, GROUP, 0, length, path)).isEqualTo(length);
        double[] end = {STATE.x()[0], STATE.x()[1], STATE.v()[0], STATE.v()[1]};
        DenseOutput output = new DenseOutput();
        assertThat(method.makeDense(EQUATIONS, STATE, GROUP, 0, length, path, output)).isTrue();
        assertThat(error(end)).isZero();
        output.put(STATE, GROUP, 1);
        assertThat(error(end)).isLessThan(1e-15);
        return output;
    }

    private static double worst(DenseOutput output) {
        double most = 0;
        for (int k = 1; k < 8; k++) {
            double[] exact = exact(k * output.length / 8);
            output.put(STATE, GROUP, k / 8.0);
            most = Math.max(most, error(exact));
        }
        return most;
    }

    @ParameterizedTest
    @CsvSource({"DOP853, 0.4, 8", "Radau, 0.1, 5"})
    void theErrorOfAStepFallsWithTheOrder(String name, double length, int power) {
        AdaptiveIntegrator method = name.equals("Radau") ? new RadauIIA(1e-5) : new DormandPrince853(1);
        double coarse = worst(step(method, length));
        double fine = worst(step(method, 0.5 * length));
        assertThat(StrictMath.log(coarse / fine) / StrictMath.log(2)).isBetween(power - 0.5, power + 1.5);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1e-6, 1e-9, 1e-12})
    void bootstrappedOutputIsAsAccurateAsItSays(double tolerance) {
        AdaptiveIntegrator method = new GraggBulirschStoer(tolerance);
        double length = 0.5 * StrictMath.pow(tolerance, 1.0 / 12);
        assertThat(worst(step(method, length))).isLessThan(10 * tolerance);
    }

    /** A bootstrapped output that cannot be so accurate says so. */
    @Test
    void bootstrappingGivesUp() {
        start();
        AdaptiveIntegrator method = new GraggBulirschStoer(1e-11);
        Path path = new Path();
        double length = method.goOn(EQUATIONS, STATE, GROUP, 0, 1.2, path);
        assertThat(Bootstrap.make(0, length, path.stages, new DenseOutput(), 2, 1)).isFalse();
    }

    /** The accelerations that an output tells are the slopes of its velocities. */
    @Test
    void accelerationsAreSlopes() {
        DenseOutput output = step(new DormandPrince853(1), 0.4);
        double[] a = new double[State.BLOCK];
        for (int k = 0; k <= 8; k++) {
            output.put(STATE, GROUP, k / 8.0 + 1e-6);
            double above = STATE.v()[0];
            output.put(STATE, GROUP, k / 8.0 - 1e-6);
            output.accelerations(GROUP, k / 8.0, a);
            assertThat(a[0]).isCloseTo((above - STATE.v()[0]) / (2e-6 * 0.4), within(1e-8));
        }
    }
}
