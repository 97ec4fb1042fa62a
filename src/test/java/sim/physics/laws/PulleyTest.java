// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.hipparchus.ode.ODEState;
import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.hipparchus.ode.nonstiff.DormandPrince853Integrator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Equations;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.PulleyJoint;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Ropes over pulleys against Atwood's machine, at rest, swinging, and slack. */
class PulleyTest {
    private static final double G = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final Body left = engine.add(new Body(new Circle(0.1)).at(-1, -2));
    private final Body right = engine.add(new Body(new Rectangle(0.3, 0.2)).at(1, -3));

    PulleyTest() {
        left.setMass(2);
        right.setMass(5);
    }

    private PulleyJoint rope(double ratio) {
        return PulleyJoint.worldPoints(left, -1, -2, -1, 0, right, 1, -2.9, 1, 0, ratio);
    }

    private void go(double time, int steps) {
        engine.setTimeStep(time / steps);
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    /** What the right one falls by: k v for the left one, (m + M / k²) a = (M / k − m) g for the left one's acceleration a. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 2, 2.5, 4})
    void atwoodsMachineRunsEvenly(double ratio) {
        engine.add(new Gravity(0, -G));
        PulleyJoint rope = engine.add(rope(ratio));
        double a = (5 / ratio - 2) * G / (2 + 5 / (ratio * ratio));
        go(0.5, 10);
        assertThat(left.getY()).isCloseTo(-2 + a / 8, within(1e-13));
        assertThat(right.getY()).isCloseTo(-3 - a / 8 / ratio, within(1e-13));
        assertThat(right.getVelocityY()).isCloseTo(-a / 2 / ratio, within(1e-13));
        assertThat(left.getX()).isEqualTo(-1);
        assertThat(right.getAngle()).isZero();
        double tension = 2 * (G + a);
        assertThat(engine.getReaction(rope).forceY()).isCloseTo(tension, within(1e-12));
        assertThat(ratio * tension).isCloseTo(5 * (G - a / ratio), within(1e-12)); // what the strands of the other side bear
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 4})
    void atwoodsMachineRunsByTimeSteppingToo(int substeps) {
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(0, -G));
        engine.add(rope(1));
        double a = 3 * G / 7;
        go(0.5, 60);
        assertThat(left.getY()).isCloseTo(-2 + a / 8, within(2e-3));
        assertThat(left.getVelocityY()).isCloseTo(a / 2, within(1e-6));
        assertThat(left.getY() + right.getY()).isCloseTo(-5, within(1e-3 / (substeps * substeps))); // opened in a first step that knew no force
    }

    /** A constraint of an author's, of which nobody knows that it takes momentum. */
    private record Own(PulleyJoint rope) implements Constraint {
        private static final long serialVersionUID = 1L;

        @Override
        public Body getBodyA() {
            return rope.getBodyA();
        }

        @Override
        public Body getBodyB() {
            return rope.getBodyB();
        }

        @Override
        public int getRows() {
            return 1;
        }

        @Override
        public void evaluate(Equations equations) {
            rope.evaluate(equations);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 4})
    void aPulleyOfAnAuthorsRunsToo(int substeps) {
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(0, -G));
        engine.add(new Own(rope(1)));
        go(0.5, 60);
        assertThat(left.getVelocityY()).isCloseTo(1.5 * G / 7, within(1e-6));
    }

    /** Tufillaro, Abbott, Griffiths 1984: (M + m) r̈ = m r θ̇² + g (m cos θ − M), r θ̈ = − 2 ṙ θ̇ − g sin θ. */
    @ParameterizedTest
    @ValueSource(ints = {1, 7, 50})
    void theSwingingMachineIsWhereItsEquationsHaveIt(int steps) {
        Body bob = engine.add(new Body(new Circle(0.05)).at(-1 + 2 * Math.sin(0.9), -2 * Math.cos(0.9)));
        Body weight = engine.add(new Body(new Circle(0.1)).at(3, -4));
        weight.setMass(2.4);
        bob.setMass(1);
        engine.remove(left);
        engine.remove(right);
        engine.add(new Gravity(0, -G));
        engine.add(PulleyJoint.bodyPoints(bob, 0, 0, -1, 0, weight, 0, 0, 3, 0, 1, 6));
        engine.setIntegrator(new DormandPrince853(1e-12));
        go(3, steps);
        OrdinaryDifferentialEquation swing = new OrdinaryDifferentialEquation() {
            @Override
            public int getDimension() {
                return 4;
            }

            @Override
            public double[] computeDerivatives(double t, double[] s) {
                double r = (s[0] * s[3] * s[3] + G * (Math.cos(s[1]) - 2.4)) / 3.4;
                return new double[] {s[2], s[3], r, (-2 * s[2] * s[3] - G * Math.sin(s[1])) / s[0]};
            }
        };
        double[] end = new DormandPrince853Integrator(1e-8, 1, 1e-14, 1e-14)
                .integrate(swing, new ODEState(0, new double[] {2, 0.9, 0, 0}), 3).getPrimaryState();
        assertThat(bob.getX()).isCloseTo(-1 + end[0] * Math.sin(end[1]), within(1e-10));
        assertThat(bob.getY()).isCloseTo(-end[0] * Math.cos(end[1]), within(1e-10));
        assertThat(weight.getY()).isCloseTo(-6 + end[0], within(1e-10));
    }

    /** Without weight, and started with no momentum and no angular momentum: the pulleys give some, and only the energy stays. */
    @Test
    void pulleysTakeMomentum() {
        right.setMass(2);
        engine.add(rope(1));
        left.setVelocity(-0.7, 0.35); // along the line between the two
        right.setVelocity(0.7, -0.35);
        double energy = engine.kineticEnergy();
        go(0.5, 100);
        assertThat(engine.kineticEnergy()).isCloseTo(energy, within(1e-12 * energy));
        assertThat(Math.hypot(left.getX() + 1, left.getY()) + Math.hypot(worldX(), worldY())).isCloseTo(4.9, within(1e-12));
        double swung = Math.abs(left.getVelocityY() + right.getVelocityY());
        assertThat(swung).isGreaterThan(0.05);
    }

    private double worldX() {
        return right.worldX(0, 0.1) - 1;
    }

    private double worldY() {
        return right.worldY(0, 0.1);
    }

    /** Its end at rest, a rope that has slack is not felt; when it is taut both go on with the momentum of the one that fell. */
    @Test
    void aSlackRopeStartsBothAtOnce() {
        PulleyJoint rope = PulleyJoint.bodyPoints(left, 0, 0, -1, 0, right, 0, 0, 1, 0, 1, 5.5);
        engine.add(new Limit(rope, Double.NEGATIVE_INFINITY, 0, 0));
        right.setVelocity(0, -1);
        go(0.25, 5);
        assertThat(left.getVelocityY()).isZero();
        assertThat(right.getY()).isCloseTo(-3.25, within(1e-14));
        go(0.5, 10);
        assertThat(right.getVelocityY()).isCloseTo(-5 / 7.0, within(1e-13));
        assertThat(left.getVelocityY()).isCloseTo(5 / 7.0, within(1e-13));
        assertThat(right.getY()).isCloseTo(-3.5 - 0.25 * 5 / 7, within(1e-12));
    }

    /** It swings round its pulley, much faster than a step can follow, and goes back. It got two fifths of its energy for that before. */
    @Test
    void whatPassesCloseByItsPulleyGainsNoEnergy() {
        engine.add(new Gravity(0, -G));
        Body light = engine.add(new Body(new Rectangle(0.5, 0.5)).at(0.01, 4));
        light.setMass(0.5);
        Body heavy = engine.add(new Body(new Rectangle(0.5, 0.5)).at(3, 4));
        heavy.setMass(2);
        engine.add(PulleyJoint.worldPoints(light, 0.01, 4, 0, 5, heavy, 3, 4, 3, 5, 1));
        double lowest = 2;
        double largest = 0;
        for (int k = 0; k < 120; k++) {
            go(1 / 60.0, 1);
            lowest = Math.min(lowest, Math.hypot(light.getX(), light.getY() - 5));
            double kinetic = light.kineticEnergy() + heavy.kineticEnergy();
            largest = Math.max(largest, kinetic + G * (0.5 * (light.getY() - 4) + 2 * (heavy.getY() - 4)));
        }
        assertThat(lowest).isLessThan(0.1);
        assertThat(largest).isLessThan(0.02);
    }

    /** Kept on a taut rope by a stop of a rope, which lets go of nothing that pulls. */
    @Test
    void aTautRopeOfAStopIsTheJoint() {
        engine.add(new Gravity(0, -G));
        engine.add(new Limit(rope(1), Double.NEGATIVE_INFINITY, 0, 0));
        go(0.5, 10);
        assertThat(left.getY()).isCloseTo(-2 + 3 * G / 7 / 8, within(1e-12));
    }

    /** A winch: the rate of the length is that of the motor, whatever hangs there. */
    @Test
    void aMotorWindsTheRopeIn() {
        engine.add(new Gravity(0, -G));
        engine.add(new PinJoint(right, 1, -3)); // which holds it
        engine.add(new Motor(rope(1), -0.5, 1000));
        go(1, 20);
        assertThat(left.getVelocityY()).isCloseTo(0.5, within(1e-12));
        double start = (1000 - 2 * G) / 2; // with all that it can
        assertThat(left.getY()).isCloseTo(-1.5 - 0.125 / start, within(1e-10));
    }

    @Test
    void theLengthCanBeSet() {
        PulleyJoint rope = engine.add(rope(1));
        assertThat(rope.getLength()).isCloseTo(4.9, within(1e-15));
        assertThat(rope.isCollideConnected()).isTrue();
        rope.setLength(4.2);
        go(0.1, 1);
        assertThat(-left.getY() - right.worldY(0, 0.1)).isCloseTo(4.2, within(1e-12));
        assertThat(left.getY()).isCloseTo(-2 + 0.7 * 5 / 7, within(1e-12)); // least move in the metric of the masses
        assertThat(engine.kineticEnergy()).isZero();
    }

    @Test
    void whatIsNoRopeIsRefused() {
        assertThatThrownBy(() -> rope(0)).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("ratio is 0.0");
        assertThatThrownBy(() -> rope(Double.NaN)).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("ratio is NaN");
        assertThatThrownBy(() -> PulleyJoint.bodyPoints(left, 0, 0, -1, Double.POSITIVE_INFINITY, right, 0, 0, 1, 0, 1, 5))
                .isInstanceOf(IllegalArgumentException.class).hasMessageContaining("y of a pulley is Infinity");
        assertThatThrownBy(() -> PulleyJoint.bodyPoints(left, 0, 0, -1, 0, right, 0, 0, 1, 0, 1, -5))
                .isInstanceOf(IllegalArgumentException.class).hasMessageContaining("length is -5.0");
        assertThatThrownBy(() -> PulleyJoint.bodyPoints(left, 0, 0, -1, 0, null, 0, 0, 1, 0, 1, 5))
                .isInstanceOf(NullPointerException.class).hasMessageContaining("both ends");
        assertThatThrownBy(() -> PulleyJoint.worldPoints(left, -1, -2, -1, -2, right, 1, -3, 1, -3, 1))
                .isInstanceOf(IllegalArgumentException.class).hasMessageContaining("length of the rope is 0.0");
        assertThatThrownBy(() -> rope(1).setLength(Double.NaN)).isInstanceOf(IllegalArgumentException.class);
    }
}
