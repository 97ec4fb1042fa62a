// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/** MuJoCo and pymunk, where Python has them. */
final class PythonPeers implements AutoCloseable {
    private static final String DRIVER = "src/jmh/python/peers.py";

    private Process process;
    private Writer tasks;
    private BufferedReader answers;
    private String engines = "";

    PythonPeers(String python) {
        try {
            process = new ProcessBuilder(python, DRIVER).redirectError(ProcessBuilder.Redirect.INHERIT).start();
            tasks = process.outputWriter(StandardCharsets.UTF_8);
            answers = process.inputReader(StandardCharsets.UTF_8);
            String first = answers.readLine();
            engines = first == null ? "" : first;
        } catch (IOException none) {
            engines = "";
        }
    }

    boolean has(String engine) {
        return engines.contains(engine.toLowerCase(Locale.ROOT));
    }

    /** Runs a scene; CPU seconds. */
    double run(Curve curve, ReportScene scene, double setting, double[][] states) {
        double dt = scene.duration / scene.samples / setting;
        String task = "{\"engine\":\"" + curve.engine().toLowerCase(Locale.ROOT) + "\",\"tuned\":" + curve.isTuned() + ",\"dt\":" + dt
                + ",\"steps\":" + (int) setting + ",\"samples\":" + scene.samples + ",\"read\":" + (states != null)
                + ",\"scene\":" + scene.model.json() + "}\n";
        try {
            tasks.write(task);
            tasks.flush();
            String answer = answers.readLine();
            if (answer == null || answer.startsWith("error")) {
                throw new IllegalStateException(String.valueOf(answer));
            }
            String[] words = answer.split(" ");
            int at = 1;
            for (int k = 0; states != null && k < states.length; k++) {
                for (int c = 0; c < states[k].length; c++) {
                    states[k][c] = Double.parseDouble(words[at++].replace("nan", "NaN").replace("inf", "Infinity"));
                }
            }
            return Double.parseDouble(words[0]);
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }

    @Override
    public void close() {
        if (process != null) {
            process.destroy();
        }
    }
}
