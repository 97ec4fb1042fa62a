// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.collision.broad.BroadPhase;
import sim.physics.collision.broad.BruteForce;
import sim.physics.collision.broad.CellGrid;
import sim.physics.collision.broad.SortAndSweep;
import sim.physics.collision.narrow.Distance;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Gravity;
import sim.physics.motion.SurfaceFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Bodies of several convex parts: laws that hold for any body, and what a body does that is cut is what the whole one does. */
class CompoundTest {
    private static Compound ell() {
        return new Compound(Compound.box(0, 0, 1, 0.3), Compound.box(-0.35, 0.65, 0.3, 1));
    }

    /** A disc with two arms; its centroid is ahead of the disc's centre. */
    private static Compound robot() {
        return new Compound(Compound.disc(0, 0, 0.6), Compound.box(0.9, 0.35, 0.8, 0.15), Compound.box(0.9, -0.35, 0.8, 0.15));
    }

    private static Compound cup() {
        return new Compound(Compound.box(0, 0, 3, 0.5), Compound.box(-1.25, 0.75, 0.5, 1), Compound.box(1.25, 0.75, 0.5, 1));
    }

    /** A rectangle, whole or cut into some parts across. */
    private static Shape bar(double width, double height, int parts) {
        if (parts == 1) {
            return new Rectangle(width, height);
        }
        double[][] cut = new double[parts][];
        for (int k = 0; k < parts; k++) {
            cut[k] = Compound.box(width * ((k + 0.5) / parts - 0.5), 0, width / parts, height);
        }
        return new Compound(cut);
    }

    /** One measure for many shapes, which come and go in its table. */
    @Test
    void oneConvexPartIsAPolygon() {
        Distance distance = new Distance();
        SplittableRandom random = new SplittableRandom(8);
        for (int k = 0; k < 300; k++) {
            double[] xy = new double[6 + 2 * random.nextInt(5)];
            for (int m = 0; m < xy.length; m += 2) {
                double angle = 2 * Math.PI * (m + random.nextDouble()) / xy.length;
                xy[m] = 2 * Math.cos(angle);
                xy[m + 1] = Math.sin(angle);
            }
            Compound compound = Compound.outline(xy);
            assertThat(compound.partCount()).isEqualTo(1);
            Body other = new Body(k % 2 == 0 ? cup() : new Circle(0.3)).at(4, random.nextDouble(), random.nextDouble());
            double gap = distance.between(new Body(compound), other);
            assertThat(gap).isEqualTo(distance.between(new Body(new Polygon(xy)), other), within(1e-13));
            assertThat(distance.between(other, new Body(compound))).isEqualTo(gap, within(1e-13));
        }
    }

    private static void addWalls(PhysicsEngine engine, double half) {
        for (int side = -1; side <= 1; side += 2) {
            engine.add(Body.fixed(new Rectangle(2 * half + 4, 2)).at(0, side * (half + 1)));
            engine.add(Body.fixed(new Rectangle(2, 2 * half + 4)).at(side * (half + 1), 0));
        }
    }

    private static PhysicsEngine gas(long seed) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 30.0);
        SplittableRandom random = new SplittableRandom(seed);
        addWalls(engine, 9);
        for (int k = 0; k < 16; k++) {
            Shape shape = k % 4 == 0 ? cup() : k % 4 == 1 ? ell() : k % 4 == 2 ? robot() : new Circle(0.4);
            Body body = engine.add(new Body(shape).at(-7 + 4 * (k % 4), -7 + 4 * (k / 4)));
            body.moving(2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1);
        }
        return engine;
    }

    @ParameterizedTest
    @CsvSource({"1, 0", "2, 0", "3, 1"})
    void aGasKeepsItsEnergyAndNothingSinksIn(long seed, double gravity) {
        PhysicsEngine engine = gas(seed);
        if (gravity > 0) {
            engine.add(new Gravity(0, -gravity));
        }
        double energy = energy(engine, gravity);
        double scale = engine.kineticEnergy() + 18 * gravity * 16;
        for (int k = 0; k < 3000; k++) {
            engine.step();
            if (k % 30 == 0) {
                assertThat(engine.overlaps()).isEmpty();
            }
        }
        assertThat(energy(engine, gravity)).isEqualTo(energy, within(1e-12 * scale));
        assertThat(engine.getImpacts()).isGreaterThan(200);
        for (Body body : engine.bodies()) {
            assertThat(Math.max(Math.abs(body.getX()), Math.abs(body.getY()))).isLessThan(10.5);
        }
    }

    private static double energy(PhysicsEngine engine, double gravity) {
        double sum = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            sum += body.isFixed() ? 0 : body.getMass() * gravity * body.getY();
        }
        return sum;
    }

    /** Seams are not felt: bars that are cut fly, bounce, slide and lie as whole ones, to rounding times what impacts make of it. */
    @ParameterizedTest
    @CsvSource({"2, 0, 0, 1e-9", "3, 0, 0, 1e-9", "2, 5, 0.3, 1e-6", "3, 5, 0.3, 1e-6"})
    void aBodyThatIsCutMovesAsTheWhole(int parts, double gravity, double friction, double error) {
        List<PhysicsEngine> engines = new ArrayList<>();
        for (int cut : new int[] {1, parts}) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1 / 60.0);
            engine.add(new Gravity(0, -gravity));
            addWalls(engine, 5);
            SplittableRandom random = new SplittableRandom(5);
            for (int k = 0; k < 6; k++) {
                Body body = engine.add(new Body(bar(1.6, 0.4, cut)).at(-3 + 3 * (k % 3), -2 + 3 * (k / 3), random.nextDouble()));
                body.moving(2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1, random.nextDouble());
            }
            for (Body body : engine.bodies()) {
                body.setFriction(friction);
                body.setRestitution(gravity > 0 ? 0.5 : 1);
            }
            engines.add(engine);
        }
        for (int k = 0; k < (gravity > 0 ? 50 : 400); k++) {
            engines.forEach(PhysicsEngine::step);
        }
        for (int k = 0; k < engines.get(0).bodies().size(); k++) {
            Body whole = engines.get(0).bodies().get(k);
            Body cut = engines.get(1).bodies().get(k);
            assertThat(cut.getX()).as("%s", whole).isEqualTo(whole.getX(), within(error));
            assertThat(cut.getY()).as("%s", whole).isEqualTo(whole.getY(), within(error));
            assertThat(cut.getAngle()).as("%s", whole).isEqualTo(whole.getAngle(), within(error));
        }
    }

    /** A box that slides over a long bar of many parts, and that bar over the ground. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 7})
    void whatSlidesOverSeamsFeelsNone(int parts) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -9.81));
        Body ground = engine.add(Body.fixed(new Rectangle(100, 2)).at(0, -1));
        Body bar = engine.add(new Body(bar(14, 0.5, parts)).at(0, 0.25));
        Body box = engine.add(new Body(new Rectangle(0.6, 0.6)).at(-5.03, 0.8));
        for (Body body : List.of(ground, bar, box)) {
            body.setFriction(body == bar ? 0.1 : 0.4);
            body.setRestitution(0);
        }
        box.setVelocity(4, 0);
        double mu = Math.sqrt(0.04); // between any two of them
        double t = 1;
        for (int k = 0; k < 60; k++) {
            engine.step();
        }
        assertThat(bar.getX()).isEqualTo(0, within(1e-9)); // the ground holds it: it presses with more than the box
        assertThat(box.getX()).isEqualTo(-5.03 + 4 * t - 0.5 * mu * 9.81 * t * t, within(1e-6));
        assertThat(box.getY()).isEqualTo(0.8, within(1e-7));
        assertThat(box.getAngle()).isEqualTo(0, within(1e-7));
    }

    /** In the air and where they bounce, welded boxes and a body of two parts are the same. */
    @Test
    void itMovesAsBodiesThatAreWelded() {
        PhysicsEngine welded = new PhysicsEngine();
        PhysicsEngine whole = new PhysicsEngine();
        Compound shape = ell();
        for (PhysicsEngine engine : List.of(welded, whole)) {
            engine.setTimeStep(1 / 100.0);
            addWalls(engine, 3);
        }
        Body one = welded.add(new Body(new Rectangle(1, 0.3)).at(0, 0));
        Body two = welded.add(new Body(new Rectangle(0.3, 1)).at(-0.35, 0.65));
        Body all = whole.add(new Body(shape).at(shape.centroidX(), shape.centroidY()).moving(1, 0.7, 2));
        for (Body part : List.of(one, two)) {
            part.moving(1 - 2 * (part.getY() - all.getY()), 0.7 + 2 * (part.getX() - all.getX()), 2);
        }
        welded.add(new WeldJoint(one, two, -0.35, 0.15));
        for (int k = 0; k < 1500; k++) {
            welded.step();
            whole.step();
        }
        assertThat(whole.getImpacts()).isGreaterThan(3);
        assertThat(one.getX()).isEqualTo(all.worldX(-shape.centroidX(), -shape.centroidY()), within(1e-7));
        assertThat(one.getY()).isEqualTo(all.worldY(-shape.centroidX(), -shape.centroidY()), within(1e-7));
    }

    /** A ball in a closed box that is one body: 2 m of free way at 1 m/s, so it bounces every 2 s, and momentum is kept. */
    @Test
    void aBallStaysInAHollowBody() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.1);
        Body box = engine.add(new Body(new Compound(
                Compound.box(0, 1.25, 3, 0.5), Compound.box(0, -1.25, 3, 0.5), Compound.box(-1.75, 0, 0.5, 3), Compound.box(1.75, 0, 0.5, 3))));
        Body ball = engine.add(new Body(new Circle(0.5)).at(0, 0).moving(1, 0));
        double m = ball.getMass();
        double M = box.getMass();
        for (int k = 0; k < 1000; k++) {
            engine.step();
            assertThat(Math.abs(ball.getX() - box.getX())).isLessThan(1 + 1e-9);
            assertThat(ball.getVelocityX() - box.getVelocityX()).satisfies(v -> assertThat(Math.abs(v)).isEqualTo(1, within(1e-12)));
            assertThat(m * ball.getVelocityX() + M * box.getVelocityX()).isEqualTo(m, within(1e-12));
        }
        assertThat(engine.getImpacts()).isEqualTo(50); // at 1, 3, 5 … 99 s
        assertThat(box.getAngle()).isEqualTo(0, within(1e-12));
    }

    /** A dumbbell of two discs that spins meets a wall with one of them when that is as far from it as its radius. */
    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.1, 5})
    void theInstantOfADiscThatGoesRoundIsExact(double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.add(Body.fixed(new Rectangle(2, 20)).at(4, 0));
        Body bell = engine.add(new Body(new Compound(Compound.disc(-1, 0, 0.25), Compound.disc(1, 0, 0.25))).moving(1, 0, 3));
        double at = 1.5; // x(t) + |cos 3t| + 0.25 = 3, after that; by Newton's method from where it is the first time
        for (double t = 0; t < 3; t += 1e-4) {
            if (t + Math.abs(Math.cos(3 * t)) + 0.25 >= 3) {
                at = t;
                break;
            }
        }
        for (int k = 0; k < 20; k++) {
            double f = at + Math.abs(Math.cos(3 * at)) - 2.75;
            at -= f / (1 - 3 * Math.sin(3 * at) * Math.signum(Math.cos(3 * at)));
        }
        double[] told = {Double.NaN};
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public void collided(Contact contact) {
                told[0] = Double.isNaN(told[0]) ? contact.time() : told[0];
            }
        });
        double energy = engine.kineticEnergy();
        while (Double.isNaN(told[0]) && engine.getTime() < 5) {
            engine.step();
        }
        assertThat(told[0]).isEqualTo(at, within(1e-12));
        assertThat(engine.kineticEnergy()).isEqualTo(energy, within(1e-13));
    }

    /** A body with two round feet rests on them, and rocks on neither. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void roundFeetBear(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(0, -9.81));
        engine.add(Body.fixed(new Rectangle(20, 1)).at(0, -0.5));
        Compound shape = new Compound(Compound.box(0, 0.6, 3, 0.4), Compound.disc(-1, 0.2, 0.2), Compound.disc(1, 0.2, 0.2));
        Body cart = engine.add(new Body(shape).at(0, shape.centroidY() + 0.3));
        for (Body body : engine.bodies()) {
            body.setFriction(0.5);
            body.setRestitution(0.2);
        }
        for (int k = 0; k < 300; k++) {
            engine.step();
        }
        double load = 0;
        for (LastingContact contact : engine.contacts(cart)) {
            load += contact.forceY(cart);
            assertThat(Math.abs(contact.x() - cart.getX())).isEqualTo(1, within(1e-3));
        }
        assertThat(load).isEqualTo(cart.getMass() * 9.81, within(1e-2));
        assertThat(engine.contacts(cart)).hasSize(2);
        assertThat(cart.getY()).isEqualTo(shape.centroidY(), within(substeps == 0 ? 1e-7 : 1e-3));
        assertThat(cart.getAngle()).isEqualTo(0, within(substeps == 0 ? 1e-7 : 1e-3));
        assertThat(cart.kineticEnergy()).isLessThan(1e-8);
    }

    /** A corner hits the inner side of a cup's wall at the time that its speed says. */
    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.3, 10})
    void theInstantInACavityIsExact(double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        Compound shape = cup();
        engine.add(Body.fixed(shape).at(shape.centroidX(), shape.centroidY()));
        Body square = engine.add(new Body(new Rectangle(0.4, 0.4)).at(0, 1, Math.PI / 4).moving(2, 0));
        double room = 1 - 0.2 * Math.sqrt(2); // from the middle to where the corner touches
        for (int k = 0; k < Math.ceil(0.6 / step); k++) {
            engine.step();
        }
        if (step < 1) {
            assertThat(square.getX()).isEqualTo(2 * room - 2 * engine.getTime(), within(1e-12)); // it has bounced once
        }
        assertThat(Math.abs(square.getX())).isLessThanOrEqualTo(room + 1e-12);
        assertThat(Math.abs(square.getVelocityX())).isEqualTo(2, within(1e-13));
        assertThat(square.getY()).isEqualTo(1, within(1e-12));
        assertThat(engine.getImpacts()).isEqualTo(step < 1 ? 1 : (int) ((20 - room) / (2 * room)) + 1);
    }

    /** A table comes down on both feet at once: it does not turn, on the ground and on a body that can move. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void bothFeetStrikeAtOnce(boolean isMovable) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.07);
        Compound shape = new Compound(Compound.box(0, 1.1, 3, 0.2), Compound.box(-1.2, 0.5, 0.2, 1), Compound.box(1.2, 0.5, 0.2, 1));
        Body table = engine.add(new Body(shape).at(0, 3 + shape.centroidY()).moving(0, -1));
        Body floor = isMovable ? new Body(new Rectangle(6, 1)) : Body.fixed(new Rectangle(6, 1));
        engine.add(floor.at(0, -0.5));
        double energy = engine.kineticEnergy();
        for (int k = 0; k < 60; k++) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isBetween(1L, 2L);
        assertThat(engine.kineticEnergy()).isEqualTo(energy, within(1e-14));
        assertThat(table.getAngularVelocity()).isEqualTo(0, within(1e-13));
        assertThat(floor.getAngularVelocity()).isEqualTo(0, within(1e-13));
        assertThat(table.getVelocityY() - floor.getVelocityY()).isEqualTo(1, within(1e-13));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aTableBearsWhatStandsOnIt(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(0, -9.81));
        Body floor = engine.add(Body.fixed(new Rectangle(20, 1)).at(0, -0.5));
        Compound shape = new Compound(Compound.box(0, 1.1, 3, 0.2), Compound.box(-1.2, 0.5, 0.2, 1), Compound.box(1.2, 0.5, 0.2, 1));
        Body table = engine.add(new Body(shape).at(0, shape.centroidY()));
        Body box = engine.add(new Body(new Rectangle(0.5, 0.5)).at(0.6, 1.45));
        for (Body body : engine.bodies()) {
            body.setFriction(0.5);
            body.setRestitution(0);
        }
        for (int k = 0; k < 200; k++) {
            engine.step();
        }
        double g = 9.81;
        double left = 0;
        double right = 0;
        for (LastingContact contact : engine.contacts(floor)) {
            double force = Math.abs(contact.forceY(table));
            left += contact.x() < 0 ? force : 0;
            right += contact.x() < 0 ? 0 : force;
        }
        double error = substeps == 0 ? 1e-6 : 1e-2;
        assertThat(left + right).isEqualTo((table.getMass() + box.getMass()) * g, within(error * 10));
        assertThat(right).isGreaterThan(left); // of what a body bears at four corners shares are not unique, but torque is
        assertThat(box.getY()).isEqualTo(1.45, within(substeps == 0 ? 1e-7 : 2e-3));
        assertThat(engine.contacts(floor)).hasSize(2); // one for each leg
    }

    /** Heaps of hooked bodies come to rest, and are not in one another: by events to a thousandth of their size while they move. */
    @ParameterizedTest
    @CsvSource({"20, 0, 1e-7, 3e-3", "40, 0, 6e-3, 6e-3", "40, 4, 3e-3, 0.05"})
    void heapsComeToRest(int count, int substeps, double atRest, double moving) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(0, -9.81));
        SplittableRandom random = new SplittableRandom(5);
        engine.add(Body.fixed(new Rectangle(12, 1)).at(0, -0.5)).setFriction(0.5);
        engine.add(Body.fixed(new Rectangle(1, 60)).at(-6, 30));
        engine.add(Body.fixed(new Rectangle(1, 60)).at(6, 30));
        for (int k = 0; k < count; k++) {
            Body body = engine.add(new Body(ell()).at(-4.4 + 1.6 * (k % 6) + 0.2 * random.nextDouble(), 1 + 1.6 * (k / 6)));
            body.setFriction(0.5);
            body.setRestitution(0);
        }
        double deepest = 0;
        for (int k = 0; k < 900; k++) {
            engine.step();
            deepest = Math.max(deepest, engine.overlaps().isEmpty() ? 0 : engine.overlaps().get(0).depth());
        }
        double fastest = 0;
        for (Body body : engine.bodies()) {
            fastest = Math.max(fastest, Math.abs(body.getVelocityX()) + Math.abs(body.getVelocityY()));
        }
        assertThat(deepest).isLessThan(moving);
        assertThat(engine.overlaps().isEmpty() ? 0 : engine.overlaps().get(0).depth()).isLessThan(atRest);
        assertThat(fastest).isLessThan(1e-6);
    }

    @Test
    void allBroadPhasesAndThreadsGiveTheSame() {
        List<PhysicsEngine> engines = new ArrayList<>();
        for (BroadPhase broad : new BroadPhase[] {new BruteForce(), new SortAndSweep(), new CellGrid()}) {
            PhysicsEngine engine = gas(7);
            engine.setBroadPhase(broad);
            engines.add(engine);
        }
        PhysicsEngine shared = gas(7);
        shared.setThreads(2);
        engines.add(shared);
        for (int k = 0; k < 300; k++) {
            engines.forEach(PhysicsEngine::step);
        }
        for (PhysicsEngine engine : engines) {
            assertThat(engine.getImpacts()).isEqualTo(engines.get(0).getImpacts());
            for (int k = 0; k < engine.bodies().size(); k++) {
                assertThat(engine.bodies().get(k).getX()).isEqualTo(engines.get(0).bodies().get(k).getX(), within(1e-9));
            }
        }
        Checkpoint.assertSameBodies(engines.get(0), shared);
    }

    @Test
    void aCheckpointGoesOnBitForBit() {
        for (int substeps : new int[] {0, 4}) {
            PhysicsEngine engine = gas(3);
            engine.add(new Gravity(0, -1));
            engine.setTimeStepping(substeps);
            for (int k = 0; k < 100; k++) {
                engine.step();
            }
            PhysicsEngine copy = Checkpoint.copy(engine);
            for (int k = 0; k < 200; k++) {
                engine.step();
                copy.step();
            }
            Checkpoint.assertSameBodies(engine, copy);
        }
    }

    /** Bodies of one and of several parts take one another's numbers, at any time, also where a listener removes them. */
    @Test
    void bodiesComeAndGo() {
        PhysicsEngine engine = gas(11);
        SplittableRandom random = new SplittableRandom(1);
        List<Body> doomed = new ArrayList<>();
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public void collided(Contact contact) {
                if (!contact.a().isFixed() && random.nextInt(30) == 0 && engine.contains(contact.a())) {
                    engine.remove(contact.a());
                    doomed.add(contact.a());
                }
            }
        });
        for (int k = 0; k < 1500; k++) {
            if (k % 10 == 0 && engine.bodies().size() < 25) {
                double x = 16 * random.nextDouble() - 8;
                double y = 16 * random.nextDouble() - 8;
                if (engine.queries().within(x, y, 2, null).isEmpty()) {
                    Shape shape = random.nextBoolean() ? cup() : random.nextBoolean() ? robot() : new Rectangle(1, 0.5);
                    engine.add(new Body(shape).at(x, y).moving(random.nextDouble(), random.nextDouble(), 1));
                }
            }
            if (k % 97 == 0) {
                engine.bodies().get(4).setPosition(engine.bodies().get(4).getX(), engine.bodies().get(4).getY());
            }
            engine.step();
            if (k % 50 == 0) {
                assertThat(engine.overlaps()).isEmpty();
            }
        }
        assertThat(doomed).hasSizeGreaterThan(5);
    }

    /** Rays, distances and boxes are those of the parts, each as a body of its own. */
    @Test
    void questionsKnowAllParts() {
        PhysicsEngine whole = new PhysicsEngine();
        PhysicsEngine cut = new PhysicsEngine();
        SplittableRandom random = new SplittableRandom(4);
        for (int k = 0; k < 60; k++) {
            Compound shape = k % 3 == 0 ? cup() : k % 3 == 1 ? ell() : robot();
            double x = 20 * random.nextDouble();
            double y = 20 * random.nextDouble();
            double angle = 6 * random.nextDouble();
            whole.add(Body.fixed(shape).at(x, y, angle));
            for (int p = 0; p < shape.partCount(); p++) {
                Body frame = new Body(shape).at(x, y, angle);
                Shape part = shape.part(p);
                if (part.vertexCount() == 1) {
                    cut.add(Body.fixed(new Circle(part.radius()))
                            .at(frame.worldX(part.vertexX(0), part.vertexY(0)), frame.worldY(part.vertexX(0), part.vertexY(0))));
                    continue;
                }
                Polygon polygon = new Polygon(part.copyVertices());
                double px = polygon.centroidX();
                double py = polygon.centroidY();
                cut.add(Body.fixed(polygon).at(frame.worldX(px, py), frame.worldY(px, py), angle));
            }
        }
        int hits = 0;
        for (int k = 0; k < 3000; k++) {
            double x = 20 * random.nextDouble();
            double y = 20 * random.nextDouble();
            double angle = 6 * random.nextDouble();
            var one = whole.queries().rayCast(x, y, Math.cos(angle), Math.sin(angle), 30, null);
            var other = cut.queries().rayCast(x, y, Math.cos(angle), Math.sin(angle), 30, null);
            assertThat(one == null).isEqualTo(other == null);
            if (one != null) {
                hits++;
                assertThat(one.distance()).isEqualTo(other.distance(), within(1e-9));
                assertThat(one.nx()).isEqualTo(other.nx(), within(1e-9));
            }
            assertThat(whole.queries().within(x, y, 0.5, null).isEmpty()).isEqualTo(cut.queries().within(x, y, 0.5, null).isEmpty());
            assertThat(whole.queries().inBox(x, y, x + 0.5, y + 1, null).isEmpty())
                    .isEqualTo(cut.queries().inBox(x, y, x + 0.5, y + 1, null).isEmpty());
        }
        assertThat(hits).isGreaterThan(1000);
        Compound shape = cup();
        Body cup = whole.add(new Body(shape).at(50 + shape.centroidX(), shape.centroidY()));
        assertThat(whole.queries().distance(cup, 50, 0.75)).isEqualTo(0.5, within(1e-12)); // to the floor of the cavity
    }

    /** On a plane, a bar that is cut slides, spins and stops as the whole, and static friction bears as much. */
    @ParameterizedTest
    @ValueSource(ints = {2, 5})
    void thePlaneRubsAllParts(int parts) {
        List<Body> bars = new ArrayList<>();
        for (int cut : new int[] {1, parts}) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(0.01);
            ForceGenerator plane = engine.add(new SurfaceFriction(9.81));
            assertThat(plane).isNotNull();
            Body bar = engine.add(new Body(bar(2, 0.3, cut)).moving(1.5, 0.4, 3));
            bar.setSurfaceFriction(0.3, 0.4);
            for (int k = 0; k < 40; k++) {
                engine.step();
            }
            bars.add(bar);
            for (int k = 0; k < 100; k++) {
                engine.step();
            }
            assertThat(bar.getAngularVelocity()).isEqualTo(0);
            bar.addForceAt(0.98 * 0.4 * 9.81 * bar.getMass() / 2, 0, bar.getX(), bar.getY() + 0.05);
            engine.step();
            assertThat(bar.getVelocityX()).isEqualTo(0);
        }
        assertThat(bars.get(1).getX()).isEqualTo(bars.get(0).getX(), within(1e-10));
        assertThat(bars.get(1).getY()).isEqualTo(bars.get(0).getY(), within(1e-10));
        assertThat(bars.get(1).getAngle()).isEqualTo(bars.get(0).getAngle(), within(1e-10));
    }

    /** An L on a pin swings with the period of its moment of inertia, also while it is stepped. */
    @ParameterizedTest
    @ValueSource(ints = {0, 8})
    void aCompoundOnAPinIsAPendulum(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.005);
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(0, -9.81));
        Compound shape = ell();
        double arm = 2;
        double tilt = 1e-3;
        Body body = engine.add(new Body(shape).at(arm * Math.sin(tilt), -arm * Math.cos(tilt), tilt));
        engine.add(new PinJoint(body, 0, 0));
        double omega = Math.sqrt(9.81 * arm / (shape.unitInertia() + arm * arm));
        int steps = (int) Math.round(20 / 0.005);
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
        assertThat(body.getX()).isEqualTo(arm * Math.sin(tilt * Math.cos(omega * 20)), within(substeps == 0 ? 1e-8 : 1e-5));
    }
}
