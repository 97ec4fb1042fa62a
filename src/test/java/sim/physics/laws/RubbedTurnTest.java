// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Compound;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Bodies that lie on one another and turn on a plane on which they rub: their contacts turn with them. */
class RubbedTurnTest {
    private static final double HEIGHT = ForceFreeHeapTest.HEIGHT;

    /**
     * Something slides outwards on a heavy bar that turns at 1 rad/s, on a plane that hardly rubs: r″ = r − μ (2 r′ − d), from r = r′ = 1. It
     * stopped on the bar at once, 1.5 short of where it comes in a second, or was let into it by 10⁻³.
     */
    @ParameterizedTest
    @CsvSource({
        "60, 0, 0, false", "60, 0.2, 0, false", "60, 0, 1e-30, false", "10, 0, 0, false", "10, 0.2, 1e-30, false",
        "60, 0, 0, true", "60, 0.2, 1e-30, true", "10, 0, 1e-30, true"
    })
    void whatLiesOnATurningBarSlidesOutwards(double stepsInASecond, double friction, double gravity, boolean onDiscs) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / stepsInASecond);
        engine.add(new Gravity(gravity, 0));
        engine.add(new SurfaceFriction(1));
        Body bar = put(engine, new Body(new Rectangle(20, 0.2)).moving(0, 0, 1), friction);
        bar.setMass(4e7);
        Body slider = put(engine, new Body(onDiscs ? skate() : new Rectangle(0.4, 0.4)).at(1, HEIGHT).moving(1 - HEIGHT, 1, 1), friction);
        for (int k = 0; k < stepsInASecond; k++) {
            engine.step();
            assertThat(engine.overlaps()).allSatisfy((Overlap o) -> assertThat(o.depth()).isLessThan(1e-6));
        }
        double along = slider.getX() * Math.cos(bar.getAngle()) + slider.getY() * Math.sin(bar.getAngle());
        assertThat(along).isCloseTo(ForceFreeHeapTest.outwards(friction, 1), within(stepsInASecond < 60 ? 1e-3 : 2e-4));
        assertThat(bar.getAngularVelocity()).isCloseTo(1, within(1e-6));
    }

    private static Shape skate() {
        return new Compound(Compound.box(0, 0, 0.4, 0.1), Compound.disc(-0.2, 0, 0.2), Compound.disc(0.2, 0, 0.2));
    }

    private static Body put(PhysicsEngine engine, Body body, double friction) {
        body.setFriction(friction);
        body.setRestitution(0);
        body.setSurfaceFriction(1e-9);
        return engine.add(body);
    }
}
