// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.ConstraintException;
import sim.physics.constraint.Equations;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What authors put into one another, and what jams itself, gets no energy from that. */
class PutTogetherTest {
    private final PhysicsEngine engine = new PhysicsEngine();

    private static Body rough(Body body, double friction) {
        body.setRestitution(0);
        body.setFriction(friction);
        return body;
    }

    /** Rollers carry boxes away more slowly than new ones are put on them, into one another. */
    @Test
    void boxesOnAConveyorThatIsTooSlow() {
        engine.setTimeStep(0.01);
        engine.add(new Gravity(0, -9.81));
        for (int k = 0; k < 4; k++) {
            Body roller = engine.add(rough(new Body(new Circle(0.45)).at(k, 0), 0.8));
            roller.setMass(5);
            engine.add(new PinJoint(roller, k, 0));
            engine.add(Motor.turning(roller, null, -4, 50));
        }
        engine.add(rough(Body.fixed(new Rectangle(60, 1)).at(10, -5), 0.5));
        for (int k = 0; k < 700; k++) {
            if (k % 100 == 0) {
                engine.add(rough(new Body(new Rectangle(1.2, 0.6)).at(0.8, 1.2), 0.8)).setMass(2);
            }
            engine.step();
            for (Body body : engine.bodies()) { // a fall by 6 and a rim of 1.8 / s, with some turning
                assertThat(body.kineticEnergy()).as("%s at %s", body, engine.getTime()).isLessThan(2 * 9.81 * 6 + 100);
            }
        }
    }

    /** Free boxes on the ground, one in another; what they can get is the energy of their places. */
    @ParameterizedTest
    @CsvSource({"0.1, 0.01", "0.3, 0.01", "0.5, 0.1", "0.9, 0.001"})
    void boxesOnTheGroundInOneAnother(double depth, double step) {
        engine.setTimeStep(step);
        engine.add(new Gravity(0, -10));
        engine.add(rough(Body.fixed(new Rectangle(50, 1)).at(0, -0.5), 0.5));
        Body low = engine.add(rough(new Body(new Rectangle(1, 1)).at(0, 0.5), 0.5));
        Body high = engine.add(rough(new Body(new Rectangle(1, 1)).at(0.1, 1.5 - depth), 0.5));
        double energy = 10 * (low.getY() + high.getY());
        for (int k = 0; k < 200; k++) {
            engine.step();
            double now = engine.kineticEnergy() + 10 * (low.getY() + high.getY());
            assertThat(now).isLessThan(energy + 1e-6);
        }
    }

    /** A constraint of an author that throws while it is closed leaves the bodies where they were. */
    @Test
    void aConstraintThatThrowsWhenItIsAssembled() {
        Body ball = engine.add(new Body(new Circle(1)).at(3, 0));
        RodJoint far = new RodJoint(ball, 0, 0, null, 0, 0, 1);
        Throwing throwing = new Throwing(far);
        assertThatThrownBy(() -> engine.assemble(far, throwing)).hasMessage("an author's fault");
        assertThat(ball.getX()).isEqualTo(3);
        assertThat(engine.allConstraints()).isEmpty();
        engine.step();
        assertThat(ball.getX()).isEqualTo(3);
    }

    private static final class Throwing implements Constraint {
        private static final long serialVersionUID = 1L;
        private final RodJoint like;
        private int calls;

        Throwing(RodJoint like) {
            this.like = like;
        }

        @Override
        public Body getBodyA() {
            return like.getBodyA();
        }

        @Override
        public Body getBodyB() {
            return null;
        }

        @Override
        public int getRows() {
            return 1;
        }

        @Override
        public void evaluate(Equations equations) {
            if (++calls > 3) {
                throw new ArithmeticException("an author's fault");
            }
            like.evaluate(equations);
        }
    }

    /** A body that was put where its joint cannot be closed stays there, with numbers. */
    @Test
    void aJointThatCannotBeClosedWhereItsBodyIsPut() {
        Body ball = engine.add(new Body(new Circle(1)).at(3, 0));
        engine.add(new SliderJoint(ball, null, 3, 0, 1, 1));
        ball.setAngle(Double.MAX_VALUE);
        assertThatThrownBy(engine::step).isInstanceOf(ConstraintException.class);
        assertThat(ball.getX()).isEqualTo(3);
        assertThat(ball.getVelocityX()).isZero();
    }

    /** A joint so far from its body that the square of its arm overflows. */
    @Test
    void anArmWithoutMeasure() {
        Body ball = engine.add(new Body(new Circle(1)).at(3, 0));
        Body other = engine.add(new Body(new Circle(1)).at(9, 0));
        PinJoint pin = new PinJoint(ball, 1e300, 1e300, other, 0, 0);
        assertThatThrownBy(() -> engine.assemble(pin)).isInstanceOf(ConstraintException.class);
        assertThat(ball.getX()).isEqualTo(3);
        assertThat(engine.allConstraints()).isEmpty();
    }

    /** Its knees are at their stops and its feet on the ground: what they ask for together cannot be. */
    @Test
    void aWalkerThatJamsItself() {
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -9.81));
        engine.add(rough(Body.fixed(new Rectangle(400, 2)).at(0, -1), 0.9));
        Body torso = engine.add(rough(new Body(new Rectangle(2, 0.4)).at(0, 1.4), 0.5));
        Motor[] motors = new Motor[4];
        for (int k = 0; k < 2; k++) {
            double x = k == 0 ? -0.9 : 0.9;
            Body thigh = engine.add(rough(new Body(new Rectangle(0.15, 0.6)).at(x, 1), 0.9));
            Body shin = engine.add(rough(new Body(new Rectangle(0.15, 0.6)).at(x, 0.4), 0.9));
            engine.add(new PinJoint(torso, thigh, x, 1.3));
            engine.add(new PinJoint(thigh, shin, x, 0.7));
            motors[2 * k] = engine.add(Motor.turning(thigh, torso, 0, 20));
            motors[2 * k + 1] = engine.add(Motor.turning(shin, thigh, 0, 20));
            engine.add(Limit.angle(thigh, torso, -1, 1));
            engine.add(Limit.angle(shin, thigh, -1, 1));
        }
        SplittableRandom random = new SplittableRandom(44);
        double[] plan = random.doubles(8, 0, 6).toArray();
        for (int k = 0; k < 200; k++) {
            for (int m = 0; m < 4; m++) {
                motors[m].setSpeed(plan[m] * StrictMath.sin(plan[4 + m] + 5 * engine.getTime()));
            }
            engine.step();
            assertThat(engine.kineticEnergy()).isLessThan(200);
        }
    }
}
