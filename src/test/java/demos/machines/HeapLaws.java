// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.machines;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;

/** What holds in each step of the demo's scenes: bounded work, nothing sinks in, and no energy but that of the motors. */
final class HeapLaws {
    private static final double GRAVITY = 98.1;
    private static final double TORQUE = 40_000;
    private static final double STIFFNESS = 8000;
    private static final double LENGTH = 9.5;
    private static final int MOST_IMPACTS = 3000;

    /** Energy by errors of the method, of some 10^6 that there is. */
    private static final double NOISE = 500;

    private HeapLaws() {}

    /** Runs the demo, and fails where a law is broken; returns how many looks the search for impacts took in a step at most. */
    static long run(long seed, int ragdolls, int rows, int steps) {
        Machines model = new Machines(seed);
        model.setRagdolls(ragdolls);
        model.setRows(rows);
        model.start();
        PhysicsEngine engine = model.physics;
        engine.setWorkLimit(Long.MAX_VALUE); // these are laws of events
        List<Body> bodies = engine.bodies();
        List<Body> car = bodies.subList(bodies.indexOf(model.car.chassis), bodies.size()); // the chassis, and two hubs with their wheels
        long most = 0;
        for (int k = 0; k < steps; k++) {
            String when = "seed " + seed + ", " + ragdolls + " ragdolls, " + rows + " rows, step " + k;
            double energy = energy(engine) + springs(car);
            double rear = turn(car, 1);
            double front = turn(car, 3);
            long impacts = engine.getImpacts();
            long looks = engine.getNarrowPhaseEvaluations();
            model.schedule.step(model);
            double work = TORQUE * (Math.abs(turn(car, 1) - rear) + Math.abs(turn(car, 3) - front));
            assertThat(engine.getImpacts() - impacts).as(when + ", impacts").isLessThan(MOST_IMPACTS);
            assertThat(engine.getDeepestPenetration()).as(when).isLessThan(1e-4); // sizes are 2 to 40
            double gain = energy(engine) + springs(car) - energy;
            assertThat(gain).as(when + ", gain of energy").isLessThan(work + NOISE);
            most = Math.max(most, engine.getNarrowPhaseEvaluations() - looks);
        }
        return most;
    }

    /** Kinetic energy, and that of the height. */
    static double energy(PhysicsEngine engine) {
        double sum = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            sum -= body.isFixed() ? 0 : body.getMass() * GRAVITY * body.getY();
        }
        return sum;
    }

    private static double springs(List<Body> car) {
        Body chassis = car.get(0);
        double cos = StrictMath.cos(chassis.getAngle());
        double sin = StrictMath.sin(chassis.getAngle());
        double sum = 0;
        for (int side = -1; side <= 1; side += 2) {
            Body hub = car.get(side < 0 ? 1 : 3);
            double x = hub.getX() - chassis.getX() - 13 * side * cos;
            double y = hub.getY() - chassis.getY() - 13 * side * sin;
            double stretch = StrictMath.sqrt(x * x + y * y) - LENGTH;
            sum += 0.5 * STIFFNESS * stretch * stretch;
        }
        return sum;
    }

    /** How far a wheel has turned on its hub. */
    private static double turn(List<Body> car, int hub) {
        return car.get(hub + 1).getAngle() - car.get(hub).getAngle();
    }
}
