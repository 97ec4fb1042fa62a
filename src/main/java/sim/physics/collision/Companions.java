// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import sim.physics.collision.broad.Boxes;
import sim.physics.collision.broad.Pairs;
import sim.physics.collision.narrow.Manifold;
import sim.physics.collision.narrow.NarrowPhase;
import sim.physics.internal.IntList;
import sim.physics.internal.Tolerances;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Steering;
import sim.physics.motion.Trajectories;

/**
 * Finds the bodies that a body touches at the instant at which it hits another one of them, as a box that lands flat
 * on three tiles, or a ball that strikes two others; and the other parts with which two bodies touch then, as a table with its legs. By rounding
 * it meets one a little before the others: by the rounding of a coordinate over its speed. Solved one after the other, these impacts would make it
 * turn, or turn it aside. Tiles are fixed, or their authors move them alike.
 */
final class Companions implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of the speed of an impact from which on another one is as good. */
    private static final double COMPARABLE = 1e-3;

    /** Roundings by which two gaps may differ that are one. */
    private static final double BLUR = 4;

    /** Cosine between normals that are the same. */
    private static final double PARALLEL = 1 - 1e-12;

    /** Length along which sides lie on one another, relative to the smaller body. */
    private static final double SIDE = 1e-9;

    private final State state;
    private final Trajectories trajectories;
    private final Boxes boxes;
    private final Pairs pairs;
    private final PairMarks marks;
    private final NarrowPhase narrowPhase;

    private transient Manifold manifold;

    /** The normal of the impact that was looked at last, towards the body that can move. */
    private double nx;

    private double ny;

    Companions(State state, Trajectories trajectories, Boxes boxes, Pairs pairs, PairMarks marks, NarrowPhase narrowPhase) {
        this.state = state;
        this.trajectories = trajectories;
        this.boxes = boxes;
        this.pairs = pairs;
        this.marks = marks;
        this.narrowPhase = narrowPhase;
    }

    /**
     * Adds pairs to those that touch.
     *
     * @param together the pairs that touch; their planned impacts are NaN, and so are those of pairs that are added
     * @param tau offset in the present step
     * @param next offset of what happens next
     * @param motion says which bodies move together; asked about driven ones only
     */
    void gather(IntList together, double tau, double next, Motion motion) {
        if (next <= until(tau)) {
            gatherMoving(together, tau);
        }
        if (next < Double.POSITIVE_INFINITY) {
            gatherTied(together, tau, next, motion);
        }
        for (int k = 0; k < together.size; k++) {
            int a = pairs.first(together.values[k]);
            int b = pairs.second(together.values[k]);
            int body = state.body(a).isDynamic() ? a : b;
            if (!pairs.areWhole()) {
                gatherParts(together, a, b, tau);
            }
            if (state.body(a).isDynamic() == state.body(b).isDynamic() || trajectories.isDriven(body)) {
                continue;
            }
            int ground = body == a ? b : a;
            double late = pairs.countOf(body) > 1 ? blur(together.values[k], body, tau) : tau;
            for (int m = 0; m < pairs.countOf(body); m++) {
                int pair = pairs.of(body, m);
                if (isOne(ground, pairs.other(pair, body))
                        && (mayTouch(pair, tau) || pairs.time(pair) <= late)
                        && !together.contains(pair) // last: all may land together
                        && (mayTouch(pair, tau) ? touches(pair, tau, pairs.time(pair)) : touchesAlong(pair, body, tau))) {
                    pairs.setTime(pair, Double.NaN);
                    together.add(pair);
                }
            }
        }
    }

    /** What bodies strike that move together with one that does, as the links of a chain that fall flat, or the wheels of a car that is put down. */
    private void gatherTied(IntList together, double tau, double next, Motion motion) {
        for (int k = 0, struck = together.size; k < struck; k++) {
            int pair = together.values[k];
            int body = state.body(pairs.first(pair)).isDynamic() ? pairs.first(pair) : pairs.second(pair);
            int ground = pairs.other(pair, body);
            if (!trajectories.isDriven(body) || state.body(ground).isDynamic()) {
                continue;
            }
            int code = pairs.code(pair);
            double late = Math.max(until(tau), late(pair, tau)); // whatever touches of them: all that are put down fall by rounding only
            pairs.setCode(pair, code);
            IntList group = motion.companions(body);
            for (int m = 0; m < group.size && next <= late; m++) {
                gatherFixed(together, group.values[m], ground, tau, late);
            }
        }
    }

    private void gatherFixed(IntList together, int body, int ground, double tau, double late) {
        for (int m = 0; m < pairs.countOf(body); m++) {
            int pair = pairs.of(body, m);
            if (pairs.time(pair) <= late && isOne(ground, pairs.other(pair, body)) && touchesNow(pair, tau)) {
                pairs.setTime(pair, Double.NaN);
                together.add(pair);
            }
        }
    }

    /** Whether another body is fixed as one is that something strikes, or goes as that does. */
    private boolean isOne(int ground, int other) {
        return boxes.isFixed(ground) ? boxes.isFixed(other) : Steering.goAsOne(state.body(ground), state.body(other));
    }

    private boolean touchesNow(int pair, double tau) {
        int code = pairs.code(pair);
        boolean yes = narrowPhase.touches(pair, tau);
        if (!yes) {
            pairs.setCode(pair, code); // as it was when its impact was looked for
        }
        return yes;
    }

    /**
     * What strikes two discs at once that can move, as a ball the two pins behind the first one: by rounding it meets one a little before the other.
     * Only discs, as flush sides would have no end of impacts together; and only what strikes about as fast: balls that go together in a cradle do not.
     */
    private void gatherMoving(IntList together, double tau) {
        if (together.size == 1 && isOfDiscs(together.values[0]) && narrowPhase.touches(together.values[0], tau)) {
            int pair = together.values[0];
            double least = COMPARABLE * Math.max(0, narrowPhase.approach());
            gatherMoving(together, pairs.first(pair), tau, least);
            gatherMoving(together, pairs.second(pair), tau, least);
        }
    }

    private void gatherMoving(IntList together, int body, double tau, double least) {
        for (int m = 0; !boxes.isFixed(body) && m < pairs.countOf(body); m++) {
            int pair = pairs.of(body, m);
            if (pairs.time(pair) <= until(tau) && isOfDiscs(pair) && narrowPhase.touches(pair, tau) && narrowPhase.approach() > least) {
                pairs.setTime(pair, Double.NaN);
                together.add(pair);
            }
        }
    }

    private boolean isOfDiscs(int pair) {
        int a = pairs.first(pair);
        int b = pairs.second(pair);
        return narrowPhase.isCircle(a) && narrowPhase.isCircle(b) && !boxes.isFixed(a) && !boxes.isFixed(b);
    }

    private void gatherParts(IntList together, int a, int b, double tau) {
        for (int m = 0; m < pairs.countOf(a); m++) {
            int pair = pairs.of(a, m);
            boolean isDriven = trajectories.isDriven(a) || trajectories.isDriven(b);
            if (pairs.other(pair, a) == b && !isDriven && mayTouch(pair, tau) && !together.contains(pair)
                    && touches(pair, tau, pairs.time(pair))) {
                pairs.setTime(pair, Double.NaN);
                together.add(pair);
            }
        }
    }

    /** Whether an impact of a pair is planned for now, or may be for the beginning of the next step. */
    private boolean mayTouch(int pair, double tau) {
        double until = until(tau);
        return pairs.time(pair) <= until || until >= trajectories.h() && !marks.isUnseen(pair);
    }

    private double until(double tau) {
        return tau + Tolerances.SOON * trajectories.h();
    }

    /**
     * Until when rounding may put off what is simultaneous with the impact of a body that has hardly any speed, as what is put down and falls by rounding
     * only: that takes it far longer than anything else. Notes the normal of that impact.
     */
    private double blur(int pair, int body, double tau) {
        if (narrowPhase.isCircle(body)) {
            return tau; // it has no side
        }
        int code = pairs.code(pair);
        double late = late(pair, tau);
        boolean isSlow = late > until(tau) && isFlush(pair, tau);
        pairs.setCode(pair, code); // as it was when its impact was looked for
        if (!isSlow) {
            return tau;
        }
        nx = towards(pair, body) * manifold.nx;
        ny = towards(pair, body) * manifold.ny;
        return late;
    }

    /** Until when rounding of the gap may put off what is simultaneous with the impact of a pair; looks at it. */
    private double late(int pair, double tau) {
        boolean isTouching = narrowPhase.touches(pair, tau);
        double speed = narrowPhase.approach();
        return isTouching && speed > 0 ? tau + BLUR * narrowPhase.roundingOfGap() / speed : tau;
    }

    /** Whether a pair touches with sides that are along those of the impact. */
    private boolean touchesAlong(int pair, int body, double tau) {
        int code = pairs.code(pair);
        boolean yes = narrowPhase.touches(pair, tau)
                && isFlush(pair, tau)
                && towards(pair, body) * (nx * manifold.nx + ny * manifold.ny) > PARALLEL;
        if (!yes) {
            pairs.setCode(pair, code);
        }
        return yes;
    }

    /** Whether sides lie on one another, and not a corner on a side or a corner; looks at the pair. */
    private boolean isFlush(int pair, double tau) {
        manifold = manifold == null ? new Manifold() : manifold;
        narrowPhase.contact(pair, tau, manifold);
        double x = manifold.rAx[0] - manifold.rAx[1];
        double y = manifold.rAy[0] - manifold.rAy[1];
        double least = SIDE * Math.min(trajectories.radius(pairs.first(pair)), trajectories.radius(pairs.second(pair)));
        return manifold.count == 2 && x * x + y * y > least * least;
    }

    private int towards(int pair, int body) {
        return pairs.first(pair) == body ? -1 : 1;
    }

    private boolean touches(int pair, double tau, double planned) {
        double until = until(tau);
        if (planned <= until) {
            return narrowPhase.touches(pair, tau);
        }
        // it would be an impact of the next step
        double start = narrowPhase.boundingCircles(pair, tau);
        double first = start == Double.POSITIVE_INFINITY ? start : narrowPhase.firstContact(pair, tau, start, until);
        return narrowPhase.isTouching() && first <= until && narrowPhase.touches(pair, tau);
    }
}
