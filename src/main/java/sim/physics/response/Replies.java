// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.motion.State;
import sim.physics.motion.Ties;

/**
 * What a unit of impulse at a point does to the velocities of all bodies of an impact, through their joints: the columns
 * of M Jᵀ, where M is W without what the joints forbid.
 */
final class Replies implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Mobility that is none but for rounding, relative to that of the bodies without ties. */
    private static final double IMMOBILE = 1e-12;

    private int bodies;
    private int[] body = {};
    private State state;
    private Ties ties;
    private double[][] changes = {};
    private double[] velocities = {};

    Replies() {
        // grows with the impacts
    }

    void begin(int count, int[] indices, State vectors, Ties joints) {
        bodies = count;
        body = indices;
        state = vectors;
        ties = joints;
        if (velocities.length < state.x().length) {
            velocities = new double[state.x().length];
        }
    }

    /** Finds the reply to a unit of a point's normal or tangential impulse, n or t on B and its opposite on A. */
    void find(int point, int a, int b, Impact c, boolean tangential) {
        if (changes.length <= point) {
            changes = Arrays.copyOf(changes, 2 * point + 4);
        }
        if (changes[point] == null || changes[point].length < 3 * bodies) {
            changes[point] = new double[3 * bodies];
        }
        Arrays.fill(changes[point], 0);
        double px = tangential ? -c.ny : c.nx;
        double py = tangential ? c.nx : c.ny;
        add(changes[point], a, -px, -py, tangential ? -c.armA : -c.leverA);
        add(changes[point], b, px, py, tangential ? c.armB : c.leverB);
    }

    private void add(double[] sum, int index, double px, double py, double turn) {
        double[] w = state.w().values();
        int s = State.BLOCK * index;
        if (w[s] == 0) {
            return;
        }
        boolean isTied = ties.isTied(index);
        if (isTied) {
            ties.reply(index, px, py, turn, velocities);
        }
        for (int k = 0; k < bodies; k++) {
            int o = State.BLOCK * body[k];
            if (isTied && ties.isTied(body[k]) && ties.island(body[k]) == ties.island(index)) {
                sum[3 * k] += velocities[o];
                sum[3 * k + 1] += velocities[o + 1];
                sum[3 * k + 2] += velocities[o + 2];
            } else if (body[k] == index) {
                sum[3 * k] += w[s] * px;
                sum[3 * k + 1] += w[s] * py;
                sum[3 * k + 2] += w[s + 2] * turn;
            }
        }
    }

    double get(int point, int place, int component) {
        return changes[point][3 * place + component];
    }

    /** What a point's reply adds to the normal velocity at an impact's point; places of its bodies, −1 for fixed. */
    double normal(int a, int b, Impact c, int point) {
        return part(b, c.nx, c.ny, c.leverB, point) - part(a, c.nx, c.ny, c.leverA, point);
    }

    double tangent(int a, int b, Impact c, int point) {
        return part(b, -c.ny, c.nx, c.armB, point) - part(a, -c.ny, c.nx, c.armA, point);
    }

    /** The mobility of a point along its normal, 0 if ties hold it there and it can be given no impulse. */
    double normalMobility(int a, int b, Impact c, int point) {
        return orNone(normal(a, b, c, point), c.normalMobility());
    }

    /** The same along its tangent. */
    double tangentMobility(int a, int b, Impact c, int point) {
        return orNone(tangent(a, b, c, point), c.tangentMobility());
    }

    private static double orNone(double mobility, double alone) {
        return mobility > IMMOBILE * alone ? mobility : 0;
    }

    private double part(int place, double x, double y, double lever, int point) {
        if (place < 0) {
            return 0;
        }
        double[] d = changes[point];
        return x * d[3 * place] + y * d[3 * place + 1] + lever * d[3 * place + 2];
    }

    /** Adds an impulse's reply to the velocities. */
    void apply(int point, double impulse, double[][] velocity) {
        for (int k = 0; k < bodies; k++) {
            for (int component = 0; component < 3; component++) {
                velocity[k][component] += impulse * changes[point][3 * k + component];
            }
        }
    }
}
