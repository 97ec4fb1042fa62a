// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.List;
import java.util.Objects;
import sim.physics.internal.IntList;
import sim.physics.response.CollisionListener.Decision;

/** What authors say of contacts: the coefficients of pairs, and listeners; the same for impacts and for time stepping. */
public final class ContactLaws implements Serializable {
    private static final long serialVersionUID = 1L;

    private final ContactLoader loader;
    private final Listeners listeners;
    private final LastingContacts lasting;

    ContactLaws(ContactLoader loader, Listeners listeners, LastingContacts lasting) {
        this.loader = loader;
        this.listeners = listeners;
        this.lasting = lasting;
    }

    /**
     * Sets how the coefficients of two bodies make that of a contact.
     *
     * @param restitution rule for the restitution
     * @param friction rule for the friction
     */
    public void setRules(PairRule restitution, PairRule friction) {
        loader.setRules(restitution, friction);
    }

    /**
     * The coefficient of restitution of two bodies.
     *
     * @param a index
     * @param b index
     * @return 0 … 1
     */
    public double restitution(int a, int b) {
        return loader.restitution(a, b);
    }

    /**
     * The coefficient of friction of two bodies.
     *
     * @param a index
     * @param b index
     * @return not negative
     */
    public double friction(int a, int b) {
        return loader.friction(a, b);
    }

    /**
     * How fast the surfaces of two bodies move on one another beside the bodies.
     *
     * @param a index
     * @param b index
     * @return velocity of b's surface relative to a's along the tangent n⊥, n pointing from a to b
     */
    public double belt(int a, int b) {
        return loader.belt(a, b);
    }

    /**
     * Adds one who is told of collisions.
     *
     * @param listener not null
     * @return false if it was added already
     */
    public boolean add(CollisionListener listener) {
        return listeners.add(Objects.requireNonNull(listener, "listener"));
    }

    /**
     * Removes one who is told of collisions.
     *
     * @param listener any
     * @return false if it was not there
     */
    public boolean remove(CollisionListener listener) {
        return listeners.remove(listener);
    }

    /** {@return whether somebody is told of collisions} */
    public boolean areHeard() {
        return !listeners.isEmpty();
    }

    /**
     * Asks what to do about a collision.
     *
     * @param contact where and when
     * @return what the first listener says that does not want a bounce
     */
    public Decision ask(Contact contact) {
        return listeners.ask(contact);
    }

    /**
     * Tells of a collision.
     *
     * @param contact where and when, with the impulse
     */
    public void tell(Contact contact) {
        listeners.tell(contact);
    }

    /** {@return whether somebody is told of contacts that last} */
    public boolean areLastingHeard() {
        return lasting.areHeard();
    }

    /**
     * Tells of the contacts that last at the end of a step.
     *
     * @param pairs their numbers
     * @param contacts what they are; both are not looked at if nobody listens
     */
    public void tellLasting(IntList pairs, List<LastingContact> contacts) {
        lasting.tell(pairs, contacts);
    }
}
