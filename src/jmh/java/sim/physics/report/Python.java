// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import sim.physics.references.RodChain;

/** MuJoCo and Chipmunk by a Python that has them: {@code REPORT_PYTHON}, or python3. */
final class Python {
    private Python() {}

    /** The points of a chain; none if there is no such Python. */
    static List<Point> measure(Scene scene, int rods) throws IOException, InterruptedException {
        double[] tip = RodChain.tip(rods, scene.seconds());
        String python = System.getenv().getOrDefault("REPORT_PYTHON", "python3");
        List<String> command = new ArrayList<>(List.of(
                python, "src/jmh/python/rods.py", "" + rods, "" + scene.seconds(), "" + tip[0], "" + tip[1]));
        for (double step : Methods.STEPS) {
            command.add("" + step);
        }
        List<Point> points = new ArrayList<>();
        Process process;
        try {
            process = new ProcessBuilder(command)
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start();
        } catch (IOException e) {
            return points; // no Python here
        }
        for (String line : new String(process.getInputStream().readAllBytes()).split("\\R")) {
            String[] part = line.split(",");
            if (part.length == 7) {
                Contender contender = new Contender(part[0], part[1], false, Methods.STEPS, null);
                double[] v = new double[5];
                for (int k = 0; k < v.length; k++) {
                    v[k] = Double.parseDouble(part[k + 2].replace("nan", "NaN"));
                }
                points.add(new Point(scene, contender, v[0], v[1], v[2], v[3], v[4]));
            }
        }
        process.waitFor();
        return points;
    }
}
