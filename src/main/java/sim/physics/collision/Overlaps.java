// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.util.ArrayList;
import java.util.List;
import sim.physics.collision.narrow.Distance;
import sim.physics.internal.Progress;
import sim.physics.motion.Body;

/** Finds and parts bodies that overlap where they are. For setting up a scene: it looks at all pairs. */
public final class Overlaps {
    /** Overlaps shallower than this part of the bodies are rounding. */
    private static final double ROUNDING = 1e-12;

    /** A little more than needed is moved, so that rounding does not leave an overlap. */
    private static final double EXTRA = 1e-10;

    /** Sweeps at most, and those after which the bodies overlap no less. */
    private static final int MAX_SWEEPS = 10_000;

    private static final int PATIENCE = 200;

    private final CollisionFilter filter;
    private final Distance distance = new Distance();

    /**
     * Makes an object that looks for overlaps.
     *
     * @param filter which bodies collide at all
     */
    public Overlaps(CollisionFilter filter) {
        this.filter = filter;
    }

    /**
     * The pairs of bodies that collide and overlap.
     *
     * @param bodies to look at
     * @return one entry a pair, deepest first
     */
    public List<Overlap> find(List<Body> bodies) {
        return find(new CirclePairs(bodies));
    }

    private List<Overlap> find(CirclePairs pairs) {
        List<Overlap> found = new ArrayList<>();
        int count = pairs.find();
        for (int k = 0; k < count; k++) {
            Body a = pairs.earlier(k);
            Body b = pairs.later(k);
            double depth = depth(a, b);
            if (depth > 0) {
                found.add(new Overlap(a, b, depth));
            }
        }
        found.sort((p, q) -> Double.compare(q.depth(), p.depth()));
        return found;
    }

    /**
     * How deep all of some pairs overlap.
     *
     * @param found pairs
     * @return the sum of their depths
     */
    public static double depth(List<Overlap> found) {
        double sum = 0;
        for (Overlap overlap : found) {
            sum += overlap.depth();
        }
        return sum;
    }

    private double depth(Body a, Body b) {
        double size = a.getShape().boundingRadius() + b.getShape().boundingRadius();
        if (!CirclePairs.doOverlap(a, b) || !a.isDynamic() && !b.isDynamic() || !filter.allows(a, b)) {
            return 0;
        }
        double gap = distance.between(a, b);
        return gap < -ROUNDING * size ? -gap : 0;
    }

    /**
     * Moves overlapping bodies apart, each pair by the least way, the lighter body the farther. Velocities are not
     * changed, so no kinetic energy is gained.
     *
     * @param bodies all that may be in the way
     * @return number of sweeps over all pairs that it took, 0 if nothing overlapped
     * @throws IllegalStateException if there is no room; the bodies stay where the attempt left them
     */
    public int separate(List<Body> bodies) {
        CirclePairs pairs = new CirclePairs(bodies);
        Progress progress = new Progress(PATIENCE);
        int sweep = 0;
        for (boolean stalls = false; sweep < MAX_SWEEPS && !stalls; sweep++) {
            List<Overlap> found = find(pairs);
            if (found.isEmpty()) {
                return sweep;
            }
            stalls = progress.stalls(depth(found));
            for (Overlap overlap : found) {
                part(overlap.a(), overlap.b());
            }
        }
        throw new IllegalStateException(
                find(bodies).size() + " pairs of bodies still overlap after " + sweep + " sweeps: is there room?");
    }

    private void part(Body a, Body b) {
        double depth = depth(a, b);
        if (depth == 0) {
            return;
        }
        double way = depth + EXTRA * (a.getShape().boundingRadius() + b.getShape().boundingRadius());
        double wA = 1 / a.getMass();
        double wB = 1 / b.getMass();
        double nx = distance.normalX();
        double ny = distance.normalY();
        a.setPosition(a.getX() - way * wA / (wA + wB) * nx, a.getY() - way * wA / (wA + wB) * ny);
        b.setPosition(b.getX() + way * wB / (wA + wB) * nx, b.getY() + way * wB / (wA + wB) * ny);
    }
}
