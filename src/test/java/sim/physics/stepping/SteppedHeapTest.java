// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Time stepping: what lies on something presses on it with its weight, comes to rest, and is hardly in it. */
class SteppedHeapTest {
    private static final double STEP = 1.0 / 60;

    @Test
    void eachLevelOfAStackBearsTheWeightAboveIt() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Body[] stack = Stepped.stack(engine, 10);
        Stepped.run(engine, 1200);
        List<LastingContact> contacts = engine.contacts();
        assertThat(contacts).hasSize(10);
        for (int k = 0; k < stack.length; k++) {
            double above = 0;
            for (LastingContact contact : engine.contacts(stack[k])) {
                above += contact.forceY(stack[k]);
            }
            assertThat(above).as("what acts on body %d bears it", k).isCloseTo(Stepped.G, within(1e-3 * Stepped.G));
        }
        LastingContact lowest = engine.contacts(stack[0]).get(0);
        assertThat(lowest.normalForce()).isCloseTo(10 * Stepped.G, within(1e-3 * 10 * Stepped.G));
    }

    /** The first number is of bodies, the second one of substeps. */
    @ParameterizedTest
    @CsvSource({"1, 1", "1, 4", "5, 4", "10, 4", "10, 8", "20, 32"})
    void aStackComesToRest(int count, int substeps) {
        PhysicsEngine engine = Stepped.engine(STEP, substeps);
        Body[] stack = Stepped.stack(engine, count);
        double deepest = 0;
        for (int k = 0; k < 3000; k++) {
            engine.step();
            deepest = Math.max(deepest, k % 50 == 0 ? Stepped.depth(engine) : 0);
        }
        assertThat(deepest).isLessThan(0.02);
        assertThat(Stepped.fastest(engine)).isLessThan(1e-4);
        assertThat(stack[count - 1].getY()).isCloseTo(count - 0.5, within(0.02));
        assertThat(stack[count - 1].getX()).isCloseTo(0, within(0.01));
    }

    /** Longer substeps leave bodies deeper in one another, and their impulses are larger: neither may throw them up in shorter ones. */
    @ParameterizedTest
    @CsvSource({"4, 4, 1", "4, 4, 2", "4, 8, 1", "1, 64, 1", "1, 4, 1", "4, 4, 10", "4, 4, 100", "8, 4, 1"})
    void aStackRestsOnWhenTheStepIsChanged(int before, int after, int parts) {
        PhysicsEngine engine = Stepped.engine(STEP, before);
        Body[] stack = Stepped.stack(engine, before == 1 ? 3 : 10);
        Stepped.run(engine, 600);
        double top = stack[stack.length - 1].getY();
        engine.setTimeStepping(after);
        engine.setTimeStep(STEP / parts);
        for (int k = 0; k < 300; k++) {
            engine.step();
            assertThat(stack[stack.length - 1].getY()).isCloseTo(top, within(0.015));
        }
    }

    @Test
    void aPyramidStands() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(new Gravity(0, -Stepped.G));
        Stepped.ground(engine);
        int rows = 10;
        for (int row = 0; row < rows; row++) {
            for (int k = 0; k < rows - row; k++) {
                Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(1.1 * (k + 0.5 * row), 0.5 + row)));
            }
        }
        Stepped.run(engine, 1200);
        assertThat(Stepped.depth(engine)).isLessThan(0.02);
        assertThat(Stepped.fastest(engine)).isLessThan(1e-3);
        for (int row = 0, n = 1; row < rows; row++) {
            for (int k = 0; k < rows - row; k++, n++) {
                Body body = engine.bodies().get(n);
                assertThat(body.getX()).isCloseTo(1.1 * (k + 0.5 * row), within(0.02));
                assertThat(body.getY()).isCloseTo(0.5 + row, within(0.02));
            }
        }
    }

    /** A box with walls around the origin, 2 wide beyond its inner half width. */
    static void bin(PhysicsEngine engine, double half) {
        for (int side = -1; side <= 1; side += 2) {
            Stepped.rough(engine.add(Body.fixed(new Rectangle(2 * half + 4, 2)).at(0, side * (half + 1))));
            Stepped.rough(engine.add(Body.fixed(new Rectangle(2, 2 * half + 4)).at(side * (half + 1), 0)));
        }
    }

    /** In one of twenty heaps a disc rolls for ever between two that lean on it, as nothing that rolls loses energy. */
    @Test
    void aHundredBodiesThatFallIntoABinComeToRestAndAreHardlyInOneAnother() {
        int rest = 0;
        for (int seed = 1; seed <= 8; seed++) {
            double fastest = fastestOfAHundredInABin(seed);
            assertThat(fastest).as("heap %d", seed).isLessThan(0.5);
            rest += fastest < 0.02 ? 1 : 0;
        }
        assertThat(rest).isGreaterThanOrEqualTo(7);
    }

    private static double fastestOfAHundredInABin(int seed) {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(new Gravity(0, -Stepped.G));
        bin(engine, 8);
        SplittableRandom random = new SplittableRandom(seed);
        for (int k = 0; k < 100; k++) {
            Shape shape = k % 3 == 0 ? new Circle(0.5) : k % 3 == 1 ? new Rectangle(1, 0.8) : Polygon.regular(3 + k % 5, 0.6);
            Body body = engine.add(new Body(shape).at(1.4 * (k % 10) - 6.3, 1.4 * (k / 10) - 6.3, 6 * random.nextDouble()));
            Stepped.rough(body).moving(random.nextDouble() - 0.5, random.nextDouble() - 0.5);
        }
        double deepest = 0;
        for (int k = 0; k < 1800; k++) {
            engine.step();
            deepest = Math.max(deepest, k % 10 == 0 ? Stepped.depth(engine) : 0);
        }
        assertThat(deepest).isLessThan(0.1);
        double weight = 0;
        double borne = 0;
        for (Body body : engine.bodies()) {
            weight += body.isFixed() ? 0 : body.getMass() * Stepped.G;
            for (LastingContact contact : body.isFixed() ? engine.contacts(body) : List.<LastingContact>of()) {
                borne -= contact.forceY(body);
            }
        }
        assertThat(borne).isCloseTo(weight, within(0.02 * weight));
        return Stepped.fastest(engine);
    }
}
