// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** The plots. */
final class Charts {
    /** Errors below it are drawn at it. */
    private static final double FLOOR = 1e-16;

    private static final Map<String, Color> COLORS = Map.of(
            "dyn4j", new Color(0xd95f02), "JBox2D", new Color(0xe7298a), "Box2D (libGDX)", new Color(0xa6761d),
            "MuJoCo", new Color(0x666666), "pymunk", new Color(0x9c9c00));

    private static final Color[] OWN = {
        new Color(0x08306b), new Color(0x2171b5), new Color(0x6baed6), new Color(0x00441b), new Color(0x238b45),
        new Color(0x74c476), new Color(0x3f007d), new Color(0x807dba), new Color(0x17becf)
    };

    private static final Marker[] MARKERS = {
        SeriesMarkers.CIRCLE, SeriesMarkers.DIAMOND, SeriesMarkers.SQUARE, SeriesMarkers.TRIANGLE_UP, SeriesMarkers.TRIANGLE_DOWN,
        SeriesMarkers.CROSS
    };

    private final Path folder;

    Charts(Path folder) {
        this.folder = folder;
    }

    /** Error over CPU time. */
    void workPrecision(Measurement measurement, ReportScene scene) throws IOException {
        XYChart chart = chart(scene.id + ": " + scene.title, "CPU seconds for a simulated second",
                scene.expected == null ? "relative error of energy" : scene.unit == 1 ? "error, m" : "error, relative");
        int own = 0;
        for (Map.Entry<Curve, List<Point>> entry : measurement.points.entrySet()) {
            Curve curve = entry.getKey();
            List<Double> x = new ArrayList<>();
            List<Double> y = new ArrayList<>();
            for (Point point : entry.getValue()) {
                if (point.error < 3 && point.cpu > 0) {
                    x.add(point.cpu);
                    y.add(Math.max(FLOOR, point.error));
                }
            }
            if (!x.isEmpty()) {
                style(chart.addSeries(curve.name(), x, y), curve, own);
            }
            own += curve.isOwn() ? 1 : 0;
        }
        save(chart, scene.id.toLowerCase(java.util.Locale.ROOT));
    }

    /** Error over tolerance; whether there was anything to plot. */
    boolean tolerance(Measurement measurement, ReportScene scene) throws IOException {
        XYChart chart = chart(scene.id + ": " + scene.title, "tolerance asked, m", "error got, m");
        int own = 0;
        for (Map.Entry<Curve, List<Point>> entry : measurement.points.entrySet()) {
            Curve curve = entry.getKey();
            List<Double> x = new ArrayList<>();
            List<Double> y = new ArrayList<>();
            for (Point point : entry.getValue()) {
                if (curve.isAdaptive() && point.error < 30) {
                    x.add(point.setting);
                    y.add(Math.max(FLOOR, point.error * scene.unit));
                }
            }
            if (!x.isEmpty()) {
                style(chart.addSeries(curve.name(), x, y), curve, own);
            }
            own += curve.isOwn() ? 1 : 0;
        }
        if (chart.getSeriesMap().isEmpty()) {
            return false;
        }
        XYSeries line = chart.addSeries("error = tolerance", new double[] {1e-13, 1e-3}, new double[] {1e-13, 1e-3});
        line.setLineColor(Color.LIGHT_GRAY);
        line.setMarker(SeriesMarkers.NONE);
        save(chart, scene.id.toLowerCase(java.util.Locale.ROOT) + "-tolerance");
        return true;
    }

    /** Dolan and Moré's profile: a step function for each engine. */
    void profile(Profile profile) throws IOException {
        XYChart chart = chart("Dolan–Moré profile, " + profile.problems() + " problems", "within this factor of the least CPU time",
                "share of the problems");
        chart.getStyler().setYAxisLogarithmic(false).setYAxisMin(0.0).setYAxisMax(1.0);
        int own = 0;
        for (String solver : profile.solvers()) {
            double[][] xy = profile.steps(solver);
            Curve curve = new Curve(solver.startsWith("ours") ? Curve.OURS : solver, solver, solver.startsWith("ours") ? OwnMethod.EXACT_PATHS : null, 1);
            style(chart.addSeries(solver, xy[0], xy[1]), curve, own);
            chart.getSeriesMap().get(solver).setMarker(SeriesMarkers.NONE);
            own += curve.isOwn() ? 1 : 0;
        }
        save(chart, "profile");
    }

    private static XYChart chart(String title, String x, String y) {
        XYChart chart = new XYChartBuilder().width(900).height(560).title(title).xAxisTitle(x).yAxisTitle(y).build();
        chart.getStyler()
                .setLegendPosition(Styler.LegendPosition.OutsideE)
                .setChartBackgroundColor(Color.WHITE);
        chart.getStyler().setXAxisLogarithmic(true).setYAxisLogarithmic(true);
        chart.getStyler().setXAxisDecimalPattern("0E0").setYAxisDecimalPattern("0E0").setMarkerSize(6);
        chart.getStyler().setPlotGridLinesColor(new Color(0xe4e4e4)).setPlotGridLinesStroke(new BasicStroke(0.5f));
        return chart;
    }

    private static void style(XYSeries series, Curve curve, int own) {
        Color color = curve.isOwn() ? OWN[own % OWN.length] : COLORS.get(curve.engine());
        series.setLineColor(color);
        series.setMarkerColor(color);
        boolean dashed = curve.isOwn() ? curve.method().equals("Automatic") : curve.isTuned();
        series.setLineStyle(dashed
                ? new BasicStroke(1.4f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {5, 4}, 0)
                : new BasicStroke(curve.isOwn() ? 2f : 1.4f));
        series.setMarker(curve.isOwn() ? MARKERS[own % MARKERS.length] : dashed ? SeriesMarkers.CROSS : SeriesMarkers.PLUS);
    }

    private void save(XYChart chart, String name) throws IOException {
        BufferedImage drawn = BitmapEncoder.getBufferedImage(chart);
        // a palette: a quarter of the bytes
        BufferedImage image = new BufferedImage(drawn.getWidth(), drawn.getHeight(), BufferedImage.TYPE_BYTE_INDEXED);
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_DITHERING, RenderingHints.VALUE_DITHER_DISABLE);
        graphics.drawImage(drawn, 0, 0, null);
        graphics.dispose();
        ImageIO.write(image, "png", folder.resolve(name + ".png").toFile());
    }
}
