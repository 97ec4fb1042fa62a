// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Writes the text, all of it from the data. */
final class Markdown {
    private final StringBuilder body = new StringBuilder();
    private final List<String> losses = new ArrayList<>();
    private final List<String> breakdowns = new ArrayList<>();

    void scene(ReportScene scene, Measurement measurement, boolean tolerances) {
        String file = scene.id.toLowerCase(Locale.ROOT);
        line("### " + scene.id + ": " + scene.title);
        line("");
        line("Reference: " + scene.reference + "." + (scene.note.isEmpty() ? "" : " " + scene.note));
        line("");
        line("![error over CPU time](plots/" + file + ".png)");
        if (tolerances) {
            line("![error over tolerance](plots/" + file + "-tolerance.png)");
        }
        line("");
        table(measurement);
        line("");
        line(verdict(scene, measurement));
        missing(scene, measurement);
        line("");
        measurement.points.forEach((curve, points) -> {
            if (curve.isOwn()) {
                lookForBreakdown(scene, curve, points);
            }
        });
    }

    /** Notes where a finer setting of our own makes the error much worse. */
    private void lookForBreakdown(ReportScene scene, Curve curve, List<Point> points) {
        Point best = null;
        Point worse = null;
        for (Point point : points) {
            if (best == null || point.error < best.error) {
                best = point;
                worse = null;
            } else if (point.error > 1e3 * best.error && point.error > 1e-6 && (worse == null || point.error > worse.error)) {
                worse = point;
            }
        }
        if (worse != null) {
            breakdowns.add("* " + scene.id + ", " + curve.method() + ": error " + number(best.error) + " at "
                    + setting(scene, curve, best.setting) + ", but " + number(worse.error) + " at " + setting(scene, curve, worse.setting));
        }
    }

    private static String setting(ReportScene scene, Curve curve, double setting) {
        return curve.isAdaptive() ? "tolerance " + number(setting) : "step " + number(scene.duration / scene.samples / setting);
    }

    private void line(String text) {
        body.append(text).append('\n');
    }

    private void table(Measurement measurement) {
        line("| CPU s for a simulated s | 1e-3 | 1e-6 | 1e-9 | 1e-12 | best error | energy | gap, m | penetration, m |");
        line("| --- | --- | --- | --- | --- | --- | --- | --- | --- |");
        measurement.points.forEach((curve, points) -> {
            if (points.isEmpty()) {
                return;
            }
            StringBuilder row = new StringBuilder("| " + curve.name());
            for (double target : Profile.TARGETS) {
                double time = Profile.time(points, target);
                row.append(" | ").append(Double.isFinite(time) ? number(time) : "never");
            }
            Point best = points.get(0);
            for (Point point : points) {
                best = point.error < best.error ? point : best;
            }
            row.append(" | ").append(number(best.error)).append(" | ").append(number(best.energy));
            row.append(" | ").append(number(best.gap)).append(" | ").append(number(best.penetration)).append(" |");
            line(row.toString());
        });
    }

    static String number(double x) {
        return Double.isNaN(x) ? "–" : x == 0 ? "0" : Double.isInfinite(x) ? "never" : String.format(Locale.ROOT, "%.1e", x);
    }

    /** Who is the fastest at each error, and whether a peer is better than all our methods. */
    private String verdict(ReportScene scene, Measurement measurement) {
        List<String> parts = new ArrayList<>();
        for (double target : Profile.TARGETS) {
            Map<String, Double> engines = new LinkedHashMap<>();
            Map<String, String> with = new LinkedHashMap<>();
            measurement.points.forEach((curve, points) -> {
                double time = Profile.time(points, target);
                if (time < engines.getOrDefault(curve.engine(), Double.POSITIVE_INFINITY)) {
                    engines.put(curve.engine(), time);
                    with.put(curve.engine(), curve.method());
                }
            });
            String at = String.format(Locale.ROOT, "%.0e", target);
            String peer = engines.keySet().stream().filter(e -> !e.equals(Curve.OURS))
                    .min(java.util.Comparator.comparing(engines::get)).orElse(null);
            double own = engines.getOrDefault(Curve.OURS, Double.POSITIVE_INFINITY);
            if (peer == null && Double.isInfinite(own)) {
                parts.add(at + ": nobody");
            } else if (peer == null) {
                parts.add(at + ": only ours (" + with.get(Curve.OURS) + ")");
            } else if (own <= engines.get(peer)) {
                parts.add(String.format(Locale.ROOT, "%s: ours (%s), %.3g times less CPU than %s (%s)",
                        at, with.get(Curve.OURS), engines.get(peer) / own, peer, with.get(peer)));
            } else {
                String how = Double.isInfinite(own) ? "we do not get there"
                        : String.format(Locale.ROOT, "%.3g times less CPU than our best, %s", own / engines.get(peer), with.get(Curve.OURS));
                parts.add(String.format(Locale.ROOT, "%s: **%s is better** (%s), %s", at, peer, with.get(peer), how));
                losses.add("* " + scene.id + " at " + at + ": " + peer + " (" + with.get(peer) + "), " + how);
            }
        }
        return "Least CPU at " + String.join("; ", parts) + ".";
    }

    private void missing(ReportScene scene, Measurement measurement) {
        List<String> out = new ArrayList<>();
        List<String> failed = new ArrayList<>();
        for (String engine : new String[] {"dyn4j", "JBox2D", "Box2D (libGDX)", "MuJoCo", "pymunk"}) {
            String why = scene.cannot.apply(engine);
            if (why != null) {
                out.add(engine + ", " + why);
            }
        }
        measurement.failures.forEach((curve, why) -> failed.add(curve.name() + ": `" + why + "`"));
        if (!out.isEmpty()) {
            line("");
            line("Not in: " + String.join("; ", out) + ".");
        }
        if (!failed.isEmpty()) {
            line("");
            line("Failed at one setting or more: " + String.join("; ", failed) + ".");
        }
        List<String> left = new ArrayList<>();
        measurement.omitted.forEach((curve, from) -> left.add(curve.name() + " from " + setting(scene, curve, from[0]) + " on"));
        if (!left.isEmpty()) {
            line("");
            line("Left out, as a run would take too long: " + String.join(", ", left) + ".");
        }
    }

    String text(String mode, double cap, boolean python, Profile profile, MethodGuide guide, Goals goals, double seconds) {
        StringBuilder text = new StringBuilder();
        text.append("# Speed against error\n\n");
        text.append("Generated, all figures from one run in the setting *").append(mode).append("*, with\n\n```\n");
        text.append("mvn -q -ntp -Pbench test-compile exec:exec -Dbench.main=sim.physics.report.SpeedVsError -Djmh.args=\"")
                .append(mode).append("\"\n```\n\n");
        text.append("`quick` takes some ten minutes, `full` an hour; `python=…` names an interpreter that has mujoco and pymunk, and names of\n"
                + "scenes as further words limit the run. ");
        text.append(String.format(Locale.ROOT, "This run took %.0f s on %d processors with JDK %s%s.%n%n",
                seconds, Runtime.getRuntime().availableProcessors(), System.getProperty("java.version"),
                python ? "" : "; mujoco and pymunk were not there, their curves are missing"));
        text.append("""
                ## How to read it

                A diagram has one curve for each engine and method: the error against an independent reference over the CPU time of
                the stepping thread for a second of simulated time, both logarithmic; lower left is better. A point is a step or,
                for our adaptive methods, a tolerance; their time step is the interval of the outputs only. Times are medians of
                rounds in which all points of all engines take turns in one JVM after a warm-up (those in Python by their own driver,
                with pymunk's steps called one by one from Python). Errors, invariants and counts come from a run of their own that
                is not timed. *Default* are the options as delivered, *tuned* the best we know: 20 + 10 iterations and no restitution
                threshold where that can be set, in JBox2D and Box2D polygons with a skin of half their slop, so that they lie flush,
                MuJoCo's RK4 with loops as stiff as it lets them be. dyn4j's limit of motion per step
                is raised in both, sleeping is off everywhere. Times below are interpolated on the curve; *best error* and the
                invariants beside it belong to the most accurate point: energy relative to the energy of the scene, the widest gap
                of a joint, the deepest penetration, at the instants of comparison. JBox2D and Box2D are in single precision.
                Everything else, momenta and deterministic counts of work too, is in
                [the data](data/speed-vs-error.csv).

                Scenes are numbered by a list of 26. Of these W19 and W26, towers and a catalogue that is judged by eye, are not in,
                nor is W24: agents that collect cans need a program round the engine. Of W23 the copies that are scaled, turned and
                mirrored are tests of the library.

                *Never* means: with no setting whose whole run takes less than CAP s of CPU. Where a method refused a setting, or a
                step was too long for it, the finer ones count and the scene says so. Steps are not made finer where that has long
                ceased to help: an error below 1e-8 that two finer settings do not lessen, or any that three times a quarter of the
                step does not, of a method of first order.

                ## Where a peer is better

                """.replace("CAP", String.valueOf(cap)));
        text.append(losses.isEmpty() ? "At none of the errors 1e-3, 1e-6, 1e-9, 1e-12 on any scene of this run.\n" : String.join("\n", losses) + "\n");
        text.append("\n## Where our own methods break down\n\nFiner settings that are much worse than coarser ones:\n\n");
        text.append(breakdowns.isEmpty() ? "none in this run.\n" : String.join("\n", breakdowns) + "\n");
        text.append("\n## All scenes together\n\n");
        text.append("A problem is a scene with one of the errors 1e-3, 1e-6, 1e-9, 1e-12 that somebody reaches; the profile of Dolan and\n"
                + "Moré (2002) says on which share of the ").append(profile.problems())
                .append(" problems a solver is within a factor of the least CPU time.\nScenes that a peer cannot express count as not solved"
                        + " by it.\n\n![profile](plots/profile.png)\n\n");
        text.append("| solver | fastest | within 2 × | within 10 × | within 100 × | at all |\n| --- | --- | --- | --- | --- | --- |\n");
        for (String solver : profile.solvers()) {
            text.append("| ").append(solver);
            for (double factor : new double[] {1, 2, 10, 100, 1e300}) {
                text.append(String.format(Locale.ROOT, " | %.0f %%", 100 * profile.share(solver, factor)));
            }
            text.append(" |\n");
        }
        text.append(guide.section());
        text.append("\n## Goals\n\n").append(goals.table());
        return text.append("\n## Scenes\n\n").append(body).toString();
    }
}
