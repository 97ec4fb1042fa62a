// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import sim.physics.internal.CoulombImpulse;
import sim.physics.response.lasting.ContactPoint;

/**
 * One point at which two bodies collide: what (16)–(24) start from, and the impulse that they give. The object is
 * filled again for each impact.
 *
 * <p>Indices A and B are the write-up's: n points from A to B, the impulse R acts on A and −R on B.
 */
public final class Impact implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Difference at which points are one, of normals, and of levers and velocities by their sizes. */
    private static final double SAME = 1e-12;

    /** Inverse masses. */
    double wA;

    double wB;

    /** Inverse moments of inertia. */
    double iA;

    double iB;

    /** Velocities before the impact, and after {@link #apply()} afterwards. */
    double vAx;

    double vAy;
    double omegaA;
    double vBx;
    double vBy;
    double omegaB;

    /** From each body's centre to the collision point. */
    double rAx;

    double rAy;
    double rBx;
    double rBy;

    /** r⊥ · n, the levers of a normal impulse in (24): zero for a circle. */
    double leverA;

    double leverB;

    /** r · n, the levers of a tangential impulse. */
    double armA;

    double armB;

    /** Unit normal from A to B. */
    double nx;

    double ny;

    /** Coefficient of restitution and of friction. */
    double restitution;

    double friction;

    /** Velocity of B's surface relative to A's along the tangent, beside that of the bodies. */
    double belt;

    /** Energy that the impact may add; 0 but for bounces that are kept from getting too short. */
    double allowance;

    /** Whether the surfaces stick: no sliding of the collision points afterwards; the restitution is 0 then, too. */
    boolean sticky;

    /** Whether it is one of a pair's first impacts in the step. */
    boolean isEarly;

    /** Finds the impulse of a point that rubs. */
    final CoulombImpulse law = new CoulombImpulse();

    /** The impulse on B along the normal and along the tangent n⊥, mass·length/time; R = −(jn n + jt n⊥) acts on A. */
    double jn;

    double jt;

    Impact() {
        // filled again for each impact
    }

    /**
     * Velocity of B's collision point relative to A's along the normal, (16) with (22); negative: approaching. By the
     * levers and not by the points, so that a circle's spin has no part in it even by rounding.
     */
    double normalVelocity() {
        return (vBx - vAx) * nx + (vBy - vAy) * ny + (omegaB * leverB - omegaA * leverA);
    }

    /** The same of the surfaces along the tangent t = n⊥. */
    double tangentVelocity() {
        return slip() + belt;
    }

    /** That of the bodies' points along the tangent. */
    private double slip() {
        return (vBy - vAy) * nx - (vBx - vAx) * ny + (omegaB * armB - omegaA * armA);
    }

    /** 1/mA + 1/mB + (rA⊥·n)²/IA + (rB⊥·n)²/IB: what a unit of normal impulse changes of the normal velocity. */
    double normalMobility() {
        return (wA + wB) + (iA * leverA * leverA + iB * leverB * leverB);
    }

    /** The same along the tangent, with arms for levers. */
    double tangentMobility() {
        return (wA + wB) + (iA * armA * armA + iB * armB * armB);
    }

    /** Sets the levers from the points; {@code roundA}, {@code roundB}: the body is a circle. */
    void setLevers(boolean roundA, boolean roundB) {
        leverA = roundA ? 0 : rAx * ny - rAy * nx;
        leverB = roundB ? 0 : rBx * ny - rBy * nx;
        armA = rAx * nx + rAy * ny;
        armB = rBx * nx + rBy * ny;
    }

    /** Kinetic energy that the impulse adds, beside what moving surfaces give: its work at the mean of the velocities before and after. */
    double energyGain() {
        double tA = jn * leverA + jt * armA;
        double tB = jn * leverB + jt * armB;
        double square = (wA + wB) * (jn * jn + jt * jt) + (iA * tA * tA + iB * tB * tB);
        return jn * normalVelocity() + jt * tangentVelocity() + 0.5 * square;
    }

    /** Velocities after the impulse: (18), (19) and (24). */
    void apply() {
        double rx = jn * nx - jt * ny; // −R, the impulse on B
        double ry = jn * ny + jt * nx;
        vAx -= wA * rx;
        vAy -= wA * ry;
        omegaA -= iA * (jn * leverA + jt * armA);
        vBx += wB * rx;
        vBy += wB * ry;
        omegaB += iB * (jn * leverB + jt * armB);
    }

    /** What the normal impulse changes of a velocity: component 0, 1 of the centre's, 2 of the angular one. */
    double change(boolean ofA, int component) {
        if (component == 2) {
            return ofA ? -iA * (jn * leverA) : iB * (jn * leverB);
        }
        double r = jn * (component == 0 ? nx : ny);
        return ofA ? -wA * r : wB * r;
    }

    void setVelocities(double[] a, double[] b) {
        vAx = a == null ? 0 : a[0];
        vAy = a == null ? 0 : a[1];
        omegaA = a == null ? 0 : a[2];
        vBx = b == null ? 0 : b[0];
        vBy = b == null ? 0 : b[1];
        omegaB = b == null ? 0 : b[2];
    }

    void getVelocities(double[] a, double[] b) {
        if (a != null) {
            a[0] = vAx;
            a[1] = vAy;
            a[2] = omegaA;
        }
        if (b != null) {
            b[0] = vBx;
            b[1] = vBy;
            b[2] = omegaB;
        }
    }

    /** Says what a contact that lasts needs to know of the point. */
    void describe(ContactPoint point) {
        point.nx = nx;
        point.ny = ny;
        point.leverA = leverA;
        point.leverB = leverB;
        point.armA = armA;
        point.armB = armB;
        point.normalMobility = normalMobility();
        point.tangentMobility = tangentMobility();
        point.friction = friction;
        point.omegaA = omegaA;
        point.omegaB = omegaB;
        point.opening = normalVelocity();
        point.slip = slip();
        point.belt = belt;
    }

    /**
     * Lets a part of the approach not bounce: what bodies of heaps have got for the time that is left would else be given
     * back to them as a bounce.
     */
    void exclude(double toCome) {
        double approach = -normalVelocity();
        if (toCome > 0 && approach > 0) {
            restitution *= Math.max(0, 1 - toCome / approach);
        }
    }

    /** Whether another impact is at the same point of the same movable bodies, with the same law; one of those may be first in one, second in the other. */
    boolean isSame(Impact that) {
        double side = (wA == 0) == (that.wA == 0) ? 1 : -1;
        boolean turned = side < 0;
        double reach = SAME * (Math.abs(leverA) + Math.abs(armA) + Math.abs(leverB) + Math.abs(armB));
        double speed = SAME * (Math.abs(normalVelocity()) + Math.abs(tangentVelocity()));
        return Math.abs(nx - side * that.nx) <= SAME
                && Math.abs(ny - side * that.ny) <= SAME
                && (wA == 0 || areNear(leverA, armA, side * (turned ? that.leverB : that.leverA), side * (turned ? that.armB : that.armA), reach))
                && (wB == 0 || areNear(leverB, armB, side * (turned ? that.leverA : that.leverB), side * (turned ? that.armA : that.armB), reach))
                && areNear(normalVelocity(), tangentVelocity(), that.normalVelocity(), that.tangentVelocity(), speed)
                && restitution == that.restitution
                && friction == that.friction
                && allowance == that.allowance
                && sticky == that.sticky;
    }

    private static boolean areNear(double x, double y, double x2, double y2, double within) {
        return Math.abs(x - x2) <= within && Math.abs(y - y2) <= within;
    }

    void copy(Impact from) {
        wA = from.wA;
        wB = from.wB;
        iA = from.iA;
        iB = from.iB;
        vAx = from.vAx;
        vAy = from.vAy;
        omegaA = from.omegaA;
        vBx = from.vBx;
        vBy = from.vBy;
        omegaB = from.omegaB;
        rAx = from.rAx;
        rAy = from.rAy;
        rBx = from.rBx;
        rBy = from.rBy;
        leverA = from.leverA;
        leverB = from.leverB;
        armA = from.armA;
        armB = from.armB;
        nx = from.nx;
        ny = from.ny;
        restitution = from.restitution;
        friction = from.friction;
        belt = from.belt;
        allowance = from.allowance;
        sticky = from.sticky;
        isEarly = from.isEarly;
        jn = from.jn;
        jt = from.jt;
    }
}
