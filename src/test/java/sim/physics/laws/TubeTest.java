// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** A box fills a tube: it slides along it by Coulomb's law, however the tube is turned and whatever rounding leaves between the walls. */
class TubeTest {
    private static final double G = 9.81;
    private static final double TIME = 0.25;

    /**
     * Gravity presses it on one wall, with a part of it along the tube. A box that is too short for its height leans on both walls, as far as friction
     * would tip it: then they bear μ G h / w together.
     */
    @ParameterizedTest
    @ValueSource(doubles = {60, 240, 960})
    void whatFillsATubeSlides(double stepsInASecond) {
        for (int seed = 0; seed < 120; seed++) {
            Random random = new Random(seed);
            double clearance = seed % 3 == 0 ? 1e-9 : 0;
            double angle = 6 * random.nextDouble();
            double friction = random.nextDouble();
            double restitution = seed % 2 == 0 ? 0 : 0.9 * random.nextDouble();
            double width = 0.3 + 2 * random.nextDouble();
            double height = 0.3 + random.nextDouble();
            double along = seed % 4 == 0 ? 4 : 0;
            Body box = new Body(new Rectangle(width, height));
            PhysicsEngine engine = tube(box, clearance, angle, 10 * random.nextGaussian(), along);
            engine.setTimeStep(1 / stepsInASecond);
            for (Body body : engine.bodies()) {
                body.setFriction(friction);
                body.setRestitution(restitution);
            }
            double speed = 4 * random.nextDouble();
            box.moving(speed * Math.cos(angle), speed * Math.sin(angle));
            for (int k = 0; k < TIME * stepsInASecond; k++) {
                engine.step();
            }
            double brake = friction * G * Math.max(1, friction * height / width) - along;
            double now = box.getVelocityX() * Math.cos(angle) + box.getVelocityY() * Math.sin(angle);
            double tolerance = 0.05 * friction * G / stepsInASecond + 1e-4;
            assertThat(now).as("seed " + seed).isCloseTo(Math.max(0, speed - brake * TIME), within(tolerance));
            assertThat(box.getAngularVelocity()).as("seed " + seed).isCloseTo(0, within(1e-7));
            assertThat(engine.getDeepestPenetration()).isLessThan(1e-9);
        }
    }

    private static PhysicsEngine tube(Body box, double clearance, double angle, double far, double along) {
        PhysicsEngine engine = new PhysicsEngine();
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        engine.add(new Gravity(along * cos + G * sin, along * sin - G * cos));
        double half = 0.5 * (((Rectangle) box.getShape()).height() + clearance);
        engine.add(Body.fixed(new Rectangle(400, 2)).at(far + (1 + half) * sin, -(1 + half) * cos, angle));
        engine.add(Body.fixed(new Rectangle(400, 2)).at(far - (1 + half) * sin, (1 + half) * cos, angle));
        engine.add(box.at(far, 0, angle));
        return engine;
    }
}
