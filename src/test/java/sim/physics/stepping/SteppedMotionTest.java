// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;

/** Time stepping: what holds of single bodies, and of momentum. */
class SteppedMotionTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 3, 16})
    void whatOnlyGravityActsOnFollowsItsParabola(int substeps) {
        PhysicsEngine engine = Stepped.engine(0.1, substeps);
        engine.add(new Gravity(0.5, -Stepped.G));
        Body body = engine.add(new Body(new Rectangle(1, 2)).at(1, 2, 0.3).moving(3, 4, 2));
        Stepped.run(engine, 20);
        assertThat(body.getX()).isCloseTo(1 + 3 * 2 + 0.5 * 0.5 * 4, within(1e-12));
        assertThat(body.getY()).isCloseTo(2 + 4 * 2 - 0.5 * Stepped.G * 4, within(1e-12));
        assertThat(body.getAngle()).isCloseTo(0.3 + 2 * 2, within(1e-12));
        assertThat(body.getVelocityY()).isCloseTo(4 - 2 * Stepped.G, within(1e-12));
    }

    @Test
    void aForceThatIsAppliedActsForOneStep() {
        PhysicsEngine engine = Stepped.engine(0.1, 4);
        Body body = engine.add(new Body(new Circle(1)));
        body.setMass(2, 3);
        Stepped.run(engine, 3);
        body.addForce(4, -6);
        body.addTorque(9);
        for (int k = 0; k < 5; k++) {
            engine.step();
            assertThat(body.getVelocityX()).isCloseTo(0.2, within(1e-15));
            assertThat(body.getVelocityY()).isCloseTo(-0.3, within(1e-15));
            assertThat(body.getAngularVelocity()).isCloseTo(0.3, within(1e-15));
        }
    }

    /** Impulses between bodies act at one point; only pins that are a little open give some angular momentum away. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void momentumOfBodiesThatCollideIsKept(boolean isTied) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        SplittableRandom random = new SplittableRandom(5);
        for (int k = 0; k < 64; k++) {
            Body body = engine.add(new Body(k % 2 == 0 ? new Circle(0.5) : Polygon.regular(3 + k % 5, 0.6)));
            body.at(1.3 * (k % 8), 1.3 * (k / 8), 6 * random.nextDouble());
            body.moving(2 - 0.6 * (k % 8) + random.nextDouble(), 2 - 0.6 * (k / 8) + random.nextDouble(), random.nextDouble());
            body.setFriction(0.5);
            body.setRestitution(0.3);
            if (isTied && k % 8 > 4) {
                engine.add(new PinJoint(body, engine.bodies().get(k - 1), body.getX() - 0.65, body.getY()));
            }
        }
        Stepped.run(engine, 1);
        double[] before = Stepped.momentum(engine);
        Stepped.run(engine, 600);
        double[] after = Stepped.momentum(engine);
        assertThat(engine.getImpacts()).isGreaterThan(100);
        assertThat(after[0]).isCloseTo(before[0], within(1e-12));
        assertThat(after[1]).isCloseTo(before[1], within(1e-12));
        assertThat(after[2]).isCloseTo(before[2], within(isTied ? 0.1 : 1e-10));
    }

    /**
     * A plastic body that grazes another one and is many sizes on at the end of the step: their contact's point is half way then, and
     * arms that are so long must not be pushed as if they were short.
     */
    @ParameterizedTest
    @ValueSource(doubles = {60, 1000, 6000, 60000})
    void aGlancingBlowGivesNoEnergyAndKeepsAngularMomentum(double speed) {
        for (boolean isDisc : new boolean[] {false, true}) {
            PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
            Stepped.rough(engine.add(new Body(new Rectangle(1, 1))));
            Body other = engine.add(new Body(isDisc ? new Circle(0.5) : new Rectangle(1, 1)).at(-0.4, 0.995, isDisc ? 0 : 0.01));
            Stepped.rough(other).moving(speed, -speed / 50);
            double energy = engine.kineticEnergy();
            double[] before = Stepped.momentum(engine);
            for (int k = 0; k < 10; k++) {
                engine.step();
                assertThat(engine.kineticEnergy()).as("step %d", k).isLessThanOrEqualTo(energy);
            }
            assertThat(engine.getImpacts()).isPositive();
            assertThat(Stepped.momentum(engine)[2]).isCloseTo(before[2], within(1e-12 * Math.abs(before[2])));
        }
    }

    @Test
    void aFastBodyDoesNotPassThroughAWallThatItFliesStraightAt() {
        for (double speed : new double[] {60, 600, 3000, 60000}) {
            PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
            engine.add(Body.fixed(new Rectangle(0.1, 10)).at(7.3, 0)).setRestitution(0.5);
            Body body = engine.add(new Body(new Circle(0.5)).moving(speed, 0));
            Body box = engine.add(new Body(new Rectangle(1, 1)).at(0, 3).moving(speed, 0));
            Stepped.run(engine, 60);
            assertThat(body.getX()).as("disc at %s", speed).isLessThan(7);
            assertThat(box.getX()).as("square at %s", speed).isLessThan(7);
        }
    }

    /** Plastic bodies in a box: the energy is never more than at the start by a twentieth. */
    @ParameterizedTest
    @ValueSource(doubles = {4e-3, 1.0 / 60, 0.25, 1, 4})
    void energyDoesNotGrowWhateverTheStepIs(double step) {
        PhysicsEngine engine = Stepped.engine(step, 4);
        SteppedHeapTest.bin(engine, 60);
        SplittableRandom random = new SplittableRandom(8);
        for (int k = 0; k < 64; k++) {
            Body body = engine.add(new Body(k % 2 == 0 ? new Circle(5) : new Rectangle(5, 10)));
            body.at(13 * (k % 8) - 46, 13 * (k / 8) - 46).moving(4 * random.nextDouble() - 2, 4 * random.nextDouble() - 2);
            Stepped.rough(body);
        }
        double start = engine.kineticEnergy();
        for (int k = 0; k < 1000; k++) {
            engine.step();
            assertThat(engine.kineticEnergy()).as("step %d", k).isLessThan(1.05 * start);
        }
        assertThat(engine.getImpacts()).isPositive();
    }
}
