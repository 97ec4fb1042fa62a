// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.ViscousFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;

/** Bodies that a listener lets pass are asked about again when they meet again, however little they were apart in the meantime. */
class PassedAndMetAgainTest {
    private static final double H = 0.01;

    /** Lets pass for a while, and counts the questions. */
    private static final class Lets implements CollisionListener {
        private static final long serialVersionUID = 1L;

        private boolean isHungry;
        private int asked;

        @Override
        public Decision colliding(Contact contact) {
            asked++;
            return isHungry ? Decision.BOUNCE : Decision.IGNORE;
        }
    }

    /** A disc passes through another one askew, so that their boxes are apart later than they are, turns back, and bounces off it. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void whatWasLetPassBouncesWhenItComesBack(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(H);
        engine.setTimeStepping(substeps);
        double slant = Math.sqrt(0.5);
        Body still = engine.add(new Body(new Circle(1)));
        Body flies = engine.add(new Body(new Circle(1)).at(-3 * slant, -3 * slant).moving(slant, slant));
        Lets listener = new Lets();
        engine.addListener(listener);
        while (Math.hypot(flies.getX(), flies.getY()) < 2.1 || flies.getX() < 0) {
            engine.step();
        }
        assertThat(listener.asked).isEqualTo(1);
        assertThat(still.getVelocityX()).isZero();
        listener.isHungry = true;
        flies.setVelocity(-slant, -slant);
        for (int k = 0; k < 50; k++) {
            engine.step();
        }
        assertThat(listener.asked).isEqualTo(2);
        assertThat(Math.hypot(still.getVelocityX(), still.getVelocityY())).isBetween(1 - 1e-12, 1 + 1e-12); // like masses: all of the speed
        assertThat(Math.hypot(flies.getVelocityX(), flies.getVelocityY())).isLessThan(1e-12);
    }

    /** Entries into a round sensor, as the listener is asked and as distances at the ends of steps say. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aSensorTellsOfEveryEntry(boolean isDriven) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(H);
        Body sensor = engine.add(Body.fixed(new Circle(3)));
        Lets listener = new Lets();
        engine.addListener(listener);
        Body bird = engine.add(new Body(new Circle(0.2)).at(2.6, 2.6));
        if (isDriven) {
            engine.add(new ViscousFriction(0)); // no force, but its path is a method's
            bird.setSurfaceFriction(1);
        }
        Random random = new Random(1);
        int entries = 0;
        boolean wasIn = false;
        for (int k = 0; k < 20_000; k++) {
            double x = bird.getX() - 2.3; // it strays about a place askew at the rim, where boxes overlap all the time
            double y = bird.getY() - 2.3;
            bird.addForce(0.2 * random.nextGaussian() - 0.5 * x, 0.2 * random.nextGaussian() - 0.5 * y);
            engine.step();
            double gap = Math.hypot(bird.getX() - sensor.getX(), bird.getY() - sensor.getY()) - 3.2;
            entries += !wasIn && gap < 0 ? 1 : 0;
            wasIn = gap < 0;
        }
        assertThat(entries).isGreaterThan(20);
        assertThat(listener.asked).isEqualTo(entries);
    }
}
