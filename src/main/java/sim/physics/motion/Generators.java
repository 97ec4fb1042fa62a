// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import sim.physics.internal.IntList;

/** The force generators of an engine: uniform fields and surface friction, known in closed form, and all others. */
final class Generators implements Serializable {
    private static final long serialVersionUID = 1L;

    /** No version of ties. */
    private static final long UNKNOWN = -1;

    private final List<ForceGenerator> all = new ArrayList<>();

    /** Sum of the uniform fields. */
    double gravityX;

    double gravityY;

    /** Null if there is none. */
    SurfaceFriction surface;

    /** Whether some generator couples bodies, be they tied together or not. */
    boolean coupled;

    /** The same with an island's bodies taken for one, at a version of the ties. */
    private boolean couplesBeyond;

    private long knownVersion = UNKNOWN;

    /** Whether several threads may ask for the forces on different bodies. */
    boolean concurrent = true;

    /** Those that need the integrator. */
    private ForceGenerator[] driving = {};

    Generators() {
        // none yet
    }

    List<ForceGenerator> copy() {
        return new ArrayList<>(all);
    }

    boolean add(ForceGenerator generator) {
        Objects.requireNonNull(generator, "generator");
        return !all.contains(generator) && all.add(generator) && sortOut();
    }

    boolean remove(ForceGenerator generator) {
        return all.remove(generator) && sortOut();
    }

    private boolean sortOut() {
        gravityX = 0;
        gravityY = 0;
        coupled = false;
        concurrent = true;
        surface = null;
        List<ForceGenerator> others = new ArrayList<>();
        for (ForceGenerator g : all) {
            if (g instanceof Gravity field) {
                gravityX += field.getX();
                gravityY += field.getY();
            } else {
                others.add(g);
                coupled |= g.isCoupled();
                concurrent &= g.isConcurrent() && !g.isCoupled();
                surface = g instanceof SurfaceFriction s ? s : surface;
            }
        }
        driving = others.toArray(new ForceGenerator[0]);
        knownVersion = UNKNOWN;
        return true;
    }

    /** Whether some generator couples bodies that no island of ties has all of, or may come to do so; ties may be null. */
    boolean couplesBeyond(Ties ties, State state) {
        if (ties == null) {
            return coupled;
        }
        if (knownVersion != ties.version()) {
            knownVersion = ties.version();
            couplesBeyond = false;
            for (ForceGenerator g : driving) {
                couplesBeyond |= g.isCoupled() && !isWithin(ties, state, g.getCoupledBodies());
            }
        }
        return couplesBeyond;
    }

    private static boolean isWithin(Ties ties, State state, List<Body> bodies) {
        IntList island = null;
        for (int k = 0; bodies != null && k < bodies.size(); k++) {
            Body body = bodies.get(k);
            if (body.isFixed()) {
                continue;
            }
            if (body.state() != state || !ties.isTied(body.index()) || island != null && ties.island(body.index()) != island) {
                return false;
            }
            island = ties.island(body.index());
        }
        return bodies != null;
    }

    /** The accelerations of uniform fields alone. */
    void fall(IntList bodies, double[] a) {
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            a[b] = gravityX;
            a[b + 1] = gravityY;
            a[b + 2] = 0;
        }
    }

    /** The accelerations of all forces; the force vector takes those of generators, and what was applied. */
    void accelerate(State state, IntList bodies, double t, Forces forces, double[] a) {
        accelerate(state, bodies, t, forces, a, null);
    }

    /** The same without one generator. */
    void accelerate(State state, IntList bodies, double t, Forces forces, double[] a, ForceGenerator without) {
        double[] f = state.f();
        double[] w = state.w().values();
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            Body body = state.body(bodies.values[k]);
            f[b] = body.appliedX();
            f[b + 1] = body.appliedY();
            f[b + 2] = body.appliedTorque();
            addForces(body, t, forces, without);
            a[b] = gravityX + w[b] * f[b]; // (5), (7)
            a[b + 1] = gravityY + w[b + 1] * f[b + 1];
            a[b + 2] = w[b + 2] * f[b + 2]; // (6), (8)
        }
    }

    /** Whether there is any generator that may act. */
    boolean isAny() {
        return driving.length > 0 || gravityX != 0 || gravityY != 0;
    }

    /** Whether there is a generator other than a uniform field. */
    boolean drive() {
        return driving.length > 0;
    }

    /** Whether a generator other than a uniform field acts on a body. */
    boolean drive(Body body) {
        return drivesOtherThan(null, body);
    }

    /** Whether something other than uniform fields and one generator acts on a body. */
    boolean drivesOtherThan(ForceGenerator one, Body body) {
        for (ForceGenerator g : driving) {
            if (g != one && g.actsOn(body)) {
                return true;
            }
        }
        return false;
    }

    /** Whether the forces on the bodies of a group depend on their state alone. */
    boolean areAutonomous(State state, IntList group) {
        for (ForceGenerator g : driving) {
            for (int k = 0; !g.isAutonomous() && k < group.size; k++) {
                if (g.actsOn(state.body(group.values[k]))) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Whether static friction holds a body at rest. */
    boolean holds(Body body) {
        if (surface == null || coupled || body.isPushed() || drivesOtherThan(surface, body)) {
            return false;
        }
        double mass = body.getMass();
        return surface.actsOn(body) && surface.holds(body, mass * gravityX, mass * gravityY, 0);
    }

    /** Adds the forces on a body, but for those of uniform fields. */
    private void addForces(Body body, double time, Forces forces, ForceGenerator without) {
        for (ForceGenerator g : driving) {
            if (g != without && g.actsOn(body)) {
                g.addForce(body, time, forces);
            }
        }
    }

    /** The energy that is stored in generators which act on a body of a group. */
    double storedEnergy(State state, IntList group) {
        double sum = 0;
        for (ForceGenerator g : driving) {
            boolean acts = false;
            for (int k = 0; !acts && k < group.size; k++) {
                acts = g.actsOn(state.body(group.values[k]));
            }
            sum += acts ? g.energy() : 0;
        }
        return sum;
    }

    /** The energy that is stored in all generators. */
    double storedEnergy() {
        double sum = 0;
        for (ForceGenerator g : driving) {
            sum += g.energy();
        }
        return sum;
    }
}
