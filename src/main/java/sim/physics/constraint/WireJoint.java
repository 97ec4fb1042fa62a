// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.Objects;
import sim.physics.motion.Body;

/**
 * A bead on a wire: a point of a body stays on a curve, (25)–(33).
 *
 * <pre>
 *   C = f(p)   (25)        Ċ = ∇f·ṗ   (26)        C″ = ∇f·p″ + ṗᵀ H ṗ   (27), (28)
 * </pre>
 *
 * <p>In the write-up, the force of the wire acts at right angles to the bead's <i>velocity</i>, (30) and (31), and λ is found by
 * dividing by ẋ + ẏ, (33). That is singular when the bead is at rest. Here the force acts along ∇f, at right angles to the wire,
 * which is the same direction whenever the bead moves. It is (40), and (29) and (32) are (41).
 */
public final class WireJoint extends Joint {
    private static final long serialVersionUID = 1L;

    private final Anchor bead;
    private final Curve wire;
    private final double[] f = new double[6];

    /**
     * Threads the centre of a body on a wire.
     *
     * @param bead the body that moves along the wire
     * @param wire the wire, in the world
     */
    public WireJoint(Body bead, Curve wire) {
        this(bead, 0, 0, wire);
    }

    /**
     * Threads a point of a body on a wire.
     *
     * @param bead the body that moves along the wire
     * @param ax x of the point, in the coordinates of the body
     * @param ay y of the point, in the coordinates of the body
     * @param wire the wire, in the world
     */
    public WireJoint(Body bead, double ax, double ay, Curve wire) {
        super(bead, null);
        this.bead = Anchor.local(bead, "a", ax, ay);
        this.wire = Objects.requireNonNull(wire, "wire");
    }

    /**
     * Returns the x coordinate of the point that stays on the wire, in the coordinates of the body.
     *
     * @return x, length
     */
    public double getAnchorAX() {
        return bead.localX;
    }

    /**
     * Returns the y coordinate of the point that stays on the wire, in the coordinates of the body.
     *
     * @return y, length
     */
    public double getAnchorAY() {
        return bead.localY;
    }

    /**
     * Returns the wire.
     *
     * @return a curve in the world
     */
    public Curve getWire() {
        return wire;
    }

    boolean hasOwnWire() {
        return wire instanceof Line || wire instanceof Ring;
    }

    /** The radius of curvature where the bead is, or less. */
    @Override
    double bend() {
        bead.evaluate();
        wire.evaluate(bead.x, bead.y, f);
        double bends = Math.abs(f[3]) + 2 * Math.abs(f[4]) + Math.abs(f[5]);
        return bends > 0 ? Math.sqrt(f[1] * f[1] + f[2] * f[2]) / bends : super.bend();
    }

    @Override
    public int getRows() {
        return 1;
    }

    @Override
    public void evaluate(Equations e) {
        bead.evaluate();
        wire.evaluate(bead.x, bead.y, f);
        double vx = bead.vx;
        double vy = bead.vy;
        double bend = f[3] * vx * vx + 2 * f[4] * vx * vy + f[5] * vy * vy;
        e.set(0, f[0], bend + bead.centripetal(f[1], f[2]));
        e.setA(0, f[1], f[2], bead.lever(f[1], f[2]));
    }
}
