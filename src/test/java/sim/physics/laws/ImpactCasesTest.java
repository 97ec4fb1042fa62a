// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;

/** Impacts that are hard to find or to decide: slots, pistons, grazing, corners, seams. */
class ImpactCasesTest {
    private final PhysicsEngine engine = new PhysicsEngine();

    @ParameterizedTest
    @CsvSource({"0, 1", "0.3, 1", "1, 1", "0, 1e12", "0.3, 1e12", "1, 1e12", "1, 1e-12", "0.3, 0"})
    void twoBodiesPartByNewtonsLaw(double e, double mass) {
        engine.setTimeStep(1);
        Body a = engine.add(new Body(new Circle(0.5)).at(-1, 0).moving(1, 0));
        a.setMass(1);
        a.setRestitution(e);
        Body b = mass == 0 ? Body.fixed(new Circle(0.5)).at(0.25, 0) : new Body(new Circle(0.5)).at(0.25, 0);
        if (mass > 0) {
            b.setMass(mass);
        }
        engine.add(b);
        engine.step();
        double share = mass == 0 ? 1 : mass / (1 + mass);
        double va = 1 - (1 + e) * share;
        double vb = mass == 0 ? 0 : (1 + e) / (1 + mass);
        assertThat(a.getVelocityX()).isCloseTo(va, within(4 * 0x1p-52));
        assertThat(b.getVelocityX()).isCloseTo(vb, within(4 * 0x1p-52));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0x1p-10, 0x1p-20, 0x1p-30, 0x1p-40})
    void aDiscRattlesInASlot(double clearance) {
        engine.setTimeStep(100 * clearance);
        engine.add(Body.fixed(new Rectangle(16, 1)).at(0, 1 + clearance / 2));
        engine.add(Body.fixed(new Rectangle(16, 1)).at(0, -1 - clearance / 2));
        Body disc = engine.add(new Body(new Circle(0.5)).moving(0.25, 1));
        double most = 0;
        for (int k = 0; k < 50; k++) {
            engine.step();
            most = Math.max(most, Math.abs(disc.getY()) - clearance / 2);
        }
        double travelled = 5000 * clearance;
        assertThat(engine.getImpacts()).isEqualTo(5000);
        assertThat(most).isLessThan(0x1p-52);
        assertThat(Math.abs(disc.getVelocityY())).isEqualTo(1);
    }

    /** A ball between a piston that falls and the floor: ever more impacts, and the energy of both stays. */
    @ParameterizedTest
    @ValueSource(doubles = {10, 100, 1e4})
    void aPistonBouncesOnABall(double mass) {
        engine.setTimeStep(0.25);
        engine.add(new Gravity(0, -1));
        engine.add(Body.fixed(new Rectangle(10, 1)).at(0, -0.5));
        Body ball = engine.add(new Body(new Circle(0.125)).at(0, 1.125).moving(0, 1));
        ball.setMass(1);
        Body piston = engine.add(new Body(new Rectangle(4, 0.5)).at(0, 3));
        piston.setMass(mass);
        double before = 0.5 + 1.125 + mass * 3;
        double most = 0;
        for (int k = 0; k < 80; k++) {
            engine.step();
            double energy = engine.kineticEnergy() + ball.getY() + mass * piston.getY();
            most = Math.max(most, Math.abs(energy / before - 1));
            assertThat(ball.getY()).isGreaterThan(0.125 - 1e-12);
            assertThat(piston.getY()).isGreaterThan(ball.getY() + 0.375 - 1e-12);
        }
        assertThat(most).isLessThan(1e-12);
        assertThat(engine.getImpacts()).isBetween(40L, 10_000L);
    }

    private static boolean hits(Body still, Body moving) {
        PhysicsEngine run = new PhysicsEngine();
        run.setTimeStep(0.5);
        run.add(still);
        run.add(moving);
        for (int k = 0; k < 8; k++) {
            run.step();
        }
        return moving.getVelocityY() != 0;
    }

    /** A disc past a disc, a disc past a corner and along an edge, a tip over a floor. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-14, 1e-12, 1e-9, 1e-6, 1e-3})
    void whoPassesAndWhoGrazesIsDecidedRight(double miss) {
        for (int sign = -1; sign <= 1; sign += 2) {
            double off = sign * miss;
            Body disc = new Body(new Circle(0.5)).at(-1.75, 1 + off).moving(1, 0);
            assertThat(hits(Body.fixed(new Circle(0.5)), disc)).as("disc").isEqualTo(sign < 0);
            Body second = new Body(new Circle(0.5)).at(-2, 0.5 + off).moving(1, 0);
            assertThat(hits(Body.fixed(new Rectangle(2, 1)).at(0, -0.5), second)).as("corner").isEqualTo(sign < 0);
            Body turning = new Body(Polygon.regular(4, 1)).at(0, off, 0.5).moving(0, 0, -1);
            assertThat(hits(Body.fixed(new Rectangle(2, 1)).at(0, -1.5), turning)).as("tip").isEqualTo(sign < 0);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-12, -1e-12, 1e-6, 0.1})
    void squaresMeetCornerToCorner(double offset) {
        engine.setTimeStep(0.25);
        Body a = engine.add(new Body(new Rectangle(1, 1)).at(-1, 0, StrictMath.PI / 4).moving(1, 0));
        Body b = engine.add(new Body(new Rectangle(1, 1)).at(1, offset, StrictMath.PI / 4).moving(-1, 0));
        double before = engine.kineticEnergy();
        for (int k = 0; k < 8; k++) {
            engine.step();
        }
        double e = engine.kineticEnergy() / before - 1;
        double spin = Math.abs(a.getAngularVelocity());
        assertThat(engine.getImpacts()).isPositive();
        assertThat(e).isCloseTo(0, within(1e-14));
        assertThat(a.getVelocityX() + b.getVelocityX()).isCloseTo(0, within(1e-15));
        assertThat(a.getVelocityY() + b.getVelocityY()).isCloseTo(0, within(1e-15));
    }

    /** Without gravity: a box that slides along flush tiles. */
    private void slide(double x, double gap, double down, double width) {
        engine.setTimeStep(1);
        for (int k = 0; k < 410 / width; k++) {
            engine.add(Body.fixed(new Rectangle(width, 0.5)).at(width * k, -0.25));
        }
        Body box = engine.add(new Body(new Rectangle(1, 1)).at(x, 0.5 + gap).moving(1, down));
        for (int k = 0; k < 400; k++) {
            engine.step();
        }
        assertThat(box.getVelocityX()).isCloseTo(1, within(1e-12));
        assertThat(box.getAngularVelocity()).isCloseTo(0, within(1e-12));
        assertThat(box.getVelocityY()).isCloseTo(-down, within(1e-12));
    }

    @ParameterizedTest
    @CsvSource({"1e-12, 0", "0, -0.001"})
    void aBoxFeelsNoSeam(double gap, double down) {
        slide(1, gap, down, 0.5);
    }

    /** Its corner meets the next tile's corner; the tile ahead would stop it, were it any higher. */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.3, 0.5, 0.7})
    void aBoxThatTouchesFeelsNoSeam(double width) {
        slide(1, 0, 0, width);
        assertThat(engine.getImpacts()).isZero();
    }

    @ParameterizedTest
    @CsvSource({"1, 1, -0.01", "0.9, 1, -0.01", "1.1, 0.5, -0.003", "1.03, 0.125, -0.001"})
    void aBoxThatLandsFlushOnTilesDoesNotTurn(double x, double gap, double down) {
        slide(x, gap, down, 0.5);
        assertThat(engine.getImpacts()).isPositive();
    }

    /** Under gravity it slides on as over one floor, with friction on the parabola of a block that friction brakes. */
    @ParameterizedTest
    @CsvSource({
        "0.3, 0, 0.0125", "0.7, 0, 0.0125", "1, 0, 0.01", "2.1, 0, 0.0125", "0.3, 0.2, 0.0125", "0.5, 0.2, 0.0125",
        "1, 0.2, 0.01", "1.3, 0.2, 0.0125", "3.7, 0.2, 0.01"
    })
    void aBoxThatLiesOnTilesFeelsNoSeam(double width, double friction, double step) {
        engine.setTimeStep(step);
        engine.add(new Gravity(0, -10));
        for (int k = -3; k < 10 / width; k++) {
            Body tile = engine.add(Body.fixed(new Rectangle(width, 0.5)).at(width * k, -0.25));
            tile.setFriction(friction);
            tile.setRestitution(0);
        }
        Body box = engine.add(new Body(new Rectangle(1, 1)).at(0.1, 0.5).moving(4, 0));
        box.setFriction(friction);
        box.setRestitution(0);
        while (engine.getTime() < 1.5) {
            engine.step();
            double t = engine.getTime();
            assertThat(box.getVelocityX()).isCloseTo(4 - 10 * friction * t, within(1e-12));
            assertThat(box.getX()).isCloseTo(0.1 + 4 * t - 5 * friction * t * t, within(1e-8));
            assertThat(box.getVelocityY()).isCloseTo(0, within(1e-12));
            assertThat(box.getY()).isCloseTo(0.5, within(1e-13));
            assertThat(box.getAngularVelocity()).isCloseTo(0, within(1e-12));
        }
    }

    /** One that is put on a grid meets the next tile corner to corner, before it has come to rest on its own one. It was stopped. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 0.1, 2, 30, -2})
    void aBoxThatIsPutOnAGridFeelsNoSeam(double speed) {
        for (double width : new double[] {0.25, 0.5, 1, 2}) {
            for (int quarter = 0; quarter < 4; quarter++) {
                PhysicsEngine grid = new PhysicsEngine();
                grid.setTimeStep(1.0 / 60);
                grid.add(new Gravity(0, -10));
                for (int k = -40; k < 40; k++) {
                    grid.add(Body.fixed(new Rectangle(1, 1)).at(k + 0.5, -0.5)).setRestitution(0);
                }
                Body box = grid.add(new Body(new Rectangle(width, 0.5)).at(width / 2 + quarter / 4.0, 0.25).moving(speed, 0));
                box.setRestitution(0);
                for (int k = 0; k < 60; k++) {
                    grid.step();
                    assertThat(box.getVelocityX()).as("width " + width + ", quarter " + quarter).isCloseTo(speed, within(1e-12));
                    assertThat(box.getY()).isCloseTo(0.25, within(1e-9));
                }
            }
        }
    }

    /** So does a stack, at the distance at which bodies of a heap lie. */
    @ParameterizedTest
    @ValueSource(doubles = {0.3, 1, 2.1})
    void aStackFeelsNoSeam(double width) {
        engine.setTimeStep(1.0 / 60);
        engine.add(new Gravity(0, -9.81));
        for (int k = -3; k < 10 / width; k++) {
            engine.add(Body.fixed(new Rectangle(width, 0.5)).at(width * k, -0.25)).setRestitution(0);
        }
        Body below = engine.add(new Body(new Rectangle(1, 1)).at(0.1, 0.5).moving(4, 0));
        Body above = engine.add(new Body(new Rectangle(0.8, 0.5)).at(0.15, 1.25).moving(4, 0));
        below.setRestitution(0);
        above.setRestitution(0);
        for (int k = 0; k < 90; k++) {
            engine.step();
            assertThat(below.getY()).isCloseTo(0.5, within(1e-9));
            assertThat(below.getVelocityY()).isCloseTo(0, within(1e-7));
            assertThat(below.getVelocityX()).isCloseTo(4, within(1e-12));
            assertThat(above.getX() - below.getX()).isCloseTo(0.05, within(1e-12));
        }
    }

    /** A step of 10⁻⁶ of the box is one. */
    @Test
    void aTileThatStandsOutStopsABox() {
        engine.setTimeStep(1);
        engine.add(Body.fixed(new Rectangle(1, 1)).at(2, -0.5 + 1e-6));
        Body box = engine.add(new Body(new Rectangle(1, 1)).at(0, 0.5).moving(1, 0));
        engine.step();
        engine.step();
        assertThat(engine.getImpacts()).isPositive();
        assertThat(box.getVelocityX()).isLessThan(0.9);
    }

    @Test
    void bulletsAreNeverMissed() {
        engine.setTimeStep(1);
        engine.add(Body.fixed(new Rectangle(1e-6, 2)));
        Body bullet = engine.add(new Body(new Rectangle(0.01, 0.005)).at(-40, 0, 0.3).moving(100, 0, 50));
        Body left = engine.add(new Body(new Circle(0.005)).at(-40, 5).moving(100, 0));
        Body right = engine.add(new Body(new Circle(0.005)).at(40, 5).moving(-100, 0));
        engine.step();
        assertThat(bullet.getX()).isNegative();
        assertThat(left.getX()).isCloseTo(-0.005 - (100 - 39.995), within(1e-12));
        assertThat(right.getX()).isCloseTo(0.005 + (100 - 39.995), within(1e-12));
    }
}
