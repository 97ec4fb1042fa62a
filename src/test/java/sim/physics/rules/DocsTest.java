// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.rules;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sim.engine.SimState;

/** What the docs show to users compiles with what they import, runs, and names what there is. */
class DocsTest {
    private static final Pattern JAVA = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL);
    private static final Pattern CLASS = Pattern.compile("public class (\\w+) extends SimState");

    /** Names in the docs that are not this library's. */
    private static final Set<String> FOREIGN = Set.of(
            "Model", "SimState", "Serializable", "Continuous2D", "ForkJoinPool", "writeToCheckpoint", "readFromCheckpoint");

    @TempDir
    Path folder;

    private static List<String> blocks(String doc) throws IOException {
        return JAVA.matcher(Files.readString(Path.of(doc)))
                .results()
                .map(found -> found.group(1))
                .toList();
    }

    @Test
    void everyJavaBlockCompilesAndRuns() throws Exception {
        List<String> manual = blocks("docs/manual.md");
        String imports = manual.get(0);
        assertThat(imports.lines()).allMatch(line -> line.startsWith("import "));
        List<String> models = new ArrayList<>();
        for (String block : manual.subList(1, manual.size())) {
            models.add(imports + model(block));
        }
        models.addAll(blocks("README.md"));
        models.addAll(blocks("examples/README.md"));
        assertThat(models).hasSizeGreaterThan(3);
        for (int k = 0; k < models.size(); k++) {
            run(models.get(k), Files.createDirectory(folder.resolve("block" + k)));
        }
    }

    /** A block of the manual, members or statements, in the model that it is part of. */
    private static String model(String block) {
        boolean isMembers = block.contains("void start()");
        String start = "public void start() {\nsuper.start();\nphysics = new PhysicsEngine();\n";
        String members = isMembers ? block : start + block + "physics.scheduleOn(schedule);\n}\n";
        return "public class Model extends SimState {\nPhysicsEngine physics;\n"
                + "public Model(long seed) { super(seed); }\n" + members + "}\n";
    }

    private void run(String source, Path place) throws Exception {
        Matcher name = CLASS.matcher(source);
        assertThat(name.find()).as(source).isTrue();
        Path file = place.resolve(name.group(1) + ".java");
        Files.writeString(file, source);
        int result = ToolProvider.getSystemJavaCompiler()
                .run(null, null, null, "-cp", System.getProperty("java.class.path"), "-proc:none", "-nowarn", file.toString());
        assertThat(result).as(source).isZero();
        try (URLClassLoader loader = new URLClassLoader(new URL[] {place.toUri().toURL()}, getClass().getClassLoader())) {
            SimState model = (SimState)
                    loader.loadClass(name.group(1)).getConstructor(long.class).newInstance(1L);
            model.start();
            for (int k = 0; k < 100; k++) {
                assertThat(model.schedule.step(model)).as(source).isTrue();
            }
            model.finish();
        }
    }

    /** The names that the docs print as code and that look like those of classes and methods. */
    @Test
    void whatTheManualNamesExists() throws IOException {
        StringBuilder text = new StringBuilder();
        Set<String> known = new TreeSet<>(FOREIGN);
        try (Stream<Path> files = Files.walk(Path.of("src/main/java"))) {
            for (Path file : (Iterable<Path>) files.filter(f -> f.toString().endsWith(".java"))::iterator) {
                known.add(file.getFileName().toString().replace(".java", ""));
                text.append(Files.readString(file));
            }
        }
        String sources = text.toString();
        for (String doc : List.of("README.md", "docs/manual.md")) {
            String prose = JAVA.matcher(Files.readString(Path.of(doc))).replaceAll("");
            List<String> code = Pattern.compile("`([^`\n]+)`").matcher(prose).results().map(r -> r.group(1)).toList();
            for (String span : code) {
                assertThat(known).as("%s: `%s`", doc, span).containsAll(names(span, "\\b([A-Z][a-z]\\w+)(?=[.(]|$| )"));
                assertThat(names(span, "\\b([a-z]\\w+)\\("))
                        .as("%s: `%s`", doc, span)
                        .allMatch(m -> FOREIGN.contains(m) || sources.contains(" " + m + "("));
            }
        }
    }

    private static Set<String> names(String span, String pattern) {
        return Pattern.compile(pattern)
                .matcher(span)
                .results()
                .map((MatchResult found) -> found.group(1))
                .collect(Collectors.toSet());
    }
}
