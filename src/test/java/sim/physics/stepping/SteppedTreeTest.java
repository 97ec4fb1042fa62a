// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping: joints without a loop that nothing touches are solved at once, by RATTLE. In turns they tell one another of what they bear by a link in a substep. */
class SteppedTreeTest {
    private static final double STEP = 1.0 / 60;
    private static final double G = 9.81;

    /** Boxes that are welded to one another in a row, and to the world at one end. In turns ten of them sagged by 1.5, and twenty by 17. */
    @ParameterizedTest
    @ValueSource(ints = {5, 10, 20})
    void aBeamOfWeldedBoxesIsStraight(int boxes) {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(new Gravity(0, -G));
        Body last = null;
        for (int k = 0; k < boxes; k++) {
            Body box = engine.add(new Body(new Rectangle(1, 0.5)).at(k + 0.5, 0));
            engine.add(new WeldJoint(box, last, k, 0));
            last = box;
        }
        Stepped.run(engine, 600);
        assertThat(last.getY()).isEqualTo(0, within(1e-4));
    }

    /** Links whose motors are told in each step to be at an angle when it ends. In turns they missed it by radians, and what was asked for next was to make up for that. */
    @Test
    void aChainOfServosIsWhereItIsToldToBe() {
        int links = 10;
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(new SurfaceFriction(G));
        List<Body> bodies = new ArrayList<>();
        List<Motor> motors = new ArrayList<>();
        for (int k = 0; k < links; k++) {
            Body link = engine.add(new Body(new Rectangle(0.5, 0.1)).at(0.55 * k, 0));
            link.setSurfaceFriction(0.5);
            if (k > 0) {
                engine.add(new PinJoint(bodies.get(k - 1), link, 0.55 * k - 0.275, 0));
                motors.add(engine.add(Motor.turning(link, bodies.get(k - 1), 0, 1e4)));
            }
            bodies.add(link);
        }
        for (int step = 1; step <= 300; step++) {
            for (int k = 0; k < links - 1; k++) {
                motors.get(k).setSpeed((told(k, step) - bent(bodies, k)) / STEP);
            }
            engine.step();
            for (int k = 0; k < links - 1 && step > 1; k++) {
                assertThat(bent(bodies, k)).isEqualTo(told(k, step), within(1e-9));
            }
        }
    }

    private static double bent(List<Body> bodies, int joint) {
        return bodies.get(joint + 1).getAngle() - bodies.get(joint).getAngle();
    }

    private static double told(int joint, int step) {
        double time = step * STEP;
        return Math.min(1, 2 * time) * 0.6 * Math.sin(Math.PI * time + 0.7 * joint);
    }

    /**
     * Rods of 1 m on one another fall from where they lie in a row; energy in units of what they can fall by. RATTLE is off by 2 · 10⁻³, 2 · 10⁻⁴ and
     * 3 · 10⁻⁵. In turns they lost 0.18, 0.005 and 0.003.
     */
    @ParameterizedTest
    @CsvSource({"3, 60, 4e-3", "3, 240, 4e-4", "10, 1000, 1e-4"})
    void aChainThatFallsKeepsItsEnergy(int links, int stepsInASecond, double bound) {
        PhysicsEngine engine = Stepped.engine(1.0 / stepsInASecond, 4);
        engine.add(new Gravity(0, -G));
        List<Body> chain = new ArrayList<>();
        double unit = 0;
        for (int k = 0; k < links; k++) {
            Body link = engine.add(new Body(new Rectangle(1, 0.02)).at(k + 0.5, 0));
            link.setMass(1, 1.0 / 12);
            link.setCollisionGroup(1, 0);
            engine.add(k == 0 ? new PinJoint(link, 0, 0) : new PinJoint(chain.get(k - 1), link, k, 0));
            chain.add(link);
            unit += G * link.getX();
        }
        for (int step = 0; step < 10 * stepsInASecond; step++) {
            engine.step();
            assertThat(energy(engine, chain) / unit).isEqualTo(0, within(bound));
        }
    }

    /** A ball on a chain of which each link weighs a hundredth. In turns its joints opened by 0.05 of 0.5 m, and a sixth of its energy was lost in two seconds. */
    @Test
    void aHeavyBallSwingsOnALightChain() {
        int links = 20;
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(new Gravity(0, -G));
        List<Body> chain = new ArrayList<>();
        List<PinJoint> pins = new ArrayList<>();
        for (int k = 0; k <= links; k++) {
            Body link = k == links ? new Body(new Circle(1)).at(0.5 * links + 1, 0) : new Body(new Rectangle(0.5, 0.1)).at(0.5 * k + 0.25, 0);
            link.setMass(k == links ? 10 : 0.1);
            link.setCollisionGroup(1, 0);
            engine.add(link);
            pins.add(engine.add(k == 0 ? new PinJoint(link, 0, 0) : new PinJoint(chain.get(k - 1), link, 0.5 * k, 0)));
            chain.add(link);
        }
        for (int step = 0; step < 150; step++) {
            engine.step();
            assertThat(energy(engine, chain) / (10 * G * 11)).isEqualTo(0, within(5e-3));
            for (int k = 1; k <= links; k++) {
                Body before = chain.get(k - 1);
                Body link = chain.get(k);
                double arm = k == links ? -1 : -0.25;
                double open = Math.hypot(before.worldX(0.25, 0) - link.worldX(arm, 0), before.worldY(0.25, 0) - link.worldY(arm, 0));
                assertThat(open).isLessThan(1e-3);
            }
        }
    }

    /**
     * Random trees of four to twelve rods, some of their joints with brakes that slip, fall. Brakes that were solved with the joints as if they held, and then let
     * go, pushed: to 1.3 times the energy that there was.
     */
    @Test
    void brakesThatSlipOnlyTakeEnergy() {
        for (int seed = 0; seed < 60; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            PhysicsEngine engine = Stepped.engine(1.0 / (60 + random.nextInt(200)), 4);
            engine.add(new Gravity(0, -G));
            List<Body> tree = new ArrayList<>();
            int links = 4 + random.nextInt(9);
            for (int k = 0; k < links; k++) {
                Body before = k == 0 ? null : tree.get(Math.max(0, k - 1 - random.nextInt(3)));
                double x = before == null ? 0 : before.getX() + 0.6 + 0.6 * random.nextDouble();
                double y = before == null ? 0 : before.getY() + random.nextDouble() - 0.5;
                Body link = engine.add(new Body(new Rectangle(1, 0.1)).at(x, y));
                link.setMass(Math.pow(10, 1.5 * (random.nextDouble() - 0.5)));
                link.setCollisionGroup(1, 0);
                double midX = before == null ? -0.5 : 0.5 * (x + before.getX());
                double midY = before == null ? 0 : 0.5 * (y + before.getY());
                engine.add(before == null ? new PinJoint(link, midX, midY) : new PinJoint(link, before, midX, midY));
                if (random.nextInt(3) == 0) {
                    engine.add(Motor.turning(link, before, 0, 20 * random.nextDouble()));
                }
                tree.add(link);
            }
            double start = energy(engine, tree);
            double unit = 0;
            for (Body link : tree) {
                unit += 2 * link.getMass() * G;
            }
            while (engine.getTime() < 3) {
                engine.step();
                assertThat((energy(engine, tree) - start) / unit).as("seed %d at %f", seed, engine.getTime()).isLessThan(5e-3);
            }
        }
    }

    private static double energy(PhysicsEngine engine, List<Body> chain) {
        double energy = engine.kineticEnergy();
        for (Body link : chain) {
            energy += link.getMass() * G * link.getY();
        }
        return energy;
    }
}
