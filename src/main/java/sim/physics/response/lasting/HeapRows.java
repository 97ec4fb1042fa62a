// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;

/** The rows of a {@link HeapSystem}, normal ones and tangential ones, and the matrix of what they do to one another. */
abstract class HeapRows implements Serializable {
    private static final long serialVersionUID = 1L;

    /**
     * Rows for which this is worth it. A path over n rows takes some n³ operations; but sweeps, which are left beyond, find no solution of
     * that many: stops and friction contradict one another through the ties, and bodies sink in.
     */
    private static final int MOST = 600;

    /** Room for more rows than there are, as a part of them: matrices have its square. */
    private static final double MORE = 0.25;

    /** Multiplications in the time in which a row's reply to a point is found. */
    private static final int ASSEMBLED = 8;

    private boolean isAssembled;

    /** Number of rows, and of each point's normal and tangential one, or −1. */
    int rows;

    private final HeapNumbers numbers = new HeapNumbers();
    int[] normal = {};
    private int[] tangent = {};

    /** By rows: the normal row of a tangential one, or −1; and its friction. */
    int[] bearer = {};

    double[] friction = {};

    /** The motor that acts along the coordinate of a stop, or −1. */
    int[] against = {};

    /** What a unit at a row does to all, row after row. */
    double[] replies = {};

    /** What a unit at a row would do there if nothing tied its bodies. */
    private double[] alone = {};

    /** By rows: bounds of velocities and of impulses, impulses, velocities; and the best impulses so far. */
    double[] bound = {};

    double[] least = {};
    double[] most = {};
    double[] impulse = {};
    double[] velocity = {};
    double[] best = {};

    /** The velocities without impulses. */
    double[] without = {};

    /** What has been done for the rows, in multiplications. */
    private long done;

    /** Takes note of some multiplications, or what takes as long. */
    void count(long multiplications) {
        done += multiplications;
    }

    /** How many there were since this was asked last. */
    long takeDone() {
        long taken = done;
        done = 0;
        return taken;
    }

    /** Takes note that what rows do has changed. */
    void forget() {
        isAssembled = false;
    }

    /** Whether a system has no more points than there may be rows. */
    static boolean fits(HeapSystem s) {
        return s.size() <= MOST;
    }

    /** Assembles the rows of a system; false if they are too many. */
    boolean assemble(HeapSystem s) {
        if (isAssembled || !fits(s) || number(s) > MOST) {
            return isAssembled;
        }
        double[] v = s.scratch();
        done += (long) ASSEMBLED * rows * s.size();
        for (int p = 0; p < s.size(); p++) {
            if (normal[p] >= 0) {
                Arrays.fill(v, 0);
                s.push(p, 1, 0, v);
                column(s, v, normal[p]);
            }
            if (tangent[p] >= 0) {
                Arrays.fill(v, 0);
                s.push(p, 0, 1, v);
                column(s, v, tangent[p]);
            }
        }
        numbers.pair(s, replies, against);
        measureAlone(s);
        isAssembled = true;
        return true;
    }

    private void measureAlone(HeapSystem s) {
        PointRows r = s.rows();
        for (int p = 0; p < s.size(); p++) {
            if (normal[p] >= 0) {
                alone[normal[p]] = r.wholeMobility(p, s.w);
            }
            if (tangent[p] >= 0) {
                alone[tangent[p]] = r.tangentMobility(p, s.w);
            }
        }
    }

    /** Makes room for the work on some rows. */
    abstract void grow(int n);

    private int number(HeapSystem s) {
        rows = numbers.number(s);
        normal = numbers.normal;
        tangent = numbers.tangent;
        if (bearer.length < rows) {
            int n = (int) ((1 + MORE) * rows) + 1;
            bearer = new int[n];
            friction = new double[n];
            against = new int[n];
            bound = new double[n];
            least = new double[n];
            most = new double[n];
            impulse = new double[n];
            velocity = new double[n];
            best = new double[n];
            without = new double[n];
            replies = new double[n * n];
            alone = new double[n];
            grow(n);
        }
        for (int p = 0; p < s.size(); p++) {
            if (normal[p] >= 0) {
                bearer[normal[p]] = -1;
            }
            if (tangent[p] >= 0) {
                bearer[tangent[p]] = normal[p];
                friction[tangent[p]] = s.friction(p);
            }
        }
        return rows;
    }

    private void column(HeapSystem s, double[] v, int column) {
        for (int q = 0; q < s.size(); q++) {
            if (normal[q] >= 0) {
                replies[column * rows + normal[q]] = s.normal(q, v);
            }
            if (tangent[q] >= 0) {
                replies[column * rows + tangent[q]] = s.tangent(q, v);
            }
        }
    }

    /** Takes the problem over: velocities without impulses, and impulses to start from. */
    void take(HeapSystem s) {
        for (int p = 0; p < s.size(); p++) {
            if (normal[p] >= 0) {
                int i = normal[p];
                bound[i] = s.bound(p);
                least[i] = s.leastImpulse(p);
                most[i] = s.mostImpulse(p);
                impulse[i] = Math.max(least[i], Math.min(most[i], s.normalImpulse(p)));
                velocity[i] = s.normal(p);
            }
            if (tangent[p] >= 0) {
                int i = tangent[p];
                bound[i] = 0;
                impulse[i] = s.tangentImpulse(p);
                velocity[i] = s.tangent(p);
            }
        }
        System.arraycopy(velocity, 0, without, 0, rows);
        System.arraycopy(impulse, 0, best, 0, rows); // if there are none that are better, as where velocities are no numbers
        evaluate();
    }

    /** Velocities by the impulses. */
    void evaluate() {
        System.arraycopy(without, 0, velocity, 0, rows);
        for (int i = 0; i < rows; i++) {
            push(i, impulse[i]);
        }
    }

    /** Adds what a change of a row's impulse does. */
    void push(int column, double change) {
        double[] v = velocity;
        double[] unit = replies;
        done += change != 0 ? rows : 1;
        for (int k = 0, o = column * rows; change != 0 && k < rows; k++) {
            v[k] += change * unit[o + k];
        }
    }

    /** What a unit at a row does there. */
    double own(int row) {
        return replies[row * rows + row];
    }

    /** The same if nothing tied its bodies: more than that, as ties only hold. */
    double alone(int row) {
        return alone[row];
    }

    /** Bounds of a row's impulse. */
    double lower(int row) {
        return bearer[row] < 0 ? least[row] : -friction[row] * impulse[bearer[row]];
    }

    double upper(int row) {
        return bearer[row] < 0 ? most[row] : friction[row] * impulse[bearer[row]];
    }

    /** Gives the best impulses to the system. */
    void give(HeapSystem s) {
        for (int p = 0; p < s.size(); p++) {
            double jn = normal[p] < 0 ? 0 : best[normal[p]];
            double jt = tangent[p] < 0 ? 0 : best[tangent[p]];
            s.start(p, jn, jt);
            s.apply(p, jn, jt);
        }
    }
}
