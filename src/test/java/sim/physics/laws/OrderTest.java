// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Euler;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Integrator;
import sim.physics.motion.RungeKutta4;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** The error of a method falls with its order, also when there are impacts on the way. */
class OrderTest {
    /** A force and a torque that depend on the position. */
    private static final class Field implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            double m = body.getMass();
            forces.add(body, -m * body.getX(), 0.3 * m / (1 + body.getY() * body.getY()));
            forces.addTorque(body, -0.5 * body.getInertia() * body.getAngle());
        }
    }

    private static double[] run(Integrator integrator, double step, double time, boolean walls) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setIntegrator(integrator);
        engine.setTimeStep(step);
        if (walls) {
            engine.add(Body.fixed(new Rectangle(1, 10)).at(1.7, 0));
            engine.add(Body.fixed(new Rectangle(10, 1)).at(0, 2.0));
        }
        Body body = engine.add(new Body(new Circle(0.5)).at(0.2, 0, 0.3).moving(1, 0.4, 0.7));
        engine.add(new Field());
        for (int k = 0; k < Math.round(time / step); k++) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isEqualTo(walls ? 2 : 0);
        return new double[] {body.getX(), body.getY(), body.getAngle(), body.getVelocityX()};
    }

    private static double error(double[] a, double[] b) {
        double most = 0;
        for (int k = 0; k < a.length; k++) {
            most = Math.max(most, Math.abs(a[k] - b[k]));
        }
        return most;
    }

    private static void slope(Integrator integrator, double coarse, double expected, boolean walls) {
        double[] reference = run(new RungeKutta4(), 1.0 / 2048, 4, walls);
        for (int k = 0; k < 3; k++) {
            double h = coarse / (1 << k);
            double ratio = error(run(integrator, h, 4, walls), reference)
                    / error(run(integrator, h / 2, 4, walls), reference);
            assertThat(Math.log(ratio) / Math.log(2)).isCloseTo(expected, within(0.2));
        }
    }

    @Test
    void eulerIsOfFirstOrder() {
        slope(new Euler(), 1.0 / 64, 1, false);
        slope(new Euler(), 1.0 / 64, 1, true);
    }

    @Test
    void rungeKuttaIsOfFourthOrderAlsoThroughImpacts() {
        slope(new RungeKutta4(), 1.0 / 16, 4, false);
        slope(new RungeKutta4(), 1.0 / 16, 4, true);
    }
}
