// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.collisions;

import java.awt.Color;
import javax.swing.JFrame;
import sim.display.Console;
import sim.display.Controller;
import sim.display.Display2D;
import sim.display.GUIState;
import sim.engine.SimState;
import sim.engine.Steppable;
import sim.physics.mason.BodyPortrayal2D;
import sim.physics.motion.Body;
import sim.portrayal.Inspector;
import sim.portrayal.continuous.ContinuousPortrayal2D;
import sim.util.media.chart.TimeSeriesChartGenerator;

/** The collisions demo in MASON's console. */
public class CollisionsWithUI extends GUIState {
    private static final Color GROUND = new Color(0, 80, 0);

    public Display2D display;
    public JFrame displayFrame;
    private final ContinuousPortrayal2D portrayal = new ContinuousPortrayal2D();
    private TimeSeriesChartGenerator chart;
    private JFrame chartFrame;
    private org.jfree.data.xy.XYSeries energy;

    public CollisionsWithUI() {
        this(new Collisions(System.currentTimeMillis()));
    }

    public CollisionsWithUI(SimState state) {
        super(state);
    }

    public static String getName() {
        return "Collisions";
    }

    public static Object getInfo() {
        return "<h2>Collisions</h2><p>Circles and rectangles bounce around on a plane between four walls. Without"
                + " friction and with restitution 1 they do so for ever and keep their energy.</p>";
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
        ((Collisions) state).mirror();
        setupPortrayals();
    }

    @Override
    public void load(SimState loaded) {
        super.load(loaded);
        setupPortrayals();
    }

    private void setupPortrayals() {
        Collisions model = (Collisions) state;
        portrayal.setField(model.field);
        portrayal.setPortrayalForRemainder(new BodyPortrayal2D(Color.RED));
        BodyPortrayal2D wall = new BodyPortrayal2D(Color.WHITE);
        for (Body body : model.physics.bodies()) {
            if (body.isFixed()) {
                portrayal.setPortrayalForObject(body, wall);
            }
        }
        display.reset();
        display.setBackdrop(GROUND);
        display.repaint();
        chart.removeAllSeries();
        energy = new org.jfree.data.xy.XYSeries("kinetic energy", false);
        chart.addSeries(energy, null);
        scheduleRepeatingImmediatelyAfter(new Steppable() {
            private static final long serialVersionUID = 1L;

            @Override
            public void step(SimState simulation) {
                double time = simulation.schedule.getTime();
                if (time >= 0 && time < Double.MAX_VALUE) {
                    energy.add(time, ((Collisions) simulation).getKineticEnergy(), true);
                }
            }
        });
    }

    @Override
    public void init(Controller controller) {
        super.init(controller);
        display = new Display2D(800, 800, this);
        displayFrame = display.createFrame();
        displayFrame.setTitle("Collisions");
        controller.registerFrame(displayFrame);
        displayFrame.setVisible(true);
        display.attach(portrayal, "Bodies");
        chart = new TimeSeriesChartGenerator();
        chart.setTitle("Kinetic energy");
        chart.setXAxisLabel("time");
        chart.setYAxisLabel("energy");
        chartFrame = chart.createFrame();
        controller.registerFrame(chartFrame);
        chartFrame.setLocation(820, 400);
        chartFrame.setVisible(true);
    }

    @Override
    public void quit() {
        super.quit();
        if (displayFrame != null) {
            displayFrame.dispose();
        }
        if (chartFrame != null) {
            chartFrame.dispose();
        }
        displayFrame = null;
        display = null;
    }

    public static void main(String[] args) {
        new Console(new CollisionsWithUI()).setVisible(true);
    }
}
