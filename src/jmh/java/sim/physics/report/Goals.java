// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** What the project wants to reach, beside what this run says. */
final class Goals {
    private static final double[] CHAIN_TARGETS = {1e-4, 1e-6, 1e-8, 1e-10, 1e-12};

    private final Map<String, Measurement> scenes = new LinkedHashMap<>();
    private final Map<String, ReportScene> about = new LinkedHashMap<>();
    private final Honesty honesty = new Honesty();
    private final List<Honesty.Row> ratios = new ArrayList<>();
    private final StringBuilder rows = new StringBuilder();

    void add(ReportScene scene, Measurement measurement) {
        scenes.put(scene.id, measurement);
        about.put(scene.id, scene);
        ratios.addAll(honesty.add(scene, measurement.points));
    }

    String table() {
        rows.append("| goal | this run | met |\n| --- | --- | --- |\n");
        within("W01", 1e-9, 0.25 / 2000, 2000);
        within("W03-10-3", 1e-12, 0.012 / 3, 3);
        within("W05-40", 1e-10, Double.POSITIVE_INFINITY, 20);
        within("W06", 1e-12, Double.POSITIVE_INFINITY, 0.03);
        for (double target : CHAIN_TARGETS) {
            ahead("W03-10-3", target, "MuJoCo", "RK4", 10);
        }
        for (String peer : new String[] {"dyn4j", "JBox2D"}) {
            ahead("W03-10-1", 1e-3, peer, "", 100);
        }
        for (Honesty.Row row : ratios) {
            row(row.what(), Markdown.number(row.low()) + " … " + Markdown.number(row.high()),
                    row.isMet() ? "yes" : row.held().isEmpty() ? "**no**" : "**no**: " + row.held());
        }
        if (honesty.counted() > 0) {
            row("error / (tolerance × amplification) within 0.1 … 10, tolerances of all these", honesty.summary(),
                    honesty.isMet() ? "yes" : "**no**");
        }
        return rows + "\nThe amplification is that of small errors on the way, as pairs of runs with one of them measure it: errors at"
                + "\nrandom in every unit of the scene's own time, and again the same ones where the motion comes back to a state, as those"
                + "\nof steps are (class Amplification of the report). A smaller error than the tolerance asks for is a *no* here, too; what"
                + "\nholds it is told where no coarser tolerance, in quarters of a decade, is sure to be cheaper (class Held).\n";
    }

    private double least(String id, double target, String engine, String method) {
        double least = Double.POSITIVE_INFINITY;
        for (Map.Entry<Curve, List<Point>> entry : scenes.get(id).points.entrySet()) {
            if (entry.getKey().engine().equals(engine) && entry.getKey().method().startsWith(method)) {
                least = Math.min(least, Profile.time(entry.getValue(), target));
            }
        }
        return least;
    }

    private void within(String id, double target, double limit, double duration) {
        if (!scenes.containsKey(id)) {
            return;
        }
        double time = least(id, target, Curve.OURS, "");
        String asked = Double.isInfinite(limit) ? "" : String.format(Locale.ROOT, " in %.1e CPU s for a simulated s", limit);
        row(about.get(id).title + ": " + Markdown.number(target) + asked, Markdown.number(time), time <= limit && Double.isFinite(time)
                ? about.get(id).duration < duration ? "not asked: the goal is for " + (int) duration + " s, see full" : "yes" : "**no**");
    }

    private void ahead(String id, double target, String peer, String method, double factor) {
        if (!scenes.containsKey(id)) {
            return;
        }
        double own = least(id, target, Curve.OURS, "");
        double other = least(id, target, peer, method);
        if (Double.isInfinite(own) && Double.isInfinite(other)) {
            return;
        }
        String got = Double.isInfinite(other) ? peer + " never, ours " + Markdown.number(own)
                : String.format(Locale.ROOT, "%.3g times", other / own);
        row(String.format(Locale.ROOT, "%s: %.0e with %.0f times less CPU than %s %s",
                about.get(id).title, target, factor, peer, method).trim(), got, other >= factor * own ? "yes" : "**no**");
    }

    private void row(String goal, String got, String met) {
        rows.append("| ").append(goal).append(" | ").append(got).append(" | ").append(met).append(" |\n");
    }
}
