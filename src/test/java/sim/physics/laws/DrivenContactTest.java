// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Bodies that the integrator moves, for their joints or forces, and that lie on something. */
class DrivenContactTest {
    /** A spring of stiffness 1 per mass to the origin. */
    private static final class Pull implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, -body.getMass() * body.getX(), -body.getMass() * body.getY());
        }
    }

    private static final double GRAVITY = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();
    private Body chassis;
    private Body rear;
    private Body front;

    @BeforeEach
    void floor() {
        engine.setTimeStep(1 / 60.0);
        put(Body.fixed(new Rectangle(1000, 2)).at(0, -1), 0);
    }

    private Body put(Body body, double restitution) {
        body.setRestitution(restitution);
        body.setFriction(0.8);
        return engine.add(body);
    }

    /** A car, 0.7 above the floor, of mass 4 + 2 π/4. */
    private void car(double restitution) {
        engine.add(new Gravity(0, -GRAVITY));
        engine.bodies().get(0).setRestitution(restitution);
        chassis = put(new Body(new Rectangle(4, 1)).at(0, 2), restitution);
        rear = put(new Body(new Circle(0.5)).at(-1.2, 1.2), restitution);
        front = put(new Body(new Circle(0.5)).at(1.2, 1.2), restitution);
        engine.add(new PinJoint(chassis, rear, -1.2, 1.2));
        engine.add(new PinJoint(chassis, front, 1.2, 1.2));
    }

    private void run(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, 0.5})
    void aCarComesToRestOnItsWheels(double restitution) {
        car(restitution);
        run(300);
        long impacts = engine.getImpacts();
        run(300);
        assertThat(engine.getImpacts()).isEqualTo(impacts);
        assertThat(engine.kineticEnergy()).isLessThan(1e-20);
        assertThat(rear.getY()).isCloseTo(0.5, within(1e-6));
        assertThat(front.getY()).isCloseTo(0.5, within(1e-6));
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-6);
    }

    /** The rear wheel slips, and the front one rolls: N₁ = M' a / μ with M' = M + m/2, and the moments about the rear wheel. */
    @Test
    void aCarIsDrivenByItsSlippingWheel() {
        car(0.5);
        for (int k = 0; k < 240; k++) {
            rear.addTorque(-20);
            engine.step();
        }
        double wheel = Math.PI / 4;
        double mass = 4 + 2 * wheel;
        double pushed = mass + 0.5 * wheel;
        double weights = GRAVITY * (4 * 1.2 + wheel * 2.4);
        double turning = 4 * 1.3 + 2 * wheel * 0.5 - 0.5 * pushed + 0.25 * wheel;
        double acceleration = (2.4 * mass * GRAVITY - weights) / (2.4 * pushed / 0.8 - turning);
        double before = chassis.getVelocityX();
        long impacts = engine.getImpacts();
        for (int k = 0; k < 120; k++) {
            rear.addTorque(-20);
            engine.step();
        }
        assertThat((chassis.getVelocityX() - before) / 2).isCloseTo(acceleration, within(1e-5));
        assertThat(front.getAngularVelocity()).isCloseTo(-chassis.getVelocityX() / 0.5, within(1e-5));
        assertThat(engine.getImpacts()).isEqualTo(impacts);
    }

    /** A motor turns a wheel at its target speed, whether the wheel slips at first or not; in the end the car rolls. */
    @ParameterizedTest
    @ValueSource(doubles = {2, 5, 100})
    void aCarRollsAtTheSpeedOfItsMotor(double torque) {
        car(0.3);
        engine.add(Motor.turning(chassis, rear, -10, torque));
        run(540);
        long impacts = engine.getImpacts();
        run(60);
        assertThat(chassis.getVelocityX()).isCloseTo(-5, within(1e-7));
        assertThat(front.getAngularVelocity()).isCloseTo(10, within(1e-6));
        assertThat(rear.getY()).isCloseTo(0.5, within(1e-6));
        assertThat(engine.getImpacts()).isEqualTo(impacts);
    }

    @Test
    void aCheckpointGoesOnBitForBit() {
        car(0.3);
        run(70);
        PhysicsEngine copy = Checkpoint.copy(engine);
        run(80);
        for (int k = 0; k < 80; k++) {
            copy.step();
        }
        assertThat(copy.getImpacts()).isEqualTo(engine.getImpacts());
        for (int k = 0; k < 4; k++) {
            assertThat(copy.bodies().get(k).getX()).isEqualTo(engine.bodies().get(k).getX());
            assertThat(copy.bodies().get(k).getY()).isEqualTo(engine.bodies().get(k).getY());
            assertThat(copy.bodies().get(k).getAngle()).isEqualTo(engine.bodies().get(k).getAngle());
        }
    }

    /** On the floor without friction it swings as if that were not there. */
    @Test
    void aBoxIsPulledAlongTheFloor() {
        engine.add(new Pull());
        Body box = engine.add(new Body(new Rectangle(1, 1)).at(0.3, 1));
        box.setRestitution(0);
        run(600);
        assertThat(box.getX()).isCloseTo(0.3 * StrictMath.cos(10), within(1e-7));
        assertThat(box.getY()).isCloseTo(0.5, within(1e-6));
        assertThat(box.getAngle()).isCloseTo(0, within(1e-6));
        assertThat(engine.getImpacts()).isLessThan(30);
    }

    /** A robot pushes two boxes over the ground: (F − μ m g) / m, and the boxes stay together. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, 0.6})
    void aRobotPushesBoxesAgainstSurfaceFriction(double restitution) {
        engine.remove(engine.bodies().get(0));
        engine.add(new SurfaceFriction(GRAVITY));
        Body robot = put(new Body(new Circle(0.5)).at(0, 0), restitution);
        Body near = put(new Body(new Rectangle(1, 1)).at(1.3, 0), restitution);
        Body far = put(new Body(new Rectangle(1, 1)).at(2.5, 0), restitution);
        double mass = 0;
        for (Body body : engine.bodies()) {
            body.setSurfaceFriction(0.3);
            mass += body.getMass();
        }
        double before = 0;
        long impacts = 0;
        for (int k = 0; k < 300; k++) {
            if (k == 150) {
                before = far.getVelocityX();
                impacts = engine.getImpacts();
            }
            robot.addForce((0.3 * GRAVITY + 1) * mass, 0);
            engine.step();
        }
        assertThat((far.getVelocityX() - before) / 2.5).isCloseTo(1, within(1e-9));
        assertThat(near.getX() - robot.getX()).isCloseTo(1, within(1e-6));
        assertThat(far.getX() - near.getX()).isCloseTo(1, within(1e-6));
        assertThat(engine.getImpacts()).isEqualTo(impacts);
    }

    /** Chains whip on the ground; they must neither hang the engine nor sink. */
    @ParameterizedTest
    @ValueSource(ints = {2, 4, 6})
    void aChainFallsOnTheFloor(int links) {
        engine.add(new Gravity(0, -GRAVITY));
        Body last = null;
        for (int k = 0; k < links; k++) {
            Body link = put(new Body(new Rectangle(0.9, 0.3)).at(k + 0.5, 2 + 0.1 * k, 0.1), 0.4);
            link.setAngularVelocity(2 - k);
            if (last != null) {
                engine.assemble(new PinJoint(last, link, k, 2 + 0.1 * k - 0.05));
            }
            last = link;
        }
        long before = 0;
        for (int k = 0; k < 300; k++) {
            engine.step();
            assertThat(engine.getImpacts() - before).as("step %d", k).isLessThan(1_000);
            before = engine.getImpacts();
        }
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-6);
        assertThat(engine.kineticEnergy()).isLessThan(1e-3);
    }

    /** A car falls on a heap between walls: turning boxes do not close their contacts again and again. */
    @Test
    void aCarOnAHeapCostsABoundedNumberOfLooks() {
        engine.add(new Gravity(0, -GRAVITY));
        engine.bodies().get(0).setRestitution(0.3);
        engine.bodies().get(0).setFriction(0.5);
        engine.add(Body.fixed(new Rectangle(2, 40)).at(-6, 20));
        engine.add(Body.fixed(new Rectangle(2, 40)).at(6, 20));
        SplittableRandom random = new SplittableRandom(10);
        for (int k = 0; k < 14; k++) {
            Body body = new Body(k % 2 == 0 ? new Rectangle(1, 0.7) : new Circle(0.4));
            engine.add(body.at(-4 + 8 * random.nextDouble(), 1 + 1.3 * k));
            body.setAngle(random.nextDouble());
            body.setRestitution(0.3);
            body.setFriction(0.4);
        }
        Body cart = engine.add(new Body(new Rectangle(2, 0.5)).at(-4, 60));
        for (double x : new double[] {-4.6, -3.4}) {
            Body wheel = engine.add(new Body(new Circle(0.4)).at(x, 59.6));
            engine.add(new PinJoint(cart, wheel, x, 59.6));
        }
        for (int k = 0; k < 225; k++) {
            long before = engine.getNarrowPhaseEvaluations();
            engine.step();
            assertThat(engine.getNarrowPhaseEvaluations() - before).as("looks in step " + k).isLessThan(60_000);
        }
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-7);
    }
}
