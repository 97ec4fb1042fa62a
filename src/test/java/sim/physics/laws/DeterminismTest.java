// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;

/** The same scene gives the same bits: again, in another JVM, after a checkpoint, beside other engines. */
class DeterminismTest {
    private static void run(PhysicsEngine engine, int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    @ParameterizedTest
    @EnumSource(GoldenScene.class)
    void theSceneHasItsGoldenHash(GoldenScene scene) {
        assertThat(scene.run()).isEqualTo(scene.hash);
    }

    /** Interpreted, compiled by the quick compiler alone, and on the other JDKs from 17 on that are installed beside this one. */
    @Test
    void otherJvmsGiveTheSameBits() throws Exception {
        Path java = Path.of("bin", "java");
        Path home = Path.of(System.getProperty("java.home"));
        List<List<String>> commands = new ArrayList<>();
        commands.add(List.of(home.resolve(java).toString(), "-Xint"));
        commands.add(List.of(home.resolve(java).toString(), "-XX:TieredStopAtLevel=1"));
        try (Stream<Path> others = Files.list(home.getParent())) {
            others.filter(other -> Files.isExecutable(other.resolve(java)) && !isSameFile(other, home))
                    .filter(other -> version(other) >= 17)
                    .forEach(other -> commands.add(List.of(other.resolve(java).toString())));
        }
        for (List<String> command : commands) {
            assertThat(GoldenScene.inAnotherJvm(command)).as("%s", command).isEqualTo(GoldenScene.all());
        }
    }

    private static boolean isSameFile(Path a, Path b) {
        try {
            return a.toRealPath().equals(b.toRealPath());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The feature version that a JDK says it has, 0 if it does not say. */
    private static int version(Path home) {
        try {
            for (String line : Files.readAllLines(home.resolve("release"))) {
                if (line.startsWith("JAVA_VERSION=")) {
                    return Runtime.Version.parse(line.replaceAll(".*=|\"", "")).feature();
                }
            }
            return 0;
        } catch (IOException | IllegalArgumentException e) {
            return 0; // no JDK that we know how to ask
        }
    }

    @Test
    void aRestoredEngineContinuesBitForBit() {
        PhysicsEngine engine = Scenes.gas(Scenes.Kind.POLYGONS, 60, 13);
        run(engine, 137);
        PhysicsEngine restored = Checkpoint.copy(engine);
        for (int k = 0; k < 300; k++) {
            engine.step();
            restored.step();
            assertThat(Scenes.hash(restored)).as("after %d steps", k).isEqualTo(Scenes.hash(engine));
        }
    }

    @Test
    void enginesInManyThreadsDoNotMeet() throws InterruptedException {
        PhysicsEngine alone = Scenes.gas(Scenes.Kind.FIGURE_1, 40, 14);
        run(alone, 300);
        long[] hashes = new long[4];
        Thread[] threads = new Thread[hashes.length];
        for (int k = 0; k < threads.length; k++) {
            int number = k;
            threads[k] = new Thread(() -> {
                PhysicsEngine engine = Scenes.gas(Scenes.Kind.FIGURE_1, 40, 14);
                run(engine, 300);
                hashes[number] = Scenes.hash(engine);
            });
            threads[k].start();
        }
        for (Thread thread : threads) {
            thread.join();
        }
        assertThat(hashes).containsOnly(Scenes.hash(alone));
    }
}
