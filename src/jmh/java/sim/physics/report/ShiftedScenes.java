// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.List;
import java.util.Locale;
import java.util.Random;
import sim.physics.references.RodChain;
import sim.physics.references.SliderCrank;

/** More scenes with joints: machines, chains of other masses and places, and what is struck. */
final class ShiftedScenes {
    private static final double G = 9.81;

    private ShiftedScenes() {}

    static List<ReportScene> all() {
        return List.of(
                chain("W04", "chain of 100 rods, 0.5 s", ones(100), 0, 0.5, 30, 0, 1, 2, 4, 9, 19, 49, 99),
                sliderCrank(),
                chain("W08", "chain of ten rods, masses over six decades, 0.5 s", decades(3), 0, 0.5, 60, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9),
                struck(),
                chain("W23", "chain of ten rods, 10⁶ m from the origin, 1 s", ones(10), 1e6, 1, 30, 9));
    }

    private static double[] ones(int n) {
        double[] masses = new double[n];
        java.util.Arrays.fill(masses, 1);
        return masses;
    }

    private static double[] decades(double most) {
        Random random = new Random(2);
        double[] masses = new double[10];
        for (int k = 0; k < masses.length; k++) {
            masses[k] = StrictMath.pow(10, most * (2 * random.nextDouble() - 1));
        }
        return masses;
    }

    /**
     * A row of rods let go from the horizontal, of other numbers, masses and places than W03's.
     *
     * @param ends of which rods are compared: of a long chain the tip falls freely for a while
     */
    static ReportScene chain(
            String id, String title, double[] masses, double far, double duration, int coarse, int... ends) {
        int n = masses.length;
        Model model = new Model(G);
        double weight = 0;
        for (int k = 0; k < n; k++) {
            model.add(Model.Kind.BOX, new double[] {1, 0.02}, masses[k], masses[k] / 12, false, 1, far + k + 0.5, far);
            model.pins.add(new Model.Pin(k, k - 1, far + k, far));
            weight += masses[k] * (k + 0.5);
        }
        ReportScene scene = new ReportScene(id, title, model, duration, 1, coarse);
        for (int rod : ends) {
            scene.point(rod, 0.5, 0);
        }
        scene.energyUnit = G * weight;
        RodChain chain = new RodChain(masses, G);
        double[] gragg = ends(chain, chain.states(scene.times(), true, 1e-14)[0], ends, far);
        double[] dormand = ends(chain, chain.states(scene.times(), false, 1e-14)[0], ends, far);
        double apart = 0;
        for (int k = 0; k < gragg.length; k++) {
            apart = Math.max(apart, Math.abs(gragg[k] - dormand[k]));
        }
        scene.reference = String.format(Locale.ROOT,
                "Lagrange's equations in the angles, Gragg–Bulirsch–Stoer at 10⁻¹⁴; Dormand–Prince 8(5,3) differs by %.1e m",
                apart);
        scene.expected = () -> new double[][] {gragg};
        return scene;
    }

    private static double[] ends(RodChain chain, double[] angles, int[] rods, double far) {
        double[] row = new double[2 * rods.length];
        for (int k = 0; k < rods.length; k++) {
            double[] end = chain.end(angles, rods[k]);
            row[2 * k] = far + end[0];
            row[2 * k + 1] = far + end[1];
        }
        return row;
    }

    /** W07: with inertia enough to pass its dead points. */
    static ReportScene sliderCrank() {
        double r = 0.6;
        double rate = 6;
        Model model = new Model(G);
        model.add(Model.Kind.BOX, new double[] {r, 0.02}, 1, r * r / 12, false, 1, 0, 0.3, Math.PI / 2, -rate * 0.3, 0, rate);
        model.add(Model.Kind.BOX, new double[] {1, 0.02}, 1, 1 / 12.0, false, 1, 0.4, 0.3, StrictMath.atan2(-0.6, 0.8), -rate * r, 0, 0);
        model.add(Model.Kind.BOX, new double[] {0.2, 0.1}, 1, 0.05 / 12, false, 1, 0.8, 0, 0, -rate * r, 0, 0);
        model.pins.add(new Model.Pin(0, -1, 0, 0));
        model.pins.add(new Model.Pin(1, 0, 0, 0.6));
        model.pins.add(new Model.Pin(1, 2, 0.8, 0));
        model.slides.add(new Model.Slide(2));
        ReportScene scene = new ReportScene("W07", "slider-crank, 5 s", model, 5, 10, 15);
        scene.point(0, r / 2, 0).point(1, 0, 0).point(2, 0, 0);
        scene.energyUnit = model.kinetic(model.start());
        SliderCrank exact = new SliderCrank(r, 1, G, Math.PI / 2, rate);
        double[] gragg = exact.angles(Math.PI / 2, scene.times(), true, 1e-14);
        double[] angles = exact.exactAngles(scene.times(), gragg);
        scene.reference = String.format(Locale.ROOT,
                "conservation of energy, time as an integral over the crank's angle to 20 digits; Gragg–Bulirsch–Stoer at 10⁻¹⁴ differs by %.1e rad",
                Math.abs(gragg[9] - angles[9]));
        scene.expected = () -> {
            double[][] rows = new double[10][];
            for (int k = 0; k < rows.length; k++) {
                rows[k] = exact.places(angles[k]);
            }
            return rows;
        };
        return scene;
    }

    /** W21: a ball strikes a link of a chain that hangs at rest; it has fallen by then as far as to be beside the link's middle. */
    static ReportScene struck() {
        int n = 10;
        int link = 4;
        double speed = 5;
        double way = 0.5;
        double radius = 0.1;
        double wide = 0.02;
        double hit = way / speed;
        Model model = new Model(G);
        for (int k = 0; k < n; k++) {
            model.add(Model.Kind.BOX, new double[] {wide, 1}, 1, 1 / 12.0, k == link, 1, 0, -k - 0.5);
            model.pins.add(new Model.Pin(k, k - 1, 0, -k));
        }
        double x = -way - radius - wide / 2;
        double y = -link - 0.5 + G * hit * hit / 2;
        int ball = model.add(Model.Kind.DISC, new double[] {radius}, 2, 0.01, true, 1, x, y, 0, speed, 0, 0);
        ReportScene scene = new ReportScene("W21", "ball that strikes a hanging chain, 0.4 s", model, 0.4, 4, 6);
        scene.methods = ContactScenes.EVENTS;
        scene.smooth = false;
        scene.cannot = OtherScenes.RESTITUTION;
        scene.point(n - 1, 0, -0.5).point(link, 0, -0.5).point(ball, 0, 0);
        scene.energyUnit = model.kinetic(model.start());
        RodChain chain = new RodChain(n, G);
        double[] start = chain.struck(link, 0.5, 2, speed, 1);
        double after = start[2 * n];
        double[] angles = java.util.Arrays.copyOf(start, 2 * n);
        double[] late = scene.times();
        for (int k = 0; k < late.length; k++) {
            late[k] = Math.max(0, late[k] - hit);
        }
        double[][] states = chain.states(angles, late, true, 1e-14);
        scene.reference = "Newton's law of impact with the inertia that the chain has there, in closed form; then Lagrange's equations,"
                + " Gragg–Bulirsch–Stoer at 10⁻¹⁴";
        scene.expected = () -> {
            double[][] rows = new double[4][];
            for (int k = 0; k < rows.length; k++) {
                double[] tip = chain.tip(states[k]);
                double[] end = chain.end(states[k], link);
                double t = scene.times()[k];
                double bx = t < hit ? x + speed * t : -radius - wide / 2 + after * (t - hit);
                rows[k] = new double[] {tip[0], tip[1], end[0], end[1], bx, y - G * t * t / 2};
            }
            return rows;
        };
        return scene;
    }
}
