// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

/**
 * The travel along a rail as a coordinate of motors and stops: C = t·d, where t is the line's direction, which turns with the
 * second body. So it has the equations of the rail itself, {@link Rail}, with t in the place of the normal.
 */
final class Travel extends Joint {
    private static final long serialVersionUID = 1L;

    final Rail rail;
    private final Anchor first;
    private final Anchor second;
    private final double alongX;
    private final double alongY;

    /** The line's direction is that in the coordinates of the second body. */
    Travel(Rail rail, Anchor first, Anchor second, double alongX, double alongY) {
        super(rail.getBodyA(), rail.getBodyB());
        this.rail = rail;
        this.first = first;
        this.second = second;
        this.alongX = alongX;
        this.alongY = alongY;
    }

    @Override
    public int getRows() {
        return 1;
    }

    @Override
    public void evaluate(Equations e) {
        Rail.separate(e, first, second, alongX, alongY);
    }

    @Override
    boolean describe(JointRows rows, int node) {
        rows.addSlide(node, first, second, alongX, alongY);
        return true;
    }
}
