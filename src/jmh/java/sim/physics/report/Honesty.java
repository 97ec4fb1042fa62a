// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Whether errors are what tolerances ask for: error over tolerance and {@link Amplification}, by scene and method.
 *
 * <p>Its table alone, of the scenes named, is made with
 *
 * <pre>
 * mvn -q -ntp -Pbench test-compile exec:exec -Dbench.main=sim.physics.report.Honesty -Djmh.args="W03 …"
 * </pre>
 */
public final class Honesty {
    static final double LOW = 0.1;
    static final double HIGH = 10;

    /** An error that references and rounding do not let be told from none. */
    private static final double LOST = 1e-12;

    /** The same in units of the last place of the coordinates. */
    private static final double ROUNDED = 50;

    private static final double LEAST_TOLERANCE = 0.5e-13;
    private static final double CAP = 2;

    private final Map<Verdict, Integer> counts = new EnumMap<>(Verdict.class);
    private final Map<Held.By, Integer> smaller = new EnumMap<>(Held.By.class);

    Honesty() {
        for (Verdict verdict : Verdict.values()) {
            counts.put(verdict, 0);
        }
        for (Held.By by : Held.By.values()) {
            smaller.put(by, 0);
        }
    }

    /** What an error says of a tolerance. */
    enum Verdict {
        WITHIN,
        SMALLER,
        LARGER,
        /** It is lost in rounding. */
        LOST,
        /** So large a tolerance lets errors be as large as the scene, where they grow no more. */
        SCENE
    }

    /** A row of the table. */
    record Row(String what, double low, double high, boolean isMet, Map<Held.By, Integer> smaller) {
        /** What holds the points whose errors are smaller, in words; empty if there are none. */
        String held() {
            List<String> words = new ArrayList<>();
            smaller.forEach((by, count) -> words.add(count + " " + name(by)));
            return String.join(", ", words);
        }
    }

    /**
     * Prints the table of some scenes.
     *
     * @param args how their names begin; all if there is none
     */
    public static void main(String[] args) {
        List<ReportScene> scenes = Suite.all(false);
        Honesty honesty = new Honesty();
        for (ReportScene scene : scenes) {
            boolean asked = args.length == 0 || List.of(args).stream().anyMatch(scene.id::startsWith);
            if (asked && scene.smooth) {
                Measurement measurement = new Measurement(scene, new PythonPeers("none"), CAP);
                measurement.sweepTolerances();
                for (Row row : honesty.add(scene, measurement.points)) {
                    System.out.printf(Locale.ROOT, "%s: %.1e … %.1e %s%n", row.what, row.low, row.high, row.held());
                }
            }
        }
        System.out.println(honesty.summary());
    }

    static Verdict verdict(double error, double tolerance, double grown, double unit) {
        double ratio = error * unit / (tolerance * grown); // tolerances are lengths
        if (error <= LOST) {
            return Verdict.LOST;
        }
        if (tolerance * grown > unit && ratio < LOW) {
            return Verdict.SCENE;
        }
        return ratio < LOW ? Verdict.SMALLER : ratio > HIGH ? Verdict.LARGER : Verdict.WITHIN;
    }

    /** What the spacing of numbers makes of places in a second, far from the origin: case G05. */
    private static double resolution(Model model) {
        double far = 0;
        for (Model.Part part : model.parts) {
            far = Math.max(far, Math.max(Math.abs(part.start()[0]), Math.abs(part.start()[1])));
        }
        return ROUNDED * Math.ulp(far);
    }

    /** Takes the points of a scene; returns a row for each method. */
    List<Row> add(ReportScene scene, Map<Curve, List<Point>> points) {
        List<Row> rows = new ArrayList<>();
        if (!scene.smooth) {
            return rows;
        }
        double grown = new Amplification(scene).measure();
        points.forEach((curve, all) -> {
            if (curve.isAdaptive() && !curve.method().equals("Automatic")) {
                Row row = row(scene, curve, all, grown);
                if (row.high > 0) {
                    rows.add(row);
                }
            }
        });
        return rows;
    }

    private Row row(ReportScene scene, Curve curve, List<Point> points, double grown) {
        double low = Double.POSITIVE_INFINITY;
        double high = 0;
        Map<Held.By, Integer> held = new EnumMap<>(Held.By.class);
        Held why = null;
        for (Point point : points) {
            if (point.setting > LEAST_TOLERANCE) {
                Verdict verdict = point.error * scene.unit <= resolution(scene.model)
                        ? Verdict.LOST : verdict(point.error, point.setting, grown, scene.unit);
                counts.merge(verdict, 1, Integer::sum);
                if (verdict == Verdict.SMALLER) {
                    why = why == null ? new Held(scene, curve) : why;
                    held.merge(why.by(point, grown), 1, Integer::sum);
                }
                if (verdict != Verdict.LOST && verdict != Verdict.SCENE) {
                    double ratio = point.error * scene.unit / (point.setting * grown);
                    low = Math.min(low, ratio);
                    high = Math.max(high, ratio);
                }
            }
        }
        String what = String.format(Locale.ROOT, "%s, %s: error / (tolerance × %.2g)", scene.title, curve.method(), grown);
        held.forEach((by, count) -> smaller.merge(by, count, Integer::sum));
        return new Row(what, low, high, low >= LOW && high <= HIGH, held);
    }

    int count(Verdict verdict) {
        return counts.get(verdict);
    }

    /** Those smaller ones that something else than the tolerance holds. */
    int held() {
        return count(Verdict.SMALLER) - smaller.get(Held.By.NOTHING);
    }

    /** Words for what holds some. */
    private static String name(Held.By by) {
        return switch (by) {
            case NOTHING -> "held by nothing";
            case COARSEST -> "which no coarser tolerance is sure to do for less";
            case STABILITY -> "held by stability";
            case OUTPUT -> "held by the engine's step";
        };
    }

    int counted() {
        return count(Verdict.WITHIN) + count(Verdict.SMALLER) + count(Verdict.LARGER);
    }

    boolean isMet() {
        return count(Verdict.WITHIN) == counted();
    }

    String summary() {
        StringBuilder why = new StringBuilder();
        smaller.forEach((by, count) -> why.append(why.isEmpty() ? "" : ", ").append(count).append(' ').append(name(by)));
        return count(Verdict.WITHIN) + " of " + counted() + ", " + count(Verdict.SMALLER) + " smaller (" + why + "), "
                + count(Verdict.LARGER) + " larger; without those that are held " + count(Verdict.WITHIN) + " of "
                + (counted() - held()) + "; not counted: " + count(Verdict.SCENE)
                + " where the tolerance allows errors as large as the scene, " + count(Verdict.LOST) + " lost in rounding";
    }
}
