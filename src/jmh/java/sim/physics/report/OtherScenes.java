// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Function;
import sim.physics.references.ClosedForms;
import sim.physics.references.ElasticPendulum;
import sim.physics.references.HardDiscs;
import sim.physics.references.RodBounce;

/** Scenes with impacts, friction with the plane below, and a spring. */
final class OtherScenes {
    private static final double G = 9.81;

    /** MuJoCo's contacts are soft springs without a coefficient of restitution. */
    static final Function<String, String> RESTITUTION =
            engine -> engine.equals("MuJoCo") ? "no coefficient of restitution" : null;

    private OtherScenes() {}

    private static double between(Random random, double low, double high) {
        return low + (high - low) * random.nextDouble();
    }

    static List<ReportScene> all(boolean full) {
        return List.of(
                flight(), balls(1, full), balls(0.9, full), balls(0.5, full), rodBounce(), blocks(100), blocks(10_000), billiard(full),
                gas(full), cluster(full), puck(), spring(100, 0.1),
                elasticPendulum());
    }

    private static ReportScene hard(String id, String title, Model model, double duration, int samples, int coarse) {
        ReportScene scene = new ReportScene(id, title, model, duration, samples, coarse);
        scene.smooth = false;
        scene.cannot = RESTITUTION;
        return scene;
    }

    /** W09. */
    static ReportScene flight() {
        Model model = new Model(G);
        double w = 7;
        int body = model.add(Model.Kind.BOX, new double[] {1, 0.5}, 1, 1.25 / 12, false, 1, 0, 0, 0, 20, 50, w);
        ReportScene scene = new ReportScene("W09", "free flight with spin, 10 s", model, 10, 10, 30);
        scene.smooth = false;
        scene.point(body, 0.5, 0.25);
        scene.energyUnit = model.kinetic(model.start());
        scene.reference = "parabola and constant spin";
        scene.expected = () -> JointScenes.rows(scene, t -> {
            double cos = StrictMath.cos(w * t);
            double sin = StrictMath.sin(w * t);
            return new double[] {20 * t + 0.5 * cos - 0.25 * sin, 50 * t - G * t * t / 2 + 0.5 * sin + 0.25 * cos};
        });
        return scene;
    }

    /** W10: many balls dropped from different heights, so that impacts fall into all phases of a step. */
    static ReportScene balls(double e, boolean full) {
        int n = full ? 40 : 20;
        Model model = new Model(G);
        model.wall(n, -1, 2 * n + 10, 2);
        double[] heights = new double[n];
        for (int k = 0; k < n; k++) {
            heights[k] = 0.5 + 1.0 / 3 + 0.618033988749895 * k % 1.0;
            model.add(Model.Kind.DISC, new double[] {0.5}, 1, 0.125, true, e, 2 * k + 0.5, heights[k] + 0.5);
        }
        ReportScene scene = hard("W10-" + Math.round(100 * e), "bouncing discs, e = " + e + ", " + n + " phases, 5 s", model, 5, 10, 30);
        for (int k = 0; k < n; k++) {
            scene.point(k + 1, 0, 0);
        }
        scene.energyUnit = e == 1 ? model.energy(model.start()) : Double.NaN;
        scene.reference = "closed form";
        scene.expected = () -> JointScenes.rows(scene, t -> {
            double[] row = new double[2 * n];
            for (int k = 0; k < n; k++) {
                row[2 * k] = 2 * k + 0.5;
                row[2 * k + 1] = 0.5 + ClosedForms.bounce(heights[k], e, G, t);
            }
            return row;
        });
        return scene;
    }

    /** W11. */
    static ReportScene rodBounce() {
        double width = 0.04;
        double inertia = (1 + width * width) / 12;
        Model model = new Model(G);
        model.wall(0, -1, 20, 2);
        model.add(Model.Kind.BOX, new double[] {1, width}, 1, inertia, true, 1, 0, 1.5, 0.3);
        ReportScene scene = hard("W11", "bouncing rod, 2 s", model, 2, 1, 60);
        scene.point(1, 0.5, 0).point(1, -0.5, 0);
        scene.energyUnit = 1.5 * G;
        RodBounce rod = new RodBounce(1, width, inertia, 1.5, 0.3, G);
        int impacts = 0;
        while (rod.next(2) < 2) {
            impacts++;
        }
        double[] pose = rod.pose();
        scene.reference = "parabola and constant spin between the roots, " + impacts + " impacts";
        scene.expected = () -> {
            double x = StrictMath.cos(pose[1]) / 2;
            double y = StrictMath.sin(pose[1]) / 2;
            return new double[][] {{x, pose[0] + y, -x, pose[0] - y}};
        };
        return scene;
    }

    /** W12. */
    static ReportScene blocks(double ratio) {
        Model model = new Model(0);
        model.wall(-0.5, 0, 1, 20);
        model.add(Model.Kind.BOX, new double[] {1, 1}, 1, 1 / 6.0, true, 1, 1.5, 0);
        model.add(Model.Kind.BOX, new double[] {1, 1}, ratio, ratio / 6, true, 1, 3.5, 0, 0, -1);
        ReportScene scene = hard("W12-" + (int) ratio, "blocks that count π, masses 1 : " + (int) ratio, model, 4, 1, 120);
        scene.point(1, 0, 0).point(2, 0, 0);
        scene.energyUnit = ratio / 2;
        scene.reference = "unfolding in a wedge, " + ClosedForms.blockImpacts(ratio) + " impacts";
        scene.expected = () -> {
            double[] at = ClosedForms.blocks(ratio, 1, 2, 4);
            return new double[][] {{at[0] + 0.5, 0, at[1] + 1.5, 0}};
        };
        return scene;
    }

    /** W13. */
    static ReportScene billiard(boolean full) {
        int n = full ? 16 : 8;
        double duration = 20;
        Model model = new Model(0);
        ReportScene scene = hard("W13", "rectangular billiard, " + n + " tables, 20 s", model, duration, 4, 150);
        List<double[]> balls = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            double x = 20 * k;
            model.wall(x - 3.5, 0, 1, 6);
            model.wall(x + 3.5, 0, 1, 6);
            model.wall(x, -2.5, 8, 1);
            model.wall(x, 2.5, 8, 1);
            double direction = 0.3 + k;
            double[] start = {x + 0.1 * k, 0.3, 0, 3 * StrictMath.cos(direction), 3 * StrictMath.sin(direction), 0};
            int ball = model.add(Model.Kind.DISC, new double[] {0.5}, 1, 0.125, true, 1, start);
            balls.add(start);
            scene.point(ball, 0, 0);
        }
        scene.energyUnit = model.kinetic(model.start());
        scene.reference = "unfolding";
        scene.note = "The circular billiard is not in: the shapes here are convex, and so is no wall round a disc.";
        scene.expected = () -> JointScenes.rows(scene, t -> {
            double[] row = new double[2 * balls.size()];
            for (int k = 0; k < balls.size(); k++) {
                double[] s = balls.get(k);
                row[2 * k] = 20 * k + ClosedForms.folded(s[0] - 20 * k, s[3], t, 2.5);
                row[2 * k + 1] = ClosedForms.folded(s[1], s[4], t, 1.5);
            }
            return row;
        });
        return scene;
    }

    /** W14: as long as the places can be compared. */
    static ReportScene gas(boolean full) {
        int n = 100;
        double half = 10;
        Model model = new Model(0);
        model.wall(-half - 1, 0, 2, 30);
        model.wall(half + 1, 0, 2, 30);
        model.wall(0, -half - 1, 30, 2);
        model.wall(0, half + 1, 30, 2);
        Random random = new Random(7);
        double[][] s = new double[4][n];
        for (int k = 0; k < n; k++) {
            s[0][k] = -9 + 2 * (k % 10) + between(random, -0.4, 0.4);
            s[1][k] = -9 + 2 * (k / 10) + between(random, -0.4, 0.4);
            s[2][k] = between(random, -5, 5);
            s[3][k] = between(random, -5, 5);
            model.add(Model.Kind.DISC, new double[] {0.5}, 1, 0.125, true, 1, s[0][k], s[1][k], 0, s[2][k], s[3][k], 0);
        }
        HardDiscs exact = new HardDiscs(s[0], s[1], s[2], s[3], 0.5, half);
        double duration = 0.5;
        ReportScene scene = hard("W14", "gas of 100 discs, 0.5 s", model, duration, 1, 15);
        exact.run(duration);
        scene.energyUnit = model.kinetic(model.start());
        scene.reference = "event by event, all pairs, " + exact.impacts() + " impacts";
        double[] row = new double[2 * n];
        for (int k = 0; k < n; k++) {
            scene.point(k + 4, 0, 0);
            row[2 * k] = exact.place(k)[0];
            row[2 * k + 1] = exact.place(k)[1];
        }
        scene.expected = () -> new double[][] {row};
        return scene;
    }

    /** W15, without walls: polygons that fly into one another. */
    static ReportScene cluster(boolean full) {
        int side = full ? 10 : 7;
        Model model = new Model(0);
        Random random = new Random(3);
        double radius = 0.7;
        for (int k = 0; k < side * side; k++) {
            int corners = 3 + k % 4;
            double x = 1.6 * (k % side - (side - 1) / 2.0) + between(random, -0.05, 0.05);
            double y = 1.6 * (k / side - (side - 1) / 2.0) + between(random, -0.05, 0.05);
            double turn = 2 * Math.PI / corners;
            double area = radius * radius * corners * StrictMath.sin(turn) / 2;
            double inertia = area * radius * radius / 6 * (2 + StrictMath.cos(turn));
            model.add(Model.Kind.POLYGON, new double[] {radius, corners}, area, inertia, true, 1,
                    x, y, between(random, -3, 3), -x / 2 + between(random, -1, 1), -y / 2 + between(random, -1, 1),
                    between(random, -2, 2));
        }
        ReportScene scene = hard("W15", "cluster of " + side * side + " polygons, 5 s", model, 5, 5, 30);
        scene.energyUnit = model.kinetic(model.start());
        scene.free = true;
        scene.reference = "conservation of energy: the error is relative, of energy";
        scene.note = "The motion is chaotic, places cannot be compared.";
        return scene;
    }

    /** W20. */
    static ReportScene puck() {
        Model model = new Model(0);
        model.surfaceGravity = G;
        model.surfaceFriction = 0.3;
        model.add(Model.Kind.DISC, new double[] {0.1}, 1, 0.005, false, 1, 0, 0, 0, 1, 0, 10);
        ReportScene scene = new ReportScene("W20", "puck that slides, spins and stops", model, 0.5, 1, 8);
        scene.point(0, 0, 0);
        scene.conservative = false;
        scene.reference = "Farkas et al. 2003: stops after 0.2165807761242 m";
        scene.note = "Other engines have no friction with a plane below, or rub against sliding and spinning apart, which here is"
                + " 22 % wrong in the distance.";
        scene.cannot = engine -> engine.equals("ours") ? null : "no friction of a flat body with a plane below";
        scene.expected = () -> new double[][] {{0.2165807761242, 0}};
        return scene;
    }

    /** W22. */
    static ReportScene spring(double omega, double zeta) {
        Model model = new Model(0);
        int body = model.add(Model.Kind.DISC, new double[] {0.1}, 1, 0.005, false, 1, 1.2, 0);
        model.springs.add(new Model.Elastic(body, 1.2, 0, 0, 0, 1, omega * omega, 2 * zeta * omega));
        String name = "spring, ω = " + (int) omega + "/s, damping ratio " + zeta + ", 1 s";
        ReportScene scene = new ReportScene("W22-" + (int) omega, name, model, 1, 4, 15);
        scene.point(body, 0, 0);
        scene.unit = 0.2;
        scene.conservative = false;
        scene.reference = "closed form; the error is relative to the first stretch";
        scene.expected = () -> JointScenes.rows(
                scene, t -> new double[] {1 + 0.2 * ClosedForms.oscillator(omega, zeta, t), 0});
        return scene;
    }

    /** W22, slow and fast: a mass that swings on a stiff spring with a damper. */
    static ReportScene elasticPendulum() {
        ElasticPendulum exact = new ElasticPendulum(10_000, 1, G);
        double[] start = exact.start(1);
        Model model = new Model(G);
        double x = start[0] * StrictMath.sin(start[1]);
        double y = -start[0] * StrictMath.cos(start[1]);
        int body = model.add(Model.Kind.DISC, new double[] {0.1}, 1, 0.005, false, 1, x, y);
        model.springs.add(new Model.Elastic(body, x, y, 0, 0, 1, 1e8, 2e4));
        ReportScene scene =
                new ReportScene("W22-stiff", "swing on a stiff spring, ω = 10,000/s, critically damped, 3 s", model, 3, 6, 15);
        scene.point(body, 0, 0);
        scene.conservative = false;
        double[][] gragg = exact.states(start, scene.times(), true, 1e-13);
        double[][] dormand = exact.states(start, scene.times(), false, 1e-13);
        double[] a = ElasticPendulum.place(gragg[5]);
        double[] b = ElasticPendulum.place(dormand[5]);
        scene.reference = String.format(java.util.Locale.ROOT,
                "Lagrange's equations in length and angle, Dormand–Prince 8(5,3) at 10⁻¹³; Gragg–Bulirsch–Stoer differs by %.1e m",
                Math.hypot(a[0] - b[0], a[1] - b[1]));
        scene.note = "At errors above 1e-2 the soft springs of the game engines take less time than any of our methods, as the left"
                + " of the plot shows.";
        scene.expected = () -> {
            double[][] rows = new double[6][];
            for (int k = 0; k < 6; k++) {
                rows[k] = ElasticPendulum.place(dormand[k]);
            }
            return rows;
        };
        return scene;
    }
}
