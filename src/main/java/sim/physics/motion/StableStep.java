// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * How long the steps of an explicit method may be for vibrations that it does not follow to die away. The error of a step says
 * nothing of it: where what vibrates is small, steps are accepted that make it larger, until it is as large as the tolerance, or
 * some tens of that; and the vibrations of light rods as large as this throw about the heavy body that they carry.
 *
 * <p>The fastest frequency ω is found by power iteration with differences of the accelerations, ω² = ‖a(x + εu) − a(x)‖ / ‖εu‖
 * (as Sommeijer, Shampine and Verwer 1998 do for RKC). It costs an evaluation each time, so it is asked for only where something
 * hints at it: after a step that was rejected, and now and then while steps are held.
 */
final class StableStep implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Iterations from a direction that says nothing: 0.9 of the frequency or more, for which methods leave room. */
    private static final int FIRST = 3;

    /** The most steps after which a rejected one asks again: twice as many as the last time if there was nothing to hold. */
    private static final int MOST_PATIENCE = 32;

    /** Steps after which one that is held asks. */
    private static final int HELD = 5;

    /** The same of any step where masses are unlike by more than a ratio: there what vibrates may grow unseen. */
    private static final int UNLIKE = 2;

    private static final double MOST_ALIKE = 100;

    /**
     * Part of the last step that one is at least: a force that jumps from one place to the next looks as stiff as the places are
     * near.
     */
    private static final double LEAST = 1.0 / 8;

    /** Distance of the places whose accelerations are compared, in sizes of a body: half of the digits. */
    private static final double APART = 0x1p-24;

    /** Part of what a frequency was that it is taken for at least after one iteration more, whose direction need not be the best. */
    private static final double KEEP = 0.8;

    /** What resists a vibration, over what drives it, from which it dies away by itself: ten times within some five swings. */
    private static final double DAMPED = 0.1;

    /** By first body of a group: the frequency, steps since it was found, and of how many coordinates; 0: not yet. */
    private double[] frequency = {};

    /** Whether the vibration was found to last. */
    private boolean[] lasts = {};

    private int[] age = {};
    private int[] patience = {};
    private int[] size = {};

    /** The direction of the last iteration, by block. */
    private double[] direction = {};

    StableStep() {
        // grows with the state
    }

    private void ensure(int length) {
        if (direction.length < length) {
            direction = Arrays.copyOf(direction, length);
            frequency = Arrays.copyOf(frequency, length / State.BLOCK);
            lasts = Arrays.copyOf(lasts, frequency.length);
            age = Arrays.copyOf(age, frequency.length);
            patience = Arrays.copyOf(patience, frequency.length);
            size = Arrays.copyOf(size, frequency.length);
        }
    }

    /**
     * Shortens a step so that the method damps what is fast.
     *
     * @param path has where the step begins, whose accelerations are known
     * @param reach the step times the frequency up to which the method does
     * @param length what its error lets it be
     */
    double shorten(IntList bodies, Path path, State state, double t, double reach, double length) {
        Stages s = path.stages;
        int first = bodies.values[0];
        ensure(path.stage.length);
        age[first] += s.isRetry ? 0 : 1;
        boolean isNew = size[first] != s.size;
        if (isNew) {
            frequency[first] = 0;
            lasts[first] = false;
            patience[first] = 1;
        }
        boolean isHeld = frequency[first] * length > reach;
        boolean isLate = age[first] >= (s.isRetry ? patience[first] : HELD);
        boolean asks = s.isRetry ? isNew || isLate : isHeld && (isLate || !lasts[first]);
        if (asks || (isNew || age[first] >= UNLIKE) && areUnlike(bodies, state)) {
            double apart = APART * state.body(first).getShape().boundingRadius() * s.weight[0];
            look(bodies, s, t, apart);
            isHeld = frequency[first] * length > reach;
            if (isHeld && (s.isRetry || !lasts[first])) {
                lasts[first] = !isDamped(bodies, s, t, apart);
                frequency[first] = lasts[first] ? frequency[first] : 0;
                isHeld = lasts[first];
            }
            patience[first] = isHeld ? 1 : Math.min(2 * patience[first], MOST_PATIENCE);
        }
        return isHeld ? Math.min(length, Math.max(reach / frequency[first], LEAST * path.made[first])) : length;
    }

    private static boolean areUnlike(IntList bodies, State state) {
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        for (int k = 0; k < bodies.size; k++) {
            double w = state.w().values()[State.BLOCK * bodies.values[k]];
            least = Math.min(least, w);
            most = Math.max(most, w);
        }
        return most > MOST_ALIKE * least;
    }

    /** Finds the frequency; the way between places that are compared is in units of what is allowed. */
    private void look(IntList bodies, Stages s, double t, double way) {
        int first = bodies.values[0];
        System.arraycopy(s.a0, 0, s.offX, 0, s.size);
        if (s.isRetry && s.coordinates.pass(s.offX)) {
            s.coordinates.accelerate(s.x0, s.v0, t, s.a); // what ties let pass there is asked for below
        }
        boolean isNew = size[first] != s.size;
        for (int m = 0; isNew && m < s.size; m++) {
            direction[slot(bodies, m)] = (m & 1) == 0 ? s.a0[m] : -s.a0[m];
        }
        double square = 0;
        for (int k = lasts[first] && !s.isRetry ? 1 : FIRST; k > 0; k--) {
            square = change(bodies, s, t, way, 0) / way;
            for (int m = 0; square > 0 && m < s.size; m++) {
                direction[slot(bodies, m)] = s.offX[m];
            }
        }
        frequency[first] = Math.max(Math.sqrt(square), lasts[first] ? KEEP * frequency[first] : 0);
        age[first] = 0;
        size[first] = s.size;
    }

    /** Whether the fastest vibration dies away by itself, where the method must not help. */
    private boolean isDamped(IntList bodies, Stages s, double t, double way) {
        double rate = frequency[bodies.values[0]];
        return change(bodies, s, t, way, rate) > DAMPED * rate * rate * way;
    }

    /**
     * How the accelerations change a small way along the direction, into {@code offX}.
     *
     * @param rate of velocities over places: if it is not 0 those are changed, and places stay
     * @return its size; 0 if that is no number
     */
    private double change(IntList bodies, Stages s, double t, double way, double rate) {
        for (int m = 0; m < s.size; m++) {
            s.offX[m] = direction[slot(bodies, m)];
        }
        s.coordinates.pass(s.offX);
        double scale = way / s.norm(s.offX);
        if (!(scale > 0 && scale < Double.POSITIVE_INFINITY)) {
            return 0;
        }
        for (int m = 0; m < s.size; m++) {
            s.x[m] = s.x0[m] + (rate == 0 ? scale * s.offX[m] : 0);
            s.v[m] = s.v0[m] + rate * scale * s.offX[m];
        }
        s.coordinates.accelerate(s.x, s.v, t, s.a);
        for (int m = 0; m < s.size; m++) {
            s.offX[m] = s.a[m] - s.a0[m];
        }
        s.coordinates.pass(s.offX);
        double found = s.norm(s.offX);
        return found < Double.POSITIVE_INFINITY ? found : 0;
    }

    /** Where a coordinate of a group is kept: its bodies' blocks are its own. */
    private static int slot(IntList bodies, int m) {
        return State.BLOCK * bodies.values[m / State.BLOCK] + m % State.BLOCK;
    }
}
