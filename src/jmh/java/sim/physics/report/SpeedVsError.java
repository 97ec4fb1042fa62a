// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * Regenerates docs/speed-vs-error.md, its data and its plots.
 *
 * <pre>
 * SpeedVsError quick|full [python=interpreter] [docs=folder] [scene …]
 * </pre>
 */
public final class SpeedVsError {
    private String python = "python3";
    private Path docs = Path.of("docs");
    private final List<String> only = new ArrayList<>();

    private SpeedVsError() {}

    /**
     * Makes the report.
     *
     * @param args see above
     * @throws IOException if it cannot be written
     */
    public static void main(String[] args) throws IOException {
        SpeedVsError report = new SpeedVsError();
        String mode = args.length == 0 ? "quick" : args[0];
        if (!mode.equals("quick") && !mode.equals("full")) {
            throw new IllegalArgumentException("setting is " + mode + ": it must be quick or full");
        }
        for (int k = 1; k < args.length; k++) {
            report.option(args[k]);
        }
        report.run(mode);
    }

    private void option(String word) {
        if (word.startsWith("python=")) {
            python = word.substring(7);
        } else if (word.startsWith("docs=")) {
            docs = Path.of(word.substring(5));
        } else {
            only.add(word);
        }
    }

    private void run(String mode) throws IOException {
        boolean full = mode.equals("full");
        double cap = full ? 0.6 : 0.3;
        int rounds = full ? 7 : 3;
        long begun = System.nanoTime();
        List<ReportScene> scenes = Suite.all(full);
        if (!only.isEmpty()) {
            scenes.removeIf(scene -> only.stream().noneMatch(scene.id::startsWith));
        }
        Files.createDirectories(docs.resolve("plots"));
        Files.createDirectories(docs.resolve("data"));
        Charts charts = new Charts(docs.resolve("plots"));
        Markdown text = new Markdown();
        Profile profile = new Profile();
        Goals goals = new Goals();
        MethodGuide guide = new MethodGuide();
        try (PythonPeers peers = new PythonPeers(python);
                Writer data = Files.newBufferedWriter(docs.resolve("data/speed-vs-error.csv"))) {
            data.write("scene,engine,method,setting,value,cpu_s_per_s,error,energy,momentum,gap_m,penetration_m,"
                    + "steps,force_evaluations,impacts,narrow_phase_looks\n");
            Progress progress = new Progress(
                    scenes.stream().mapToDouble(scene -> Measurement.expected(scene, peers, cap, rounds)).toArray());
            for (ReportScene scene : scenes) {
                Measurement measurement = new Measurement(scene, peers, cap);
                measurement.run(rounds, progress);
                write(data, scene, measurement);
                charts.workPrecision(measurement, scene);
                text.scene(scene, measurement, charts.tolerance(measurement, scene));
                profile.add(measurement);
                goals.add(scene, measurement);
                guide.add(scene, measurement.points);
                progress.next();
            }
            progress.end();
            charts.profile(profile);
            double seconds = (System.nanoTime() - begun) * 1e-9;
            Files.writeString(docs.resolve("speed-vs-error.md"), text.text(mode, cap, peers.has("mujoco"), profile, guide, goals, seconds));
        }
    }

    private static void write(Writer data, ReportScene scene, Measurement measurement) throws IOException {
        for (Map.Entry<Curve, List<Point>> entry : measurement.points.entrySet()) {
            Curve curve = entry.getKey();
            for (Point p : entry.getValue()) {
                String steps = curve.isOwn() ? "" : String.valueOf((long) p.setting * scene.samples);
                data.write(String.join(",",
                        scene.id, curve.engine(), "\"" + curve.method() + "\"", curve.isAdaptive() ? "tolerance" : "step",
                        value(curve.isAdaptive() ? p.setting : scene.duration / scene.samples / p.setting),
                        value(p.cpu), value(p.error), value(p.energy), value(p.momentum), value(p.gap), value(p.penetration),
                        count(p, "steps", steps), count(p, "forces", ""), count(p, "impacts", ""), count(p, "looks", "")) + "\n");
            }
        }
    }

    private static String value(double x) {
        return Double.isNaN(x) ? "" : String.format(java.util.Locale.ROOT, "%.4g", x);
    }

    private static String count(Point point, String name, String otherwise) {
        Long count = point.counts.get(name);
        return count == null ? otherwise : count.toString();
    }
}
