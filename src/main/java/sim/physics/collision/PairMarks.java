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

    /** How deep pairs may be; empty while none may. */
    private double[] depth = {};

    /** Pairs in a heap; empty while there is none. */
    private boolean[] lasting = {};

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
        if (pair < depth.length) {
            depth[pair] = 0;
        }
        if (pair < lasting.length) {
            lasting[pair] = false;
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
     * @param most length; 0 until it is set, and when the pair begins anew
     */
    public void setDepth(int pair, double most) {
        if (pair >= depth.length) {
            depth = Arrays.copyOf(depth, Math.max(2 * depth.length, pair + 1));
        }
        depth[pair] = most;
    }

    /**
     * How deep a pair may be before it counts as an impact.
     *
     * @param pair its number
     * @return length, 0 for most
     */
    public double depth(int pair) {
        return pair < depth.length ? depth[pair] : 0;
    }

    /**
     * Says whether the bodies of a pair lie on one another in a heap.
     *
     * @param pair its number
     * @param yes whether they do; not any more when the pair begins anew
     */
    public void setLasting(int pair, boolean yes) {
        if (pair >= lasting.length) {
            lasting = Arrays.copyOf(lasting, Math.max(2 * lasting.length, pair + 1));
        }
        lasting[pair] = yes;
    }

    /**
     * Whether the bodies of a pair lie on one another in a heap.
     *
     * @param pair its number
     * @return false for most
     */
    public boolean isLasting(int pair) {
        return pair < lasting.length && lasting[pair];
    }
}
