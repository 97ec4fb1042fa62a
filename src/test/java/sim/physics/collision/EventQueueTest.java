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

    @Test
    void eventsThatArePlannedAgainTakeNoMemory() {
        for (int k = 0; k < 100_000; k++) {
            plan(random.nextInt(1000));
        }
        assertThat(queue.capacity()).isLessThanOrEqualTo(8 * BODIES);
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
            if (item >= 0) {
                pairs.setTime(item, Double.NaN);
            } else {
                pathEnds.forget(~item);
            }
            count++;
        }
        assertThat(count).isEqualTo(expected);
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
