// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import java.util.Arrays;

/** What is known of pairs beside their closest features: which are let pass, rest on one another, or lie in a heap. */
public final class PairMarks implements Serializable {
    private static final long serialVersionUID = 1L;

    private boolean[] ignored = new boolean[16];

    /** Pairs at rest on one another, which are not looked at. */
    private boolean[] held = new boolean[16];

    /** How deep pairs in a heap may be; empty while there is none. */
    private double[] slack = {};

    PairMarks() {
        // grows with the pairs
    }

    void begin(int pair, boolean isIgnored) {
        if (pair >= ignored.length) {
            ignored = Arrays.copyOf(ignored, Math.max(2 * ignored.length, pair + 1));
            held = Arrays.copyOf(held, ignored.length);
        }
        ignored[pair] = isIgnored;
        held[pair] = false;
        if (pair < slack.length) {
            slack[pair] = 0;
        }
    }

    /** Whether a pair is not to be looked at. */
    boolean isUnseen(int pair) {
        return ignored[pair] || held[pair];
    }

    void hold(int pair, boolean yes) {
        held[pair] = yes;
    }

    /**
     * Lets a pair pass through one another until their boxes are apart, or not.
     *
     * @param pair its number
     * @param yes whether it passes
     */
    public void ignore(int pair, boolean yes) {
        ignored[pair] = yes;
    }

    /**
     * Whether the bodies of a pair pass through one another.
     *
     * @param pair its number
     * @return false if they collide
     */
    public boolean isIgnored(int pair) {
        return ignored[pair];
    }

    /**
     * Whether the bodies of a pair rest on one another.
     *
     * @param pair its number
     * @return as {@link CollisionDetection#hold} said, until the pair ends
     */
    public boolean isHeld(int pair) {
        return held[pair];
    }

    /**
     * Says how deep a pair may be before it counts as an impact.
     *
     * @param pair its number
     * @param depth length; 0 until it is set, and when the pair begins anew
     */
    public void setSlack(int pair, double depth) {
        if (pair >= slack.length) {
            slack = Arrays.copyOf(slack, Math.max(2 * slack.length, pair + 1));
        }
        slack[pair] = depth;
    }

    /**
     * How deep a pair may be before it counts as an impact.
     *
     * @param pair its number
     * @return length, 0 for most
     */
    public double slack(int pair) {
        return pair < slack.length ? slack[pair] : 0;
    }
}
