// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.DisjointSets;
import sim.physics.internal.IntList;
import sim.physics.motion.Trajectories;

/**
 * Takes motion relative to one another from the bodies of a heap on which no force acts. What is left is theirs together: of bodies that lie on
 * nothing fixed the motion as one, with their momenta; of those on a wall the momentum along it; and nothing on several walls.
 */
final class HeapHalt implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Energy that is but rounding, relative to what there is. */
    private static final double ROUNDING = 1e-14;

    /** Sine of the angle between normals up to which walls are one. */
    private static final double PARALLEL = 1e-9;

    private final HeapSystem s;
    private final Trajectories trajectories;
    private final HeapNotes notes;
    private final TakenMotion taken;

    /** Where bodies are when they have their velocities, 2 each. */
    private double[] places = {};

    /** By body: the first of those that it presses on, directly or by others; and what these have gained, twice as much as energy. */
    private int[] groups = {};

    private double[] gains = {};

    /** The motion together: of a place, and about it. */
    private double x;

    private double y;
    private double vx;
    private double vy;
    private double spin;

    HeapHalt(HeapSystem system, Trajectories trajectories, HeapNotes notes) {
        s = system;
        this.notes = notes;
        taken = new TakenMotion(system);
        this.trajectories = trajectories;
    }

    /**
     * Takes all of it. On the straight ways on which bodies go then as one they part, by a second order of the time, as none of their normals turns
     * against the line of centres.
     */
    void halt(IntList heap) {
        place(heap, s.v, 0);
        Arrays.fill(groups, 0, heap.size, 0);
        find(0);
        taken.keep();
        keep(0, 0);
        taken.tell(notes, 0);
    }

    /**
     * Takes as much of it as makes up for energy that contacts have given. They follow one another to the second order of the time, and what is left
     * of that would add up. The speeds with which points part are smaller by that, but none approaches. Bodies that do not press on one another
     * know nothing of that.
     *
     * @param from velocities before
     * @param time in which they change evenly
     */
    void gainNothing(IntList heap, double[] from, double time) {
        if (!(HeapEnergy.gained(s, from) > ROUNDING * HeapEnergy.of(s, from))) {
            return;
        }
        taken.keep();
        place(heap, from, time);
        group();
        count(from);
        for (int group = 0; group < s.bodyCount(); group++) {
            if (gains[group] > 0) {
                find(group);
                double there = energyWithin(group);
                keep(group, there > gains[group] ? Math.sqrt(1 - gains[group] / there) : 0);
            }
        }
        taken.tell(notes, time);
    }

    private void place(IntList heap, double[] from, double time) {
        if (groups.length < heap.size) {
            places = new double[4 * heap.size];
            groups = new int[2 * heap.size];
            gains = new double[2 * heap.size];
        }
        double[] d = trajectories.data();
        for (int k = 0; k < heap.size; k++) {
            int o = heap.values[k] * Trajectories.STRIDE;
            places[2 * k] = d[o + Trajectories.X0] + 0.5 * time * (from[3 * k] + s.v[3 * k]);
            places[2 * k + 1] = d[o + Trajectories.Y0] + 0.5 * time * (from[3 * k + 1] + s.v[3 * k + 1]);
        }
    }

    private void group() {
        for (int k = 0; k < s.bodyCount(); k++) {
            groups[k] = k;
        }
        for (int p = 0; p < s.contacts(); p++) {
            if (s.normalImpulse(p) != 0 && !s.rows().isOnFixed(p)) {
                DisjointSets.join(groups, s.rows().body(p, 0), s.rows().body(p, 1));
            }
        }
        for (int k = 0; k < s.bodyCount(); k++) {
            groups[k] = DisjointSets.find(groups, k);
        }
    }

    /** Counts what groups have gained; where surfaces move, which give some, all of them are one. */
    private void count(double[] from) {
        Arrays.fill(gains, 0, s.bodyCount(), 0);
        if (s.fastestBelt() > 0) {
            Arrays.fill(groups, 0, s.bodyCount(), 0);
            gains[0] = HeapEnergy.gained(s, from) - ROUNDING * HeapEnergy.of(s, from);
            return;
        }
        for (int k = 0; k < s.bodyCount(); k++) {
            gains[groups[k]] += HeapEnergy.gainedBy(s, from, k) - ROUNDING * HeapEnergy.of(s, from, k);
        }
    }

    private void find(int group) {
        double mass = 0;
        x = 0;
        y = 0;
        vx = 0;
        vy = 0;
        spin = 0;
        for (int k = 0; k < s.bodyCount(); k++) {
            double m = groups[k] == group ? 1 / s.w[2 * k] : 0;
            mass += m;
            x += m * places[2 * k];
            y += m * places[2 * k + 1];
            vx += m * s.v[3 * k];
            vy += m * s.v[3 * k + 1];
        }
        x /= mass;
        y /= mass;
        vx /= mass;
        vy /= mass;
        if (!slideAlongWalls(group)) {
            turn(group);
        }
    }

    /** Leaves what walls do not oppose; false if there are none. */
    private boolean slideAlongWalls(int group) {
        int wall = -1;
        for (int p = 0; p < s.contacts(); p++) {
            if (!s.rows().isOnFixed(p) || groups[Math.max(s.rows().body(p, 0), s.rows().body(p, 1))] != group) {
                continue;
            }
            boolean isFirst = wall < 0;
            wall = isFirst ? p : wall;
            double nx = s.rows().nx(p);
            double ny = s.rows().ny(p);
            boolean isOther = Math.abs(nx * s.rows().ny(wall) - ny * s.rows().nx(wall)) > PARALLEL;
            double away = isOther ? 0 : vy * nx - vx * ny;
            vx = -away * ny;
            vy = away * nx;
        }
        return wall >= 0;
    }

    private void turn(int group) {
        double inertia = 0;
        double momentum = 0;
        for (int k = 0; k < s.bodyCount(); k++) {
            if (groups[k] == group) {
                double dx = places[2 * k] - x;
                double dy = places[2 * k + 1] - y;
                inertia += (dx * dx + dy * dy) / s.w[2 * k] + 1 / s.w[2 * k + 1];
                momentum += (dx * (s.v[3 * k + 1] - vy) - dy * (s.v[3 * k] - vx)) / s.w[2 * k] + s.v[3 * k + 2] / s.w[2 * k + 1];
            }
        }
        spin = momentum / inertia;
    }

    /** Twice the energy of motions relative to that together. */
    private double energyWithin(int group) {
        double sum = 0;
        for (int k = 0; k < s.bodyCount(); k++) {
            if (groups[k] == group) {
                double ux = s.v[3 * k] - speedX(k);
                double uy = s.v[3 * k + 1] - speedY(k);
                double turn = s.v[3 * k + 2] - spin;
                sum += (ux * ux + uy * uy) / s.w[2 * k] + turn * turn / s.w[2 * k + 1];
            }
        }
        return sum;
    }

    private void keep(int group, double part) {
        for (int k = 0; k < s.bodyCount(); k++) {
            if (groups[k] == group) {
                s.v[3 * k] = speedX(k) + part * (s.v[3 * k] - speedX(k));
                s.v[3 * k + 1] = speedY(k) + part * (s.v[3 * k + 1] - speedY(k));
                s.v[3 * k + 2] = spin + part * (s.v[3 * k + 2] - spin);
            }
        }
    }

    private double speedX(int k) {
        return vx - spin * (places[2 * k + 1] - y);
    }

    private double speedY(int k) {
        return vy + spin * (places[2 * k] - x);
    }
}
