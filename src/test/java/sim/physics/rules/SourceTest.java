// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.rules;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What holds of the sources and the docs: headers, sizes, the index of equations, the README. */
class SourceTest {
    private static final int FILE_LINES = 500;
    private static final int METHOD_LINES = 60;

    /** Files that may be longer, each with its reason; growing this list is a decision. */
    private static final Map<String, String> LONG_FILES = Map.of(
            "PhysicsEngine.java", "the whole public face of the engine, two thirds of it documentation",
            "Body.java", "bean properties of a body, two thirds of it documentation");

    private static final Pattern METHOD =
            Pattern.compile("^    (?:[a-zA-Z<][^;={}]*)\\)(?: throws [A-Za-z, ]+)? \\{$", Pattern.MULTILINE);

    private static List<Path> sources(String... roots) throws IOException {
        List<Path> all = new java.util.ArrayList<>();
        for (String root : roots) {
            try (Stream<Path> files = Files.walk(Path.of(root))) {
                files.filter(f -> f.toString().endsWith(".java")).sorted().forEach(all::add);
            }
        }
        assertThat(all).isNotEmpty();
        return all;
    }

    @Test
    void everyFileNamesItsLicence() throws IOException {
        for (Path file : sources("src", "examples")) {
            assertThat(Files.readString(file))
                    .as(file.toString())
                    .startsWith("// SPDX-License-Identifier: Apache-2.0\n"
                            + "// SPDX-FileCopyrightText: 2026 The mason-physics authors\n");
        }
    }

    @Test
    void filesAndMethodsAreShort() throws IOException {
        for (Path file : sources("src/main/java", "examples")) {
            List<String> lines = Files.readAllLines(file);
            if (!LONG_FILES.containsKey(file.getFileName().toString())) {
                assertThat(lines.size()).as(file.toString()).isLessThanOrEqualTo(FILE_LINES);
            }
            int start = -1;
            for (int k = 0; k < lines.size(); k++) {
                if (METHOD.matcher(lines.get(k)).find()) {
                    start = k;
                } else if (lines.get(k).equals("    }") && start >= 0) {
                    assertThat(k - start).as("%s:%d", file, start + 1).isLessThanOrEqualTo(METHOD_LINES);
                    start = -1;
                }
            }
        }
    }

    @Test
    void theStepIsReadInOneScreen() throws IOException {
        String source = Files.readString(Path.of("src/main/java/sim/physics/PhysicsEngine.java"));
        for (String method : List.of("    public void step() {", "    private void stepByEvents() {")) {
            int start = source.indexOf(method);
            int end = source.indexOf("\n    }\n", start);
            assertThat(start).as(method).isPositive();
            assertThat(source.substring(start, end).lines().count()).as(method).isLessThanOrEqualTo(40);
        }
    }

    @Test
    void everyEquationIsWhereTheIndexSays() throws IOException {
        Set<Integer> seen = new TreeSet<>();
        for (String line : Files.readAllLines(Path.of("docs/equations.md"))) {
            if (!line.startsWith("| (")) {
                continue;
            }
            String[] cells = line.split("\\|");
            seen.addAll(numbers(cells[1]));
            if (!cells[2].contains("open:")) {
                check(cells[2].replace("`", "").trim(), numbers(cells[1]));
            }
        }
        for (int k = 1; k <= 54; k++) {
            assertThat(seen).contains(k);
        }
    }

    private static void check(String place, Set<Integer> numbers) throws IOException {
        String[] parts = place.split("#");
        Path file = Path.of("src/main/java", parts[0].replace('.', '/') + ".java");
        assertThat(file).exists();
        String source = Files.readString(file);
        assertThat(source).as(place).contains(" " + parts[1] + "(");
        Set<Integer> cited = numbers(source);
        assertThat(cited).as("cited in %s", file).containsAll(numbers);
    }

    /** The numbers in a text like "(5)–(8), (11)". */
    private static Set<Integer> numbers(String text) {
        Set<Integer> found = new TreeSet<>();
        Matcher m = Pattern.compile("\\((\\d+)\\)(?:[–-]\\((\\d+)\\))?").matcher(text);
        while (m.find()) {
            int from = Integer.parseInt(m.group(1));
            int to = m.group(2) == null ? from : Integer.parseInt(m.group(2));
            for (int k = from; k <= to && to <= 54; k++) {
                found.add(k);
            }
        }
        return found;
    }

    @Test
    void theReadmeHasTwoCommandsAndItsLinksLead() throws IOException {
        String readme = Files.readString(Path.of("README.md"));
        String quick = readme.substring(readme.indexOf("## Quick start"), readme.indexOf("## In a model"));
        Matcher blocks = Pattern.compile("```\n(.*?)\n```", Pattern.DOTALL).matcher(quick);
        List<String> commands = blocks.results().map(r -> r.group(1)).toList();
        assertThat(commands)
                .containsExactly(
                        "mvn -q -ntp test-compile exec:java -Dexec.args=\"collisions\"", "mvn -B -ntp verify");
        try (Stream<Path> docs = Stream.concat(Stream.of(Path.of("README.md"), Path.of("examples/README.md")),
                Files.walk(Path.of("docs")).filter(f -> f.toString().endsWith(".md")))) {
            for (Path doc : (Iterable<Path>) docs::iterator) {
                Path folder = doc.toAbsolutePath().getParent();
                Matcher links = Pattern.compile("\\]\\(([^)#:]+)\\)").matcher(Files.readString(doc));
                while (links.find()) {
                    assertThat(folder.resolve(links.group(1))).exists();
                }
            }
        }
    }
}
