// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.Cuts;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.RungeKutta4;
import sim.physics.references.RodChain;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Methods that choose their steps move trees of pins in their angles: against the general code, a reference, and laws. */
class TreeCoordinatesTest {
    private static final double G = 9.81;

    private static Integrator method(String name, double tolerance) {
        return switch (name) {
            case "DOP853" -> new DormandPrince853(tolerance);
            case "GBS" -> new GraggBulirschStoer(tolerance);
            case "Automatic" -> new Automatic(tolerance);
            default -> new RungeKutta4();
        };
    }

    /** A tree of plates, some pinned where others are, some at their centres of mass, and how many steps it is followed. */
    private static final class Tree {
        final PhysicsEngine engine = new PhysicsEngine();
        final List<Body> plates = new ArrayList<>();
        final List<PinJoint> pins = new ArrayList<>();
        final Body base = Body.fixed(new Circle(0.01));
        final Wind wind = new Wind();

        /** Whether it is held by the world, by a fixed body or by nothing; a tree is not quick where a force may couple bodies. */
        Tree(String hold, boolean isQuick, boolean isWindy) {
            SplittableRandom random = new SplittableRandom(11);
            engine.add(new Gravity(0.5, -G));
            engine.add(base.at(0.25, -0.5));
            base.setCollisionGroup(1, 0);
            double[] x = new double[9];
            double[] y = new double[9];
            for (int k = 0; k < x.length; k++) {
                int from = k == 0 ? -1 : k % 3 == 2 ? k / 2 : k - 1;
                double nearX = from < 0 ? 0.25 : x[from];
                double nearY = from < 0 ? -0.5 : y[from];
                boolean isAtCentre = k == 4;
                double centreX = nearX + (isAtCentre ? 0 : random.nextDouble() - 0.3);
                double centreY = nearY + (isAtCentre ? 0 : random.nextDouble() - 0.7);
                boolean isShort = k == 6; // the next one hangs at the same pin
                x[k] = isShort ? nearX : centreX + 0.5 * random.nextDouble();
                y[k] = isShort ? nearY : centreY - 0.5 * random.nextDouble();
                Body plate = engine.add(new Body(new Rectangle(0.4, 0.3)).at(centreX, centreY, random.nextDouble()));
                plate.setMass(0.5 + random.nextDouble(), 0.05 + 0.1 * random.nextDouble());
                plate.setCollisionGroup(1, 0);
                plates.add(plate);
                if (from >= 0) {
                    Body other = plates.get(from);
                    pins.add(engine.add(k % 2 == 0 ? new PinJoint(other, plate, nearX, nearY) : new PinJoint(plate, other, nearX, nearY)));
                } else if (hold.equals("world")) {
                    pins.add(engine.add(new PinJoint(plate, nearX, nearY)));
                } else if (hold.equals("base")) {
                    pins.add(engine.add(new PinJoint(base, plate, nearX, nearY)));
                }
            }
            plates.forEach(plate -> plate.setAngularVelocity(random.nextDouble() - 0.5)); // the pins take what they do not allow
            if (isWindy) {
                engine.add(wind);
            }
            if (!isQuick) {
                engine.add(new PinChainTest.Nothing());
            }
        }

        void run(int steps) {
            for (int k = 0; k < steps; k++) {
                engine.step();
            }
        }

        double[] places() {
            double[] places = new double[6 * plates.size()];
            for (int k = 0; k < plates.size(); k++) {
                Body plate = plates.get(k);
                places[6 * k] = plate.getX();
                places[6 * k + 1] = plate.getY();
                places[6 * k + 2] = plate.getAngle();
                places[6 * k + 3] = plate.getVelocityX();
                places[6 * k + 4] = plate.getVelocityY();
                places[6 * k + 5] = plate.getAngularVelocity();
            }
            return places;
        }

        void closed() {
            for (Constraint pin : engine.allConstraints()) {
                assertThat(PinChainTest.gap((PinJoint) pin)).isLessThan(100 * 0x1p-52);
            }
        }
    }

    /** A force and a torque that change with place, turn and velocity; it can fail. */
    private static final class Wind implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private int callsUntilItFails = Integer.MAX_VALUE;

        @Override
        public boolean isAutonomous() {
            return true;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            if (callsUntilItFails-- == 0) {
                throw new UnsupportedOperationException("calm");
            }
            double pull = 5 - 3 * body.getX();
            double lift = 4 * StrictMath.sin(body.getAngle()) - body.getVelocityY();
            forces.addAt(body, pull, lift, body.getX() + 0.1, body.getY() - 0.05);
            forces.addTorque(body, -0.2 * body.getAngularVelocity());
        }
    }

    /** The same history, in the quick way with some method and in the general one: by long steps of the engine, and by short ones. */
    private static void compare(String name, String hold, boolean isWindy, Consumer<Tree> history) {
        compare(name, hold, isWindy, 1 / 2048.0, history);
        if (!name.equals("RK4")) {
            compare(name, hold, isWindy, 1 / 64.0, history);
        }
    }

    private static void compare(String name, String hold, boolean isWindy, double step, Consumer<Tree> history) {
        Tree quick = new Tree(hold, true, isWindy);
        Tree general = new Tree(hold, false, isWindy);
        quick.engine.setIntegrator(method(name, 1e-12));
        general.engine.setIntegrator(new DormandPrince853(1e-13));
        quick.engine.setTimeStep(step);
        general.engine.setTimeStep(step);
        history.accept(quick);
        history.accept(general);
        assertThat(quick.places()).containsExactly(general.places(), within(name.equals("RK4") ? 1e-6 : 2e-9));
        quick.closed();
    }

    private static int steps(Tree tree) {
        return (int) Math.round(0.25 / tree.engine.getTimeStep());
    }

    @ParameterizedTest
    @CsvSource({
        "DOP853, world, false", "DOP853, base, true", "DOP853, free, false", "DOP853, free, true",
        "GBS, world, true", "GBS, base, false", "GBS, free, false", "GBS, free, true", "Automatic, free, true", "RK4, base, true"
    })
    void goToWhereTheGeneralCodeGoes(String name, String hold, boolean isWindy) {
        compare(name, hold, isWindy, tree -> tree.run(2 * steps(tree)));
    }

    @ParameterizedTest
    @CsvSource({"RK4, world", "DOP853, world", "GBS, free", "Automatic, base"})
    void newMassesActAtOnce(String name, String hold) {
        compare(name, hold, false, tree -> {
            tree.run(steps(tree));
            tree.plates.get(3).setMass(2, 0.3);
            tree.plates.get(8).setMass(0.4);
            tree.run(steps(tree));
        });
    }

    @ParameterizedTest
    @ValueSource(strings = {"RK4", "DOP853", "GBS", "Automatic"})
    void aBaseThatIsMovedTakesTheTreeAlong(String name) {
        compare(name, "base", true, tree -> {
            tree.run(steps(tree));
            tree.base.setPosition(0.27, -0.52);
            tree.run(steps(tree));
        });
    }

    @ParameterizedTest
    @CsvSource({"RK4, world", "DOP853, world", "GBS, base", "Automatic, free", "DOP853, free"})
    void whatIsCutAndPushedGoesItsWay(String name, String hold) {
        compare(name, hold, false, tree -> {
            tree.run(steps(tree));
            tree.engine.remove(tree.pins.get(tree.pins.size() - 3));
            tree.plates.get(7).setVelocity(0.2, 0.1);
            tree.run(steps(tree) / 2);
            tree.plates.get(2).addForce(3, 4);
            tree.plates.get(8).addTorque(0.5);
            tree.run(steps(tree) / 2);
        });
    }

    @ParameterizedTest
    @ValueSource(strings = {"RK4", "DOP853", "GBS", "Automatic"})
    void aForceThatFailsLeavesNothingBehind(String name) {
        compare(name, "world", true, name.equals("RK4") ? 1 / 2048.0 : 1 / 64.0, tree -> {
            tree.run(steps(tree));
            double[] places = tree.places();
            tree.wind.callsUntilItFails = 30;
            assertThatThrownBy(() -> tree.run(1)).isInstanceOf(UnsupportedOperationException.class);
            tree.wind.callsUntilItFails = Integer.MAX_VALUE;
            for (int k = 0; k < tree.plates.size(); k++) {
                Body plate = tree.plates.get(k);
                plate.at(places[6 * k], places[6 * k + 1], places[6 * k + 2]);
                plate.moving(places[6 * k + 3], places[6 * k + 4], places[6 * k + 5]);
            }
            tree.run(steps(tree) - 1);
        });
    }

    /** What one method leaves for the next is where the bodies are. */
    @ParameterizedTest
    @ValueSource(strings = {"world", "free"})
    void methodsMayTakeTurns(String hold) {
        Tree turns = new Tree(hold, true, false);
        Tree general = new Tree(hold, false, false);
        turns.engine.setTimeStep(1 / 1920.0);
        general.engine.setTimeStep(1 / 1920.0);
        general.engine.setIntegrator(new DormandPrince853(1e-12));
        for (String name : new String[] {"RK4", "DOP853", "RK4", "GBS", "RK4", "Automatic", "DOP853", "RK4"}) {
            turns.engine.setIntegrator(method(name, 1e-11));
            turns.run(60);
            general.run(60);
        }
        assertThat(turns.places()).containsExactly(general.places(), within(1e-7));
        turns.closed();
    }

    @ParameterizedTest
    @CsvSource({
        "DOP853, 1e-4", "DOP853, 1e-7", "DOP853, 1e-10", "DOP853, 1e-12", "GBS, 1e-4", "GBS, 1e-7", "GBS, 1e-10", "GBS, 1e-12",
        "Automatic, 1e-8"
    })
    void theErrorOfAChainIsAboutTheTolerance(String name, double tolerance) {
        RodChain exact = new RodChain(10, G);
        double[] tip = exact.tip(exact.states(new double[] {2}, true, 1e-14)[0]);
        for (int steps : new int[] {1, 500}) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setIntegrator(method(name, tolerance));
            engine.setTimeStep(2.0 / steps);
            engine.add(new Gravity(0, -G));
            Body last = Scenes.rods(engine, 10, 0);
            for (int k = 0; k < steps; k++) {
                engine.step();
            }
            double x = last.getX() + 0.5 * StrictMath.cos(last.getAngle());
            double y = last.getY() + 0.5 * StrictMath.sin(last.getAngle());
            assertThat(StrictMath.hypot(x - tip[0], y - tip[1])).as("%d steps", steps).isBetween(0.01 * tolerance, 30 * tolerance);
        }
    }

    /** The centre of mass of a free tree falls as a body, and what nothing takes away is kept, whatever the tolerance. */
    @ParameterizedTest
    @CsvSource({"DOP853, 0.01", "GBS, 0.01", "Automatic, 0.5", "DOP853, 0.5"})
    void aFreeTreeKeepsWhatItHas(String name, double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setIntegrator(method(name, 1e-4));
        engine.setTimeStep(step);
        Scenes.rods(engine, 6, 0);
        engine.remove(engine.allConstraints().get(0));
        engine.bodies().get(2).setVelocity(1, 2);
        engine.bodies().get(5).setAngularVelocity(9);
        engine.step();
        double[] before = invariants(engine);
        for (int k = 0; k < Math.round(5 / step); k++) {
            engine.step();
        }
        assertThat(invariants(engine)).containsExactly(before, within(1e-12 * before[0]));
    }

    /** Energy, momentum, angular momentum. */
    private static double[] invariants(PhysicsEngine engine) {
        double[] sum = {engine.kineticEnergy(), 0, 0, 0};
        for (Body body : engine.bodies()) {
            double m = body.getMass();
            sum[1] += m * body.getVelocityX();
            sum[2] += m * body.getVelocityY();
            sum[3] += body.getInertia() * body.getAngularVelocity()
                    + m * (body.getX() * body.getVelocityY() - body.getY() * body.getVelocityX());
        }
        return sum;
    }

    /** Nothing bends the path of an angle here, so that no error asks for a step; yet what is in the way is met. */
    @ParameterizedTest
    @CsvSource({"DOP853, 1", "GBS, 1", "Automatic, 1", "DOP853, 0.001"})
    void aRotorMeetsWhatIsInItsWay(String name, double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setIntegrator(method(name, 1e-3));
        engine.setTimeStep(step);
        Body rotor = engine.add(new Body(new Rectangle(2, 0.1)).at(1, 0));
        engine.add(new PinJoint(rotor, 0, 0));
        engine.add(Body.fixed(new Circle(0.1)).at(-1.5, 0));
        rotor.setVelocity(0, 6 * Math.PI);
        rotor.setAngularVelocity(6 * Math.PI);
        double until = 1 / 6.0 - 0.02;
        for (int k = 0; k < Math.ceil(until / step); k++) {
            engine.step();
        }
        if (step < until) {
            assertThat(engine.getImpacts()).isZero();
            assertThat(rotor.getAngle()).isCloseTo(6 * Math.PI * engine.getTime(), within(1e-9));
        }
        while (engine.getTime() < 0.9) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isBetween(1L, 9L);
    }

    /** Impacts in the quick way and in the general one. */
    @ParameterizedTest
    @CsvSource({"DOP853, 0.2", "GBS, 0.2", "DOP853, 0.002"})
    void impactsAreTheSame(String name, double step) {
        double[][] ends = new double[2][];
        for (int way = 0; way < 2; way++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setIntegrator(method(name, way == 0 ? 1e-11 : 1e-12));
            engine.setTimeStep(step);
            engine.add(new Gravity(0, -G));
            engine.add(Body.fixed(new Rectangle(20, 1)).at(0, -2.1));
            Scenes.rods(engine, 3, 2);
            Body ball = engine.add(new Body(new Circle(0.2)).at(2.9, -1.2));
            ball.setCollisionGroup(2, 3);
            ball.setRestitution(0.9);
            if (way == 1) {
                engine.add(new PinChainTest.Nothing());
            }
            while (engine.getTime() < 0.999) {
                engine.step();
            }
            assertThat(engine.getImpacts()).isGreaterThan(1);
            ends[way] = engine.bodies().stream().flatMapToDouble(b -> DoubleStream.of(b.getX(), b.getY())).toArray();
        }
        assertThat(ends[0]).containsExactly(ends[1], within(1e-6));
    }

    /** A thick syrup. */
    private static final class Syrup implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, -1e5 * body.getVelocityX(), -1e5 * body.getVelocityY());
        }
    }

    /** The implicit method moves bodies in their own coordinates: the change is one of these, too. */
    @ParameterizedTest
    @CsvSource({"true, 0.1", "true, 1", "false, 0.1"})
    void aTreeThatTurnsOutStiffGoesItsWay(boolean isHeld, double step) {
        double[][] ends = new double[2][];
        for (int way = 0; way < 2; way++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setIntegrator(way == 0 ? new Automatic(1e-7) : new RadauIIA(1e-9));
            engine.setTimeStep(step);
            engine.add(new Gravity(0, -G));
            engine.add(new Syrup());
            Scenes.rods(engine, 3, 0);
            engine.bodies().get(1).setVelocity(0, 3);
            if (!isHeld) {
                engine.remove(engine.allConstraints().get(0));
            }
            while (engine.getTime() < 1.99) {
                engine.step();
            }
            ends[way] = engine.bodies().stream().flatMapToDouble(b -> DoubleStream.of(b.getX(), b.getY(), b.getAngle())).toArray();
        }
        assertThat(ends[0]).containsExactly(ends[1], within(1e-5));
    }

    /** In the middle of a step the tree becomes two. */
    @ParameterizedTest
    @CsvSource({"DOP853, 0.2", "GBS, 0.2", "Automatic, 0.002", "DOP853, 0.002", "RK4, 0.0005"})
    void whatAnImpactCutsGoesItsWay(String name, double step) {
        double[][] ends = new double[2][];
        for (int way = 0; way < 2; way++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setIntegrator(way == 0 ? method(name, 1e-11) : new DormandPrince853(1e-12));
            engine.setTimeStep(step);
            engine.add(new Gravity(0, -G));
            Scenes.rods(engine, 4, 2);
            Body peg = engine.add(Body.fixed(new Circle(0.2)).at(3.2, -0.6));
            peg.setCollisionGroup(2, 3);
            engine.addListener(new Cuts(engine, engine.allConstraints().get(2)));
            if (way == 1) {
                engine.add(new PinChainTest.Nothing());
            }
            while (engine.getTime() < 0.5999) {
                engine.step();
            }
            assertThat(engine.getImpacts()).isPositive();
            assertThat(engine.allConstraints()).hasSize(3);
            ends[way] = engine.bodies().stream().flatMapToDouble(b -> DoubleStream.of(b.getX(), b.getY(), b.getAngle())).toArray();
        }
        assertThat(ends[0]).containsExactly(ends[1], within(1e-7));
    }

    /** In the middle of strides and at their ends; forces of an author's make the states of stages those of the bodies. */
    @ParameterizedTest
    @CsvSource({
        "RK4, free, 0.002, true", "DOP853, free, 0.002, true", "DOP853, world, 0.03, false", "GBS, base, 0.002, true",
        "GBS, free, 0.2, false", "Automatic, world, 0.002, false", "Automatic, free, 0.05, true"
    })
    void aRestoredTreeGoesOnToTheBit(String name, String hold, double step, boolean isWindy) {
        Tree tree = new Tree(hold, true, isWindy);
        tree.engine.setIntegrator(method(name, 1e-7));
        tree.engine.setTimeStep(step);
        for (int k = 0; k < 12; k++) {
            PhysicsEngine restored = Checkpoint.copy(tree.engine);
            tree.run(3);
            restored.step();
            restored.step();
            restored.step();
            assertThat(Scenes.hash(restored)).as("at %s", tree.engine.getTime()).isEqualTo(Scenes.hash(tree.engine));
        }
    }

    /** Limbs that lie on the ground and on one another, thousands of impacts long: no energy comes from nowhere. */
    @ParameterizedTest
    @CsvSource("Automatic, 1e-5, 0, 4, 2.02")
    void ragdollsComeDownForGood(String name, double tolerance, double friction, int seed, double until) {
        SplittableRandom random = new SplittableRandom(seed);
        for (int k = 0; k < 5; k++) {
            random.nextInt(); // the scenes that once failed
        }
        PhysicsEngine engine = new PhysicsEngine();
        engine.setIntegrator(method(name, tolerance));
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -G));
        engine.add(Body.fixed(new Rectangle(100, 1)).at(0, -3));
        for (int doll = 0; doll < 2; doll++) {
            Body trunk = engine.add(new Body(new Rectangle(0.2, 0.6)).at(3 * doll, 0.5 * doll));
            for (int limb = 0; limb < 4; limb++) {
                double x = 3 * doll + (limb % 2 == 0 ? -0.1 : 0.1);
                double y = 0.5 * doll + (limb < 2 ? 0.3 : -0.3);
                double angle = 6.28 * random.nextDouble();
                Body last = trunk;
                for (int k = 0; k < 2; k++) {
                    double nextX = x + 0.4 * Math.cos(angle);
                    double nextY = y + 0.4 * Math.sin(angle);
                    Body part = engine.add(new Body(new Rectangle(0.4, 0.1)).at((x + nextX) / 2, (y + nextY) / 2, angle));
                    part.setCollisionGroup(2, 1);
                    engine.add(new PinJoint(last, part, x, y));
                    last = part;
                    x = nextX;
                    y = nextY;
                    angle += random.nextDouble() - 0.5;
                }
            }
        }
        for (Body body : engine.bodies()) {
            body.setRestitution(0);
            body.setFriction(friction);
        }
        double before = energy(engine);
        while (engine.getTime() < until) {
            engine.step();
            assertThat(energy(engine)).isLessThan(before + 1e-9);
        }
        for (Constraint pin : engine.allConstraints()) {
            assertThat(PinChainTest.gap((PinJoint) pin)).isLessThan(1e-14);
        }
    }

    private static double energy(PhysicsEngine engine) {
        double sum = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            sum += body.isFixed() ? 0 : G * body.getMass() * body.getY();
        }
        return sum;
    }

    /** Whoever moves them, they go the same way to the bit. */
    @Test
    void threadsDoNotMatter() {
        List<double[]> ends = new ArrayList<>();
        for (int threads = 1; threads <= 3; threads++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setThreads(threads);
            engine.setIntegrator(new DormandPrince853(1e-6));
            engine.setTimeStep(0.02);
            engine.add(new Gravity(0, -G));
            for (int k = 0; k < 40; k++) {
                Body one = engine.add(new Body(new Rectangle(1, 0.1)).at(3 * k, 0));
                Body other = engine.add(new Body(new Rectangle(1, 0.1)).at(3 * k + 1, 0));
                engine.add(new PinJoint(one, 3 * k - 0.5, 0));
                engine.add(new PinJoint(one, other, 3 * k + 0.5, 0));
            }
            for (int k = 0; k < 50; k++) {
                engine.step();
            }
            ends.add(engine.bodies().stream().flatMapToDouble(b -> DoubleStream.of(b.getX(), b.getY(), b.getAngle())).toArray());
        }
        assertThat(ends.get(1)).isEqualTo(ends.get(0));
        assertThat(ends.get(2)).isEqualTo(ends.get(0));
    }
}
