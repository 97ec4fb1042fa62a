// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import sim.physics.internal.Tolerances;

/** The gaps of lasting pairs: how deep they may be, which gap is kept for that, and how a missing one is regained. */
final class HeapGaps {
    /** Height of an edge's other end from which it is no contact, relative to the smaller body. */
    private static final double FLAT = 2e-2;

    /** How deep a pair may be, relative to the smaller body. */
    private static final double CUSHION = 1e-10;

    /** The same at least, in units of what rounding may make of a gap: that at which pairs touch. */
    private static final double ROUNDED = 0.25;

    /** The same in heaps with driven bodies, whose paths are not quite the motion. */
    private static final double DRIVEN_CUSHION = 1e-7;

    /** The same where a solution was not quite right; and the part of it that it may have been wrong by. */
    private static final double FAIR_CUSHION = 1e-4;

    private static final double FAIR = 0.25;

    /** How deep a pair of a large heap may be while it moves. */
    private static final double LARGE_CUSHION = 1e-3;

    /** What a large heap regains in a step at most, relative to the smaller body. */
    private static final double MOST_REGAINED = 1e-2;

    /** Growth of the root of the depth of a pair that has become too deep too often, relative to that which it may have else. */
    private static final double DEEPER = 2;

    /** Part of a missing gap that a solution regains. */
    private static final double REGAIN = 0.2;

    /**
     * What gaps are rounded to, in parts of the depth that is allowed: next to nothing must not decide which of several supports bear
     * a body.
     */
    private static final double GRAIN = 0.01;

    /** The same of bodies that are driven and not tied: their velocities are right to as much in a step. */
    private static final double DRIVEN_GRAIN = 0.25;

    /** How many of these a gap may be wider than the one that is kept, to be let be. */
    private static final double LET_BE = 4;

    /** Part of the depth that a solution may be wrong by, if it has to be. */
    private static final double LITTLE = 1e-2;

    /** Part of the depth from which on a point is as deep as it may be, but for rounding. */
    private static final double NEARLY = 0.99;

    /** How much deeper a pair may be then, in units of that depth, where its way is known and leads out; and how deep at most. */
    private static final double SLACK = 0.25;

    private static final double MOST_SLACK = 2;

    /** Part of the depth by which a way that is known leads out. */
    private static final double OUT = 0.5;

    private HeapGaps() {}

    /** The same relative to the two bodies, of which both may be larger. */
    static double flat(double size, double radii) {
        return FLAT * size / radii;
    }

    /** How deep a pair of free bodies may be that moves at most. */
    static double fairDepth(double size) {
        return 1.01 * FAIR_CUSHION * size;
    }

    /** How deep a pair may be. */
    static double depth(boolean isDriven, double size) {
        return (isDriven ? DRIVEN_CUSHION : CUSHION) * size;
    }

    /** The same far from the origin, where rounding of coordinates hides such a depth: bodies would be parted for ever by impacts of nothing. */
    static double depth(boolean isDriven, double size, double rounding) {
        return Math.max(depth(isDriven, size), ROUNDED * rounding);
    }

    /** How deep a pair may be whose way is known, and leads out of where it is too deep: rounding alone is not to stop it there. */
    static double slack(double gap, double depth) {
        return Math.max(depth, Math.min(MOST_SLACK * depth, SLACK * depth - gap));
    }

    /** How deep a pair is to be found that may be deep, whose bodies' ways are known: what is open, and closes by another corner, strikes. */
    static double watched(double gap, double depth) {
        return gap > LET_BE * depth ? 0 : depth;
    }

    /** Whether a point is as deep as it may be. */
    static boolean isNearly(double gap, double depth) {
        return gap < -NEARLY * depth;
    }

    /** How far a way that is known leads out of that. */
    static double room(double depth) {
        return OUT * depth;
    }

    /** How deep a pair of free bodies may be that is as deep as it is: less and less where it could be deeper before. */
    static double depth(double gap, double size, double rounding) {
        return Math.max(depth(false, size, rounding), Math.min(FAIR_CUSHION * size, -gap));
    }

    /** Whether that is deeper than it is to be when all is at rest. */
    static boolean isDeeper(double depth, double size, double rounding) {
        return depth > LET_BE * depth(false, size, rounding);
    }

    /** The error of velocities over a time with which a solution is kept if there is no better one. */
    static double fairSpeed(double size, double time) {
        return FAIR * FAIR_CUSHION * size / time;
    }

    /** The same in a large heap. */
    static double fairSpeedOfMany(double size, double time) {
        return FAIR * LARGE_CUSHION * size / time;
    }

    /** How deep a pair may be that has become too deep too often. */
    static double deeper(double gap, double size) {
        double root = Math.sqrt(Math.max(0, -gap / size)) + DEEPER * Math.sqrt(CUSHION); // of numbers: that of a length depends on its unit
        return gap < 0 ? size * (root * root) : 0;
    }

    /** How deep a pair of a large heap may be. */
    static double depthOfMany(double gap, double size) {
        return Math.max(LARGE_CUSHION * size, LARGE_CUSHION * size - gap);
    }

    /** The least normal velocity of a point of a large heap, which regains no more in the last bit of a step than in others. */
    static double leastSpeedOfMany(double gap, double bend, double size, Regain regain) {
        double room = Math.min(bend, LARGE_CUSHION * size);
        double missing = Math.max(0, -gap - FAIR_CUSHION * size);
        return gap >= room ? (room - gap) / regain.time() : regain.speed(Math.min(REGAIN * missing, MOST_REGAINED * size));
    }

    /** How deep a pair may be whose velocity is wrong by that much. */
    static double depth(double depth, double size, double error, double time) {
        return Math.max(depth, Math.min(FAIR_CUSHION * size, error * time / FAIR));
    }

    /** An error of velocities over a time that does not matter. */
    static double littleSpeed(double depth, double time) {
        return LITTLE * depth / time;
    }

    /** The least speed at which the coordinate of a stop is to leave it. */
    static double leastSpeed(double gap, Regain regain) {
        return gap >= 0 ? -gap / regain.time() : regain.speed(-REGAIN * gap);
    }

    /**
     * The least normal velocity of a point. What was put into one another goes no deeper, but nothing drives it apart: the
     * shorter the time, the more energy that would be.
     *
     * @param exact gap that there is
     * @param depth how deep it may be
     * @param bend what turning and sliding may take of the gap in the time
     * @param regain has the time for which the velocity is to hold
     * @param isFresh whether it was not found for a longer time before
     * @param isEven whether the velocity is reached evenly in the time; if not, at once, and the heap is stopped when this
     *     does not do
     * @param isTied whether bodies are tied to others
     */
    static double leastSpeed(double exact, double depth, double bend, Regain regain, boolean isFresh, boolean isEven, boolean isTied) {
        if (exact * (isEven ? DRIVEN_CUSHION : FAIR_CUSHION) < -Tolerances.PUT * depth) {
            return 0;
        }
        double grain = isTied ? 0 : (isEven ? DRIVEN_GRAIN : GRAIN) * depth;
        double gap = round(exact, grain);
        double room = round(depth + bend, grain);
        double least = isFresh ? room : 0.5 * room;
        if (gap >= least) {
            return gap <= room + LET_BE * grain ? 0 : (least - gap) / regain.time();
        }
        double regained = REGAIN * (room - gap);
        double lift = bend - Math.max(0, exact + depth); // or it would be too deep before the time is over
        return isEven ? regain.speed(regained) + Math.max(0, 2 * lift) / regain.time() : Math.max(regained, lift) / regain.time();
    }

    /** A least speed above 0 as it was found before for a longer time, where that does; else gaps are noise. */
    static double asFound(double least, double now, double room, double bend, double time) {
        double lift = (bend - Math.max(0, room)) / time;
        return now >= Math.max(0, lift) ? Math.min(least, now) : least;
    }

    private static double round(double gap, double grain) {
        return grain == 0 ? gap : Math.rint(gap / grain) * grain;
    }
}
