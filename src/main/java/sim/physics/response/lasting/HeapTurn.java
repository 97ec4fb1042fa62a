// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * What turning does to the points of a heap whose forces act evenly over a time: forces act along the normals and at the levers
 * which points have in its middle, and no point approaches along the normal that it has at its end, nor is it too deep there. So
 * places and velocities are of second order in the time (the midpoint rule for forces, the implicit one for constraints).
 */
final class HeapTurn implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Turn, rad, up to which bodies are followed: far beyond it no force acts evenly. */
    private static final double MOST = 0.25;

    /** How far forces may take bodies in a step, relative to their size, for them to be followed: else nothing is as it is foreseen. */
    static final double LONG = 0.5;

    /** Turn, or way along one another relative to levers, that is none in steps in which forces take bodies out of their places, and the less the shorter they are. */
    private static final double NOISE = 1e-5;

    /**
     * Parts of the time at which gaps are looked at, too, where bodies surely move evenly: a force that holds at the end may come too late. Late
     * in the time a gap that is right at its middle and end is least between these, by what is of third order.
     */
    private static final double[] SOONER = {0.75, 0.5, 0.25, 1.0 / 16, 1.0 / 64};

    /** Gap up to which a point is closed, and may not sink at once, in units of the depth that it may have. */
    private static final double CLOSED = 4;

    private final Trajectories trajectories;
    private final HeapSystem system;
    private final TurnedPoint point = new TurnedPoint();
    private final Regain regain;
    private final PointRows end = new PointRows();

    /** By point: the least velocity for the sake of its gap, and the gap that there may be at the end. */
    private double[] least = {};
    private double[] floor = {};

    /** By point: its gap at the start. */
    private double[] start = {};

    /** By point: turn of its bodies, rad, that is an error of their search for forces. */
    private double[] noise = {};

    /** Whether no force but those of the solution changes how bodies move. */
    private boolean isExact;

    /** Velocities at the start, and ways from there; 3 per body. */
    private double[] before = {};
    private double[] after = {};

    /** By how much the ways of bodies in the time are others than of velocities that change evenly, in the last integration; 3 per body. */
    private double[] bend = {};

    /** What impulses would do to bodies that nothing ties, and what of that was not known when these were integrated. */
    private double[] pushes = {};

    private double[] missed = {};

    /** By body: acceleration when it was solved for last, and the step in which that was. */
    private double[] gained = {};
    private double[] knownIn = {};

    HeapTurn(Trajectories trajectories, HeapSystem system, Regain regain) {
        this.trajectories = trajectories;
        this.system = system;
        this.regain = regain;
    }

    /**
     * Takes in a point.
     *
     * @param deepest how deep it may be
     * @param roam how far forces take its bodies in a step, relative to their size
     */
    void set(int p, Manifold m, int k, double deepest, double roam) {
        if (floor.length <= p) {
            floor = Arrays.copyOf(floor, 2 * p + 2);
            noise = Arrays.copyOf(noise, 2 * p + 2);
            start = Arrays.copyOf(start, 2 * p + 2);
        }
        floor[p] = deepest;
        start[p] = m.gaps[k];
        noise[p] = roam > LONG ? Double.POSITIVE_INFINITY : NOISE * Math.min(1, roam);
        point.set(p, m, k);
    }

    /** Begins with the bodies' velocities at the start of the time, and goes on from there as they have done, until better is known. */
    void begin(IntList heap, double time, boolean regains, boolean isForeseen) {
        isExact = isForeseen;
        int n = system.contacts();
        least = least.length < n ? new double[2 * n] : least;
        for (int p = 0; p < n; p++) {
            least[p] = system.bound(p);
        }
        if (before.length < 3 * heap.size) {
            before = new double[6 * heap.size];
            after = new double[6 * heap.size];
            bend = new double[6 * heap.size];
        }
        Arrays.fill(bend, 0, 3 * heap.size, 0);
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            int o = body * Trajectories.STRIDE + Trajectories.VX;
            System.arraycopy(trajectories.data(), o, before, 3 * k, State.BLOCK);
            for (int c = 0; c < State.BLOCK; c++) {
                int at = 3 * body + c;
                after[3 * k + c] = before[3 * k + c] + (at < gained.length && knownIn[body] >= trajectories.step() - 1 ? gained[at] * time : 0);
            }
        }
        turn(after, time, regains);
    }

    /** Their velocities at the start of the time. */
    double[] before() {
        return before;
    }

    /** Takes the velocities that bodies would have at the end of the time if they went on as they have done, to an array. */
    void foresee(double[] v, int bodies) {
        System.arraycopy(after, 0, v, 0, 3 * bodies);
    }

    /**
     * Takes note of where an integration has brought a body. What turns with the others is pushed along a normal that stays meanwhile, to one side first
     * and to the other later: that does not change how fast it is in the end, but where.
     *
     * @param k number of the body in the heap
     * @param c component
     * @param way it has gone in the time
     * @param v velocity that it has then
     */
    void bend(int k, int c, double way, double v, double time) {
        bend[3 * k + c] = way - 0.5 * (before[3 * k + c] + v) * time;
    }

    /** Keeps what bodies gain in a time, as they will in the next one. */
    void keep(IntList heap, double[] v, double time) {
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            if (knownIn.length <= body) {
                knownIn = Arrays.copyOf(knownIn, 2 * body + 2);
                gained = Arrays.copyOf(gained, 3 * knownIn.length);
            }
            knownIn[body] = trajectories.step();
            for (int c = 0; c < State.BLOCK; c++) {
                gained[3 * body + c] = (v[3 * k + c] - before[3 * k + c]) / time;
            }
        }
    }

    /**
     * Turns points with the velocities that bodies reach at the end of the time.
     *
     * @param v 3 per body
     * @param regains whether points may have to part
     */
    void turn(double[] v, double time, boolean regains) {
        aim(v, time);
        bound(v, time, regains);
    }

    /** Lets points part as they have to where they are at the end of the time, with velocities that bodies reach then. */
    void bound(double[] v, double time, boolean regains) {
        for (int p = 0; p < system.contacts(); p++) {
            boolean isFollowed = look(p, v, 0.5 * time, 0.5 * time, 1);
            set(p, end);
            double normal = end.normal(p, v);
            system.turn(p, normal - system.rows().normal(p, v), end.tangent(p, v) - system.rows().tangent(p, v));
            if (regains && isFollowed) { // else the gap that is looked at is that of the start, and the bound is, too
                double missing = 2 * (floor[p] - point.gap);
                double regained = missing > 0 ? regain.speed(missing) : missing / time; // in next to no time rounding would be any speed
                system.bound(p, Math.max(least[p], normal + regained));
                holdSooner(p, v, time, normal);
            }
        }
    }

    private void holdSooner(int p, double[] v, double time, double normal) {
        boolean isClosed = start[p] <= -CLOSED * floor[p];
        for (int k = 0; k < SOONER.length && isExact; k++) {
            double part = SOONER[k];
            look(p, v, part * (1 - 0.5 * part) * time, 0.5 * part * part * time, 0);
            double deepest = isClosed ? start[p] + part * part * (floor[p] - start[p]) : floor[p];
            system.bound(p, Math.max(system.bound(p), normal - 2 * (point.gap - deepest) / (part * part * time)));
        }
    }

    /** Lets points have the least velocities that they have where they are now. */
    void forget() {
        for (int p = 0; p < system.contacts(); p++) {
            system.bound(p, least[p]);
        }
    }

    /** What the impulses would do to some bodies if nothing tied them; their ties reply when they are driven. 3 per body. */
    double[] pushes(int bodies) {
        if (pushes.length < 3 * bodies) {
            pushes = new double[6 * bodies];
            missed = new double[6 * bodies];
        }
        Arrays.fill(pushes, 0, 3 * bodies, 0);
        system.pushAlone(pushes);
        return pushes;
    }

    /** Gives bodies the velocities that their pushes give them, when these are all. */
    void settle(double[] v, int bodies) {
        double[] all = pushes(bodies);
        for (int k = 0; k < 3 * bodies; k++) {
            v[k] = before[k] + all[k];
        }
    }

    /** By how much velocities are others than at the start. 3 per body. */
    double[] changes(double[] v, int bodies) {
        for (int k = 0; k < 3 * bodies; k++) {
            pushes[k] = v[k] - before[k];
        }
        return pushes;
    }

    /**
     * Makes up for points that were not where the last pushes had them, in the system's velocities: at once for what nothing ties, else by
     * the next integration.
     *
     * @return the velocities that were missed
     */
    double[] makeUp(int bodies) {
        Arrays.fill(missed, 0, 3 * bodies, 0);
        system.pushAlone(missed);
        for (int k = 0; k < 3 * bodies; k++) {
            missed[k] -= pushes[k];
            system.v[k] += system.isTied() ? 0 : missed[k];
        }
        return missed;
    }

    /** Lets forces act where points are in the middle of the time, with velocities that bodies reach at its end. */
    void aim(double[] v, double time) {
        for (int p = 0; p < system.contacts(); p++) {
            look(p, v, 0.375 * time, 0.125 * time, 0.5); // of velocities that change evenly, and half of what ways differ by beside
            set(p, system.middle());
        }
    }

    private void set(int p, PointRows rows) {
        int a = system.rows().body(p, 0);
        int b = system.rows().body(p, 1);
        rows.set(p, a, b, point.nx, point.ny, point.leverA(), point.leverB(), point.armA(), point.armB());
    }

    /** Takes a point to where its bodies bring it; false if it is left where it is. */
    private boolean look(int p, double[] v, double first, double last, double bent) {
        int a = system.rows().body(p, 0);
        int b = system.rows().body(p, 1);
        double turnA = way(a, 2, v, first, last, bent);
        double turnB = way(b, 2, v, first, last, bent);
        double turn = Math.max(Math.abs(turnA), Math.abs(turnB));
        double dx = way(b, 0, v, first, last, bent) - way(a, 0, v, first, last, bent);
        double dy = way(b, 1, v, first, last, bent) - way(a, 1, v, first, last, bent);
        boolean isNone = turn < noise[p] && point.slide(p, dx, dy) < noise[p];
        double part = isNone ? 0 : Math.min(1, MOST / turn);
        point.look(p, part * dx, part * dy, part * turnA, part * turnB);
        return part > 0;
    }

    private double way(int body, int c, double[] v, double first, double last, double bent) {
        return body < 0 ? 0 : first * before[3 * body + c] + last * v[3 * body + c] + bent * bend[3 * body + c];
    }
}
