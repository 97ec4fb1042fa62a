// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.awt.Graphics2D;
import java.awt.Paint;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.util.Objects;
import sim.display.GUIState;
import sim.physics.motion.Body;
import sim.portrayal.DrawInfo2D;
import sim.portrayal.Inspector;
import sim.portrayal.LocationWrapper;
import sim.portrayal.SimpleInspector;
import sim.portrayal.SimplePortrayal2D;

/** Draws a {@link Body} in its shape, size and orientation, and finds it under the mouse. */
public class BodyPortrayal2D extends SimplePortrayal2D {
    private static final long serialVersionUID = 1L;

    private final transient Paint paint;

    /**
     * Creates a portrayal.
     *
     * @param paint paint that fills the shape
     */
    public BodyPortrayal2D(Paint paint) {
        this.paint = Objects.requireNonNull(paint, "paint");
    }

    @Override
    public void draw(Object object, Graphics2D graphics, DrawInfo2D info) {
        graphics.setPaint(paint);
        graphics.fill(outline((Body) object, info));
    }

    @Override
    public boolean hitObject(Object object, DrawInfo2D range) {
        return outline((Body) object, range).intersects(range.clip.x, range.clip.y, range.clip.width, range.clip.height);
    }

    /** {@inheritDoc} A plain body shows its properties one by one; your own subclass shows its own. */
    @Override
    public Inspector getInspector(LocationWrapper wrapper, GUIState state) {
        Object object = wrapper == null ? null : wrapper.getObject();
        if (object == null || object.getClass() != Body.class) {
            return super.getInspector(wrapper, state);
        }
        return new SimpleInspector(new InspectedBody((Body) object), state, "Body");
    }

    private static Shape outline(Body body, DrawInfo2D info) {
        AffineTransform place = AffineTransform.getTranslateInstance(info.draw.x, info.draw.y);
        place.scale(info.draw.width, info.draw.height);
        place.rotate(body.getAngle());
        return place.createTransformedShape(AwtShapes.of(body.getShape()));
    }
}
