// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import sim.physics.constraint.Constraints;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/**
 * The contacts of columns that stand: of bodies of which each lies on one other, and the lowest one on what nothing moves. Solved one after the other,
 * what the lowest ones bear would need as many turns as the column has bodies, squared: until then it gives way, leans, and falls. So they are solved at
 * once ({@link UnlikeSet}), in the time of a few turns. What presses on a third body is of no column.
 */
final class Columns implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Pairs of a column at least: lower ones stand. And at most: room goes with their square. */
    private static final int FEWEST = 3;

    private static final int MOST = 200;

    /** Speeds at its points at most, relative to what forces give in a step: a heap that falls is of no columns. */
    private static final double STILL = 0.5;

    /** In place of a pair: nothing lies on a body; it is of no column. */
    private static final int TOP = -1;

    private static final int NONE = -2;

    private final State state;
    private final ContactRows rows;

    /** Length of the step. */
    private double step;

    Columns(State state, ContactRows rows) {
        this.state = state;
        this.rows = rows;
    }

    /**
     * Finds the columns of a step.
     *
     * @param step its length
     * @param constraints whose bodies are of none; may be null
     * @param order takes the pairs, column by column from below
     * @param ends takes where each column ends
     */
    void find(double step, Constraints constraints, IntList order, IntList ends) {
        this.step = step;
        for (int k = 0; rows.count >= FEWEST && k < rows.count; k++) {
            int body = lowest(k);
            if (body >= 0 && climb(k, body, constraints, order)) {
                ends.add(order.size);
            }
        }
    }

    /** The body of a pair that lies on what nothing moves, −1 for none. */
    private int lowest(int k) {
        boolean isFirst = isGround(rows.first(k));
        return isFirst == isGround(rows.second(k)) || !lies(k) ? -1 : isFirst ? rows.second(k) : rows.first(k);
    }

    private boolean isGround(int body) {
        return !state.body(body).isDynamic();
    }

    /** Whether the bodies of a pair lie on one another, side on side. */
    private boolean lies(int k) {
        boolean lies = rows.pointCount(k) > 1 && !rows.isStruck(k);
        double most = STILL * step * rows.normals[ContactRows.PAIR * k + ContactRows.WEIGHT];
        for (int p = rows.begin(k); lies && p < rows.end(k); p += ContactRows.STRIDE) {
            lies = Math.abs(rows.points[p + ContactRows.APPROACH]) <= most && Math.abs(rows.slip(k, p, state.v())) <= most;
        }
        return lies;
    }

    /** Lists the pairs from one on up, if they are a column; whether they are. */
    private boolean climb(int k, int lowest, Constraints constraints, IntList order) {
        int begin = order.size;
        order.add(k);
        int body = lowest;
        int next = above(k, body, constraints);
        while (next >= 0 && lies(next)) {
            order.add(next);
            body = rows.first(next) == body ? rows.second(next) : rows.first(next);
            next = above(next, body, constraints);
        }
        boolean isColumn = next == TOP && order.size - begin >= FEWEST && order.size - begin <= MOST;
        order.size = isColumn ? order.size : begin;
        return isColumn;
    }

    /** The other pair of a body, {@link #TOP} if it has none; {@link #NONE} if it is of no column. */
    private int above(int k, int body, Constraints constraints) {
        if (isGround(body) || constraints != null && constraints.isTied(body)) {
            return NONE;
        }
        int other = TOP;
        for (int row = rows.byBody.first(body); row >= 0; row = rows.byBody.next(row, body)) {
            if (row != k && !rows.isNew(row)) {
                other = other == TOP ? row : NONE;
            }
        }
        return other;
    }
}
