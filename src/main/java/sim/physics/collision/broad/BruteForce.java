// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;

/**
 * A broad phase for a few bodies. It compares a box that has changed with all others. For some tens of bodies that is less work
 * than keeping anything sorted, and it needs no memory but a list.
 */
public final class BruteForce implements BroadPhase {
    private static final long serialVersionUID = 1L;

    private final Claim claim = new Claim();

    private final IntList bodies = new IntList();

    /** Which bodies are pairs already of the body that is looked at: those marked with the present number. */
    private int[] mark = new int[8];

    private int marking;

    /** Pairs or bodies found in a look, with room for one more. */
    private int[] found = new int[8];

    /** Creates a broad phase without bodies. */
    public BruteForce() {
        // bodies come by add
    }

    @Override
    public void claim() {
        claim.take(this);
    }

    @Override
    public void add(int body, Boxes boxes, Pairs pairs) {
        bodies.add(body);
        int all = boxes.data().length / Boxes.STRIDE; // after another broad phase it may have pairs with any body
        if (all > mark.length) {
            mark = Arrays.copyOf(mark, Growth.length(mark.length, all));
            found = new int[mark.length + 1];
        }
        update(body, boxes, pairs);
    }

    @Override
    public void update(int body, Boxes boxes, Pairs pairs) {
        double[] d = boxes.data();
        int o = Boxes.STRIDE * body;
        double minX = d[o];
        double minY = d[o + 1];
        double maxX = d[o + 2];
        double maxY = d[o + 3];
        end(body, boxes, pairs, minX, minY, maxX, maxY);
        int count = 0;
        for (int k = 0; k < bodies.size; k++) {
            int other = bodies.values[k];
            found[count] = other;
            count += boxes.met(other, minX, minY, maxX, maxY); // no branch, since nobody could foretell it
        }
        for (int k = 0; k < count; k++) {
            int other = found[k];
            if (mark[other] != marking && !(boxes.isFixed(body) && boxes.isFixed(other))) {
                pairs.beginNew(body, other);
            }
        }
    }

    /** Ends the pairs of a body whose boxes are apart now, and marks the body and its partners in the others. */
    private void end(int body, Boxes boxes, Pairs pairs, double minX, double minY, double maxX, double maxY) {
        marking++;
        mark[body] = marking;
        int apart = 0;
        if (pairs.countOf(body) >= found.length) { // bodies of several parts have several pairs
            found = new int[2 * pairs.countOf(body)];
        }
        for (int k = pairs.countOf(body) - 1; k >= 0; k--) {
            int pair = pairs.of(body, k);
            int other = pairs.other(pair, body);
            found[apart] = pair;
            mark[other] = marking;
            apart += 1 - boxes.met(other, minX, minY, maxX, maxY);
        }
        for (int k = 0; k < apart; k++) {
            pairs.end(found[k]);
        }
    }

    @Override
    public void remove(int body, Boxes boxes, Pairs pairs) {
        while (pairs.countOf(body) > 0) {
            pairs.end(pairs.of(body, 0));
        }
        int place = 0;
        while (bodies.values[place] != body) {
            place++;
        }
        bodies.values[place] = bodies.values[--bodies.size];
    }
}
