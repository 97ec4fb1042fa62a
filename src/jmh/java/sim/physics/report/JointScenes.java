// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.math.BigDecimal;
import java.util.List;
import sim.physics.references.EllipticPendulum;
import sim.physics.references.RodChain;
import sim.physics.references.Squeezer;
import sim.physics.references.SqueezerPath;

/** Scenes with joints. */
final class JointScenes {
    private static final double G = 9.81;

    private JointScenes() {}

    /** All of them; the long ones in full length only if asked for. */
    static List<ReportScene> all(boolean full) {
        return List.of(
                pointPendulum(full ? 2000 : 100), rodPendulum(), chain(2, 1), chain(2, 3), chain(10, 1), chain(10, 3),
                fourBar(2, 10), fourBar(40, full ? 20 : 2), squeezer());
    }

    /** W01. */
    static ReportScene pointPendulum(double duration) {
        Model model = new Model(G);
        model.add(Model.Kind.DISC, new double[] {0.05}, 1, 1e-14, false, 1, 1, 0);
        model.rods.add(new Model.Rod(0, 0, 0));
        int samples = (int) Math.round(2 * duration);
        ReportScene scene = new ReportScene("W01", "IFToMM A01: point pendulum, " + (int) duration + " s", model, duration, samples, 16);
        scene.point(0, 0, 0);
        scene.energyUnit = G;
        scene.reference = "elliptic functions";
        EllipticPendulum exact = EllipticPendulum.released(new BigDecimal("9.81"), BigDecimal.ZERO);
        scene.expected = () -> rows(scene, t -> {
            double angle = exact.angle(t);
            return new double[] {StrictMath.sin(angle), -StrictMath.cos(angle)};
        });
        return scene;
    }

    /** W02. */
    static ReportScene rodPendulum() {
        Model model = new Model(G);
        model.rod(0.5, 0);
        model.pins.add(new Model.Pin(0, -1, 0, 0));
        ReportScene scene = new ReportScene("W02", "rod pendulum, 10 s", model, 10, 10, 30);
        scene.point(0, 0.5, 0);
        scene.energyUnit = G / 2;
        scene.reference = "elliptic functions";
        EllipticPendulum exact = EllipticPendulum.released(new BigDecimal("14.715"), BigDecimal.ZERO);
        scene.expected = () -> rows(scene, t -> {
            double angle = exact.angle(t);
            return new double[] {StrictMath.sin(angle), -StrictMath.cos(angle)};
        });
        return scene;
    }

    /** W03. */
    static ReportScene chain(int n, int duration) {
        Model model = new Model(G);
        for (int k = 0; k < n; k++) {
            model.rod(k + 0.5, 0);
            model.pins.add(new Model.Pin(k, k - 1, k, 0));
        }
        ReportScene scene = new ReportScene("W03-" + n + "-" + duration, "chain of " + n + " rods, t = " + duration + " s", model, duration, 1, 30 * duration);
        scene.point(n - 1, 0.5, 0);
        scene.energyUnit = G * n * n / 2.0;
        RodChain chain = new RodChain(n, G);
        double[] gragg = chain.tip(chain.states(scene.times(), true, 1e-14)[0]);
        double[] dormand = chain.tip(chain.states(scene.times(), false, 1e-14)[0]);
        scene.reference = String.format(java.util.Locale.ROOT,
                "Lagrange's equations in the angles, Gragg–Bulirsch–Stoer at 10⁻¹⁴; Dormand–Prince 8(5,3) differs by %.1e m,"
                        + " and errors below that are not told apart",
                Math.hypot(gragg[0] - dormand[0], gragg[1] - dormand[1]));
        scene.expected = () -> new double[][] {gragg};
        return scene;
    }

    /** W05. */
    static ReportScene fourBar(int n, int duration) {
        Model model = new Model(G);
        for (int k = 0; k <= n; k++) {
            // the cranks stand upright; the middle moves with half the speed of the top
            model.rod(k, 0.5, Math.PI / 2, 0.5, 0, -1);
            model.pins.add(new Model.Pin(k, -1, k, 0));
        }
        for (int k = 0; k < n; k++) {
            int coupler = model.rod(k + 0.5, 1, 0, 1, 0, 0);
            model.pins.add(new Model.Pin(coupler, k, k, 1));
            model.pins.add(new Model.Pin(coupler, k + 1, k + 1, 1));
        }
        ReportScene scene = new ReportScene("W05-" + n, "IFToMM A02: " + n + "-four-bar, " + duration + " s", model, duration, 20 * duration, 2);
        scene.point(0, 0.5, 0);
        scene.energyUnit = G * (3 * n + 1) / 2;
        scene.reference = "elliptic functions of the turning pendulum";
        scene.note = "All bars lie in one line twice in every turn.";
        BigDecimal w = new BigDecimal("9.81").multiply(BigDecimal.valueOf((n + 1) / 2.0 + n))
                .divide(BigDecimal.valueOf(n + 1).divide(BigDecimal.valueOf(3), new java.math.MathContext(40)).add(BigDecimal.valueOf(n)),
                        new java.math.MathContext(40));
        EllipticPendulum exact = EllipticPendulum.overTheTop(w, -1);
        scene.expected = () -> rows(scene, t -> {
            double angle = exact.angle(t);
            return new double[] {StrictMath.sin(angle), -StrictMath.cos(angle)};
        });
        return scene;
    }

    /** W06. */
    static ReportScene squeezer() {
        Squeezer exact = new Squeezer();
        Model model = new Model(0);
        for (int k = 0; k < 7; k++) {
            double[] c = exact.centre(k);
            model.add(Model.Kind.DISC, new double[] {0.001}, Squeezer.MASS[k], Squeezer.INERTIA[k], false, 1, c[0], c[1]);
        }
        for (double[] pin : exact.pins()) {
            model.pins.add(new Model.Pin((int) pin[0], (int) pin[1], pin[2], pin[3]));
        }
        double[] end = exact.springEnd();
        double[] s = Squeezer.SPRING;
        model.springs.add(new Model.Elastic(2, end[0], end[1], s[2], s[3], s[1], s[0], 0));
        model.torque = Squeezer.TORQUE;
        ReportScene scene = new ReportScene("W06", "Andrews' squeezer, 0.03 s", model, 0.03, 1, 60);
        for (int k = 0; k < 7; k++) {
            scene.point(k, 0.007, 0);
        }
        double near = Squeezer.beta(exact.states(scene.times(), true, 1e-14)[0]);
        SqueezerPath path = new SqueezerPath();
        double[] places = path.points(0.03, near, 0.007);
        scene.reference = String.format(java.util.Locale.ROOT,
                "conservation of energy, time as an integral over the crank's angle to 20 digits; Newton's equations with multipliers, "
                        + "Gragg–Bulirsch–Stoer at 10⁻¹⁴, differ by %.1e rad",
                Math.abs(near - path.beta(0.03, near)));
        scene.note = "The error is that of points 7 mm from the centres, in units of 7 mm: about rad.";
        scene.unit = 0.007;
        scene.cannot = engine -> engine.equals("JBox2D") || engine.equals("Box2D (libGDX)")
                ? "a spring is given by its frequency there, and its stiffness changes with the pose"
                : null;
        scene.expected = () -> new double[][] {places};
        return scene;
    }

    /** What is expected at an instant. */
    interface Row {
        double[] at(double t);
    }

    static double[][] rows(ReportScene scene, Row row) {
        double[] t = scene.times();
        double[][] rows = new double[t.length][];
        for (int k = 0; k < rows.length; k++) {
            rows[k] = row.at(t[k]);
        }
        return rows;
    }
}
