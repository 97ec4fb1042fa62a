// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.CollisionFilter;
import sim.physics.collision.broad.Boxes;
import sim.physics.collision.broad.BroadPhase;
import sim.physics.collision.broad.BruteForce;
import sim.physics.collision.broad.CellGrid;
import sim.physics.collision.broad.Pairs;
import sim.physics.constraint.Onset;
import sim.physics.internal.Growth;
import sim.physics.motion.State;

/** The pairs of bodies that may touch within the step, and what is kept of them from step to step. */
final class NearPairs implements Pairs.Listener, Serializable {
    private static final long serialVersionUID = 1L;

    /** The two do not collide at all. */
    static final int FORBIDDEN = 1;
    /** Listeners have been asked what to do, and it is this. */
    static final int DECIDED = 2;

    static final int IGNORED = 4;
    static final int STICKY = 8;
    /** They pressed on one another in the last step. */
    static final int TOUCHED = 16;

    /** They were solved with all that they hang together with. */
    static final int OF_SET = 32;

    /** Values kept of each of two points: impulses along normal and tangent, and the one along the normal before that. */
    static final int POINT = 3;

    static final int KEPT = 2 * POINT;

    /** Part that is left of a force that presses, from which on it has not been released. */
    private static final double LEFT = 0.5;

    /** Number of bodies from which a grid finds the pairs. */
    private static final int CROWD = 50;

    /** Room of a box around a body in units of its size, and in steps of its way: fewer where that would be far. */
    private static final double ROOM = 0.1;

    private static final double STEPS = 3;
    private static final double FAR = 4;

    private final State state;
    private final Poses poses;
    private final CollisionFilter filter;
    private final Onset onset;
    private final Boxes boxes = new Boxes();
    private final Pairs pairs = new Pairs();
    private BroadPhase broad = new BruteForce();
    private int bodies;

    int[] flags = {};
    double[] kept = {};
    int[] features = {};

    /** The pairs of which one body may move; those of sleeping and fixed ones are not looked at. */
    final PairOrder order = new PairOrder(pairs);

    private double minX;
    private double minY;
    private double maxX;
    private double maxY;

    NearPairs(State state, Poses poses, CollisionFilter filter, Onset onset) {
        this.onset = onset;
        this.state = state;
        this.poses = poses;
        this.filter = filter;
        pairs.setListener(this);
    }

    Pairs pairs() {
        return pairs;
    }

    /** Takes a body in. */
    void add(int body, double h) {
        boxes.ensure(body + 1);
        pairs.ensure(body + 1);
        pairs.setParts(body, state.body(body).getShape().partCount());
        boxes.setFixed(body, state.body(body).isImmobile());
        bound(body, h, steps(body, h), ROOM);
        boxes.set(body, minX, minY, maxX, maxY);
        bodies++;
        broad.add(body, boxes, pairs);
        if (bodies == CROWD && broad instanceof BruteForce) {
            toGrid();
        }
    }

    private void toGrid() {
        broad = new CellGrid();
        for (int k = 0; k < state.size(); k++) {
            if (poses.knows(k)) {
                broad.add(k, boxes, pairs);
            }
        }
    }

    void remove(int body) {
        broad.remove(body, boxes, pairs);
        bodies--;
    }

    /** A body was written: its box is made anew, and its pairs may be others. */
    void written(int body, double h) {
        bound(body, h, steps(body, h), ROOM);
        boxes.set(body, minX, minY, maxX, maxY);
        broad.update(body, boxes, pairs);
        for (int k = 0; k < pairs.countOf(body); k++) {
            filter(pairs.of(body, k));
        }
        revive(body);
    }

    /** A pair is not to be looked at until one of its bodies is written or wakes. */
    void leave(int pair) {
        order.drop(pair);
    }

    /** The pairs of a body are to be looked at. */
    void revive(int body) {
        for (int k = 0; k < pairs.countOf(body); k++) {
            order.add(pairs.of(body, k));
        }
    }

    /** Makes the boxes anew that bodies may leave in the step. */
    void update(double h) {
        for (int k = 0; k < poses.awake.size; k++) {
            poses.turn(poses.awake.values[k]);
            update(poses.awake.values[k], h, 0);
        }
    }

    /**
     * Makes the boxes anew that forces may drive bodies out of in the step. Where that is less than their room they come to overlap before they meet;
     * what is small, or falls for long, would pass by what nobody has looked for.
     *
     * @param a accelerations by forces
     */
    void drive(double h, double[] a) {
        for (int k = 0; k < poses.awake.size; k++) {
            int body = poses.awake.values[k];
            double way = h * h * (Math.abs(a[State.BLOCK * body]) + Math.abs(a[State.BLOCK * body + 1]));
            double size = poses.hull(body).bounding;
            if (way > ROOM * size) {
                update(body, h, way / size);
            }
        }
    }

    /** Makes a box anew that a body may leave, with so much more room, in units of its size. */
    private void update(int body, double h, double more) {
        double[] d = boxes.data();
        bound(body, h, 1, more);
        int o = Boxes.STRIDE * body;
        boolean isIn = minX >= d[o] && minY >= d[o + 1] && maxX <= d[o + 2] && maxY <= d[o + 3]; // not so if it was no number
        if (!isIn) {
            bound(body, h, steps(body, h), ROOM + more);
            boxes.set(body, minX, minY, maxX, maxY);
            broad.update(body, boxes, pairs);
        }
    }

    /** For how many steps the box of a body is to do. */
    private double steps(int body, double h) {
        double[] v = state.v();
        int b = State.BLOCK * body;
        double way = h * (Math.abs(v[b]) + Math.abs(v[b + 1]));
        double far = FAR * poses.hull(body).bounding;
        return STEPS * way <= far ? STEPS : Math.max(1, far / way);
    }

    /** The box of a body and of its way in some steps, with some room. */
    private void bound(int body, double h, double steps, double room) {
        Hull hull = poses.hull(body);
        double[] x = state.x();
        double[] v = state.v();
        int b = State.BLOCK * body;
        double wideX = hull.radius;
        double wideY = hull.radius;
        double turned = 0;
        double lowX = -wideX;
        double lowY = -wideY;
        if (hull.count > 1) {
            double cos = poses.turns[2 * body];
            double sin = poses.turns[2 * body + 1];
            lowX = Double.POSITIVE_INFINITY;
            lowY = lowX;
            wideX = -lowX;
            wideY = -lowX;
            for (int k = 0; k < hull.count; k++) {
                double px = cos * hull.x[k] - sin * hull.y[k];
                double py = sin * hull.x[k] + cos * hull.y[k];
                lowX = Math.min(lowX, px);
                wideX = Math.max(wideX, px);
                lowY = Math.min(lowY, py);
                wideY = Math.max(wideY, py);
            }
            lowX -= hull.radius;
            lowY -= hull.radius;
            wideX += hull.radius;
            wideY += hull.radius;
            turned = Math.min(2, Math.abs(v[b + 2]) * h * steps) * hull.bounding;
        }
        double way = h * steps;
        double more = room * hull.bounding + turned + h * onset.of(body);
        minX = x[b] + lowX + Math.min(0, way * v[b]) - more;
        minY = x[b + 1] + lowY + Math.min(0, way * v[b + 1]) - more;
        maxX = x[b] + wideX + Math.max(0, way * v[b]) + more;
        maxY = x[b + 1] + wideY + Math.max(0, way * v[b + 1]) + more;
    }

    @Override
    public void pairBegan(int pair) {
        if (pair >= flags.length) {
            int length = Growth.length(flags.length, pair + 1);
            flags = Arrays.copyOf(flags, length);
            kept = Arrays.copyOf(kept, KEPT * length);
            features = Arrays.copyOf(features, 2 * length);
            order.ensure(length);
        }
        flags[pair] = 0;
        order.add(pair);
        Arrays.fill(kept, KEPT * pair, KEPT * pair + KEPT, 0);
        Arrays.fill(features, 2 * pair, 2 * pair + 2, 0);
        filter(pair);
    }

    private void filter(int pair) {
        int a = pairs.first(pair);
        int b = pairs.second(pair);
        boolean forbids = !filter.allows(state.body(a), state.body(b));
        flags[pair] = forbids ? flags[pair] | FORBIDDEN : flags[pair] & ~FORBIDDEN;
    }

    @Override
    public void pairEnded(int pair) {
        flags[pair] = FORBIDDEN;
        leave(pair);
    }

    boolean is(int pair, int flag) {
        return (flags[pair] & flag) != 0;
    }

    /** Keeps the impulses of the points of rows for the step to come. */
    void keep(ContactRows rows, ContactSolver contacts) {
        for (int k = 0; k < rows.count; k++) {
            int pair = rows.pair(k);
            int n = rows.pointCount(k);
            flags[pair] = contacts.isOfSet(k) ? flags[pair] | OF_SET : flags[pair] & ~OF_SET;
            for (int m = 0; m < 2; m++) {
                int o = KEPT * pair + POINT * m;
                features[2 * pair + m] = m < n ? rows.feature(k, m) : 0;
                kept[o] = m < n ? rows.of(k, m, ContactRows.NORMAL) : 0;
                kept[o + 1] = m < n ? rows.of(k, m, ContactRows.TANGENT) : 0;
                kept[o + 2] = m < n ? rows.of(k, m, ContactRows.LAST) : 0;
            }
        }
    }

    /**
     * Lets the points of the row that was added last begin with the impulses of the step before. If one of two of a set is another one than then, it begins
     * with what the one had that is there no more: where corners of two bodies lie on one another, chance decides whose it is.
     *
     * @param growth what impulses are multiplied by
     */
    void remember(int pair, Touch touch, ContactRows rows, double growth) {
        int first = place(pair, touch.feature[0]);
        int second = touch.count > 1 ? place(pair, touch.feature[1]) : -1;
        if (touch.count > 1 && (first < 0) != (second < 0) && is(pair, OF_SET)) {
            int left = 1 - Math.max(first, second);
            left = kept[KEPT * pair + POINT * left] > 0 ? left : -1;
            first = first < 0 ? left : first;
            second = second < 0 ? left : second;
        }
        remember(pair, rows, 0, first, growth);
        remember(pair, rows, 1, second, growth);
    }

    /**
     * Which part of the impulses of the step before the row that was added last is to begin with, by what forces do to its bodies. Those that pressed them on
     * one another and do no more have left impulses that press nothing: one solution would let the two part with a share of it, as it does not know what holds them.
     *
     * @param a accelerations by forces
     * @param then the same of the step before
     * @param d the substep
     */
    double release(int pair, ContactRows rows, double[] a, double[] then, double d) {
        int k = rows.count - 1;
        double given = kept[KEPT * pair] + kept[KEPT * pair + POINT];
        if (given == 0 || isSame(rows.first(k), a, then) && isSame(rows.second(k), a, then)) {
            return 1;
        }
        double pushed = push(rows, k, then);
        double push = push(rows, k, a);
        if (push >= LEFT * pushed) {
            return 1;
        }
        double released = d * (pushed - push);
        return given > released ? 1 - released / given : 0;
    }

    private static boolean isSame(int body, double[] a, double[] then) {
        int b = State.BLOCK * body;
        return a[b] == then[b] && a[b + 1] == then[b + 1];
    }

    /** The larger one of the forces that press a row's bodies on one another. */
    private double push(ContactRows rows, int k, double[] a) {
        int first = rows.first(k);
        int second = rows.second(k);
        return Math.max(0, Math.max(push(rows, k, first, second, a), -push(rows, k, second, first, a)));
    }

    /**
     * The force along the normal that acts on a body of a row, seen from the other one where that moves as its author says: what moves such a body is
     * no force, and it is so heavy that rounding of its acceleration would be one.
     */
    private double push(ContactRows rows, int k, int body, int other, double[] a) {
        int b = State.BLOCK * body;
        double w = state.w().values()[b];
        if (w == 0 || !state.body(body).isDynamic()) {
            return 0;
        }
        int c = State.BLOCK * other;
        boolean isSteered = state.w().values()[c] > 0 && !state.body(other).isDynamic();
        double x = isSteered ? a[b] - a[c] : a[b];
        double y = isSteered ? a[b + 1] - a[c + 1] : a[b + 1];
        return (rows.normalX(k) * x + rows.normalY(k) * y) / w;
    }

    private void remember(int pair, ContactRows rows, int point, int place, double growth) {
        if (place >= 0) {
            int o = KEPT * pair + POINT * place;
            rows.remember(rows.count - 1, point, growth * kept[o], growth * kept[o + 1], growth * kept[o + 2]);
        }
    }

    /** Where the impulses of a feature are kept, −1 if it had none. */
    private int place(int pair, int feature) {
        for (int m = 1; m >= 0; m--) {
            if (features[2 * pair + m] == feature && kept[KEPT * pair + POINT * m] > 0) {
                return m;
            }
        }
        return -1;
    }
}
