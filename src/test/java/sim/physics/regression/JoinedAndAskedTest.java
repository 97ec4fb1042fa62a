// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** A body is added, and tied to others, and something is asked before the next step. */
class JoinedAndAskedTest {
    private static void add(PhysicsEngine engine, int at) {
        Body link = engine.add(new Body(new Rectangle(1, 0.1)).at(at + 0.5, 0));
        link.setCollisionGroup(1, 0);
        engine.add(at == 0 ? new PinJoint(link, 0, 0) : new PinJoint(engine.bodies().get(at - 1), link, at, 0));
    }

    /** A chain that collides with nobody grows by a link at a time: where arrays by body were full, the step threw, as the link was grouped before it came in. */
    @Test
    void aChainThatGrowsWhileItIsAskedAbout() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 1024);
        engine.add(new Gravity(0, -1e-9));
        PhysicsEngine unasked = Checkpoint.copy(engine);
        for (int k = 0; k < 70; k++) {
            add(engine, k);
            add(unasked, k);
            engine.overlaps();
            engine.step();
            unasked.step();
            Checkpoint.assertSameBodies(engine, unasked);
        }
    }

    /** A slider that a weak motor drives is tied to another body, and is set to 3 where the motor wants 2: to ask in between let the motor stop it at once. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aMotorDoesNotHoldWhatIsSetAfterItsIslandIsFormed(boolean isAsked) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 1024);
        Body slider = engine.add(new Body(new Circle(1)).at(0, 0).moving(2, 0));
        slider.setMass(1);
        engine.add(Motor.sliding(engine.add(new SliderJoint(slider, null, 0, 0, 1, 0)), 2, 0.01));
        engine.step();
        Body rider = engine.add(new Body(new Circle(1)).at(slider.getX(), slider.getY()).moving(2, 0));
        rider.setMass(1);
        engine.add(new WeldJoint(slider, rider, slider.getX(), slider.getY()));
        if (isAsked) {
            engine.overlaps();
        }
        slider.setVelocity(3, 0);
        engine.step();
        assertThat(slider.getVelocityX()).isCloseTo(2.5, within(1e-5)); // the mean of both, and what 0.01 N take from it in a step
    }

    /** A stop that bore its body when it was removed was refused as open when the body had gone on; a new one of the same bounds is not. */
    @Test
    void aStopThatBoreIsAddedAgainAsANewOneIs() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 64);
        engine.add(new Gravity(1, 0));
        Body slider = engine.add(new Body(new Circle(1)).at(0, 0));
        SliderJoint rail = engine.add(new SliderJoint(slider, null, 0, 0, 1, 0));
        Limit stop = engine.add(Limit.travel(rail, -1, 0, 0));
        for (int k = 0; k < 8; k++) {
            engine.step();
        }
        engine.remove(stop);
        for (int k = 0; k < 8; k++) {
            engine.step();
        }
        assertThat(slider.getX()).isGreaterThan(1e-3);
        engine.add(Limit.travel(rail, -1, 0, 0));
        engine.add(stop);
    }
}
