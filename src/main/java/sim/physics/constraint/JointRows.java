// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.internal.Trig;
import sim.physics.motion.State;

/**
 * The rows of an island's joints other than pins, each kind in a loop of its own: what {@link RodJoint#evaluate} and the like
 * say, with one cosine and sine for all that lies on a body, and without a call for each.
 */
final class JointRows implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values of a rod, a slider and an angle; an arm is in its body's coordinates, or a place where the body cannot move. */
    private static final int ROD = 5;

    private static final int SLIDE = 6;
    private static final int ANGLE = 4;

    /** Values of an end that was evaluated: arm, place, velocity and spin. */
    private static final int END = 7;

    private final Island island;
    private final Turns turns;

    /** Nodes of the rods; both arms and the length of each. */
    private final IntList rods = new IntList();

    private double[] rodValues = {};

    private final List<RodJoint> lengths = new ArrayList<>();

    /** Nodes of the sliders; both arms and the normal of each, in the coordinates of its second body. */
    private final IntList slides = new IntList();

    private double[] slideValues = {};

    /** Rows that keep θ of the first body + ratio · θ of the second = sum: 2 · node + row; ratio, sum and both θ of each. */
    private final IntList angles = new IntList();

    private double[] angleValues = {};

    /** Nodes of motors and stops, and these. */
    private final IntList switches = new IntList();

    private final List<Switched> own = new ArrayList<>();

    private final double[] ends = new double[2 * END];

    JointRows(Island island, Turns turns) {
        this.island = island;
        this.turns = turns;
    }

    /** Takes a constraint over; false if it must be asked itself. */
    boolean take(Constraint constraint, int node) {
        if (constraint instanceof Switched s) {
            boolean yes = s.coordinate() instanceof Joint joint && joint.describe(this, node);
            if (yes) {
                switches.add(node);
                own.add(s);
            }
            return yes;
        }
        return constraint instanceof Joint joint && joint.describe(this, node);
    }

    void addRod(int node, RodJoint rod, Anchor first, Anchor second) {
        rods.add(node);
        lengths.add(rod);
        rodValues = withRoom(rodValues, ROD * rods.size);
        int at = ROD * (rods.size - 1);
        anchor(rodValues, at, island.a[node], first);
        anchor(rodValues, at + 2, island.b[node], second);
        rodValues[at + 4] = rod.getLength();
    }

    /** Takes the lengths of rods that may have been set; returns whether one was. */
    boolean measure() {
        boolean isNew = false;
        for (int k = 0; k < rods.size; k++) {
            double length = lengths.get(k).getLength();
            isNew |= length != rodValues[ROD * k + 4];
            rodValues[ROD * k + 4] = length;
        }
        return isNew;
    }

    void addSlide(int node, Anchor first, Anchor second, double normalX, double normalY) {
        slides.add(node);
        slideValues = withRoom(slideValues, SLIDE * slides.size);
        int at = SLIDE * (slides.size - 1);
        anchor(slideValues, at, island.a[node], first);
        anchor(slideValues, at + 2, island.b[node], second);
        double cos = 1;
        double sin = 0;
        if (island.b[node] >= 0) {
            turns.need(island.b[node]);
        } else if (second.body != null) {
            cos = Trig.cos(second.body.getAngle());
            sin = Trig.sin(second.body.getAngle());
        }
        slideValues[at + 4] = cos * normalX - sin * normalY;
        slideValues[at + 5] = sin * normalX + cos * normalY;
    }

    void addAngle(int node, int row, Joint joint, double ratio, double sum) {
        angles.add(2 * node + row);
        angleValues = withRoom(angleValues, ANGLE * angles.size);
        int at = ANGLE * (angles.size - 1);
        angleValues[at] = ratio;
        angleValues[at + 1] = sum;
        angleValues[at + 2] = joint.getBodyA().getAngle();
        angleValues[at + 3] = joint.getBodyB() == null ? 0 : joint.getBodyB().getAngle();
    }

    private static double[] withRoom(double[] values, int length) {
        return values.length < length ? Arrays.copyOf(values, Growth.length(values.length, length)) : values;
    }

    private void anchor(double[] values, int at, int body, Anchor end) {
        values[at] = end.localX;
        values[at + 1] = end.localY;
        if (body >= 0 && (end.localX != 0 || end.localY != 0)) {
            turns.need(body);
        } else if (body < 0) {
            end.evaluate();
            values[at] = end.x;
            values[at + 1] = end.y;
        }
    }

    /** Evaluates C, J and J̇ ẋ at the positions and velocities of the state vectors. */
    void evaluate(State state) {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0; k < rods.size; k++) {
            evaluateRod(rods.values[k], ROD * k, x, v);
        }
        for (int k = 0; k < slides.size; k++) {
            evaluateSlide(slides.values[k], SLIDE * k, x, v);
        }
        for (int k = 0; k < angles.size; k++) {
            evaluateAngle(angles.values[k], ANGLE * k, x);
        }
        for (int k = 0; k < switches.size; k++) {
            int p = switches.values[k];
            own.get(k).take(island.c, island.rate, island.j, p);
        }
    }

    /** Where an end is, and how it moves. */
    private void find(int at, double ax, double ay, int body, int s, double[] x, double[] v) {
        double[] end = ends;
        if (body < 0) {
            end[at] = 0;
            end[at + 1] = 0;
            end[at + 2] = ax;
            end[at + 3] = ay;
            end[at + 4] = 0;
            end[at + 5] = 0;
            end[at + 6] = 0;
            return;
        }
        double cos = turns.turn[2 * body];
        double sin = turns.turn[2 * body + 1];
        double rx = cos * ax - sin * ay;
        double ry = sin * ax + cos * ay;
        double omega = v[s + State.THETA];
        end[at] = rx;
        end[at + 1] = ry;
        end[at + 2] = x[s] + rx;
        end[at + 3] = x[s + 1] + ry;
        end[at + 4] = v[s] - omega * ry; // (22)
        end[at + 5] = v[s + 1] + omega * rx;
        end[at + 6] = omega;
    }

    private void findBoth(int p, double[] values, int at, double[] x, double[] v) {
        find(0, values[at], values[at + 1], island.a[p], island.blockA[p], x, v);
        find(END, values[at + 2], values[at + 3], island.b[p], island.blockB[p], x, v);
    }

    /** r⊥ · n of an end. */
    private double lever(int at, double nx, double ny) {
        return ends[at] * ny - ends[at + 1] * nx;
    }

    /** −θ̇² r · n of an end. */
    private double centripetal(int at, double nx, double ny) {
        double omega = ends[at + 6];
        return -omega * omega * (ends[at] * nx + ends[at + 1] * ny);
    }

    private void write(int p, double nx, double ny, double turnA, double turnB) {
        double[] j = island.j;
        int o = Island.J * p;
        if (island.a[p] >= 0) {
            j[o] = nx;
            j[o + 1] = ny;
            j[o + 2] = turnA;
        }
        if (island.b[p] >= 0) {
            j[o + 6] = -nx;
            j[o + 7] = -ny;
            j[o + 8] = turnB;
        }
    }

    private void evaluateRod(int p, int at, double[] x, double[] v) {
        findBoth(p, rodValues, at, x, v);
        double dx = ends[2] - ends[END + 2];
        double dy = ends[3] - ends[END + 3];
        double distance = Math.sqrt(dx * dx + dy * dy);
        double nx = distance > 0 ? dx / distance : 1;
        double ny = distance > 0 ? dy / distance : 0;
        double across = (ends[4] - ends[END + 4]) * ny - (ends[5] - ends[END + 5]) * nx;
        double swing = distance > 0 ? across * across / distance : 0;
        island.c[2 * p] = distance - rodValues[at + 4];
        island.rate[2 * p] = centripetal(0, nx, ny) - centripetal(END, nx, ny) + swing;
        write(p, nx, ny, lever(0, nx, ny), -lever(END, nx, ny));
    }

    private void evaluateSlide(int p, int at, double[] x, double[] v) {
        findBoth(p, slideValues, at, x, v);
        double nx = slideValues[at + 4];
        double ny = slideValues[at + 5];
        if (island.b[p] >= 0) {
            double cos = turns.turn[2 * island.b[p]];
            double sin = turns.turn[2 * island.b[p] + 1];
            nx = cos * slideValues[at + 4] - sin * slideValues[at + 5];
            ny = sin * slideValues[at + 4] + cos * slideValues[at + 5];
        }
        double dx = ends[2] - ends[END + 2];
        double dy = ends[3] - ends[END + 3];
        double away = nx * dx + ny * dy;
        double along = nx * dy - ny * dx; // n⊥·d
        double speed = nx * (ends[5] - ends[END + 5]) - ny * (ends[4] - ends[END + 4]); // n⊥·u
        double omega = ends[END + 6];
        double turning = 2 * omega * speed - omega * omega * away;
        island.c[2 * p] = away;
        island.rate[2 * p] = centripetal(0, nx, ny) - centripetal(END, nx, ny) + turning;
        write(p, nx, ny, lever(0, nx, ny), along - lever(END, nx, ny));
    }

    private void evaluateAngle(int slot, int at, double[] x) {
        int p = slot >> 1;
        int o = Island.J * p + 3 * (slot & 1) + State.THETA;
        double a = angleValues[at + 2];
        double b = angleValues[at + 3];
        double ratio = angleValues[at];
        if (island.a[p] >= 0) {
            a = x[island.blockA[p] + State.THETA];
            island.j[o] = 1;
        }
        if (island.b[p] >= 0) {
            b = x[island.blockB[p] + State.THETA];
            island.j[o + 6] = ratio;
        }
        island.c[slot] = a + ratio * b - angleValues[at + 1];
        island.rate[slot] = 0; // feedback has added to it
    }
}
