// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.List;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.references.Swing;
import sim.physics.shape.Circle;

/** W01: the pendulum A01 of the IFToMM benchmarks, a point of 1 kg on a massless rod of 1 m let go from the horizontal. */
final class SwingScene {
    private static final double G = 9.81;
    private static final double OUTPUT = 0.5;

    private SwingScene() {}

    static Scene of(double seconds) {
        List<Contender> all = new ArrayList<>();
        for (Contender c : Methods.contenders(OUTPUT, (method, step) -> own(seconds, method, step))) {
            all.add(c);
        }
        String title = "IFToMM A01, a pendulum for " + (long) seconds + " s";
        return new Scene("W01", title, seconds, "largest at outputs every 0.5 s, m", all);
    }

    private static Trial own(double seconds, Integrator method, double step) {
        PhysicsEngine engine = new PhysicsEngine();
        long each = Math.max(1, Math.round(OUTPUT / step));
        engine.setTimeStep(OUTPUT / each);
        engine.setIntegrator(method);
        engine.add(new Gravity(0, -G));
        Body point = engine.add(new Body(new Circle(0.1)).at(1, 0));
        point.setMass(1);
        engine.add(new RodJoint(point, 1, 0, null, 0, 0));
        return new Trial() {
            private double worst;

            @Override
            public void run() {
                for (int k = 1; k * OUTPUT <= seconds; k++) {
                    for (long m = 0; m < each; m++) {
                        engine.step();
                    }
                    double angle = Swing.angle(Math.sqrt(G), k * OUTPUT);
                    double x = point.getX() - StrictMath.sin(angle);
                    worst = Math.max(worst, Math.hypot(x, point.getY() + StrictMath.cos(angle)));
                }
            }

            @Override
            public double error() {
                return worst;
            }

            @Override
            public double energy() {
                return (point.kineticEnergy() + G * point.getY()) / G;
            }

            @Override
            public double gap() {
                return Math.abs(Math.hypot(point.getX(), point.getY()) - 1);
            }
        };
    }
}
