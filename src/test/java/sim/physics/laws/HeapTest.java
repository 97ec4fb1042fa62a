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
import sim.physics.Scenes;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Bodies that lie on one another: they come to rest, do not sink, slide by Coulomb's law, and fall if their support goes. */
class HeapTest {
    private static final double G = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();

    HeapTest() {
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -G));
    }

    private Body add(Body body, double restitution, double friction) {
        body.setRestitution(restitution);
        body.setFriction(friction);
        return engine.add(body);
    }

    private List<Body> stack(int n, double restitution, double friction, double offset) {
        add(Body.fixed(new Rectangle(100, 2)).at(0, -1), restitution, friction);
        List<Body> stack = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            stack.add(add(new Body(new Rectangle(1, 1)).at(offset * (k % 2), 1.1 * k + 0.6), restitution, friction));
        }
        return stack;
    }

    private int run(int steps) {
        int most = 0;
        for (int k = 0; k < steps; k++) {
            long before = engine.getImpacts();
            engine.step();
            most = (int) Math.max(most, engine.getImpacts() - before);
        }
        return most;
    }

    /**
     * More points touch in a pile of discs than it has freedoms: which of them bear it is not clear, that it rests is. A disc may
     * roll for ever, as nothing that rolls loses energy: of sixty piles 42 rest at least (of thirty it would be luck: four of five do), and of a
     * hundred with boxes 70 (of two hundred 157 to 163 do, of the first sixty 40 to 46). So may a box rock that lies across discs, with some
     * millijoules that come and go: three do, of two hundred four. What is at rest makes no impacts.
     */
    @ParameterizedTest
    @CsvSource({"0, 60, 42", "0.5, 100, 70"})
    void pilesComeToRest(double boxes, int piles, int least) {
        int rest = 0;
        int rocking = 0;
        for (int seed = 1; seed <= piles; seed++) {
            PhysicsEngine pile = pile(seed, boxes);
            for (int k = 0; k < 720; k++) {
                pile.step();
            }
            assertThat(pile.getDeepestPenetration()).as("pile " + seed).isLessThan(1e-9);
            assertThat(pile.overlaps()).allSatisfy(overlap -> assertThat(overlap.depth()).isLessThan(1e-9));
            assertThat(pile.kineticEnergy()).as("pile " + seed).isLessThan(0.03);
            rocking += pile.kineticEnergy() > 2e-3 ? 1 : 0;
            long before = pile.getImpacts();
            boolean still = pile.kineticEnergy() == 0;
            rest += still ? 1 : 0;
            for (int k = 0; k < 60; k++) {
                pile.step();
            }
            assertThat(!still || pile.getImpacts() == before).isTrue();
        }
        assertThat(rest).isGreaterThanOrEqualTo(least);
        assertThat(rocking).isLessThanOrEqualTo(3);
    }

    /** Thirty discs, some of them boxes, that fall into a bin. */
    private static PhysicsEngine pile(int seed, double boxes) {
        PhysicsEngine pile = new PhysicsEngine();
        pile.setTimeStep(1 / 60.0);
        pile.add(new Gravity(0, -G));
        put(pile, Body.fixed(new Rectangle(6, 2)).at(0, -1), 0.5);
        for (int side = -1; side <= 1; side += 2) {
            put(pile, Body.fixed(new Rectangle(1, 60)).at(side * 2.5, 15), 0.5);
        }
        SplittableRandom random = new SplittableRandom(seed);
        for (int k = 0; k < 30; k++) {
            double x = (k % 5) * 0.7 - 1.5 + random.nextDouble(0.05);
            double size = random.nextDouble(0.2, 0.3);
            Shape shape = random.nextDouble() < boxes ? new Rectangle(2 * size, 1.4 * size) : new Circle(size);
            put(pile, new Body(shape).at(x, 0.75 * (k / 5) + 0.5), 0.4);
        }
        return pile;
    }

    private static void put(PhysicsEngine pile, Body body, double friction) {
        body.setRestitution(0.1);
        body.setFriction(friction);
        pile.add(body);
    }

    /** Each box stands on two: its forces are not unique, those on the floor add up to the weight, and all is exactly at rest. */
    @ParameterizedTest
    @ValueSource(ints = {3, 6, 10})
    void aPyramidComesToRest(int rows) {
        Body floor = add(Body.fixed(new Rectangle(100, 2)).at(0, -1), 0, 0.6);
        double mass = 0;
        List<Body> boxes = new ArrayList<>();
        for (int row = 0; row < rows; row++) {
            for (int k = 0; k < rows - row; k++) {
                boxes.add(add(new Body(new Rectangle(1, 1)).at(1.1 * k + 0.55 * row, row + 0.5), 0, 0.6));
                mass += boxes.get(boxes.size() - 1).getMass();
            }
        }
        run(120);
        assertThat(engine.kineticEnergy()).isZero();
        for (Body box : boxes) {
            assertThat(box.getY() % 1).isCloseTo(0.5, within(1e-7));
            assertThat(box.getAngle()).isCloseTo(0, within(1e-7));
        }
        double borne = engine.contacts(floor).stream().mapToDouble(LastingContact::normalForce).sum();
        assertThat(borne).isCloseTo(mass * G, within(1e-6 * mass * G));
    }

    @ParameterizedTest
    @CsvSource({"2, 0.3, 0.5, 0", "5, 0, 0.5, 0", "5, 0.3, 0, 0", "10, 0.3, 0.5, 0", "3, 0.5, 0.5, 0.2", "10, 0.5, 0.5, 0.2"})
    void aStackComesToRest(int n, double restitution, double friction, double offset) {
        List<Body> stack = stack(n, restitution, friction, offset);
        int most = run(600);
        assertThat(most).as("impacts in a step").isLessThan(20 * n);
        assertThat(engine.kineticEnergy()).isZero();
        for (int k = 0; k < n; k++) {
            assertThat(stack.get(k).getY()).as("height of box " + k).isCloseTo(k + 0.5, within(1e-8));
            assertThat(stack.get(k).getAngle()).isCloseTo(0, within(1e-8));
        }
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-9);
    }

    @Test
    void whatStandsStillCostsNothing() {
        stack(5, 0.3, 0.5, 0);
        run(300);
        long looks = engine.getNarrowPhaseEvaluations();
        run(1000);
        assertThat(engine.getNarrowPhaseEvaluations()).isEqualTo(looks);
    }

    /** The forces of a tall stack are solved for exactly, else it would creep and be solved for in each step for ever. */
    @ParameterizedTest
    @ValueSource(ints = {50, 80})
    void aTallStackComesToRestToo(int height) {
        stack(height, 0.2, 0.5, 0);
        run(150);
        assertThat(engine.kineticEnergy()).isZero();
        long looks = engine.getNarrowPhaseEvaluations();
        run(300);
        assertThat(engine.getNarrowPhaseEvaluations()).isEqualTo(looks);
        double weight = height * engine.bodies().get(1).getMass() * G;
        double borne = engine.contacts(engine.bodies().get(0)).stream().mapToDouble(LastingContact::normalForce).sum();
        assertThat(borne).isCloseTo(weight, within(1e-6 * weight));
    }

    @Test
    void aStackFallsIfItsSupportIsTakenAway() {
        List<Body> stack = stack(4, 0, 0.5, 0);
        run(300);
        double[] heights = stack.stream().mapToDouble(Body::getY).toArray();
        engine.remove(stack.get(0));
        run(6);
        double fallen = 0.5 * G * 0.1 * 0.1;
        assertThat(stack.get(3).getY()).isCloseTo(heights[3] - fallen, within(0.01));
        run(300);
        assertThat(stack.get(3).getY()).isCloseTo(heights[3] - 1, within(1e-8));
    }

    /** Four boxes on one another slide as one, with the force on the lowest less friction of them all. */
    @Test
    void aPushedStackSlidesByCoulombsLaw() {
        List<Body> stack = stack(4, 0.3, 0.5, 0);
        run(300);
        for (int k = 0; k < 120; k++) {
            stack.get(0).addForce(30, 0);
            engine.step();
        }
        double speed = (30 / 4.0 - 0.5 * G) * 2;
        assertThat(stack.get(0).getVelocityX()).isCloseTo(speed, within(1e-9));
        assertThat(stack.get(3).getVelocityX()).isCloseTo(speed, within(1e-9));
        assertThat(stack.get(3).getX()).isCloseTo(stack.get(0).getX(), within(1e-6));
    }

    /** The lower block slides on a floor without friction: its momentum with the upper one stays, and heat is μ N s. */
    @Test
    void aBlockSlidesOnAMovableOneByCoulombsLaw() {
        add(Body.fixed(new Rectangle(1000, 2)).at(0, -1), 0, 0);
        Body below = add(new Body(new Rectangle(40, 1)).at(0, 0.5), 0, 0.25);
        Body above = add(new Body(new Rectangle(1, 1)).at(-10, 1.5), 0, 0.25);
        below.setMass(3);
        above.setMass(1);
        run(60);
        above.setVelocity(4, 0);
        double start = above.getX() - below.getX();
        run(240);
        assertThat(above.getVelocityX()).isCloseTo(1, within(1e-9));
        assertThat(below.getVelocityX()).isCloseTo(1, within(1e-9));
        double way = 4 * 4 * 0.75 / (2 * 0.25 * G);
        assertThat(above.getX() - below.getX() - start).isCloseTo(way, within(4 * 1.0 / 60));
        assertThat(above.getY()).isCloseTo(1.5, within(1e-6));
    }

    @Test
    void aHeapOfBallsAndBoxesLosesItsEnergyAndStaysInItsBox() {
        walls(0.3, 0.4);
        List<Body> heap = fill(30, 0.3, 0.4);
        double energy = energy(heap);
        for (int k = 0; k < 600; k++) {
            engine.step();
            double now = energy(heap);
            assertThat(now).as("energy in step " + k).isLessThanOrEqualTo(energy + 2e-3 * heap.size());
            energy = Math.min(energy, now);
        }
        assertThat(engine.kineticEnergy()).isLessThan(0.1);
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-9);
        assertThat(engine.overlaps().stream().mapToDouble(o -> o.depth()).max().orElse(0)).isLessThan(1e-9);
    }

    private void walls(double restitution, double friction) {
        add(Body.fixed(new Rectangle(14, 2)).at(0, -1), restitution, friction);
        add(Body.fixed(new Rectangle(2, 40)).at(-6, 20), restitution, friction);
        add(Body.fixed(new Rectangle(2, 40)).at(6, 20), restitution, friction);
    }

    private List<Body> fill(int n, double restitution, double friction) {
        SplittableRandom random = new SplittableRandom(5);
        List<Body> heap = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            Shape shape = k % 2 == 0 ? new Circle(0.3 + 0.3 * random.nextDouble()) : new Rectangle(1.2, 0.6);
            Body body = new Body(shape).at(-4 + 2 * (k % 5), 1 + 1.5 * (k / 5), random.nextDouble());
            body.setMass(shape.area() * (0.2 + 5 * random.nextDouble()));
            heap.add(add(body.moving(random.nextDouble() - 0.5, 0, 0), restitution, friction));
        }
        return heap;
    }

    private double energy(List<Body> heap) {
        return engine.kineticEnergy() + heap.stream().mapToDouble(b -> G * b.getMass() * b.getY()).sum();
    }

    @Test
    void aHeapContinuesFromACheckpointBitForBit() {
        walls(0.2, 0.5);
        fill(30, 0.2, 0.5);
        run(80);
        PhysicsEngine copy = Checkpoint.copy(engine);
        for (int k = 0; k < 100; k++) {
            engine.step();
            copy.step();
        }
        assertThat(Scenes.hash(copy)).isEqualTo(Scenes.hash(engine));
    }
}
