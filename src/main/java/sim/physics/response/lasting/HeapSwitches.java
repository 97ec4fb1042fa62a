// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.SwitchedRow;
import sim.physics.motion.SwitchedTies;

/**
 * The motors and stops of bodies in a heap. What a wheel gets from the ground and what its motor gives depend on each
 * other, and both are bounded: they are solved for together, and then push evenly for the time of the solution, as contacts
 * do. So no motor yields or reaches its speed within that time, and nothing has to be searched for.
 */
final class HeapSwitches implements Serializable {
    private static final long serialVersionUID = 1L;

    /** A stop is looked at if it may be reached by this turn, rad, or part of its size, or at this many times its speed. */
    private static final double NEAR = 0.05;

    private static final double TIMES = 3;

    private final HeapBodies by;
    private final HeapSystem system;
    private final SwitchedRow row = new SwitchedRow();
    private final PointRows end = new PointRows();

    /** By point behind the contacts: its number in its island, and which way it is read. */
    private final IntList number = new IntList();

    private final IntList sign = new IntList();

    /** By island: the number of points up to its last one. */
    private final IntList ends = new IntList();

    /** By point again: its first impulse; of motors the greatest one. */
    private double[] first = {};

    private double[] greatest = {};

    /** The same: the speed at which a stop that is struck now is left; else −∞. */
    private double[] rebounds = {};

    /** By the first body of an island: how its motors and stops were set when it came to rest. */
    private long[] settings = {};

    HeapSwitches(HeapBodies by, HeapSystem system) {
        this.by = by;
        this.system = system;
    }

    void clear() {
        number.clear();
        sign.clear();
        ends.clear();
    }

    /**
     * Takes in the motors and stops of an island that is prepared for its replies, at the velocities of the system.
     *
     * @param fall speed that forces give to bodies in the time
     */
    void gather(SwitchedTies switched, Regain regain, double fall) {
        double length = regain.time();
        double sway = 0;
        for (int k = 0; k < switched.size(); k++) {
            switched.read(k, row);
            sway += row.isMotor ? Math.sqrt(mobility()) * row.limit * length : 0;
        }
        for (int k = 0; k < switched.size(); k++) {
            switched.read(k, row);
            if (row.isMotor) {
                add(k, 1, row.speed, length);
            } else {
                double speed = Math.sqrt(mobility()) * (sway + fall * Math.sqrt(lighterMass()));
                stop(k, 1, row.aboveLower, regain, speed);
                stop(k, -1, row.belowUpper, regain, speed);
            }
        }
        ends.add(number.size);
    }

    /** What a unit along the coordinate at hand does to its speed if nothing else ties its bodies: ties make that less. */
    private double mobility() {
        double first = row.firstX * row.firstX + row.firstY * row.firstY;
        double second = row.nx * row.nx + row.ny * row.ny;
        return mobility(place(row.first), first, row.firstLever) + mobility(place(row.second), second, row.secondLever);
    }

    private double mobility(int place, double square, double lever) {
        return place < 0 ? 0 : square * system.w[2 * place] + lever * lever * system.w[2 * place + 1];
    }

    private double lighterMass() {
        int a = place(row.first);
        int b = place(row.second);
        return 1 / Math.max(a < 0 ? 0 : system.w[2 * a], b < 0 ? 0 : system.w[2 * b]);
    }

    /** Takes in a stop that may be reached; given what forces may change its coordinate's speed by. */
    private void stop(int k, int way, double gap, Regain regain, double speed) {
        if (gap == Double.POSITIVE_INFINITY) {
            return;
        }
        double length = regain.time();
        add(k, way, HeapGaps.leastSpeed(gap, regain), length);
        int p = system.size() - 1;
        double approach = -system.normal(p);
        if (gap > NEAR * row.size && gap > (TIMES * approach + speed) * length) {
            system.removeLast();
            number.size--;
            sign.size--;
        } else if (approach * length > Math.max(0, gap) && row.restitution * approach > speed) { // or it is back in no time
            rebounds[number.size - 1] = row.restitution * approach;
        }
    }

    private void add(int k, int way, double bound, double length) {
        int at = number.size;
        number.add(k);
        sign.add(way);
        if (first.length <= at) {
            first = Arrays.copyOf(first, 2 * at + 2);
            greatest = Arrays.copyOf(greatest, 2 * at + 2);
            rebounds = Arrays.copyOf(rebounds, 2 * at + 2);
        }
        first[at] = way * length * row.force;
        greatest[at] = row.isMotor ? length * row.limit : Double.POSITIVE_INFINITY;
        rebounds[at] = Double.NEGATIVE_INFINITY;
        system.add(place(row.first), place(row.second), row, way, 0, row.isMotor ? 0 : Double.POSITIVE_INFINITY);
        system.bound(system.size() - 1, bound);
    }

    /**
     * The greatest speed that a point gives to a body of the heap if it is a motor, by all that it has, but at most a part of what its own
     * speed lacks; 0 if it is none.
     */
    double reach(int p, IntList heap, BodyScale scales, double part) {
        double limit = greatest[p - system.contacts()];
        double mobility = system.normalMobility(p);
        if (!(limit < Double.POSITIVE_INFINITY && mobility < Double.POSITIVE_INFINITY)) {
            return 0;
        }
        double[] v = system.scratch();
        Arrays.fill(v, 0, 3 * heap.size, 0);
        system.push(p, Math.min(limit, part * Math.abs(system.bound(p) - system.normal(p)) / mobility), 0, v);
        return scales.fastest(heap, v);
    }

    /** Takes note of how the motors and stops of an island are set, whose first body is given. */
    void keep(SwitchedTies switched, int first) {
        settings = first < settings.length ? settings : Arrays.copyOf(settings, 2 * first + 1);
        settings[first] = settings(switched);
    }

    /** Whether they are set as they were then. */
    boolean areKept(SwitchedTies switched, int first) {
        return first < settings.length && settings[first] == settings(switched);
    }

    /** A number that tells how they are set. */
    private long settings(SwitchedTies switched) {
        long sum = switched.size();
        for (int k = 0; k < switched.size(); k++) {
            switched.read(k, row);
            sum = 31 * sum + Double.doubleToLongBits(row.speed);
            sum = 31 * sum + Double.doubleToLongBits(row.limit);
            sum = 31 * sum + Double.doubleToLongBits(row.aboveLower);
            sum = 31 * sum + Double.doubleToLongBits(row.belowUpper);
        }
        return sum;
    }

    /** Lets a point take the replies of the one before it, if that is of the same coordinate of two tied bodies; false if it is not. */
    boolean shares(int p) {
        double sign = p > system.contacts() ? system.rows().alike(p, p - 1) : 0;
        return sign != 0 && system.replies().share(p, p - 1, sign < 0);
    }

    /** Adds what tells each point from others. */
    void name(IntList names) {
        for (int k = 0; k < number.size; k++) {
            names.add(-1 - 2 * number.values[k] - (sign.values[k] < 0 ? 1 : 0));
        }
    }

    private int place(int body) {
        return body < 0 ? -1 : by.place[body] - 1;
    }

    /** By point behind the contacts: the speed at which what strikes it now is to leave it. */
    double[] rebounds() {
        return rebounds;
    }

    /** Lets no coordinate go beyond a speed along the way that it has where an integration has brought its bodies, given their velocities there. */
    void turn(SwitchedTies switched, int island, double[] v) {
        for (int at = begin(island); at < ends.values[island]; at++) {
            int p = system.contacts() + at;
            if (!system.rows().isOfTurns(p)) {
                switched.readNow(number.values[at], row);
                end.set(0, place(row.first), place(row.second), row, sign.values[at]);
                system.turn(p, end.normal(0, v) - system.rows().normal(p, v), 0);
            }
        }
    }

    private int begin(int island) {
        return island == 0 ? 0 : ends.values[island - 1];
    }

    /** Starts from the last forces; from now on motors may act. */
    void start() {
        for (int k = 0; k < number.size; k++) {
            int p = system.contacts() + k;
            if (greatest[k] < Double.POSITIVE_INFINITY) {
                system.setMost(p, greatest[k]);
            }
            system.start(p, first[k], 0);
        }
    }

    /**
     * Lets the motors and stops of an island push as has been found, evenly over a time.
     *
     * @param island its number in the order in which islands were taken in
     */
    void freeze(SwitchedTies switched, int island, double length) {
        int at = begin(island);
        for (int k = 0; k < switched.size(); k++) {
            double impulse = 0;
            while (at < ends.values[island] && number.values[at] == k) {
                impulse += sign.values[at] * system.normalImpulse(system.contacts() + at);
                at++;
            }
            switched.freeze(k, impulse / length);
        }
    }
}
