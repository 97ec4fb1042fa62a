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
 * which all boxes change; and G04: that is so for dust about a planet, too. So it is where sizes are mixed, which a grid with cells of
 * one size has to answer with a look at all that are larger, or at all that are crowded in a cell.
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

    /** A wall for each body: a list of walls would be looked at by all. */
    @ParameterizedTest
    @ValueSource(ints = {100, 1000, 30_000})
    void aMaze(int n) {
        double side = 5 * Math.sqrt(0.5 * n);
        assertThat(work(n, body -> {
                    double x = side * random.nextDouble();
                    double y = side * random.nextDouble();
                    boxes.setFixed(body, body % 2 == 0);
                    boxes.set(body, x, y, x + (body % 2 == 0 ? 4 : 0.5), y + (body % 4 == 0 ? 4 : 0.5));
                }))
                .isLessThan(5);
    }

    /** One boulder for so many grains that are in clusters between them, as sand is. */
    @ParameterizedTest
    @ValueSource(ints = {5, 12, 40})
    void boulders(int grains) {
        int n = 20_000;
        double side = Math.sqrt(n / (double) grains);
        assertThat(work(n, body -> {
                    double x = Math.floor(side * random.nextDouble());
                    double y = Math.floor(side * random.nextDouble());
                    if (body % grains == 0) {
                        square(body, x, y, 1);
                    } else {
                        square(body, x + 0.2 * random.nextDouble(), y + 0.2 * random.nextDouble(), 0.01);
                    }
                }))
                .isLessThan(5);
    }

    /** Three decades, as many in each. */
    @ParameterizedTest
    @ValueSource(ints = {100, 1000, 30_000})
    void sizesOfAllKinds(int n) {
        double side = 30 * Math.sqrt(n);
        assertThat(work(n, body -> {
                    double size = StrictMath.pow(10, 3 * random.nextDouble() - 2);
                    square(body, side * random.nextDouble(), side * random.nextDouble(), size);
                }))
                .isLessThan(5);
    }

    /** Boxes grow with speeds: they fit the cells at first, and from some step on one in ten does not. */
    @ParameterizedTest
    @ValueSource(ints = {1000, 30_000})
    void someGrow(int n) {
        double side = 10 * Math.sqrt(n);
        int[] changes = {0};
        assertThat(work(n, body -> {
                    boolean isFast = changes[0]++ > 2 * n && body % 10 == 0;
                    square(body, side * random.nextDouble(), side * random.nextDouble(), isFast ? 3 : 1);
                }))
                .isLessThan(8);
    }
}
