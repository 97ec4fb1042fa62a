// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.motion.Ground;

/**
 * What the plane does to the bodies of a heap that rub on it, as impulses in the time of a solution, while the impulses of
 * their contacts are known:
 *
 * <pre>
 *   v = u + W Δt F(v),   v = 0 if M u / Δt lies within the limit surface
 * </pre>
 *
 * <p>with u the velocity without the plane. F depends only on the direction of v. It is found by repetition: with the
 * friction of the last direction put in the form −K v, K diagonal, the equation is linear; v is scaled to the length that
 * goes with its direction before.
 */
final class HeapGround implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int REPETITIONS = 8;

    /** Change of velocity, relative to itself, at which the direction of friction is right. */
    private static final double RIGHT = 1e-4;

    /** Speed that may be but the closing of a gap, relative to that which the plane takes from a body in the time. */
    private static final double LITTLE = 1e-3;

    private final Ground plane;
    private double length;

    /** The bodies that rub: their numbers in the heap and indices. */
    private int[] places = {};

    private int[] bodies = {};
    private int count;

    /** Whether the plane holds them; whether they moved at the start. */
    private boolean[] isHeld = {};

    private boolean[] moves = {};

    /** Of those that did not: whether they were held in this solution, and torn off; whether they have moved in it since. */
    private boolean[] isTorn = {};

    private boolean[] slips = {};

    /** Whether something of that is new. */
    private boolean isNew;

    /** Inverse masses and moments of inertia, 2 each; impulses of the plane, 3 each. */
    private double[] w = {};

    private double[] impulses = {};

    private final double[] force = new double[3];

    HeapGround(Ground plane) {
        this.plane = plane;
    }

    /** Begins a heap. */
    void begin(int most, double time) {
        length = time;
        count = 0;
        if (places.length < most) {
            places = new int[2 * most];
            bodies = new int[2 * most];
            isHeld = new boolean[2 * most];
            moves = new boolean[2 * most];
            isTorn = new boolean[2 * most];
            slips = new boolean[2 * most];
            w = new double[4 * most];
            impulses = new double[6 * most];
        }
    }

    /** Takes in a body that rubs, with its velocity at the start. */
    void enter(int place, int body, HeapSystem s, double[] v, int at) {
        places[count] = place;
        bodies[count] = body;
        moves[count] = v[at] != 0 || v[at + 1] != 0 || v[at + 2] != 0;
        isHeld[count] = false;
        isTorn[count] = false;
        slips[count] = false;
        w[2 * count] = s.w[2 * place];
        w[2 * count + 1] = s.w[2 * place + 1];
        Arrays.fill(impulses, 3 * count, 3 * count + 3, 0);
        count++;
    }

    /**
     * Finds the impulses of the plane. A body at rest that has been torn off is not held again in this solution: what
     * pushes a sliding body may be less than what static friction bears, and bodies that push each other would be let go and
     * held by turns. As long as it does not move all the same, because others before it are held, static friction bears what
     * it can of the load.
     *
     * @param s has the velocities from which directions are taken where they are not 0
     * @param free velocities without impulses
     * @param momenta impulses and moments of impulses of the contacts on each body
     * @return by how much they have changed, relative to themselves; infinite if a body is held or let go
     */
    double find(HeapSystem s, double[] free, double[] momenta) {
        double change = 0;
        isNew = false;
        for (int k = 0; k < count; k++) {
            int at = 3 * places[k];
            double wt = w[2 * k];
            double wr = w[2 * k + 1];
            double speed = norm(s.v[at], s.v[at + 1], s.v[at + 2], wt, wr);
            if (isTorn[k] && !slips[k] && speed > LITTLE * length * plane.deceleration(bodies[k])) {
                slips[k] = true;
                isNew = true;
            }
            double vx = free[at] + wt * momenta[at];
            double vy = free[at + 1] + wt * momenta[at + 1];
            double omega = free[at + 2] + wr * momenta[at + 2];
            boolean held = !isTorn[k]
                    && plane.holds(bodies[k], vx / (length * wt), vy / (length * wt), omega / (length * wr), moves[k]);
            if (isHeld[k] && !held && !moves[k]) {
                isTorn[k] = true;
                isNew = true;
            }
            if (held != isHeld[k]) {
                isHeld[k] = held;
                setMobile(s, places[k], !held, wt, wr);
                change = Double.POSITIVE_INFINITY;
            }
            if (!held) {
                change = Math.max(change, slide(k, s.v, vx, vy, omega));
            }
        }
        return change;
    }

    /** Whether the last impulses were found for a body that was torn off only then, or has only then moved. */
    boolean isNew() {
        return isNew;
    }

    /** Finds the friction of a sliding body from its velocity without it; returns by how much that has changed, relative to itself. */
    private double slide(int k, double[] v, double vx, double vy, double omega) {
        int at = 3 * places[k];
        double wt = w[2 * k];
        double wr = w[2 * k + 1];
        boolean known = norm(v[at], v[at + 1], v[at + 2], wt, wr) > 0; // squares of what rounding leaves may be none
        double dx = known ? v[at] : vx;
        double dy = known ? v[at + 1] : vy;
        double turn = known ? v[at + 2] : omega;
        for (int n = 0; n < REPETITIONS; n++) {
            plane.friction(bodies[k], dx, dy, turn, isTorn[k] && !slips[k], force);
            double nx = vx + length * wt * force[0];
            double ny = vy + length * wt * force[1];
            double spin = omega + length * wr * force[2];
            double size = norm(nx, ny, spin, wt, wr);
            double scale = size / norm(dx, dy, turn, wt, wr);
            if (!(scale > 0 && scale < Double.POSITIVE_INFINITY)) {
                break;
            }
            dx *= scale;
            dy *= scale;
            turn *= scale;
            if (norm(nx - dx, ny - dy, spin - turn, wt, wr) <= RIGHT * size) {
                break;
            }
            double way = Math.sqrt(dx * dx + dy * dy);
            double kt = way == 0 ? 0 : length * wt * Math.sqrt(force[0] * force[0] + force[1] * force[1]) / way;
            double kr = turn == 0 ? 0 : length * wr * Math.abs(force[2] / turn);
            dx = (nx + kt * dx) / (1 + kt);
            dy = (ny + kt * dy) / (1 + kt);
            turn = (spin + kr * turn) / (1 + kr);
        }
        double cx = length * force[0] - impulses[3 * k];
        double cy = length * force[1] - impulses[3 * k + 1];
        double turned = length * force[2] - impulses[3 * k + 2];
        for (int c = 0; c < 3; c++) {
            impulses[3 * k + c] = length * force[c];
        }
        double changed = norm(wt * cx, wt * cy, wr * turned, wt, wr);
        return changed == 0 ? 0 : changed / (length * norm(wt * force[0], wt * force[1], wr * force[2], wt, wr));
    }

    /** Size of a velocity: √(2 T / m). */
    private static double norm(double vx, double vy, double omega, double wt, double wr) {
        return Math.sqrt(vx * vx + vy * vy + omega * omega * (wt / wr));
    }

    /** Gives the system the velocities that the bodies would have with the plane, but without contacts. */
    void apply(HeapSystem s, double[] free) {
        System.arraycopy(free, 0, s.v, 0, 3 * s.bodyCount());
        for (int k = 0; k < count; k++) {
            int at = 3 * places[k];
            s.v[at] = isHeld[k] ? 0 : s.v[at] + w[2 * k] * impulses[3 * k];
            s.v[at + 1] = isHeld[k] ? 0 : s.v[at + 1] + w[2 * k] * impulses[3 * k + 1];
            s.v[at + 2] = isHeld[k] ? 0 : s.v[at + 2] + w[2 * k + 1] * impulses[3 * k + 2];
        }
    }

    /** Holds bodies that friction would give energy, and those that were torn off but did not move; true if there are any. */
    boolean stop(HeapSystem s) {
        boolean any = false;
        for (int k = 0; k < count; k++) {
            int at = 3 * places[k];
            double power = impulses[3 * k] * s.v[at] + impulses[3 * k + 1] * s.v[at + 1] + impulses[3 * k + 2] * s.v[at + 2];
            if (!isHeld[k] && (power > 0 || isTorn[k] && !slips[k])) {
                isHeld[k] = true;
                setMobile(s, places[k], false, w[2 * k], w[2 * k + 1]);
                any = true;
            }
        }
        return any;
    }

    /** Ends a heap: bodies that were held can be moved again. */
    void end(HeapSystem s) {
        for (int k = 0; k < count; k++) {
            if (isHeld[k]) {
                setMobile(s, places[k], true, w[2 * k], w[2 * k + 1]);
            }
        }
    }

    /** Lets a body be moved, or be as good as fixed; given its own inverse mass and moment of inertia. */
    private static void setMobile(HeapSystem s, int place, boolean yes, double inverseMass, double inverseInertia) {
        s.w[2 * place] = yes ? inverseMass : 0;
        s.w[2 * place + 1] = yes ? inverseInertia : 0;
        for (int p = 0; p < s.size(); p++) {
            if (s.rows().isOf(p, place)) {
                int o = HeapSystem.STRIDE * p;
                s.data[o + HeapSystem.MOBILITY_N] = orNone(s.rows().normalMobility(p, s.w));
                s.data[o + HeapSystem.MOBILITY_T] = orNone(s.rows().tangentMobility(p, s.w));
                s.data[o + HeapSystem.CROSS] = s.rows().crossMobility(p, s.w);
            }
        }
    }

    /** A point that nothing moves can be given no impulse. */
    private static double orNone(double mobility) {
        return mobility > 0 ? mobility : Double.POSITIVE_INFINITY;
    }
}
