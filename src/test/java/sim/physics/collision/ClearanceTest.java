// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Pairs whose bodies cannot have come together since the last look are not looked at: none that do may be missed by that. */
class ClearanceTest {
    private static PhysicsEngine engine(double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        return engine;
    }

    private static Body robot(PhysicsEngine engine, double x, double y) {
        Body body = engine.add(new Body(new Circle(0.5)).at(x, y));
        body.setMass(1);
        body.setRestitution(1);
        return body;
    }

    private static void assertApart(PhysicsEngine engine) {
        for (Overlap overlap : engine.overlaps()) {
            assertThat(overlap.depth()).isLessThan(1e-9);
        }
    }

    /** They meet at an instant that is known, under a force that sets in when they have been looked at as slow ones. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 30, 1000, 30_000})
    void aSuddenPushIsNotMissed(double force) {
        PhysicsEngine engine = engine(0.1);
        Body one = robot(engine, 0, 0);
        Body box = engine.add(new Body(new Rectangle(1, 1)).at(1.1, 0)); // within its bounding circle: the distance is looked at
        box.setMass(1e9);
        box.setRestitution(1);
        for (int k = 0; k < 3; k++) {
            one.addForce(1e-10, 0);
            engine.step();
        }
        for (int k = 0; k < 4 && engine.getImpacts() == 0; k++) {
            one.addForce(force, 0);
            engine.step();
            double time = 0.1 * (k + 1);
            if (0.5 * force * time * time > 0.1) { // it has met the box, which cannot be moved, on the way
                double met = Math.sqrt(0.2 / force);
                double left = time - met;
                assertThat(engine.getImpacts()).isGreaterThanOrEqualTo(1);
                double x = 0.1 - force * met * left + 0.5 * force * left * left;
                double v = -force * met + force * left;
                if (engine.getImpacts() == 1) {
                    assertThat(one.getX()).isCloseTo(x, within(1e-6));
                    assertThat(one.getVelocityX()).isCloseTo(v, within(1e-6 * force));
                }
            }
            assertApart(engine);
        }
    }

    /** A box that begins to spin fast hits with its corner what is not on its way else. */
    @Test
    void aSuddenSpinIsNotMissed() {
        PhysicsEngine engine = engine(0.1);
        Body one = robot(engine, 0, 1.2);
        Body box = engine.add(new Body(new Rectangle(2, 0.4)).at(0, 0));
        box.setMass(1);
        for (int k = 0; k < 3; k++) {
            one.addForce(0, 1e-6);
            box.addForce(0, -1e-6);
            engine.step();
        }
        assertThat(engine.getImpacts()).isZero();
        for (int k = 0; k < 3; k++) {
            box.addTorque(60);
            one.addForce(0, 1e-6);
            engine.step();
            assertApart(engine);
        }
        assertThat(engine.getImpacts()).isPositive();
    }

    /** Bodies that are put next to others between steps. */
    @Test
    void whatIsPutElsewhereIsLookedAt() {
        SplittableRandom random = new SplittableRandom(5);
        for (int trial = 0; trial < 200; trial++) {
            PhysicsEngine engine = engine(0.1);
            Body one = robot(engine, 0, 0);
            Body box = engine.add(new Body(new Rectangle(1, 1)).at(1.06, 0));
            box.setMass(1);
            for (int k = 0; k < 2; k++) {
                one.addForce(0, 1e-4); // no other than this one: else they move uniformly beside one another
                engine.step();
            }
            double gap = 0.01 * random.nextDouble();
            one.setPosition(0.06 - gap, box.getY());
            one.setVelocity(0.15, 0);
            one.addForce(0, 1e-4);
            engine.step();
            assertThat(engine.getImpacts()).as("gap %s", gap).isEqualTo(1);
            assertApart(engine);
        }
    }

    /** Slow robots among boxes near them: an exact count. */
    @Test
    void slowCrowdsAreHardlyLookedAt() {
        PhysicsEngine engine = engine(0.01);
        Body[] robots = new Body[25];
        for (int k = 0; k < 25; k++) {
            robots[k] = robot(engine, 1.4 * (k % 5), 1.4 * (k / 5));
            engine.add(new Body(new Rectangle(0.3, 0.3)).at(1.4 * (k % 5) + 0.7, 1.4 * (k / 5) + 0.7)).setMass(1);
        }
        for (int step = 0; step < 100; step++) {
            for (Body one : robots) {
                one.addForce(step % 2 == 0 ? 0.2 : -0.2, 0);
            }
            engine.step();
        }
        assertThat(engine.getImpacts()).isZero();
        assertThat(engine.getNarrowPhaseEvaluations()).isLessThan(1000); // 12,000 and more, were all looked at in each step
    }
}
