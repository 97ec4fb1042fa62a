// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.collisions;

import demos.SceneWithUI;
import javax.swing.JFrame;
import sim.display.Console;
import sim.display.Controller;
import sim.engine.SimState;
import sim.engine.Steppable;
import sim.util.media.chart.TimeSeriesChartGenerator;

/** The collisions demo in MASON's console. */
public final class CollisionsWithUI extends SceneWithUI {
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
    protected void setupPortrayals() {
        super.setupPortrayals();
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
        if (chartFrame != null) {
            chartFrame.dispose();
        }
        chartFrame = null;
    }

    public static void main(String[] args) {
        new Console(new CollisionsWithUI()).setVisible(true);
    }
}
