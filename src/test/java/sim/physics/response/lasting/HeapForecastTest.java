// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import sim.physics.internal.IntList;

/** Forces that are polynomials of time are foretold, and those that jump about are those of the last solution. */
class HeapForecastTest {
    private final HeapSystem system = new HeapSystem();
    private final HeapForecast forecast = new HeapForecast();
    private final IntList names = new IntList();

    HeapForecastTest() {
        ContactPoint point = new ContactPoint();
        point.ny = 1;
        point.normalMobility = 1;
        point.tangentMobility = 2;
        system.clear();
        system.enter(0, 1, 1);
        system.add(-1, 0, point);
        names.add(7);
    }

    /** What is foretold for a time after some steps; the impulse that was there is 99. */
    private double after(int steps, DoubleUnaryOperator force) {
        for (int k = 0; k < steps; k++) {
            forecast.begin(names);
            system.start(0, 0.1 * force.applyAsDouble(k), 0.2 * force.applyAsDouble(k));
            forecast.keep(system, k, 0.1);
        }
        system.start(0, 99, 0);
        forecast.begin(names);
        forecast.start(system, steps, 0.1);
        return system.normalImpulse(0) / 0.1;
    }

    @Test
    void aLineIsFollowed() {
        assertThat(after(4, t -> 3 + 2 * t)).isEqualTo(11, within(1e-12));
    }

    @Test
    void aParabolaIsFollowed() {
        assertThat(after(6, t -> 1 + t * t)).isEqualTo(37, within(1e-11));
        assertThat(system.tangentImpulse(0)).isEqualTo(7.4, within(1e-11));
    }

    @Test
    void whatJumpsIsNotFollowed() {
        assertThat(after(7, t -> t % 2 == 0 ? 5 : 3)).isEqualTo(990, within(1e-9)); // left as it was
    }

    @Test
    void otherPointsHaveNoPast() {
        after(6, t -> 1 + t);
        names.add(8);
        system.add(-1, 0, new ContactPoint());
        system.start(0, 99, 0);
        forecast.begin(names);
        forecast.start(system, 6, 0.1);
        assertThat(system.normalImpulse(0)).isEqualTo(99);
    }
}
