// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.awt.Graphics2D;
import java.awt.Paint;
import java.util.Objects;
import sim.display.GUIState;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Joint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.internal.Check;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Spring;
import sim.portrayal.DrawInfo2D;
import sim.portrayal.Inspector;
import sim.portrayal.LocationWrapper;
import sim.portrayal.SimpleInspector;
import sim.portrayal.SimplePortrayal2D;
import sim.util.Double2D;

/**
 * Draws a joint, a motor, a stop or a spring in a {@link JointsPortrayal2D}, and finds it under the mouse. Pins are rings, welds
 * squares, rods lines, rails lines with a box that slides, wires their curves, ropes lines that sag, springs zigzags, motors
 * arrows, stops arcs and bars, and gears two rings and a dashed line. Whatever else acts between two bodies is a dashed line.
 *
 * <p>The size of symbols depends on that of their bodies, unless you set it. Sizes are lengths of the world, so symbols grow when
 * one zooms in.
 */
public class LinkPortrayal2D extends SimplePortrayal2D {
    private static final long serialVersionUID = 1L;

    private final transient Paint paint;
    private double size;

    /**
     * Creates a portrayal.
     *
     * @param paint paint of lines and symbols
     */
    public LinkPortrayal2D(Paint paint) {
        this.paint = Objects.requireNonNull(paint, "paint");
    }

    /**
     * Returns the size of symbols.
     *
     * @return radius of a pin's ring, length; 0 if it depends on the bodies
     */
    public double getSize() {
        return size;
    }

    /**
     * Sets the size of symbols.
     *
     * @param size radius of a pin's ring, length; 0 for 0.15 times the root of the bodies' mean area
     */
    public void setSize(double size) {
        this.size = Check.notNegative("size", size);
    }

    @Override
    public void draw(Object object, Graphics2D graphics, DrawInfo2D info) {
        Double2D place = (Double2D) info.location;
        sketch(object, info, place).draw(graphics, info, place.x, place.y, paint);
    }

    @Override
    public boolean hitObject(Object object, DrawInfo2D range) {
        Double2D place = (Double2D) range.location;
        return sketch(object, range, place).isHit(range, place.x, place.y);
    }

    private Sketch sketch(Object object, DrawInfo2D info, Double2D place) {
        Body a;
        Body b;
        if (object instanceof Constraint c) {
            a = c.getBodyA();
            b = c.getBodyB();
        } else {
            Body[] ends = LinkPlaces.ends((ForceGenerator) object);
            a = ends[0];
            b = ends[1];
        }
        LinkSymbols symbols = new LinkSymbols(size > 0 ? size : Sketch.size(a, b), info, place);
        symbols.add(object, a, b);
        return symbols.sketch;
    }

    /** {@inheritDoc} It shows the bodies, force and gap of a constraint, and the length and force of a spring. */
    @Override
    public Inspector getInspector(LocationWrapper wrapper, GUIState state) {
        Object object = wrapper == null ? null : wrapper.getObject();
        Object field = wrapper == null ? null : wrapper.getFieldPortrayal().getField();
        if (object instanceof Spring spring) {
            return new SimpleInspector(new InspectedSpring(spring), state, getName(wrapper));
        }
        if (!(object instanceof Constraint constraint && field instanceof PhysicsEngine engine)) {
            return super.getInspector(wrapper, state);
        }
        return new SimpleInspector(view(engine, constraint), state, getName(wrapper));
    }

    private static Object view(PhysicsEngine engine, Constraint constraint) {
        if (constraint instanceof Joint joint) {
            return new InspectedJoint(engine, joint);
        }
        if (constraint instanceof Motor motor) {
            return new InspectedMotor(engine, motor);
        }
        return constraint instanceof Limit limit
                ? new InspectedLimit(engine, limit)
                : new InspectedConstraint(engine, constraint);
    }

    @Override
    public String getName(LocationWrapper wrapper) {
        Object object = wrapper == null ? null : wrapper.getObject();
        return object == null ? "" : object.getClass().getSimpleName();
    }
}
