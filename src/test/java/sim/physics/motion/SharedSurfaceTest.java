// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Bodies share what is equal of their surfaces, and nobody can tell. */
class SharedSurfaceTest {
    private final PhysicsEngine engine = new PhysicsEngine();
    private final List<Body> balls = new ArrayList<>();

    private void addBalls(double... restitutions) {
        Body wall = engine.add(Body.fixed(new Rectangle(100, 2)).at(0, -1));
        wall.setRestitution(1);
        for (int k = 0; k < restitutions.length; k++) {
            Body ball = new Body(new Circle(0.5)).at(3 * k, 1).moving(0, -1);
            ball.setRestitution(restitutions[k]);
            balls.add(engine.add(ball));
        }
    }

    private void bouncesWith(double... restitutions) {
        engine.step();
        for (int k = 0; k < restitutions.length; k++) {
            assertThat(balls.get(k).getVelocityY()).isCloseTo(restitutions[k], within(1e-15));
        }
    }

    @Test
    void equalOnes() {
        addBalls(1, 1, 1);
        bouncesWith(1, 1, 1);
    }

    @Test
    void differentOnesAndEqualOnes() {
        addBalls(0.5, 0.25, 0.25, 0.5, 1);
        bouncesWith(0.5, 0.25, 0.25, 0.5, 1);
    }

    @Test
    void oneThatIsSetInTheEngineChangesNoOther() {
        addBalls(0.5, 0.5, 0.5);
        balls.get(1).setRestitution(0.25);
        assertThat(balls.get(0).getRestitution()).isEqualTo(0.5);
        assertThat(balls.get(2).getRestitution()).isEqualTo(0.5);
        bouncesWith(0.5, 0.25, 0.5);
    }

    @Test
    void allThatAreSetInTheEngineOneByOne() {
        addBalls(1, 1, 1);
        for (Body ball : balls) {
            ball.setRestitution(0.5);
        }
        bouncesWith(0.5, 0.5, 0.5);
    }

    @Test
    void oneThatLeavesTakesItsSurfaceAlong() {
        addBalls(0.5, 0.25);
        engine.remove(balls.get(1));
        balls.get(0).setRestitution(1);
        assertThat(balls.get(1).getRestitution()).isEqualTo(0.25);
        engine.add(balls.get(1));
        bouncesWith(1, 0.25);
    }

    @Test
    void theOnlyBodyOfAnEngineMayChangeItsOwn() {
        PhysicsEngine small = new PhysicsEngine();
        Body first = small.add(new Body(new Circle(1)));
        first.setFriction(0.3);
        first.setRestitution(0.5);
        Body second = small.add(new Body(new Circle(1)).at(5, 0));
        assertThat(second.getFriction()).isZero();
        assertThat(second.getRestitution()).isEqualTo(1);
        assertThat(first.getFriction()).isEqualTo(0.3);
        assertThat(first.getRestitution()).isEqualTo(0.5);
    }
}
