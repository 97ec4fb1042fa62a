// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.OpenGroups;

/** What {@link Impacts} knows of each group: how large it is, what strikes in it, and whether that gives anything back. */
final class MetGroups implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of the speed that forces make in a step which is no bounce: it would be over within a part of the step. */
    private static final double BRIEF = 0.1;

    /** Times as fast as forces make it in a step is what bounces in spite of them. */
    private static final double SLOW = 4;

    /** Points of a group up to which what bears it is solved with what strikes. */
    private static final int MANY = 64;

    private final ContactRows rows;
    private final Groups groups;

    /** The number of points and stops that have met in the substep, and whether one of them gives something back. */
    int[] counts = {};

    /** The number of points that have part in that, whether they have met or lie there. */
    int[] parts = {};

    boolean[] giveBack = {};

    /** Whether it is mirrored by {@link Reflections}, and not solved otherwise. */
    boolean[] areReflected = {};

    /** Whether joints or springs tie bodies, and whether joints do. */
    boolean[] areTied = {};

    boolean[] areJoined = {};

    /** The number of points, and whether one of them may bounce. */
    private int[] sizes = {};

    private boolean[] mayBounce = {};

    /** Whether bodies that can move touch one another, and nothing that its author moves. */
    private boolean[] passesOn = {};

    /** The largest speed at which something strikes, and the largest one that forces make in the step. */
    private double[] fastest = {};

    private double[] loads = {};

    MetGroups(ContactRows rows, Groups groups) {
        this.rows = rows;
        this.groups = groups;
    }

    /** Begins a step. */
    void begin() {
        if (counts.length < groups.count) {
            int n = groups.slots.length;
            counts = new int[n];
            parts = new int[n];
            giveBack = new boolean[n];
            areReflected = new boolean[n];
            areTied = new boolean[n];
            areJoined = new boolean[n];
            sizes = new int[n];
            mayBounce = new boolean[n];
            passesOn = new boolean[n];
            fastest = new double[n];
            loads = new double[n];
        }
        Arrays.fill(areTied, 0, groups.count, false);
        Arrays.fill(areJoined, 0, groups.count, false);
        groups.markTied(areTied, areJoined);
        Arrays.fill(sizes, 0, groups.count, 0);
        Arrays.fill(mayBounce, 0, groups.count, false);
        Arrays.fill(passesOn, 0, groups.count, false);
        for (int k = 0; k < rows.count; k++) {
            if (groups.has(k, rows)) {
                sizes[groups.of(k, rows)] += rows.pointCount(k);
                mayBounce[groups.of(k, rows)] |= rows.mayBounce(k);
                passesOn[groups.of(k, rows)] |= groups.isMovable(rows.first(k)) && groups.isMovable(rows.second(k));
            }
        }
        for (int k = 0; k < rows.count; k++) {
            if (groups.has(k, rows) && groups.isOnMovedGround(k, rows)) {
                passesOn[groups.of(k, rows)] = false;
            }
        }
    }

    /** Begins a substep. */
    void open() {
        Arrays.fill(counts, 0, groups.count, 0);
        Arrays.fill(parts, 0, groups.count, 0);
        Arrays.fill(giveBack, 0, groups.count, false);
        Arrays.fill(fastest, 0, groups.count, 0);
        Arrays.fill(loads, 0, groups.count, 0);
    }

    /** A point strikes; forces alone make so much speed of it in a step. */
    void strike(int group, double speed, double load, boolean bounces) {
        counts[group]++;
        giveBack[group] |= bounces;
        fastest[group] = Math.max(fastest[group], speed);
        loads[group] = Math.max(loads[group], load);
    }

    /** Whether joints tie bodies of a group in which something has met. */
    boolean areSomeJoined() {
        boolean yes = false;
        for (int g = 0; !yes && g < groups.count; g++) {
            yes = counts[g] > 0 && areJoined[g];
        }
        return yes;
    }

    /** Forgets what strikes too slowly. */
    void dropSlow() {
        for (int g = 0; g < groups.count; g++) {
            if (fastest[g] < BRIEF * loads[g]) {
                counts[g] = 0;
                giveBack[g] = false;
            }
        }
    }

    /** Forgets what strikes slowly in large groups in which nothing gives anything back: a substep solves it well enough. */
    void dropLarge() {
        for (int g = 0; g < groups.count; g++) {
            counts[g] = isLarge(g) && isLoaded(g) ? 0 : counts[g];
        }
    }

    /** Ends the turns of such groups, which settle in none that could be waited for. */
    void closeLarge(OpenGroups turns) {
        for (int g = 0; g < groups.count; g++) {
            if (isLarge(g)) {
                turns.close(g);
            }
        }
    }

    /** Whether a group may be mirrored with what bears it: a small one without joints, on what is fixed, that something strikes much faster than forces make it. */
    boolean mayBeSupported(int group) {
        return counts[group] > 0 && passesOn[group] && !areTied[group] && !groups.areFree[group] && !groups.areRubbed() && sizes[group] <= MANY && !isLoaded(group);
    }

    /** Whether there are many points in a group, and nothing gives anything back that meets in it. */
    private boolean isLarge(int group) {
        return sizes[group] > Impacts.FEW && !giveBack[group];
    }

    /** Whether nothing in a group strikes faster than forces could make it: most of what it takes is a load, which Poisson's law would give back. */
    boolean isLoaded(int group) {
        return fastest[group] < SLOW * loads[group];
    }

    boolean areSome() {
        boolean yes = false;
        for (int g = 0; !yes && g < groups.count; g++) {
            yes = counts[g] > 0;
        }
        return yes;
    }

    /** Whether a group is small, and nothing in it bounces. */
    boolean isPlastic(int group) {
        return sizes[group] <= Impacts.FEW && !mayBounce[group];
    }
}
