// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Discs without friction press on one another along the line of their centres: nothing ever turns them. */
class SteppedDiscsTest {
    private static Body disc(PhysicsEngine engine, double radius, double x, double y) {
        Body disc = engine.add(new Body(new Circle(radius)).at(x, y));
        disc.setRestitution(0);
        return disc;
    }

    @Test
    void discsWithoutFrictionThatFallIntoABinDoNotTurn() {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        engine.add(new Gravity(0, -Stepped.G));
        engine.add(Body.fixed(new Rectangle(6, 1)).at(0, -0.5));
        engine.add(Body.fixed(new Rectangle(1, 40)).at(-2.5, 19));
        engine.add(Body.fixed(new Rectangle(1, 40)).at(2.5, 19));
        SplittableRandom random = new SplittableRandom(1);
        List<Body> discs = new ArrayList<>();
        for (int k = 0; k < 110; k++) {
            double radius = 0.13 + 0.04 * random.nextDouble();
            discs.add(disc(engine, radius, (k % 11 - 5) * 0.35 + 0.01 * random.nextDouble(), 0.3 + 0.36 * (k / 11)));
        }
        Stepped.run(engine, 240);
        assertThat(engine.contacts()).hasSizeGreaterThan(100);
        for (Body disc : discs) {
            assertThat(disc.getAngularVelocity()).isCloseTo(0, within(1e-12));
        }
    }

    private static double orbital(List<Body> bodies) {
        double sum = 0;
        for (Body body : bodies) {
            sum += body.getMass() * (body.getX() * body.getVelocityY() - body.getY() * body.getVelocityX());
        }
        return sum;
    }

    /** What binds them pulls at their centres, so their way about one another keeps all of the angular momentum. */
    @ParameterizedTest
    @ValueSource(doubles = {1.0 / 60, 1.0 / 240})
    void discsWithoutFrictionThatAreDrawnTogetherKeepTheAngularMomentumOfTheirWays(double step) {
        PhysicsEngine engine = Stepped.engine(step, 4);
        SplittableRandom random = new SplittableRandom(7);
        List<Body> discs = new ArrayList<>();
        for (int k = 0; k < 12; k++) {
            double angle = k + 0.3 * random.nextDouble();
            double x = (1 + 0.4 * k) * StrictMath.cos(angle);
            double y = (1 + 0.4 * k) * StrictMath.sin(angle);
            discs.add(disc(engine, 0.3, x, y).moving(-0.5 * y, 0.5 * x));
            for (int m = 0; m < k; m++) {
                engine.add(new Spring(discs.get(m), 0, 0, discs.get(k), 0, 0, 0, 0.2, 0));
            }
        }
        double before = orbital(discs);
        Stepped.run(engine, (int) StrictMath.rint(20 / step));
        assertThat(engine.getImpacts()).isGreaterThan(4);
        assertThat(orbital(discs)).isCloseTo(before, within(2e-3 * before));
    }
}
