// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.Ties;
import sim.physics.motion.Trajectories;

/**
 * When the first open point of a heap strikes. If the time of a solution went on beyond that, the point would be stopped before it touches
 * anything; and where another corner of a box strikes first, it would be stopped where it touches nothing at all.
 */
final class HeapClosing implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Speed of what strikes, in units of what forces give in the time: slower points come to lie. */
    private static final double FAST = 1;

    /** How much faster a point gets at most by what forces give, in a mean over the time: levers may make it more than half. */
    private static final double MORE = 0.75;

    /** Way in the time, relative to the smaller body, of what hardly moves. */
    private static final double SLOW = 1e-6;

    /** By point: its gap, what turning may take of that in the time, and a way that is none. */
    private double[] gaps = {};

    private double[] bends = {};

    private double[] least = {};

    /** By point: coefficients of restitution, and speeds with which points that strike now are to part. */
    private double[] restitution = {};

    private double[] rebounds = {};

    /** Whether a point has pressed in the last solution. */
    private boolean[] presses = {};

    /** How long before they touch points are taken to strike now; 0 if none does. */
    private double span;

    /** Speed that forces give in the time, at most. */
    private double given;

    /** Bodies that are struck now, by their numbers in the heap. */
    private final IntList struck = new IntList();

    private final Trajectories trajectories;
    private final HeapBodies by;
    private final HeapSystem system;
    private final HeapCourses courses;
    private final BodyScale scales;
    private final HeapMeeting meeting;

    HeapClosing(
            Trajectories trajectories, HeapBodies by, HeapSystem system, HeapCourses courses, BodyScale scales, HeapMeeting meeting) {
        this.trajectories = trajectories;
        this.by = by;
        this.system = system;
        this.courses = courses;
        this.scales = scales;
        this.meeting = meeting;
    }

    /** Takes in a point. */
    void set(int p, double gap, double bend, double size, double bounce, boolean isPressed) {
        if (bends.length <= p) {
            gaps = Arrays.copyOf(gaps, 2 * p + 2);
            bends = Arrays.copyOf(bends, 2 * p + 2);
            least = Arrays.copyOf(least, 2 * p + 2);
            restitution = Arrays.copyOf(restitution, 2 * p + 2);
            presses = Arrays.copyOf(presses, 2 * p + 2);
            rebounds = Arrays.copyOf(rebounds, 2 * p + 2);
        }
        gaps[p] = gap;
        bends[p] = bend;
        least[p] = SLOW * size;
        restitution[p] = bounce;
        presses[p] = isPressed;
        rebounds[p] = Double.NEGATIVE_INFINITY;
    }

    /**
     * Finds how soon the first point strikes that is open; a little too soon, as what remains of its gap is soon found. The system has the
     * velocities of the bodies, and how fast gaps may close in the time.
     *
     * @param scale speed that forces give bodies which nothing drives in the time
     * @param shortest time in which a gap is closed that counts as none
     * @return the time if no point strikes in it
     */
    double first(IntList heap, double scale, double time, double shortest) {
        given = Math.max(scale, driven(heap, time));
        double first = time;
        span = 0;
        struck.clear();
        for (int p = 0; p < system.contacts(); p++) {
            double speed = -system.normal(p);
            double way = -system.bound(p) * time;
            if (!(speed > FAST * given && speed * time > least[p])) {
                continue;
            }
            if (way <= speed * shortest) {
                span = Math.max(span, Math.max(shortest, gaps[p] / speed));
                rebounds[p] = restitution[p] > 0 ? restitution[p] * speed : rebounds[p];
                note(system.rows().body(p, 0));
                note(system.rows().body(p, 1));
                continue;
            }
            double part = Math.min(1, way / speed / time);
            double faster = part * (MORE * given + bends[p] / time);
            first = Math.min(first, Math.max(shortest, way / (speed + faster)));
        }
        for (int k = 0; k < heap.size && first < time; k++) {
            by.closedIn[heap.values[k]] = trajectories.step() + 1;
        }
        return first;
    }

    /**
     * Finds the points that bounce now in a heap that has been struck within the step: as those do which strike at the start of one, or what stands
     * would bounce, and what moves would not.
     *
     * @param pull acceleration that forces give
     * @param shortest time in which a gap is closed that counts as none
     */
    void bounce(double pull, double shortest) {
        double h = trajectories.h();
        span = 0;
        for (int p = 0; p < system.contacts(); p++) {
            double speed = restitution[p] > 0 ? -system.normal(p, courses.without()) : 0;
            if (speed > FAST * pull * h && speed * h > least[p] && gaps[p] <= speed * shortest) {
                span = shortest;
                rebounds[p] = restitution[p] * speed;
            }
        }
    }

    /**
     * Lets what has pressed close its gap no faster than in a whole step, where solutions end early in this one: in a short time it would fall
     * freely into the gap that is kept for the bends of a long one.
     */
    void hold(IntList heap) {
        boolean isShort = false;
        for (int k = 0; k < heap.size; k++) {
            isShort |= by.closedIn[heap.values[k]] == trajectories.step() + 1;
        }
        for (int p = 0; p < system.contacts() && isShort; p++) {
            if (presses[p] && -system.normal(p) <= FAST * given && given < Double.POSITIVE_INFINITY) {
                system.bound(p, Math.max(system.bound(p), -Math.max(0, gaps[p]) / trajectories.h()));
            }
        }
    }

    /**
     * Lets points that are too deep part almost as fast as they approach, where so much has happened in a step that it would not end: without that
     * they would sink a little each time.
     */
    void hop(IntList deep) {
        for (int k = 0; k < deep.size; k++) {
            int p = deep.values[k];
            double speed = -system.normal(p);
            rebounds[p] = speed > 0 ? Math.max(rebounds[p], FreeHeap.HOP * speed) : rebounds[p];
        }
    }

    /** Speed that forces give to bodies which the integrator drives; infinite before it is known. */
    private double driven(IntList heap, double time) {
        double most = 0;
        for (int k = 0; k < heap.size; k++) {
            double pull = by.pull[heap.values[k]];
            most = trajectories.isDriven(heap.values[k]) ? Math.max(most, pull > 0 ? pull * time : Double.POSITIVE_INFINITY) : most;
        }
        return most;
    }

    /**
     * Speed that forces have given to driven bodies in as long a time when their heap was solved last; 0 where that is not known. Authors' forces are not known
     * beforehand, and what has come to rest has no speed beside which anything is little.
     */
    double known(IntList heap, double time) {
        double most = 0;
        for (int k = 0; k < heap.size; k++) {
            most = trajectories.isDriven(heap.values[k]) ? Math.max(most, by.pull[heap.values[k]] * time) : most;
        }
        return most;
    }

    /** Takes note of what forces have given to bodies in a time without contacts. */
    void learn(IntList heap, double time) {
        for (int k = 0; k < heap.size; k++) {
            double gained = scales.change(heap.values[k], system.free(), courses.before(), 3 * k);
            by.pull[heap.values[k]] = Math.max(gained / time, Double.MIN_NORMAL);
        }
    }

    /** {@return by point the speeds with which those are to part that strike now and bounce, else −∞} */
    double[] rebounds() {
        return rebounds;
    }

    /** Whether a point strikes now. */
    boolean strikes() {
        return span > 0;
    }

    private void note(int number) {
        if (number >= 0 && !struck.contains(number)) {
            struck.add(number);
        }
    }

    /** Lets what closes at the same instant strike together with the points that strike now; false if there is nothing. */
    boolean gathers(IntList heap, Ties ties, double tau) {
        return span > 0 && meeting.join(heap, struck, ties, tau, 2 * span);
    }
}
