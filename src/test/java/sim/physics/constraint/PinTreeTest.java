// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

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
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Trees of pins, whose steps are made in their angles: against the general code, and the laws of motion. */
class PinTreeTest {
    /** A random tree of rods; its last rod hangs from the one before, and each third one from any earlier one. */
    private static List<Body> tree(PhysicsEngine engine, int links, boolean isHeld, int seed) {
        SplittableRandom random = new SplittableRandom(100L * links + seed);
        List<Body> rods = new ArrayList<>();
        double[] x = new double[links];
        double[] y = new double[links];
        for (int k = 0; k < links; k++) {
            int from = k == 0 ? -1 : k % 3 == 2 ? random.nextInt(k) : k - 1;
            double angle = 6 * random.nextDouble();
            double length = 0.5 + random.nextDouble();
            double nearX = from < 0 ? 0.25 : x[from];
            double nearY = from < 0 ? -0.5 : y[from];
            x[k] = nearX + length * Math.cos(angle);
            y[k] = nearY + length * Math.sin(angle);
            Body rod = engine.add(new Body(new Rectangle(length, 0.02)).at((nearX + x[k]) / 2, (nearY + y[k]) / 2, angle));
            rod.setMass(0.5 + random.nextDouble(), 0.05 + 0.1 * random.nextDouble());
            rod.setCollisionGroup(1, 0);
            rods.add(rod);
            boolean isTurned = random.nextBoolean();
            if (from >= 0) {
                Body other = rods.get(from);
                engine.add(new PinJoint(isTurned ? rod : other, isTurned ? other : rod, nearX, nearY));
            } else if (isHeld) {
                engine.add(new PinJoint(rod, nearX, nearY));
            }
        }
        rods.forEach(rod -> rod.setAngularVelocity(random.nextDouble() - 0.5)); // those that the pins allow are next to these
        return rods;
    }

    private static PhysicsEngine engine(double step, double gravity) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        if (gravity != 0) {
            engine.add(new Gravity(0.5, -gravity));
        }
        return engine;
    }

    private static double[] places(List<Body> rods) {
        double[] places = new double[3 * rods.size()];
        for (int k = 0; k < rods.size(); k++) {
            places[3 * k] = rods.get(k).getX();
            places[3 * k + 1] = rods.get(k).getY();
            places[3 * k + 2] = rods.get(k).getAngle();
        }
        return places;
    }

    /** A force and a torque that change with time, place, turn and velocity. */
    private static final class Wind implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            double pull = 5 - 3 * body.getX() + 2 * time * time;
            double lift = 4 * Math.sin(body.getAngle()) - body.getVelocityY();
            forces.addAt(body, pull, lift, body.getX() + 0.1, body.getY() - 0.05);
            forces.addTorque(body, -0.2 * body.getAngularVelocity());
        }
    }

    private static double[] run(int links, boolean isHeld, double step, boolean isQuick, boolean isWindy) {
        PhysicsEngine engine = engine(step, 9.81);
        List<Body> rods = tree(engine, links, isHeld, 1);
        if (isWindy) {
            engine.add(new Wind());
        }
        if (!isQuick) {
            engine.add(new PinChainTest.Nothing());
        }
        for (int k = 0; k < Math.round(0.25 / step); k++) {
            engine.step();
        }
        for (Constraint pin : engine.allConstraints()) {
            assertThat(PinChainTest.gap((PinJoint) pin)).isLessThan(100 * 0x1p-52 * links);
        }
        return places(rods);
    }

    @ParameterizedTest
    @CsvSource({"1, true", "2, true", "3, true", "3, false", "9, true", "9, false", "30, true", "30, false"})
    void goToWhereTheGeneralCodeGoes(int links, boolean isHeld) {
        goToWhereTheGeneralCodeGoes(links, isHeld, false);
    }

    /** Plates whose centres are beside the line from pin to pin, some far from pins that are near to each other. */
    private static double[] plates(boolean isHeld, double step, boolean isQuick, boolean isWindy) {
        PhysicsEngine engine = engine(step, 9.81);
        SplittableRandom random = new SplittableRandom(7);
        List<Body> plates = new ArrayList<>();
        double x = 0;
        double y = 0;
        for (int k = 0; k < 8; k++) {
            double length = k % 3 == 1 ? 0.02 : 0.6;
            double nextX = x + length * Math.cos(2.0 * k);
            double nextY = y + length * Math.sin(2.0 * k);
            double centreX = x + 0.4 * random.nextDouble() - 0.2;
            double centreY = y + 0.4 * random.nextDouble() - 0.2;
            Body plate = engine.add(new Body(new Rectangle(0.6, 0.4)).at(centreX, centreY, random.nextDouble()));
            plate.setMass(0.5 + random.nextDouble(), 0.05 + 0.1 * random.nextDouble());
            plate.setCollisionGroup(1, 0);
            if (k > 0) {
                engine.add(new PinJoint(plates.get(k == 5 ? 2 : k - 1), plate, x, y)); // a branch
            } else if (isHeld) {
                engine.add(new PinJoint(plate, x, y));
            }
            plates.add(plate);
            x = nextX;
            y = nextY;
        }
        if (isWindy) {
            engine.add(new Wind());
        }
        if (!isQuick) {
            engine.add(new PinChainTest.Nothing());
        }
        for (int k = 0; k < Math.round(0.125 / step); k++) {
            engine.step();
        }
        return places(plates);
    }

    @ParameterizedTest
    @CsvSource({"true, false", "false, false", "true, true", "false, true"})
    void platesGoThereToo(boolean isHeld, boolean isWindy) {
        double[] coarse = plates(isHeld, 1 / 1024.0, true, isWindy);
        double[] fine = plates(isHeld, 1 / 2048.0, true, isWindy);
        double[] general = plates(isHeld, 1 / 4096.0, false, isWindy);
        assertThat(fine).containsExactly(general, within(1e-6));
        assertThat(most(fine, general)).isLessThan(most(coarse, general) / 8 + 1e-11);
    }

    @ParameterizedTest
    @CsvSource({"1, true", "2, true", "3, true", "3, false", "9, true", "9, false", "30, true", "30, false"})
    void goThereUnderAnyForces(int links, boolean isHeld) {
        goToWhereTheGeneralCodeGoes(links, isHeld, true);
    }

    private static void goToWhereTheGeneralCodeGoes(int links, boolean isHeld, boolean isWindy) {
        double[] coarse = run(links, isHeld, 1 / 512.0, true, isWindy);
        double[] fine = run(links, isHeld, 1 / 1024.0, true, isWindy);
        double[] general = run(links, isHeld, 1 / 2048.0, false, isWindy);
        assertThat(fine).containsExactly(general, within(1e-6));
        assertThat(most(fine, general)).isLessThan(most(coarse, general) / 8 + 1e-11); // order 4
    }

    /** A weight of an author's own is as good as a field: the tree may not feel the difference. */
    private static final class Weight implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, 0.5 * body.getMass(), -9.81 * body.getMass());
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aWeightIsAsGoodAsAField(boolean isHeld) {
        PhysicsEngine field = engine(1 / 240.0, 9.81);
        PhysicsEngine weight = engine(1 / 240.0, 0);
        List<Body> fall = tree(field, 12, isHeld, 4);
        List<Body> hang = tree(weight, 12, isHeld, 4);
        weight.add(new Weight());
        for (int k = 0; k < 240; k++) {
            field.step();
            weight.step();
        }
        assertThat(places(hang)).containsExactly(places(fall), within(1e-9));
    }

    /** A wind that blows on circles only. */
    private static final class Draught implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public boolean actsOn(Body body) {
            return body.getShape() instanceof Circle;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, 1, 0);
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void whatActsElsewhereDoesNotChangeABit(boolean isHeld) {
        PhysicsEngine calm = engine(1 / 240.0, 9.81);
        PhysicsEngine busy = engine(1 / 240.0, 9.81);
        List<Body> rods = tree(calm, 9, isHeld, 5);
        List<Body> others = tree(busy, 9, isHeld, 5);
        Body ball = busy.add(new Body(new Circle(1)).at(1000, 0));
        busy.add(new Draught());
        for (int k = 0; k < 240; k++) {
            ball.addForce(0, k % 2);
            calm.step();
            busy.step();
        }
        assertThat(ball.getVelocityX()).isGreaterThan(0.1);
        assertThat(places(others)).isEqualTo(places(rods));
    }

    /** Turns rods by 0.3 rad to and fro within a step of 0.1. */
    private static final class Shaker implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public boolean actsOn(Body body) {
            return body.getShape() instanceof Rectangle;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            double inertia = body.getInertia() + 0.25 * body.getMass();
            forces.addTorque(body, inertia * 592 * Math.cos(2 * Math.PI * time / 0.1));
        }
    }

    /** The ends of the step tell nothing of it. */
    @Test
    void aLinkThatSwingsOutAndBackMeetsWhatIsThere() {
        PhysicsEngine engine = engine(0.1, 0);
        Body rod = engine.add(new Body(new Rectangle(1, 0.02)).at(0.5, 0));
        engine.add(new PinJoint(rod, 0, 0));
        engine.add(Body.fixed(new Circle(0.05)).at(0.8 * Math.cos(0.25), 0.8 * Math.sin(0.25)));
        engine.add(new Shaker());
        engine.step();
        assertThat(engine.getImpacts()).isPositive();
    }

    @Test
    void aFreeTreeGoesWhereItsForcesPushIt() {
        PhysicsEngine engine = engine(1 / 240.0, 0);
        List<Body> rods = tree(engine, 12, false, 2);
        engine.add(new Weight());
        engine.step();
        double[] start = centre(rods);
        for (int k = 0; k < 480; k++) {
            engine.step();
        }
        double[] end = centre(rods);
        assertThat(end[0]).isCloseTo(start[0] + 2 * start[2] + 0.5 * 0.5 * 4, within(1e-11));
        assertThat(end[1]).isCloseTo(start[1] + 2 * start[3] - 0.5 * 9.81 * 4, within(1e-11));
    }

    private static double most(double[] a, double[] b) {
        double most = 0;
        for (int k = 0; k < a.length; k++) {
            most = Math.max(most, Math.abs(a[k] - b[k]));
        }
        return most;
    }

    @Test
    void aFreeTreeFallsAsABody() {
        PhysicsEngine engine = engine(1 / 240.0, 9.81);
        List<Body> rods = tree(engine, 12, false, 2);
        engine.step();
        double[] start = centre(rods);
        for (int k = 0; k < 480; k++) {
            engine.step();
        }
        double[] end = centre(rods);
        assertThat(end[0]).isCloseTo(start[0] + 2 * start[2] + 0.5 * 0.5 * 4, within(1e-12));
        assertThat(end[1]).isCloseTo(start[1] + 2 * start[3] - 0.5 * 9.81 * 4, within(1e-12));
    }

    @Test
    void aTreeInSpaceKeepsWhatNothingTakesAway() {
        PhysicsEngine engine = engine(1 / 240.0, 0);
        List<Body> rods = tree(engine, 12, false, 3);
        engine.step();
        double energy = engine.kineticEnergy();
        double spin = spin(rods);
        double[] start = centre(rods);
        for (int k = 0; k < 480; k++) {
            engine.step();
        }
        assertThat(engine.kineticEnergy()).isCloseTo(energy, within(1e-12 * energy));
        assertThat(spin(rods)).isCloseTo(spin, within(1e-11));
        assertThat(centre(rods)[2]).isCloseTo(start[2], within(1e-12));
        assertThat(centre(rods)[3]).isCloseTo(start[3], within(1e-12));
    }

    /** A chain that whips is where a step is too long, which nothing that opens would tell. */
    @ParameterizedTest
    @CsvSource({"40, 6000", "100, 10000"})
    void aLongChainThatWhipsKeepsItsEnergy(int links, int steps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 240.0);
        engine.add(new Gravity(0, -9.81));
        Body last = null;
        for (int k = 0; k < links; k++) {
            Body rod = engine.add(new Body(new Rectangle(1, 0.02)).at(k + 0.5, 0));
            rod.setMass(1, 1 / 12.0);
            rod.setCollisionGroup(1, 0);
            engine.add(last == null ? new PinJoint(rod, 0, 0) : new PinJoint(last, rod, k, 0));
            last = rod;
        }
        double fall = 9.81 * links * links / 2; // from the horizontal to hanging down
        for (int k = 0; k < steps; k++) {
            engine.step();
            if (k % 100 == 99) {
                double energy = engine.kineticEnergy();
                for (Body rod : engine.bodies()) {
                    energy += 9.81 * rod.getY();
                }
                assertThat(energy).as("step %d", k).isBetween(-0.002 * fall, 0.002 * fall);
            }
        }
        for (Constraint pin : engine.allConstraints()) {
            assertThat(PinChainTest.gap((PinJoint) pin)).isLessThan(100 * 0x1p-52 * links);
        }
    }

    private static double[] centre(List<Body> rods) {
        double[] sum = new double[4];
        double mass = 0;
        for (Body rod : rods) {
            double m = rod.getMass();
            sum[0] += m * rod.getX();
            sum[1] += m * rod.getY();
            sum[2] += m * rod.getVelocityX();
            sum[3] += m * rod.getVelocityY();
            mass += m;
        }
        for (int k = 0; k < sum.length; k++) {
            sum[k] /= mass;
        }
        return sum;
    }

    private static double spin(List<Body> rods) {
        double sum = 0;
        for (Body rod : rods) {
            sum += rod.getInertia() * rod.getAngularVelocity()
                    + rod.getMass() * (rod.getX() * rod.getVelocityY() - rod.getY() * rod.getVelocityX());
        }
        return sum;
    }
}
