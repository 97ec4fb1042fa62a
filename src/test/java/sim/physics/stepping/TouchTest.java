// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sim.physics.collision.narrow.Distance;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Where time stepping finds bodies to touch, against the distance that the narrow phase of events has for them. */
class TouchTest {
    private static Shape shape(SplittableRandom random) {
        return switch (random.nextInt(4)) {
            case 0 -> new Circle(0.2 + random.nextDouble());
            case 1 -> new Rectangle(0.1 + 2 * random.nextDouble(), 0.1 + random.nextDouble());
            default -> Polygon.regular(3 + random.nextInt(5), 0.3 + random.nextDouble());
        };
    }

    @Test
    void whatTouchesHasAPointAndItsDepthIsTheDistance() {
        SplittableRandom random = new SplittableRandom(1);
        Distance distance = new Distance();
        int overlapping = 0;
        for (int k = 0; k < 30_000; k++) {
            State state = new State();
            Body a = new Body(shape(random)).at(0, 0, 6 * random.nextDouble());
            Body b = new Body(shape(random));
            b.at(3 * random.nextDouble() - 1.5, 3 * random.nextDouble() - 1.5, 6 * random.nextDouble());
            state.add(a);
            state.add(b);
            Poses poses = new Poses(state);
            for (int body = 0; body < 2; body++) {
                poses.add(body);
                poses.turn(body);
            }
            Touch touch = new Touch(state, poses, null);
            double margin = 0.02;
            touch.find(0, 0, 1, 0, margin);
            double gap = distance.between(a, b);
            if (gap > margin) {
                continue;
            }
            double size = Math.min(a.getShape().boundingRadius(), b.getShape().boundingRadius());
            assertThat(touch.count).as("points of %s and %s, %s apart", a, b, gap).isPositive();
            assertThat(Math.hypot(touch.nx, touch.ny)).isCloseTo(1, within(1e-14));
            double least = touch.count > 1 ? Math.min(touch.gap[0], touch.gap[1]) : touch.gap[0];
            assertThat(least).isCloseTo(gap, within(gap <= 0 ? 1e-3 * size : margin));
            overlapping += gap <= 0 ? 1 : 0;
        }
        assertThat(overlapping).isGreaterThan(10_000);
    }
}
