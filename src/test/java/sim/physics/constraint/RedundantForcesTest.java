// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** Joints that say the same twice, or that contradict one another, where the write-up's iteration has no way, or no answer. */
class RedundantForcesTest {
    private static PhysicsEngine engine(ConstraintSolver solver) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 512);
        engine.add(new Gravity(1, -9.81));
        engine.setConstraintSolver(solver);
        return engine;
    }

    private static Body bar(PhysicsEngine engine, double x, double y, double angle) {
        Body bar = engine.add(new Body(new Rectangle(2, 0.2)).at(x, y, angle));
        bar.setMass(1 + 0.3 * x, 0.4);
        bar.setCollisionGroup(1, 0);
        return bar;
    }

    /** Two bars that swing, and joints which say again what others say: where both are is known by that. */
    private static Body[] redundant(PhysicsEngine engine, String what) {
        Body a = bar(engine, 0.8, 0, 0.3);
        Body b = bar(engine, 2.6, 0.4, -0.1);
        engine.add(new PinJoint(a, -0.1, -0.3));
        engine.add(new PinJoint(a, b, 1.7, 0.3));
        switch (what) {
            case "two pins at one point" -> engine.add(new PinJoint(a, -0.1, -0.3));
            case "two welds" -> {
                engine.add(new WeldJoint(a, b, 1.7, 0.3));
                engine.add(new WeldJoint(a, b, 2, 0.5));
            }
            case "a third crank" -> {
                for (int k = 1; k < 4; k++) { // b is carried by three parallel cranks and goes round without turning
                    Body crank = bar(engine, 2.6 + k, 1.4, Math.PI / 2);
                    engine.add(new PinJoint(crank, b, 2.6 + k, 0.4));
                    engine.add(new PinJoint(crank, 2.6 + k, 2.4));
                }
                engine.remove(engine.allConstraints().get(1));
            }
            default -> engine.add(new RodJoint(a, 0.8, 0, null, -0.1, -0.3));
        }
        return new Body[] {a, b};
    }

    @ParameterizedTest
    @ValueSource(strings = {"two pins at one point", "two welds", "a third crank", "a rod along a bar"})
    void theGlobalSolveGoesTheWayOfTheElimination(String what) {
        PhysicsEngine one = engine(new DirectSolver());
        PhysicsEngine other = engine(new GlobalSolver());
        Body[] a = redundant(one, what);
        Body[] b = redundant(other, what);
        for (int k = 0; k < 256; k++) {
            one.step();
            other.step();
            for (int body = 0; body < 2; body++) {
                assertThat(b[body].getX()).as("step %s", k).isCloseTo(a[body].getX(), within(1e-9));
                assertThat(b[body].getY()).as("step %s", k).isCloseTo(a[body].getY(), within(1e-9));
                assertThat(b[body].getAngle()).as("step %s", k).isCloseTo(a[body].getAngle(), within(1e-9));
            }
        }
        assertThat(other.getRelievedSteps()).isZero();
    }

    /** A point of a body cannot be at two places: that is refused as with any solver, and nobody has moved. */
    @Test
    void whatContradictsItselfIsRefused() {
        PhysicsEngine engine = engine(new GlobalSolver());
        Body bar = bar(engine, 0, 0, 0);
        engine.add(new PinJoint(bar, -1, 0));
        engine.step();
        long before = Scenes.hash(engine);
        PinJoint open = PinJoint.bodyPoints(bar, -1, 0, null, 3, 0);
        assertThatThrownBy(() -> engine.assemble(open)).isInstanceOf(ConstraintException.class).hasMessageContaining("PinJoint");
        assertThat(Scenes.hash(engine)).isEqualTo(before);
        engine.step();
    }
}
