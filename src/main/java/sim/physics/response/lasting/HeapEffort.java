// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.internal.IntList;

/**
 * What contacts give to driven bodies while their forces hold. These keep the directions of the normals at the start of that
 * time: where a limb turns about a peg its normal turns away, and a force that holds it up does work. That grows with the square
 * of the time, so a shorter one makes it little.
 */
final class HeapEffort implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Share of the kinetic energy that contacts may give in a step. */
    private static final double MOST = 1e-3;

    /** Way, relative to its size, by which a body may be lifted against what forces do: the gaps that are kept. */
    private static final double LIFT = 1e-4;

    /** Time for which forces hold in any case, relative to the step. */
    private static final double SHORT = 2e-3;

    /** Bounds of what is left of a time that was too long. */
    private static final double LEAST = 0.125;

    private static final double GREATEST = 0.5;

    private final BodyScale scales;
    private double shorter;
    private double work;
    private boolean isOver;

    /** Speed that a motor gives to a body in the time. */
    private double reach;

    HeapEffort(BodyScale scales) {
        this.scales = scales;
    }

    /** Sets the speed that a motor gives to a body in the time: with it, too, contacts lift what they keep apart. */
    void setReach(double speed) {
        reach = speed;
    }

    double reach() {
        return reach;
    }

    /**
     * Whether contacts give too much while their forces hold, and these can be found for a shorter time.
     *
     * @param before velocities at the start of that time, those at its end being the system's
     * @param pulls what forces do to the bodies
     * @param time for which forces hold
     * @param step of the engine
     */
    boolean isTooMuch(HeapSystem s, double[] before, HeapPull pulls, IntList heap, double time, double step) {
        work = HeapEnergy.work(s, before) - given(s, before, pulls, heap, time, step);
        isOver = false;
        if (!(work > 0)) {
            return false;
        }
        double most = 0.5 * MOST * HeapEnergy.of(s, before) * time / step;
        for (int k = 0; k < heap.size; k++) {
            double pull = Math.max(pulls.seen(heap.values[k]), Math.max(reach, gained(s.free(), before, 3 * k)) / time);
            most += s.w[2 * k] == 0 ? 0 : LIFT * scales.radius(heap.values[k]) * pull / s.w[2 * k];
        }
        shorter = time * Math.max(LEAST, Math.min(GREATEST, most / work));
        isOver = work > most;
        return isOver && time > SHORT * step;
    }

    /**
     * What moving surfaces give, but no more than makes all bodies of the heap as fast as the fastest of them in a step, or than these rub off
     * under their weight: what they wedge would be given any amount.
     */
    private double given(HeapSystem s, double[] before, HeapPull pulls, IntList heap, double time, double step) {
        double fastest = s.fastestBelt();
        double most = 0;
        for (int k = 0; k < heap.size && fastest > 0; k++) {
            double pull = Math.max(pulls.seen(heap.values[k]), gained(s.free(), before, 3 * k) / time);
            most += s.w[2 * k] == 0 ? 0 : fastest * time * (fastest / step + pull) / s.w[2 * k];
        }
        return fastest == 0 ? 0 : Math.min(most, HeapEnergy.given(s));
    }

    /** How fast a body's centre would become without contacts. */
    private static double gained(double[] v, double[] before, int at) {
        return Math.max(Math.abs(v[at] - before[at]), Math.abs(v[at + 1] - before[at + 1]));
    }

    /** Whether contacts give too much, be the time as short as it is. */
    boolean isOver() {
        return isOver;
    }

    /** What they give. */
    double work() {
        return work;
    }

    /** A time in which it may be little enough. */
    double shorter() {
        return shorter;
    }
}
