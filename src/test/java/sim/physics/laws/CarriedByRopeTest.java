// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Equations;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PulleyJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.LastingContact;
import sim.physics.shape.Rectangle;

/** A box on a platform that hangs from ropes over pulleys, which may slacken or are wound: what acts on both is along unlike directions. */
class CarriedByRopeTest {
    private static final double G = 9.81;
    private static final int STEPS = 30;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final Body platform = put(0, 0, 2);
    private final Body box = put(0, 0.2, 10);
    private final Body weight = put(3, 0, 13);
    private final SliderJoint stand = engine.add(new SliderJoint(weight, null, 3, 0, 0, 1));

    CarriedByRopeTest() {
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -G));
        engine.add(new SliderJoint(platform, null, 0, 0, 0, 1));
    }

    private Body put(double x, double y, double mass) {
        Body body = engine.add(new Body(new Rectangle(0.6, 0.2)).at(x, y));
        body.setMass(mass);
        body.setRestitution(0);
        body.setFriction(0.5);
        return body;
    }

    private PulleyJoint rope(double ratio) {
        return PulleyJoint.worldPoints(weight, 3, 0, 3, 10, platform, 0, 0, 0, 10, ratio);
    }

    /** Runs, and sees that the box goes up with an acceleration, pressed on the platform, and is not struck after the first step. */
    private void risesBy(double a) {
        engine.step();
        long impacts = engine.getImpacts();
        for (int k = 1; k < STEPS; k++) {
            engine.step();
            assertThat(engine.contacts(box)).hasSize(1);
            LastingContact contact = engine.contacts(box).get(0);
            assertThat(contact.forceY(box)).isCloseTo(10 * (G + a), within(1e-3));
        }
        double time = STEPS / 60.0;
        assertThat(engine.getImpacts()).isEqualTo(impacts);
        assertThat(platform.getY()).isCloseTo(a * time * time / 2, within(1e-6));
        assertThat(box.getY() - platform.getY()).isCloseTo(0.2, within(1e-6));
    }

    /** What the weight falls by is the ratio times what the platform rises by. */
    @ParameterizedTest
    @ValueSource(doubles = {0.5, 1, 2, 4})
    void aRopeThatMaySlackenBearsBox(double ratio) {
        engine.add(new Limit(rope(ratio), Double.NEGATIVE_INFINITY, 0, 0));
        risesBy((ratio * 13 - 12) * G / (12 + ratio * ratio * 13));
    }

    @ParameterizedTest
    @ValueSource(doubles = {50, 150})
    void aWinchThatIsTooWeakPullsWithAllItHas(double force) {
        engine.remove(stand);
        engine.add(new WeldJoint(weight, null, 3, 0));
        Motor winch = engine.add(new Motor(rope(1), -100, force));
        risesBy(force / 12 - G);
        assertThat(engine.getReaction(winch).force()).isCloseTo(force, within(1e-9));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 3})
    void aMotorAlongCoordinateOfItsOwnLiftsBox(double ratio) {
        weight.setMass(1000);
        engine.add(new Motor(new Balance(platform, weight, ratio), 1000, 200));
        double a = (200 - 12 * G) / 12;
        risesBy(a);
        double time = STEPS / 60.0;
        assertThat(weight.getY()).isCloseTo((ratio * 200 / 1000 - G) * time * time / 2, within(1e-6));
    }

    /** The height of one body, and a multiple of that of another one: both go up together. */
    private static final class Balance implements Constraint {
        private static final long serialVersionUID = 1L;

        private final Body first;
        private final Body second;
        private final double ratio;

        Balance(Body first, Body second, double ratio) {
            this.first = first;
            this.second = second;
            this.ratio = ratio;
        }

        @Override
        public Body getBodyA() {
            return first;
        }

        @Override
        public Body getBodyB() {
            return second;
        }

        @Override
        public int getRows() {
            return 1;
        }

        @Override
        public void evaluate(Equations equations) {
            equations.set(0, first.getY() + ratio * second.getY(), 0);
            equations.setA(0, 0, 1, 0);
            equations.setB(0, 0, ratio, 0);
        }
    }
}
