// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import java.io.Serializable;

/**
 * What a step costs, in units that are counted and not timed, so that a run is the same on any machine: a unit is the acceleration of
 * one body, or a look at a pair, some tenths of a microsecond each. Whoever is about to spend more than is allowed is stopped.
 */
public final class Work implements Serializable {
    private static final long serialVersionUID = 1L;

    /** More than any step may cost. */
    public static final long UNLIMITED = Long.MAX_VALUE;

    /** Work for each body of a group whose work is apart that does not count: that of a step in some hundreds of parts. */
    private static final long USUAL = 10_000;

    private long done;
    private int evaluations;

    /** How many looks at pairs it has taken note of. */
    private transient long looks;

    /** What may be spent in the step, and up to where. */
    private transient long most = UNLIMITED;

    private transient long limit = UNLIMITED;

    /** Whether a step is on its way, and whether what it does now counts for a group alone. */
    private transient boolean isOn;

    private transient boolean isApart;

    /** What the group has spent. */
    private transient long apart;

    /** Makes one that has no limit. */
    public Work() {
        // nothing is done yet
    }

    /** Says that the work of a step is done, and there is more to do. It has no trace of calls: nothing is wrong with them. */
    public static final class Spent extends RuntimeException {
        private static final long serialVersionUID = 1L;

        private Spent() {
            super("the work of a step is spent", null, false, false);
        }
    }

    /**
     * Begins a step.
     *
     * @param most units that may be spent in it
     * @param looks how many looks there were at pairs so far
     */
    public void begin(long most, long looks) {
        this.looks = looks;
        this.most = most;
        limit = most < UNLIMITED - done ? done + most : UNLIMITED;
        isOn = true;
        isApart = false;
    }

    /** Ends the step: what is asked between steps does not count. */
    public void end() {
        limit = UNLIMITED;
        isOn = false;
    }

    /**
     * Lets what is spent count for groups of bodies, each apart, and not for the step: threads may share it, and who does how much of it is
     * left open.
     *
     * @param yes false to go on
     */
    public void apart(boolean yes) {
        isApart = yes;
    }

    /** A group's turn begins. */
    public void beginGroup() {
        apart = 0;
    }

    /**
     * Does for groups what another one does, in another thread.
     *
     * @param other that of the step
     */
    public void match(Work other) {
        most = other.most;
        isOn = other.isOn;
        isApart = true;
    }

    /**
     * A group's turn is over. What it has spent beyond what is usual counts for the step: all groups together would else have no limit.
     *
     * @param bodies how many there are in it
     * @throws Spent if that is more than is allowed
     */
    public void endGroup(int bodies) {
        long more = isApart ? apart - USUAL * bodies : 0;
        apart = 0;
        if (more > 0) {
            isApart = false;
            try {
                spend(more);
            } finally {
                isApart = true;
            }
        }
    }

    /** A group has spent all that a step may: so has the step. */
    public void endWithGroup() {
        done = limit < UNLIMITED ? Math.max(done, limit) : done;
    }

    /** {@return units that the group has spent} */
    public long spentApart() {
        return apart;
    }

    /**
     * Takes over what another thread has spent on the group whose turn it is.
     *
     * @param units not negative
     */
    public void takeOver(long units) {
        apart += units;
    }

    /**
     * Takes note of work.
     *
     * @param units not negative
     * @throws Spent if that is more than is allowed
     */
    public void spend(long units) {
        if (!isOn) {
            return;
        }
        if (isApart) {
            apart += units;
        } else {
            done += units;
        }
        if (isApart ? apart > most : done > limit) {
            isOn = false; // what is left is to be put in order
            throw new Spent();
        }
    }

    /**
     * Takes note of work, and of the looks at pairs since the last note of looks.
     *
     * @param units not negative
     * @param looks how many looks there were so far
     * @throws Spent if that is more than is allowed
     */
    public void spend(long units, long looks) {
        long since = looks - this.looks;
        this.looks = looks;
        spend(units + since);
    }

    /**
     * Takes note that the accelerations of a group were asked for.
     *
     * @param units how many bodies, and what was solved for them since the last time
     * @throws Spent if that is more than is allowed
     */
    public void evaluate(long units) {
        evaluations++;
        spend(units);
    }

    /** {@return whether a step is on its way, so that what is done counts} */
    public boolean isOn() {
        return isOn;
    }

    /** {@return how often accelerations were asked for, in steps and between them} */
    public int evaluations() {
        return evaluations;
    }

    /** {@return units spent since it was made} */
    public long done() {
        return done;
    }

    private Object readResolve() {
        most = UNLIMITED;
        limit = UNLIMITED;
        return this;
    }
}
