// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import sim.physics.motion.Body;

/** The pairs of bodies whose bounding circles may overlap, by a sweep along the axis on which the bodies are spread out more. */
final class CirclePairs {
    /** What a circle covers of the axis, and a little more than rounding leaves of that. */
    private static final class Span {
        private final int body;
        private double low;
        private double high;

        Span(int body) {
            this.body = body;
        }

        double low() {
            return low;
        }

        void set(double centre, double radius) {
            double margin = 4 * Math.ulp(Math.abs(centre) + radius);
            low = centre - radius - margin;
            high = centre + radius + margin;
        }
    }

    private static final Comparator<Span> BY_LOW = Comparator.comparingDouble(Span::low);

    private final List<Body> bodies;
    private final Span[] spans;
    private final Span[] open;
    private long[] pairs = new long[16];
    private int count;

    CirclePairs(List<Body> bodies) {
        this.bodies = bodies;
        spans = new Span[bodies.size()];
        open = new Span[spans.length];
        Arrays.setAll(spans, Span::new);
    }

    /** Looks where the bodies are now; returns the number of pairs, which are in the order of their later bodies, then their earlier. */
    int find() {
        count = 0;
        boolean alongX = spread(true) >= spread(false);
        for (Span span : spans) {
            Body body = bodies.get(span.body);
            span.set(alongX ? body.getX() : body.getY(), body.getShape().boundingRadius());
        }
        Arrays.sort(spans, BY_LOW); // hardly changed since the last look
        int opened = 0;
        for (Span span : spans) {
            int kept = 0;
            for (int k = 0; k < opened; k++) {
                if (open[k].high >= span.low) {
                    add(span.body, open[k].body);
                    open[kept++] = open[k];
                }
            }
            open[kept] = span;
            opened = kept + 1;
        }
        Arrays.sort(pairs, 0, count);
        return count;
    }

    private double spread(boolean alongX) {
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (Body body : bodies) {
            least = Math.min(least, alongX ? body.getX() : body.getY());
            most = Math.max(most, alongX ? body.getX() : body.getY());
        }
        return most - least;
    }

    private void add(int i, int j) {
        if (!doOverlap(bodies.get(i), bodies.get(j))) {
            return;
        }
        if (count == pairs.length) {
            pairs = Arrays.copyOf(pairs, 2 * count);
        }
        pairs[count++] = (long) Math.max(i, j) << Integer.SIZE | Math.min(i, j);
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
