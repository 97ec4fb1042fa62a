// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.internal.IntList;

/** What happens at once in a {@link HeapSystem}, before forces act: the approach of points that close too fast ends. */
final class HeapStrike implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of the energy that a strike may add to it, where points have to part. */
    private static final double GAIN = 1e-3;

    /** Speed at which points hardly close, relative to the bodies' or to what forces give them: more than what solutions leave. */
    private static final double HARDLY = 1e-10;

    /** The same for points that have just been struck; and the part of the speed that they lack which they get then at once. */
    private static final double STRUCK = 1e-9;

    private static final double LIFT = 0.1;

    /** Least normal velocities, while others are in their place. */
    private double[] kept = {};

    /** Velocities with what forces give, while others are in their place. */
    private double[] given = {};

    private boolean isStuck;

    private final HeapSystem system;
    private final HeapNotes notes;
    private final HeapCourses courses;
    private final BodyScale scales;

    HeapStrike(HeapSystem system, HeapNotes notes, HeapCourses courses, BodyScale scales) {
        this.system = system;
        this.notes = notes;
        this.courses = courses;
        this.scales = scales;
    }

    /**
     * Changes the velocities at once where points close too fast.
     *
     * @param deep points that are too deep
     * @param scale what forces give bodies
     * @param bounces by contact: speeds with which points are to part then
     * @param rebounds by points behind the contacts: the same
     * @return false if none do
     */
    boolean act(IntList heap, IntList deep, double scale, double[] bounces, double[] rebounds) {
        double speed = scales.fastest(heap, system.v);
        if (!isDue(deep, speed, scale)) {
            return false;
        }
        strike(Math.max(speed, scale), bounces, rebounds);
        notes.strike(1);
        courses.strike(heap, system.v);
        return true;
    }

    /** The same where the system's velocities have what forces give them, and points the impulses from which they start: without both. */
    boolean actFirst(IntList heap, IntList deep, double scale, double[] bounces) {
        given = given.length < 3 * heap.size ? new double[6 * heap.size] : given;
        System.arraycopy(system.v, 0, given, 0, 3 * heap.size);
        System.arraycopy(courses.before(), 0, system.v, 0, 3 * heap.size);
        if (!isDue(deep, scales.fastest(heap, system.v), scale)) {
            System.arraycopy(given, 0, system.v, 0, 3 * heap.size); // or what forces give them would be lost
            return false;
        }
        system.startFromNothing();
        return act(heap, deep, scale, bounces, bounces);
    }

    /**
     * Whether something is to happen at once: a point closes faster than it may, or is deeper than it may be and does not part, for
     * which forces that act evenly come too late.
     *
     * @param deep points that are too deep
     * @param speed of the bodies
     * @param scale what forces give them
     */
    private boolean isDue(IntList deep, double speed, double scale) {
        isStuck = false;
        for (int k = 0; k < deep.size; k++) {
            isStuck |= Math.abs(system.normal(deep.values[k])) <= STRUCK * speed;
        }
        boolean isDue = isStuck;
        double none = HARDLY * Math.max(speed, scale);
        for (int p = 0; p < system.size() && !isDue; p++) {
            isDue = !system.isMotor(p) && system.normal(p) < Math.min(0, system.bound(p)) - none;
        }
        return isDue;
    }

    /**
     * Ends the approach of points that close faster than they may.
     *
     * @param bounces by contact: speeds with which points are to part then
     * @param rebounds by points behind the contacts: the same
     */
    private void strike(double scale, double[] bounces, double[] rebounds) {
        double lift = isStuck ? LIFT : 0;
        if (kept.length < system.size()) {
            kept = new double[2 * system.size()];
        }
        for (int p = 0; p < system.size(); p++) {
            kept[p] = system.bound(p);
            double least = kept[p] > 0 && !system.isMotor(p) ? lift * kept[p] : Math.min(0, kept[p]);
            system.bound(p, Math.max(least, p < system.contacts() ? bounces[p] : rebounds[p - system.contacts()]));
        }
        boolean right = system.solve(scale, true);
        if (HeapEnergy.isWedged(system, system.free())) {
            system.unwedge(false);
            system.again();
            right = system.solve(scale, true);
        }
        if (!right || HeapEnergy.locks(system, HeapEnergy.LOCKED) || !(HeapEnergy.gained(system, system.free()) <= GAIN * HeapEnergy.of(system, system.free()))) {
            system.solveSoftly(scale);
        }
        for (int p = 0; p < system.size(); p++) {
            system.bound(p, kept[p]);
        }
    }
}
