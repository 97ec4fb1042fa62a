// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import demos.collisions.Collisions;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sim.engine.SimState;
import sim.physics.Scenes;

/** A model restored from MASON's checkpoint continues bit for bit. */
class CheckpointTest {
    private static Collisions model() {
        Collisions model = new Collisions(7);
        model.setCircles(20);
        model.setRectangles(20);
        model.setSize(5);
        model.start();
        return model;
    }

    private static void run(Collisions model, int steps) {
        for (int k = 0; k < steps; k++) {
            model.schedule.step(model);
        }
    }

    @Test
    void theCollisionsDemoContinuesFromAFile(@TempDir Path folder) {
        Collisions straight = model();
        run(straight, 400);
        Collisions first = model();
        run(first, 150);
        java.io.File file = folder.resolve("collisions.checkpoint").toFile();
        first.writeToCheckpoint(file);
        Collisions restored = (Collisions) SimState.readFromCheckpoint(file);
        run(restored, 250);
        assertThat(restored.physics.getImpacts()).isEqualTo(straight.physics.getImpacts()).isGreaterThan(100);
        assertThat(Scenes.hash(restored.physics)).isEqualTo(Scenes.hash(straight.physics));
    }

    @Test
    void aRestartIsAFreshWorld() {
        Collisions model = model();
        run(model, 100);
        long first = Scenes.hash(model.physics);
        model.finish();
        model.setSeed(7);
        model.start();
        run(model, 100);
        assertThat(Scenes.hash(model.physics)).isEqualTo(first);
    }

    @Test
    void frictionAndRestitutionTakeEffectAtOnce() {
        Collisions model = model();
        run(model, 20);
        double energy = model.getKineticEnergy();
        run(model, 20);
        assertThat(model.getKineticEnergy()).isCloseTo(energy, org.assertj.core.api.Assertions.within(1e-11 * energy));
        model.setCoefficientOfFriction(0.5);
        run(model, 200);
        assertThat(model.getKineticEnergy()).isZero();
    }
}
