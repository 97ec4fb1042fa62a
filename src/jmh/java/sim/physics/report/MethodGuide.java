// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** For each scene and error the cheapest of our methods that gets there, and with which step or tolerance. */
final class MethodGuide {
    private final List<String> rows = new ArrayList<>();

    /**
     * What to take.
     *
     * @param point null if no method gets there
     */
    record Choice(Curve curve, Point point) {}

    void add(ReportScene scene, Map<Curve, List<Point>> points) {
        StringBuilder row = new StringBuilder("| " + scene.id + ": " + scene.title);
        for (double target : Profile.TARGETS) {
            Choice choice = cheapest(points, target);
            row.append(" | ").append(choice == null ? "none" : cell(scene, choice));
        }
        rows.add(row + " |");
    }

    /** Null if no method of ours reaches the error. */
    static Choice cheapest(Map<Curve, List<Point>> points, double target) {
        Choice best = null;
        for (Map.Entry<Curve, List<Point>> entry : points.entrySet()) {
            Point point = entry.getKey().isOwn() ? cheapest(entry.getValue(), target) : null;
            if (point != null && (best == null || point.cpu < best.point.cpu)) {
                best = new Choice(entry.getKey(), point);
            }
        }
        return best;
    }

    /** The cheapest of the settings from the one on from which finer ones are as good; null if the finest is not. */
    private static Point cheapest(List<Point> coarseToFine, double target) {
        Point best = null;
        for (int k = coarseToFine.size() - 1; k >= 0 && coarseToFine.get(k).error <= target; k--) {
            Point point = coarseToFine.get(k);
            best = best == null || point.cpu < best.cpu ? point : best;
        }
        return best;
    }

    private static String cell(ReportScene scene, Choice choice) {
        Curve curve = choice.curve;
        double setting = choice.point.setting;
        String how;
        if (curve.own() == OwnMethod.EXACT_PATHS) {
            how = "any step";
        } else if (curve.isAdaptive()) {
            how = "tolerance " + String.format(Locale.ROOT, "%.0e", setting);
        } else {
            how = "step " + String.format(Locale.ROOT, "%.2g s", scene.duration / scene.samples / setting);
        }
        return curve.method() + ", " + how + ": " + Markdown.number(choice.point.cpu);
    }

    /** The section, with its heading. */
    String section() {
        StringBuilder text = new StringBuilder("\n## Which method, which step\n\n");
        text.append("The cheapest of our methods at an error, the step or tolerance that it takes, and CPU seconds for a simulated"
                + " second, of\nthe settings that were run: steps are halved, tolerances divided by ten. Finer settings of the"
                + " method are as good, so that the\nfigure is none of luck. *None*: rounding, or the limit of this run, is in the way."
                + " Between impacts paths are exact: any step does.\n\n");
        text.append("| scene | 1e-3 | 1e-6 | 1e-9 | 1e-12 |\n| --- | --- | --- | --- | --- |\n");
        rows.forEach(row -> text.append(row).append('\n'));
        return text.toString();
    }
}
