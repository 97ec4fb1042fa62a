// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A grid with cells of several sizes reports exactly the pairs that a look at all boxes does, while bodies change sizes and places. */
class CellLevelsTest {
    private static final int BODIES = 700;
    private static final int CHANGES = 8000;
    private static final int CHECK = 200;

    private final Boxes boxes = new Boxes();
    private final Pairs pairs = new Pairs();
    private final Pairs wanted = new Pairs();
    private final CellGrid grid = new CellGrid();
    private final BruteForce all = new BruteForce();
    private final boolean[] isIn = new boolean[BODIES];
    private SplittableRandom random;
    private double[] sizes;

    /** Somewhere, often in a cluster, where the coordinates are round or about the origin. */
    private void place(int body) {
        double size = sizes[random.nextInt(sizes.length)] * (0.5 + random.nextDouble());
        double spread = random.nextBoolean() ? 0.01 * sizes[sizes.length - 1] : 10 * sizes[sizes.length - 1];
        double x = spread * (random.nextDouble() - 0.5);
        double y = spread * (random.nextDouble() - 0.5);
        if (random.nextInt(4) == 0) {
            x = Math.rint(x / size) * size;
            y = Math.rint(y / size) * size;
        }
        double other = random.nextInt(4) == 0 ? 0.1 * size * random.nextDouble() : size;
        boolean isWide = random.nextBoolean();
        boxes.set(body, x, y, x + (isWide ? size : other), y + (isWide ? other : size));
    }

    private void change() {
        int body = random.nextInt(BODIES);
        if (!isIn[body]) {
            boxes.setFixed(body, random.nextInt(4) == 0);
            place(body);
            grid.add(body, boxes, pairs);
            all.add(body, boxes, wanted);
            isIn[body] = true;
        } else if (random.nextInt(10) == 0) {
            grid.remove(body, boxes, pairs);
            all.remove(body, boxes, wanted);
            isIn[body] = false;
        } else {
            place(body);
            grid.update(body, boxes, pairs);
            all.update(body, boxes, wanted);
        }
    }

    private TreeSet<Integer> codes(Pairs those) {
        TreeSet<Integer> codes = new TreeSet<>();
        for (int body = 0; body < BODIES; body++) {
            for (int k = 0; k < those.countOf(body); k++) {
                codes.add(Math.min(body, those.other(those.of(body, k), body)) * BODIES
                        + Math.max(body, those.other(those.of(body, k), body)));
            }
        }
        return codes;
    }

    @ParameterizedTest
    @CsvSource({
        "1, 1:0.01", "2, 1:1:1:30", "3, 0.001:0.001:0.001:1:30:1000", "4, 1e-9:1:1e9", "5, 0:0:0:1:1:200", "6, 1:1:1:8:8",
        "7, 1e-300:1:1e300"
    })
    void allReportWhatALookAtAllPairsGives(long seed, String kinds) {
        random = new SplittableRandom(seed);
        sizes = Arrays.stream(kinds.split(":")).mapToDouble(Double::parseDouble).toArray();
        boxes.ensure(BODIES);
        pairs.ensure(BODIES);
        wanted.ensure(BODIES);
        int checked = 0;
        for (int k = 1; k <= CHANGES; k++) {
            change();
            if (k % CHECK == 0) {
                assertThat(codes(pairs)).isEqualTo(codes(wanted));
                assertThat(pairs.count()).isEqualTo(wanted.count());
                checked += pairs.count();
            }
        }
        assertThat(checked).isPositive();
        assertThat(grid.levels()).isGreaterThan(1);
    }
}
