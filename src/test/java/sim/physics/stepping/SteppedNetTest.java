// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sim.physics.stepping.Frames.G;
import static sim.physics.stepping.Frames.falling;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping: nets and trusses of rods between small discs, and plates of welded boxes, are solved at once. In turns, their rods were a hundredth too long. */
class SteppedNetTest {
    private static final double LENGTH = 0.2;
    private static final double RADIUS = 0.04;

    private final PhysicsEngine engine = falling();
    private final List<RodJoint> rods = new ArrayList<>();

    private Body disc(int column, int row, boolean isFixed) {
        Body disc = Stepped.rough(isFixed ? Body.fixed(new Circle(RADIUS)) : new Body(new Circle(RADIUS)));
        if (!isFixed) {
            disc.setMass(0.1);
        }
        disc.setCollisionGroup(1, 2);
        return engine.add(disc.at(column * LENGTH, -row * LENGTH));
    }

    private void rod(Body a, Body b) {
        if (!a.isFixed() || !b.isFixed()) {
            rods.add(engine.add(RodJoint.bodyPoints(a, 0, 0, b, 0, 0)));
        }
    }

    private double longest() {
        double most = 0;
        for (RodJoint rod : rods) {
            Body a = rod.getBodyA();
            Body b = rod.getBodyB();
            most = Math.max(most, Math.abs(Math.hypot(a.getX() - b.getX(), a.getY() - b.getY()) / rod.getLength() - 1));
        }
        return most;
    }

    private double energy() {
        double energy = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            energy += body.isFixed() ? 0 : body.getMass() * G * body.getY();
        }
        return energy;
    }

    /** All that hangs from a row of fixed discs by rods of one length swings like a chain of as many links, wherever it is: what is beside one another has one velocity. */
    @ParameterizedTest
    @ValueSource(ints = {10, 20})
    void aCurtainSwingsLikeAChain(int size) {
        Body[][] discs = new Body[size][size];
        for (int column = 0; column < size; column++) {
            for (int row = 0; row < size; row++) {
                discs[column][row] = disc(column, row, row == 0);
                discs[column][row].setVelocity(1.0 * row / size, 0);
                if (column > 0) {
                    rod(discs[column - 1][row], discs[column][row]);
                }
                if (row > 0) {
                    rod(discs[column][row - 1], discs[column][row]);
                }
            }
        }
        double energy = energy();
        for (int k = 0; k < 240; k++) {
            engine.step();
            assertThat(longest()).isLessThan(1e-4);
            for (int row = 1; row < size; row++) {
                assertThat(discs[size - 1][row].getY()).isCloseTo(discs[0][row].getY(), within(1e-4 * LENGTH));
            }
        }
        double fall = size * size * 0.1 * G * size * LENGTH;
        assertThat(energy()).isCloseTo(energy, within(1e-4 * fall));
    }

    /** A truss between two walls, under a hundred times the weight of a disc, stays where its rods put it; its discs may turn, so its rods are as many as their ways. */
    @ParameterizedTest
    @CsvSource({"6, 0.2", "6, 0", "10, 0"})
    void aTrussBearsABox(int columns, double fall) {
        Body[] upper = new Body[columns];
        Body[] lower = new Body[columns];
        for (int k = 0; k < columns; k++) {
            boolean isEnd = k == 0 || k == columns - 1;
            upper[k] = disc(k, 0, isEnd);
            lower[k] = disc(k, 1, isEnd);
            rod(upper[k], lower[k]);
            if (k > 0) {
                rod(upper[k - 1], upper[k]);
                rod(lower[k - 1], lower[k]);
                rod(upper[k - 1], lower[k]);
            }
        }
        Body box = Stepped.rough(new Body(new Rectangle(3 * LENGTH, 0.3)));
        box.setMass(10);
        box.setCollisionGroup(2, 1);
        engine.add(box.at((columns - 1) * LENGTH / 2, 0.15 + RADIUS + fall));
        Stepped.run(engine, 600);
        assertThat(longest()).isLessThan(1e-4);
        assertThat(box.getY() - 0.15 - RADIUS).isCloseTo(0, within(1e-4));
    }

    /** A square plate of boxes that welds hold to a wall is one body: it does not sag. */
    @Test
    void aWeldedPlateIsStraight() {
        int size = 16;
        Body[][] boxes = new Body[size][size];
        for (int column = 0; column < size; column++) {
            for (int row = 0; row < size; row++) {
                Body box = column == 0 ? Body.fixed(new Rectangle(LENGTH, LENGTH)) : new Body(new Rectangle(LENGTH, LENGTH));
                box.setCollisionGroup(1, 0);
                boxes[column][row] = engine.add(box.at(column * LENGTH, -row * LENGTH));
                if (column > 0) {
                    engine.add(new WeldJoint(boxes[column - 1][row], box, (column - 0.5) * LENGTH, -row * LENGTH));
                }
                if (column > 0 && row > 0) {
                    engine.add(new WeldJoint(boxes[column][row - 1], box, column * LENGTH, (0.5 - row) * LENGTH));
                }
            }
        }
        Stepped.run(engine, 300);
        for (Body[] column : boxes) {
            for (int row = 0; row < size; row++) {
                assertThat(column[row].getY()).isCloseTo(-row * LENGTH, within(1e-5));
            }
        }
    }
}
