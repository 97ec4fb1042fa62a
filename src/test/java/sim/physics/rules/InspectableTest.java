// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.rules;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** MASON's inspectors call public methods by reflection, which fails for those that a class that is not public declares. */
class InspectableTest {
    private static final Path CLASSES = Path.of("target/classes");

    @Test
    void publicMethodsOfPublicClassesCanBeCalledByReflection() throws IOException, ClassNotFoundException {
        List<Path> files;
        try (Stream<Path> all = Files.walk(CLASSES)) {
            files = all.filter(f -> f.toString().endsWith(".class") && !f.endsWith("package-info.class")).sorted().toList();
        }
        assertThat(files).isNotEmpty();
        List<String> hidden = new ArrayList<>();
        for (Path file : files) {
            String name = CLASSES.relativize(file).toString().replace(file.getFileSystem().getSeparator(), ".");
            Class<?> type = Class.forName(name.substring(0, name.length() - ".class".length()), false, getClass().getClassLoader());
            for (Method method : type.getMethods()) {
                if (Modifier.isPublic(type.getModifiers()) && !Modifier.isPublic(method.getDeclaringClass().getModifiers())) {
                    hidden.add(type.getSimpleName() + "." + method.getName());
                }
            }
        }
        assertThat(hidden).isEmpty();
    }
}
