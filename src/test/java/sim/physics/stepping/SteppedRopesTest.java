// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;

/** Time stepping: elastic balls in a row on elastic ropes, which fly about and strike one another without a force. */
class SteppedRopesTest {
    private static final double RATE = 240;

    private static double some(SplittableRandom random) {
        return 4 * random.nextDouble() - 2;
    }

    private static List<Body> balls(PhysicsEngine engine, SplittableRandom random) {
        List<Body> balls = new ArrayList<>();
        for (int k = 0; k < 6; k++) {
            Body ball = engine.add(new Body(new Circle(0.1)).at(0.3 * k, 0).moving(some(random), some(random)));
            ball.setMass(1 + random.nextDouble());
            if (k > 0) {
                engine.add(Limit.rope(balls.get(k - 1), 0, 0, ball, 0, 0, 0.5, 1)).setCollideConnected(true);
            }
            balls.add(ball);
        }
        engine.add(Limit.rope(balls.get(0), 0, 0, null, 0, 0.5, 0.8, 1));
        return balls;
    }

    /** The way between two balls turns within a substep in which they strike askew: more than a hundred times in ten seconds. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void elasticBallsKeepTheirEnergyHoweverAskewTheyStrike(long seed) {
        PhysicsEngine engine = Stepped.engine(1 / RATE, 4);
        List<Body> balls = balls(engine, new SplittableRandom(seed));
        double before = balls.stream().mapToDouble(Body::kineticEnergy).sum();
        for (int k = 0; k < 10 * RATE; k++) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isGreaterThan(50);
        assertThat(balls.stream().mapToDouble(Body::kineticEnergy).sum()).isCloseTo(before, within(0.01 * before));
    }
}
