// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.Trig;
import sim.physics.shape.Shape;

/**
 * Coulomb friction of a flat rigid body that presses on a plane with uniform pressure. Each element resists its own
 * velocity, so sliding and spinning are coupled (Farkas, Bartels, Unger and Wolf, <i>Frictional coupling between
 * sliding and spinning motion</i>, 2003): for a normal force N and the coefficient μ
 *
 * <pre>
 *   F = −μN ⟨v/|v|⟩,   τ = −μN ⟨r × v/|v|⟩,   v(r) = v + ω × r,   ⟨·⟩ the mean over the area
 * </pre>
 *
 * <p>The loads that static friction can hold form the limit surface (Goyal, Ruina and Papadopoulos, <i>Planar sliding
 * with dry friction</i>, 1991). It is convex, and its support function is the power that friction takes,
 * D(v, ω) = ⟨|v(r)|⟩.
 *
 * <p>Patches are immutable: bodies and threads may share one.
 */
abstract class SurfacePatch implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Between these the squares of velocities neither overflow nor underflow. */
    private static final double SLOW = 0x1p-300;

    private static final double FAST = 0x1p300;

    /** The length that subclasses measure in. */
    private final double unit;

    SurfacePatch(double unit) {
        this.unit = unit;
    }

    static SurfacePatch of(Shape shape) {
        if (shape.partCount() > 1) {
            return new CompoundPatch(shape);
        }
        return shape.vertexCount() == 1 ? new DiscPatch(shape.radius()) : new PolygonPatch(shape);
    }

    /**
     * Force and torque for μN = 1, in world coordinates; zero for a body exactly at rest.
     *
     * @param out takes force x, force y and torque
     */
    final void friction(double vx, double vy, double omega, double theta, double[] out) {
        out[0] = 0;
        out[1] = 0;
        out[2] = 0;
        if (vx == 0 && vy == 0 && omega == 0) {
            return;
        }
        double spin = unit * omega;
        double largest = Math.max(Math.max(Math.abs(vx), Math.abs(vy)), Math.abs(spin));
        if (largest > SLOW && largest < FAST) {
            rub(vx, vy, spin, theta, out);
        } else {
            int linear = Math.max(Math.getExponent(vx), Math.getExponent(vy));
            int power = -Math.max(linear, Math.getExponent(omega) + Math.getExponent(unit));
            rub(Math.scalb(vx, power), Math.scalb(vy, power), unit * Math.scalb(omega, power), theta, out);
        }
        out[2] *= unit;
    }

    /**
     * Whether static friction holds a body at rest: its load lies within the limit surface, that is, no motion gains
     * more power from the load than friction takes from it.
     *
     * @param limit the largest friction force, μs N
     */
    final boolean holds(double fx, double fy, double torque, double theta, double limit) {
        if (limit == 0) {
            return fx == 0 && fy == 0 && torque == 0;
        }
        double x = fx / limit;
        double y = fy / limit;
        if (!(Math.sqrt(x * x + y * y) <= 1)) {
            return false;
        }
        if (torque == 0) {
            return true; // ⟨|v(r)|⟩ ≥ |⟨v(r)⟩| = |v|
        }
        double cos = Trig.cos(theta);
        double sin = Trig.sin(theta);
        return carries(cos * x + sin * y, cos * y - sin * x, torque / limit / unit);
    }

    /** The torque against a body that spins in place, for μN = 1: the most that there is. */
    final double arm() {
        return unit * mostTorque();
    }

    /** The same for lengths in units. */
    abstract double mostTorque();

    /**
     * Adds friction for lengths in units, to an array of zeros.
     *
     * @param spin angular velocity times the unit, not all of them 0
     */
    abstract void rub(double vx, double vy, double spin, double theta, double[] out);

    /** Whether a load in the body's own frame, in units of μs N and the length unit, with |f| ≤ 1, is held. */
    abstract boolean carries(double fx, double fy, double torque);
}
