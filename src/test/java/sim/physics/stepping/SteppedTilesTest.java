// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Floors of tiles, under time stepping: contacts are a little deep, so that what slides meets each next tile with its corner. */
class SteppedTilesTest {
    private static PhysicsEngine world(double slope) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        engine.add(new Gravity(-Stepped.G * Math.sin(slope), -Stepped.G * Math.cos(slope)));
        for (int k = -20; k < 40; k++) {
            engine.add(Body.fixed(new Rectangle(1, 1)).at(k + 0.5, -0.5)).setRestitution(0);
        }
        return engine;
    }

    /** Without friction, what slides goes on as over one floor. It lost most of its speed, within a second. */
    @ParameterizedTest
    @CsvSource({"0, 0.2", "0, 2", "0, 8", "0.5, 2", "0.5, 8"})
    void whatSlidesFeelsNoSeam(double slope, double speed) {
        for (Shape shape : List.of(new Circle(0.4), new Rectangle(0.7, 0.5), new Rectangle(1, 0.5), new Rectangle(1.7, 0.5))) {
            double height = shape.vertexCount() == 1 ? 0.4 : 0.25;
            for (int phase = 0; phase < 8; phase++) {
                PhysicsEngine engine = world(slope);
                Body body = engine.add(new Body(shape).at(0.5 + 0.125 * phase, height).moving(speed, 0));
                body.setRestitution(0);
                for (Body each : engine.bodies()) {
                    each.setFriction(0);
                }
                Stepped.run(engine, 90);
                double expected = speed - Stepped.G * Math.sin(slope) * 1.5;
                assertThat(body.getVelocityX()).as(shape + ", phase " + phase).isCloseTo(expected, within(2e-3 * speed + 2e-4));
                assertThat(body.getY()).isCloseTo(height, within(1e-3));
                assertThat(body.getAngle()).isCloseTo(0, within(1e-3));
            }
        }
    }

    /** Without friction nothing turns a disc, also if it comes to a seam just as a substep ends. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-12, -1e-12, 3e-12, 1e-9})
    void aSmoothDiscDoesNotTurn(double longer) {
        for (int phase = 0; phase < 8; phase++) {
            PhysicsEngine engine = world(0);
            engine.setTimeStep((1 + longer) / 60);
            Body disc = engine.add(new Body(new Circle(0.4)).at(0.5 + 0.125 * phase, 0.4).moving(8, 0));
            for (Body each : engine.bodies()) {
                each.setFriction(0);
                each.setRestitution(0);
            }
            Stepped.run(engine, 90);
            assertThat(disc.getAngle()).isCloseTo(0, within(1e-12));
        }
    }

    /**
     * A disc that comes to a seam just as a substep ends is by rounding over the one tile or the other, and has no corner to go round: rolling it lost and
     * got 1 % of its speed there, smooth it got a spin. In a world that is turned by any angle, and on tiles of which each lies off by a little.
     */
    @ParameterizedTest
    @CsvSource({"1, 0, 0", "4, 0, 0", "1, 0.5, 0", "4, 0.5, 0", "1, 0, 1e-13", "4, 0, 1e-13", "1, 0.5, 1e-13", "4, 0.5, 1e-13"})
    void aDiscThatIsOverASeamAsASubstepEndsGoesOn(int substeps, double friction, double off) {
        SplittableRandom random = new SplittableRandom(17);
        for (int run = 0; run < 40; run++) {
            double angle = run % 4 == 0 ? 0 : 7 * random.nextDouble();
            double cos = StrictMath.cos(angle);
            double sin = StrictMath.sin(angle);
            PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
            engine.add(new Gravity(10 * sin, -10 * cos));
            for (int k = -3; k < 14; k++) {
                double y = off * (2 * random.nextDouble() - 1) - 0.25;
                engine.add(Body.fixed(new Rectangle(1, 0.5)).at(cos * k - sin * y, sin * k + cos * y, angle));
            }
            double x = 0.1 + 0.1 * (run % 8);
            Body disc = engine.add(new Body(new Circle(0.5)).at(cos * x - sin * 0.5, sin * x + cos * 0.5).moving(4 * cos, 4 * sin));
            disc.setAngularVelocity(friction > 0 ? -8 : 0);
            for (Body each : engine.bodies()) {
                each.setFriction(friction);
                each.setRestitution(0);
            }
            double spin = disc.getAngularVelocity();
            for (int k = 0; k < 90; k++) {
                engine.step();
                assertThat(disc.getAngularVelocity()).as("run " + run).isCloseTo(spin, within(1e-9));
                assertThat(cos * disc.getVelocityX() + sin * disc.getVelocityY()).as("run " + run).isCloseTo(4, within(1e-9));
            }
        }
    }

    /** What falls on tiles, wherever their seams are, does as on one floor. */
    @ParameterizedTest
    @CsvSource({"0, 0", "0.4, 0", "0, 0.5", "0.4, 0.5"})
    void whatFallsFlatFeelsNoSeam(double friction, double restitution) {
        for (Shape shape : List.of(new Circle(0.4), new Rectangle(0.7, 0.5), new Rectangle(1, 0.5), new Rectangle(2.7, 0.5))) {
            double height = shape.vertexCount() == 1 ? 0.4 : 0.25;
            for (int phase = 0; phase < 8; phase++) {
                Body[] bodies = new Body[2];
                for (int k = 0; k < 2; k++) {
                    PhysicsEngine engine = k == 0 ? Stepped.engine(1.0 / 60, 4) : world(0);
                    if (k == 0) {
                        engine.add(new Gravity(0, -Stepped.G));
                        engine.add(Body.fixed(new Rectangle(60, 1)).at(10, -0.5));
                    }
                    bodies[k] = engine.add(new Body(shape).at(0.5 + 0.125 * phase, height + 0.3).moving(1, 0));
                    for (Body each : engine.bodies()) {
                        each.setFriction(friction);
                        each.setRestitution(restitution);
                    }
                    Stepped.run(engine, 40);
                }
                String what = shape + ", phase " + phase;
                assertThat(bodies[1].getX()).as(what).isCloseTo(bodies[0].getX(), within(5e-3));
                assertThat(bodies[1].getY()).as(what).isCloseTo(bodies[0].getY(), within(5e-3));
                assertThat(bodies[1].getAngle()).as(what).isCloseTo(bodies[0].getAngle(), within(1e-2));
            }
        }
    }

    /** A tile that is higher by a twenty-fifth or a tenth of the box stops it. */
    @ParameterizedTest
    @CsvSource({"0.1, 0.02", "0.5, 0.02", "0.5, 0.05", "2, 0.05"})
    void whatIsHigherStopsABox(double speed, double step) {
        PhysicsEngine engine = world(0);
        engine.add(Body.fixed(new Rectangle(1, 1)).at(3.5, step - 0.5)).setRestitution(0);
        Body box = engine.add(new Body(new Rectangle(1, 0.5)).at(0.6, 0.25).moving(speed, 0));
        box.setRestitution(0);
        for (Body each : engine.bodies()) {
            each.setFriction(0);
        }
        Stepped.run(engine, (int) (60 * 3 / speed));
        assertThat(box.getX()).isLessThan(2.51);
        assertThat(Math.abs(box.getVelocityX())).isLessThan(0.5 * speed);
    }
}
