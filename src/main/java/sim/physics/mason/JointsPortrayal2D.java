// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.awt.Color;
import java.util.Objects;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.motion.ForceGenerator;
import sim.portrayal.Portrayal;
import sim.util.Double2D;

/**
 * A layer of a display that shows what ties bodies: joints, motors, stops, ropes, and the springs and other forces that act
 * between two bodies. Attach it over the {@code ContinuousPortrayal2D} of the bodies, and set the engine as its field:
 *
 * <pre>
 *   private final JointsPortrayal2D joints = new JointsPortrayal2D(100, 100);   // the size of the bodies' field
 *
 *   display.attach(joints, "Joints");                                           // in init(), after the bodies
 *   joints.setField(((Model) state).physics);                                   // in start() and load()
 * </pre>
 *
 * <p>Each of them is drawn by a {@link LinkPortrayal2D} of one colour, unless you set another portrayal for its class. A click on
 * one of them opens an inspector with its bodies, its force, its gap, and the properties that may be set.
 */
public class JointsPortrayal2D extends EnginePortrayal2D {
    private final LinkPortrayal2D portrayal;

    /**
     * Creates a layer that draws in dark orange.
     *
     * @param width width of the field that shows the bodies
     * @param height height of that field
     */
    public JointsPortrayal2D(double width, double height) {
        this(width, height, new LinkPortrayal2D(new Color(220, 110, 0)));
    }

    /**
     * Creates a layer.
     *
     * @param width width of the field that shows the bodies
     * @param height height of that field
     * @param portrayal the portrayal that draws everything for which no other one is set
     */
    public JointsPortrayal2D(double width, double height, LinkPortrayal2D portrayal) {
        super(width, height);
        this.portrayal = Objects.requireNonNull(portrayal, "portrayal");
    }

    @Override
    public Portrayal getDefaultPortrayal() {
        return portrayal;
    }

    @Override
    void forAll(PhysicsEngine engine, Visitor visitor) {
        LinkPlaces places = new LinkPlaces(engine);
        for (Constraint constraint : engine.allConstraints()) {
            Double2D place = places.of(constraint);
            visitor.visit(constraint, place.x, place.y);
        }
        for (ForceGenerator generator : engine.allForceGenerators()) {
            if (LinkPlaces.ends(generator) != null) {
                Double2D place = places.of(generator);
                visitor.visit(generator, place.x, place.y);
            }
        }
    }

    @Override
    Double2D locate(Object object) {
        PhysicsEngine engine = engine();
        boolean isThere = engine != null
                && (object instanceof Constraint c ? engine.contains(c) : engine.allForceGenerators().contains(object));
        return isThere ? new LinkPlaces(engine).of(object) : null;
    }
}
