// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Measures anew what docs/speed.md shows: each block of it that begins with a line like {@code $ ChainRun 9 10 100} is that benchmark's
 * output, in a JVM of its own. The page is written after each block, so a run that is ended has not been for nothing.
 *
 * <pre>
 * SpeedPage                 all blocks, about half an hour
 * SpeedPage ChainRun disks  those whose line has one of these words in it
 * </pre>
 */
public final class SpeedPage {
    private static final Path PAGE = Path.of("docs", "speed.md");
    private static final String FENCE = "```";
    private static final String PROMPT = "$ ";

    private SpeedPage() {}

    /**
     * Runs the benchmarks of the page.
     *
     * @param args words that choose among them; none for all
     * @throws IOException if the page cannot be read or written, or a benchmark cannot be started
     * @throws InterruptedException if somebody ends the wait for one
     */
    public static void main(String[] args) throws IOException, InterruptedException {
        List<String> lines = new ArrayList<>(Files.readAllLines(PAGE));
        for (int k = 0; k < lines.size(); k++) {
            String line = lines.get(k);
            if (line.startsWith(PROMPT) && isChosen(line, args)) {
                System.err.println(line);
                List<String> output = run(line.substring(PROMPT.length()).split(" "));
                lines.subList(k + 1, end(lines, k)).clear();
                lines.addAll(k + 1, output);
                Files.write(PAGE, lines);
            }
        }
    }

    private static boolean isChosen(String line, String[] words) {
        boolean chosen = words.length == 0;
        for (String word : words) {
            chosen |= line.contains(word);
        }
        return chosen;
    }

    private static int end(List<String> lines, int begin) {
        int k = begin + 1;
        while (!lines.get(k).equals(FENCE) && !lines.get(k).startsWith(PROMPT)) {
            k++;
        }
        return k;
    }

    private static List<String> run(String[] words) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-XX:+UseSerialGC", "-Djava.awt.headless=true",
                "-cp", System.getProperty("java.class.path"), SpeedPage.class.getPackageName() + "." + words[0]));
        command.addAll(List.of(words).subList(1, words.length));
        Process process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
        String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        if (process.waitFor() != 0) {
            throw new IllegalStateException(String.join(" ", words) + " ended with " + process.exitValue());
        }
        return output.lines().map(String::stripTrailing).filter(line -> !line.isEmpty() && !line.startsWith("#")).toList();
    }
}
