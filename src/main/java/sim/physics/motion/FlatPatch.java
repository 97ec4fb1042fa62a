// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

/** A patch whose limit surface is known by the friction of motions alone: any but that of a disc. */
abstract class FlatPatch extends SurfacePatch {
    private static final long serialVersionUID = 1L;

    /** ⟨v/|v|⟩ and ⟨r × v/|v|⟩ of the body that spins in place: the most torque that the patch takes. */
    private final double[] spinning = new double[State.BLOCK];

    FlatPatch(double unit) {
        super(unit);
    }

    @Override
    final double mostTorque() {
        return spinning[2];
    }

    /** To be called when the patch is made. */
    final void spin() {
        slip(0, 0, 1, spinning);
    }

    /** Takes ⟨v/|v|⟩ and ⟨r × v/|v|⟩ in the body's own frame to out. */
    abstract void slip(double ux, double uy, double spin, double[] out);

    @Override
    boolean carries(double fx, double fy, double torque) {
        double share = torque / spinning[2];
        if (!(Math.abs(share) <= 1)) {
            return false;
        }
        double gx = fx - share * spinning[0];
        double gy = fy - share * spinning[1];
        if (Math.sqrt(gx * gx + gy * gy) <= 1 - Math.abs(share)) {
            return true; // in the double cone between sliding and spinning, which the limit surface encloses
        }
        return new WorstTwist(this, spinning[2]).holds(fx, fy, torque);
    }
}
