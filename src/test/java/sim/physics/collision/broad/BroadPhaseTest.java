// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Both broad phases report exactly the pairs whose boxes overlap, whatever happens to the boxes. */
class BroadPhaseTest {
    private static final int MOST = 120;
    private static final int CHANGES = 1500;

    /** One broad phase with its pairs; all share the boxes. */
    private static final class Watched implements Pairs.Listener {
        final BroadPhase phase;
        final Pairs pairs = new Pairs();

        /** The pairs that have begun and not ended, by what the listener was told. */
        final Set<Integer> told = new TreeSet<>();

        Watched(BroadPhase phase) {
            this.phase = phase;
            pairs.ensure(MOST);
            pairs.setListener(this);
        }

        @Override
        public void pairBegan(int pair) {
            assertThat(told.add(code(pair))).as("begins once").isTrue();
        }

        @Override
        public void pairEnded(int pair) {
            assertThat(told.remove(code(pair))).as("ends once").isTrue();
        }

        private int code(int pair) {
            assertThat(pairs.first(pair)).isLessThan(pairs.second(pair));
            return pairs.first(pair) * MOST + pairs.second(pair);
        }

        /** What the lists of the bodies and the look-up say agrees with what the listener was told. */
        void check(Set<Integer> expected, List<Integer> present) {
            assertThat(told).isEqualTo(expected);
            assertThat(pairs.count()).isEqualTo(expected.size());
            int entries = 0;
            for (int body : present) {
                int own = pairs.countOf(body);
                for (int k = 0; k < own; k++) {
                    assertThat(told).contains(code(pairs.of(body, k)));
                }
                entries += own;
            }
            assertThat(entries).isEqualTo(2 * expected.size());
        }
    }

    private final Boxes boxes = new Boxes();
    private final List<Integer> present = new ArrayList<>();
    private SplittableRandom random;

    /** All pairs, compared one by one. */
    private Set<Integer> bruteForce() {
        Set<Integer> all = new TreeSet<>();
        for (int a : present) {
            for (int b : present) {
                if (a < b && touch(a, b)) {
                    all.add(a * MOST + b);
                }
            }
        }
        return all;
    }

    private boolean touch(int a, int b) {
        if (boxes.isFixed(a) && boxes.isFixed(b)) {
            return false;
        }
        for (int axis = 0; axis < 2; axis++) {
            double[] d = boxes.data();
            double low = Math.max(d[Boxes.STRIDE * a + axis], d[Boxes.STRIDE * b + axis]);
            double high = Math.min(d[Boxes.STRIDE * a + axis + 2], d[Boxes.STRIDE * b + axis + 2]);
            if (low > high) {
                return false;
            }
        }
        return true;
    }

    /** A coordinate; often on a coarse lattice, so that boxes touch and coincide exactly. */
    private double coordinate() {
        double x = 100 * random.nextDouble() - 50;
        return switch (random.nextInt(4)) {
            case 0 -> x;
            case 1 -> Math.rint(x);
            case 2 -> 5 * Math.rint(x / 5);
            default -> 0.1 * Math.rint(x);
        };
    }

    /** Sizes from a point to larger than the world. */
    private double extent() {
        return switch (random.nextInt(12)) {
            case 0 -> 0;
            case 1 -> 1e-12;
            case 2 -> 1e3 * random.nextDouble();
            case 3, 4 -> 5;
            default -> 6 * random.nextDouble();
        };
    }

    private void place(int body) {
        double x = coordinate();
        double y = coordinate();
        boxes.set(body, x, y, x + extent(), y + extent());
    }

    private void move(int body) {
        double[] d = boxes.data();
        int o = Boxes.STRIDE * body;
        double dx = random.nextInt(3) - 1 + (random.nextBoolean() ? 0.3 * random.nextDouble() : 0);
        double dy = random.nextInt(3) - 1;
        boxes.set(body, d[o] + dx, d[o + 1] + dy, Math.max(d[o] + dx, d[o + 2] + dx), d[o + 3] + dy);
    }

    private void change(List<Watched> all) {
        int what = random.nextInt(10);
        if (present.isEmpty() || what == 0 && present.size() < MOST) {
            int body = 0;
            while (present.contains(body)) {
                body++;
            }
            present.add(body);
            boxes.setFixed(body, random.nextInt(5) == 0);
            place(body);
            for (Watched w : all) {
                w.phase.add(body, boxes, w.pairs);
            }
            return;
        }
        int at = random.nextInt(present.size());
        int body = present.get(at);
        if (what == 1 && random.nextBoolean()) {
            present.remove(at);
            for (Watched w : all) {
                w.phase.remove(body, boxes, w.pairs);
            }
            return;
        }
        if (what < 4) {
            place(body);
        } else {
            move(body);
        }
        for (Watched w : all) {
            w.phase.update(body, boxes, w.pairs);
        }
    }

    private void run(long seed, List<Supplier<BroadPhase>> phases) {
        random = new SplittableRandom(seed);
        boxes.ensure(MOST);
        List<Watched> all = new ArrayList<>();
        for (Supplier<BroadPhase> phase : phases) {
            all.add(new Watched(phase.get()));
        }
        int pairs = 0;
        for (int k = 0; k < CHANGES; k++) {
            change(all);
            Set<Integer> expected = bruteForce();
            pairs += expected.size();
            for (Watched w : all) {
                w.check(expected, present);
            }
        }
        assertThat(pairs).isGreaterThan(CHANGES);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void allReportWhatLookingAtAllPairsGives(long seed) {
        run(seed, List.of(SortAndSweep::new, CellGrid::new, BruteForce::new));
    }

    @Test
    void aCrowdThatGrowsLaysTheGridAnew() {
        SplittableRandom places = new SplittableRandom(9);
        Watched grid = new Watched(new CellGrid());
        Watched sweep = new Watched(new SortAndSweep());
        boxes.ensure(MOST);
        for (int body = 0; body < MOST; body++) {
            double x = 40 * places.nextDouble();
            double size = body < 10 ? 0.01 : 3; // the first ones make the cells far too small
            boxes.set(body, x, x / 2, x + size, x / 2 + size);
            present.add(body);
            for (Watched w : List.of(grid, sweep)) {
                w.phase.add(body, boxes, w.pairs);
                w.check(bruteForce(), present);
            }
        }
    }
}
