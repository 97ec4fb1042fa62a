// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.awt.Graphics2D;
import java.awt.Paint;
import java.util.Objects;
import sim.display.GUIState;
import sim.physics.PhysicsEngine;
import sim.physics.internal.Check;
import sim.physics.motion.Body;
import sim.physics.response.LastingContact;
import sim.portrayal.DrawInfo2D;
import sim.portrayal.Inspector;
import sim.portrayal.LocationWrapper;
import sim.portrayal.SimpleInspector;
import sim.portrayal.SimplePortrayal2D;

/**
 * Draws a lasting contact in a {@link ContactsPortrayal2D}: its point, its normal, and an arrow for the force on the second body,
 * or on the one that can move.
 */
public class ContactPortrayal2D extends SimplePortrayal2D {
    private static final long serialVersionUID = 1L;

    /** Length of the longest arrow, in sizes of a symbol. */
    private static final double LONGEST = 10;

    private final transient Paint paint;
    private final transient Paint forcePaint;
    private double forceScale;

    /** The greatest force that was drawn. */
    private double greatest;

    /**
     * Creates a portrayal.
     *
     * @param paint paint of points and normals
     * @param forcePaint paint of forces; null to draw none
     */
    public ContactPortrayal2D(Paint paint, Paint forcePaint) {
        this.paint = Objects.requireNonNull(paint, "paint");
        this.forcePaint = forcePaint;
    }

    /**
     * Returns how long arrows are.
     *
     * @return length in the world per force; 0 if the greatest force so far is a little longer than its body
     */
    public double getForceScale() {
        return forceScale;
    }

    /**
     * Sets how long arrows are.
     *
     * @param scale length in the world per force; 0 to make the greatest force so far a little longer than its body
     */
    public void setForceScale(double scale) {
        forceScale = Check.notNegative("scale", scale);
    }

    @Override
    public void draw(Object object, Graphics2D graphics, DrawInfo2D info) {
        LastingContact contact = (LastingContact) object;
        symbol(contact).draw(graphics, info, contact.x(), contact.y(), paint);
        if (forcePaint != null) {
            force(contact).draw(graphics, info, contact.x(), contact.y(), forcePaint);
        }
    }

    @Override
    public boolean hitObject(Object object, DrawInfo2D range) {
        LastingContact contact = (LastingContact) object;
        return symbol(contact).isHit(range, contact.x(), contact.y());
    }

    /** A dot, and the normal to both sides. */
    private static Sketch symbol(LastingContact contact) {
        Sketch sketch = new Sketch(Sketch.size(contact.a(), contact.b()));
        double dx = 1.5 * sketch.size * contact.normalX();
        double dy = 1.5 * sketch.size * contact.normalY();
        sketch.disc(contact.x(), contact.y(), 0.6 * sketch.size);
        return sketch.line(contact.x() - dx, contact.y() - dy, contact.x() + dx, contact.y() + dy);
    }

    private Sketch force(LastingContact contact) {
        Sketch sketch = new Sketch(Sketch.size(contact.a(), contact.b()));
        Body body = contact.b().isFixed() ? contact.a() : contact.b();
        double fx = contact.forceX(body);
        double fy = contact.forceY(body);
        double force = Math.sqrt(fx * fx + fy * fy);
        greatest = Math.max(greatest, force);
        double scale = forceScale > 0 ? forceScale : greatest > 0 ? LONGEST * sketch.size / greatest : 0;
        return sketch.arrow(contact.x(), contact.y(), contact.x() + scale * fx, contact.y() + scale * fy);
    }

    /** {@inheritDoc} It shows the bodies and the force as they are at the end of each step. */
    @Override
    public Inspector getInspector(LocationWrapper wrapper, GUIState state) {
        Object field = wrapper == null ? null : wrapper.getFieldPortrayal().getField();
        if (!(field instanceof PhysicsEngine engine)) {
            return super.getInspector(wrapper, state);
        }
        return new SimpleInspector(new InspectedContact(engine, (LastingContact) wrapper.getObject()), state, "Contact");
    }

    @Override
    public String getName(LocationWrapper wrapper) {
        return "Contact";
    }
}
