// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;

/**
 * The kinematic bodies of an engine. They are far heavier than all others, and before each step a force is applied to each of them that
 * makes it as fast as its author wants, against the uniform field. All that is true of heavy bodies that are pushed is then true of them.
 */
final class Kinematics implements Serializable {
    private static final long serialVersionUID = 1L;

    /**
     * How many times as heavy as the heaviest other body a kinematic one is made, by events and by time stepping: that keeps books of
     * kinetic energies, which would lose twelve digits beside one that is larger by 2⁴⁰. And by what factor it may differ from that.
     */
    private static final double HEAVY = 0x1p40;

    private static final double HEAVY_IF_STEPPED = 0x1p30;
    private static final double SPAN = 16;

    /**
     * Way in a step, relative to its size, of a body that stands, and how far from its course it may come to a stand; what it bears pushes
     * one that is 2⁴⁰ times as heavy away by 10⁻¹² of what that would fall.
     */
    private static final double STILL = 0x1p-33;

    /** How many times what others could give in a step is given where something is squeezed. */
    private static final double TOO_MUCH = 0x1p12;

    /** Beyond this, forces are no numbers. */
    private static final double HUGE = 0x1p900;

    private final List<KinematicBody> bodies = new ArrayList<>();
    private double mass;
    private double inertia;

    /** Whether there were no other bodies that can move, beside which they would be heavy. */
    private boolean wereNone;

    /** How heavy they are made now. */
    private double heavy;

    /** Number of the last step that has begun. */
    private long last = -1;

    /** Number of bodies when masses were looked at last, and how often these had been written then, plus 1; 0 if that is not known. */
    private int count = -1;

    private transient long writes;

    Kinematics() {
        // none yet
    }

    /** Takes a body in, which may have left since the last step only to come again. */
    void add(KinematicBody body) {
        if (!bodies.contains(body)) {
            bodies.add(body);
        }
        count = -1;
    }

    boolean isEmpty() {
        return bodies.isEmpty();
    }

    boolean areSomeMoving() {
        boolean yes = false;
        for (int k = 0; k < bodies.size(); k++) {
            yes |= !bodies.get(k).isImmobile();
        }
        return yes;
    }

    /** Sets the forces for a step; one that begins again has failed. */
    void push(State state, long number, Generators generators, double h, boolean isStepped) {
        for (int k = bodies.size() - 1; k >= 0; k--) {
            if (bodies.get(k).state() != state) {
                bodies.remove(k); // it has left
            }
        }
        double wanted = isStepped ? HEAVY_IF_STEPPED : HEAVY;
        if (!bodies.isEmpty() && (count != state.bodyCount() || writes != state.writes() + 1 || heavy != wanted)) {
            heavy = wanted;
            weigh(state);
        }
        for (int k = 0; k < bodies.size(); k++) {
            KinematicBody body = bodies.get(k);
            boolean stood = body.isImmobile();
            body.begin(h, STILL * HEAVY / wanted, number == last);
            if (body.isImmobile() != stood && generators.acting(body).length > 0) {
                generators.isCouplingNew |= generators.coupled; // what feels it is integrated together with it only while it moves
            }
            push(body, generators.gravityX, generators.gravityY);
        }
        last = number;
        count = state.bodyCount();
        writes = state.writes() + 1;
    }

    private void push(KinematicBody body, double gravityX, double gravityY) {
        boolean stands = body.isImmobile();
        double ax = stands ? 0 : body.acceleration(State.X) - gravityX;
        double ay = stands ? 0 : body.acceleration(State.Y) - gravityY;
        double turn = stands ? 0 : body.acceleration(State.THETA);
        if (ax != 0 || ay != 0 || turn != 0 || body.isPushed()) {
            body.apply(mass * ax, mass * ay, inertia * turn);
        }
    }

    /**
     * Whether some body has been pushed off its course by far more than all other bodies could push in a step: something that is squeezed
     * between bodies that nothing moves. There are no forces then that could let all go on.
     *
     * @param tau offset of an instant in the step
     * @param areKept whether the ends of driven bodies have been kept, so that the state may be written
     * @param strength of motors
     */
    boolean areSqueezing(State state, Trajectories trajectories, double tau, boolean areKept, double gravity, double strength, double h) {
        double most = 0;
        double speed = 0;
        for (int k = 0; k < bodies.size(); k++) {
            KinematicBody body = bodies.get(k);
            boolean isThere = body.state() == state && body.hasCourse(); // a listener may have removed it
            if (isThere && (areKept || !trajectories.isDriven(body.index()))) {
                trajectories.publish(body.index(), tau, state);
                most = Math.max(most, body.deflection());
                speed = Math.max(speed, body.fastest());
            }
        }
        double given = mass * most;
        return speed > 0 && given > TOO_MUCH * mass / (SPAN * heavy) * speed && given > TOO_MUCH * (strength * h + most(state, speed, gravity, h));
    }

    /** The momentum with which they have been pushed off their courses until a part of the step is over, as the state has their velocities. */
    double pushed(double part) {
        double most = 0;
        for (int k = 0; k < bodies.size(); k++) {
            most = bodies.get(k).hasCourse() ? Math.max(most, bodies.get(k).deflection(part)) : most;
        }
        return mass * most;
    }

    double fastest() {
        double fastest = 0;
        for (int k = 0; k < bodies.size(); k++) {
            fastest = bodies.get(k).hasCourse() ? Math.max(fastest, bodies.get(k).fastest()) : fastest;
        }
        return fastest;
    }

    /** The momentum that all others have, seen from a body as fast as the fastest one, and get from forces in a step. */
    private static double most(State state, double speed, double gravity, double h) {
        double sum = 0;
        double[] v = state.v();
        double[] f = state.f();
        for (int k = 0, b = 0; k < state.size(); k++, b += State.BLOCK) {
            Body body = state.body(k);
            if (body != null && body.isDynamic()) {
                double spin = Math.abs(v[b + State.THETA]) * body.getShape().boundingRadius();
                double force = Math.abs(f[b]) + Math.abs(f[b + 1]) + Math.abs(body.appliedX()) + Math.abs(body.appliedY());
                sum += body.getMass() * (speed + Math.abs(v[b]) + Math.abs(v[b + 1]) + spin + gravity * h) + force * h;
            }
        }
        return sum;
    }

    /** Makes all as heavy as they are to be, among the bodies that there are now; masses are changed as seldom as possible. */
    private void weigh(State state) {
        double heaviest = 0;
        double largest = 0;
        for (int k = 0; k < state.size(); k++) {
            Body body = state.body(k);
            if (body != null && !body.isFixed()) {
                heaviest = body.isDynamic() ? Math.max(heaviest, body.getMass()) : heaviest;
                largest = Math.max(largest, body.getShape().boundingRadius());
            }
        }
        double arm = largest * largest;
        boolean areNone = heaviest == 0;
        heaviest = areNone ? arm : heaviest;
        if (wereNone || !isWithin(mass, heaviest) || !isWithin(inertia, heaviest * arm)) {
            mass = Math.min(HUGE, heavy * powerOfTwo(heaviest));
            inertia = Math.min(HUGE, mass * powerOfTwo(arm));
        }
        wereNone = areNone;
        for (int k = 0; k < bodies.size(); k++) {
            bodies.get(k).become(mass, inertia);
        }
    }

    /** So that what is divided by it again is the same: a field moves no body that stands. */
    private static double powerOfTwo(double value) {
        return Math.scalb(1.0, Math.getExponent(value));
    }

    private boolean isWithin(double now, double other) {
        return now >= Math.min(HUGE, heavy / SPAN * other) && now <= heavy * SPAN * other;
    }
}
