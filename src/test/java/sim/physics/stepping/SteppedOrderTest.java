// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Curve;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.constraint.WireJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping against events: joints, and contacts that last, are of second order in the substep; joints do no work. */
class SteppedOrderTest {
    private static Body link(PhysicsEngine engine, double x, double y, double length, double angle) {
        Body link = engine.add(new Body(new Rectangle(length, 0.2)).at(x, y, angle));
        link.setCollisionGroup(1, 0);
        return link;
    }

    private static void pendulum(PhysicsEngine engine, String how) {
        Body first = link(engine, 0.5, 0, 1, 0);
        switch (how) {
            case "rod" -> engine.add(new RodJoint(first, 0, 0, null, 0, 0, 0.5));
            case "weld" -> {
                engine.add(new PinJoint(first, 0, 0));
                engine.add(new WeldJoint(first, link(engine, 1.5, 0, 1, 0), 1, 0));
            }
            case "bead" -> engine.add(new WireJoint(first, Curve.circle(0, 0, 0.5)));
            default -> {
                engine.add(new PinJoint(first, 0, 0));
                engine.add(new Spring(first, 0.5, 0, null, 1, 1, 0.5, 20, 0.1)); // soft: a force that changes within the step
            }
        }
    }

    private static void fourBar(PhysicsEngine engine) {
        Body crank = link(engine, 0, 0.5, 1, 0.5 * Math.PI).moving(0.5, 0, -1);
        Body coupler = link(engine, 1, 1, 2, 0);
        Body rocker = link(engine, 2.5, 0.5, Math.sqrt(2), -0.25 * Math.PI);
        engine.add(new PinJoint(crank, 0, 0));
        engine.add(new PinJoint(crank, coupler, 0, 1));
        engine.add(new PinJoint(coupler, rocker, 2, 1));
        engine.add(new PinJoint(rocker, 3, 0));
    }

    /** On the ground, from rest, driven by its rear wheel. */
    private static void car(PhysicsEngine engine) {
        Body ground = engine.add(Body.fixed(new Rectangle(100, 2)).at(0, -1));
        ground.setFriction(0.9);
        ground.setRestitution(0);
        Body chassis = engine.add(new Body(new Rectangle(3, 0.5)).at(0, 0.8));
        for (int x = -1; x <= 1; x += 2) {
            Body wheel = engine.add(new Body(new Circle(0.4)).at(x, 0.4));
            wheel.setFriction(0.9);
            wheel.setRestitution(0);
            engine.add(new PinJoint(chassis, wheel, x, 0.4));
            if (x < 0) {
                engine.add(Motor.turning(wheel, chassis, -8, 2));
            }
        }
    }

    private static double[] places(String what, double step, int substeps, double time) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(0, -Stepped.G));
        switch (what) {
            case "fourBar" -> fourBar(engine);
            case "car" -> car(engine);
            default -> pendulum(engine, what);
        }
        Stepped.run(engine, (int) Math.round(time / step));
        return SleepScenes.places(engine);
    }

    /** Places after a time, in steps of 1/240 s and 1/480 s of four substeps: half the substep misses by a quarter. */
    @ParameterizedTest
    @CsvSource({"rod, 2, 1e-3", "weld, 1, 1e-3", "bead, 2, 1e-3", "spring, 1, 2e-3", "fourBar, 1, 2e-3", "car, 2, 3e-4"})
    void halfTheSubstepMissesByAQuarter(String what, double time, double most) {
        double[] exact = places(what, 1.0 / 1920, 0, time);
        double[] miss = new double[2];
        for (int k = 0; k < 2; k++) {
            double[] places = places(what, 1.0 / (240 << k), 4, time);
            for (int m = 0; m < places.length; m++) {
                miss[k] = Math.max(miss[k], Math.abs(places[m] - exact[m]));
            }
        }
        assertThat(miss[0]).isLessThan(most);
        assertThat(miss[0] / miss[1]).isBetween(3.2, 4.8);
    }

    private static double lost(int discs, int substeps) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
        List<Body> bodies = new ArrayList<>();
        for (int k = 0; k < discs; k++) {
            double x = k == 0 ? 0.5 : -0.5;
            bodies.add(engine.add(new Body(new Circle(0.5)).at(x, 0).moving(0, 5 * x, 5)));
            bodies.get(k).setCollisionGroup(1, 0);
        }
        engine.add(discs == 1 ? new PinJoint(bodies.get(0), 0, 0) : new PinJoint(bodies.get(0), bodies.get(1), 0, 0));
        double before = engine.kineticEnergy();
        Stepped.run(engine, 600);
        return 1 - engine.kineticEnergy() / before;
    }

    /** Discs that spin at 5/s about a pin at their rims, for 10 s: a joint that acts all at once, where the bodies were, took a fifth in substeps of 1/60 s. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void whatSpinsBesideItsCentreKeepsItsEnergy(int discs) {
        assertThat(lost(discs, 1)).isBetween(0.0, 0.05);
        assertThat(lost(discs, 4)).isBetween(0.0, 1.5e-3);
        assertThat(lost(discs, 16)).isBetween(0.0, 5e-5);
    }
}
