// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Motors and stops tell where their coordinates are, whether they act or not. */
class SwitchedValueTest {
    @Test
    void aTurnIsCountedFromWhereItWasMade() {
        Body a = new Body(new Circle(1)).at(0, 0, 0.25);
        Body b = new Body(new Circle(1)).at(3, 0, 0.5);
        Limit stop = Limit.angle(a, b, -1, 1);
        Motor motor = Motor.turning(a, b, 2, 5);
        a.setAngle(1);
        b.setAngle(0.75);
        assertThat(stop.getValue()).isEqualTo(0.5); // (1 - 0.75) - (0.25 - 0.5)
        assertThat(motor.getValue()).isEqualTo(0.5);
    }

    @Test
    void aRopeTellsHowFarItIsFromTaut() {
        Body a = new Body(new Circle(1)).at(0, 0);
        Body b = new Body(new Circle(1)).at(3, 4);
        assertThat(Limit.rope(a, 0, 0, b, 0, 0, 7).getValue()).isEqualTo(-2);
    }

    @Test
    void anEndOfARailTellsItsTravel() {
        Body block = new Body(new Rectangle(1, 1)).at(0, 0);
        SliderJoint rail = new SliderJoint(block, null, 0, 0, 0.6, 0.8);
        Limit ends = Limit.travel(rail, -1, 5);
        block.setPosition(1.2, 1.6);
        assertThat(ends.getValue()).isEqualTo(rail.getTravel()).isCloseTo(2, within(1e-15));
    }

    /** To ask changes no bit of a run. */
    @Test
    void askingChangesNothing() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        engine.add(new Gravity(0, -9.81));
        Body rod = engine.add(new Body(new Rectangle(1, 0.1)).at(0.5, 0));
        engine.add(new PinJoint(rod, null, 0, 0));
        engine.add(Limit.angle(rod, null, -0.5, 0.5));
        PhysicsEngine other = Checkpoint.copy(engine);
        for (int k = 0; k < 100; k++) {
            engine.step();
            other.step();
            for (Constraint one : engine.allConstraints()) {
                if (one instanceof Limit stop) {
                    assertThat(stop.getValue()).isEqualTo(rod.getAngle());
                }
            }
        }
        Checkpoint.assertSameBodies(other, engine);
        assertThat(rod.getAngle()).isCloseTo(-0.5, within(1e-9));
    }
}
