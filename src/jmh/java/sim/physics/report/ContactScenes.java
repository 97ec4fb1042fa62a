// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.Arrays;
import java.util.ArrayList;
import java.util.List;
import sim.physics.references.Ladder;

/** Scenes with contacts that last, with friction or without, and with rows of impacts. */
final class ContactScenes {
    /** Where bodies touch, rest, slide and roll on one another: events need the step where something turns while it slides. */
    static final List<OwnMethod> EVENTS = List.of(OwnMethod.EVENTS, OwnMethod.TIME_STEPPING);

    private static final double G = 9.81;

    private ContactScenes() {}

    static List<ReportScene> all(boolean full) {
        List<ReportScene> all = new ArrayList<>(List.of(
                cradle(20, 3, 1e-6), slide(), roll(), incline(), ladder(), stack(100), pushed(), rollers(), elastic(full)));
        if (full) { // others of their kind tell more
            all.add(cradle(5, 1, 1e-3));
            all.add(stack(1));
        }
        return all;
    }

    private static ReportScene touching(String id, String title, Model model, double duration, int samples, int coarse) {
        ReportScene scene = new ReportScene(id, title, model, duration, samples, coarse);
        scene.smooth = false;
        scene.methods = EVENTS;
        return scene;
    }

    /** A disc of radius 1/2. */
    private static int disc(Model model, double mass, double... start) {
        return model.add(Model.Kind.DISC, new double[] {0.5}, mass, mass / 8, true, 0, start);
    }

    private static int box(Model model, double width, double height, double mass, double... start) {
        double inertia = mass * (width * width + height * height) / 12;
        return model.add(Model.Kind.BOX, new double[] {width, height}, mass, inertia, true, 0, start);
    }

    /** W16: balls of equal masses on a line change their velocities, as if they went through one another. */
    static ReportScene cradle(int n, int in, double gap) {
        double speed = 2;
        Model model = new Model(0);
        double[] place = new double[n];
        double[] v = new double[n];
        for (int k = 0; k < n; k++) {
            place[k] = k * (1 + gap) - (k < in ? 0.5 : 0);
            v[k] = k < in ? speed : 0;
            model.add(Model.Kind.DISC, new double[] {0.5}, 1, 0.125, true, 1, place[k], 0, 0, v[k]);
        }
        String title = "cradle of " + n + " discs, gaps of " + Markdown.number(gap) + " m, " + in + " come in, 1 s";
        ReportScene scene = new ReportScene("W16-" + n, title, model, 1, 2, 15);
        scene.smooth = false;
        scene.cannot = OtherScenes.RESTITUTION;
        for (int k = 0; k < n; k++) {
            scene.point(k, 0, 0);
        }
        scene.energyUnit = model.kinetic(model.start());
        scene.free = true;
        scene.reference = "places of points that go through one another, in order";
        scene.expected = () -> JointScenes.rows(scene, t -> {
            double[] points = new double[n];
            for (int k = 0; k < n; k++) {
                points[k] = place[k] - k + v[k] * t;
            }
            Arrays.sort(points);
            double[] row = new double[2 * n];
            for (int k = 0; k < n; k++) {
                row[2 * k] = points[k] + k;
            }
            return row;
        });
        return scene;
    }

    /** W17a. */
    static ReportScene slide() {
        double mu = 0.5;
        double speed = 5;
        Model model = new Model(G);
        model.friction = mu;
        int box = box(model, 1, 0.5, 1, 0, 0.25, 0, speed);
        model.wall(0, -1, 40, 2);
        ReportScene scene = touching("W17-slide", "box that slides and stops, 1.5 s", model, 1.5, 3, 10);
        scene.point(box, 0, 0).point(box, 0.5, 0.25);
        scene.reference = "v² / 2 μ g = 2.548 m after v / μ g = 1.019 s, in closed form";
        double stop = speed / (mu * G);
        scene.expected = () -> JointScenes.rows(scene, t -> {
            double s = Math.min(t, stop);
            double x = s * (speed - mu * G * s / 2);
            return new double[] {x, 0.25, x + 0.5, 0.5};
        });
        return scene;
    }

    /** W17b. */
    static ReportScene roll() {
        double mu = 0.2;
        double speed = 3;
        Model model = new Model(G);
        model.friction = mu;
        int disc = disc(model, 1, 0, 0.5, 0, speed);
        model.wall(0, -1, 40, 2);
        ReportScene scene = touching("W17-roll", "disc that slides, then rolls, 1 s", model, 1, 2, 15);
        scene.point(disc, 0, 0).point(disc, 0.5, 0);
        scene.reference = "rolls with 2 v / 3 from v / 3 μ g = 0.510 s on, in closed form";
        double begin = speed / (3 * mu * G);
        scene.expected = () -> JointScenes.rows(scene, t -> {
            double s = Math.min(t, begin);
            double x = s * (speed - mu * G * s / 2) + 2 * speed / 3 * (t - s);
            double angle = -2 * mu * G * s * s + -2 * (2 * speed / 3) * (t - s);
            return new double[] {x, 0.5, x + StrictMath.cos(angle) / 2, 0.5 + StrictMath.sin(angle) / 2};
        });
        return scene;
    }

    /** W17c: the plane lies, gravity leans. */
    static ReportScene incline() {
        double mu = 0.4;
        double angle = Math.PI / 6;
        Model model = new Model(G * StrictMath.cos(angle));
        model.across = G * StrictMath.sin(angle);
        model.friction = mu;
        int box = box(model, 1, 0.5, 1, 0, 0.25);
        model.wall(0, -1, 40, 2);
        ReportScene scene = touching("W17-incline", "box on an incline of 30°, μ = 0.4, 2 s", model, 2, 2, 15);
        scene.point(box, 0, 0).point(box, 0.5, 0.25);
        scene.reference = "s = g (sin α − μ cos α) t² / 2";
        double pull = model.across - mu * model.gravity;
        scene.expected = () -> JointScenes.rows(scene, t -> {
            double s = pull * t * t / 2;
            return new double[] {s, 0.25, s + 0.5, 0.5};
        });
        return scene;
    }

    /** W17d: leaves the smooth wall at about two thirds of its height and goes on along the smooth floor. */
    static ReportScene ladder() {
        double half = 1;
        double thick = 0.02;
        double inertia = (half * half + thick * thick) / 3;
        double angle = 1.1;
        double x = half * StrictMath.cos(angle) + thick * StrictMath.sin(angle);
        double y = half * StrictMath.sin(angle) + thick * StrictMath.cos(angle);
        Model model = new Model(G);
        int bar = model.add(Model.Kind.BOX, new double[] {2 * half, 2 * thick}, 1, inertia, true, 0, x, y, -angle);
        model.wall(9, -1, 20, 2);
        model.wall(-1, 9, 2, 18);
        Ladder exact = new Ladder(half, thick, inertia, G);
        double[] left = exact.leaves(angle, 1e-13);
        ReportScene scene = touching("W17-ladder", "ladder that slips, no friction, 0.6 s", model, 0.6, 3, 15);
        scene.point(bar, half, 0).point(bar, -half, 0);
        scene.energyUnit = model.energy(model.start());
        scene.reference = String.format(java.util.Locale.ROOT,
                "Lagrange's equation in its angle, Dormand–Prince 8(5,3) at 10⁻¹³, off the wall from %.4f s on, found by bisection", left[0]);
        scene.note = "What turns while it slides is of second order in the step with this engine, of first with the other ones.";
        scene.expected = () -> JointScenes.rows(scene, t -> {
            double[] at = exact.place(angle, t, 1e-13);
            double cx = half * StrictMath.cos(at[2]);
            double cy = half * StrictMath.sin(at[2]);
            return new double[] {at[0] + cx, at[1] - cy, at[0] - cx, at[1] + cy};
        });
        return scene;
    }

    /** W18. */
    static ReportScene stack(double heavy) {
        Model model = new Model(G);
        model.friction = 0.5;
        int n = 10;
        for (int k = 0; k < n; k++) {
            box(model, 1, 1, k == n - 1 ? heavy : 1, 0, k + 0.5);
        }
        model.wall(0, -1, 40, 2);
        String title = "stack of ten boxes, the top one " + (int) heavy + " times as heavy, 5 s";
        ReportScene scene = touching("W18-" + (int) heavy, title, model, 5, 5, 15);
        double[] row = new double[4 * n];
        for (int k = 0; k < n; k++) {
            scene.point(k, -0.5, -0.5).point(k, 0.5, 0.5);
            row[4 * k] = -0.5;
            row[4 * k + 1] = k;
            row[4 * k + 2] = 0.5;
            row[4 * k + 3] = k + 1;
        }
        scene.reference = "statics: it stands as it was put";
        scene.note = "Polygons of JBox2D and Box2D as delivered have a skin, and boxes lie 15 mm higher one on another; tuned, they lie flush.";
        scene.expected = () -> JointScenes.rows(scene, t -> row);
        return scene;
    }

    /** W25: rolling. */
    static ReportScene pushed() {
        Model model = new Model(G);
        model.friction = 0.5;
        model.push = 6;
        int disc = disc(model, 1, 0, 0.5);
        model.wall(0, -1, 60, 2);
        ReportScene scene = touching("W25-push", "disc that is pushed and rolls, 2 s", model, 2, 2, 15);
        scene.point(disc, 0, 0).point(disc, 0.5, 0);
        scene.reference = "a = 2 F / 3 m";
        scene.note = "By events, what a force other than gravity drives stays 10⁻⁷ of its size off the ground: an error of 5e-8 m.";
        scene.expected = () -> JointScenes.rows(scene, t -> {
            double x = t * t * 2 * model.push / 6;
            return new double[] {x, 0.5, x + StrictMath.cos(-2 * x) / 2, 0.5 + StrictMath.sin(-2 * x) / 2};
        });
        return scene;
    }

    /** W25: SimBenchmark's rolling, cut to the plane. */
    static ReportScene rollers() {
        int n = 5;
        double mass = 10;
        Model model = new Model(G);
        model.friction = 0.8;
        model.push = 25;
        int box = box(model, 12, 0.2, mass, 0, 1.1);
        for (int k = 0; k < n; k++) {
            disc(model, 1, 2 * k - n + 1, 0.5);
        }
        model.wall(0, -1, 60, 2);
        ReportScene scene = touching("W25-rollers", "plate that is pushed over five rollers, 1 s", model, 1, 2, 15);
        scene.note = "By events, what a force other than gravity drives stays 10⁻⁷ of its size off what it rests on: an error of 1e-7 m.";
        scene.point(box, 0, 0).point(box, 6, 0);
        for (int k = 0; k < n; k++) {
            scene.point(k + 1, 0, 0);
        }
        scene.reference = "a = F / (M + 3 n m / 8), the rollers half as fast";
        double pull = model.push / (mass + 3 * n / 8.0);
        scene.expected = () -> JointScenes.rows(scene, t -> {
            double x = pull * t * t / 2;
            double[] row = new double[4 + 2 * n];
            row[0] = x;
            row[1] = 1.1;
            row[2] = 6 + x;
            row[3] = 1.1;
            for (int k = 0; k < n; k++) {
                row[4 + 2 * k] = 2 * k - n + 1 + x / 2;
                row[5 + 2 * k] = 0.5;
            }
            return row;
        });
        return scene;
    }

    /** W25: SimBenchmark's elastic 666, cut to the plane. */
    static ReportScene elastic(boolean full) {
        int side = full ? 10 : 6;
        Model model = new Model(G);
        model.wall(0, -1, 200, 2);
        for (int k = 0; k < side * side; k++) {
            double x = 1.1 * (k % side) + 0.04 * (k / side % 3);
            model.add(Model.Kind.DISC, new double[] {0.5}, 1, 0.125, true, 1, x, 1.5 + 1.1 * (k / side));
        }
        ReportScene scene = touching("W25-666", "elastic heap of " + side * side + " discs that drops, 5 s", model, 5, 5, 30);
        scene.methods = null;
        scene.cannot = OtherScenes.RESTITUTION;
        scene.energyUnit = model.energy(model.start());
        scene.reference = "conservation of energy: the error is relative, of energy";
        scene.note = "The motion is chaotic, places cannot be compared.";
        return scene;
    }
}
