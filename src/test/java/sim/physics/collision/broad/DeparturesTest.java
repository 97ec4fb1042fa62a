// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import sim.physics.internal.IntList;

/** Bodies that leave their boxes in one step leave the same pairs, old and new ones, in whatever order they are looked at. */
class DeparturesTest {
    private static final int BODIES = 400;

    /** A grid with the pairs that have begun in the present step. */
    private static final class Watched implements Pairs.Listener {
        final CellGrid grid = new CellGrid();
        final Boxes boxes = new Boxes();
        final Pairs pairs = new Pairs();
        final Set<Integer> fresh = new TreeSet<>();

        Watched() {
            boxes.ensure(BODIES);
            pairs.ensure(BODIES);
            pairs.setListener(this);
        }

        @Override
        public void pairBegan(int pair) {
            assertThat(fresh.add(code(pair))).isTrue();
        }

        @Override
        public void pairEnded(int pair) {
            fresh.remove(code(pair));
        }

        int code(int pair) {
            return BODIES * pairs.first(pair) + pairs.second(pair);
        }

        Set<Integer> all() {
            Set<Integer> all = new TreeSet<>();
            for (int body = 0; body < BODIES; body++) {
                for (int k = 0; k < pairs.countOf(body); k++) {
                    all.add(code(pairs.of(body, k)));
                }
            }
            return all;
        }
    }

    @Test
    void theOrderDoesNotMatter() {
        SplittableRandom random = new SplittableRandom(11);
        Watched one = new Watched();
        Watched other = new Watched();
        double[] x = new double[BODIES];
        double[] y = new double[BODIES];
        for (int body = 0; body < BODIES; body++) {
            x[body] = random.nextDouble(40);
            y[body] = random.nextDouble(40);
            for (Watched w : new Watched[] {one, other}) {
                w.boxes.set(body, x[body], y[body], x[body] + 3, y[body] + 3);
                w.grid.add(body, w.boxes, w.pairs);
            }
        }
        Departures departures = new Departures();
        int restarted = 0;
        for (int step = 0; step < 60; step++) {
            one.fresh.clear();
            other.fresh.clear();
            Set<Integer> before = one.all();
            IntList leaving = some(random);
            double[] nextX = x.clone();
            double[] nextY = y.clone();
            departures.begin(leaving, BODIES);
            for (int k = 0; k < leaving.size; k++) {
                int body = leaving.values[k];
                nextX[body] += random.nextDouble(-4, 4);
                nextY[body] += random.nextDouble(-4, 4);
                one.boxes.set(body, nextX[body], nextY[body], nextX[body] + 3, nextY[body] + 3);
                one.grid.update(body, one.boxes, one.pairs);
                departures.keep(body, other.boxes);
                other.boxes.set(body, nextX[body], nextY[body], nextX[body] + 3, nextY[body] + 3);
            }
            shuffle(leaving, random);
            for (int k = 0; k < leaving.size; k++) {
                other.grid.update(leaving.values[k], other.boxes, other.pairs, departures);
            }
            assertThat(other.all()).isEqualTo(one.all());
            assertThat(other.fresh).isEqualTo(one.fresh);
            before.retainAll(one.fresh);
            restarted += before.size();
            x = nextX;
            y = nextY;
        }
        assertThat(restarted).as("pairs that ended and began anew").isGreaterThan(20);
    }

    private static IntList some(SplittableRandom random) {
        IntList some = new IntList();
        for (int body = 0; body < BODIES; body++) {
            if (random.nextInt(3) == 0) {
                some.add(body);
            }
        }
        shuffle(some, random);
        return some;
    }

    private static void shuffle(IntList list, SplittableRandom random) {
        for (int k = list.size - 1; k > 0; k--) {
            int m = random.nextInt(k + 1);
            int swap = list.values[k];
            list.values[k] = list.values[m];
            list.values[m] = swap;
        }
    }
}
