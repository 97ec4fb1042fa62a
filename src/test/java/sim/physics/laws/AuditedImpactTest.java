// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.StepReport;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.SurfaceFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** The audit's books of driven bodies that are struck, more than once at an instant too, and tied by those who are told of it. */
class AuditedImpactTest {
    /** Walks to the right, as people do who want out. */
    private static final class Walk implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, 1 - body.getVelocityX(), 0);
        }
    }

    /** Holds fast what it has hit first. */
    private static final class Grip implements CollisionListener {
        private static final long serialVersionUID = 1L;

        private final PhysicsEngine engine;
        private final boolean isWeld;
        private Constraint joint;

        Grip(PhysicsEngine engine, boolean isWeld) {
            this.engine = engine;
            this.isWeld = isWeld;
        }

        @Override
        public void collided(Contact c) {
            if (joint == null) {
                joint = engine.add(isWeld ? new WeldJoint(c.a(), c.b(), c.x(), c.y()) : new PinJoint(c.a(), c.b(), c.x(), c.y()));
            }
        }
    }

    private static PhysicsEngine empty() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.02);
        return engine;
    }

    private static PhysicsEngine gripper(boolean isWeld, boolean isAudited) {
        PhysicsEngine engine = empty();
        engine.add(new SurfaceFriction(9.81));
        engine.addListener(new Grip(engine, isWeld));
        engine.add(new Body(new Circle(0.35)).moving(3, 0.2, 1)).setSurfaceFriction(0.1);
        engine.add(new Body(new Circle(0.3)).at(1, 0.2)).setSurfaceFriction(0.1);
        engine.setAudited(isAudited);
        return engine;
    }

    /**
     * What drives discs against a wall and one another is smooth, so all that RK4 misses is some 10⁻¹⁰ of their energy; what they lose is the
     * impacts'. It was drift, up to a third of the energy in a step, where bodies were struck and moved on before they had a path.
     */
    @ParameterizedTest
    @CsvSource({"3, 0, 0", "3, 0.2, 0", "4, 0.2, 0", "4, 0, 0.3", "4, 0.2, 0.3", "6, 0.1, 0.5"})
    void whatDrivenBodiesLoseInACrowdIsTheImpacts(int count, double aside, double restitution) {
        PhysicsEngine engine = empty();
        engine.add(new Walk());
        engine.add(Body.fixed(new Rectangle(1, 50)).at(10, 0)).setRestitution(restitution);
        for (int k = 0; k < count; k++) {
            engine.add(new Body(new Circle(0.5)).at(8 - 1.3 * k, k % 2 * aside)).setRestitution(restitution);
        }
        engine.setAudited(true);
        double lost = 0;
        for (int k = 0; k < 400; k++) {
            engine.step();
            StepReport report = engine.getStepReport();
            assertThat(report.drift()).as("step " + k).isCloseTo(0, within(1e-8));
            lost -= report.impacts();
        }
        assertThat(lost).isGreaterThan(0.3);
    }

    /**
     * What a listener ties together within a step has the same motion with and without audit, which went beyond what was tied until then, and
     * left the other body where it came to: with a fifth more energy. And it costs the energy of the relative velocity, for which the author stands.
     */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void whatIsTiedWithinAStepGoesOnAsWithoutAudit(boolean isWeld) {
        PhysicsEngine engine = gripper(isWeld, false);
        PhysicsEngine audited = gripper(isWeld, true);
        for (int k = 0; k < 60; k++) {
            engine.step();
            audited.step();
            Checkpoint.assertSameBodies(engine, audited);
            assertThat(audited.getStepReport().drift()).as("step " + k).isCloseTo(0, within(1e-6));
        }
        assertThat(audited.getRunReport().authored()).isLessThan(-0.1);
    }

    /** A disc that lies still on a plane with friction and is struck has its energy from the impact: elastic, so nothing is lost. */
    @Test
    void whatIsStruckAtRestOnAPlaneHasItsEnergyFromTheImpact() {
        PhysicsEngine engine = empty();
        engine.add(new SurfaceFriction(9.81));
        engine.add(new Body(new Circle(0.3)).moving(3, 0)).setSurfaceFriction(0.1);
        engine.add(new Body(new Circle(0.3)).at(1, 0.1)).setSurfaceFriction(0.1);
        engine.setAudited(true);
        for (int k = 0; k < 60; k++) {
            engine.step();
            assertThat(engine.getStepReport().drift()).as("step " + k).isCloseTo(0, within(1e-7));
            assertThat(engine.getStepReport().impacts()).as("step " + k).isCloseTo(0, within(1e-12));
        }
    }
}
