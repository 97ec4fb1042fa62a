// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import java.util.function.IntConsumer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Hard case G18: in scenes that are meant to be hard, the grid compares no more than 5 (n log₂ n + pairs) boxes in a step in
 * which all boxes change; and G04: that is so for dust about a planet, too.
 */
class BroadPhaseWorkTest {
    private static final int STEPS = 4;

    private final Boxes boxes = new Boxes();
    private final Pairs pairs = new Pairs();
    private final CellGrid grid = new CellGrid();
    private final SplittableRandom random = new SplittableRandom(1);

    private void square(int body, double x, double y, double size) {
        boxes.set(body, x, y, x + size, y + size);
    }

    /** The most boxes compared in a step, over n log₂ n + pairs; boxes are placed anew for each step. */
    private double work(int n, IntConsumer place) {
        boxes.ensure(n);
        pairs.ensure(n);
        for (int body = 0; body < n; body++) {
            place.accept(body);
            grid.add(body, boxes, pairs);
        }
        double worst = 0;
        for (int step = 0; step < STEPS; step++) {
            long before = grid.looks();
            for (int body = 0; body < n; body++) {
                place.accept(body);
                grid.update(body, boxes, pairs);
            }
            worst = Math.max(worst, (grid.looks() - before) / (n * StrictMath.log(n) / StrictMath.log(2) + pairs.count()));
        }
        return worst;
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 1000, 30_000})
    void aColumn(int n) {
        assertThat(work(n, body -> square(body, 0, 1.01 * body + 0.1 * random.nextDouble(), 1))).isLessThan(5);
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 1000, 30_000})
    void aLargeBoxOverAll(int n) {
        double side = Math.sqrt(n);
        assertThat(work(n, body -> {
                    if (body == n / 2) {
                        square(body, -10, -10, 2 * side + 20);
                    } else {
                        square(body, 2 * side * random.nextDouble(), 2 * side * random.nextDouble(), 1);
                    }
                }))
                .isLessThan(5);
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 1000, 30_000})
    void allJumpAnywhere(int n) {
        double side = 100 * Math.sqrt(n);
        assertThat(work(n, body -> square(body, side * random.nextDouble(), side * random.nextDouble(), 1))).isLessThan(5);
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 1000, 3000})
    void allInOneCell(int n) {
        assertThat(work(n, body -> square(body, 0.5 * random.nextDouble(), 0.5 * random.nextDouble(), 1))).isLessThan(5);
        assertThat(pairs.count()).isEqualTo(n * (n - 1) / 2);
    }

    /** Grains of 10⁻⁶ about a disc of 10⁶. */
    @ParameterizedTest
    @ValueSource(ints = {1000, 10_000, 100_000})
    void dustAboutAPlanet(int n) {
        double side = 1e-5 * Math.sqrt(n);
        assertThat(work(n, body -> {
                    if (body == 0) {
                        square(0, -1e6, -2e6, 2e6);
                    } else {
                        square(body, side * random.nextDouble(), side * random.nextDouble(), 1e-6);
                    }
                }))
                .isLessThan(1);
    }
}
