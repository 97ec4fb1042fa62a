// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * Time stepping: rows and racks of discs that touch and rub, struck by another one. A wave goes through them, as if each pair collided alone, one after the
 * other. With friction, on a plane that rubs, or where forces acted they bounced as one, and what struck came back at three quarters of its speed.
 */
class SteppedRackTest {
    private static final double R = 0.5;
    private static final double SPEED = 10;

    /** Centres: the disc that strikes, a little off the axis, and a row or a triangle that touches. */
    private static double[][] places(int rows, boolean isRack, double off, double gap) {
        double[][] all = new double[1 + (isRack ? rows * (rows + 1) / 2 : rows)][];
        all[0] = new double[] {-3, off};
        double way = 2 * R + gap;
        for (int i = 0, n = 1; i < rows; i++) {
            for (int j = 0; j <= (isRack ? i : 0); j++) {
                all[n++] = isRack ? new double[] {StrictMath.sqrt(0.75) * way * i, way * (j - 0.5 * i)} : new double[] {way * i, 0};
            }
        }
        return all;
    }

    private static Body[] discs(PhysicsEngine engine, double[][] places, double restitution, double friction) {
        Body[] all = new Body[places.length];
        for (int k = 0; k < all.length; k++) {
            all[k] = new Body(new Circle(R)).at(places[k][0], places[k][1]);
            all[k].setMass(1);
            all[k].setRestitution(restitution);
            all[k].setFriction(friction);
        }
        all[0].moving(SPEED, 0);
        for (Body body : all) {
            engine.add(body);
        }
        return all;
    }

    /** Velocities and spins after all collisions, pair after pair in the order of time: Newton's law, and Coulomb's. */
    private static double[][] inTurn(double[][] x, double restitution, double friction) {
        double[][] v = new double[x.length][3];
        v[0][0] = SPEED;
        double time = next(x, v, null);
        while (time < 1) {
            int[] pair = new int[2];
            time = next(x, v, pair);
            for (int k = 0; k < x.length; k++) {
                x[k][0] += StrictMath.min(time, 1) * v[k][0];
                x[k][1] += StrictMath.min(time, 1) * v[k][1];
            }
            if (time < 1) {
                collide(x[pair[0]], x[pair[1]], v[pair[0]], v[pair[1]], restitution, friction);
            }
        }
        return v;
    }

    private static double next(double[][] x, double[][] v, int[] pair) {
        double first = Double.POSITIVE_INFINITY;
        for (int i = 0; i < x.length; i++) {
            for (int j = 0; j < i; j++) {
                double dx = x[i][0] - x[j][0];
                double dy = x[i][1] - x[j][1];
                double ux = v[i][0] - v[j][0];
                double uy = v[i][1] - v[j][1];
                double b = dx * ux + dy * uy;
                double c = dx * dx + dy * dy - 4 * R * R;
                double root = b * b - (ux * ux + uy * uy) * c;
                if (b < -1e-13 && root > 0) {
                    double time = StrictMath.max(0, c / (StrictMath.sqrt(root) - b));
                    if (time < first) {
                        first = time;
                        if (pair != null) {
                            pair[0] = i;
                            pair[1] = j;
                        }
                    }
                }
            }
        }
        return first;
    }

    private static void collide(double[] x, double[] y, double[] v, double[] u, double restitution, double friction) {
        double way = StrictMath.hypot(y[0] - x[0], y[1] - x[1]);
        double nx = (y[0] - x[0]) / way;
        double ny = (y[1] - x[1]) / way;
        double normal = -0.5 * (1 + restitution) * (nx * (u[0] - v[0]) + ny * (u[1] - v[1]));
        double slip = nx * (u[1] - v[1]) - ny * (u[0] - v[0]) - R * (u[2] + v[2]);
        double tangent = StrictMath.max(-friction * normal, StrictMath.min(friction * normal, -slip / 6)); // 2 / m + 2 R² / I = 6 / m
        for (int k = 0; k < 2; k++) {
            double[] w = k == 0 ? v : u;
            w[0] += (2 * k - 1) * (nx * normal - ny * tangent);
            w[1] += (2 * k - 1) * (ny * normal + nx * tangent);
            w[2] -= tangent / (0.5 * R);
        }
    }

    /** A row is a chain of collisions of two. All but the last disc left with a third of the speed together. */
    @ParameterizedTest
    @CsvSource({"1, 0.05, 0.1, 4", "1, 0.5, 0.1, 1", "0.95, 0.05, 0.1, 4", "0.95, 0.05, 0, 4", "0.95, 0.5, 0.3, 2", "0.5, 0.05, 0.1, 4"})
    void aRowOfDiscsThatRubPassesTheBlowOn(double restitution, double friction, double off, int substeps) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
        Body[] row = discs(engine, places(5, false, off, 0), restitution, friction);
        double[][] right = inTurn(places(5, false, off, 1e-9), restitution, friction);
        double[] before = Stepped.momentum(engine);
        Stepped.run(engine, 60);
        for (int k = 0; k < row.length; k++) {
            assertThat(row[k].getVelocityX()).as("disc %d", k).isCloseTo(right[k][0], within(1e-6));
            assertThat(row[k].getVelocityY()).as("disc %d", k).isCloseTo(right[k][1], within(1e-6));
            assertThat(row[k].getAngularVelocity()).as("disc %d", k).isCloseTo(right[k][2], within(1e-6));
        }
        assertThat(Stepped.momentum(engine)).containsExactly(before, within(1e-11));
    }

    /** The break: discs that are struck at once are not those that are struck in turn, but near them. It came back at 7.2. */
    @ParameterizedTest
    @CsvSource({"0.95, 0.05", "0.95, 0.1", "1, 0.05", "0.8, 0.1"})
    void theBreakOfARack(double restitution, double friction) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        Body[] all = discs(engine, places(5, true, 0.1, 0), restitution, friction);
        double[] before = Stepped.momentum(engine);
        double energy = engine.kineticEnergy();
        double[][] right = inTurn(places(5, true, 0.1, 1e-9), restitution, friction);
        Stepped.run(engine, 30);
        assertThat(all[0].getVelocityX()).isCloseTo(right[0][0], within(0.9));
        assertThat(all[0].getVelocityY()).isCloseTo(right[0][1], within(0.4));
        assertThat(Stepped.momentum(engine)).containsExactly(before, within(1e-11));
        assertThat(engine.kineticEnergy()).isLessThan(energy);
    }

    /** A rack that is struck along its axis goes apart to both sides alike. */
    @ParameterizedTest
    @ValueSource(doubles = {0.95, 1})
    void aRackGoesApartToBothSidesAlike(double restitution) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        Body[] all = discs(engine, places(5, true, 0, 0), restitution, 0.1);
        Stepped.run(engine, 30);
        assertThat(all[0].getVelocityY()).isCloseTo(0, within(1e-9));
        for (int i = 0, n = 1; i < 5; n += ++i) {
            for (int j = 0; j <= i; j++) {
                assertThat(all[n + j].getVelocityX()).isCloseTo(all[n + i - j].getVelocityX(), within(1e-9));
                assertThat(all[n + j].getVelocityY()).isCloseTo(-all[n + i - j].getVelocityY(), within(1e-9));
                assertThat(all[n + j].getAngularVelocity()).isCloseTo(-all[n + i - j].getAngularVelocity(), within(1e-9));
            }
        }
    }

    /** On a plane that rubs, what strikes a row stops dead, and the last disc goes on: v² falls by 2 μ g s on the way. It was thrown back at 6.5. */
    @ParameterizedTest
    @CsvSource({"0, 4", "0.05, 4", "0.05, 1"})
    void aRowOnAPlaneThatRubs(double friction, int substeps) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
        engine.add(new SurfaceFriction(Stepped.G));
        Body[] row = discs(engine, places(5, false, 0, 0), 1, friction);
        for (Body body : row) {
            body.setSurfaceFriction(0.05, 0.05);
        }
        Stepped.run(engine, 30);
        double way = row[0].getX() + 3 + row[5].getX() - 4;
        for (int k = 0; k < 5; k++) {
            assertThat(row[k].getVelocityX()).as("disc %d", k).isCloseTo(0, within(1e-9));
        }
        assertThat(row[0].getX()).isCloseTo(-1, within(1e-3));
        assertThat(row[5].getVelocityX()).isCloseTo(StrictMath.sqrt(SPEED * SPEED - 2 * 0.05 * Stepped.G * way), within(2e-3));
    }

    /** A row that falls freely is as one in no field. It lost a fifth of its energy, and what struck came back at 3.3. */
    @ParameterizedTest
    @ValueSource(doubles = {0.95, 1})
    void aRowInFreeFall(double restitution) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        engine.add(new Gravity(1, -2));
        Body[] row = discs(engine, places(5, false, 0.1, 0), restitution, 0.05);
        double[][] right = inTurn(places(5, false, 0.1, 1e-9), restitution, 0.05);
        Stepped.run(engine, 60);
        for (int k = 0; k < row.length; k++) {
            assertThat(row[k].getVelocityX() - 1).as("disc %d", k).isCloseTo(right[k][0], within(1e-6));
            assertThat(row[k].getVelocityY() + 2).as("disc %d", k).isCloseTo(right[k][1], within(1e-6));
        }
    }

    /** A row that lies on a floor, which bears it meanwhile. It bounced as one: what struck it came back at 6.3 to 6.7. */
    @ParameterizedTest
    @CsvSource({"1, 0, 4", "1, 1, 4", "0.95, 0, 1", "0.95, 0.95, 4", "0.5, 0, 4"})
    void aRowOnAFloor(double restitution, double ofFloor, int substeps) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
        engine.add(new Gravity(0, -Stepped.G));
        engine.add(Body.fixed(new Rectangle(100, 2)).at(0, -1 - R)).setRestitution(ofFloor);
        Body[] row = discs(engine, places(5, false, 0, 0), restitution, 0);
        double[][] right = inTurn(places(5, false, 0, 1e-9), restitution, 0);
        Stepped.run(engine, 30);
        for (int k = 0; k < row.length; k++) {
            assertThat(row[k].getVelocityX()).as("disc %d", k).isCloseTo(right[k][0], within(2e-3));
            assertThat(row[k].getVelocityY()).as("disc %d", k).isCloseTo(0, within(1e-3));
            assertThat(row[k].getY()).as("disc %d", k).isCloseTo(0, within(1e-3));
        }
    }

    /** A wave that goes on through gaps within a substep: a hammer on a row of boards. They were 0.06 to 0.2 deep in one another. */
    @ParameterizedTest
    @CsvSource({"1, 0, 0.02, 4", "0.9, 0.5, 0.02, 4", "0.9, 0, 0.05, 4", "0.5, 0, 0.02, 1"})
    void aWaveGoesThroughGaps(double restitution, double friction, double gap, int substeps) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, substeps);
        Body hammer = engine.add(new Body(new Rectangle(1, 1)).at(-1, 0).moving(20, 0));
        double light = hammer.getMass() / 5;
        double first = 20;
        double passed = 20 * (1 + restitution) / (1 + light / hammer.getMass());
        for (int k = 0; k < 5; k++) {
            engine.add(new Body(new Rectangle(0.2, 1)).at(k * (0.2 + gap), 0));
            first = k == 0 ? passed : first * (1 + restitution) / 2;
        }
        for (Body body : engine.bodies()) {
            body.setRestitution(restitution);
            body.setFriction(friction);
        }
        double deepest = 0;
        for (int k = 0; k < 30; k++) {
            engine.step();
            for (Overlap overlap : engine.overlaps()) {
                deepest = StrictMath.max(deepest, overlap.depth());
            }
        }
        assertThat(deepest).isLessThan(1e-4);
        if (restitution > 0.5) {
            assertThat(engine.bodies().get(5).getVelocityX()).isCloseTo(first, within(1e-6));
        }
    }
}
