// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.Arrays;
import sim.physics.motion.Body;
import sim.physics.motion.Link;

/** What a constraint must be before it is added. */
final class Admissible {
    /** Gap of a new constraint, relative to the sizes of its bodies, up to which it counts as closed. */
    static final double CLOSED = 1e-6;

    /** What may be left of its rate, as a part of those of which this is the difference. */
    private static final double SLIP = 1e-3;

    private Admissible() {}

    static void check(Constraint constraint, boolean closed) {
        Body b = constraint.getBodyB();
        if (constraint.getBodyA() == b) {
            throw new IllegalArgumentException("constraint is " + constraint + ": it needs two different bodies, but both are " + b);
        }
        if (!constraint.getBodyA().isDynamic() && (b == null || !b.isDynamic())) {
            throw new IllegalArgumentException("constraint is " + constraint + ": none of its bodies can move, "
                    + "but one of them must");
        }
        int rows = constraint.getRows();
        if (rows < 1 || rows > Equations.ROWS) {
            throw new IllegalArgumentException("rows are " + rows + ": a constraint has 1 to " + Equations.ROWS);
        }
        Equations equations = new Equations();
        evaluate(constraint, equations);
        for (int row = 0; row < rows; row++) {
            double gap = Math.abs(equations.c[row]);
            double size = constraint.isAngle(row) ? 1 : constraint.getSize();
            if (!(gap <= (closed ? CLOSED * size : Double.MAX_VALUE))) {
                throw new IllegalArgumentException("constraint is " + constraint + ": it is open by "
                        + equations.c[row] + " in row " + row + places(constraint) + "; assemble() would close it");
            }
            double mobility = mobility(equations.jA, row, constraint.getBodyA()) + (b == null ? 0 : mobility(equations.jB, row, b));
            if (closed ? !(mobility < Double.POSITIVE_INFINITY) : Double.isNaN(mobility)) {
                throw new IllegalArgumentException("constraint is " + constraint + ": its row " + row + " of J is "
                        + Arrays.toString(Arrays.copyOfRange(equations.jA, 3 * row, 3 * row + 3)) + ", "
                        + Arrays.toString(Arrays.copyOfRange(equations.jB, 3 * row, 3 * row + 3))
                        + ": all of it must be finite, with its squares over the masses");
            }
        }
    }

    /** Whether a constraint is closed, and its bodies move as it lets them. What switches lets them do anything. */
    static boolean holds(Constraint constraint) {
        boolean yes = true;
        if (!(constraint instanceof Switched)) {
            Equations equations = new Equations();
            constraint.evaluate(equations);
            for (int row = 0; row < constraint.getRows(); row++) {
                double[] a = rate(equations.jA, row, constraint.getBodyA());
                double[] b = rate(equations.jB, row, constraint.getBodyB());
                yes &= Math.abs(equations.c[row]) <= CLOSED * (constraint.isAngle(row) ? 1 : constraint.getSize());
                yes &= Math.abs(a[0] + b[0]) <= SLIP * (a[1] + b[1]);
            }
        }
        return yes;
    }

    /** What a body adds to J ẋ, and that with all terms positive. */
    private static double[] rate(double[] j, int row, Body body) {
        if (body == null) {
            return new double[2];
        }
        double x = j[3 * row] * body.getVelocityX();
        double y = j[3 * row + 1] * body.getVelocityY();
        double theta = j[3 * row + 2] * body.getAngularVelocity();
        return new double[] {x + y + theta, Math.abs(x) + Math.abs(y) + Math.abs(theta)};
    }

    /** What a body adds to J W Jᵀ; no finite number if J has none. */
    private static double mobility(double[] j, int row, Body body) {
        double x = j[3 * row];
        double y = j[3 * row + 1];
        double theta = j[3 * row + 2];
        double isFinite = 0 * x + 0 * y + 0 * theta;
        return body.isImmobile() ? isFinite : isFinite + (x * x + y * y) / body.getMass() + theta * theta / body.getInertia();
    }

    /** Evaluates a constraint; motors and stops that acted when they were removed do not act yet. */
    private static void evaluate(Constraint constraint, Equations equations) {
        Switched row = constraint instanceof Switched s ? s : null;
        boolean was = row != null && row.isOnNow;
        if (was) {
            row.isOnNow = false;
        }
        constraint.evaluate(equations);
        if (was) {
            row.isOnNow = true;
        }
    }

    /** Where the points of a joint are: whoever gave points of the world that are taken as the bodies' sees it. */
    private static String places(Constraint constraint) {
        if (!(constraint instanceof Joint && constraint instanceof Link link)) {
            return "";
        }
        Anchor first = Anchor.local(link.getBodyA(), "a", link.getAnchorAX(), link.getAnchorAY());
        Anchor second = Anchor.local(link.getBodyB(), "b", link.getAnchorBX(), link.getAnchorBY());
        first.evaluate();
        second.evaluate();
        return ", its points are at (" + first.x + ", " + first.y + ") and (" + second.x + ", " + second.y + ") in the world";
    }
}
