// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.constraint.TieRows;
import sim.physics.motion.SpringRows;
import sim.physics.motion.State;

/**
 * Keeps the books of kinetic energy, by groups of bodies that joints, stiff springs and contacts connect: what holds bodies together or apart
 * takes energy, or leaves it. Solved once, one after the other, impulses may give some: those of the substep before push into
 * directions that have turned since, and of what was missing and is regained the second solution takes back a part only, the less the lighter
 * a body is between heavy ones and the farther from its centre it is tied. In joints that jam that would grow without bound.
 *
 * <p>The energy of a group that is free of what cannot move is that of its motion about its centre of mass: what its bodies do to one another changes no
 * other, and a part of the energy of its flight would be many times what there is to be spread. Where one of its bodies moves as its author says, all is
 * seen from that one. Of such bodies, which are so heavy that a part of their own energy would be anything, only what they give the others counts.
 */
final class Balance implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int BLOCK = State.BLOCK;

    /** Energy at which a group is too slow to be looked at, in units of what forces give it in a substep when it is at rest. */
    private static final double SLOW = 16;

    /** Part of its energy that a group may have got for nothing before it is made to pay: what swings gains some and loses it again. */
    private static final double PATIENCE = 0.01;

    /** The same of trees of joints that are solved at once: to take what is more off them costs them nothing else. */
    private static final double LITTLE_PATIENCE = 0.001;

    /** Times the energy that it may have from which on a group has been thrown about. */
    private static final double LOST = 4;

    /** What energies may differ by for rounding. */
    private static final double ROUNDING = 1e-12;

    /** The same of what bodies take that their authors move, of which the rest is not counted. */
    private static final double ROUNDED = 1e-15;

    private final State state;
    private final Groups groups;
    private final Grounds grounds;

    /** Where bodies were, and their velocities. */
    private double[] places = {};

    private double[] speeds = {};

    /** By group: twice the energies that were noted, those of now, and what these may be. */
    private double[] before = {};

    private double[] after = {};
    private double[] most = {};

    /** By body: twice the energy that the group that it is the first of has got for nothing. */
    private double[] debt = {};

    private boolean[] marks = {};

    /** By body: the part that it keeps of what it has got, 1 for those of which nothing was taken. */
    private double[] shares = {};

    Balance(State state, Groups groups, Grounds grounds) {
        this.state = state;
        this.groups = groups;
        this.grounds = grounds;
    }

    /** Begins a step, of which the groups are known. */
    void open() {
        int n = state.x().length / BLOCK;
        if (marks.length < n) {
            places = new double[BLOCK * n];
            speeds = new double[BLOCK * n];
            before = new double[n];
            after = new double[n];
            most = new double[n];
            debt = Arrays.copyOf(debt, n);
            marks = new boolean[n];
            shares = new double[n];
            Arrays.fill(shares, 1);
        }
    }

    /** A body is new: what was in its place has no velocity any more, which one that is fixed would have had, and owes nothing. */
    void add(int body) {
        if (body < debt.length) {
            Arrays.fill(speeds, BLOCK * body, BLOCK * body + BLOCK, 0);
            debt[body] = 0;
        }
    }

    /** Nobody owes anything. */
    void forgive() {
        Arrays.fill(debt, 0);
        Arrays.fill(marks, false);
        Arrays.fill(shares, 1);
    }

    /** Notes where the bodies are, and their velocities. */
    void note() {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0; k < groups.bodies; k++) {
            int b = groups.blocks[k];
            places[b] = x[b];
            places[b + 1] = x[b + 1];
            places[b + 2] = x[b + 2];
            speeds[b] = v[b];
            speeds[b + 1] = v[b + 1];
            speeds[b + 2] = v[b + 2];
        }
        for (int k = 0; k < grounds.held.size; k++) {
            int b = BLOCK * grounds.held.values[k];
            System.arraycopy(x, b, places, b, BLOCK);
            System.arraycopy(v, b, speeds, b, BLOCK);
        }
    }

    /**
     * Adds what forces have given since to the noted velocities: it is nobody's for nothing, and what pulls two groups together may not be taken
     * back from one of them only.
     *
     * @param now accelerations of now
     * @param then those that the noted velocities have been given
     * @param part part of the substep for which they differ
     */
    void force(double[] now, double[] then, double part) {
        for (int k = 0; k < groups.bodies; k++) {
            int b = groups.blocks[k];
            speeds[b] += part * (now[b] - then[b]);
            speeds[b + 1] += part * (now[b + 1] - then[b + 1]);
            speeds[b + 2] += part * (now[b + 2] - then[b + 2]);
        }
    }

    /** {@return the places that were noted} */
    double[] places() {
        return places;
    }

    /** {@return the velocities that were noted} */
    double[] speeds() {
        return speeds;
    }

    /** Measures energies: those that were noted, and those of now. */
    private void measure(double[] v) {
        int[] blocks = groups.blocks;
        double[] masses = groups.masses;
        for (int g = 0, k = 0; g < groups.count; g++) {
            double then = 0;
            double now = 0;
            if (groups.areFree[g] || groups.anchors[g] >= 0) {
                measureSeen(v, g);
                k = groups.begins[g + 1];
                continue;
            }
            for (int end = groups.begins[g + 1]; k < end; k++) {
                int b = blocks[k];
                double m = masses[2 * k];
                double i = masses[2 * k + 1];
                then += m * (speeds[b] * speeds[b] + speeds[b + 1] * speeds[b + 1]) + i * speeds[b + 2] * speeds[b + 2];
                now += m * (v[b] * v[b] + v[b + 1] * v[b + 1]) + i * v[b + 2] * v[b + 2];
            }
            before[g] = then;
            after[g] = now;
        }
    }

    private void measureSeen(double[] v, int g) {
        if (groups.anchors[g] < 0) {
            measureFree(v, g);
        } else {
            before[g] = seen(speeds, speeds, g);
            after[g] = borne(v, v, g);
        }
    }

    /** A component of the velocity of the body from which a group is seen; 0 where that is the world. */
    private double ofAnchor(double[] v, int g, int component) {
        return groups.areFree[g] ? v[groups.anchors[g] + component] : 0;
    }

    /** The product of the bodies that forces move, seen from one that its author moves, or from the world where the group touches what is fixed. */
    private double seen(double[] u, double[] v, int g) {
        double ux = ofAnchor(u, g, 0);
        double uy = ofAnchor(u, g, 1);
        double vx = ofAnchor(v, g, 0);
        double vy = ofAnchor(v, g, 1);
        double sum = 0;
        for (int k = groups.begins[g]; k < groups.begins[g + 1]; k++) {
            int b = groups.blocks[k];
            if (!groups.areSteered[k]) {
                sum += groups.masses[2 * k] * ((u[b] - ux) * (v[b] - vx) + (u[b + 1] - uy) * (v[b + 1] - vy));
                sum += groups.masses[2 * k + 1] * u[b + 2] * v[b + 2];
            }
        }
        return sum;
    }

    /** The product of velocities of now or of those that were noted, seen from where these are seen from, and with it what steered bodies have taken. */
    private double borne(double[] u, double[] v, int g) {
        double x = ofAnchor(speeds, g, 0);
        double y = ofAnchor(speeds, g, 1);
        double sum = 0;
        for (int k = groups.begins[g]; k < groups.begins[g + 1]; k++) {
            int b = groups.blocks[k];
            double along = (u[b] - x) * (v[b] - x) + (u[b + 1] - y) * (v[b + 1] - y);
            double turn = u[b + 2] * v[b + 2];
            if (groups.areSteered[k]) {
                along -= (speeds[b] - x) * (speeds[b] - x) + (speeds[b + 1] - y) * (speeds[b + 1] - y);
                turn -= speeds[b + 2] * speeds[b + 2];
            }
            sum += groups.masses[2 * k] * along + groups.masses[2 * k + 1] * turn;
        }
        return sum;
    }

    /** The same of a group that is free, at one go. */
    private void measureFree(double[] v, int g) {
        double then = 0;
        double now = 0;
        double mass = 0;
        double thenX = 0;
        double thenY = 0;
        double nowX = 0;
        double nowY = 0;
        for (int k = groups.begins[g]; k < groups.begins[g + 1]; k++) {
            int b = groups.blocks[k];
            double m = groups.masses[2 * k];
            double i = groups.masses[2 * k + 1];
            double ux = m * speeds[b];
            double uy = m * speeds[b + 1];
            double vx = m * v[b];
            double vy = m * v[b + 1];
            then += ux * speeds[b] + uy * speeds[b + 1] + i * speeds[b + 2] * speeds[b + 2];
            now += vx * v[b] + vy * v[b + 1] + i * v[b + 2] * v[b + 2];
            mass += m;
            thenX += ux;
            thenY += uy;
            nowX += vx;
            nowY += vy;
        }
        before[g] = then - (thenX * thenX + thenY * thenY) / mass;
        after[g] = now - (nowX * nowX + nowY * nowY) / mass;
    }

    /** The product u M v of a group, about the centre of mass of one that is free: twice the energy if the two are the same velocities. */
    private double product(double[] u, double[] v, int g) {
        return groups.anchors[g] >= 0 ? borne(u, v, g) : whole(u, v, g) - (groups.areFree[g] ? ofCentre(u, v, g) : 0);
    }

    /** The product of velocities that others have noted, or of accelerations. */
    private double given(double[] u, double[] v, int g) {
        return groups.anchors[g] >= 0 ? seen(u, v, g) : product(u, v, g);
    }

    /** The part of the product that is of the motion of the centre of mass. */
    private double ofCentre(double[] u, double[] v, int g) {
        int[] blocks = groups.blocks;
        double mass = 0;
        double ux = 0;
        double uy = 0;
        double vx = 0;
        double vy = 0;
        for (int k = groups.begins[g]; k < groups.begins[g + 1]; k++) {
            int b = blocks[k];
            double m = groups.masses[2 * k];
            mass += m;
            ux += m * u[b];
            uy += m * u[b + 1];
            vx += m * v[b];
            vy += m * v[b + 1];
        }
        return (ux * vx + uy * vy) / mass;
    }

    private double whole(double[] u, double[] v, int g) {
        int[] blocks = groups.blocks;
        double[] masses = groups.masses;
        double sum = 0;
        for (int k = groups.begins[g]; k < groups.begins[g + 1]; k++) {
            int b = blocks[k];
            sum += masses[2 * k] * (u[b] * v[b] + u[b + 1] * v[b + 1]) + masses[2 * k + 1] * u[b + 2] * v[b + 2];
        }
        return sum;
    }

    /** Bounds energies by those at the start of a substep, or what forces alone made of them, which is what others have noted. */
    void bound(Balance noted, double[] a, double h) {
        double[] v = noted.speeds;
        for (int g = 0; g < groups.count; g++) {
            most[g] = given(v, v, g) + Math.max(0, h * (h * given(a, a, g) - 2 * given(v, a, g)));
        }
    }

    /** Notes the velocities with which bounces begin: they may keep their energy, and what moving surfaces have given. */
    void begin(ContactRows rows) {
        begin();
        groups.drive(rows, ContactRows.TANGENT, most);
        for (int g = 0; g < groups.count; g++) {
            most[g] = (1 + ROUNDING) * Math.max(most[g], before[g]);
        }
    }

    /** Notes the velocities with which something begins that gives no energy, and marks the groups of which books are kept. */
    void begin() {
        note();
        measure(speeds);
        for (int k = 0; k < groups.bodies; k++) {
            int body = groups.blocks[k] / BLOCK;
            marks[body] = groups.areBooked[groups.slots[body]];
        }
    }

    /**
     * Takes so much of what compression has given off groups that it has thrown about that they have no more energy than they may: over-relaxed turns
     * may end nowhere where much rubs.
     *
     * @return whether there was such a group
     */
    boolean takeBackLost() {
        boolean any = false;
        for (int g = 0; g < groups.count; g++) {
            any |= limit(g, LOST, Math.max(most[g], before[g]));
        }
        return any;
    }

    /**
     * Whether some group has more energy than was noted and than motors, springs and moving surfaces have given it; its bodies are marked
     * then.
     *
     * @param a accelerations by forces
     * @param h substep
     */
    boolean isBroken(TieRows ties, SpringRows springs, ContactRows rows, double[] a, double h) {
        measure(state.v());
        boolean isMore = false;
        for (int g = 0; g < groups.count; g++) {
            int first = groups.firsts[g];
            debt[first] = groups.areBooked[g] ? Math.max(0, debt[first] + after[g] - before[g]) : debt[first];
            isMore |= groups.areBooked[g] && isMore(g, 0);
        }
        return isMore && mark(ties, springs, rows, a, h);
    }

    private boolean isMore(int g, double rounding) {
        return debt[groups.firsts[g]] > (groups.trees.has(g) ? LITTLE_PATIENCE : PATIENCE) * before[g] + rounding;
    }

    private boolean mark(TieRows ties, SpringRows springs, ContactRows rows, double[] a, double h) {
        Arrays.fill(most, 0, groups.count, 0);
        ties.give(groups.slots, most);
        springs.give(groups.slots, most, h);
        groups.drive(rows, ContactRows.TANGENT, most);
        for (int g = 0; g < groups.count; g++) {
            int first = groups.firsts[g];
            if (groups.areBooked[g] && isMore(g, 0)) {
                boolean isSlow = after[g] < SLOW * h * h * pull(a, g);
                debt[first] = isSlow ? 0 : Math.max(0, debt[first] - most[g]);
            }
            most[g] += before[g];
        }
        boolean any = false;
        for (int k = 0; k < groups.bodies; k++) {
            int body = groups.blocks[k] / BLOCK;
            int g = groups.slots[body];
            marks[body] = groups.areBooked[g] && isMore(g, rounding(g)) && after[g] > most[g];
            any |= marks[body];
        }
        return any;
    }

    /** Twice the energy that forces give in a unit of time to a group that is at rest. */
    private double pull(double[] a, int g) {
        return groups.anchors[g] >= 0 ? seen(a, a, g) : whole(a, a, g);
    }

    /** What may be rounding of the energy of a group that is free: that of its flight is no part of it, but is rounded. */
    private double rounding(int g) {
        if (groups.anchors[g] >= 0) {
            return roundingOfSteered(g);
        }
        return groups.areFree[g] ? ROUNDING * whole(speeds, speeds, g) : 0;
    }

    /** The same of what bodies take that their authors move, but for the one from which all is seen; or of all that is seen from one that nothing can move. */
    private double roundingOfSteered(int g) {
        double x = ofAnchor(speeds, g, 0);
        double y = ofAnchor(speeds, g, 1);
        double sum = 0;
        for (int k = groups.begins[g]; k < groups.begins[g + 1]; k++) {
            int b = groups.blocks[k];
            if (groups.areSteered[k] || groups.areHeld[g]) {
                double way = Math.abs(speeds[b] - x) + Math.abs(speeds[b + 1] - y);
                double fast = Math.abs(speeds[b]) + Math.abs(speeds[b + 1]) + Math.abs(x) + Math.abs(y);
                sum += groups.masses[2 * k] * way * fast + groups.masses[2 * k + 1] * speeds[b + 2] * speeds[b + 2];
            }
        }
        return ROUNDED * sum;
    }

    /** The bodies of groups that have too much energy. */
    boolean[] marks() {
        return marks;
    }

    /** Puts the marked bodies where they were, at rest. */
    void takeBack() {
        for (int k = 0; k < groups.bodies; k++) {
            int b = groups.blocks[k];
            if (marks[b / BLOCK]) {
                System.arraycopy(places, b, state.x(), b, BLOCK);
                Arrays.fill(state.v(), b, b + BLOCK, 0);
            }
        }
    }

    /** Gives the marked bodies their velocities back. */
    void bringBack() {
        for (int k = 0; k < groups.bodies; k++) {
            int b = groups.blocks[k];
            if (marks[b / BLOCK]) {
                System.arraycopy(speeds, b, state.v(), b, BLOCK);
            }
        }
    }

    /** Moves the marked bodies on. */
    void move(double h) {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0; k < groups.bodies; k++) {
            int b = groups.blocks[k];
            for (int m = b; marks[b / BLOCK] && m < b + BLOCK; m++) {
                x[m] += h * v[m];
            }
        }
    }

    /**
     * Takes so much of what marked groups, or those of them that are trees, have got off them that they have no more energy than they may, each of
     * their impulses by the same part: that keeps momentum. Says whether there was such a group.
     */
    boolean limit(TreeGroups some) {
        boolean any = false;
        for (int g = 0; g < groups.count; g++) {
            any |= (some == null || some.has(g)) && limit(g, 1, most[g]);
        }
        return any;
    }

    /** Limits what a group has to a bound if it is so many times as much. */
    private boolean limit(int g, double times, double bound) {
        double[] v = state.v();
        double now = product(v, v, g);
        boolean isMore = marks[groups.firsts[g]] && now > times * bound;
        if (isMore) {
            scale(v, g, LimitedChange.part(before[g], product(v, speeds, g), now, bound));
        }
        return isMore;
    }

    /** What each body keeps of what it has got. */
    double[] shares() {
        return shares;
    }

    private void scale(double[] v, int g, double part) {
        for (int k = groups.begins[g]; k < groups.begins[g + 1]; k++) {
            int b = groups.blocks[k];
            shares[b / BLOCK] = part;
            for (int m = b; m < b + BLOCK; m++) {
                v[m] = speeds[m] + part * (v[m] - speeds[m]);
            }
        }
    }

    /** Forgets which groups, or which of those that are trees, were marked, and what was taken; says whether any other body is marked. */
    boolean forget(TreeGroups some) {
        boolean any = false;
        for (int k = 0; k < groups.bodies; k++) {
            int body = groups.blocks[k] / BLOCK;
            if (some == null || some.has(groups.slots[body])) {
                marks[body] = false;
                shares[body] = 1;
            }
            any |= marks[body];
        }
        return any;
    }
}
