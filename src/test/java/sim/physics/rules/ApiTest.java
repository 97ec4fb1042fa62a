// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.rules;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.GenericArrayType;
import java.lang.reflect.Member;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.lang.reflect.WildcardType;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Each package's summary says what is for authors; and what is for authors takes and returns nothing else. */
class ApiTest {
    private static final Path ROOT = Path.of("src/main/java");
    private static final String ALL = "All public classes here are for authors.";
    private static final String NOTHING = "Nothing here is for authors.";
    private static final String SOME = "<p>For authors:";

    /** What the engine alone calls, of classes that authors name; growing this list is a decision. */
    private static final Map<String, String> FOR_THE_ENGINE = Map.of(
            "Integrator.advance", "authors choose a method, and the engine calls it",
            "State.carry", "what rounding has left of the vectors",
            "State.lag", "vectors that are written when they are asked for",
            "State.placeLog", "queries look again at what has moved",
            "State.setGlance", "the vectors within a step, for listeners",
            "State.setPresence", "the same, and what listeners write",
            "State.touched", "which blocks were written, and how",
            "Boxes.notes", "what detection keeps of bodies beside boxes",
            "CellGrid.update", "many bodies at once",
            "Pairs.setListener", "detection follows the pairs that begin and end");

    private static Map<String, String> summaries() throws IOException {
        Map<String, String> found = new TreeMap<>();
        try (Stream<Path> files = Files.walk(ROOT)) {
            for (Path folder : (Iterable<Path>) files.filter(Files::isDirectory)::iterator) {
                if (!classes(folder).isEmpty()) {
                    Path file = folder.resolve("package-info.java");
                    assertThat(file).exists();
                    found.put(name(folder), Files.readString(file).replaceAll("\n \\* ?", " "));
                }
            }
        }
        return found;
    }

    private static String name(Path file) {
        return ROOT.relativize(file).toString().replace(".java", "").replace('/', '.').replace('\\', '.');
    }

    /** The classes in a folder that have a file of their own. */
    private static List<String> classes(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(f -> f.toString().endsWith(".java") && !f.endsWith("package-info.java")).map(ApiTest::name).toList();
        }
    }

    private static Set<Class<?>> api() throws Exception {
        Set<Class<?>> found = new HashSet<>();
        for (Map.Entry<String, String> each : summaries().entrySet()) {
            String text = each.getValue();
            boolean isAll = text.contains(ALL);
            int at = text.indexOf(SOME);
            assertThat(Stream.of(isAll, text.contains(NOTHING), at >= 0).filter(is -> is)).as(each.getKey()).hasSize(1);
            List<String> names = isAll ? classes(ROOT.resolve(each.getKey().replace('.', '/'))) : at < 0 ? List.of()
                    : Pattern.compile("\\{@link (sim\\.[\\w.]+)}").matcher(text.substring(at)).results().map(r -> r.group(1)).toList();
            for (String name : names) {
                Class<?> one = Class.forName(name);
                assertThat(Modifier.isPublic(one.getModifiers()) || isAll).as(name).isTrue();
                if (Modifier.isPublic(one.getModifiers())) {
                    found.add(one);
                }
            }
        }
        return found;
    }

    @Test
    void whatIsForAuthorsTakesAndReturnsNothingElse() throws Exception {
        Set<Class<?>> api = api();
        assertThat(api).hasSizeGreaterThan(60);
        Set<String> used = new TreeSet<>();
        for (Class<?> one : api) {
            for (Member member : members(one)) {
                for (Class<?> shown : shown(member)) {
                    if (!isApi(shown, api)) {
                        String name = one.getSimpleName() + "." + member.getName();
                        String above = "Integrator." + member.getName();
                        boolean isKnown = sim.physics.motion.Integrator.class.isAssignableFrom(one) && FOR_THE_ENGINE.containsKey(above);
                        assertThat(isKnown || FOR_THE_ENGINE.containsKey(name)).as("%s: %s", name, shown).isTrue();
                        used.add(isKnown ? above : name);
                    }
                }
            }
        }
        assertThat(used).isEqualTo(new TreeSet<>(FOR_THE_ENGINE.keySet()));
    }

    private static boolean isApi(Class<?> shown, Set<Class<?>> api) {
        return !shown.getName().startsWith("sim.physics.")
                || api.contains(shown)
                || shown.getEnclosingClass() != null && shown.isEnum() && api.contains(shown.getEnclosingClass());
    }

    private static List<Member> members(Class<?> one) {
        List<Member> all = new ArrayList<>();
        all.addAll(List.of(one.getDeclaredMethods()));
        all.addAll(List.of(one.getDeclaredConstructors()));
        all.addAll(List.of(one.getDeclaredFields()));
        all.removeIf(m -> m.isSynthetic() || (m.getModifiers() & (Modifier.PUBLIC | Modifier.PROTECTED)) == 0);
        return all;
    }

    private static Set<Class<?>> shown(Member member) {
        Set<Class<?>> found = new HashSet<>();
        if (member instanceof Method method) {
            add(method.getGenericReturnType(), found);
            List.of(method.getGenericParameterTypes()).forEach(type -> add(type, found));
            List.of(method.getExceptionTypes()).forEach(type -> add(type, found));
        } else if (member instanceof Constructor<?> constructor) {
            List.of(constructor.getGenericParameterTypes()).forEach(type -> add(type, found));
        } else {
            add(((Field) member).getGenericType(), found);
        }
        return found;
    }

    private static void add(Type type, Set<Class<?>> found) {
        if (type instanceof Class<?> plain) {
            found.add(plain.isArray() ? plain.getComponentType() : plain);
        } else if (type instanceof GenericArrayType array) {
            add(array.getGenericComponentType(), found);
        } else if (type instanceof ParameterizedType generic) {
            add(generic.getRawType(), found);
            List.of(generic.getActualTypeArguments()).forEach(each -> add(each, found));
        } else if (type instanceof WildcardType wildcard) {
            List.of(wildcard.getUpperBounds()).forEach(each -> add(each, found));
            List.of(wildcard.getLowerBounds()).forEach(each -> add(each, found));
        }
    }
}
