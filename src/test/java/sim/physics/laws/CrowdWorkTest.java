// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What a crowd on a plane costs, seen from above: an exact count, the same on every machine. */
class CrowdWorkTest {
    private static final double SIDE = 4;
    private static final int STEPS = 600;

    /** Discs that push boxes about, by forces that are set anew in each step; returns the work of a step. */
    private static double work(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.add(new SurfaceFriction(9.81));
        for (int end = 0; end < 2; end++) {
            engine.add(Body.fixed(new Rectangle(1, SIDE + 2)).at(end * (SIDE + 1) - 0.5, SIDE / 2));
            engine.add(Body.fixed(new Rectangle(SIDE + 2, 1)).at(SIDE / 2, end * (SIDE + 1) - 0.5));
        }
        Body[] robots = new Body[8];
        double[] headings = new double[robots.length];
        for (int k = 0; k < 16; k++) {
            boolean isRobot = k % 2 == 0;
            Body body = new Body(isRobot ? new Circle(0.2) : new Rectangle(0.6, 0.4)).at(0.5 + k % 4, 0.5 + k / 4, 6 * random.nextDouble());
            body.setMass(isRobot ? 3 : 2);
            body.setSurfaceFriction(isRobot ? 0 : 0.4);
            body.setRestitution(0.1);
            body.setFriction(0.2);
            engine.add(body);
            if (isRobot) {
                robots[k / 2] = body;
            }
        }
        for (int step = 0; step < STEPS; step++) {
            for (int k = 0; k < robots.length; k++) {
                headings[k] = random.nextInt(60) == 0 || step == 0 ? 6.28 * random.nextDouble() : headings[k];
                robots[k].addForce(
                        20 * (0.6 * Math.cos(headings[k]) - robots[k].getVelocityX()),
                        20 * (0.6 * Math.sin(headings[k]) - robots[k].getVelocityY()));
            }
            engine.step();
        }
        assertThat(engine.getRelievedSteps()).isZero();
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-7);
        return (double) engine.getWork() / STEPS;
    }

    /** It took 1.4 times as much when plane, contacts and places were solved for in turns until their last digits were right. */
    @Test
    void whatRobotsPushIsSolvedInAFewTurns() {
        double sum = 0;
        for (long seed = 0; seed < 6; seed++) {
            sum += work(seed);
        }
        assertThat(sum / 6).isLessThan(580);
    }
}
