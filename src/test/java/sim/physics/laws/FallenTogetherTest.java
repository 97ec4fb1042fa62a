// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** What joints tie falls on a floor, and meets it in several places at once but for rounding, in worlds that are turned by any angle. */
class FallenTogetherTest {
    private static final double G = 9.81;
    private static final double THICKNESS = 0.2;

    /** One after the other these impacts threw links up: half of the chains of 12 and 20 links ended as arches of up to 0.2 m. */
    @ParameterizedTest
    @CsvSource({"8, 0.03, 0", "12, 0.1, 0", "20, 0.03, 0", "20, 0.1, 0", "12, 0.1, 0.5", "20, 0.1, 0.5"})
    void aChainLiesFlat(int links, double height, double restitution) {
        SplittableRandom random = new SplittableRandom(5);
        for (int k = 0; k < 12; k++) {
            double angle = 2 * Math.PI * random.nextDouble();
            PhysicsEngine engine = chain(links, height, restitution, angle);
            for (int n = 0; n < 150; n++) {
                engine.step();
            }
            for (int m = 1; m <= links; m++) {
                Body link = engine.bodies().get(m);
                double y = StrictMath.cos(angle) * link.getY() - StrictMath.sin(angle) * link.getX();
                assertThat(y).as("link %d at %s", m, angle).isEqualTo(THICKNESS / 2, within(1e-6));
                assertThat(link.getAngle()).as("link %d at %s", m, angle).isEqualTo(angle, within(1e-9));
            }
        }
    }

    /** It is the mirror image of itself; one leg after the other, it went aside by up to 4 cm. */
    @ParameterizedTest
    @CsvSource({"0, 0.5", "0.5, 0.5", "0.9, 0.3"})
    void aTableStaysWhereItIs(double restitution, double friction) {
        SplittableRandom random = new SplittableRandom(4);
        for (int k = 0; k < 16; k++) {
            double angle = 2 * Math.PI * random.nextDouble();
            PhysicsEngine engine = floor(20, angle);
            Body top = put(engine, new Rectangle(2, 0.2), 0, 1.5, angle);
            for (int side = -1; side <= 1; side += 2) {
                Body leg = put(engine, new Rectangle(0.2, 1), 0.8 * side, 0.9, angle);
                engine.add(new WeldJoint(top, leg, leg.getX(), leg.getY()));
            }
            rub(engine, restitution, friction);
            for (int n = 0; n < 200; n++) {
                engine.step();
            }
            double x = StrictMath.cos(angle) * top.getX() + StrictMath.sin(angle) * top.getY();
            assertThat(x).as("at %s", angle).isEqualTo(0, within(1e-5));
            assertThat(top.getAngle()).as("at %s", angle).isEqualTo(angle, within(1e-6));
        }
    }

    private static PhysicsEngine floor(double length, double angle) {
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(G * sin, -G * cos));
        engine.add(Body.fixed(new Rectangle(length, 1)).at(0.5 * sin, -0.5 * cos, angle));
        return engine;
    }

    private static Body put(PhysicsEngine engine, Rectangle shape, double x, double y, double angle) {
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        return engine.add(new Body(shape).at(cos * x - sin * y, sin * x + cos * y, angle));
    }

    private static void rub(PhysicsEngine engine, double restitution, double friction) {
        for (Body body : engine.bodies()) {
            body.setRestitution(restitution);
            body.setFriction(friction);
        }
    }

    private static PhysicsEngine chain(int links, double height, double restitution, double angle) {
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        PhysicsEngine engine = floor(links + 10, angle);
        double y = height + THICKNESS / 2;
        for (int k = 0; k < links; k++) {
            double x = k - (links - 1) / 2.0;
            Body link = put(engine, new Rectangle(1, THICKNESS), x, y, angle);
            if (k > 0) {
                engine.add(new PinJoint(engine.bodies().get(k), link, cos * (x - 0.5) - sin * y, sin * (x - 0.5) + cos * y));
            }
        }
        rub(engine, restitution, 0.5);
        return engine;
    }
}
