// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * Impacts within a step of time stepping are those by events: at their instant, where the bodies are then. They were solved at its end, along normals of
 * its start, so that errors of velocities were a tenth and more of the change, in any substeps.
 */
class SteppedFreeImpactTest {
    private static final int SCENES = 40;

    /** What strikes what. */
    private enum Scene {
        DISC_AND_CORNER,
        DISCS,
        BOX_AND_CORNER,
        BOX_ON_FLOOR,
        CAR_AND_CORNER
    }

    private static double[] run(Scene scene, double restitution, int seed, int finer, int substeps) {
        SplittableRandom random = new SplittableRandom(seed);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60 / finer);
        engine.setTimeStepping(substeps);
        double friction = 0.2 + 0.7 * random.nextDouble();
        double speed = 2 + 2 * random.nextDouble();
        double y = 0.35 + 0.15 * random.nextDouble();
        double spin = 16 * random.nextDouble() - 8;
        double angle = 3 * random.nextDouble();
        double x = -0.9 - (double) seed / SCENES * speed / 60; // each begins at another time of a step
        Body corner = Body.fixed(new Rectangle(0.6, 0.1)).at(0, 0.05);
        Body disc = new Body(new Circle(0.4)).at(x, y).moving(speed, 0, spin);
        switch (scene) {
            case DISC_AND_CORNER -> add(engine, corner, disc);
            case DISCS -> add(engine, new Body(new Circle(0.5)), disc);
            case BOX_AND_CORNER -> add(engine, corner, new Body(new Rectangle(0.5, 0.3)).at(x, y - 0.15, angle).moving(speed, -0.3, 0.3 * spin));
            case BOX_ON_FLOOR -> {
                engine.add(new Gravity(0, -Stepped.G));
                Body box = new Body(new Rectangle(0.5, 0.3)).at(x, 0.62, 0.3 + 0.5 * angle).moving(speed, -2, 0.3 * spin);
                add(engine, Body.fixed(new Rectangle(40, 2)).at(0, -1), box);
            }
            default -> {
                Body chassis = new Body(new Rectangle(3, 0.5)).at(x - 1, y + 0.4).moving(speed, 0);
                add(engine, corner, disc, chassis);
                engine.add(new PinJoint(chassis, disc, x, y));
            }
        }
        for (Body body : engine.bodies()) {
            body.setFriction(friction);
            body.setRestitution(restitution);
        }
        Stepped.run(engine, 16 * finer);
        return engine.bodies().stream()
                .flatMap(b -> List.of(b.getVelocityX(), b.getVelocityY(), b.getAngularVelocity(), b.getX(), b.getY(), b.getAngle()).stream())
                .mapToDouble(d -> d)
                .toArray();
    }

    private static void add(PhysicsEngine engine, Body... bodies) {
        for (Body body : bodies) {
            engine.add(body);
        }
    }

    /** Errors of all scenes, in ascending order: the largest of a velocity or place. */
    private static double[] errors(Scene scene, double restitution, int finer, int substeps) {
        double[] errors = new double[SCENES];
        for (int seed = 0; seed < SCENES; seed++) {
            double[] exact = run(scene, restitution, seed, 4, 0);
            double[] found = run(scene, restitution, seed, finer, substeps);
            for (int k = 0; k < exact.length; k++) {
                errors[seed] = Math.max(errors[seed], Math.abs(found[k] - exact[k]));
            }
        }
        Arrays.sort(errors);
        return errors;
    }

    /** What is round is as by events to rounding (10⁻⁸ where it grazes), at the usual step. It was off by 0.2 m/s and 3 cm in the median. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, 0.8, 1})
    void whatIsRoundStrikesAsByEvents(double restitution) {
        for (Scene scene : List.of(Scene.DISC_AND_CORNER, Scene.DISCS)) {
            double[] errors = errors(scene, restitution, 1, 4);
            assertThat(errors[SCENES / 2]).as(scene.name()).isLessThan(1e-12);
            assertThat(errors[9 * SCENES / 10]).as(scene.name()).isLessThan(1e-7);
        }
    }

    /**
     * A disc that spins strikes a wall at any angle: Newton's law along the normal, and Coulomb's at the radius, μ (1 + e) |vn| or what stops the sliding,
     * a third of its speed. Friction acted at the disc's distance from the wall when the step had begun: it turned it by up to a seventh too much.
     */
    @ParameterizedTest
    @CsvSource({"0.05, 1", "0.05, 4", "0.0166666666666667, 1", "0.0166666666666667, 4", "0.0123, 3"})
    void aDiscIsRubbedAtItsRadius(double step, int substeps) {
        SplittableRandom random = new SplittableRandom(3);
        for (int k = 0; k < 100; k++) {
            double x = StrictMath.cos(k);
            double y = StrictMath.sin(k);
            double friction = random.nextDouble();
            double restitution = random.nextDouble();
            double down = -1 - 2 * random.nextDouble();
            double along = 6 * random.nextDouble() - 3;
            double spin = 40 * random.nextDouble() - 20;
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(step);
            engine.setTimeStepping(substeps);
            Body wall = Body.fixed(new Rectangle(20, 1)).at(0.5 * y, -0.5 * x, k);
            Body disc = new Body(new Circle(0.3)).at(-0.6 * y, 0.6 * x).moving(along * x - down * y, along * y + down * x, spin);
            add(engine, wall, disc);
            for (Body body : engine.bodies()) {
                body.setFriction(friction);
                body.setRestitution(restitution);
            }
            Stepped.run(engine, (int) StrictMath.ceil(0.4 / step));
            double slip = along + 0.3 * spin;
            double rubbed = -Math.signum(slip) * Math.min(friction * (1 + restitution) * -down, Math.abs(slip) / 3);
            assertThat(disc.getAngularVelocity()).isCloseTo(spin + 2 * rubbed / 0.3, within(1e-10));
            assertThat(x * disc.getVelocityX() + y * disc.getVelocityY()).isCloseTo(along + rubbed, within(1e-10));
            assertThat(x * disc.getVelocityY() - y * disc.getVelocityX()).isCloseTo(-restitution * down, within(1e-10));
        }
    }

    /** Boxes, whose turns within a step are series, to 10⁻³ at the usual step, and 50 times less at a quarter of it. They were off by 0.3 to 0.7. */
    @ParameterizedTest
    @CsvSource({"BOX_AND_CORNER, 0.3", "BOX_AND_CORNER, 0.8", "BOX_AND_CORNER, 1", "BOX_ON_FLOOR, 0.8", "BOX_ON_FLOOR, 1"})
    void boxesStrikeAsByEvents(Scene scene, double restitution) {
        double whole = errors(scene, restitution, 1, 4)[SCENES / 2];
        double quarter = errors(scene, restitution, 4, 4)[SCENES / 2];
        assertThat(whole).isLessThan(1e-3);
        assertThat(quarter).isLessThan(whole / 20);
    }

    /** Where joints have part in an impact its error falls with the substep. It did not fall at all. */
    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.8, 1})
    void whatJointsHavePartInFallsWithTheSubstep(double restitution) {
        double coarse = errors(Scene.CAR_AND_CORNER, restitution, 1, 4)[SCENES / 2];
        double fine = errors(Scene.CAR_AND_CORNER, restitution, 1, 64)[SCENES / 2];
        assertThat(coarse).isLessThan(0.1);
        assertThat(fine).isLessThan(coarse / 8);
    }

    /** Elastic impacts keep the angular momentum. Each took up to a hundredth of it, or gave it. */
    @Test
    void elasticImpactsKeepTheAngularMomentum() {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        SplittableRandom random = new SplittableRandom(3);
        for (int k = 0; k < 25; k++) {
            Body body = new Body(k % 2 == 0 ? new Circle(0.5) : new Rectangle(0.9, 0.6)).at(1.4 * (k % 5), 1.4 * (k / 5));
            engine.add(body.moving(3 - 1.2 * (k % 5) + random.nextDouble(), 3 - 1.2 * (k / 5) + random.nextDouble(), random.nextDouble()));
            body.setRestitution(1);
            body.setFriction(0.3);
        }
        double[] before = Stepped.momentum(engine);
        Stepped.run(engine, 300);
        double[] after = Stepped.momentum(engine);
        assertThat(engine.getImpacts()).isGreaterThan(20);
        for (int k = 0; k < 3; k++) {
            assertThat(after[k]).isCloseTo(before[k], within(1e-10));
        }
    }

    private static List<Body> fall(PhysicsEngine engine, double x, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Body ground = Body.fixed(new Rectangle(20, 1)).at(x, -0.5);
        List<Body> all = new ArrayList<>(List.of(ground));
        for (int k = 0; k < 3; k++) {
            double size = 0.4 + 0.4 * random.nextDouble();
            Body body = new Body(k % 2 == 0 ? new Circle(0.5 * size) : new Rectangle(size, 0.5));
            all.add(body.at(x + 0.5 * (k % 2) + 0.3 * random.nextDouble(), 0.5 + 0.8 * k)
                    .moving(8 * random.nextDouble() - 4, -3 * random.nextDouble(), 8 * random.nextDouble() - 4));
        }
        for (Body body : all) {
            body.setFriction(0);
            body.setRestitution(0);
            engine.add(body);
        }
        return all;
    }

    private static PhysicsEngine falling() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.setTimeStepping(4);
        engine.add(new Gravity(0, -Stepped.G));
        return engine;
    }

    private static boolean goAlike(long seed) {
        PhysicsEngine one = falling();
        PhysicsEngine both = falling();
        List<Body> alone = fall(one, 0, seed);
        List<Body> near = fall(both, 0, seed);
        fall(both, 1000, seed + 5000);
        boolean are = true;
        for (int step = 0; are && step < 40; step++) {
            one.step();
            both.step();
            for (int k = 0; k < alone.size(); k++) {
                are &= alone.get(k).getY() == near.get(k).getY() && alone.get(k).getVelocityX() == near.get(k).getVelocityX();
            }
        }
        return are;
    }

    /**
     * Two bins, far from one another: what has met in one of them knows its gaps, not what a pair of the other one has left in its place. With the first
     * seed it did not. (Not with all seeds are bits the same: others may be solved in another order.)
     */
    @ParameterizedTest
    @ValueSource(longs = {286, 1, 2, 3})
    void whatIsFarAwayHasNoPartInAnImpact(long seed) {
        assertThat(goAlike(seed)).isTrue();
    }
}
