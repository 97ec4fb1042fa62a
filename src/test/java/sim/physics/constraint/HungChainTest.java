// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.State;
import sim.physics.shape.Rectangle;

/** Chains that hang, whose accelerations are found from both ends or in sweeps: against the way for all trees, which is taken under weights. */
class HungChainTest {
    /** How the links lie in their own coordinates. */
    enum Lie {
        LEVEL,
        STEEP,
        ASKEW
    }

    /** A weight of an author's own, for which trees take another way. */
    private static final class Weight implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, 0.5 * body.getMass(), -9.81 * body.getMass());
        }
    }

    private static List<Body> chain(PhysicsEngine engine, int links, Lie lie, double sign) {
        SplittableRandom random = new SplittableRandom(links);
        List<Body> chain = new ArrayList<>();
        double x = 0.25;
        double y = -0.5;
        for (int k = 0; k < links; k++) {
            double length = 0.5 + random.nextDouble();
            double angle = 6 * random.nextDouble();
            double wide = lie == Lie.LEVEL ? length : lie == Lie.STEEP ? 0.02 : 0.8 * length;
            double high = lie == Lie.LEVEL ? 0.02 : lie == Lie.STEEP ? length : 0.6 * length;
            double alongX = lie == Lie.STEEP ? 0 : wide;
            double alongY = lie == Lie.LEVEL ? 0 : high;
            double ex = Math.cos(angle) * alongX - Math.sin(angle) * alongY;
            double ey = Math.sin(angle) * alongX + Math.cos(angle) * alongY;
            Body link = engine.add(new Body(new Rectangle(wide, high)).at(sign * (x + ex / 2), y + ey / 2, sign * angle));
            link.setMass(0.5 + random.nextDouble(), 0.05 + 0.1 * random.nextDouble());
            link.setCollisionGroup(1, 0);
            engine.add(k == 0 ? new PinJoint(link, sign * x, y) : new PinJoint(chain.get(k - 1), link, sign * x, y));
            chain.add(link);
            x += ex;
            y += ey;
        }
        return chain;
    }

    private static double[] run(int links, Lie lie, double sign, ForceGenerator pull) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 480.0);
        engine.add(pull);
        List<Body> chain = chain(engine, links, lie, sign);
        for (int k = 0; k < 96; k++) {
            engine.step();
        }
        for (Constraint pin : engine.allConstraints()) {
            assertThat(PinChainTest.gap((PinJoint) pin)).isLessThan(100 * 0x1p-52 * Math.max(1, links / 4));
        }
        double[] all = new double[3 * links];
        for (int k = 0; k < links; k++) {
            all[3 * k] = chain.get(k).getX();
            all[3 * k + 1] = chain.get(k).getY();
            all[3 * k + 2] = chain.get(k).getAngle();
        }
        return all;
    }

    @ParameterizedTest
    @CsvSource({"1, LEVEL", "2, LEVEL", "3, STEEP", "4, ASKEW", "5, LEVEL", "8, STEEP", "13, ASKEW", "24, LEVEL", "41, ASKEW", "5000, LEVEL", "5001, STEEP"})
    void goWhereTreesGo(int links, Lie lie) {
        double[] hung = run(links, lie, 1, new Gravity(0.5, -9.81));
        assertThat(hung).containsExactly(run(links, lie, 1, new Weight()), within(1e-9));
    }

    @ParameterizedTest
    @CsvSource({"1, LEVEL", "6, LEVEL", "7, LEVEL"})
    void goTheMirroredWayInTheMirror(int links, Lie lie) {
        double[] one = run(links, lie, 1, new Gravity(0.5, -9.81));
        double[] other = run(links, lie, -1, new Gravity(-0.5, -9.81));
        for (int k = 0; k < one.length; k++) {
            assertThat(other[k]).isEqualTo(k % 3 == 1 ? one[k] : -one[k]);
        }
    }

    /** At the origin, at rest, all values of a link are zero. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aPendulumAtTheOriginFallsAsOneElsewhere(boolean isField) {
        double[][] angles = new double[2][4];
        for (int place = 0; place < 2; place++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1 / 32.0);
            engine.add(isField ? new Gravity(0, -9.81) : new Weight());
            Body rod = engine.add(new Body(new Rectangle(2, 0.25)).at(place, 0));
            engine.add(new PinJoint(rod, place - 1, 0));
            for (int k = 0; k < 4; k++) {
                engine.step();
                angles[place][k] = rod.getAngle();
            }
        }
        assertThat(angles[0]).containsExactly(angles[1]);
    }

    /** Blocks side by side are taken at once; with others between them, and in the other order, one by one. */
    @ParameterizedTest
    @ValueSource(ints = {2, 5, 8})
    void goTheSameWayWhereverTheirBlocksLie(int links) {
        List<double[]> places = new ArrayList<>();
        for (int order = 0; order < 3; order++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1 / 60.0);
            engine.add(new Gravity(0, -9.81));
            Body[] chain = new Body[links];
            for (int k = 0; k < links; k++) {
                int link = order == 1 ? links - 1 - k : k;
                chain[link] = engine.add(new Body(new Rectangle(1, 0.02)).at(link + 0.5, 0));
                chain[link].setCollisionGroup(1, 0);
                if (order == 2) {
                    engine.add(new Body(new Rectangle(1, 1)).at(k, 100));
                }
            }
            for (int k = 0; k < links; k++) {
                engine.add(k == 0 ? new PinJoint(chain[k], 0, 0) : new PinJoint(chain[k - 1], chain[k], k, 0));
            }
            for (int k = 0; k < 300; k++) {
                engine.step();
            }
            double[] all = new double[4 * links];
            for (int k = 0; k < links; k++) {
                all[4 * k] = chain[k].getX();
                all[4 * k + 1] = chain[k].getY();
                all[4 * k + 2] = chain[k].getAngle();
                all[4 * k + 3] = chain[k].getAngularVelocity();
            }
            places.add(all);
        }
        assertThat(places.get(1)).containsExactly(places.get(0));
        assertThat(places.get(2)).containsExactly(places.get(0));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e3, 3e4, 1e6})
    void aPendulumThatHasTurnedOftenSwingsAsOneThatHasNot(double turns) {
        double[][] turning = new double[2][40];
        for (int which = 0; which < 2; which++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1 / 64.0);
            engine.add(new Gravity(0, -9.81));
            Body rod = engine.add(new Body(new Rectangle(2, 0.25)).at(1, 0, which * Math.rint(turns) * 2 * Math.PI));
            engine.add(new PinJoint(rod, 0, 0));
            for (int k = 0; k < 40; k++) {
                engine.step();
                turning[which][k] = rod.getAngularVelocity();
            }
        }
        assertThat(turning[1]).containsExactly(turning[0], within(1e-14 * turns));
    }

    private static List<Body> straightChain(PhysicsEngine engine, int links, double angle, double x, double y) {
        List<Body> chain = new ArrayList<>();
        double c = Math.cos(angle);
        double s = Math.sin(angle);
        for (int k = 0; k < links; k++) {
            Body rod = engine.add(new Body(new Rectangle(1, 0.02)).at(x + (k + 0.5) * c, y + (k + 0.5) * s, angle));
            rod.setMass(1, 1 / 12.0);
            rod.setCollisionGroup(1, 0);
            double px = x + k * c;
            double py = y + k * s;
            engine.add(k == 0 ? new PinJoint(rod, px, py) : new PinJoint(chain.get(k - 1), rod, px, py));
            chain.add(rod);
        }
        return chain;
    }

    /** Arms are found from places in the world, with their rounding: that is no reason to take a longer way. */
    @ParameterizedTest
    @CsvSource({
        "10, 0, 0, 0", "10, 0.1, 0, 0", "100, 0.1, 0, 0", "100, -0.2, 0, 0", "100, 0.3, 0, 0", "1000, 0.1, 0, 0", "30, 1.2, 300, -70",
        "30, 2.5, -1e5, 1e4"
    })
    void chainsBuiltAtAnAngleHang(int links, double angle, double x, double y) {
        PhysicsEngine engine = new PhysicsEngine();
        straightChain(engine, links, angle, x, y);
        List<TiedGroup> groups = Grouping.groups(engine.allConstraints(), new int[links]);
        State state = engine.bodies().get(0).state();
        assertThat(groups).hasSize(1);
        assertThat(groups.get(0).island().tree.advance(state, 0, -9.81, 1 / 240.0)).isTrue();
        assertThat(groups.get(0).island().tree.isHung()).isTrue();
        for (Constraint pin : engine.allConstraints()) {
            double coordinate = Math.max(Math.abs(x) + Math.abs(y), 1) + links;
            assertThat(PinChainTest.gap((PinJoint) pin)).isLessThan(4 * 0x1p-52 * coordinate);
        }
    }

    /** A centre of mass that is really beside the line is no rounding. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 1e-12, -0.05})
    void chainsOfCrookedLinksDoNotHang(double aside) {
        PhysicsEngine engine = new PhysicsEngine();
        Body one = engine.add(new Body(new Rectangle(1, 0.2)).at(0.5, 0));
        Body two = engine.add(new Body(new Rectangle(1, 0.2)).at(1.5, 0));
        engine.add(new PinJoint(one, 0, aside));
        engine.add(new PinJoint(one, two, 1, aside));
        List<TiedGroup> groups = Grouping.groups(engine.allConstraints(), new int[2]);
        assertThat(groups.get(0).island().tree.advance(one.state(), 0, -9.81, 1 / 240.0)).isTrue();
        assertThat(groups.get(0).island().tree.isHung()).isFalse();
    }

    @ParameterizedTest
    @CsvSource({"10, 0.1", "40, -0.2", "100, 0.3", "4001, 0.3", "6000, 0.1"})
    void straightChainsGoWhereTreesGo(int links, double angle) {
        double[][] places = new double[2][2 * links];
        for (int way = 0; way < 2; way++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1 / 480.0);
            engine.add(way == 0 ? new Gravity(0.5, -9.81) : new Weight());
            List<Body> chain = straightChain(engine, links, angle, 1, 2);
            for (int k = 0; k < 96; k++) {
                engine.step();
            }
            for (int k = 0; k < links; k++) {
                places[way][2 * k] = chain.get(k).getX();
                places[way][2 * k + 1] = chain.get(k).getY();
            }
            for (Constraint pin : engine.allConstraints()) {
                assertThat(PinChainTest.gap((PinJoint) pin)).isLessThan(100 * 0x1p-52 * Math.max(1, links / 4));
            }
        }
        assertThat(places[0]).containsExactly(places[1], within(1e-9));
    }

    /** What the root of a chain laid along an axis feels fades from link to link. */
    @ParameterizedTest
    @CsvSource({"1000, 20", "3000, 200", "6000, 200"})
    void nothingFadesIntoDenormalNumbers(int links, int steps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 240.0);
        engine.add(new Gravity(0, -9.81));
        List<Body> chain = new ArrayList<>();
        for (int k = 0; k < links; k++) {
            Body rod = engine.add(new Body(new Rectangle(1, 0.02)).at(k + 0.5, 0));
            rod.setMass(1, 1 / 12.0);
            rod.setCollisionGroup(1, 0);
            engine.add(k == 0 ? new PinJoint(rod, 0, 0) : new PinJoint(chain.get(k - 1), rod, k, 0));
            chain.add(rod);
        }
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
        for (Body rod : chain) {
            double turning = Math.abs(rod.getAngularVelocity());
            assertThat(turning == 0 || turning >= Double.MIN_NORMAL).isTrue();
            assertThat(rod.getAngle() == 0 || Math.abs(rod.getAngle()) >= Double.MIN_NORMAL).isTrue();
        }
        assertThat(chain.get(50).getAngularVelocity()).isNotZero();
    }
}
