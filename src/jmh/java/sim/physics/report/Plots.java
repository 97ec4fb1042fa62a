// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.lines.SeriesLines;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** Draws the diagrams of the report. */
final class Plots {
    private static final double FLOOR = 1e-16;

    private Plots() {}

    /** Error over cost: one curve for each contender; ours solid, those of others dashed. */
    static void workPrecision(Scene scene, List<Point> points, Path folder) throws IOException {
        XYChart chart = chart(scene.title(), "CPU seconds per simulated second", "error: " + scene.error());
        draw(chart, points, Point::cost);
        save(chart, folder, scene.id() + "-work-precision");
    }

    /** Error over the tolerance that was asked for. */
    static void honesty(String title, Map<Scene, List<Point>> scenes, Path folder) throws IOException {
        XYChart chart = chart(title, "tolerance asked for", "error got");
        scenes.forEach((scene, points) -> curves(points).forEach((label, curve) -> {
            if (curve.get(0).contender().isAdaptive()) {
                add(chart, scene.id() + " " + label, curve, Point::setting);
            }
        }));
        save(chart, folder, "tolerance");
    }

    /** The share of tasks that a contender has done within a factor of the best one's time. */
    static void profile(Map<String, double[]> ratios, Path folder) throws IOException {
        XYChart chart = chart("share of tasks done within a factor of the best time", "factor", "share");
        chart.getStyler().setYAxisLogarithmic(false).setYAxisMax(1.0).setYAxisMin(0.0);
        ratios.forEach((label, sorted) -> {
            double[] x = new double[sorted.length];
            double[] y = new double[sorted.length];
            int done = 0;
            for (double ratio : sorted) {
                if (ratio < 1e6) {
                    x[done] = ratio;
                    y[done] = (done + 1.0) / sorted.length;
                    done++;
                }
            }
            if (done > 0) {
                XYSeries series = chart.addSeries(
                        label, java.util.Arrays.copyOf(x, done), java.util.Arrays.copyOf(y, done));
                series.setMarker(SeriesMarkers.CIRCLE);
            }
        });
        save(chart, folder, "profile");
    }

    /** Points by contender. */
    static Map<String, List<Point>> curves(List<Point> points) {
        Map<String, List<Point>> curves = new LinkedHashMap<>();
        for (Point p : points) {
            curves.computeIfAbsent(p.contender().label(), k -> new java.util.ArrayList<>()).add(p);
        }
        return curves;
    }

    private static void draw(XYChart chart, List<Point> points, ToDoubleFunction<Point> x) {
        curves(points).forEach((label, curve) -> add(chart, label, curve, x));
    }

    private static void add(XYChart chart, String label, List<Point> curve, ToDoubleFunction<Point> x) {
        List<Point> finite = curve.stream().filter(p -> p.error() < 1e3).toList();
        if (finite.isEmpty()) {
            return;
        }
        double[] xs = finite.stream().mapToDouble(x).toArray();
        double[] ys = finite.stream().mapToDouble(p -> Math.max(FLOOR, p.error())).toArray();
        XYSeries series = chart.addSeries(label, xs, ys);
        boolean ours = finite.get(0).contender().isOurs();
        series.setLineStyle(ours ? SeriesLines.SOLID : SeriesLines.DASH_DASH);
        series.setMarker(ours ? SeriesMarkers.CIRCLE : SeriesMarkers.CROSS);
    }

    private static XYChart chart(String title, String x, String y) {
        XYChart chart = new XYChartBuilder().width(1000).height(640).title(title).xAxisTitle(x).yAxisTitle(y).build();
        chart.getStyler().setXAxisLogarithmic(true).setYAxisLogarithmic(true);
        chart.getStyler().setLegendPosition(Styler.LegendPosition.OutsideE).setMarkerSize(6);
        chart.getStyler().setChartBackgroundColor(java.awt.Color.WHITE);
        return chart;
    }

    private static void save(XYChart chart, Path folder, String name) throws IOException {
        BitmapEncoder.saveBitmap(chart, folder.resolve(name).toString(), BitmapEncoder.BitmapFormat.PNG);
    }
}
