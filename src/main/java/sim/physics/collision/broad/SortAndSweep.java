// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.util.Arrays;

/**
 * The write-up's dimension reduction strategy. For each dimension, the end points of all boxes are in a list, which is kept
 * sorted by insertion. Overlaps are tracked by the end points that change places (Cohen, Lin, Manocha and Ponamgi,
 * <i>I-COLLIDE</i>, 1995; Figure 4).
 *
 * <p>When a lower end point passes an upper one, two boxes begin or cease to overlap in that dimension. They are a pair if they
 * overlap in the other dimension too. A box is moved on from its own place in the list, so a step in which no box changes costs
 * nothing. The cost of a change is the number of end points passed.
 */
public final class SortAndSweep implements BroadPhase {
    private static final long serialVersionUID = 1L;

    private final Claim claim = new Claim();

    /** End points of one dimension: values in ascending order, and whose they are. */
    private static final class Axis implements java.io.Serializable {
        private static final long serialVersionUID = 1L;

        /** Offset of the lower end in a box: 0 for x, 1 for y; the upper one is two further. */
        final int lower;

        double[] value = new double[16];

        /** 2·body for the lower end point of a box, 2·body + 1 for the upper one. */
        int[] end = new int[16];

        /** Where each end point stands. */
        int[] place = new int[16];

        int size;

        Axis(int lower) {
            this.lower = lower;
        }

        void append(int which) {
            if (size == end.length) {
                value = Arrays.copyOf(value, 2 * size);
                end = Arrays.copyOf(end, 2 * size);
            }
            if (which >= place.length) {
                place = Arrays.copyOf(place, Math.max(2 * place.length, which + 1));
            }
            value[size] = Double.POSITIVE_INFINITY;
            end[size] = which;
            place[which] = size++;
        }

        void drop(int which) {
            for (int k = place[which] + 1; k < size; k++) {
                value[k - 1] = value[k];
                end[k - 1] = end[k];
                place[end[k]] = k - 1;
            }
            size--;
        }

        /**
         * Gives an end point its new value and sorts it in. At equal values lower end points stand before upper ones,
         * so that boxes that touch overlap.
         */
        void move(int which, double to, Axis across, Boxes boxes, Pairs pairs) {
            int k = place[which];
            boolean upper = (which & 1) != 0;
            while (k > 0 && (value[k - 1] > to || value[k - 1] == to && !upper && (end[k - 1] & 1) != 0)) {
                shift(k, k - 1);
                if (!upper && (end[k] & 1) != 0) {
                    meet(which >> 1, end[k] >> 1, boxes, pairs);
                } else if (upper && (end[k] & 1) == 0) {
                    part(which >> 1, end[k] >> 1, across, boxes, pairs);
                }
                k--;
            }
            while (k < size - 1 && (value[k + 1] < to || value[k + 1] == to && upper && (end[k + 1] & 1) == 0)) {
                shift(k, k + 1);
                if (upper && (end[k] & 1) == 0) {
                    meet(which >> 1, end[k] >> 1, boxes, pairs);
                } else if (!upper && (end[k] & 1) != 0) {
                    part(which >> 1, end[k] >> 1, across, boxes, pairs);
                }
                k++;
            }
            value[k] = to;
            end[k] = which;
            place[which] = k;
        }

        /** Whether two overlap as it stands. */
        boolean overlap(int a, int b, Boxes boxes) {
            double[] d = boxes.data();
            int o = Boxes.STRIDE * b + lower;
            return value[place[2 * a + 1]] >= d[o] && d[o + 2] >= value[place[2 * a]];
        }

        private void shift(int to, int from) {
            value[to] = value[from];
            end[to] = end[from];
            place[end[from]] = to;
        }

        private static void meet(int a, int b, Boxes boxes, Pairs pairs) {
            if (a != b && boxes.overlap(a, b)) {
                pairs.begin(a, b);
            }
        }

        /** Ends a pair, if there is one: only if the two overlap in the other dimension too, where a may still be moved. */
        private static void part(int a, int b, Axis across, Boxes boxes, Pairs pairs) {
            if (a != b && across.overlap(a, b, boxes)) {
                for (int p = pairs.find(a, b); p >= 0; p = pairs.find(a, b)) {
                    pairs.end(p);
                }
            }
        }
    }

    private final Axis axisX = new Axis(0);
    private final Axis axisY = new Axis(1);

    /** Creates a broad phase without bodies. */
    public SortAndSweep() {
        // bodies come by add
    }

    @Override
    public void claim() {
        claim.take(this);
    }

    @Override
    public void add(int body, Boxes boxes, Pairs pairs) {
        for (int side = 0; side < 2; side++) {
            axisX.append(2 * body + side);
            axisY.append(2 * body + side);
        }
        update(body, boxes, pairs);
    }

    @Override
    public void update(int body, Boxes boxes, Pairs pairs) {
        update(axisX, axisY, body, boxes, pairs);
        update(axisY, axisX, body, boxes, pairs);
    }

    /** Moves the end point that leads first, so that the lower one never passes the upper one. */
    private static void update(Axis axis, Axis across, int body, Boxes boxes, Pairs pairs) {
        double lower = boxes.data()[Boxes.STRIDE * body + axis.lower];
        double upper = boxes.data()[Boxes.STRIDE * body + axis.lower + 2];
        int low = 2 * body;
        if (upper >= axis.value[axis.place[low + 1]]) {
            axis.move(low + 1, upper, across, boxes, pairs);
            axis.move(low, lower, across, boxes, pairs);
        } else {
            axis.move(low, lower, across, boxes, pairs);
            axis.move(low + 1, upper, across, boxes, pairs);
        }
    }

    @Override
    public void remove(int body, Boxes boxes, Pairs pairs) {
        while (pairs.countOf(body) > 0) {
            pairs.end(pairs.of(body, 0));
        }
        for (int side = 0; side < 2; side++) {
            axisX.drop(2 * body + side);
            axisY.drop(2 * body + side);
        }
    }
}
