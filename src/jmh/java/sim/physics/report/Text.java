// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Writes the report's text around its figures. */
final class Text {
    private final Map<Scene, List<Point>> results;
    private final boolean full;
    private final StringBuilder out = new StringBuilder();

    Text(Map<Scene, List<Point>> results, boolean full) {
        this.results = results;
        this.full = full;
    }

    String write() {
        out.append(HEAD.formatted(
                full ? "full" : "quick",
                Runtime.getRuntime().availableProcessors(),
                System.getProperty("java.version")));
        results.forEach(this::scene);
        out.append("\n## Tolerance asked for, error got\n\n![tolerance](plots/tolerance.png)\n\n");
        honesty();
        out.append("\n## All tasks together\n\nA task is an error of 1e-3, 1e-6, 1e-9 or 1e-12 in a scene. The share of tasks "
                + "that a method has\ndone within a factor of the time of the best one (Dolan and Moré 2002):\n\n"
                + "![profile](plots/profile.png)\n");
        out.append(TAIL);
        return out.toString();
    }

    private void scene(Scene scene, List<Point> points) {
        out.append("\n## ").append(scene.id()).append(": ").append(scene.title()).append("\n\n");
        out.append("![").append(scene.id()).append("](plots/").append(scene.id()).append("-work-precision.png)\n\n");
        out.append("CPU time per simulated second at an error of (").append(scene.error()).append("):\n\n");
        out.append("| | 1e-3 | 1e-6 | 1e-9 | 1e-12 | least error | energy there | joint gap there |\n");
        out.append("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
        Map<String, List<Point>> curves = Plots.curves(points);
        curves.forEach((label, curve) -> {
            out.append("| ").append(label);
            for (double error : Costs.ERRORS) {
                out.append(" | ").append(time(Costs.at(error, curve)));
            }
            Point best = curve.get(0);
            for (Point p : curve) {
                best = p.error() < best.error() ? p : best;
            }
            out.append(" | ").append(number(best.error()));
            out.append(" | ").append(number(Math.abs(best.energy())));
            out.append(" | ").append(number(best.gap())).append(" |\n");
        });
        verdict(curves);
    }

    /** Says who is best at each error, of ours and of the others. */
    private void verdict(Map<String, List<Point>> curves) {
        List<String> lines = new ArrayList<>();
        if (curves.values().stream().allMatch(c -> c.get(0).contender().isOurs())) {
            return; // no other engine ran this scene
        }
        for (double error : Costs.ERRORS) {
            String ours = best(curves, error, true);
            String theirs = best(curves, error, false);
            if (ours == null && theirs == null) {
                continue;
            }
            if (theirs == null) {
                lines.add(String.format(Locale.ROOT, "At %.0e only %s of ours gets there.", error, ours));
            } else if (ours == null) {
                lines.add(String.format(Locale.ROOT, "At %.0e %s gets there and we do not.", error, theirs));
            } else {
                double ratio = Costs.at(error, curves.get(theirs)) / Costs.at(error, curves.get(ours));
                lines.add(String.format(
                        Locale.ROOT, ratio >= 1 ? "At %.0e %s takes %s the time of %s."
                                : "At %.0e **%s is better**: it takes %s the time of our %s.",
                        error, theirs, times(ratio), ours));
            }
        }
        out.append("\n").append(String.join("\n", lines)).append("\n");
    }

    private static String times(double ratio) {
        return String.format(Locale.ROOT, ratio >= 10 ? "%.0f times" : "%.1f times", ratio);
    }

    private static String best(Map<String, List<Point>> curves, double error, boolean ours) {
        String best = null;
        double least = Double.POSITIVE_INFINITY;
        for (Map.Entry<String, List<Point>> e : curves.entrySet()) {
            double cost = Costs.at(error, e.getValue());
            if (e.getValue().get(0).contender().isOurs() == ours && cost < least) {
                least = cost;
                best = e.getKey();
            }
        }
        return best;
    }

    private void honesty() {
        out.append("Error over tolerance, least and largest over tolerances of 1e-3 to 1e-12:\n\n| scene | method | least | largest |\n");
        out.append("| --- | --- | --- | --- |\n");
        results.forEach((scene, points) -> Plots.curves(points).forEach((label, curve) -> {
            if (curve.get(0).contender().isAdaptive()) {
                double least = Double.POSITIVE_INFINITY;
                double most = 0;
                for (Point p : curve) {
                    if (p.setting() > 2e-13) {
                        least = Math.min(least, p.error() / p.setting());
                        most = Math.max(most, p.error() / p.setting());
                    }
                }
                out.append("| ").append(scene.id()).append(" | ").append(label);
                out.append(" | ").append(number(least)).append(" | ").append(number(most)).append(" |\n");
            }
        }));
    }

    private static String number(double value) {
        return Double.isNaN(value) ? "" : value == Double.POSITIVE_INFINITY ? "fails" : String.format(Locale.ROOT, "%.1e", value);
    }

    private static String time(double seconds) {
        return seconds == Double.POSITIVE_INFINITY ? "never"
                : seconds < 1e-3 ? String.format(Locale.ROOT, "%.1f µs", 1e6 * seconds)
                : String.format(Locale.ROOT, "%.2f ms", 1e3 * seconds);
    }

    private static final String HEAD = """
            # Speed against error

            What a right digit costs: CPU time of one thread per simulated second, against the error at the end, for this engine's
            methods and for others. Written by the %s report on %d shared cores, Java %s; regenerate it, its
            [data](data/speed-vs-error.csv) and its plots with

            ```
            mvn -q -ntp -Pbench test-compile exec:exec -Dbench.main=sim.physics.report.SpeedVsError -Djmh.args=quick
            ```

            or `full`. A Python with MuJoCo and pymunk (`REPORT_PYTHON`, else `python3`) adds those engines.

            * Every point is the median CPU time of runs after warm-up, with the set-up of the scene left out.
            * References are independent of the engine: elliptic functions, Lagrange's equations in angles by another library's
              extrapolation method, closed forms, and an event simulation of its own (`src/test/java/sim/physics/references`).
            * Fixed-step methods and all other engines run at steps of 1/30 to 1/4000, adaptive methods at tolerances of 1e-3 to
              1e-13, with one output at the end (W01: every half second). dyn4j and JBox2D run with their default iterations and
              with 50; sleeping is off; links do not collide with each other in any engine. Chipmunk is called step by step
              from Python, which is part of its time; MuJoCo makes all steps in one call, without contacts.
            * Columns of energy are relative to the scene's depth; 1e-16 in a plot stands for no error.
            """;

    private static final String TAIL = """

            ## Which method for which scene

            * **You do not know, or parts are stiff:** `new Automatic(tolerance)`. It costs what Dormand-Prince costs, and goes over to
              Radau IIA where a spring, a damper or a heavy load would hold its steps small.
            * **Five to ten digits, smooth forces, joints:** `new DormandPrince853(tolerance)`; **ten to thirteen:**
              `new GraggBulirschStoer(tolerance)`. Let the engine's time step be as long as your model allows: it only says when
              agents act and the state is published.
            * **A fixed step, as MASON models have it:** `RungeKutta4`, the default.
            * **Very long runs without friction or damping:** `new Rattle(4)`: its energy swings and does not drift.
            * **Free bodies that only collide** need no method: their motion is exact whatever is chosen.
            * **Euler** is there because the write-up has it.
            """;
}
