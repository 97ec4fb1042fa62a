// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.SurfaceFriction;

/** Scenes whose bits are known: the same on every JDK, interpreted or compiled. A JVM of its own runs them by {@link #main}. */
enum GoldenScene {
    /** The gas of Figure 1. */
    GAS(8737119095546984472L, GoldenScene::gas),
    /** Polygons on a rough ground. */
    POLYGONS(4887223604970660957L, GoldenScene::polygons),
    /** Chains of pins in their angles, by one method after the other. */
    CHAINS(-8090058087368616495L, GoldenScene::chains);

    private static final int MOST_MINUTES = 5;

    final long hash;
    private final Supplier<PhysicsEngine> scene;

    GoldenScene(long hash, Supplier<PhysicsEngine> scene) {
        this.hash = hash;
        this.scene = scene;
    }

    /** Runs it and hashes where its bodies are. */
    long run() {
        return Scenes.hash(scene.get());
    }

    private static PhysicsEngine gas() {
        PhysicsEngine engine = Scenes.gas(Scenes.Kind.FIGURE_1, 40, 11);
        run(engine, 400);
        if (engine.getImpacts() <= 100) {
            throw new AssertionError("impacts are " + engine.getImpacts() + ": they should be more than 100");
        }
        return engine;
    }

    private static PhysicsEngine polygons() {
        PhysicsEngine engine = Scenes.gas(Scenes.Kind.POLYGONS, 24, 12);
        engine.add(new SurfaceFriction(0.1));
        for (Body body : engine.bodies()) {
            body.setSurfaceFriction(0.02);
        }
        run(engine, 300);
        return engine;
    }

    private static PhysicsEngine chains() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(new Gravity(0, -9.81));
        engine.setTimeStep(1 / 240.0);
        Scenes.rods(engine, 7, 0);
        for (int k = 0; k < 6; k++) {
            Integrator[] methods = {
                new DormandPrince853(1e-8), new RungeKutta4(), new GraggBulirschStoer(1e-9), new DormandPrince853(1e-2), new Automatic(1e-4),
                new GraggBulirschStoer(1e-3)
            };
            engine.setIntegrator(methods[k]);
            run(engine, 40);
        }
        return engine;
    }

    private static void run(PhysicsEngine engine, int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    /** The known hashes, as text. */
    static List<String> all() {
        return Arrays.stream(values()).map(k -> Long.toString(k.hash)).toList();
    }

    /**
     * Runs all scenes in another JVM.
     *
     * @param command a java command and its options
     * @return the hashes that it found, as text, or what it said
     */
    static List<String> inAnotherJvm(List<String> command) throws Exception {
        Path out = Files.createTempFile("hashes", ".txt");
        List<String> all = new ArrayList<>(command);
        all.addAll(List.of("-cp", System.getProperty("java.class.path"), GoldenScene.class.getName(), out.toString()));
        Path log = Files.createTempFile("jvm", ".txt");
        Process process = new ProcessBuilder(all).redirectErrorStream(true).redirectOutput(log.toFile()).start();
        if (!process.waitFor(MOST_MINUTES, TimeUnit.MINUTES)) {
            process.destroyForcibly();
            return List.of("no answer");
        }
        List<String> found = Files.readAllLines(process.exitValue() == 0 ? out : log);
        Files.delete(out);
        Files.delete(log);
        return found;
    }

    /**
     * Writes the hashes of all scenes to a file.
     *
     * @param args the file
     */
    public static void main(String[] args) throws Exception {
        List<String> found = new ArrayList<>();
        for (GoldenScene scene : values()) {
            found.add(Long.toString(scene.run()));
        }
        Files.write(new File(args[0]).toPath(), found, StandardCharsets.UTF_8);
    }
}
