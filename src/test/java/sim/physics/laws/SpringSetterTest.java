// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Springs whose length, stiffness and damping are set while they act, as those of muscles are. */
class SpringSetterTest {
    private final PhysicsEngine engine = new PhysicsEngine();
    private final Body ball = engine.add(new Body(new Circle(0.5)).at(2, 0));
    private final Spring spring = engine.add(new Spring(ball, 0, 0, null, 0, 0, 2, 100, 0));

    SpringSetterTest() {
        engine.setTimeStep(0.01);
        ball.setMass(1);
    }

    private void run(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    /** Where nothing moves: x = L + (x₀ − L) cos ωt from the instant at which the length is set. */
    @Test
    void aMuscleThatContracts() {
        run(10);
        assertThat(ball.getX()).isEqualTo(2);
        spring.setLength(1);
        run(20);
        assertThat(ball.getX()).isCloseTo(1 + StrictMath.cos(10 * 0.2), within(1e-4));
        assertThat(spring.getLength()).isEqualTo(1);
    }

    @Test
    void aSpringThatBecomesStiffer() {
        spring.setLength(1.5);
        spring.setStiffness(400);
        run(20);
        assertThat(ball.getX()).isCloseTo(1.5 + 0.5 * StrictMath.cos(20 * 0.2), within(1e-3));
        assertThat(spring.energy() + engine.kineticEnergy()).isCloseTo(50, within(0.1));
        assertThat(spring.getStiffness()).isEqualTo(400);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aDamperIsPutOn(int substeps) {
        if (substeps > 0) {
            engine.setTimeStepping(substeps);
        }
        spring.setLength(1);
        spring.setDamping(20); // critical
        run(200);
        assertThat(ball.getX()).isCloseTo(1, within(1e-6));
        assertThat(spring.getDamping()).isEqualTo(20);
    }

    /** A box at rest on the ground, which the spring then lifts. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void whatRestsIsLifted(int substeps) {
        if (substeps > 0) {
            engine.setTimeStepping(substeps);
        }
        engine.add(new Gravity(0, -9.81));
        engine.add(Body.fixed(new Rectangle(10, 1)).at(20, -0.5));
        Body box = engine.add(new Body(new Rectangle(1, 1)).at(20, 0.5));
        Spring crane = engine.add(new Spring(box, 0, 0, null, 20, 5, 4.5, 100, 50));
        run(300);
        assertThat(box.getY()).isCloseTo(0.5, within(1e-3));
        crane.setLength(2);
        run(500);
        assertThat(box.getY()).isCloseTo(5 - 2 - 0.0981, within(1e-2));
    }

    @Test
    void whatIsNoNumberIsRefusedAndChangesNothing() {
        assertThatIllegalArgumentException().isThrownBy(() -> spring.setLength(-1)).withMessageContaining("length is -1.0");
        assertThatIllegalArgumentException().isThrownBy(() -> spring.setStiffness(Double.NaN)).withMessageContaining("stiffness is NaN");
        assertThatIllegalArgumentException().isThrownBy(() -> spring.setDamping(1 / 0.0)).withMessageContaining("damping is Infinity");
        assertThat(spring.getLength()).isEqualTo(2);
        assertThat(spring.getStiffness()).isEqualTo(100);
        assertThat(spring.getDamping()).isZero();
    }

    /** Springs may be set before their bodies are in an engine. */
    @Test
    void aSpringOfNoEngine() {
        Spring loose = new Spring(new Body(new Circle(1)), 0, 0, Body.fixed(new Circle(1)), 0, 0, 1, 1, 0);
        loose.setLength(3);
        assertThat(loose.getLength()).isEqualTo(3);
    }

    @Test
    void aCopyGoesOnAlike() throws IOException, ClassNotFoundException {
        run(3);
        spring.setLength(1);
        spring.setDamping(1);
        run(3);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(engine);
        }
        PhysicsEngine copy;
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            copy = (PhysicsEngine) in.readObject();
        }
        run(5);
        for (int k = 0; k < 5; k++) {
            copy.step();
        }
        assertThat(copy.bodies().get(0).getX()).isEqualTo(ball.getX());
    }

    @Test
    void itSaysWhatItIs() {
        assertThat(spring).hasToString("Spring(" + ball + ", world, length 2.0, stiffness 100.0, damping 0.0)");
    }
}
