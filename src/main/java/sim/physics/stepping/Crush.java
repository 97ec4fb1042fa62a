// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.TANGENT;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.constraint.TieRows;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.SpringRows;
import sim.physics.motion.State;
import sim.physics.motion.Steering;

/**
 * Bounds what presses on bodies that others crush which their authors move, that is, on what is deep in a ground, and touches another one that goes elsewhere.
 * Nothing gives way there, so that any impulse is as good as another one, and those of a press and of its anvil grow against one another as depth grows, to
 * hundreds of times the momentum of what lies between. Where it gets out, their directions turn, and what they differ by then throws it out.
 *
 * <p>A press has what it takes to bear what forces press on it, by levers and wedges, and to make bodies as fast as it is.
 */
final class Crush implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Depth relative to the smaller body from which on a body is crushed. */
    private static final double DEEP = 0.01;

    private final State state;
    private final Poses poses;

    /** The rows of bodies that no force moves, if one of them is deep and one of a body that its author moves. */
    private final IntList grounds = new IntList();

    /** By group: a body that it touches and no force moves, −1 for none; the fastest other one against it; whether one is deep; the largest impulse. */
    private int[] first = {};

    private double[] fastest = {};
    private boolean[] areDeep = {};
    private double[] most = {};

    Crush(State state, Poses poses) {
        this.state = state;
        this.poses = poses;
    }

    /** Finds the rows of a step in which bodies may be crushed: they are marked. Whether there are any. */
    boolean find(ContactRows rows) {
        grounds.clear();
        boolean isDeep = false;
        for (int k = 0; poses.steered.size > 0 && k < rows.count; k++) {
            if (isOfGround(rows, k)) {
                boolean isSunk = depth(rows, k, ContactRows.GAP) > DEEP;
                rows.pairs[ContactRows.INTS * k + ContactRows.SUNK] = isSunk ? 1 : 0;
                isDeep |= isSunk;
                grounds.add(k);
            }
        }
        if (!isDeep) {
            grounds.clear();
        }
        return isDeep;
    }

    private boolean isOfGround(ContactRows rows, int k) {
        return poses.isGround(rows.first(k)) || poses.isGround(rows.second(k));
    }

    /** How deep a pair is by the gaps of its points, relative to the smaller body. */
    private double depth(ContactRows rows, int k, int gaps) {
        double gap = 0;
        for (int p = rows.begin(k); p < rows.end(k); p += ContactRows.STRIDE) {
            gap = Math.min(gap, rows.points[p + gaps]);
        }
        return -gap / Math.min(poses.hull(rows.first(k)).bounding, poses.hull(rows.second(k)).bounding);
    }

    /** How deep a body is now in one that no force moves, at most, relative to the smaller one. */
    double deepest(ContactRows rows) {
        double deepest = 0;
        for (int k = 0; k < rows.count; k++) {
            boolean areThere = poses.knows(rows.first(k)) && poses.knows(rows.second(k)); // authors may have removed one since
            deepest = areThere && isOfGround(rows, k) ? Math.max(deepest, depth(rows, k, ContactRows.NOW)) : deepest;
        }
        return deepest;
    }

    /**
     * Bounds what presses at the beginning of a substep, before bodies are given it.
     *
     * @param a accelerations by forces
     * @param h substep
     */
    void bound(ContactRows rows, Groups groups, TieRows ties, SpringRows springs, double[] a, double h) {
        if (most.length < groups.count) {
            first = new int[groups.slots.length];
            fastest = new double[groups.slots.length];
            areDeep = new boolean[groups.slots.length];
            most = new double[groups.slots.length];
        }
        Arrays.fill(first, 0, groups.count, -1);
        Arrays.fill(fastest, 0, groups.count, 0);
        Arrays.fill(areDeep, 0, groups.count, false);
        Arrays.fill(most, 0, groups.count, 0);
        boolean any = false;
        for (int n = 0; n < grounds.size; n++) {
            int k = grounds.values[n];
            any |= groups.has(k, rows) && meet(rows, k, slot(rows, k, groups));
        }
        if (any) {
            ties.press(groups.slots, most);
            springs.press(groups.slots, most);
            for (int g = 0; g < groups.count; g++) {
                most[g] = Belts.LEVER * most[g] + load(groups, g, a, h);
            }
            limit(rows, groups);
        }
    }

    private int slot(ContactRows rows, int k, Groups groups) {
        return groups.slots[poses.isGround(rows.first(k)) ? rows.second(k) : rows.first(k)];
    }

    private int ground(ContactRows rows, int k) {
        return poses.isGround(rows.first(k)) ? rows.first(k) : rows.second(k);
    }

    /** Takes note of a ground of a group; whether it is another one than the first. */
    private boolean meet(ContactRows rows, int k, int g) {
        int ground = ground(rows, k);
        areDeep[g] |= rows.pairs[ContactRows.INTS * k + ContactRows.SUNK] != 0;
        if (first[g] < 0) {
            first[g] = ground;
        }
        Body one = state.body(first[g]);
        Body other = state.body(ground);
        boolean isOther = one != other && !Steering.goAsOne(one, other);
        if (isOther) {
            double dx = other.getVelocityX() - one.getVelocityX();
            double dy = other.getVelocityY() - one.getVelocityY();
            double turn = round(one, first[g]) + round(other, ground);
            fastest[g] = Math.max(fastest[g], Math.sqrt(dx * dx + dy * dy) + turn);
        }
        return isOther;
    }

    private double round(Body body, int index) {
        return Math.abs(body.getAngularVelocity()) * poses.hull(index).bounding;
    }

    /** The impulse for which the bodies of a group count. */
    private double load(Groups groups, int g, double[] a, double h) {
        double sum = 0;
        for (int k = groups.begins[g]; fastest[g] > 0 && k < groups.begins[g + 1]; k++) {
            int b = groups.blocks[k];
            if (!groups.areSteered[k]) {
                double round = fastest[g] * fastest[g] / poses.hull(b / State.BLOCK).bounding;
                sum += h * groups.masses[2 * k] * (Belts.LEVER * Math.sqrt(a[b] * a[b] + a[b + 1] * a[b + 1]) + Belts.ROUND * round);
            }
        }
        return sum;
    }

    /** Bounds all of a group that is crushed: what presses from body to body would be the press's again as soon as it was solved. */
    private void limit(ContactRows rows, Groups groups) {
        for (int k = 0; k < rows.count; k++) {
            if (groups.has(k, rows)) {
                int g = groups.of(k, rows);
                double pressed = rows.sum(k, NORMAL);
                if (areDeep[g] && fastest[g] > 0 && pressed > most[g]) {
                    scale(rows, k, most[g] / pressed);
                }
            }
        }
    }

    private static void scale(ContactRows rows, int k, double by) {
        for (int p = rows.begin(k); p < rows.end(k); p += ContactRows.STRIDE) {
            rows.points[p + NORMAL] *= by;
            rows.points[p + TANGENT] *= by;
        }
    }
}
