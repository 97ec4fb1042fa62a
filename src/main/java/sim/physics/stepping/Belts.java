// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.constraint.TieRows;
import sim.physics.motion.SpringRows;
import sim.physics.motion.State;

/**
 * Bounds the friction of moving surfaces by what they are there for: to make the bodies as fast as they are, and to rub what forces, motors
 * and springs press on them. Where belts wedge a body, Coulomb's law has no forces: what one of them pulls presses on the other, which
 * pulls the more; impulses would grow from substep to substep, and the body go into the walls and out of them at any speed. A friction
 * that is bounded takes energy as any other does, in the eyes of who goes along with the belt.
 */
final class Belts implements Serializable {
    private static final long serialVersionUID = 1L;

    /** How often all that presses in a group may press on a surface, by levers and wedges. */
    static final double LEVER = 16;

    /** How often what bodies would bear may that went round themselves as fast as the surfaces are. */
    static final double ROUND = 4;

    private final State state;
    private final Poses poses;

    /** By group: the speed of the fastest surface that drives it, 0 for none; the impulse that a surface gives at most. */
    private double[] fastest = {};

    private double[] most = {};

    Belts(State state, Poses poses) {
        this.state = state;
        this.poses = poses;
    }

    /**
     * Bounds friction for a substep, which begins, by what presses before it.
     *
     * @param a accelerations by forces
     * @param h substep
     */
    void bound(ContactRows rows, Groups groups, TieRows ties, SpringRows springs, double[] a, double h) {
        if (most.length < groups.count) {
            fastest = new double[groups.slots.length];
            most = new double[groups.slots.length];
        }
        Arrays.fill(most, 0, groups.count, 0);
        Arrays.fill(fastest, 0, groups.count, 0);
        findFastest(rows, groups);
        ties.press(groups.slots, most);
        springs.press(groups.slots, most);
        for (int g = 0; g < groups.count; g++) {
            most[g] *= LEVER;
            for (int k = groups.begins[g]; fastest[g] > 0 && k < groups.begins[g + 1]; k++) {
                most[g] += load(fastest[g], groups.blocks[k], groups.masses[2 * k], groups.masses[2 * k + 1], a, h);
            }
        }
        boundDriven(rows, groups);
    }

    /**
     * Takes note that bodies have met: what strikes presses as much as it takes to stop it, and a surface rubs that.
     *
     * @param before velocities with which they met
     */
    void strike(ContactRows rows, Groups groups, double[] before) {
        for (int g = 0; g < groups.count; g++) {
            for (int k = groups.begins[g]; fastest[g] > 0 && k < groups.begins[g + 1]; k++) {
                double mass = groups.masses[2 * k];
                most[g] += mass * (fastest[g] + length(before, groups.blocks[k], groups.masses[2 * k + 1] / mass));
            }
        }
        boundDriven(rows, groups);
    }

    /** Finds the speed of the fastest surface that drives a group. */
    private void findFastest(ContactRows rows, Groups groups) {
        for (int k = 0; k < rows.count; k++) {
            if (rows.isDriven(k)) {
                int g = groups.of(k, rows);
                fastest[g] = Math.max(fastest[g], Math.abs(rows.normals[ContactRows.PAIR * k + ContactRows.BELT]));
            }
        }
    }

    /** Bounds the friction of pairs that surfaces drive, by group, with what presses in them now. */
    void boundDriven(ContactRows rows, Groups groups) {
        for (int k = 0; k < rows.count; k++) {
            if (rows.isDriven(k)) {
                double asked = rows.normals[ContactRows.PAIR * k + ContactRows.ASKED];
                double pressed = asked * rows.sum(k, ContactRows.NORMAL);
                double bound = most[groups.of(k, rows)];
                rows.normals[ContactRows.PAIR * k + ContactRows.FRICTION] = (pressed > bound ? bound / pressed : 1) * asked;
            }
        }
    }

    /** The impulse for which a body counts that surfaces of some speed drive. */
    private double load(double speed, int b, double mass, double moment, double[] a, double h) {
        double arm = moment / mass;
        double round = speed * (speed + length(state.v(), b, arm)) / poses.hull(b / State.BLOCK).bounding;
        return h * mass * (LEVER * length(a, b, arm) + ROUND * round);
    }

    /** Length of a vector of a body, its turn counted at the radius of gyration. */
    private static double length(double[] u, int b, double arm) {
        return Math.sqrt(u[b] * u[b] + u[b + 1] * u[b + 1] + arm * u[b + 2] * u[b + 2]);
    }
}
