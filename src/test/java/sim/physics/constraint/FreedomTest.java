// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.Witness;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.State;
import sim.physics.shape.Rectangle;

/** What joints let pass of an error: what is left of it when the bodies are brought back onto them. */
class FreedomTest {
    private static final double G = 9.81;

    private static Body rod(double x, double y, double angle) {
        Body rod = new Body(new Rectangle(1, 0.02)).at(x, y, angle);
        rod.setMass(1, 1 / 12.0);
        rod.setCollisionGroup(1, 0);
        return rod;
    }

    /**
     * A rod on a pin at distance r of its centre can only turn: of changes e of its place and α of its angle the least
     * mass-weighted move back onto the pin leaves a turn by (m r × e + I α) / (m r² + I).
     */
    @Test
    void aRodOnAPinIsLeftWithItsTurn() {
        State state = new State();
        Body rod = rod(0.3, -0.4, StrictMath.atan2(-4, 3));
        state.add(rod);
        Constraints constraints = new Constraints(state);
        constraints.add(new PinJoint(rod, null, 0, 0));
        constraints.regroup();
        IntList bodies = constraints.island(0);
        constraints.accelerate(bodies, new double[State.BLOCK], true);
        double[] change = {0.002, 0.001, -0.003};
        double turn = (0.3 * 0.001 + 0.4 * 0.002 - 0.003 / 12) / (0.25 + 1 / 12.0);
        for (int again = 0; again < 2; again++) { // what is left passes as it is
            assertThat(constraints.pass(bodies, change)).isTrue();
            assertThat(change[2]).isCloseTo(turn, within(1e-17));
            assertThat(change[0]).isCloseTo(0.4 * turn, within(1e-17));
            assertThat(change[1]).isCloseTo(0.3 * turn, within(1e-17));
        }
    }

    /** With springs in place of projection nothing brings bodies back, and all of an error counts. */
    @Test
    void nothingIsTakenAwayWhereNothingBringsBodiesBack() {
        State state = new State();
        Body rod = rod(0.5, 0, 0);
        state.add(rod);
        Constraints constraints = new Constraints(state);
        constraints.setStabilization(Stabilization.feedback(10, 10));
        constraints.add(new PinJoint(rod, null, 0, 0));
        constraints.regroup();
        double[] change = {0.002, 0.001, -0.003};
        assertThat(constraints.pass(constraints.island(0), change)).isFalse();
        assertThat(change).containsExactly(0.002, 0.001, -0.003);
    }

    /**
     * Windows in a row: cranks and couplers swing as one pendulum, however many they are. Joints take nearly all that a
     * larger number is off, so that a tolerance is met in about as many steps, and to about the same part.
     */
    @Test
    void aToleranceMeansTheSameInLoopsOfAnyNumber() {
        for (Integrator method : List.of(new DormandPrince853(1e-9), new GraggBulirschStoer(1e-9))) {
            double[] few = swing(1, method);
            double[] many = swing(20, method);
            assertThat(many[0]).as("%s", method).isLessThan(1.1 * few[0]);
            assertThat(many[1]).as("%s", method).isLessThan(3e-8);
            assertThat(few[1]).as("%s", method).isLessThan(3e-8);
        }
    }

    /** Evaluations, and how far the place is off after 5 s. */
    private static double[] swing(int windows, Integrator method) {
        double[] place = new double[2];
        long calls = 0;
        for (int way = 0; way < 2; way++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(5);
            engine.setIntegrator(way == 0 ? method : new DormandPrince853(1e-13));
            engine.add(new Gravity(0, -G));
            double x = 0.5;
            double y = -StrictMath.sqrt(0.75);
            Body before = null;
            Witness counter = null;
            for (int k = 0; k <= windows; k++) {
                Body crank = engine.add(rod(k + x / 2, y / 2, StrictMath.atan2(y, x)));
                engine.add(new PinJoint(crank, null, k, 0));
                if (before != null) {
                    Body coupler = engine.add(rod(k - 0.5 + x, y, 0));
                    engine.add(new PinJoint(coupler, before, k - 1 + x, y));
                    engine.add(new PinJoint(coupler, crank, k + x, y));
                } else {
                    counter = new Witness(crank, true);
                    engine.add(counter);
                }
                before = crank;
            }
            engine.step();
            place[way] = before.getX();
            calls = way == 0 ? counter.calls() : calls;
        }
        return new double[] {calls, Math.abs(place[0] - place[1])};
    }
}
