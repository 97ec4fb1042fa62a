// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Loops, redundant supports and poses at which a mechanism is singular. */
class MechanismTest {
    private static final double START = StrictMath.PI / 2;

    /** A rod of mass 1 between two points. */
    private static Body rod(PhysicsEngine engine, double x0, double y0, double x1, double y1) {
        double length = StrictMath.hypot(x1 - x0, y1 - y0);
        Body rod = new Body(new Rectangle(length, 0.02));
        rod.at((x0 + x1) / 2, (y0 + y1) / 2, StrictMath.atan2(y1 - y0, x1 - x0));
        rod.setMass(1, length * length / 12);
        rod.setCollisionGroup(1, 0);
        return engine.add(rod);
    }

    /** N windows of rods in a row, upright, spinning clockwise: IFToMM's benchmark A02. Returns the uprights. */
    private static Body[] fourBars(PhysicsEngine engine, int n) {
        engine.add(new Gravity(0, -9.81));
        Body[] upright = new Body[n + 1];
        for (int k = 0; k <= n; k++) {
            upright[k] = rod(engine, k, 0, k, 1).moving(0.5, 0, -1);
            engine.add(new PinJoint(upright[k], k, 0));
        }
        for (int k = 0; k < n; k++) {
            Body coupler = rod(engine, k, 1, k + 1, 1).moving(1, 0);
            engine.add(new PinJoint(upright[k], coupler, k, 1));
            engine.add(new PinJoint(coupler, upright[k + 1], k + 1, 1));
        }
        return upright;
    }

    private static double turned(int steps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.9425149226070836835 / steps);
        Body[] upright = fourBars(engine, 2);
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
        return upright[0].getAngle() - START + 2 * StrictMath.PI;
    }

    @Test
    void fourBarsRevolveInTheirPeriodThroughTheirSingularPose() {
        double coarse = Math.abs(turned(125));
        double fine = Math.abs(turned(1000));
        assertThat(fine).isLessThan(1e-9);
        assertThat(StrictMath.log(coarse / fine) / StrictMath.log(8)).isBetween(3.8, 4.3);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 40})
    void theUprightsOfFourBarsStayParallelForTwentySeconds(int n) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        Body[] upright = fourBars(engine, n);
        for (int k = 0; k < 2000; k++) {
            engine.step();
        }
        assertThat(upright[0].getAngle()).isLessThan(START - 9 * 2 * StrictMath.PI);
        for (Body other : upright) {
            assertThat(other.getAngle()).isCloseTo(upright[0].getAngle(), within(1e-11));
        }
    }

    @Test
    void peaucelliersLinkageDrawsAStraightLine() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        engine.add(new Gravity(0, -1));
        double p = 0.7;
        double arm = 2.5;
        double side = 2;
        double angle = 0.6;
        double oa = 2 * p * StrictMath.cos(angle);
        double oc = (arm * arm - side * side) / oa;
        double half = (oc - oa) / 2;
        double away = StrictMath.sqrt(side * side - half * half);
        double ux = StrictMath.cos(angle);
        double uy = StrictMath.sin(angle);
        Body a = point(engine, oa * ux, oa * uy);
        Body c = point(engine, oc * ux, oc * uy);
        Body b = point(engine, (oa + half) * ux - away * uy, (oa + half) * uy + away * ux);
        Body d = point(engine, (oa + half) * ux + away * uy, (oa + half) * uy - away * ux);
        Body[][] bars = {{b, null}, {d, null}, {a, b}, {a, d}, {c, b}, {c, d}};
        for (Body[] bar : bars) {
            double x = bar[1] == null ? 0 : bar[1].getX();
            double y = bar[1] == null ? 0 : bar[1].getY();
            engine.add(new RodJoint(bar[0], bar[0].getX(), bar[0].getY(), bar[1], x, y));
        }
        engine.add(new RodJoint(a, a.getX(), a.getY(), null, p, 0));
        double line = (arm * arm - side * side) / (2 * p);
        double lowest = c.getY();
        for (int k = 0; k < 350; k++) { // then the bars are stretched out, where the point is not well defined
            engine.step();
            assertThat(c.getX()).isCloseTo(line, within(1e-13 * line));
            lowest = Math.min(lowest, c.getY());
        }
        assertThat(lowest).isLessThan(-2);
    }

    private static Body point(PhysicsEngine engine, double x, double y) {
        Body body = engine.add(new Body(new Circle(0.1)).at(x, y));
        body.setCollisionGroup(1, 0);
        return body;
    }

    @Test
    void aGridThatCannotMoveDoesNotMove() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        engine.add(new Gravity(0, -9.81));
        int n = 8;
        Body[][] grid = new Body[n][n];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                grid[i][j] = point(engine, i, -j);
                if (i > 0) {
                    engine.add(new PinJoint(grid[i - 1][j], grid[i][j], i - 0.5, -j));
                }
                engine.add(
                        j == 0
                                ? new PinJoint(grid[i][0], i, 0.5)
                                : new PinJoint(grid[i][j - 1], grid[i][j], i, -j + 0.5));
            }
        }
        for (int k = 0; k < 200; k++) {
            engine.step();
        }
        assertThat(engine.getRedundantEquations()).isPositive();
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                assertThat(grid[i][j].getX()).isCloseTo(i, within(1e-12));
                assertThat(grid[i][j].getY()).isCloseTo(-j, within(1e-12));
            }
        }
    }
}
