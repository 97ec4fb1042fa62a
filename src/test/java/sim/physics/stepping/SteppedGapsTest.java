// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Floors with gaps that are narrower than what slides over them, under time stepping: the edge beyond a gap is as high as the one before it. */
class SteppedGapsTest {
    private static PhysicsEngine floor(double gap, double friction, int substeps) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
        engine.add(new Gravity(0, -Stepped.G));
        for (int k = 0; k < 6; k++) {
            Body plate = Stepped.rough(engine.add(Body.fixed(new Rectangle(5, 0.4)).at(2.5 + k * (5 + gap), -0.2)));
            plate.setFriction(friction);
        }
        return engine;
    }

    /** Without friction nothing slows what slides. It was stopped by the first edge beyond a gap, and tripped. */
    @ParameterizedTest
    @CsvSource({"0.05, 4, 4", "0.2, 4, 4", "0.2, 4, 16", "0.2, 0.5, 4", "0.3, 15, 4", "0.2, 0.05, 4"})
    void whatSlidesGoesOnOverGaps(double gap, double speed, int substeps) {
        for (Shape shape : new Shape[] {new Rectangle(0.8, 0.6), new Rectangle(1.6, 0.1), new Polygon(-0.5, 0, 0.5, 0, 0, 0.4)}) {
            for (int phase = 0; phase < 10; phase++) {
                PhysicsEngine engine = floor(gap, 0, substeps);
                double height = shape.vertexCount() == 3 ? 0.4 / 3 : ((Rectangle) shape).height() / 2;
                Body body = Stepped.rough(engine.add(new Body(shape).at(4.1 - 0.1 * speed - 0.01 * phase, height)));
                Stepped.run(engine, 20);
                body.setVelocity(speed, 0);
                Stepped.run(engine, (int) Math.min(240, 60 * 16 / speed));
                assertThat(body.getVelocityX()).as("%s, phase %s", shape, phase).isCloseTo(speed, within(1e-3 * speed));
                assertThat(body.getY()).isCloseTo(height, within(5e-3));
            }
        }
    }

    /** The same over bodies that lie side by side, with gaps or without. */
    @ParameterizedTest
    @CsvSource({"0, 4", "0.02, 4", "0.1, 4", "0.1, 16"})
    void whatSlidesGoesOnOverBodies(double gap, int substeps) {
        for (int phase = 0; phase < 10; phase++) {
            PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
            engine.add(new Gravity(0, -Stepped.G));
            Stepped.ground(engine).at(0, -1.5);
            for (int k = 0; k < 8; k++) {
                Stepped.rough(engine.add(new Body(new Rectangle(2, 0.5)).at(k * (2 + gap), -0.25))).setMass(50);
            }
            Body box = engine.add(new Body(new Rectangle(0.8, 0.6)).at(0.02 * phase, 0.3));
            box.setRestitution(0);
            box.setMass(0.5);
            Stepped.run(engine, 60);
            box.setVelocity(4, 0);
            Stepped.run(engine, 180);
            assertThat(box.getVelocityX()).as("phase %s", phase).isCloseTo(4, within(5e-3));
        }
    }

    /** A box that one belt hands to the next is as fast as the one that bears more than half of it. It stopped at the second one, and went on only when it had jumped. */
    @ParameterizedTest
    @CsvSource({"1", "4", "16"})
    void aBeltHandsABoxToTheNext(int substeps) {
        PhysicsEngine engine = floor(0.2, 0.7, substeps);
        for (int k = 0; k < 6; k++) {
            engine.bodies().get(k).setBeltSpeed(-1 - 0.3 * k);
        }
        Body box = Stepped.rough(engine.add(new Body(new Rectangle(0.8, 0.6)).at(1, 0.3)));
        box.setFriction(0.7);
        box.moving(1, 0);
        double slowest = 1;
        for (int k = 0; k < 900; k++) {
            engine.step();
            slowest = Math.min(slowest, box.getVelocityX());
        }
        assertThat(slowest).isGreaterThan(0.98);
        assertThat(Math.abs(box.getAngle())).isLessThan(0.01);
        // 4 m on the first belt, 5.2 on the next ones; where it changes is anywhere within its length and the gap
        double time = 15 - 4 / 1.0 - 5.2 / 1.3 - 5.2 / 1.6;
        assertThat(box.getX()).isCloseTo(5 + 2 * 5.2 + 1.9 * time, within(1.0));
    }

    /** A kerb is one all the same: one of a hundredth of the box's width stops it. */
    @Test
    void aLowKerbStopsABox() {
        PhysicsEngine engine = floor(0.2, 0, 4);
        engine.add(Body.fixed(new Rectangle(5, 0.41)).at(2.5 + 5.2, -0.195)).setRestitution(0);
        Body box = Stepped.rough(engine.add(new Body(new Rectangle(0.8, 0.6)).at(2, 0.3)));
        Stepped.run(engine, 20);
        box.setVelocity(0.5, 0);
        Stepped.run(engine, 360);
        assertThat(box.getX() + 0.4).isBetween(5.0, 5.21);
    }
}
