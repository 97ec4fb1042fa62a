// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.SurfaceFriction;
import sim.physics.response.CollisionListener;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What presses and is let go has nothing to part with: all was at rest, and nothing gives back. The impulses of the step before made it drift off. */
class SteppedReleaseTest {
    private static final double STEP = 1.0 / 60;

    /** How fast a disc moves that has pushed a row of boxes, which friction with the plane holds, for a second, and then no more for three. */
    private static double drift(int boxes, double force, double direction, int substeps) {
        return drift(boxes, force, direction, substeps, false);
    }

    /** The same; a listener is asked about two others in the step in which it is let go, if wanted. */
    private static double drift(int boxes, double force, double direction, int substeps, boolean isHeard) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(STEP);
        engine.setTimeStepping(substeps);
        engine.setSleepAllowed(false);
        engine.add(new SurfaceFriction(9.81));
        double x = StrictMath.cos(direction);
        double y = StrictMath.sin(direction);
        for (int k = 1; k <= boxes; k++) {
            Body box = new Body(new Rectangle(1, 1)).at(k * x, k * y, direction);
            box.setMass(3);
            box.setSurfaceFriction(0.3, 0.4);
            box.setRestitution(0);
            engine.add(box);
        }
        Body disc = new Body(new Circle(0.5));
        disc.setMass(2);
        disc.setRestitution(0);
        engine.add(disc);
        if (isHeard) {
            engine.add(new Body(new Circle(0.5)).at(100, 0));
            engine.add(new Body(new Circle(0.5)).at(101 + 6 * 60.5 * STEP, 0).moving(-6, 0));
            engine.addListener(new Bounces());
        }
        for (int k = 0; k < 240; k++) {
            if (k < 60) {
                disc.addForce(force * x, force * y);
            }
            engine.step();
        }
        return StrictMath.hypot(disc.getVelocityX(), disc.getVelocityY());
    }

    /** It drifted at 0.28 of what the force gives it in a substep, at 1 to 23 mm/s. */
    @ParameterizedTest
    @CsvSource({"2, 0, 1", "2, 0, 4", "5, 0.7, 4", "10, 0, 1", "10, 2, 4"})
    void whatHasPushedABoxStays(double force, double direction, int substeps) {
        assertThat(drift(1, force, direction, substeps)).isEqualTo(0, within(1e-9));
    }

    /** The step begins anew then, and what was released was forgotten: it drifted at 9 mm/s. */
    @Test
    void itStaysAlsoIfAListenerIsAskedInThatStep() {
        assertThat(drift(1, 10, 0, 1, true)).isEqualTo(0, within(1e-9));
    }

    /** Says what would happen without it. */
    private static final class Bounces implements CollisionListener {
        private static final long serialVersionUID = 1L;
    }

    /** Of what several bodies hold a little is left, as each hands on a part only: 0.7 and 1 mm/s in place of 9 and 13. */
    @ParameterizedTest
    @CsvSource({"2, 15", "3, 15", "3, 22"})
    void whatHasPushedARowHardlyDrifts(int boxes, double force) {
        assertThat(drift(boxes, force, 0, 4)).isLessThan(2e-3);
    }
}
