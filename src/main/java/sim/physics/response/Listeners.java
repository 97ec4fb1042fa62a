// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import sim.physics.collision.CollisionFilter;
import sim.physics.internal.Length;
import sim.physics.motion.Glance;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/** Asks those who are told of collisions, and tells them. */
final class Listeners implements Serializable {
    private static final long serialVersionUID = 3L;

    private final State state;
    private final Trajectories trajectories;
    /** Made anew when it changes after it was used, as one of them may do that who is being told. */
    private List<CollisionListener> all = new ArrayList<>();

    private boolean isUsed;

    /** All of them; null until somebody is added or removed. */
    private transient Set<CollisionListener> known;

    /** The second point of a pair. */
    private final Impact next = new Impact();

    /** Simulated time of the present instant. */
    private double now;

    /** Where bodies are then. */
    private final Glance glance;

    Listeners(State state, Trajectories trajectories) {
        this.state = state;
        this.trajectories = trajectories;
        glance = new Glance(trajectories);
    }

    /** Adds one, who is told from the next collision on; false if it was added already. */
    boolean add(CollisionListener listener) {
        if (!known().add(listener)) {
            return false;
        }
        return own().add(listener);
    }

    /** Removes one, who is told no more from the next collision on; false if it was not there. */
    boolean remove(CollisionListener listener) {
        if (!known().remove(listener)) {
            return false;
        }
        own().remove(LastingContacts.find(all, listener));
        return true;
    }

    private Set<CollisionListener> known() {
        if (known == null) {
            known = Collections.newSetFromMap(new IdentityHashMap<>());
            known.addAll(all);
        }
        return known;
    }

    private List<CollisionListener> own() {
        if (isUsed) {
            all = new ArrayList<>(all);
            isUsed = false;
        }
        return all;
    }

    private List<CollisionListener> use() {
        isUsed = true;
        return all;
    }

    boolean isEmpty() {
        return all.isEmpty();
    }

    void setInstant(double tau, double time) {
        glance.setNow(tau);
        now = time;
    }

    /**
     * Asks what to do about an impact, which is sticky then if one of them wants it.
     *
     * @return null if there is none any more: one of the two was put elsewhere at this instant, or the filter keeps them from one another now
     */
    CollisionListener.Decision ask(int a, int b, Impact impact, CollisionFilter filter) {
        if (isPut(a) || isPut(b)) {
            return null; // by what listeners have done about another pair
        }
        publishUnwritten(a);
        publishUnwritten(b);
        Contact contact = contact(a, b, impact, -impact.normalVelocity(), 0);
        CollisionListener.Decision decision = askNow(contact);
        if (decision == CollisionListener.Decision.STICK) {
            impact.sticky = true;
            state.touched().stick();
        }
        boolean isOver = isPut(a) || isPut(b) || !filter.allows(contact.a(), contact.b());
        return isOver && decision != CollisionListener.Decision.IGNORE ? null : decision;
    }

    /** Whether a body that was written at this instant is elsewhere than it was. */
    private boolean isPut(int body) {
        return state.isTouched(body) && !trajectories.isAt(body, trajectories.offset(body), state, 0);
    }

    /** Lets a body that was written at this instant go on with the velocity that it has been given; false if it was not. */
    boolean takeOver(int body) {
        boolean isWritten = state.isTouched(body);
        if (isWritten) {
            int at = body * Trajectories.STRIDE + Trajectories.VX;
            System.arraycopy(state.v(), State.BLOCK * body, trajectories.data(), at, State.BLOCK);
        }
        return isWritten;
    }

    private CollisionListener.Decision askNow(Contact contact) {
        state.setGlance(glance);
        try {
            return ask(contact);
        } finally {
            state.setGlance(null);
        }
    }

    /** The first decision for something else than a bounce. */
    CollisionListener.Decision ask(Contact contact) {
        List<CollisionListener> those = use();
        for (int k = 0; k < those.size(); k++) {
            CollisionListener.Decision decision = those.get(k).colliding(contact);
            if (decision == null) {
                throw new NullPointerException("decision is null: listener " + those.get(k) + " must say what to do about " + contact);
            }
            if (decision == CollisionListener.Decision.IGNORE || decision == CollisionListener.Decision.STICK) {
                return decision;
            }
        }
        return CollisionListener.Decision.BOUNCE;
    }

    /** Tells of each pair of a simultaneous impact once, with the impulses of its points together. */
    void tell(SimultaneousImpact simultaneous, Impact impact) {
        for (int k = 0; k < simultaneous.bodyCount(); k++) { // all first: what a listener of one pair writes is not to be lost with the next one
            publish(simultaneous.body(k));
        }
        for (int k = 0; k < simultaneous.pointCount(); k++) {
            int a = simultaneous.bodyA(k);
            int b = simultaneous.bodyB(k);
            simultaneous.get(k, impact);
            double approach = simultaneous.approach(k);
            if (takesIn(simultaneous, k + 1, a, b, impact)) {
                k++;
            }
            tellNow(a, b, impact, approach);
        }
    }

    /** Adds the impulses of a next point to those of one, if it is of the same bodies and acts along the same normal: parts of compounds have others. */
    private boolean takesIn(SimultaneousImpact simultaneous, int k, int a, int b, Impact impact) {
        if (k == simultaneous.pointCount() || simultaneous.bodyA(k) != a || simultaneous.bodyB(k) != b) {
            return false;
        }
        simultaneous.get(k, next);
        boolean isSame = next.nx == impact.nx && next.ny == impact.ny;
        impact.jn += isSame ? next.jn : 0;
        impact.jt += isSame ? next.jt : 0;
        return isSame;
    }

    /** Tells of an impact, with the speed before it. */
    void tell(int a, int b, Impact impact, double approach) {
        publish(a);
        publish(b);
        tellNow(a, b, impact, approach);
    }

    private void tellNow(int a, int b, Impact impact, double approach) {
        Contact contact = contact(a, b, impact, approach, Length.of(impact.jn, impact.jt));
        state.setGlance(glance);
        try {
            tell(contact);
        } finally {
            state.setGlance(null);
        }
    }

    void tell(Contact contact) {
        List<CollisionListener> those = use();
        for (int k = 0; k < those.size(); k++) {
            those.get(k).collided(contact);
        }
    }

    private void publishUnwritten(int body) {
        if (!state.isTouched(body)) { // else it would undo what listeners have done about another pair
            publish(body);
        }
    }

    private void publish(int body) {
        trajectories.publish(body, trajectories.offset(body), state);
    }

    private Contact contact(int a, int b, Impact impact, double speed, double impulse) {
        int o = a * Trajectories.STRIDE;
        double x = trajectories.data()[o] + impact.rAx;
        double y = trajectories.data()[o + 1] + impact.rAy;
        return new Contact(state.body(a), state.body(b), now, x, y, impact.nx, impact.ny, speed, impulse);
    }
}
