// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** More supports than a body needs: all of them bear it, and what rolls on them is moved by all. */
class SharedLoadTest {
    private static final double G = 9.81;
    private static final double FORCE = 25;
    private static final double MASS = 10;
    private static final int ROLLERS = 5;

    /** Of the plate, whose rollers of mass 1 go at half its speed and turn as fast as they go: F / (M + 3 n m / 8). */
    private static final double ACCELERATION = FORCE / (MASS + 3 * ROLLERS / 8.0);

    /** A force on one body, which nobody knows to be constant. */
    private record Push(Body pushed, double force) implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public boolean actsOn(Body body) {
            return body == pushed;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, force, 0);
        }
    }

    private final PhysicsEngine engine = new PhysicsEngine();
    private final List<Body> rollers = new ArrayList<>();
    private Body plate;

    private Body put(Body body, double mass, double inertia) {
        body.setMass(mass, inertia);
        body.setFriction(0.8);
        body.setRestitution(0);
        return engine.add(body);
    }

    /** A plate of 12 m on five rollers of radius 1/2, on the ground. */
    private void build(double drop, double friction) {
        engine.add(new Gravity(0, -G));
        plate = put(new Body(new Rectangle(12, 0.2)).at(0, 1.1 + drop), MASS, MASS * 144.04 / 12);
        for (int k = 0; k < ROLLERS; k++) {
            rollers.add(put(new Body(new Circle(0.5)).at(2 * k - ROLLERS + 1, 0.5), 1, 0.125));
        }
        Body ground = Body.fixed(new Rectangle(60, 2)).at(0, -1);
        ground.setFriction(friction);
        ground.setRestitution(0);
        engine.add(ground);
    }

    /** Pushes the plate for a second. */
    private void push(boolean byGenerator, int steps) {
        engine.setTimeStep(1.0 / steps);
        if (byGenerator) {
            engine.add(new Push(plate, FORCE));
        }
        for (int k = 0; k < steps; k++) {
            if (!byGenerator) {
                plate.addForce(FORCE, 0);
            }
            engine.step();
        }
    }

    /** F t / (M + 3 n m / 8), and each roller turns with it. Where two of five bear the plate it is a tenth too fast. */
    @ParameterizedTest
    @CsvSource({
        "false, 15", "false, 60", "false, 120", "false, 480", "false, 1920", "true, 15", "true, 60", "true, 120", "true, 480", "true, 1920"
    })
    void aPlateThatIsPushedRollsOnAllItsRollers(boolean byGenerator, int steps) {
        build(0, 0.8);
        push(byGenerator, steps);
        double error = byGenerator ? 0.5 * ACCELERATION / steps : 1e-11; // what the integrator drives bounces before it lies there
        assertThat(plate.getVelocityX()).isCloseTo(ACCELERATION, within(error));
        assertThat(rollers).allSatisfy(roller -> assertThat(roller.getAngularVelocity()).isCloseTo(-ACCELERATION, within(error)));
        assertThat(engine.contacts()).hasSize(2 * ROLLERS);
        assertThat(engine.contacts(plate)).allSatisfy(contact -> assertThat(contact.normalForce()).isGreaterThan(1));
        double borne = engine.contacts(plate).stream().mapToDouble(LastingContact::normalForce).sum();
        assertThat(borne).isCloseTo(MASS * G, within(1e-3));
        assertThat(plate.getX()).isCloseTo(ACCELERATION / 2, within(Math.max(error, 1e-10)));
    }

    /** Also where it comes down on them, and bounces a little, before it lies there. */
    @ParameterizedTest
    @CsvSource({"1e-12, false", "1e-9, false", "1e-4, false", "0.1, false", "1e-12, true", "1e-7, true", "1e-4, true", "0.1, true"})
    void soDoesOneThatFallsOnThem(double drop, boolean byGenerator) {
        build(drop, 0.8);
        push(byGenerator, 120);
        assertThat(engine.contacts(plate)).hasSize(ROLLERS);
        assertThat(engine.contacts(plate)).allSatisfy(contact -> assertThat(contact.normalForce()).isGreaterThan(1));
        double mean = rollers.stream().mapToDouble(Body::getAngularVelocity).average().orElseThrow();
        assertThat(rollers).allSatisfy(roller -> assertThat(roller.getAngularVelocity()).isCloseTo(mean, within(1e-2)));
    }

    /**
     * Plates of any mass on two to seven rollers on the ground or on ice, put on them or let fall, which bounce or not, in any step: f / (M + 3 n m / 8),
     * or of n m / 3.
     */
    @ParameterizedTest
    @ValueSource(ints = {30, 60, 100, 120, 240, 500})
    void anyPlateRollsOnAllItsRollers(int steps) {
        for (double error : errors(steps, false)) {
            assertThat(error).isLessThan(1e-5);
        }
    }

    /** What the integrator drives bounces before it lies there, and now and then leaves a roller out: 2 of 100 plates, 15 when loads were not shared. */
    @Test
    void nearlyAllPlatesThatAGeneratorPushesDo() {
        long right = 0;
        for (int steps : new int[] {30, 60, 100, 120, 240, 500}) {
            right += Arrays.stream(errors(steps, true)).filter(error -> error < 1e-4).count();
        }
        assertThat(right).isGreaterThanOrEqualTo(68); // of 72
    }

    private static double[] errors(int steps, boolean byGenerator) {
        Random random = new Random(steps);
        double[] errors = new double[12];
        for (int k = 0; k < errors.length; k++) {
            SharedLoadTest other = new SharedLoadTest();
            int count = 2 + random.nextInt(6);
            double drop = random.nextInt(3) == 0 ? 0 : Math.pow(10, -1 - 11 * random.nextDouble());
            double friction = random.nextInt(4) == 0 ? 0 : 0.8;
            double mass = Math.pow(10, 2 * random.nextDouble() - 0.5);
            double speed = other.speed(count, drop, friction, mass, random.nextInt(3) == 0 ? 0.3 : 0, steps, byGenerator);
            double expected = 2.5 * mass / (mass + (friction > 0 ? 3 / 8.0 : 1 / 3.0) * count);
            errors[k] = Math.abs(speed / expected - 1);
        }
        return errors;
    }

    /** After 1 s under a force of 2.5 N a kg, when it has not left a roller yet. */
    private double speed(int count, double drop, double friction, double mass, double restitution, int steps, boolean byGenerator) {
        engine.setTimeStep(1.0 / steps);
        engine.add(new Gravity(0, -G));
        double width = 2 * count + 4;
        plate = put(new Body(new Rectangle(width, 0.2)).at(0, 1.1 + drop), mass, mass * (width * width + 0.04) / 12);
        for (int k = 0; k < count; k++) {
            put(new Body(new Circle(0.5)).at(2 * k - count + 1, 0.5), 1, 0.125);
        }
        engine.bodies().forEach(body -> body.setRestitution(restitution));
        Body ground = engine.add(Body.fixed(new Rectangle(100, 2)).at(0, -1));
        ground.setFriction(friction);
        ground.setRestitution(0);
        if (byGenerator) {
            engine.add(new Push(plate, 2.5 * mass));
        }
        for (int k = 0; k < steps; k++) {
            if (!byGenerator) {
                plate.addForce(2.5 * mass, 0);
            }
            engine.step();
        }
        return plate.getVelocityX();
    }

    /** Short steps make no hops: what forces press together parts no faster than they bring it back. */
    @ParameterizedTest
    @ValueSource(ints = {500, 1500, 4000, 10000, 100000})
    void noStepIsTooShortToLieStill(int rate) {
        build(0, 0.8);
        engine.setTimeStep(1.0 / rate);
        engine.add(new Push(plate, FORCE));
        double fastest = 0;
        for (int k = 0; k < 20; k++) {
            engine.step();
            fastest = Math.max(fastest, Math.abs(plate.getVelocityY()));
        }
        assertThat(fastest).isLessThan(4e-3);
    }

    /** What is pressed between a plate and ice does not turn, and does not hold the plate. */
    @Test
    void rollersOnIceGoWithThePlate() {
        build(0, 0);
        push(true, 120);
        double shared = FORCE / (MASS + ROLLERS / 3.0); // a disc moved at its rim: a = F/m + F r²/I = 3 F/m
        assertThat(plate.getVelocityX()).isCloseTo(shared, within(1e-4));
    }
}
