// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.Loads;
import sim.physics.motion.State;
import sim.physics.shape.Rectangle;

/** The quick steps of chains of pins are those of the general code, whichever way the chain is laid out. */
class PinChainTest {
    /** A force of nothing, which may couple any bodies and so keeps the engine from the quick way. */
    static final class Nothing implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            // none
        }

        @Override
        public boolean isCoupled() {
            return true;
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 4, 5, 6, 10, 31, 32})
    void movesAsTheGeneralCodeDoes(int links) {
        for (int ends = 0; ends < 4; ends++) {
            for (int seed = 0; seed < 3; seed++) {
                if (links == 1 && ends == 0 || links < 3 && ends == 3) {
                    continue; // no pin, or nothing that can move
                }
                List<Body> quick = new ArrayList<>();
                List<Body> general = new ArrayList<>();
                PhysicsEngine one = chain(links, ends, seed, quick);
                PhysicsEngine other = chain(links, ends, seed, general);
                other.add(new Nothing());
                for (int step = 0; step < 100; step++) {
                    one.step();
                    other.step();
                }
                for (int k = 0; k < quick.size(); k++) {
                    assertThat(quick.get(k).getX()).isCloseTo(general.get(k).getX(), within(1e-10));
                    assertThat(quick.get(k).getY()).isCloseTo(general.get(k).getY(), within(1e-10));
                    assertThat(quick.get(k).getAngle()).isCloseTo(general.get(k).getAngle(), within(1e-10));
                    assertThat(quick.get(k).getAngularVelocity())
                            .isCloseTo(general.get(k).getAngularVelocity(), within(1e-8));
                }
            }
        }
    }

    /** Accelerations of an author's own, the same over the whole run, for which the engine asks body by body. */
    private static final class Even implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final List<Body> rods;

        Even(List<Body> rods) {
            this.rods = rods;
        }

        static double acceleration(int rod, int slot) {
            return slot == State.THETA ? 3 - rod % 5 : slot == 1 ? -4 * (rod % 2) : 2 * (rod % 3);
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            int k = rods.indexOf(body);
            forces.add(body, body.getMass() * acceleration(k, 0), body.getMass() * acceleration(k, 1));
            forces.addTorque(body, body.getInertia() * acceleration(k, State.THETA));
        }
    }

    /** As contacts push a bridge. */
    @ParameterizedTest
    @ValueSource(ints = {5, 10, 31})
    void movesUnderEvenLoadsAsTheGeneralCodeDoes(int links) {
        List<Body> quick = new ArrayList<>();
        List<Body> general = new ArrayList<>();
        PhysicsEngine one = chain(links, 3, 1, quick);
        PhysicsEngine other = chain(links, 3, 1, general);
        one.step(); // what was put together is closed
        other.step();
        other.add(new Even(general));
        State state = quick.get(0).state();
        Island island = Grouping.groups(one.allConstraints(), new int[links + 1]).get(0).island();
        Loads loads = (bodies, t, a) -> {
            for (int k = 0; k < links; k++) {
                for (int c = 0; c < State.BLOCK; c++) {
                    double field = c == 0 ? 0.5 : c == 1 ? -9.81 : 0;
                    a[State.BLOCK * quick.get(k).index() + c] = field + Even.acceleration(k, c);
                }
            }
        };
        double[] first = new double[state.x().length];
        for (int step = 0; step < 100; step++) {
            other.step();
            assertThat(island.chain.advance(state, new DirectSolver(), loads, first, 0, 1 / 500.0)).isTrue();
        }
        for (int k = 0; k < links; k++) {
            assertThat(quick.get(k).getX()).isCloseTo(general.get(k).getX(), within(1e-10));
            assertThat(quick.get(k).getY()).isCloseTo(general.get(k).getY(), within(1e-10));
            assertThat(quick.get(k).getAngle()).isCloseTo(general.get(k).getAngle(), within(1e-10));
            assertThat(quick.get(k).getAngularVelocity()).isCloseTo(general.get(k).getAngularVelocity(), within(1e-8));
        }
    }

    /** How far a pin is open. */
    static double gap(PinJoint pin) {
        double[] a = place(pin.getBodyA(), pin.getAnchorAX(), pin.getAnchorAY());
        double[] b = place(pin.getBodyB(), pin.getAnchorBX(), pin.getAnchorBY());
        return StrictMath.hypot(a[0] - b[0], a[1] - b[1]);
    }

    private static double[] place(Body body, double x, double y) {
        if (body == null) {
            return new double[] {x, y};
        }
        double cos = StrictMath.cos(body.getAngle());
        double sin = StrictMath.sin(body.getAngle());
        return new double[] {body.getX() + (cos * x - sin * y), body.getY() + (sin * x + cos * y)};
    }

    /** A zigzag of rods, some pins of which name their bodies the other way round; ends: bit 0 left, 1 right is held. */
    private static PhysicsEngine chain(int links, int ends, int seed, List<Body> rods) {
        SplittableRandom random = new SplittableRandom(31L * links + seed);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 500.0);
        engine.add(new Gravity(0.5, -9.81));
        double x = 0;
        double y = 0;
        for (int k = 0; k < links; k++) {
            double angle = k % 2 == 0 ? 0.4 : -0.5;
            double length = 0.6 + 0.5 * random.nextDouble();
            Body rod = new Body(new Rectangle(length, 0.02));
            rod.setMass(0.5 + random.nextDouble(), 0.05 + 0.1 * random.nextDouble());
            rod.setCollisionGroup(1, 0);
            rods.add(rod.at(x + 0.5 * length * Math.cos(angle), y + 0.5 * length * Math.sin(angle)));
            rod.setAngle(angle);
            engine.add(rod);
            rod.setAngularVelocity(random.nextDouble() - 0.5);
            if (k > 0) {
                boolean turned = random.nextBoolean();
                engine.add(new PinJoint(rods.get(turned ? k : k - 1), rods.get(turned ? k - 1 : k), x, y));
            } else if ((ends & 1) > 0) {
                engine.add(new PinJoint(rod, x, y));
            }
            x += length * Math.cos(angle);
            y += length * Math.sin(angle);
        }
        if ((ends & 2) > 0) {
            Body post = Body.fixed(new Rectangle(0.1, 0.1)).at(x, y);
            post.setCollisionGroup(1, 0);
            engine.add(post);
            engine.add(new PinJoint(post, rods.get(links - 1), x, y));
        }
        return engine;
    }
}
