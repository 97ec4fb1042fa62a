// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.Rattle;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Rectangle;

/**
 * In the steady state a step allocates nothing. Arrays still grow when a run meets its largest crowd so far, so what is
 * measured is the least of several windows, each with many impacts; a step that allocates at all shows in every one.
 */
class AllocationTest {
    private static final int WINDOWS = 25;

    /** Keeps bodies near the origin. */
    private static final class Spring implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            double k = 1e-5 * body.getMass();
            forces.add(body, -k * body.getX(), -k * body.getY());
        }
    }

    private static void run(PhysicsEngine engine, int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    private static void assertAllocatesNothing(PhysicsEngine engine, int steps) {
        assertAllocatesNothing(engine, steps, true);
    }

    private static void assertAllocatesNothing(PhysicsEngine engine, int steps, boolean collides) {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        run(engine, 40 * steps);
        long least = Long.MAX_VALUE;
        for (int window = 0; window < WINDOWS; window++) {
            long impacts = engine.getImpacts();
            long before = threads.getCurrentThreadAllocatedBytes();
            run(engine, steps);
            long bytes = threads.getCurrentThreadAllocatedBytes() - before;
            assertThat(engine.getImpacts() > impacts).isEqualTo(collides);
            least = Math.min(least, bytes);
        }
        assertThat(least).as("bytes in %d steps", steps).isZero();
    }

    private static PhysicsEngine circles(int n) {
        PhysicsEngine engine = new PhysicsEngine();
        for (int side = -1; side <= 1; side += 2) {
            engine.add(Body.fixed(new Rectangle(120, 6)).at(0, 53 * side));
            engine.add(Body.fixed(new Rectangle(6, 120)).at(53 * side, 0));
        }
        for (int k = 0; k < n; k++) {
            Body body = new Body(new Circle(2 + k % 3));
            engine.add(body.at(12 * (k % 8) - 42, 12 * (k / 8) - 42).moving(1 - 0.37 * (k % 5), 0.21 * (k % 7) - 0.7));
        }
        return engine;
    }

    @Test
    void aGasOfCircles() {
        assertAllocatesNothing(circles(50), 200);
    }

    @Test
    void aGasOfPolygons() {
        assertAllocatesNothing(Scenes.gas(Scenes.Kind.POLYGONS, 60, 1), 200);
    }

    @Test
    void aCrowdInCells() {
        assertAllocatesNothing(Scenes.gas(Scenes.Kind.FIGURE_1, 250, 2), 100);
    }

    @Test
    void bodiesThatFall() {
        PhysicsEngine engine = Scenes.gas(Scenes.Kind.FIGURE_1, 30, 3);
        engine.add(new Gravity(0, -0.01));
        assertAllocatesNothing(engine, 200);
    }

    @Test
    void bodiesThatSlideAndAreStruckAgain() {
        PhysicsEngine engine = Scenes.gas(Scenes.Kind.POLYGONS, 30, 4);
        engine.add(new SurfaceFriction(1e-4));
        for (Body body : engine.bodies()) {
            body.setSurfaceFriction(0.01);
        }
        assertAllocatesNothing(engine, 60);
    }

    @Test
    void bodiesOfSeveralParts() {
        for (double friction : new double[] {0, 1e-4}) {
            PhysicsEngine engine = circles(10);
            Compound shape = new Compound(Compound.disc(0, 0, 2), Compound.box(2.5, 1, 3, 0.4), Compound.box(2.5, -1, 3, 0.4));
            for (int k = 0; k < 20; k++) {
                engine.add(new Body(shape).at(12 * (k % 8) - 42, 12 * (k / 8) - 20).moving(1 - 0.37 * (k % 5), 0.21 * (k % 7) - 0.7, 0.1));
            }
            if (friction > 0) {
                engine.add(new SurfaceFriction(friction));
                engine.bodies().forEach(body -> body.setSurfaceFriction(0.01));
            }
            assertAllocatesNothing(engine, 60);
        }
    }

    @Test
    void bodiesOnASpringWithRungeKutta() {
        PhysicsEngine engine = Scenes.gas(Scenes.Kind.FIGURE_1, 30, 5);
        engine.setIntegrator(new RungeKutta4());
        engine.add(new Spring());
        assertAllocatesNothing(engine, 100);
    }

    /** Chains alone, and islands that springs couple, of which there are several groups. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void chainsAndGroupsOfThem(int method) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 240.0);
        engine.setIntegrator(method == 0 ? new RungeKutta4() : method == 1 ? new Rattle(2) : new DormandPrince853(1e-8));
        engine.add(new Gravity(0, -9.81));
        for (int k = 0; k < 5; k++) {
            Body upper = engine.add(new Body(new Rectangle(1, 0.1)).at(0.5, 10 * k));
            Body middle = engine.add(new Body(new Rectangle(1, 0.1)).at(1.5, 10 * k));
            Body lower = engine.add(new Body(new Rectangle(1, 0.1)).at(0.5, 10 * k - 3));
            engine.add(new PinJoint(upper, 0, 10 * k));
            engine.add(new PinJoint(upper, middle, 1, 10 * k));
            engine.add(new PinJoint(lower, 0, 10 * k - 3));
            for (Body body : List.of(upper, middle, lower)) {
                body.setCollisionGroup(1, 0);
            }
            if (k < 3) {
                engine.add(new sim.physics.motion.Spring(middle, 0, 0, lower, 0, 0, 2, 10, 0));
            }
        }
        assertAllocatesNothing(engine, 50, false);
    }

    /** A motor and a stop, which ask for their times of switching in each step: 64 bytes of iterators. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void motorsAndStops(int method) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 240.0);
        engine.setIntegrator(method == 0 ? new RungeKutta4() : method == 1 ? new Rattle(2) : new DormandPrince853(1e-8));
        engine.add(new Gravity(0, -9.81));
        Body upper = engine.add(new Body(new Rectangle(1, 0.1)).at(0.5, 0));
        Body lower = engine.add(new Body(new Rectangle(1, 0.1)).at(1.5, 0));
        engine.add(new PinJoint(upper, 0, 0));
        engine.add(new PinJoint(upper, lower, 1, 0));
        engine.add(Motor.turning(upper, null, 1, 0.2));
        engine.add(Limit.angle(lower, upper, -40, 40));
        assertAllocatesNothing(engine, 50, false);
    }

    @Test
    void bodiesThatRubAndLoseSpeed() {
        PhysicsEngine engine = Scenes.gas(Scenes.Kind.FIGURE_1, 40, 6);
        for (Body body : engine.bodies()) {
            body.setFriction(0.1);
            body.setRestitution(0.999);
        }
        assertAllocatesNothing(engine, 200);
    }
}
