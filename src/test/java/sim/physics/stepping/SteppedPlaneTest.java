// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Rectangle;

/** Time stepping: friction with the plane is that of the body's patch, and not of an ellipsoid of forces and torques. */
class SteppedPlaneTest {
    private static final double STEP = 1.0 / 60;
    private static final double MU = 0.3;
    private static final double G = 9.81;

    private static PhysicsEngine plane(double step, int substeps) {
        PhysicsEngine engine = Stepped.engine(step, substeps);
        engine.add(new SurfaceFriction(G));
        return engine;
    }

    /**
     * A rectangle of length 1 starts with (1, 0.5) and turns. Where it stops is from RK4 with friction summed over 400 × 80 cells, to 1e-4. The ellipsoid let the square
     * stop 0.33 from there and the slender one 0.034, in whatever steps.
     */
    @ParameterizedTest
    @CsvSource({"0.1, 5, 0.3287, 0.1364, 1.7491", "1, 20, 1.6849, 0.8424, 29.881"})
    void whatSlidesAndSpinsStopsWhereItsPatchLetsIt(double width, double spin, double x, double y, double angle) {
        PhysicsEngine engine = plane(STEP, 4);
        Body body = new Body(new Rectangle(1, width)).moving(1, 0.5, spin);
        body.setSurfaceFriction(MU);
        engine.add(body);
        double energy = engine.kineticEnergy();
        while (energy > 0 && engine.getTime() < 10) {
            engine.step();
            assertThat(engine.kineticEnergy()).as("friction takes energy").isLessThan(energy);
            energy = engine.kineticEnergy();
        }
        assertThat(body.getX()).isEqualTo(x, within(1.5e-3));
        assertThat(body.getY()).isEqualTo(y, within(1.5e-3));
        assertThat(body.getAngle()).isEqualTo(angle, within(1.5e-3));
    }

    /** A rod that is pushed at its end, across it, turns about the point at 1/√2 of its length, and begins to at √2 − 1 of its friction: the ellipsoid has 1/√5. */
    @ParameterizedTest
    @ValueSource(doubles = {0.41, 0.42})
    void aRodYieldsAtItsEndToTheForceThatItsPatchYieldsTo(double part) {
        PhysicsEngine engine = plane(STEP, 4);
        Body rod = new Body(new Rectangle(1, 1e-3)).at(0, 0);
        rod.setMass(2);
        rod.setSurfaceFriction(MU);
        engine.add(rod);
        for (int k = 0; k < 240; k++) {
            rod.addForceAt(0, part * MU * 2 * G, 0.5 * Math.cos(rod.getAngle()), rod.getY() + 0.5 * Math.sin(rod.getAngle()));
            engine.step();
        }
        if (part < Math.sqrt(2) - 1) {
            assertThat(rod.getAngle()).isZero();
        } else {
            assertThat(rod.getAngle()).isGreaterThan(0.01);
        }
    }

    /**
     * Ten links that bend in a wave, of which friction makes a way: 0.7516 back in 10 s, by RK4 for the three coordinates that the angles leave free, with friction
     * summed by Gauss's rule over 12 × 4 points a link. The ellipsoid made it 0.47 in whatever steps.
     */
    @Test
    void aSnakeGetsAsFarAsItsFrictionLetsIt() {
        int links = 10;
        double pitch = 0.55;
        double step = 0.004;
        PhysicsEngine engine = plane(step, 4);
        Body[] bodies = new Body[links];
        Motor[] motors = new Motor[links - 1];
        for (int k = 0; k < links; k++) {
            bodies[k] = new Body(new Rectangle(0.5, 0.1)).at(k * pitch, 0);
            bodies[k].setMass(1);
            bodies[k].setSurfaceFriction(0.5);
            engine.add(bodies[k]);
            if (k > 0) {
                engine.add(new PinJoint(bodies[k - 1], bodies[k], (k - 0.5) * pitch, 0));
                motors[k - 1] = Motor.turning(bodies[k], bodies[k - 1], 0, 1e4);
                engine.add(motors[k - 1]);
            }
        }
        for (int n = 0; n < 2500; n++) {
            for (int k = 0; k < links - 1; k++) {
                motors[k].setSpeed((bend(k, (n + 1) * step) - bend(k, n * step)) / step);
            }
            engine.step();
        }
        double way = 0;
        for (Body body : bodies) {
            way += body.getX() / links;
        }
        assertThat(way - 0.5 * (links - 1) * pitch).isEqualTo(-0.7516, within(0.01));
    }

    /** The angle of a joint, which begins smoothly. */
    private static double bend(int joint, double time) {
        double s = Math.min(1, 2 * time);
        return s * s * (3 - 2 * s) * 0.6 * Math.sin(Math.PI * time + 0.7 * joint);
    }
}
