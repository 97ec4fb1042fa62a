// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** The same scene in other units, another place, another attitude, another order, or backwards, is the same scene. */
class InvarianceTest {
    private static final double EPSILON = 0x1p-52;

    /** How a scene is set up; the numbers of the plain one are the defaults. */
    private static final class Frame {
        private double length = 1;
        private double time = 1;
        private double x;
        private double y;
        private double turn;
        private double drift;
        private boolean isMirrored;
        private int[] order;

        private final PhysicsEngine engine = new PhysicsEngine();

        private Body place(Body body, double px, double py, double angle, double vx, double vy, double omega) {
            double side = isMirrored ? -1 : 1;
            double cos = turn == 0 ? 1 : StrictMath.cos(turn);
            double sin = turn == 0 ? 0 : StrictMath.sin(turn);
            double mx = side * px;
            double mv = side * vx;
            body.at(x + length * (cos * mx - sin * py), y + length * (sin * mx + cos * py), side * angle + turn);
            double speed = length / time;
            return body.moving(
                    speed * (cos * mv - sin * vy) + drift, speed * (sin * mv + cos * vy), side * omega / time);
        }

        /** Forgets the frame: x, y, angle, vx, vy, omega as they would be in the plain one. */
        private double[] plain(Body body) {
            double side = isMirrored ? -1 : 1;
            double cos = turn == 0 ? 1 : StrictMath.cos(turn);
            double sin = turn == 0 ? 0 : StrictMath.sin(turn);
            double px = (body.getX() - x - drift * engine.getTime()) / length;
            double py = (body.getY() - y) / length;
            double speed = length / time;
            double vx = (body.getVelocityX() - drift) / speed;
            double vy = body.getVelocityY() / speed;
            return new double[] {
                side * (cos * px + sin * py), cos * py - sin * px, side * (body.getAngle() - turn),
                side * (cos * vx + sin * vy), cos * vy - sin * vx, side * body.getAngularVelocity() * time
            };
        }
    }

    /** A chain of five rods that swings. */
    private static double[] chain(Frame f, int steps) {
        f.engine.setTimeStep(f.time / 128);
        double g = 9.81 * f.length / (f.time * f.time);
        f.engine.add(new Gravity(g * StrictMath.sin(f.turn), -g * (f.turn == 0 ? 1 : StrictMath.cos(f.turn))));
        Body last = null;
        for (int k = 0; k < 5; k++) {
            Body rod = new Body(new Rectangle(f.length, 0.125 * f.length));
            f.place(rod, k + 0.5, 0, 0, 0, 0, 0);
            rod.setCollisionGroup(1, 0);
            f.engine.add(rod);
            double side = f.isMirrored ? -1 : 1;
            f.engine.add(
                    last == null
                            ? new PinJoint(rod, -0.5 * side * f.length, 0, null, f.x, f.y)
                            : new PinJoint(last, 0.5 * side * f.length, 0, rod, -0.5 * side * f.length, 0));
            last = rod;
        }
        for (int k = 0; k < steps; k++) {
            f.engine.step();
        }
        return f.plain(last);
    }

    /** Elastic discs and boxes in a box, or without walls. */
    private static double[][] gas(Frame f, int steps, boolean walls) {
        f.engine.setTimeStep(f.time / 16);
        int n = 16;
        SplittableRandom random = new SplittableRandom(7);
        Body[] bodies = new Body[n];
        double[][] pose = new double[n][];
        for (int k = 0; k < n; k++) {
            bodies[k] = new Body(k % 2 == 0 ? new Circle(0.5 * f.length) : new Rectangle(f.length, 0.5 * f.length));
            pose[k] = new double[] {
                2 * (k % 4) - 3, 2 * (k / 4) - 3, k % 2 == 0 ? 0 : random.nextDouble(-1, 1), random.nextDouble(-1, 1),
                random.nextDouble(-1, 1), random.nextDouble(-1, 1)
            };
        }
        if (walls) {
            for (int side = -1; side <= 1; side += 2) {
                f.engine.add(f.place(Body.fixed(new Rectangle(12 * f.length, f.length)), 0, 4.5 * side, 0, 0, 0, 0));
                f.engine.add(f.place(Body.fixed(new Rectangle(f.length, 12 * f.length)), 4.5 * side, 0, 0, 0, 0, 0));
            }
        }
        for (int m = 0; m < n; m++) {
            int k = f.order == null ? m : f.order[m];
            f.engine.add(f.place(bodies[k], pose[k][0], pose[k][1], pose[k][2], pose[k][3], pose[k][4], pose[k][5]));
        }
        for (int k = 0; k < steps; k++) {
            f.engine.step();
        }
        double[][] end = new double[n][];
        for (int k = 0; k < n; k++) {
            end[k] = f.plain(bodies[k]);
        }
        assertThat(f.engine.getImpacts()).isGreaterThan(walls ? 5 : 1);
        return end;
    }

    private static double distance(double[] a, double[] b) {
        double most = 0;
        for (int k = 0; k < a.length; k++) {
            most = Math.max(most, Math.abs(a[k] - b[k]));
        }
        return most;
    }

    private static double distance(double[][] a, double[][] b) {
        double most = 0;
        for (int k = 0; k < a.length; k++) {
            most = Math.max(most, distance(a[k], b[k]));
        }
        return most;
    }

    @ParameterizedTest
    @CsvSource({"20, 0", "-20, 0", "0, 10", "4, 2", "20, -7"})
    void powersOfTwoAsUnitsChangeNoBit(int length, int time) {
        Frame f = new Frame();
        f.length = StrictMath.scalb(1.0, length);
        f.time = StrictMath.scalb(1.0, time);
        assertThat(chain(f, 256)).isEqualTo(chain(new Frame(), 256));
        Frame g = new Frame();
        g.length = f.length;
        g.time = f.time;
        assertThat(gas(g, 200, true)).isDeepEqualTo(gas(new Frame(), 200, true));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e6, 1e-6, 0.3048})
    void otherUnitsChangeRoundingOnly(double length) {
        Frame f = new Frame();
        f.length = length;
        double e = distance(chain(f, 128), chain(new Frame(), 128));
        Frame g = new Frame();
        g.length = length;
        double eg = distance(gas(g, 60, true), gas(new Frame(), 60, true));
        assertThat(e).isLessThan(1e-12);
        assertThat(eg).isLessThan(1e-10);
    }

    @Test
    void aMirrorImageHasMirroredBits() {
        Frame f = new Frame();
        f.isMirrored = true;
        assertThat(chain(f, 256)).isEqualTo(chain(new Frame(), 256));
        Frame g = new Frame();
        g.isMirrored = true;
        double e = distance(gas(g, 100, true), gas(new Frame(), 100, true));
        assertThat(e).isZero();
    }

    @Test
    void aTurnedSceneIsTurned() {
        Frame f = new Frame();
        f.turn = 0.7;
        double e = distance(chain(f, 128), chain(new Frame(), 128));
        Frame g = new Frame();
        g.turn = 0.7;
        double eg = distance(gas(g, 60, true), gas(new Frame(), 60, true));
        assertThat(e).isLessThan(1e-12);
        assertThat(eg).isLessThan(1e-10);
    }

    @Test
    void aMovingSceneMoves() {
        Frame f = new Frame();
        f.drift = 3;
        double e = distance(gas(f, 40, false), gas(new Frame(), 40, false));
        assertThat(e).isLessThan(1e-11);
    }

    @Test
    void aSceneThatStartsLaterIsTheSame() {
        Frame late = new Frame();
        late.engine.setTimeStep(1 / 16.0);
        for (int k = 0; k < 1_000_000; k++) {
            late.engine.step();
        }
        assertThat(gas(late, 100, true)).isDeepEqualTo(gas(new Frame(), 100, true));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0x1p20, 0x1p30, 0x1p40})
    void farFromTheOriginOnlyTheRoundingOfPlacesGrows(double far) {
        Frame f = new Frame();
        f.x = far;
        f.y = -far;
        double[] a = chain(f, 128);
        double[] b = chain(new Frame(), 128);
        Frame g = new Frame();
        g.x = far;
        g.y = far;
        double[][] c = gas(g, 60, true);
        double[][] d = gas(new Frame(), 60, true);
        double velocity = 0;
        for (int k = 3; k < 6; k++) {
            velocity = Math.max(velocity, Math.abs(a[k] - b[k]));
        }
        assertThat(distance(a, b)).isLessThan(100 * EPSILON * far);
        assertThat(distance(c, d)).isLessThan(1e5 * EPSILON * far);
    }

    @Test
    void theOrderOfBodiesDoesNotMatter() {
        Frame f = new Frame();
        f.order = new int[] {5, 0, 15, 3, 9, 12, 1, 7, 2, 14, 4, 11, 6, 13, 10, 8};
        double e = distance(gas(f, 100, true), gas(new Frame(), 100, true));
        assertThat(e).isLessThan(1e-11);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theOrderOfBallsOnATableDoesNotMatter(boolean touching) {
        double[][][] end = new double[2][][];
        for (int way = 0; way < 2; way++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(0.125);
            Body[] balls = new Body[16];
            double gap = touching ? 0 : 1e-6;
            balls[0] = new Body(new Circle(0.5)).at(-5, 0).moving(4, 0);
            for (int row = 0, k = 1; row < 5; row++) {
                for (int m = 0; m <= row; m++) {
                    balls[k++] = new Body(new Circle(0.5))
                            .at(row * (1 + gap) * StrictMath.sqrt(0.75), (m - 0.5 * row) * (1 + gap));
                }
            }
            for (int k = 0; k < 16; k++) {
                engine.add(balls[way == 0 ? k : (7 * k + 3) % 16]);
            }
            for (int k = 0; k < 40; k++) {
                engine.step();
            }
            end[way] = new double[16][];
            for (int k = 0; k < 16; k++) {
                end[way][k] = new double[] {balls[k].getX(), balls[k].getY(), balls[k].getVelocityX(), balls[k].getVelocityY()};
            }
        }
        double sym = 0;
        for (int row = 0, k = 1; row < 5; row++) {
            for (int m = 0; m <= row; m++, k++) {
                int other = k + row - 2 * m;
                sym = Math.max(sym, Math.abs(end[0][k][2] - end[0][other][2]) + Math.abs(end[0][k][3] + end[0][other][3]));
            }
        }
        assertThat(distance(end[0], end[1])).isZero();
        assertThat(sym).isLessThan(1e-13);
    }

    @Test
    void aGasGoesBackTheWayItCame() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.25);
        SplittableRandom random = new SplittableRandom(3);
        Body[] discs = new Body[9];
        for (int side = -1; side <= 1; side += 2) {
            engine.add(Body.fixed(new Rectangle(14, 1)).at(0, 5.5 * side));
            engine.add(Body.fixed(new Rectangle(1, 14)).at(5.5 * side, 0));
        }
        double[][] start = new double[9][];
        for (int k = 0; k < 9; k++) {
            discs[k] = engine.add(new Body(new Circle(0.5)).at(3 * (k % 3) - 3, 3 * (k / 3) - 3));
            discs[k].moving(random.nextDouble(-1, 1), random.nextDouble(-1, 1));
            start[k] = new double[] {discs[k].getX(), discs[k].getY(), -discs[k].getVelocityX(), -discs[k].getVelocityY()};
        }
        for (int k = 0; k < 40; k++) {
            engine.step();
        }
        long impacts = engine.getImpacts();
        for (Body disc : discs) {
            disc.setVelocity(-disc.getVelocityX(), -disc.getVelocityY());
        }
        for (int k = 0; k < 40; k++) {
            engine.step();
        }
        double e = 0;
        for (int k = 0; k < 9; k++) {
            e = Math.max(e, distance(start[k], new double[] {discs[k].getX(), discs[k].getY(), discs[k].getVelocityX(), discs[k].getVelocityY()}));
        }
        assertThat(engine.getImpacts()).isEqualTo(2 * impacts);
        assertThat(impacts).isGreaterThan(15);
        assertThat(e).isLessThan(1e-9);
    }

    @Test
    void aChainGoesBackTheWayItCame() {
        Frame f = new Frame();
        f.engine.setIntegrator(new DormandPrince853(1e-11));
        chain(f, 128);
        for (Body body : f.engine.bodies()) {
            body.moving(-body.getVelocityX(), -body.getVelocityY(), -body.getAngularVelocity());
        }
        for (int k = 0; k < 128; k++) {
            f.engine.step();
        }
        double most = 0;
        for (int k = 0; k < 5; k++) {
            Body rod = f.engine.bodies().get(k);
            most = Math.max(most, distance(f.plain(rod), new double[] {k + 0.5, 0, 0, 0, 0, 0}));
        }
        assertThat(most).isLessThan(1e-9);
    }

    /** Dust of a millionth falls on a planet of a million. */
    @Test
    void dustAndAPlanetMeet() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.5);
        engine.add(Body.fixed(new Circle(1e6)).at(0, -1e6));
        Body[] dust = new Body[1000];
        for (int k = 0; k < 1000; k++) {
            dust[k] = engine.add(new Body(new Circle(1e-6)).at(1e-3 * (k - 500), 1 + 1e-5 * k).moving(0, -1));
        }
        long before = engine.getNarrowPhaseEvaluations();
        for (int k = 0; k < 6; k++) {
            engine.step();
        }
        double e = 0;
        for (int k = 0; k < 1000; k++) {
            double x = 1e-3 * (k - 500);
            double surface = -x * x / 2e6 + 1e-6;
            double exact = 3 - (1 + 1e-5 * k) + 2 * surface;
            e = Math.max(e, Math.abs(dust[k].getY() - exact));
        }
        assertThat(engine.getImpacts()).isEqualTo(1000);
        assertThat(e).isLessThan(1e-9);
    }
}
