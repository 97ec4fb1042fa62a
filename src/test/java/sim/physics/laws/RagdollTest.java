// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/**
 * A doll of eleven bodies with ten stops, thrown around a hand that is held: its stops meet within a step, drive one another
 * and let one another go. Every step ends, no stop is passed, and what the stops take of energy they never give back.
 */
class RagdollTest {
    private final PhysicsEngine engine = new PhysicsEngine();
    private final List<Body[]> pairs = new ArrayList<>();
    private final List<double[]> bounds = new ArrayList<>();

    private Body box(double w, double h, double x, double y) {
        Body body = engine.add(new Body(new Rectangle(w, h)).at(x, y));
        body.setMass(1, (w * w + h * h) / 12);
        body.setCollisionGroup(1, 0);
        return body;
    }

    private void join(Body a, Body b, double x, double y, double lower, double upper) {
        engine.add(new PinJoint(a, b, x, y));
        engine.add(Limit.angle(a, b, lower, upper));
        pairs.add(new Body[] {a, b});
        bounds.add(new double[] {lower, upper});
    }

    private void build(double spin) {
        engine.setTimeStep(1 / 240.0);
        engine.add(new Gravity(0, -9.81));
        Body torso = box(0.3, 0.5, 0, 0);
        Body hips = box(0.3, 0.2, 0, -0.35);
        join(hips, torso, 0, -0.25, -0.5, 0.5);
        join(box(0.2, 0.2, 0, 0.35), torso, 0, 0.25, -0.6, 0.6);
        Body hand = null;
        for (int side = -1; side <= 1; side += 2) {
            Body upper = box(0.3, 0.1, side * 0.3, 0.2);
            hand = box(0.3, 0.1, side * 0.6, 0.2);
            join(upper, torso, side * 0.15, 0.2, -1.5, 1.5);
            join(hand, upper, side * 0.45, 0.2, side > 0 ? -0.1 : -2, side > 0 ? 2 : 0.1);
            Body thigh = box(0.12, 0.4, side * 0.1, -0.65);
            join(thigh, hips, side * 0.1, -0.45, -0.8, 1.2);
            join(box(0.1, 0.4, side * 0.1, -1.05), thigh, side * 0.1, -0.85, -1.8, 0.05);
        }
        engine.add(new PinJoint(hand, 0.75, 0.2));
        for (Body body : engine.bodies()) {
            body.setVelocity(-spin * (body.getY() - 0.2), spin * (body.getX() - 0.75));
            body.setAngularVelocity(spin);
        }
    }

    private double energy() {
        double sum = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            sum += 9.81 * body.getMass() * body.getY();
        }
        return sum;
    }

    private double passed() {
        double most = 0;
        for (int k = 0; k < pairs.size(); k++) {
            double angle = pairs.get(k)[0].getAngle() - pairs.get(k)[1].getAngle();
            most = Math.max(most, Math.max(bounds.get(k)[0] - angle, angle - bounds.get(k)[1]));
        }
        return most;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -4, 4.5, -5.5, 6.5, -9, 11})
    void noStopIsPassed(double spin) {
        build(spin);
        double least = energy();
        for (int step = 0; step < 700; step++) {
            engine.step();
            assertThat(passed()).as("step %s", step).isLessThan(1e-9);
            assertThat(energy()).as("step %s", step).isLessThan(least + 0.05); // errors of rough steps
            least = Math.min(least, energy());
        }
    }
}
