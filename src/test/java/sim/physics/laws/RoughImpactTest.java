// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Impacts of several points with friction: inelastic impact with Coulomb friction, of which each point gives a part back and rubs once more. */
class RoughImpactTest {
    /**
     * A unit square that slides at 1 falls flat at 4. It is stopped with no spin, by more at its front than at its back. That is given back: it
     * spins, and rubs on the other way until it slides no more. On a floor, on two bodies side by side and on two posts, by events and by time
     * stepping, to either side.
     */
    @ParameterizedTest
    @CsvSource({"0, 0", "0, 0.001", "0, 0.5", "0, 1", "4, 0", "4, 0.001", "4, 0.5", "4, 1"})
    void aBoxThatFallsFlat(int substeps, double restitution) {
        double mu = 0.4;
        double inertia = 1.0 / 6;
        double spin = restitution * 0.5 / inertia; // the normal impulses differ by twice what the friction of 1 turns by
        double rubs = Math.min(0.5 * spin / (1 + 0.25 / inertia), mu * restitution * 4);
        for (int floor = 0; floor < 3; floor++) {
            for (int side = -1; side < 2; side += 2) {
                PhysicsEngine engine = new PhysicsEngine();
                engine.setTimeStep(1.0 / 960);
                engine.setTimeStepping(substeps);
                double wide = floor == 2 ? 0.25 : 5;
                engine.add(Body.fixed(new Rectangle(floor == 0 ? 20 : wide, 1)).at(floor == 0 ? 0 : floor == 1 ? -2.5 : -0.5, -0.5));
                engine.add(Body.fixed(new Rectangle(wide, 1)).at(floor == 0 ? 30 : floor == 1 ? 2.5 : 0.5, -0.5));
                Body box = engine.add(new Body(new Rectangle(1, 1)).at(-0.1 * side, 0.9).moving(side, -4));
                box.setMass(1);
                for (Body each : engine.bodies()) {
                    each.setFriction(mu);
                    each.setRestitution(restitution);
                }
                while (box.getVelocityY() < -0.1) {
                    engine.step();
                }
                String what = "floor " + floor + " to " + side;
                assertThat(box.getVelocityX()).as(what).isCloseTo(-side * rubs, within(substeps == 0 ? 1e-9 : 4e-3));
                assertThat(box.getVelocityY()).as(what).isCloseTo(4 * restitution, within(substeps == 0 ? 1e-9 : 4e-3));
                assertThat(box.getAngularVelocity()).as(what).isCloseTo(side * (spin - 0.5 * rubs / inertia), within(substeps == 0 ? 1e-9 : 6e-3));
            }
        }
    }

    /** A body that falls straight and flat onto two posts rubs on neither of them: they do not pull against each other. */
    @ParameterizedTest
    @ValueSource(doubles = {0.5, 1})
    void twoPostsThatABoxFallsFlatOnShareItsImpulse(double restitution) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.5);
        List<Double> told = new ArrayList<>();
        engine.add(Body.fixed(new Circle(0.25)).at(-0.5, -0.25));
        engine.add(Body.fixed(new Circle(0.25)).at(0.5, -0.25));
        engine.add(new Body(new Rectangle(2, 1)).at(0, 1).moving(0, -2)).setMass(3);
        engine.addListener(new CollisionListener() {
            @Override
            public void collided(Contact contact) {
                told.add(contact.impulse());
            }
        });
        for (Body each : engine.bodies()) {
            each.setFriction(0.5);
            each.setRestitution(restitution);
        }
        engine.step();
        assertThat(told).hasSize(2).allSatisfy(impulse -> assertThat(impulse).isCloseTo(3 * (1 + restitution), within(1e-12)));
    }

    /** Boxes and discs that meet at several points at once, some of them flat, keep their momentum and gain no energy. */
    @ParameterizedTest
    @ValueSource(doubles = {0.3, 1})
    void noneGainsEnergy(double restitution) {
        SplittableRandom random = new SplittableRandom(11);
        for (int run = 0; run < 300; run++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(0.1);
            int below = 2 + random.nextInt(3);
            for (int k = 0; k < below; k++) {
                engine.add(new Body(new Rectangle(1, 1)).at(1.1 * k, 0)).setMass(Math.exp(6 * random.nextDouble() - 3));
            }
            Body top = random.nextInt(3) == 0
                    ? new Body(new Circle(0.8)).at(0.55, Math.sqrt(0.64 - 0.0025) + 0.5 + 1e-3)
                    : new Body(new Rectangle(1.1 * below, 0.5)).at(0.55 * (below - 1), 0.751);
            engine.add(top.moving(4 * random.nextDouble() - 2, -1 - random.nextDouble())).setMass(Math.exp(6 * random.nextDouble() - 3));
            double x = 0;
            for (Body each : engine.bodies()) {
                each.setFriction(2 * random.nextDouble());
                each.setRestitution(restitution);
                x += each.getMass() * each.getVelocityX();
            }
            double before = engine.kineticEnergy();
            engine.step();
            for (Body each : engine.bodies()) {
                x -= each.getMass() * each.getVelocityX();
            }
            assertThat(engine.getImpacts()).isPositive();
            assertThat(engine.kineticEnergy()).as("run %d", run).isLessThanOrEqualTo(before * (1 + 1e-13));
            assertThat(x).isCloseTo(0, within(1e-12 * (1 + Math.abs(top.getMass()))));
        }
    }
}
