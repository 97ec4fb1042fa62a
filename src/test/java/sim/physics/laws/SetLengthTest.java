// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.ConstraintException;
import sim.physics.constraint.Limit;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;

/** Lengths of rods and ropes, and the bounds of stops, may be set at any time. */
class SetLengthTest {
    private static final double G = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final Body bob = engine.add(new Body(new Circle(0.1)).at(1, 0));

    private void begin(int substeps) {
        engine.setTimeStep(0.01);
        engine.setTimeStepping(substeps);
    }

    private void run(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    private double distance() {
        return Math.hypot(bob.getX(), bob.getY());
    }

    private double energy() {
        double square = bob.getVelocityX() * bob.getVelocityX() + bob.getVelocityY() * bob.getVelocityY();
        return 0.5 * square + G * bob.getY();
    }

    /** It is moved along the rod, keeps what velocity it has across it, and swings on with the new length. */
    @ParameterizedTest
    @CsvSource({"0, 1e-12, 1e-7", "4, 1e-3, 1e-3"})
    void aRodIsClosedAsWhenABodyIsMoved(int substeps, double gap, double drift) {
        begin(substeps);
        engine.add(new Gravity(0, -G));
        RodJoint rod = engine.add(RodJoint.bodyPoints(bob, 0, 0, null, 0, 0));
        run(50);
        double vx = bob.getVelocityX();
        double angle = StrictMath.atan2(bob.getY(), bob.getX());
        rod.setLength(1.5);
        assertThat(rod.getLength()).isEqualTo(1.5);
        engine.step();
        assertThat(distance()).isCloseTo(1.5, within(gap));
        double way = 0.01 * Math.hypot(vx, bob.getVelocityY()) / 1.5;
        assertThat(StrictMath.atan2(bob.getY(), bob.getX())).isCloseTo(angle, within(1.1 * way));
        assertThat(bob.getVelocityX()).isCloseTo(vx, within(0.1));
        double before = energy();
        run(100);
        assertThat(distance()).isCloseTo(1.5, within(gap));
        assertThat(energy()).isCloseTo(before, within(drift * G));
    }

    /** What counts as closed is a part of a rod's new length, whatever it was before. */
    @ParameterizedTest
    @CsvSource({"1000, 1", "1, 1000"})
    void aRodMayBecomeAThousandTimesAsLongOrAsShort(double from, double to) {
        begin(0);
        engine.setTimeStep(1e-3);
        engine.add(new Gravity(0, -G));
        bob.setPosition(from, 0);
        RodJoint rod = engine.add(RodJoint.bodyPoints(bob, 0, 0, null, 0, 0));
        engine.step();
        rod.setLength(to);
        for (int k = 0; k < 2000; k++) {
            engine.step();
            assertThat(distance()).isCloseTo(to, within(1e-14 * to));
        }
    }

    /** A fall onto a rope: longer it lets the bob fall on, shorter it holds it where it is. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aRopeIsPaidOutAndDoesNotPull(int substeps) {
        begin(substeps);
        engine.add(new Gravity(0, -G));
        bob.setPosition(0, -1);
        Limit rope = engine.add(Limit.rope(bob, 0, 0, null, 0, 0, 1));
        RodJoint length = (RodJoint) rope.getCoordinate();
        run(20);
        assertThat(bob.getY()).isCloseTo(-1, within(1e-4));
        length.setLength(1.25);
        run(10);
        assertThat(bob.getVelocityY()).isCloseTo(-0.1 * G, within(1e-9));
        run(90);
        assertThat(bob.getY()).isCloseTo(-1.25, within(1e-4));
        length.setLength(0.9);
        for (int k = 0; k < 100; k++) {
            engine.step();
            assertThat(bob.getVelocityY()).isCloseTo(0, within(1e-9));
            assertThat(engine.getReaction(rope).forceY()).isCloseTo(bob.getMass() * G, within(1e-6));
        }
        assertThat(bob.getY()).isCloseTo(substeps == 0 ? -1.25 : -0.9, within(1e-4));
    }

    /** The turn goes on to wherever the stop is when it gets there. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void stopsAreSetAsTheyTurn(int substeps) {
        begin(substeps);
        bob.setPosition(0, 0);
        engine.add(new PinJoint(bob, 0, 0));
        Limit stops = engine.add(Limit.angle(bob, null, -1, 1));
        bob.setAngularVelocity(1);
        run(50);
        stops.setBounds(-1, 0.7);
        run(100);
        assertThat(bob.getAngle()).isCloseTo(0.7, within(1e-9));
        stops.setBounds(-1, 0.2);
        for (int k = 0; k < 100; k++) {
            engine.step();
            assertThat(bob.getAngularVelocity()).isCloseTo(0, within(1e-9));
        }
        assertThat(bob.getAngle()).isCloseTo(substeps == 0 ? 0.7 : 0.2, within(1e-9));
        bob.setAngularVelocity(-1);
        run(50);
        assertThat(bob.getAngle()).isCloseTo(substeps == 0 ? 0.2 : -0.3, within(1e-9));
        stops.setBounds(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
        run(300);
        assertThat(bob.getAngle()).isCloseTo(substeps == 0 ? -2.8 : -3.3, within(1e-9));
        assertThat(stops.getLower()).isEqualTo(Double.NEGATIVE_INFINITY);
    }

    /** What the listener of an impact sets at half of the step holds for the other half. */
    @Test
    void aListenerSetsThemWithinAStep() {
        engine.setTimeStep(1);
        bob.setPosition(0, 0);
        engine.add(new PinJoint(bob, 0, 0));
        Limit stops = engine.add(Limit.angle(bob, null, -1, 10));
        bob.setAngularVelocity(1);
        Body other = engine.add(new Body(new Circle(0.1)).at(0, 9));
        RodJoint rod = engine.add(RodJoint.bodyPoints(other, 0, 0, null, 0, 8));
        engine.add(new Body(new Circle(0.125)).at(50, 50).moving(1, 0));
        engine.add(Body.fixed(new Circle(0.125)).at(50.75, 50));
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public void collided(Contact contact) {
                stops.setBounds(-1, 0.75);
                rod.setLength(2);
            }
        });
        engine.step();
        assertThat(bob.getAngle()).isCloseTo(0.75, within(1e-9));
        assertThat(other.getY()).isCloseTo(10, within(1e-12));
    }

    @Test
    void sleepersWakeWhenTheirRopesAndStopsAreSet() {
        begin(4);
        engine.add(new Gravity(0, -G));
        bob.setPosition(0, -1);
        Limit rope = engine.add(Limit.rope(bob, 0, 0, null, 0, 0, 1));
        run(500);
        assertThat(engine.isAsleep(bob)).isTrue();
        rope.setBounds(Double.NEGATIVE_INFINITY, 0.5);
        run(100);
        assertThat(bob.getY()).isCloseTo(-1.5, within(1e-3));
        run(500);
        assertThat(engine.isAsleep(bob)).isTrue();
        ((RodJoint) rope.getCoordinate()).setLength(1.2);
        run(100);
        assertThat(bob.getY()).isCloseTo(-1.7, within(1e-3));
    }

    /** As when a body is put beyond the reach of its chain: the step is refused once, and may be mended. */
    @Test
    void aRodThatCannotBeClosedIsToldOfOnce() {
        begin(0);
        RodJoint first = engine.add(RodJoint.bodyPoints(bob, 0, 0, null, 0, 0));
        RodJoint second = engine.add(RodJoint.bodyPoints(bob, 0, 0, null, 2, 0.5));
        second.setLength(0.5);
        assertThatThrownBy(engine::step).isInstanceOf(ConstraintException.class);
        assertThat(bob.getX()).isEqualTo(1);
        first.setLength(2);
        run(10);
        assertThat(distance()).isCloseTo(2, within(1e-12));
        assertThat(Math.hypot(bob.getX() - 2, bob.getY() - 0.5)).isCloseTo(0.5, within(1e-12));
    }

    @Test
    void whatIsNoLengthIsRefusedAndNothingChanges() {
        RodJoint rod = RodJoint.bodyPoints(bob, 0, 0, null, 0, 0);
        for (double bad : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThatThrownBy(() -> rod.setLength(bad)).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("length");
        }
        assertThat(rod.getLength()).isEqualTo(1);
        Limit stops = Limit.angle(bob, null, -1, 1);
        double[][] bounds = {{1, 1}, {2, 1}, {Double.NaN, 1}, {-1, Double.NaN}};
        for (double[] bad : bounds) {
            assertThatThrownBy(() -> stops.setBounds(bad[0], bad[1]))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("lower is " + bad[0]);
        }
        assertThat(stops.getLower()).isEqualTo(-1);
        assertThat(stops.getUpper()).isEqualTo(1);
    }
}
