// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos;

import java.awt.Color;
import java.util.HashMap;
import java.util.Map;
import javax.swing.JFrame;
import sim.display.Controller;
import sim.display.Display2D;
import sim.display.GUIState;
import sim.engine.SimState;
import sim.field.continuous.Continuous2D;
import sim.physics.mason.BodyPortrayal2D;
import sim.physics.mason.ContactsPortrayal2D;
import sim.physics.mason.FieldMirror;
import sim.physics.mason.JointsPortrayal2D;
import sim.physics.motion.Body;
import sim.portrayal.Inspector;
import sim.portrayal.continuous.ContinuousPortrayal2D;

/** A scene in MASON's console. */
public abstract class SceneWithUI extends GUIState {
    protected Display2D display;
    private JFrame frame;
    private final ContinuousPortrayal2D portrayal = new ContinuousPortrayal2D();
    private final JointsPortrayal2D joints = new JointsPortrayal2D(Scene.WORLD, Scene.WORLD);
    private final ContactsPortrayal2D contacts = new ContactsPortrayal2D(Scene.WORLD, Scene.WORLD);

    protected SceneWithUI(SimState state) {
        super(state);
    }

    @Override
    public Object getSimulationInspectedObject() {
        return state;
    }

    @Override
    public Inspector getInspector() {
        Inspector inspector = super.getInspector();
        inspector.setVolatile(true);
        return inspector;
    }

    @Override
    public void start() {
        super.start();
        setupPortrayals();
    }

    @Override
    public void load(SimState loaded) {
        super.load(loaded);
        setupPortrayals();
    }

    /** Begins to show a scene, when it starts or is loaded. */
    protected void setupPortrayals() {
        Scene scene = (Scene) state;
        Map<Color, BodyPortrayal2D> portrayals = new HashMap<>();
        Continuous2D field = new Continuous2D(Scene.WORLD, Scene.WORLD, Scene.WORLD); // walls are as long, and are to be seen from near too
        scheduleRepeatingImmediatelyAfter(new FieldMirror(scene.physics, field)); // of the display: models that run without one have no part of it
        portrayal.setField(field);
        for (Body body : scene.physics.bodies()) {
            portrayal.setPortrayalForObject(
                    body, portrayals.computeIfAbsent(scene.colour(body), BodyPortrayal2D::new));
        }
        joints.setField(scene.physics);
        contacts.setField(scene.physics);
        display.reset();
        display.setBackdrop(scene.ground());
        display.repaint();
    }

    @Override
    public void init(Controller controller) {
        super.init(controller);
        display = new Display2D(800, 800, this);
        frame = display.createFrame();
        frame.setTitle(getName(getClass()));
        controller.registerFrame(frame);
        frame.setVisible(true);
        display.attach(portrayal, "Bodies");
        display.attach(joints, "Joints");
        display.attach(contacts, "Contacts", false); // to be chosen in the display's menu of layers
    }

    @Override
    public void quit() {
        super.quit();
        if (frame != null) {
            frame.dispose();
        }
        frame = null;
        display = null;
    }
}
