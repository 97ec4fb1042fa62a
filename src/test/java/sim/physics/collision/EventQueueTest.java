// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sim.physics.collision.broad.Pairs;

/** What will happen comes in its order, each event once, and takes memory by what will happen, not by what was planned. */
class EventQueueTest {
    private static final int BODIES = 40;

    private final Pairs pairs = new Pairs();
    private final PathEnds pathEnds = new PathEnds();
    private final EventQueue queue = new EventQueue(pairs, pathEnds);
    private final SplittableRandom random = new SplittableRandom(3);

    EventQueueTest() {
        pairs.ensure(BODIES);
        for (int k = 1; k < BODIES; k++) {
            pairs.begin(k - 1, k);
            pairs.setTime(k - 1, Double.NaN);
        }
    }

    private void plan(double time) {
        int item = random.nextInt(BODIES - 1);
        if (random.nextInt(10) == 0) {
            pathEnds.plan(item, time);
            queue.add(time, ~item);
        } else {
            pairs.setTime(item, time);
            queue.add(time, item);
        }
    }

    /** In the first step all lies in one heap; in the second one, in many spans, since so much has happened in the first. */
    @Test
    void eventsThatArePlannedAgainTakeNoMemory() {
        for (int step = 0; step < 3; step++) {
            queue.begin(1000);
            for (int k = 0; k < 100_000; k++) {
                plan(random.nextInt(1000));
            }
            assertAllComeInOrder();
        }
    }

    private void assertAllComeInOrder() {
        assertThat(queue.capacity()).isLessThanOrEqualTo(16 * BODIES);
        double last = 0;
        int count = 0;
        int expected = 0;
        for (int k = 0; k < BODIES - 1; k++) {
            expected += (Double.isNaN(pairs.time(k)) ? 0 : 1) + (Double.isNaN(pathEnds.end(k)) ? 0 : 1);
        }
        while (queue.hasNext()) {
            int item = queue.firstItem();
            assertThat(queue.firstTime()).isGreaterThanOrEqualTo(last);
            assertThat(queue.firstTime()).isEqualTo(item >= 0 ? pairs.time(item) : pathEnds.end(~item));
            last = queue.firstTime();
            queue.removeFirst();
            forget(item);
            count++;
        }
        assertThat(count).isEqualTo(expected);
    }

    /** As in a step: what has come leads to new events, some of them at once, and calls off others. */
    @Test
    void eventsThatArePlannedMeanwhileComeInTheirOrder() {
        for (int step = 0; step < 20; step++) {
            queue.begin(1);
            for (int k = 0; k < BODIES; k++) {
                plan(random.nextDouble());
            }
            double last = 0;
            for (int count = 0; count < 300 && queue.hasNext(); count++) {
                double now = queue.firstTime();
                int item = queue.firstItem();
                assertThat(now).isGreaterThanOrEqualTo(last).isEqualTo(earliest());
                queue.removeFirst();
                forget(item);
                plan(random.nextInt(5) == 0 ? now : now + (1 - now) * random.nextDouble());
                last = now;
            }
            while (queue.hasNext()) {
                forget(queue.firstItem());
            }
        }
    }

    private void forget(int item) {
        if (item >= 0) {
            pairs.setTime(item, Double.NaN);
        } else {
            pathEnds.forget(~item);
        }
    }

    private double earliest() {
        double first = Double.POSITIVE_INFINITY;
        for (int k = 0; k < BODIES - 1; k++) {
            first = pairs.time(k) < first ? pairs.time(k) : first;
            first = pathEnds.end(k) < first ? pathEnds.end(k) : first;
        }
        return first;
    }

    @Test
    void oneEventThatIsPlannedForTheSameInstantAgainTakesNoMemory() {
        for (int k = 0; k < 10_000; k++) {
            pairs.setTime(3, 0.5);
            queue.add(0.5, 3);
        }
        assertThat(queue.capacity()).isLessThanOrEqualTo(32);
        assertThat(queue.hasNext()).isTrue();
    }
}
