// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.broad.Pairs;
import sim.physics.internal.IntList;

/** What is known of pairs beside their closest features: which are let pass, rest on one another, or lie in a heap. */
public final class PairMarks implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int IGNORED = 1;

    /** At rest on one another, not looked at. */
    private static final int HELD = 2;

    private final Pairs pairs;

    /** How deep pairs may be; empty while none may. */
    private double[] depth = {};

    /** Pairs in a heap; empty while there is none. */
    private boolean[] lasting = {};

    /** Pairs that stick; empty while none ever did. */
    private boolean[] sticky = {};

    /** Pairs that go on as if nothing were there, whatever the filter says; empty while none ever did. */
    private boolean[] passing = {};

    /** The numbers of these pairs, ascending. */
    private final IntList passed = new IntList();

    /** The bodies that pass through one that has got another shape. */
    private final IntList kept = new IntList();

    private final Clearances clearances;

    PairMarks(Pairs pairs, Clearances clearances) {
        this.pairs = pairs;
        this.clearances = clearances;
    }

    /** How far pairs are apart at least. */
    Clearances clearances() {
        return clearances;
    }

    void begin(int pair, boolean isIgnored) {
        pairs.setMarks(pair, isIgnored ? IGNORED : 0);
        clearances.forget(pair);
        if (pair < depth.length) {
            depth[pair] = 0;
        }
        if (pair < lasting.length) {
            lasting[pair] = false;
        }
        if (pair < sticky.length) {
            sticky[pair] = false;
        }
        if (passes(pair)) {
            endPassing(pair);
        }
    }

    /**
     * Whether a pair cannot collide, or has its own means while it rests.
     *
     * @param pair its number
     * @return true if no impact of it is looked for
     */
    public boolean isUnseen(int pair) {
        return pairs.marks(pair) != 0;
    }

    /** Whether no pair has ever been allowed to be deep in one another. */
    boolean areShallow() {
        return depth.length == 0;
    }

    /** Whether a body has a pair that does not pass through one another. */
    boolean hasNeighbours(int body) {
        for (int m = 0; m < pairs.countOf(body); m++) {
            if (!isIgnored(pairs.of(body, m))) {
                return true;
            }
        }
        return false;
    }

    void hold(int pair, boolean yes) {
        mark(pair, HELD, yes);
    }

    private void mark(int pair, int what, boolean yes) {
        int marks = pairs.marks(pair);
        pairs.setMarks(pair, yes ? marks | what : marks & ~what);
    }

    /**
     * Lets a pair pass through one another until they are apart where a step begins, or where they are put.
     *
     * @param pair its number
     */
    public void letPass(int pair) {
        if (pair >= passing.length) {
            passing = Arrays.copyOf(passing, Math.max(2 * passing.length, pair + 1));
        }
        if (!passing[pair]) {
            passed.insert(pair);
        }
        passing[pair] = true;
        mark(pair, IGNORED, true);
    }

    /**
     * Ends the passing of pairs that are apart where the step begins, however near one another they still are.
     *
     * @param parted takes their numbers
     */
    void part(IntList parted) {
        parted.clear();
        int count = 0;
        for (int k = 0; k < passed.size; k++) {
            int pair = passed.values[k];
            boolean isThere = pairs.first(pair) >= 0;
            passing[pair] = isThere && !clearances.isApart(pair);
            if (passing[pair]) {
                passed.values[count++] = pair;
            } else if (isThere) {
                parted.add(pair);
            }
        }
        passed.size = count;
    }

    /**
     * Takes note of what passes through a body that is about to be taken out and in again, as it has got another shape.
     *
     * @param body its index
     */
    public void keep(int body) {
        kept.clear();
        for (int k = 0; k < passed.size; k++) {
            int pair = passed.values[k];
            if (pairs.first(pair) == body || pairs.second(pair) == body) {
                kept.add(pairs.other(pair, body));
            }
        }
    }

    /** Lets pass through a body that is in again what did so before. */
    void recall(int body) {
        for (int k = 0; k < kept.size; k++) {
            for (int m = 0; m < pairs.countOf(body); m++) {
                if (pairs.other(pairs.of(body, m), body) == kept.values[k]) {
                    letPass(pairs.of(body, m));
                }
            }
        }
        kept.clear();
    }

    boolean passes(int pair) {
        return pair < passing.length && passing[pair];
    }

    void endPassing(int pair) {
        passing[pair] = false;
        passed.takeOut(pair);
    }

    /** Takes note of what the filter says of a pair now. */
    void filter(int pair, boolean forbids) {
        mark(pair, IGNORED, forbids || passes(pair));
    }

    /**
     * Whether the bodies of a pair pass through one another.
     *
     * @param pair its number
     * @return false if they collide
     */
    public boolean isIgnored(int pair) {
        return (pairs.marks(pair) & IGNORED) != 0;
    }

    /**
     * Whether the bodies of a pair rest on one another.
     *
     * @param pair its number
     * @return as {@link CollisionDetection#hold} said, until the pair ends
     */
    public boolean isHeld(int pair) {
        return (pairs.marks(pair) & HELD) != 0;
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

    /**
     * Says whether the bodies of a pair stick to one another where they touch.
     *
     * @param pair its number
     * @param yes as its last collision was decided; not any more when the pair begins anew
     */
    public void setSticky(int pair, boolean yes) {
        if (pair >= sticky.length) {
            if (!yes) {
                return;
            }
            sticky = Arrays.copyOf(sticky, Math.max(2 * sticky.length, pair + 1));
        }
        sticky[pair] = yes;
    }

    /**
     * Whether the bodies of a pair stick to one another where they touch.
     *
     * @param pair its number
     * @return false for most
     */
    public boolean isSticky(int pair) {
        return pair < sticky.length && sticky[pair];
    }
}
