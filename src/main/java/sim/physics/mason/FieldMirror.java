// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import sim.engine.SimState;
import sim.engine.Steppable;
import sim.field.continuous.Continuous2D;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.util.Double2D;

/**
 * Shows the bodies of an engine in a field of MASON, at the places where the engine has them. Step it after the engine: in a
 * {@code GUIState} by {@code scheduleRepeatingImmediatelyAfter}, or on the model's schedule with {@link #ORDERING}. The field is
 * a picture of the engine, so moving an object in the field does not move the body. Other objects in the field stay there.
 *
 * <p>MASON draws the objects whose centres lie in a window, or outside it by no more than the field's discretization. So make the
 * discretization no less than half the length of the longest body, or walls vanish when one zooms in.
 */
public final class FieldMirror implements Steppable {
    private static final long serialVersionUID = 2L;

    /** An ordering after the engine's. */
    public static final int ORDERING = PhysicsEngine.ORDERING + 10;

    private final PhysicsEngine engine;
    private final Continuous2D field;

    /** The bodies in the field; at first also those of another engine, before a model was started again. */
    private List<Body> shown = new ArrayList<>();

    /**
     * Creates a mirror and fills the field.
     *
     * @param engine the engine to show
     * @param field the field that shows its bodies
     */
    public FieldMirror(PhysicsEngine engine, Continuous2D field) {
        this.engine = Objects.requireNonNull(engine, "engine");
        this.field = Objects.requireNonNull(field, "field");
        for (Object object : field.getAllObjects()) {
            if (object instanceof Body body) {
                shown.add(body);
            }
        }
        update();
    }

    @Override
    public void step(SimState state) {
        update();
    }

    /** Brings the field up to date. */
    public void update() {
        List<Body> bodies = engine.bodies();
        for (Body body : shown) {
            if (!engine.contains(body)) {
                field.remove(body);
            }
        }
        for (Body body : bodies) {
            field.setObjectLocation(body, new Double2D(body.getX(), body.getY()));
        }
        shown = bodies;
    }
}
