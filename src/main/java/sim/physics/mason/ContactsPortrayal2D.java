// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.awt.Color;
import java.util.Objects;
import sim.physics.PhysicsEngine;
import sim.physics.response.LastingContact;
import sim.portrayal.Portrayal;
import sim.util.Double2D;

/**
 * A layer of a display that shows the contacts which last at the end of a step, as {@link PhysicsEngine#contacts()} lists them:
 * where bodies rest or lie on one another, the normal there, and the force. Bodies that bounce have none. Use it like
 * {@link JointsPortrayal2D}. A click on a contact inspects it.
 */
public class ContactsPortrayal2D extends EnginePortrayal2D {
    private final ContactPortrayal2D portrayal;

    /**
     * Creates a layer that draws points and normals in red, and forces in magenta.
     *
     * @param width width of the field that shows the bodies
     * @param height height of that field
     */
    public ContactsPortrayal2D(double width, double height) {
        this(width, height, new ContactPortrayal2D(new Color(200, 0, 0), Color.MAGENTA));
    }

    /**
     * Creates a layer.
     *
     * @param width width of the field that shows the bodies
     * @param height height of that field
     * @param portrayal the portrayal that draws the contacts
     */
    public ContactsPortrayal2D(double width, double height, ContactPortrayal2D portrayal) {
        super(width, height);
        this.portrayal = Objects.requireNonNull(portrayal, "portrayal");
    }

    @Override
    public Portrayal getDefaultPortrayal() {
        return portrayal;
    }

    @Override
    void forAll(PhysicsEngine engine, Visitor visitor) {
        for (LastingContact contact : engine.contacts()) {
            visitor.visit(contact, contact.x(), contact.y());
        }
    }

    @Override
    Double2D locate(Object object) {
        LastingContact now = engine() == null ? null : now(engine(), (LastingContact) object);
        return now == null ? null : new Double2D(now.x(), now.y());
    }

    /** The contact of the same bodies at the end of the last step; null if there is none. */
    static LastingContact now(PhysicsEngine engine, LastingContact before) {
        if (engine.contains(before.a()) && engine.contains(before.b())) {
            for (LastingContact contact : engine.contacts(before.a())) {
                if (contact.a() == before.b() || contact.b() == before.b()) {
                    return contact;
                }
            }
        }
        return null;
    }
}
