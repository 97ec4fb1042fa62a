// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Compound;
import sim.physics.shape.Rectangle;

/**
 * Robots, seen from above, that push stacked boxes into a corner, on a plane with friction. The energy is no more than the work of the push. A
 * path that was bent by 10¹³ times what forces give, after an impact, was taken for a force that presses: in one scene of six with restitution 0.3 boxes
 * bounced at 10⁵ to 10¹¹ m/s.
 */
class RobotAtCornerTest {
    private static final double PUSH = 20;

    private final PhysicsEngine engine = new PhysicsEngine();

    private Body add(Body body, double friction, double restitution) {
        body.setFriction(friction);
        body.setRestitution(restitution);
        return engine.add(body);
    }

    @ParameterizedTest
    @ValueSource(longs = {51, 68, 71, 74, 83, 89, 92, 97, 101, 113, 117, 123})
    void itGivesNoMoreThanItsWork(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double restitution = 0.3 * random.nextInt(2);
        double friction = 0.3 * random.nextInt(4);
        engine.setTimeStep(random.nextBoolean() ? 1 / 60.0 : 0.04);
        engine.add(new SurfaceFriction(9.81));
        add(Body.fixed(new Rectangle(12, 2)).at(0, -1), friction, restitution);
        add(Body.fixed(new Rectangle(2, 8)).at(5, 4), friction, restitution);
        double width = 0.4 + 0.4 * random.nextDouble();
        int boxes = 5 + random.nextInt(4);
        for (int k = 0; k < boxes; k++) {
            double gap = random.nextInt(10) < 7 ? 0 : 0.01;
            Body box = new Body(new Rectangle(width, width));
            box.at(4 - width / 2 - k % 3 * (width + gap), width / 2 + k / 3 * (width + gap));
            box.setSurfaceFriction(0.05 + 0.5 * random.nextDouble());
            add(box, friction, restitution);
        }
        Body robot = new Body(new Compound(Compound.disc(0, 0, 0.35), Compound.box(0.55, 0.25, 0.5, 0.12), Compound.box(0.55, -0.25, 0.5, 0.12)));
        add(robot.at(-3, 1.2), friction, restitution);
        double work = 0;
        for (int k = 0; k < 60; k++) {
            double fx = PUSH * StrictMath.cos(robot.getAngle());
            double fy = PUSH * StrictMath.sin(robot.getAngle());
            double x = robot.getX();
            double y = robot.getY();
            robot.addForce(fx, fy);
            engine.step();
            work += fx * (robot.getX() - x) + fy * (robot.getY() - y);
            assertThat(engine.kineticEnergy()).isLessThan(work + 0.01 * PUSH);
        }
    }
}
