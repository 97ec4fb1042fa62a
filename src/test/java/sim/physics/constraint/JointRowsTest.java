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
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.shape.Rectangle;

/** The rows that an island evaluates by kinds are those of each joint, and what it solves with them satisfies them. */
class JointRowsTest {
    private static final int MOVABLE = 4;

    private final State state = new State();
    private final List<Body> bodies = new ArrayList<>();
    private final List<Constraint> joints = new ArrayList<>();
    private Island island;

    private void build(SplittableRandom random) {
        IntList indices = new IntList();
        for (int k = 0; k < MOVABLE; k++) {
            Body body = new Body(new Rectangle(1, 0.5)).at(1.3 * k, 0.1 * k, 0.2 * k);
            body.setMass(1 + k, 0.5 + 0.3 * k);
            indices.add(state.add(body));
            bodies.add(body);
        }
        Body held = Body.fixed(new Rectangle(1, 1)).at(-2, 1, 0.7);
        state.add(held);
        joints.add(new RodJoint(bodies.get(0), 0.2, 0.1, held, -1.8, 1.2));
        joints.add(new RodJoint(held, -1.7, 0.8, bodies.get(1), 1.3, 0.1));
        joints.add(new RodJoint(bodies.get(2), 2.6, 0.2, null, 2, 3));
        joints.add(new SliderJoint(bodies.get(0), bodies.get(1), 0.6, 0.2, 1, 0.3));
        joints.add(new SliderJoint(bodies.get(3), held, 3, 0, 0.4, 1));
        joints.add(new SlotJoint(bodies.get(3), bodies.get(2), 3, 0.5, 0.4, 1));
        joints.add(new SlotJoint(bodies.get(1), null, 1, 0.4, -2, 1));
        joints.add(new WeldJoint(bodies.get(1), bodies.get(2), 2, 0.2));
        joints.add(new GearJoint(bodies.get(2), bodies.get(3), 1.7));
        joints.add(new PinJoint(bodies.get(2), bodies.get(3), 3.2, 0.4));
        joints.add(Limit.angle(bodies.get(0), held, -1, 1));
        joints.add(Motor.turning(bodies.get(3), bodies.get(0), 2, 10));
        joints.add(Motor.sliding(new SliderJoint(bodies.get(1), bodies.get(3), 2, 0.3, 1, -0.4), 1, 3));
        joints.add(Limit.travel(new SliderJoint(bodies.get(2), held, 2, 0.5, 0.2, 1), -1, 1));
        joints.add(Limit.rope(bodies.get(0), 0, 0, bodies.get(3), 3.9, 0.3, 5));
        island = new Island(indices, joints);
        for (int k = 0; k < State.BLOCK * MOVABLE; k++) {
            state.x()[k] += random.nextDouble(-1, 1);
            state.v()[k] = random.nextDouble(-3, 3);
        }
    }

    private void turn(SplittableRandom random) {
        for (Constraint joint : joints) {
            if (joint instanceof Switched s) {
                s.isOnNow = random.nextBoolean();
            }
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void theyAreThoseOfTheJoints(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        build(random);
        turn(random);
        island.evaluate(state);
        for (int k = 0; k < State.BLOCK * MOVABLE; k++) {
            state.v()[k] = random.nextDouble(-3, 3); // the same place at other speeds
        }
        turn(random);
        island.evaluate(state);
        for (int k = 0; k < island.constraints.length; k++) {
            Equations expected = new Equations();
            island.constraints[k].evaluate(expected);
            for (int row = 0; row < island.constraints[k].getRows(); row++) {
                int p = island.firstNode[k] + row / 2;
                int slot = 2 * p + row % 2;
                String name = island.constraints[k] + ", row " + row;
                assertThat(island.c[slot]).as(name).isCloseTo(expected.c[row], within(1e-14));
                assertThat(island.rate[slot]).as(name).isCloseTo(expected.rate[row], within(1e-13));
                for (int c = 0; c < 6; c++) {
                    boolean isMovable = (c < 3 ? island.blockA[p] : island.blockB[p]) >= 0;
                    double entry = island.j[Island.J * p + 3 * (row % 2) + c % 3 + (c < 3 ? 0 : 6)];
                    double one = isMovable ? expected.jacobian(row, c) : 0;
                    assertThat(entry).as(name + ", column " + c).isCloseTo(one, within(1e-14));
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void whatIsSolvedSatisfiesThem(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        build(random);
        joints.removeIf(joint -> joint instanceof WeldJoint || joint instanceof PinJoint || joint instanceof SlotJoint); // fewer rows than freedoms
        IntList indices = island.bodies;
        island = new Island(indices, joints);
        turn(random);
        island.evaluate(state);
        double[] u = new double[state.x().length];
        for (int k = 0; k < State.BLOCK * MOVABLE; k++) {
            u[k] = random.nextDouble(-10, 10);
        }
        new DirectSolver().prepareAndCorrect(island, state.w().values(), u, island.rate);
        double[] left = new double[2 * island.nodes];
        island.residual(u, island.rate, left);
        double most = 0;
        for (int k = 0; k < island.lambda.length; k++) {
            most = Math.max(most, Math.abs(island.lambda[k]));
        }
        for (int k = 0; k < island.constraints.length; k++) {
            int p = island.firstNode[k];
            boolean isOff = island.constraints[k] instanceof Switched s && !s.isOnNow;
            assertThat(left[2 * p]).as("%s", island.constraints[k]).isCloseTo(0, within(1e-12 * (1 + most)));
            assertThat(island.lambda[2 * p] == 0).as("%s", island.constraints[k]).isEqualTo(isOff);
        }
    }
}
