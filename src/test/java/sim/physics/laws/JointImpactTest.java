// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.response.BorderedImpulse;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Impacts on jointed bodies, (47)–(54): closed forms, and the write-up's system against the islands' replies. */
class JointImpactTest {
    /** Keeps the velocities right after the first impact. */
    private static final class Snapshot implements CollisionListener {
        private static final long serialVersionUID = 1L;

        private final Body[] bodies;
        private double[] velocities;

        Snapshot(Body... bodies) {
            this.bodies = bodies;
        }

        @Override
        public void collided(Contact contact) {
            if (velocities == null) {
                velocities = new double[3 * bodies.length];
                for (int k = 0; k < bodies.length; k++) {
                    velocities[3 * k] = bodies[k].getVelocityX();
                    velocities[3 * k + 1] = bodies[k].getVelocityY();
                    velocities[3 * k + 2] = bodies[k].getAngularVelocity();
                }
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"1.1, 1", "0.3, 1", "1.9, 0.5", "1.3333333333333333, 0"})
    void aBallStrikesAPinnedRod(double d, double e) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        Body rod = engine.add(new Body(new Rectangle(2, 0.02)).at(1, 0));
        rod.setMass(3, 1);
        engine.add(new PinJoint(rod, 0, 0));
        Body ball = engine.add(new Body(new Circle(0.1)).at(d, -0.15).moving(0, 2));
        ball.setMass(1.3);
        ball.setRestitution(e);
        Snapshot after = new Snapshot(rod, ball);
        engine.addListener(after);
        for (int k = 0; k < 10; k++) {
            engine.step();
        }
        double impulse = (1 + e) * 2 / (1 / 1.3 + 3 * d * d / (3 * 4));
        assertThat(after.velocities[4]).isCloseTo(2 - impulse / 1.3, within(1e-13));
        assertThat(after.velocities[2]).isCloseTo(impulse * d * 3 / (3 * 4), within(1e-13));
        double pin = 3 * after.velocities[1] - impulse;
        assertThat(pin).isCloseTo(impulse * (3 * d / 4 - 1), within(1e-12));
    }

    @Test
    void twoHingedRodsAreStruckAtTheEnd() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        Body first = engine.add(new Body(new Rectangle(1, 0.02)).at(0.5, 0));
        Body second = engine.add(new Body(new Rectangle(1, 0.02)).at(1.5, 0));
        first.setMass(1, 1 / 12.0);
        second.setMass(1, 1 / 12.0);
        engine.add(new PinJoint(first, second, 1, 0));
        Body ball = engine.add(new Body(new Circle(0.1)).at(0, -0.15).moving(0, 1));
        ball.setMass(1);
        Snapshot after = new Snapshot(first, second, ball);
        engine.addListener(after);
        for (int k = 0; k < 8; k++) {
            engine.step();
        }
        double impulse = 1 - after.velocities[7];
        assertThat(impulse).isCloseTo(2 / (1 + 1.25 + 2.25), within(1e-13));
        assertThat(after.velocities[1]).isCloseTo(1.25 * impulse, within(1e-13));
        assertThat(after.velocities[2]).isCloseTo(-4.5 * impulse, within(1e-13));
        assertThat(after.velocities[4]).isCloseTo(-0.25 * impulse, within(1e-13));
        assertThat(after.velocities[5]).isCloseTo(1.5 * impulse, within(1e-13));
    }

    /** A ball hits a link of a chain between two anchors, or one that hangs free. */
    private static double[] strike(long seed, boolean bordered, boolean bothEnds) {
        SplittableRandom random = new SplittableRandom(seed);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        if (bordered) {
            engine.setImpulseSolver(new BorderedImpulse());
        }
        int n = 8;
        Body[] all = new Body[n + 1];
        double x = 0;
        double y = 0;
        for (int k = 0; k < n; k++) {
            double angle = bothEnds ? (k % 2 == 0 ? 0.1 : -0.1) : random.nextDouble(-0.4, 0.4);
            double cos = StrictMath.cos(angle);
            double sin = StrictMath.sin(angle);
            all[k] = engine.add(new Body(new Rectangle(1, 0.05)).at(x + cos / 2, y + sin / 2, angle));
            all[k].setMass(random.nextDouble(0.5, 2));
            engine.add(k == 0 ? new PinJoint(all[0], 0, 0) : new PinJoint(all[k - 1], all[k], x, y));
            x += cos;
            y += sin;
        }
        if (bothEnds) {
            engine.add(new PinJoint(all[n - 1], x, y));
        }
        Body target = all[3];
        all[n] = engine.add(new Body(new Circle(0.2)).at(target.getX() + 0.1, target.getY() - 0.5).moving(0.3, 3));
        Snapshot after = new Snapshot(all);
        engine.addListener(after);
        for (int k = 0; k < 20; k++) {
            engine.step();
        }
        return after.velocities;
    }

    @Test
    void theWriteUpsSystemAndTheIslandsRepliesAgree() {
        for (long seed = 1; seed <= 20; seed++) {
            for (boolean bothEnds : new boolean[] {false, true}) {
                assertThat(strike(seed, true, bothEnds)).containsExactly(strike(seed, false, bothEnds), within(1e-9));
            }
        }
    }
}
