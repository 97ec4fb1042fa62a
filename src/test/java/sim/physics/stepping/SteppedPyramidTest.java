// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** Friction and inelastic impacts hold a pyramid of boxes: a high one must not swing for ever by how its contacts are solved. */
class SteppedPyramidTest {
    private static final double SIDE = 1.1;

    private static Body pyramid(PhysicsEngine engine, int rows, double gap) {
        engine.add(new Gravity(0, -Stepped.G));
        Stepped.ground(engine);
        Body top = null;
        for (int row = 0; row < rows; row++) {
            for (int k = 0; k < rows - row; k++) {
                Body box = new Body(new Rectangle(1, 1)).at(SIDE * (k - 0.5 * (rows - row - 1)), 0.5 + gap + row * (1 + gap));
                top = Stepped.rough(engine.add(box));
            }
        }
        return top;
    }

    @ParameterizedTest
    @CsvSource({"10, 4", "14, 4", "16, 4", "20, 4", "14, 2", "16, 8", "20, 8"})
    void whatIsPutDownStands(int rows, int substeps) {
        PhysicsEngine engine = Stepped.engine(1 / 60.0, substeps);
        Body top = pyramid(engine, rows, 0);
        Stepped.run(engine, 360);
        assertThat(engine.bodies()).filteredOn(b -> !b.isFixed()).allMatch(engine::isAsleep);
        assertThat(top.getX()).isCloseTo(0, within(0.005));
        assertThat(top.getY()).isCloseTo(rows - 0.5, within(0.1 * rows / (substeps * substeps * 4)));
    }

    /** Bricks, each over two of the one below, of which every second course ends with halves, fall on one another from a little above. */
    @ParameterizedTest
    @CsvSource({"20, 10", "24, 16", "30, 20"})
    void wallsStand(int courses, int bricks) {
        PhysicsEngine engine = Stepped.engine(1 / 60.0, 4);
        engine.add(new Gravity(0, -Stepped.G));
        Stepped.ground(engine);
        for (int course = 0; course < courses; course++) {
            double y = 0.51 + 1.01 * course;
            boolean isOdd = course % 2 == 1;
            for (int k = 0; k < bricks; k++) {
                boolean isLast = isOdd && k == bricks - 1;
                Body brick = new Body(new Rectangle(isLast ? 1 : 2, 1)).at(1.01 * (2 * k + (isLast ? 0.5 : isOdd ? 1 : 0)), y);
                Stepped.rough(engine.add(brick));
            }
            if (isOdd) {
                Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(-0.5, y)));
            }
        }
        Stepped.run(engine, 900);
        assertThat(engine.bodies()).filteredOn(b -> !b.isFixed()).allMatch(engine::isAsleep);
        assertThat(Stepped.depth(engine)).isLessThan(1e-2);
    }

    /** Rows fall on one another from a little above. */
    @ParameterizedTest
    @CsvSource({"14, 0.05", "16, 0.05", "20, 0.01"})
    void whatFallsALittleComesToRest(int rows, double gap) {
        PhysicsEngine engine = Stepped.engine(1 / 60.0, 4);
        pyramid(engine, rows, gap);
        Stepped.run(engine, 600);
        assertThat(engine.bodies()).filteredOn(b -> !b.isFixed()).allMatch(engine::isAsleep);
        assertThat(Stepped.depth(engine)).isLessThan(5e-3);
    }
}
