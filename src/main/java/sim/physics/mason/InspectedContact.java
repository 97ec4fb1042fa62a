// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.util.Objects;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.response.LastingContact;

/** The contact of two bodies as MASON's inspectors see it, as long as it lasts. */
public final class InspectedContact {
    private final PhysicsEngine engine;
    private final LastingContact contact;

    /**
     * Makes the view of a contact.
     *
     * @param engine that it is in
     * @param contact as it is now
     */
    public InspectedContact(PhysicsEngine engine, LastingContact contact) {
        this.engine = Objects.requireNonNull(engine, "engine");
        this.contact = Objects.requireNonNull(contact, "contact");
    }

    private LastingContact now() {
        return ContactsPortrayal2D.now(engine, contact);
    }

    /** {@return one body} */
    public Body getBodyA() {
        return contact.a();
    }

    /** {@return the other body} */
    public Body getBodyB() {
        return contact.b();
    }

    /** {@return whether it lasts still} */
    public boolean isPresent() {
        return now() != null;
    }

    /** {@return force along the normal, 0 if it is over} */
    public double getNormalForce() {
        LastingContact now = now();
        return now == null ? 0 : now.normalForce();
    }

    /** {@return force along the tangent, 0 if it is over} */
    public double getTangentForce() {
        LastingContact now = now();
        return now == null ? 0 : now.tangentForce();
    }
}
