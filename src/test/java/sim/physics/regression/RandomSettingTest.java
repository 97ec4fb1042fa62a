// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Joint;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.PairRule;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * A box of bodies and machines of which anything is set at any time, by agents and by a listener: nothing throws or is thrown about,
 * and a copy from a checkpoint, with more threads, does the same to the bit.
 */
class RandomSettingTest {
    private static final double FASTEST = 100;

    private static final class World implements CollisionListener, Serializable {
        private static final long serialVersionUID = 1L;

        private final PhysicsEngine engine = new PhysicsEngine();
        private final Random random;
        private final List<Body> bodies = new ArrayList<>();
        private final List<Joint> joints = new ArrayList<>();
        private final List<Motor> motors = new ArrayList<>();

        World(long seed) {
            random = new Random(seed);
            engine.setTimeStep(1.0 / 60);
            engine.add(new Gravity(0, -10));
            for (int k = 0; k < 4; k++) {
                boolean isFlat = k < 2;
                int side = k % 2 == 0 ? -1 : 1;
                Body wall = Body.fixed(isFlat ? new Rectangle(30, 1) : new Rectangle(1, 30));
                bodies.add(engine.add(wall.at(isFlat ? 0 : 12 * side, isFlat ? 11 * side : 0)));
            }
            for (int k = 0; k < 20; k++) {
                boolean isRound = random.nextBoolean();
                Body body = new Body(isRound ? new Circle(0.3 + 0.4 * random.nextDouble()) : new Rectangle(1, 0.5 + random.nextDouble()));
                bodies.add(engine.add(body.at(-9 + 4.5 * (k % 5), -8 + 3 * (k / 5), random.nextDouble())));
                body.setRestitution(0.3 * random.nextInt(3));
            }
            bodies.forEach(body -> body.setFriction(0.5));
            for (int k = 0; k < 6; k++) {
                tie(bodies.get(4 + 2 * k), bodies.get(5 + 2 * k), k % 3);
            }
            engine.addListener(this);
        }

        private void tie(Body a, Body b, int how) {
            double x = (a.getX() + b.getX()) / 2;
            double y = (a.getY() + b.getY()) / 2;
            joints.add(engine.add(
                    how == 0
                            ? new PinJoint(a, b, x, y)
                            : how == 1
                                    ? new RodJoint(a, a.getX(), a.getY(), b, b.getX(), b.getY())
                                    : new SliderJoint(a, b, x, y, 1, 0)));
            if (how == 0) {
                motors.add(engine.add(Motor.turning(a, b, 1, 20)));
            }
        }

        private <T> T any(List<T> list) {
            return list.get(random.nextInt(list.size()));
        }

        private void set() {
            Body body = any(bodies);
            Joint joint = any(joints);
            Motor motor = any(motors);
            switch (random.nextInt(9)) {
                case 0, 1 -> body.setFriction(0.4 * random.nextInt(3));
                case 2 -> joint.setCollideConnected(!joint.isCollideConnected());
                case 3 -> engine.setPairRules(PairRule.MINIMUM, PairRule.values()[random.nextInt(5)]);
                case 4 -> motor.setSpeed(random.nextInt(5) - 2);
                case 5 -> motor.setLimit(1 + random.nextInt(40));
                case 6 -> motor.setCollideConnected(random.nextBoolean());
                case 7 -> joint.setBreakingLoad(1e5 + random.nextInt(100), 1e6); // never reached
                default -> setMass(body, 0.5 + random.nextDouble());
            }
        }

        private static void setMass(Body body, double mass) {
            if (!body.isFixed()) {
                body.setMass(mass);
            }
        }

        private void step() {
            if (random.nextInt(3) == 0) {
                set();
            }
            engine.step();
        }

        @Override
        public void collided(Contact contact) {
            if (random.nextInt(4) == 0) {
                set();
            }
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {0, 1, 2, 3, 4, 5})
    void anythingIsSetAtAnyTime(long seed) {
        World world = new World(seed);
        for (int k = 0; k < 100; k++) {
            world.step();
        }
        World copy = Checkpoint.copy(world);
        copy.engine.setThreads(3);
        for (int k = 0; k < 100; k++) {
            world.step();
            copy.step();
            Checkpoint.assertSameBodies(copy.engine, world.engine);
            for (Body body : world.bodies) {
                assertThat(Math.hypot(body.getVelocityX(), body.getVelocityY())).isLessThan(FASTEST);
            }
        }
    }
}
