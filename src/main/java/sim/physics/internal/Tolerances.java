// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

/**
 * The tolerances that say what touches, bounces, rests and lies, in one place. Those of a method alone are in its class. None is
 * an absolute length, speed or time: each is relative to the bodies, speeds or steps it is used with, so that a scene may be given
 * in any unit.
 */
public final class Tolerances {
    /**
     * Gap at which two bodies touch, relative to the coordinates from which it is computed; a few units of rounding.
     * Smaller: searches for impacts stall in the noise. Larger: impacts come early by as much.
     */
    public static final double GAP = 8 * 0x1p-52;

    /**
     * Speed below which surfaces that touch count as not approaching, relative to the speed of the bodies' points.
     * Smaller: an impact may be followed by an impact of its own rounding.
     */
    public static final double APPROACH = 1e-13;

    /** Penetration, relative to the bodies, from which any approach counts as a contact that is more than its rounding. */
    public static final double DEEP = 1e-11;

    /** Part of the step that a search for an impact moves on at least when it got stuck in a sustained contact. */
    public static final double FORCED_PROGRESS = 1e-4;

    /** Penetration, relative to the smaller body, in which no heap leaves a pair: its bodies were put into one another. */
    public static final double PUT = 1e-3;

    /** Penetration, relative to the bodies, that no impact leaves: they were put into one another, or a heap has let go of them. */
    public static final double OVERLAP = 1e-8;

    /** Gap up to which a second point of two parallel edges belongs to the same impact, relative to the bodies. */
    public static final double FLUSH = 1e-11;

    /** Distance of two corners from which the normal of an edge is taken in place of the line between them. */
    public static final double CORNERS = 1e-9;

    /** Time within which impacts count as simultaneous, relative to the step. */
    public static final double SIMULTANEOUS = 1e-14;

    /** Time within which a body's impacts on fixed bodies may be simultaneous but for rounding, relative to the step. */
    public static final double SOON = 1e-9;

    /**
     * Length of a bounce, relative to the step, from which a body comes to rest on a fixed surface that can bear it.
     * All the bounces that would follow are shorter, and together take this over 1 − e.
     */
    public static final double REST = 1e-6;

    /**
     * Length of the shortest bounce, relative to the step, of bodies that cannot come to rest on one another: it bounds
     * the number of impacts in a step. The bodies hover within acceleration · (step · this)² / 8.
     */
    public static final double SHORTEST_BOUNCE = 1.0 / 64;

    /**
     * Impacts of a pair in one step from which on they are elastic, if the pair loses speed in them: bodies that lose
     * their speeds among one another would else collide for ever in a finite time.
     */
    public static final int ELASTIC_AFTER = 16;

    /** Impacts of a pair in one step from which a body comes to rest at its next short bounce. */
    public static final int REST_AFTER = 20_000;

    /** Impacts of a pair in one step from which its bodies may lie on one another, in a heap. */
    public static final int LIE_AFTER = 8;

    /** The same where one of them lies in a heap already. */
    public static final int JOIN_AFTER = 2;

    /** The same for a pair that loses energy only by friction. */
    public static final int ELASTIC_LIE_AFTER = 512;

    /** Length of a bounce, relative to the step, from which on they do not. */
    public static final double SHORT = 0.25;

    /** Times a body may come to rest on the same surface in one step before the surface counts as not bearing it. */
    public static final int RESTS = 8;

    /** Times that driven bodies may prove to be apart or parting in a step where a contact was expected. */
    public static final int MISSES = 100;

    /** How far the instant of an impact of driven bodies may be moved, relative to the step, to a gap of zero. */
    public static final double POLISH = 1.0 / 16;

    /** Impacts of a pair under a force in one step from which on it rattles. */
    public static final int RATTLE_AFTER = 50;

    /** Restitution of a pair that rattles, until its bounces are short. */
    public static final double RATTLE = 0.5;

    /** Length of a short bounce, relative to the smaller body: larger ones look like bounces, and give energy. */
    public static final double RATTLE_SIZE = 4e-3;

    /** By how much of its size, or in rad, a body may be put elsewhere that goes on to lie where it lies: a tenth of what contacts may be deep. */
    public static final double LIES_ON = 1e-8;

    private Tolerances() {}
}
