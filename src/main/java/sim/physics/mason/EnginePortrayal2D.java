// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.awt.Graphics2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import sim.display.GUIState;
import sim.physics.PhysicsEngine;
import sim.physics.internal.Check;
import sim.portrayal.DrawInfo2D;
import sim.portrayal.FieldPortrayal2D;
import sim.portrayal.LocationWrapper;
import sim.portrayal.SimplePortrayal2D;
import sim.util.Bag;
import sim.util.Double2D;

/**
 * A layer of a display over a {@code ContinuousPortrayal2D}. Its field is a {@link PhysicsEngine}, and it covers the same part of
 * the world as the bodies' field. It reads the engine when it is drawn, and keeps nothing in it.
 */
public abstract class EnginePortrayal2D extends FieldPortrayal2D {
    private final double width;
    private final double height;

    EnginePortrayal2D(double width, double height) {
        this.width = Check.positive("width", width);
        this.height = Check.positive("height", height);
    }

    /**
     * Sets the engine whose parts are drawn. Call this when a model starts and when one is loaded.
     *
     * @param engine a {@link PhysicsEngine}, or null for nothing
     * @throws IllegalArgumentException if it is anything else
     */
    @Override
    public void setField(Object engine) {
        if (engine != null && !(engine instanceof PhysicsEngine)) {
            throw new IllegalArgumentException("field is " + engine + ": it must be a PhysicsEngine");
        }
        super.setField(engine);
    }

    /** The engine, or null. */
    PhysicsEngine engine() {
        return (PhysicsEngine) getField();
    }

    /**
     * Returns the width of the world that is shown.
     *
     * @return length
     */
    public double getWidth() {
        return width;
    }

    /**
     * Returns the height of the world that is shown.
     *
     * @return length
     */
    public double getHeight() {
        return height;
    }

    /** Has all visited that is to be drawn. */
    abstract void forAll(PhysicsEngine engine, Visitor visitor);

    /** Takes an object and where it is. */
    @FunctionalInterface
    interface Visitor {
        void visit(Object object, double x, double y);
    }

    /** Where an object is now; null if it is there no more. */
    abstract Double2D locate(Object object);

    @Override
    protected void hitOrDraw(Graphics2D graphics, DrawInfo2D info, Bag putInHere) {
        if (engine() == null) {
            return;
        }
        Double2D scale = getScale(info);
        forAll(engine(), (object, x, y) -> {
            Rectangle2D.Double draw = new Rectangle2D.Double(info.draw.x + x * scale.x, info.draw.y + y * scale.y, scale.x, scale.y);
            DrawInfo2D here = new DrawInfo2D(info.gui, this, draw, info.clip);
            here.precise = info.precise;
            here.location = new Double2D(x, y);
            SimplePortrayal2D portrayal = (SimplePortrayal2D) getPortrayalForObject(object);
            if (graphics != null) {
                portrayal.draw(object, graphics, here);
            } else if (portrayal.hitObject(object, here)) {
                putInHere.add(wrapper(object));
            }
        });
    }

    private LocationWrapper wrapper(Object object) {
        return new LocationWrapper(object, null, this) {
            @Override
            public Object getLocation() {
                return locate(object);
            }

            @Override
            public String getLocationName() {
                Double2D now = locate(object);
                return now == null ? "gone" : now.toCoordinates();
            }
        };
    }

    @Override
    public Double2D getScale(DrawInfo2D info) {
        return new Double2D(info.draw.width / width, info.draw.height / height);
    }

    @Override
    public Object getPositionLocation(Point2D.Double position, DrawInfo2D info) {
        Double2D scale = getScale(info);
        return new Double2D((position.x - info.draw.x) / scale.x, (position.y - info.draw.y) / scale.y);
    }

    @Override
    public Object getObjectLocation(Object object, GUIState gui) {
        return locate(object);
    }

    @Override
    public Point2D.Double getLocationPosition(Object location, DrawInfo2D info) {
        Double2D scale = getScale(info);
        Double2D place = (Double2D) location;
        return place == null ? null : new Point2D.Double(info.draw.x + place.x * scale.x, info.draw.y + place.y * scale.y);
    }
}
