// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.util.Arrays;
import java.util.List;
import sim.physics.collision.broad.Boxes;
import sim.physics.collision.broad.CellGrid;
import sim.physics.collision.broad.Pairs;
import sim.physics.motion.Body;

/** The pairs of bodies whose bounding circles overlap, unless both are fixed: those of a broad phase of their own that do. */
final class CirclePairs {
    private final List<Body> bodies;
    private final Boxes boxes = new Boxes();
    private final Pairs near = new Pairs();
    private final CellGrid grid = new CellGrid();
    private long[] pairs = new long[16];
    private int count;

    CirclePairs(List<Body> bodies) {
        this.bodies = bodies;
        boxes.ensure(bodies.size());
        near.ensure(bodies.size());
        for (int k = 0; k < bodies.size(); k++) {
            boxes.setFixed(k, bodies.get(k).isImmobile());
            enclose(k);
            grid.add(k, boxes, near);
        }
    }

    /** Looks where the bodies are now; returns the number of pairs, which are in the order of their later bodies, then their earlier. */
    int find() {
        for (int k = 0; k < bodies.size(); k++) {
            if (enclose(k)) {
                grid.update(k, boxes, near);
            }
        }
        count = 0;
        for (int k = 0; k < bodies.size(); k++) {
            for (int m = 0; m < near.countOf(k); m++) {
                add(k, near.other(near.of(k, m), k));
            }
        }
        Arrays.sort(pairs, 0, count);
        return count;
    }

    /** Sets the box around a body's circle, a little larger than rounding could make of it; returns whether it is another one. */
    private boolean enclose(int k) {
        Body body = bodies.get(k);
        double radius = body.getShape().boundingRadius();
        double x = body.getX();
        double y = body.getY();
        double wide = radius + 4 * Math.ulp(Math.abs(x) + radius);
        double high = radius + 4 * Math.ulp(Math.abs(y) + radius);
        double[] d = boxes.data();
        int o = Boxes.STRIDE * k;
        boolean isNew = d[o] != x - wide || d[o + 1] != y - high || d[o + 2] != x + wide || d[o + 3] != y + high;
        boxes.set(k, x - wide, y - high, x + wide, y + high);
        return isNew;
    }

    private void add(int later, int earlier) {
        if (earlier > later || !doOverlap(bodies.get(later), bodies.get(earlier))) {
            return;
        }
        if (count == pairs.length) {
            pairs = Arrays.copyOf(pairs, 2 * count);
        }
        pairs[count++] = (long) later << Integer.SIZE | earlier;
    }

    static boolean doOverlap(Body a, Body b) {
        double size = a.getShape().boundingRadius() + b.getShape().boundingRadius();
        double dx = b.getX() - a.getX();
        double dy = b.getY() - a.getY();
        return dx * dx + dy * dy < size * size;
    }

    Body earlier(int k) {
        return bodies.get((int) pairs[k]);
    }

    Body later(int k) {
        return bodies.get((int) (pairs[k] >> Integer.SIZE));
    }
}
