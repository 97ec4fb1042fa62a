// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.List;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Integrator;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;

/** W22: a spring and damper with rates of 20,000 and 0.5 per second; what is fast is over at once. */
final class SpringScene {
    private static final double STIFFNESS = 1e4;
    private static final double RATIO = 100;
    private static final double SECONDS = 2;

    private SpringScene() {}

    static Scene of() {
        List<Contender> all = new ArrayList<>(Methods.contenders(SECONDS, SpringScene::own));
        return new Scene("W22", "a stiff spring and damper for 2 s", SECONDS, "place, m", all);
    }

    private static double place(double t) {
        double omega = StrictMath.sqrt(STIFFNESS);
        double root = StrictMath.sqrt(RATIO * RATIO - 1);
        double slow = -omega / (RATIO + root);
        double fast = -omega * (RATIO + root);
        return (fast * StrictMath.exp(slow * t) - slow * StrictMath.exp(fast * t)) / (fast - slow);
    }

    private static Trial own(Integrator method, double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.setIntegrator(method);
        Body wall = engine.add(Body.fixed(new Circle(0.01)));
        Body body = engine.add(new Body(new Circle(0.1)).at(3, 0));
        body.setCollisionGroup(1, 0);
        body.setMass(1);
        engine.add(new Spring(
                body, 0, 0, wall, 0, 0, 2, STIFFNESS, 2 * RATIO * StrictMath.sqrt(STIFFNESS)));
        return new Trial() {
            @Override
            public void run() {
                for (long k = Math.round(SECONDS / step); k > 0; k--) {
                    engine.step();
                }
            }

            @Override
            public double error() {
                double error = Math.abs(body.getX() - 2 - place(SECONDS));
                return !(error < 1e3) ? Double.POSITIVE_INFINITY : error;
            }
        };
    }
}
