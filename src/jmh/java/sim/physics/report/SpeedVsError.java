// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Regenerates docs/speed-vs-error.md, its data and its plots.
 *
 * <pre>
 * mvn -q -ntp -Pbench test-compile exec:exec -Dbench.main=sim.physics.report.SpeedVsError -Djmh.args=quick
 * </pre>
 */
public final class SpeedVsError {
    private SpeedVsError() {}

    /**
     * Runs the report.
     *
     * @param args {@code quick} or {@code full}
     * @throws Exception if files cannot be written
     */
    public static void main(String[] args) throws Exception {
        boolean full = args.length > 0 && args[0].equals("full");
        Path docs = Path.of("docs");
        Files.createDirectories(docs.resolve("plots"));
        Files.createDirectories(docs.resolve("data"));
        Harness harness = new Harness(full ? 1 : 0.15, full ? 60 : 4);
        List<Scene> scenes = List.of(
                RodScenes.of("W02", "a rod swings for 10 s", 1, 10),
                RodScenes.of("W03-2", "two rods for 3 s", 2, 3),
                RodScenes.of("W03-10", "ten rods for 3 s", 10, 3),
                SwingScene.of(full ? 2000 : 100),
                SpringScene.of(),
                BounceScene.of());
        Map<Scene, List<Point>> results = new LinkedHashMap<>();
        int all = scenes.stream().mapToInt(s -> s.contenders().size()).sum();
        int done = 0;
        for (Scene scene : scenes) {
            List<Point> points = new ArrayList<>();
            for (Contender contender : scene.contenders()) {
                points.addAll(harness.measure(scene, contender));
                progress(++done, all, scene.title());
            }
            if (scene.id().startsWith("W02") || scene.id().startsWith("W03")) {
                int rods = scene.id().equals("W02") ? 1 : Integer.parseInt(scene.id().substring(4));
                points.addAll(Python.measure(scene, rods));
            }
            results.put(scene, points);
            Plots.workPrecision(scene, points, docs.resolve("plots"));
        }
        Plots.honesty("what was asked for and what was got", results, docs.resolve("plots"));
        Plots.profile(Costs.ratios(results), docs.resolve("plots"));
        data(results, docs.resolve("data").resolve("speed-vs-error.csv"));
        Files.writeString(docs.resolve("speed-vs-error.md"), new Text(results, full).write());
        System.out.println();
    }

    private static void progress(int done, int all, String title) {
        int width = 30 * done / all;
        System.out.printf("\r[%s%s] %d/%d %-40s", "#".repeat(width), ".".repeat(30 - width), done, all, title);
        System.out.flush();
    }

    private static void data(Map<Scene, List<Point>> results, Path file) throws IOException {
        StringBuilder text = new StringBuilder("scene,engine,method,setting,cpu_per_second,error,energy,gap\n");
        results.forEach((scene, points) -> {
            for (Point p : points) {
                text.append(String.format(
                        Locale.ROOT, "%s,%s,%s,%.6g,%.4g,%.4g,%.4g,%.4g%n",
                        scene.id(), p.contender().engine(), p.contender().method(), p.setting(), p.cost(), p.error(),
                        p.energy(), p.gap()));
            }
        });
        Files.writeString(file, text);
    }
}
