// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What strikes under time stepping does what it does by events, to the first order of the step, wherever steps begin. */
class SteppedImpactTest {
    private static final double G = Stepped.G;
    private static final double WIDTH = 1;
    private static final double HEIGHT = 0.6;
    private static final double INERTIA = (WIDTH * WIDTH + HEIGHT * HEIGHT) / 12;

    /** A box of mass 1 that falls onto a corner, turning, from where it is some time after the start; its ground may be welded to the world. */
    private static PhysicsEngine falling(double step, int substeps, double since, double friction, double restitution, boolean isTied) {
        PhysicsEngine engine = Stepped.engine(step, substeps);
        engine.add(new Gravity(0, -G));
        Body ground = isTied ? new Body(new Rectangle(10, 1)) : Body.fixed(new Rectangle(10, 1));
        engine.add(ground.at(0, -0.5));
        if (isTied) {
            engine.add(new WeldJoint(ground, null, 0, -0.5));
        }
        Body box = new Body(new Rectangle(WIDTH, HEIGHT)).at(since, 2 - G * since * since / 2, 0.3 + 0.5 * since).moving(1, -G * since, 0.5);
        box.setMass(1);
        engine.add(box);
        return lawOf(engine, friction, restitution);
    }

    private static PhysicsEngine lawOf(PhysicsEngine engine, double friction, double restitution) {
        for (Body body : engine.bodies()) {
            body.setFriction(friction);
            body.setRestitution(restitution);
        }
        return engine;
    }

    private static Body last(PhysicsEngine engine) {
        return engine.bodies().get(engine.bodies().size() - 1);
    }

    /** When the box's lower right corner is down, by bisection of the height of a free fall. */
    private static double touchdown() {
        double from = 0.4;
        double to = 0.6;
        while (to - from > 1e-15) {
            double t = 0.5 * (from + to);
            double angle = 0.3 + 0.5 * t;
            boolean isAbove = 2 - G * t * t / 2 + low(angle) > 0;
            from = isAbove ? t : from;
            to = isAbove ? to : t;
        }
        return from;
    }

    /** The lower left corner against the centre: its height, and how far it is to the left. */
    private static double low(double angle) {
        return -0.5 * WIDTH * Math.sin(angle) - 0.5 * HEIGHT * Math.cos(angle);
    }

    private static double side(double angle) {
        return -0.5 * WIDTH * Math.cos(angle) + 0.5 * HEIGHT * Math.sin(angle);
    }

    /** [vx, vy, ω] after the corner has struck: the impulse stops the slip if friction can, or lies on the edge of its cone. */
    private static double[] struck(double time, double friction, double restitution) {
        double angle = 0.3 + 0.5 * time;
        double x = side(angle);
        double y = low(angle);
        double nn = 1 + x * x / INERTIA;
        double tt = 1 + y * y / INERTIA;
        double nt = -x * y / INERTIA;
        double approach = -G * time + 0.5 * x;
        double slip = 1 - 0.5 * y;
        double wanted = -(1 + restitution) * approach;
        double det = nn * tt - nt * nt;
        double normal = (tt * wanted + nt * slip) / det;
        double along = -(nn * slip + nt * wanted) / det;
        if (Math.abs(along) > friction * normal) {
            double mu = -Math.signum(slip + nt * wanted / nn) * friction;
            normal = wanted / (nn + mu * nt);
            along = mu * normal;
        }
        return new double[] {1 + along, -G * time + normal, 0.5 + (x * normal - y * along) / INERTIA};
    }

    /** Wherever the step begins in which it strikes: the closed form. Errors were up to a half of the change, and did not become smaller. */
    @ParameterizedTest
    @CsvSource({"0, 0", "0.1, 0", "0.3, 0", "0.9, 0", "0.1, 0.5", "0.3, 0.5", "0.9, 0.5", "0.1, 1"})
    void aCornerIsStruckAsByTheClosedForm(double friction, double restitution) {
        double time = touchdown();
        double[] expected = struck(time, friction, restitution);
        for (double step : new double[] {1.0 / 240, 1.0 / 960, 1.0 / 3840}) {
            for (int phase = 0; phase < 10; phase++) {
                double since = 0.1 * phase * step;
                PhysicsEngine engine = falling(step, 1 + phase % 4, since, friction, restitution, false);
                int steps = 2 + (int) Math.ceil((time - since) / step);
                Stepped.run(engine, steps);
                Body box = last(engine);
                double after = since + steps * step - time;
                String where = "step " + step + ", phase " + phase;
                assertThat(box.getVelocityX()).as(where).isCloseTo(expected[0], within(40 * step));
                assertThat(box.getVelocityY() + G * after).as(where).isCloseTo(expected[1], within(40 * step));
                assertThat(box.getAngularVelocity()).as(where).isCloseTo(expected[2], within(80 * step));
            }
        }
    }

    /** How far the box has slid and turned in the end, after all of its impacts: as by events, also on a ground that is a body, to the first order. */
    @ParameterizedTest
    @CsvSource({"0, false", "0, true", "0.5, false", "0.5, true"})
    void theWayAfterSomeImpactsIsThatByEvents(double restitution, boolean isTied) {
        PhysicsEngine reference = falling(1.0 / 3840, 0, 0, 0.3, restitution, isTied);
        double solved = isTied ? 0.01 : 0; // what turns with joints leave
        Stepped.run(reference, 64 * 80);
        for (int finer : new int[] {4, 16, 64}) {
            PhysicsEngine engine = falling(1.0 / 60 / finer, 4, 0, 0.3, restitution, isTied);
            Stepped.run(engine, finer * 80);
            assertThat(last(engine).getX()).as("1/" + 60 * finer).isCloseTo(last(reference).getX(), within(0.15 / finer + solved));
            assertThat(last(engine).getAngle()).as("1/" + 60 * finer).isCloseTo(last(reference).getAngle(), within(0.4 / finer + solved));
        }
    }

    /** Two boxes on a pin that fall, by chance, and slide or bounce: most are where they are by events. Most were not at any step. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5})
    void pinnedBoxesStrikeAsByEvents(double restitution) {
        double[] errors = new double[30];
        for (int seed = 0; seed < errors.length; seed++) {
            Body[] exact = pinned(seed, 1.0 / 960, 0, restitution);
            Body[] stepped = pinned(seed, 1.0 / 1920, 4, restitution);
            for (int k = 0; k < exact.length; k++) {
                errors[seed] = Math.max(errors[seed], Math.hypot(exact[k].getX() - stepped[k].getX(), exact[k].getY() - stepped[k].getY()));
            }
        }
        Arrays.sort(errors);
        assertThat(errors[15]).as("median").isLessThan(5e-3);
        assertThat(errors[24]).as("four fifths").isLessThan(3e-2);
    }

    private static Body[] pinned(int seed, double step, int substeps, double restitution) {
        SplittableRandom random = new SplittableRandom(seed);
        PhysicsEngine engine = Stepped.engine(step, substeps);
        engine.add(new Gravity(0, -G));
        engine.add(Body.fixed(new Rectangle(50, 1)).at(0, -0.5));
        Body[] pair = new Body[2];
        for (int k = 0; k < 2; k++) {
            double angle = 3 * random.nextDouble();
            pair[k] = engine.add(new Body(new Rectangle(0.6 + random.nextDouble(), 0.4)).at(1.6 * k, 2.2 + random.nextDouble(), angle));
            pair[k].setVelocity(2 * random.nextDouble() - 1, 0);
        }
        engine.add(new PinJoint(pair[0], pair[1], 0.8, 0.5 * (pair[0].getY() + pair[1].getY())));
        engine.setCollisions(pair[0], pair[1], false);
        lawOf(engine, random.nextDouble(), restitution);
        Stepped.run(engine, (int) Math.round(1 / step));
        return pair;
    }

    /** Piles of what bounces come to rest, most of them. Bodies in all of them had speeds of 0.05 to 0.3 m/s for ever. */
    @ParameterizedTest
    @ValueSource(doubles = {0.4, 0.8})
    void pilesOfWhatBouncesComeToRest(double restitution) {
        double[] energies = new double[9];
        for (int seed = 0; seed < energies.length; seed++) {
            PhysicsEngine engine = lawOf(pile(seed), 0.5, restitution);
            Stepped.run(engine, 40 * 60);
            energies[seed] = engine.kineticEnergy();
        }
        Arrays.sort(energies);
        assertThat(energies[5]).isLessThan(1e-5);
        assertThat(energies[8]).isLessThan(1e-2);
    }

    private static PhysicsEngine pile(int seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        engine.add(new Gravity(0, -G));
        engine.add(Body.fixed(new Rectangle(30, 1)).at(0, -0.5));
        engine.add(Body.fixed(new Rectangle(1, 60)).at(-6.5, 29));
        engine.add(Body.fixed(new Rectangle(1, 60)).at(6.5, 29));
        for (int k = 0; k < 24; k++) {
            double size = 0.5 + random.nextDouble();
            Body body = new Body(k % 3 == 0 ? new Circle(size / 2) : new Rectangle(size, 0.4 + 0.6 * random.nextDouble()));
            engine.add(body.at(-5 + 2 * (k % 6) + 0.2 * random.nextDouble(), 1.2 + 1.7 * (k / 6), 3 * random.nextDouble()));
        }
        return engine;
    }

    /** A ball that bounces for ever is as high after 100 s. It had lost nine tenths of its height. */
    @ParameterizedTest
    @CsvSource({"1, 0", "4, 0", "1, 0.5", "4, 0.5"})
    void anElasticBallBouncesForEver(int substeps, double friction) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
        engine.add(new Gravity(0, -G));
        Stepped.ground(engine);
        Body ball = engine.add(new Body(new Circle(0.2)).at(0, 2));
        lawOf(engine, friction, 1);
        double begun = G * 2;
        for (int k = 0; k < 6000; k++) {
            engine.step();
            double energy = 0.5 * ball.getVelocityY() * ball.getVelocityY() + G * ball.getY();
            assertThat(energy / begun).isBetween(0.97, 1.03);
        }
    }
}
