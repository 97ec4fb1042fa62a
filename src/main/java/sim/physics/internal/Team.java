// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import java.io.Serializable;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Several threads that do one piece of work together: the calling thread, and helpers from the common pool of the JVM, or
 * from the {@code ForkJoinPool} that the caller is in. No thread belongs to a team, so engines may come and go; a helper
 * that finds no time to help is not waited for; one that has taken a portion is.
 *
 * <p>The items of a work must not depend on each other: which thread does which, and when, is left open. Nothing is
 * allocated when a work is done.
 */
public final class Team implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Portions per thread, so that one that is late holds up the others by little. */
    private static final int PORTIONS = 8;

    /**
     * Looks for more work after which a helper goes home: 50 to 200 µs, depending on the processor. To be called costs the caller
     * 30 to 50 µs, and the helper as much again.
     */
    private static final int PATIENCE = 4000;

    /** Looks for a helper that has not finished after which the caller lets others use its processor. */
    private static final int LOOKS = 500;

    private static final int COUNT_BITS = 32;
    private static final long COUNT = (1L << COUNT_BITS) - 1;

    /** Something to be done to each of a number of items. */
    public interface Work {
        /**
         * Does what there is to do for an item.
         *
         * @param worker 0 for the calling thread, or the number of a helper, less than the size of the team; at any time
         *     there is one thread at most with that number
         * @param item number of the item
         */
        void work(int worker, int item);
    }

    private final int size;
    private final boolean always;
    private transient Helper[] helpers;

    /** Number of the work, and how many of its portions nobody has taken yet. */
    private transient AtomicLong open;

    /** Portions that are done. */
    private transient AtomicInteger done;

    private transient Work work;
    private transient int items;
    private transient int portions;

    private transient Throwable failure;
    private transient int failed;
    private long works;

    /**
     * Makes a team; it starts no thread.
     *
     * @param size number of threads, the calling one included, 2 or more
     * @param always whether works are shared that are too small for it to pay, for tests
     */
    public Team(int size, boolean always) {
        this.size = size;
        this.always = always;
    }

    /**
     * Whether it pays to share a work.
     *
     * @param count number of its items
     * @param least number from which on it pays
     * @return true if it is to be done together
     */
    public boolean pays(int count, int least) {
        return count >= (always ? 2 : least);
    }

    /**
     * Number of threads at most.
     *
     * @return the calling one included
     */
    public int size() {
        return size;
    }

    /**
     * Number of works that were done together.
     *
     * @return since the team was made
     */
    public long works() {
        return works;
    }

    /**
     * Does a work. If items throw something, the others are done all the same, or not at all.
     *
     * @param what the work
     * @param count number of its items, 0 … count − 1
     * @return the first item that threw something, in the order of the items; −1 if none did
     */
    public int run(Work what, int count) {
        wake();
        works++;
        work = what;
        items = count;
        portions = Math.min(count, PORTIONS * size);
        failure = null;
        failed = -1;
        done.set(0);
        long number = (open.get() >>> COUNT_BITS) + 1;
        open.set(number << COUNT_BITS | portions);
        for (int k = 0; k < helpers.length && k + 1 < count; k++) {
            helpers[k].call();
        }
        while (doPortion(0)) {
            // go on
        }
        for (int looks = 0; done.get() < portions; looks++) {
            if (looks < LOOKS) {
                Thread.onSpinWait();
            } else {
                Thread.yield(); // somebody who helps was interrupted
            }
        }
        work = null;
        return failed;
    }

    /**
     * What the item threw that {@link #run} returned.
     *
     * @return an unchecked exception or an error
     */
    public Throwable failure() {
        return failure;
    }

    /**
     * Throws what an item threw.
     *
     * @param thrown what {@link #failure()} returned
     */
    public static void rethrow(Throwable thrown) {
        if (thrown instanceof Error error) {
            throw error;
        }
        throw (RuntimeException) thrown;
    }

    /** Takes a portion and does it; false if there is none. */
    private boolean doPortion(int worker) {
        long now = open.get();
        while ((now & COUNT) != 0) {
            if (open.compareAndSet(now, now - 1)) {
                int portion = portions - (int) (now & COUNT); // nobody changes the work before this one is done
                int from = (int) ((long) items * portion / portions);
                int to = (int) ((long) items * (portion + 1) / portions);
                for (int item = from; item < to; item++) {
                    try {
                        work.work(worker, item);
                    } catch (RuntimeException | Error e) {
                        fail(item, e);
                        break;
                    }
                }
                done.incrementAndGet();
                return true;
            }
            now = open.get();
        }
        return false;
    }

    private synchronized void fail(int item, Throwable e) {
        if (failed < 0 || item < failed) {
            failed = item;
            failure = e;
        }
    }

    private void wake() {
        if (helpers == null) {
            open = new AtomicLong();
            done = new AtomicInteger();
            helpers = new Helper[size - 1];
            for (int k = 0; k < helpers.length; k++) {
                helpers[k] = new Helper(this, k + 1);
            }
        }
    }

    /** Somebody who looks for portions for a while, whenever called. */
    private static final class Helper extends ForkJoinTask<Void> {
        private static final long serialVersionUID = 1L;

        private final transient Team team;
        private final int number;
        private final AtomicBoolean called = new AtomicBoolean();

        Helper(Team team, int number) {
            this.team = team;
            this.number = number;
        }

        void call() {
            if (!called.get() && called.compareAndSet(false, true)) {
                fork();
            }
        }

        @Override
        protected boolean exec() {
            for (int looks = 0; looks < PATIENCE; looks++) {
                if (team.doPortion(number)) {
                    looks = 0;
                } else {
                    Thread.onSpinWait();
                }
            }
            called.set(false);
            return false; // never done: it can be called again
        }

        @Override
        public Void getRawResult() {
            return null;
        }

        @Override
        protected void setRawResult(Void value) {
            // there is none
        }
    }
}
