// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.StepReport;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** What a surface that moves along its body's boundary does by Coulomb's law: conveyor belts, in closed form. */
class BeltTest {
    private static final double G = 10;
    private static final double MU = 0.25;
    private static final double SPEED = 2;
    private static final double STEP = 1.0 / 60;

    private final PhysicsEngine engine = new PhysicsEngine();

    /** Begins a world of events, or of substeps; how exact it is where something slides. */
    private double begin(int substeps, double slope) {
        engine.setTimeStep(STEP);
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(-G * StrictMath.sin(slope), -G * StrictMath.cos(slope)));
        return substeps == 0 ? 1e-6 : 0.008; // a substep's way at the speed of the belt
    }

    private Body rough(Body body) {
        body.setFriction(MU);
        body.setRestitution(0);
        return engine.add(body);
    }

    /** A belt whose upper side goes to the right. */
    private Body belt(double speed) {
        Body belt = rough(Body.fixed(new Rectangle(100, 1)).at(0, -0.5));
        belt.setBeltSpeed(-speed);
        return belt;
    }

    private Body put(Shape shape, double x, double y) {
        return rough(new Body(shape).at(x, y));
    }

    private void run(double time) {
        for (int k = 0; k < Math.round(time / STEP); k++) {
            engine.step();
        }
    }

    /** Place and velocity after a time from rest, with an acceleration up to a speed that is kept then. */
    private static void isAt(Body body, double time, double acceleration, double speed, double error) {
        double until = Math.min(time, speed / acceleration);
        double x = 0.5 * acceleration * until * until + speed * (time - until);
        assertThat(body.getX()).isCloseTo(x, within(error));
        assertThat(body.getVelocityX()).isCloseTo(acceleration * until, within(error));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aBoxIsAcceleratedUpToTheSpeedOfTheBelt(int substeps) {
        double error = begin(substeps, 0);
        belt(SPEED);
        Body box = put(new Rectangle(1, 1), 0, 0.5);
        for (int k = 1; k <= 4; k++) {
            run(0.5);
            isAt(box, 0.5 * k, MU * G, SPEED, substeps == 0 ? 1e-13 : error);
        }
        assertThat(box.getVelocityX()).isCloseTo(SPEED, within(1e-12)); // it does not creep
    }

    /** A row of them, and one that carries another; welded ones; a heap of more than thirty. */
    @ParameterizedTest
    @CsvSource({"0, STACK", "4, STACK", "0, WELDED", "4, WELDED", "0, LARGE", "4, LARGE"})
    void soAreBodiesThatLieOnOneAnother(int substeps, String how) {
        double error = begin(substeps, 0);
        belt(SPEED);
        Body below = put(new Rectangle(1, 1), 0, 0.5);
        Body above = put(new Rectangle(0.8, 0.8), 0, 1.4);
        if (how.equals("WELDED")) {
            engine.add(new WeldJoint(below, above, 0, 1));
        }
        for (int k = 0; how.equals("LARGE") && k < 32; k++) {
            put(new Rectangle(0.5, 0.5), -20 + 0.5 * k, 0.25); // side by side: one heap
        }
        run(0.5);
        isAt(below, 0.5, MU * G, SPEED, error);
        run(1.5);
        isAt(below, 2, MU * G, SPEED, error);
        assertThat(above.getX()).isCloseTo(below.getX(), within(error));
        for (Body body : engine.bodies()) {
            assertThat(body.getVelocityX()).isCloseTo(body.isFixed() ? 0 : SPEED, within(error));
        }
    }

    /** It rolls when the belt has given it a third of its speed: the rim is as fast as the belt then. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aDiscRollsOnABelt(int substeps) {
        begin(substeps, 0);
        belt(SPEED);
        Body disc = put(new Circle(0.5), 0, 0.5);
        run(2);
        isAt(disc, 2, MU * G, SPEED / 3, 1e-12);
        assertThat(disc.getAngularVelocity()).isCloseTo(SPEED * 2 / 3 / 0.5, within(1e-12));
    }

    @ParameterizedTest
    @CsvSource({"0, 0.2", "4, 0.2", "0, 0.3", "4, 0.3"})
    void aBeltClimbsIfItsFrictionIsEnough(int substeps, double slope) {
        double error = begin(substeps, slope);
        belt(SPEED);
        Body box = put(new Rectangle(1, 1), 0, 0.5);
        run(2);
        double acceleration = G * (MU * StrictMath.cos(slope) - StrictMath.sin(slope)); // to either side
        assertThat(box.getVelocityX()).isCloseTo(2 * acceleration, within(error));
        assertThat(box.getX()).isCloseTo(2 * acceleration, within(error));
        run(4);
        assertThat(box.getVelocityX()).isCloseTo(Math.min(SPEED, 6 * acceleration), within(error));
    }

    /** Below it one belt, above it a plate with a slower one, which smooth walls hold: friction of both, then of one less the other. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aBoxBetweenTwoBelts(int substeps) {
        double error = begin(substeps, 0);
        belt(SPEED);
        Body box = put(new Rectangle(2, 1), 0, 0.5);
        Body plate = put(new Rectangle(40, 0.1), 0, 1.05); // its weight presses, and it hardly tips
        plate.setMass(box.getMass(), 1e6);
        plate.setBeltSpeed(0.5 * SPEED); // its lower side to the right
        engine.add(Body.fixed(new Rectangle(1, 0.02)).at(20.5, 1.09));
        engine.add(Body.fixed(new Rectangle(1, 0.02)).at(-20.5, 1.09));
        double both = 3 * MU * G; // of twice the weight below, and of once above
        double time = 0.5 * SPEED / both;
        double way = 0.5 * both * time * time;
        run(1);
        double left = Math.min(1 - time, 0.5 * SPEED / (MU * G));
        double x = way + 0.5 * SPEED * left + 0.5 * MU * G * left * left + SPEED * (1 - time - left);
        assertThat(box.getX()).isCloseTo(x, within(substeps == 0 ? 2e-3 : error)); // where slip ends is of first order
        assertThat(box.getVelocityX()).isCloseTo(SPEED, within(1e-3)); // the plate tips a little
        assertThat(plate.getX()).isCloseTo(0, within(1e-3));
    }

    /** A sledge on ice with a belt, and a box on it: momentum stays zero, and in the end the two part at the speed of the belt. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aBeltThatCanMoveIsPushedBack(int substeps) {
        begin(substeps, 0);
        engine.add(Body.fixed(new Rectangle(100, 1)).at(0, -0.5)).setRestitution(0);
        Body sledge = put(new Rectangle(20, 1), 0, 0.5);
        sledge.setBeltSpeed(-SPEED);
        Body box = put(new Rectangle(1, 2), 0, 2);
        for (int k = 0; k < 120; k++) {
            engine.step();
            double momentum = sledge.getMass() * sledge.getVelocityX() + box.getMass() * box.getVelocityX();
            assertThat(momentum).isCloseTo(0, within(1e-12));
        }
        double error = substeps == 0 ? 1e-7 : 1e-3;
        assertThat(box.getVelocityX() - sledge.getVelocityX()).isCloseTo(SPEED, within(error));
        assertThat(box.getVelocityX()).isCloseTo(SPEED * 20 / 22, within(error));
    }

    /** A disc that falls on a belt gets the impulse of the cone of friction, sideways and as a spin. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void aDiscThatBouncesOffABelt(double restitution) {
        engine.setTimeStep(STEP);
        Body belt = belt(100); // so that it slips throughout
        Body disc = put(new Circle(0.5), 0, 0.6).moving(0, -3);
        belt.setRestitution(1);
        disc.setRestitution(restitution);
        run(0.1);
        assertThat(disc.getVelocityY()).isCloseTo(3 * restitution, within(1e-14));
        assertThat(disc.getVelocityX()).isCloseTo(MU * 3 * (1 + restitution), within(1e-14));
        assertThat(disc.getAngularVelocity()).isCloseTo(2 / 0.5 * MU * 3 * (1 + restitution), within(1e-13));
    }

    /** What sticks to a belt goes with it at once. */
    @Test
    void whatSticksToABelt() {
        engine.setTimeStep(STEP);
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public Decision colliding(Contact contact) {
                return Decision.STICK;
            }
        });
        belt(SPEED);
        Body box = put(new Rectangle(1, 1), 0, 0.6).moving(0, -3);
        run(0.1);
        assertThat(box.getVelocityX()).isCloseTo(SPEED, within(1e-12));
        assertThat(box.getVelocityY()).isCloseTo(0, within(1e-12));
    }

    /**
     * Bodies on a belt, and the same that come with the opposite velocity upon a ground that stands: one motion, seen by two
     * observers. Machines and what is struck, too, with substeps, where books of energy are kept of tied bodies.
     */
    @ParameterizedTest
    @CsvSource({"0, CHAIN, 1e-4", "4, CHAIN, 1e-9", "0, BOUNCES, 1e-9", "4, BOUNCES, 1e-9", "0, DROPS, 1e-9", "4, DROPS, 1e-9",
        "0, DRIVEN, 1e-6", "4, DRIVEN, 1e-9", "0, PILE, 0.05", "4, PILE, 0.05"})
    void aBeltIsAGroundThatIsSeenFromElsewhere(int substeps, String what, double error) {
        PhysicsEngine still = scene(what, substeps, -1.5, 0);
        PhysicsEngine moving = scene(what, substeps, 0, 1.5);
        for (int k = 1; k <= (what.equals("PILE") ? 30 : 60); k++) { // which no two runs of a pile agree upon for long
            still.step();
            moving.step();
            for (int m = 1; m < still.bodies().size(); m++) {
                Body a = still.bodies().get(m);
                Body b = moving.bodies().get(m);
                assertThat(b.getX()).isCloseTo(a.getX() + 1.5 * k * STEP, within(error));
                assertThat(b.getY()).isCloseTo(a.getY(), within(error));
                assertThat(b.getAngle()).isCloseTo(a.getAngle(), within(error));
            }
        }
    }

    private static PhysicsEngine scene(String what, int substeps, double speed, double belt) {
        BeltTest scene = new BeltTest();
        scene.begin(substeps, 0);
        scene.belt(belt).setRestitution(1);
        Body last = null;
        if (what.equals("DRIVEN")) {
            scene.engine.add((ForceGenerator) (body, time, forces) -> forces.add(body, 0.3 * body.getMass() * StrictMath.sin(3 * time), 0));
            scene.put(new Rectangle(1, 0.5), 0, 0.25).moving(speed, 0);
            scene.put(new Rectangle(0.6, 0.5), 0, 0.75).moving(speed, 0);
        }
        for (int k = 0; k < 12 && what.equals("PILE"); k++) {
            Shape shape = k % 3 == 0 ? new Circle(0.3) : new Rectangle(0.5, 0.4 + 0.02 * k);
            scene.put(shape, k % 4, 0.5 + k / 4).moving(speed, 0).setAngle(0.1 * k);
        }
        int count = scene.engine.bodies().size() > 1 ? 0 : 4;
        for (int k = 0; k < count; k++) {
            boolean isChain = what.equals("CHAIN");
            Body body = scene.put(k % 2 == 0 && !isChain ? new Circle(0.4) : new Rectangle(0.8, 0.2), isChain ? 0.8 * k : 2 * k, 0.7);
            body.setRestitution(what.equals("BOUNCES") && k % 2 == 0 ? 0.6 : 0);
            body.moving(speed, 0);
            if (isChain && k > 0) {
                scene.engine.add(new PinJoint(last, body, 0.8 * k - 0.4, 0.7));
            }
            last = body;
        }
        return scene.engine;
    }

    /** Started and turned round while boxes stand on it, one of them asleep; a copy of a checkpoint, with more threads, does the same. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aBeltIsStartedAndStopped(int substeps) {
        double error = begin(substeps, 0);
        Body belt = belt(0);
        Body box = put(new Rectangle(1, 1), 0, 0.5);
        put(new Rectangle(1, 1), 5, 0.5);
        put(new Rectangle(0.8, 0.8), 5, 1.4);
        run(3);
        assertThat(engine.isAsleep(box)).isEqualTo(substeps > 0);
        double x = box.getX();
        belt.setBeltSpeed(-SPEED);
        PhysicsEngine copy = Checkpoint.copy(engine);
        copy.setThreads(3);
        run(2);
        for (int k = 0; k < 120; k++) {
            copy.step();
        }
        Checkpoint.assertSameBodies(engine, copy);
        assertThat(belt.getBeltSpeed()).isEqualTo(-SPEED);
        assertThat(copy.bodies().get(0).getBeltSpeed()).isEqualTo(-SPEED);
        assertThat(box.getX() - x).isCloseTo(2 * SPEED - SPEED * SPEED / (2 * MU * G), within(error));
        belt.setBeltSpeed(0);
        run(3);
        assertThat(box.getVelocityX()).isEqualTo(0);
        assertThat(box.getX() - x).isCloseTo(2 * SPEED, within(2 * error));
    }

    /** So slow a belt takes a box along that would be asleep. */
    @Test
    void aSlowBeltDoesNotFallAsleep() {
        begin(4, 0);
        belt(1e-4);
        Body box = put(new Rectangle(1, 1), 0, 0.5);
        run(1);
        double x = box.getX();
        run(9);
        assertThat(box.getX() - x).isCloseTo(9e-4, within(1e-9));
        assertThat(engine.isAsleep(box)).isFalse();
    }

    /** A wall holds a box on the belt that runs below it: the belt pushes by its friction, and works on nothing. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aBoxThatIsHeldBears(int substeps) {
        begin(substeps, 0);
        belt(SPEED);
        Body box = put(new Rectangle(1, 1), 0, 0.5);
        Body wall = engine.add(Body.fixed(new Rectangle(1, 4)).at(1, 2.1));
        run(1);
        double push = engine.contacts(box).stream()
                .filter(c -> c.a() == wall || c.b() == wall)
                .mapToDouble(c -> c.forceX(box))
                .sum();
        assertThat(push).isCloseTo(-MU * G, within(substeps == 0 ? 1e-8 : 1e-4));
        assertThat(box.getX()).isCloseTo(0, within(1e-3));
    }

    /** What the belt gives is in the books: they close, and all energy that a box alone has got is work. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theBooksClose(boolean isStack) {
        begin(0, 0);
        belt(SPEED);
        Body box = put(new Rectangle(1, 1), 0, 0.5);
        if (isStack) {
            put(new Rectangle(0.8, 0.8), 0, 1.4);
        }
        engine.setAudited(true);
        run(2);
        StepReport books = engine.getRunReport();
        assertThat(books.drift()).isCloseTo(0, within(1e-12));
        assertThat(books.work() + books.impacts()).isCloseTo(0.5 * SPEED * SPEED * (isStack ? 1.64 : 1), within(1e-6));
        if (!isStack) {
            assertThat(books.work()).isCloseTo(box.kineticEnergy(), within(1e-6));
        }
    }

    /** A bar in a corner of belts that hold it faster than they let it go: no forces let it go on as they do, and none throw it out. */
    @ParameterizedTest
    @CsvSource({"0, 0, -2, -2, 0.3", "0, 0, -2, -2, -1.5665", "0, -1.6, 0, 0, 0.3", "0, -1.6, 0, -2, -1.5665", "0, -1.6, -2, -2, 0.3",
        "1, -1.6, 2, -2, 2.5", "4, -2, 2, -1.6, 2.5", "8, -1.6, 2, -2, 2.5", "4, 0, -2, -2, 0.3", "4, -1.6, 0, -2, -1.5665"})
    void whatBeltsWedgeIsNotThrownAbout(int substeps, double own, double wall, double floor, double angle) {
        for (int k = 0; k < 25; k++) {
            wedge(substeps, new Body(new Rectangle(0.75, 0.3)).at(7.3 - 0.0008 * k, -7.1, angle), own, wall, floor);
        }
    }

    /** A disc, too, which would be pressed right through the walls, and spun there at any rate. */
    @ParameterizedTest
    @CsvSource({"1, -2, 2, -2", "4, -2, 2, -2", "8, -2, 2, -2", "4, -1.6, 0, -2", "4, -2, 0.5, -2"})
    void norIsADisc(int substeps, double own, double wall, double floor) {
        wedge(substeps, new Body(new Circle(0.3)).at(7.1, -7.1), own, wall, floor);
    }

    private static void wedge(int substeps, Body body, double own, double wall, double floor) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 64);
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(0, -G));
        Body[] bodies = {Body.fixed(new Rectangle(30, 1)).at(0, -8), Body.fixed(new Rectangle(1, 30)).at(8, 0), body};
        double[] speeds = {floor, wall, own};
        for (int k = 0; k < bodies.length; k++) {
            bodies[k].setRestitution(0);
            bodies[k].setFriction(1.5);
            bodies[k].setBeltSpeed(speeds[k]);
            engine.add(bodies[k]);
        }
        for (int k = 0; k < 200; k++) {
            engine.step();
            double speed = Math.hypot(body.getVelocityX(), body.getVelocityY());
            assertThat(speed + 0.4 * Math.abs(body.getAngularVelocity())).isLessThan(12);
            assertThat(Math.max(body.getX() - 7.5, -7.5 - body.getY())).isLessThan(0); // its centre is in no wall
        }
    }

    @Test
    void aSpeedThatIsNoneIsRefused() {
        Body body = new Body(new Circle(1));
        assertThat(body.getBeltSpeed()).isEqualTo(0);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> body.setBeltSpeed(Double.NaN))
                .withMessage("belt speed is NaN: it must be finite");
        body.setBeltSpeed(3);
        body.setFriction(0.5);
        body.setRestitution(0.5);
        engine.add(body);
        assertThat(body.getBeltSpeed()).isEqualTo(3);
    }
}
