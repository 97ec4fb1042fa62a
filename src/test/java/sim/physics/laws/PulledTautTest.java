// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/**
 * A heavy body falls on light folded links, and pulls them taut. Pins do no work. While it turns round, the light links swing through as fast as
 * the root of the ratio of masses says, within a hundredth of a step and less.
 */
class PulledTautTest {
    private static final double G = 9.81;

    @ParameterizedTest
    @CsvSource({"3, 1e3, 60", "3, 1e3, 240", "3, 1e6, 60", "3, 1e6, 240", "3, 1e6, 1024", "3, 1e6, 4096", "6, 1e4, 60", "6, 1e4, 240", "6, 1e4, 1024"})
    void aHeavyBodyThatPullsLightLinksTautKeepsItsEnergy(int links, double mass, double stepsInASecond) {
        assertThat(largestChange(links, mass, stepsInASecond, new Gravity(0, -G))).isLessThan(1e-7);
    }

    /** Of forces that an author gives nobody knows the energy. */
    @ParameterizedTest
    @CsvSource({"3, 1e3, 60", "3, 1e3, 240", "3, 1e6, 60", "3, 1e6, 240", "3, 1e6, 1024", "6, 1e4, 60", "6, 1e4, 240", "6, 1e4, 1024"})
    void soItDoesUnderAnAuthorsForce(int links, double mass, double stepsInASecond) {
        assertThat(largestChange(links, mass, stepsInASecond, (body, time, forces) -> forces.add(body, 0, -G * body.getMass()))).isLessThan(1e-3);
    }

    /** Of the energy, in units of the heavy body's weight and a link. */
    private static double largestChange(int links, double mass, double stepsInASecond, ForceGenerator weight) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / stepsInASecond);
        engine.add(weight);
        List<Body> chain = folded(engine, links, mass);
        double before = energy(chain);
        double fastest = 0;
        double most = 0;
        for (int k = 0; k < 2 * stepsInASecond; k++) {
            engine.step();
            most = Math.max(most, Math.abs(energy(chain) - before) / (mass * G));
            fastest = Math.max(fastest, Math.abs(chain.get(0).getAngularVelocity()));
        }
        assertThat(fastest).as("it was pulled taut").isGreaterThan(10);
        return most;
    }

    private static List<Body> folded(PhysicsEngine engine, int links, double mass) {
        List<Body> chain = new ArrayList<>();
        double x = 0;
        double y = 0;
        for (int k = 0; k < links; k++) {
            double angle = (k % 2 == 0 ? 0.1 : Math.PI - 0.15) + 0.01 * k;
            double cos = Math.cos(angle);
            double sin = Math.sin(angle);
            Body link = engine.add(new Body(new Rectangle(1, 0.1)).at(x + cos / 2, y + sin / 2, angle));
            double m = k == links - 1 ? mass : 1;
            link.setMass(m, 0.1 * m);
            link.setCollisionGroup(1, 0);
            engine.add(k == 0 ? new PinJoint(link, x, y) : new PinJoint(chain.get(k - 1), link, x, y));
            chain.add(link);
            x += cos;
            y += sin;
        }
        return chain;
    }

    private static double energy(List<Body> bodies) {
        double sum = 0;
        for (Body body : bodies) {
            double vx = body.getVelocityX();
            double vy = body.getVelocityY();
            double omega = body.getAngularVelocity();
            sum += body.getMass() * (G * body.getY() + 0.5 * (vx * vx + vy * vy)) + 0.5 * body.getInertia() * omega * omega;
        }
        return sum;
    }
}
