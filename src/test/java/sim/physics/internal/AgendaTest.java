// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** An agenda says in each step what was scheduled to it last, each item once, however often it was scheduled anew. */
class AgendaTest {
    private static final int ITEMS = 700;

    @Test
    void whatIsDueIsWhatATableOfDatesSays() {
        SplittableRandom random = new SplittableRandom(5);
        Agenda agenda = new Agenda();
        agenda.ensure(ITEMS);
        long[] dates = new long[ITEMS];
        Arrays.fill(dates, Agenda.NEVER);
        int seen = 0;
        for (long step = 1; step < 3000; step++) {
            long now = step;
            IntList due = agenda.advance(step);
            int[] expected = IntStream.range(0, ITEMS).filter(k -> dates[k] == now).toArray();
            int[] found = Arrays.copyOf(due.values, due.size);
            Arrays.sort(found);
            assertThat(found).as("step %d", step).isEqualTo(expected);
            seen += found.length;
            for (int item : expected) {
                dates[item] = Agenda.NEVER;
            }
            for (int k = 0; k < 120; k++) {
                int item = random.nextInt(ITEMS);
                long ahead = random.nextInt(4) == 0 ? random.nextLong(1, 1000) : random.nextLong(1, 70);
                dates[item] = random.nextInt(8) == 0 ? Agenda.NEVER : step + ahead;
                agenda.schedule(item, dates[item]);
                assertThat(agenda.date(item)).isEqualTo(dates[item]);
            }
        }
        assertThat(seen).isGreaterThan(10_000);
    }

    /** Nobody asks while something else than events moves the bodies. What was due then would have been due in four million steps. */
    @Test
    void whatWasDueInStepsThatWereLeftOutIsDueInTheNextOne() {
        SplittableRandom random = new SplittableRandom(6);
        Agenda agenda = new Agenda();
        agenda.ensure(ITEMS);
        long[] dates = new long[ITEMS];
        Arrays.fill(dates, Agenda.NEVER);
        int seen = 0;
        for (long step = 1; step < 1_000_000; step += random.nextInt(3) == 0 ? random.nextLong(1, 10_000) : random.nextLong(1, 90)) {
            long now = step;
            IntList due = agenda.advance(step);
            int[] found = Arrays.copyOf(due.values, due.size);
            Arrays.sort(found);
            assertThat(found).as("step %d", step).isEqualTo(IntStream.range(0, ITEMS).filter(k -> dates[k] <= now).toArray());
            seen += found.length;
            for (int item : found) {
                dates[item] = Agenda.NEVER;
            }
            for (int k = 0; k < 120; k++) {
                int item = random.nextInt(ITEMS);
                dates[item] = step + (random.nextInt(4) == 0 ? random.nextLong(1, 20_000) : random.nextLong(1, 70));
                agenda.schedule(item, dates[item]);
            }
        }
        assertThat(seen).isGreaterThan(10_000);
    }

    @Test
    void whatIsFarAheadIsPutOffWhileThereIsNoRoomLeft() {
        SplittableRandom random = new SplittableRandom(7);
        Agenda agenda = new Agenda();
        int most = 60_000;
        long[] dates = new long[most];
        Arrays.fill(dates, Agenda.NEVER);
        int items = 0;
        for (long step = 1; step < 1000; step++) {
            long now = step;
            IntList due = agenda.advance(step);
            int[] found = Arrays.copyOf(due.values, due.size);
            Arrays.sort(found);
            assertThat(found).as("step %d", step).isEqualTo(
                    IntStream.range(0, items).filter(k -> dates[k] == now).toArray());
            items += random.nextInt(60);
            agenda.ensure(items);
            for (int k = 0; k < 40 && items > 0; k++) { // mostly new ones, far ahead: they are moved on every 63 steps
                int item = random.nextInt(3) == 0 ? random.nextInt(items) : Math.max(0, items - 1 - k);
                dates[item] = step + random.nextLong(1, 700);
                agenda.schedule(item, dates[item]);
            }
        }
        assertThat(items).isLessThan(most);
    }

    @Test
    void itemsThatAreScheduledAgainInOneStepTakeNoMemory() {
        SplittableRandom random = new SplittableRandom(6);
        Agenda agenda = new Agenda();
        agenda.ensure(ITEMS);
        long[] dates = new long[ITEMS];
        Arrays.fill(dates, Agenda.NEVER);
        agenda.advance(1);
        for (int k = 0; k < 200_000; k++) {
            int item = random.nextInt(ITEMS);
            dates[item] = random.nextInt(3) == 0 ? Agenda.NEVER : 2 + random.nextInt(80);
            agenda.schedule(item, dates[item]);
        }
        assertThat(agenda.places()).isLessThanOrEqualTo(12 * ITEMS);
        for (long step = 2; step < 90; step++) {
            long now = step;
            IntList due = agenda.advance(step);
            int[] found = Arrays.copyOf(due.values, due.size);
            Arrays.sort(found);
            int[] expected = IntStream.range(0, ITEMS).filter(k -> dates[k] == now).toArray();
            assertThat(found).as("step %d", step).isEqualTo(expected);
        }
    }

    @Test
    void whatLiesInRecordsOfOthersLeavesTheirBitsAndWordsAlone() {
        SplittableRandom random = new SplittableRandom(8);
        int[] records = new int[4 * ITEMS];
        int[] others = new int[4 * ITEMS];
        for (int k = 0; k < records.length; k++) {
            others[k] = k % 4 == 2 ? random.nextInt() & Agenda.SPARE : random.nextInt();
            records[k] = k % 4 == 2 ? others[k] | Agenda.EMPTY : others[k];
        }
        Agenda agenda = new Agenda(2, 2);
        agenda.setRecords(records);
        long[] dates = new long[ITEMS];
        Arrays.fill(dates, Agenda.NEVER);
        long first = (1L << 23) - 500; // where the dates' bits begin anew
        for (long step = first; step < first + 1000; step++) {
            long now = step;
            IntList due = agenda.advance(step);
            int[] found = Arrays.copyOf(due.values, due.size);
            Arrays.sort(found);
            assertThat(found).as("step %d", step).isEqualTo(
                    IntStream.range(0, ITEMS).filter(k -> dates[k] == now).toArray());
            for (int k = 0; k < 120; k++) {
                int item = random.nextInt(ITEMS);
                dates[item] = random.nextInt(8) == 0 ? Agenda.NEVER : step + random.nextLong(1, 300);
                agenda.schedule(item, dates[item]);
                assertThat(agenda.date(item)).isEqualTo(dates[item]);
            }
            assertThat(IntStream.range(0, records.length).map(k -> k % 4 == 2 ? records[k] & Agenda.SPARE : records[k]).toArray())
                    .isEqualTo(others);
        }
    }

    @Test
    void whatIsWantedTooFarAheadIsDueEarlier() {
        Agenda agenda = new Agenda();
        agenda.ensure(2);
        agenda.advance(7);
        agenda.schedule(0, 1L << 40);
        agenda.schedule(1, 7 + Agenda.AHEAD - 1L);
        for (long step = 8; step < 7 + Agenda.AHEAD - 1L; step++) {
            assertThat(agenda.advance(step).size).isZero();
        }
        assertThat(agenda.advance(7 + Agenda.AHEAD - 1L).values[0]).isEqualTo(1);
        assertThat(agenda.advance(7L + Agenda.AHEAD).values[0]).isZero();
    }
}
