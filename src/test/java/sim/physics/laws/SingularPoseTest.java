// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.function.DoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.Reaction;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.AdaptiveIntegrator;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.Rattle;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.Spring;
import sim.physics.references.EllipticPendulum;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Mechanisms that go through poses in which their joints are redundant, and some that stand in one. */
class SingularPoseTest {
    private static final double G = 9.81;

    /** A force of 1 downwards at the right end of a rod of length 1. */
    private static final class Load implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final Body rod;

        Load(Body rod) {
            this.rod = rod;
        }

        @Override
        public boolean actsOn(Body body) {
            return body == rod;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            double cos = StrictMath.cos(body.getAngle());
            double sin = StrictMath.sin(body.getAngle());
            forces.addAt(body, 0, -1, body.getX() + 0.5 * cos, body.getY() + 0.5 * sin);
        }
    }

    private final PhysicsEngine engine = new PhysicsEngine();

    private Body rod(double x0, double y0, double x1, double y1) {
        double length = StrictMath.hypot(x1 - x0, y1 - y0);
        Body rod = new Body(new Rectangle(length, 0.02));
        rod.at((x0 + x1) / 2, (y0 + y1) / 2, StrictMath.atan2(y1 - y0, x1 - x0));
        rod.setMass(1, length * length / 12);
        rod.setCollisionGroup(1, 0);
        return engine.add(rod);
    }

    private double energy() {
        double sum = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            sum += body.getMass() * G * body.getY();
        }
        return sum;
    }

    /** N windows of rods in a row, upright, spinning clockwise: IFToMM's benchmark A02. All bars lie in line twice in a turn. */
    private Body fourBars(int n) {
        engine.add(new Gravity(0, -G));
        Body[] upright = new Body[n + 1];
        for (int k = 0; k <= n; k++) {
            upright[k] = rod(k, 0, k, 1).moving(0.5, 0, -1);
            engine.add(new PinJoint(upright[k], k, 0));
        }
        for (int k = 0; k < n; k++) {
            Body coupler = rod(k, 1, k + 1, 1).moving(1, 0);
            engine.add(new PinJoint(upright[k], coupler, k, 1));
            engine.add(new PinJoint(coupler, upright[k + 1], k + 1, 1));
        }
        return upright[0];
    }

    /** The largest distance of the first crank's end from that of the pendulum that the mechanism is. */
    private double error(int n, double duration) {
        BigDecimal weight = BigDecimal.valueOf((n + 1) / 2.0 + n);
        BigDecimal inertia = BigDecimal.valueOf(n + 1).divide(BigDecimal.valueOf(3), new MathContext(40)).add(BigDecimal.valueOf(n));
        EllipticPendulum exact = EllipticPendulum.overTheTop(
                new BigDecimal("9.81").multiply(weight).divide(inertia, new MathContext(40)), -1);
        Body crank = fourBars(n);
        double before = energy();
        double depth = G * (3 * n + 1) / 2;
        double worst = 0;
        int steps = (int) Math.round(duration / engine.getTimeStep());
        int every = (int) Math.max(1, Math.round(0.05 / engine.getTimeStep()));
        for (int k = 1; k <= steps; k++) {
            engine.step();
            if (k % every == 0) {
                double angle = exact.angle(engine.getTime());
                double dx = crank.getX() + 0.5 * StrictMath.cos(crank.getAngle()) - StrictMath.sin(angle);
                double dy = crank.getY() + 0.5 * StrictMath.sin(crank.getAngle()) + StrictMath.cos(angle);
                worst = Math.max(worst, StrictMath.hypot(dx, dy));
            }
        }
        // what the last pass took has not become an error of place yet
        assertThat(Math.abs(energy() - before) / depth).as("energy").isLessThan(Math.max(1e-12, 3 * worst));
        return worst;
    }

    @ParameterizedTest
    @CsvSource({"5e-3, 2e-7", "1e-3, 3e-10", "5e-4, 1e-10", "2e-4, 1e-10", "1e-4, 1e-10", "5e-5, 1e-10", "2e-5, 1e-10"})
    void fourBarsTurnRightAtEveryStep(double step, double near) {
        engine.setTimeStep(step);
        engine.setIntegrator(new RungeKutta4());
        assertThat(error(2, 2.5)).isLessThan(near);
    }

    static Stream<Arguments> methods() {
        DoubleFunction<Integrator> dormandPrince = DormandPrince853::new;
        DoubleFunction<Integrator> bulirschStoer = GraggBulirschStoer::new;
        DoubleFunction<Integrator> radau = RadauIIA::new;
        DoubleFunction<Integrator> automatic = Automatic::new;
        return Stream.of(
                Arguments.of(dormandPrince, 1e-14), Arguments.of(bulirschStoer, 1e-14), Arguments.of(radau, 1e-12),
                Arguments.of(automatic, 1e-13));
    }

    @ParameterizedTest
    @MethodSource("methods")
    void fourBarsTurnRightAtEveryTolerance(DoubleFunction<Integrator> method, double least) {
        for (double tolerance = 1e-9; tolerance > 0.5 * least; tolerance /= 10) {
            SingularPoseTest run = new SingularPoseTest();
            run.engine.setTimeStep(0.05);
            run.engine.setIntegrator(method.apply(tolerance));
            assertThat(run.error(2, 2.5)).as("tolerance %s", tolerance).isLessThan(Math.max(1e-10, 1000 * tolerance));
        }
    }

    @ParameterizedTest
    @CsvSource({
        "2, 2.5e-3, 1e-3", "2, 2.5e-4, 1e-5", "4, 1e-2, 3e-6", "4, 2.5e-3, 1e-8", "4, 1e-4, 1e-9",
        "6, 1e-2, 1e-8", "6, 1e-3, 3e-8", "6, 2.5e-4, 3e-7"
    })
    void fourBarsTurnUnderRattle(int order, double step, double near) {
        engine.setTimeStep(step);
        engine.setIntegrator(new Rattle(order));
        assertThat(error(2, 2.5)).isLessThan(near);
    }

    /** How near to the pose steps end is chance: eleven lengths say more than one. */
    @Test
    void fourBarsTurnUnderRattleAtMostSteps() {
        double[] errors = DoubleStream.of(25, 20, 12.5, 10, 9, 8, 7, 6, 5, 4, 2.5)
                .map(step -> {
                    SingularPoseTest run = new SingularPoseTest();
                    run.engine.setTimeStep(1e-4 * step);
                    run.engine.setIntegrator(new Rattle(4));
                    return run.error(2, 2.5);
                })
                .sorted()
                .toArray();
        assertThat(errors[5]).as("median").isLessThan(1e-10);
        assertThat(errors[10]).isLessThan(5e-9);
    }

    /** Beside the pose rounding is larger than such tolerances: steps ended after 10⁻¹⁰ s, and 1 % to 5 % of the energy was lost where it gave up. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-14, 1e-15, 1e-16})
    void aToleranceBelowRoundingTakesNoEnergy(double tolerance) {
        for (AdaptiveIntegrator method : new AdaptiveIntegrator[] {new GraggBulirschStoer(tolerance), new DormandPrince853(tolerance)}) {
            SingularPoseTest run = new SingularPoseTest();
            run.engine.setTimeStep(0.05);
            run.engine.setIntegrator(method);
            assertThat(run.error(40, 2)).as("%s", method).isLessThan(1e-11);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-8, 1e-10, 1e-12})
    void fortyWindowsTurnRight(double tolerance) {
        engine.setTimeStep(0.05);
        engine.setIntegrator(new GraggBulirschStoer(tolerance));
        assertThat(error(40, 2)).isLessThan(1000 * tolerance);
    }

    /** IFToMM's benchmark A02 whole: some 40 passes through the pose. */
    @ParameterizedTest
    @ValueSource(doubles = {3e-13, 1e-13, 3e-14})
    void fortyWindowsTurnRightForTwentySeconds(double tolerance) {
        engine.setTimeStep(0.05);
        engine.setIntegrator(new GraggBulirschStoer(tolerance));
        assertThat(error(40, 20)).isLessThan(1e-10);
    }

    /** A bar on three cranks: one is too many, and in line all are. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-2, 1e-3, 1e-4})
    void aBarOnThreeCranksTurnsAsAPendulum(double step) {
        engine.setTimeStep(step);
        assertThat(errorOfThreeCranks()).isLessThan(1e-10 + 1e3 * StrictMath.pow(step, 4));
        assertThat(engine.getRedundantEquations()).isOne();
    }

    static Stream<Arguments> methodsForThreeCranks() {
        return Stream.of(
                Arguments.of(new DormandPrince853(1e-10), 0.05), Arguments.of(new GraggBulirschStoer(1e-12), 0.05),
                Arguments.of(new RadauIIA(1e-10), 0.05), Arguments.of(new Rattle(4), 1e-3));
    }

    @ParameterizedTest
    @MethodSource("methodsForThreeCranks")
    void aBarOnThreeCranksTurnsUnderEveryMethod(Integrator method, double step) {
        engine.setTimeStep(step);
        engine.setIntegrator(method);
        assertThat(errorOfThreeCranks()).isLessThan(3e-8);
    }

    /** How near to the pose a step ends is chance: many settings say more than one. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-8, 1e-9, 1e-10, 1e-11, 1e-12})
    void aBarOnThreeCranksTurnsWhereverStepsEnd(double tolerance) {
        for (double step : new double[] {0.05, 0.04, 0.025, 0.02, 0.01, 0.005}) {
            for (Integrator method : new Integrator[] {new DormandPrince853(tolerance), new GraggBulirschStoer(tolerance)}) {
                SingularPoseTest run = new SingularPoseTest();
                run.engine.setTimeStep(step);
                run.engine.setIntegrator(method);
                assertThat(run.errorOfThreeCranks()).as("%s, step %s", method, step).isLessThan(300 * tolerance);
            }
        }
    }

    private double errorOfThreeCranks() {
        engine.add(new Gravity(0, -G));
        Body bar = rod(0, 1, 2, 1).moving(1, 0);
        Body crank = null;
        for (int k = 2; k >= 0; k--) {
            crank = rod(k, 0, k, 1).moving(0.5, 0, -1);
            engine.add(new PinJoint(crank, k, 0));
            engine.add(new PinJoint(crank, bar, k, 1));
        }
        EllipticPendulum exact = EllipticPendulum.overTheTop(new BigDecimal("12.2625"), -1); // 9.81 · (3/2 + 1) / (3/3 + 1)
        double worst = 0;
        for (int k = 0; k < Math.round(4 / engine.getTimeStep()); k++) {
            engine.step();
            double angle = exact.angle(engine.getTime());
            double dx = 2 * crank.getX() - StrictMath.sin(angle);
            double dy = 2 * crank.getY() + StrictMath.cos(angle);
            worst = Math.max(worst, StrictMath.hypot(dx, dy));
        }
        return worst;
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 5})
    void aDoorOnManyHingesIsAPendulumWithNothingToPush(int hinges) {
        engine.setTimeStep(1e-3);
        engine.add(new Gravity(0, -G));
        Body door = rod(0, 0, 1, 0);
        PinJoint[] pins = new PinJoint[hinges];
        for (int k = 0; k < hinges; k++) {
            pins[k] = engine.add(new PinJoint(door, 0, 0));
        }
        for (int k = 0; k < 1000; k++) {
            engine.step();
        }
        assertThat(engine.getRedundantEquations()).isEqualTo(2 * (hinges - 1));
        double x = 0;
        double y = 0;
        for (PinJoint pin : pins) {
            x += engine.getReaction(pin).forceX();
            y += engine.getReaction(pin).forceY();
            assertThat(engine.getReaction(pin).forceY()).isCloseTo(engine.getReaction(pins[0]).forceY(), within(1e-6));
        }
        // the pull of a rod of mass 1: from its weight and its swing
        double angle = door.getAngle();
        double rate = door.getAngularVelocity();
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        double alpha = -1.5 * G * cos;
        double ex = x - 0.5 * (-alpha * sin - rate * rate * cos);
        double ey = y - 0.5 * (alpha * cos - rate * rate * sin) - G;
        assertThat(ex).isCloseTo(0, within(1e-11 * G));
        assertThat(ey).isCloseTo(0, within(1e-11 * G));
    }

    /** Two rods in a line between two supports, with a load: they cannot move, but to first order they can. */
    private double deflection(double wider) {
        engine.setTimeStep(0.01);
        Body left = rod(0, 0, 1, 0);
        Body right = rod(1, 0, 2, 0);
        engine.add(new PinJoint(left, 0, 0));
        PinJoint middle = engine.add(new PinJoint(left, right, 1, 0));
        engine.add(new PinJoint(right, 0.5, 0, null, 2 * (1 + wider), 0));
        engine.add(new Load(left));
        double most = 0;
        for (int k = 0; k < 200; k++) {
            engine.step();
            most = Math.max(most, Math.abs(left.getY() + 0.5 * StrictMath.sin(left.getAngle())));
            assertThat(engine.getReaction(middle).force()).isLessThan(10);
        }
        return most;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-12, -1e-12})
    void rodsInALineHardlyGiveWay(double wider) {
        assertThat(deflection(wider)).isLessThan(1e-8);
        assertThat(engine.getRedundantEquations()).isOne();
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1, 30})
    void rodsInALineThatAreStruckStand(double speed) {
        Body left = rod(0, 0, 1, 0).moving(0, 0.5 * speed, speed);
        Body right = rod(1, 0, 2, 0).moving(0, 0.5 * speed, -speed);
        engine.add(new PinJoint(left, 0, 0));
        engine.add(new PinJoint(left, right, 1, 0));
        engine.add(new PinJoint(right, 0.5, 0, null, 2, 0));
        for (int k = 0; k < 100; k++) {
            engine.step();
            assertThat(Math.abs(left.getY() + 0.5 * StrictMath.sin(left.getAngle()))).isLessThan(1e-8);
        }
    }

    static Stream<Integrator> methodsForStraightBars() {
        return Stream.of(new RungeKutta4(), new DormandPrince853(1e-8), new GraggBulirschStoer(1e-8), new RadauIIA(1e-6));
    }

    /**
     * A rod along two bars that a pin joins in a line keeps them straight, although its row depends on those of the pin wherever they fly. What
     * they would bend by is stopped at once, and they turn on with their angular momentum.
     */
    @ParameterizedTest
    @MethodSource("methodsForStraightBars")
    void aRodAlongTwoBarsKeepsThemStraight(Integrator method) {
        engine.setTimeStep(1 / 60.0);
        engine.setIntegrator(method);
        engine.add(new Gravity(0, -G));
        Body one = engine.add(new Body(new Rectangle(1, 0.3)).at(0, 0).moving(0.3, 0.2, 0.4));
        Body other = engine.add(new Body(new Rectangle(1, 0.3)).at(1.1, 0.2).moving(-0.1, 0.5, -1));
        engine.add(new PinJoint(one, other, 0.55, 0.1));
        engine.add(new RodJoint(one, 0, 0, other, 1.1, 0.2));
        Body third = engine.add(new Body(new Circle(0.1)).at(0, 5));
        engine.add(Limit.rope(one, 0, 0, third, 0, 0, 1000)); // neither it nor a spring without force makes a difference
        engine.add(new Spring(other, 0, 0, third, 0, 0, 5, 1e-15, 0));
        double apart = StrictMath.hypot(1.1, 0.2);
        double m = one.getMass();
        double spin = one.getInertia() * (0.4 - 1) + 0.5 * m * (1.1 * (0.5 - 0.2) - 0.2 * (-0.1 - 0.3));
        double omega = spin / (2 * one.getInertia() + 0.5 * m * apart * apart);
        for (int k = 0; k < 60; k++) {
            engine.step();
            assertThat(StrictMath.hypot(one.getX() - other.getX(), one.getY() - other.getY())).isCloseTo(apart, within(1e-10));
        }
        assertThat(one.getAngularVelocity()).isCloseTo(omega, within(1e-4)); // gaps of rounding are bends of their root
        assertThat(other.getAngularVelocity()).isCloseTo(omega, within(1e-4));
        assertThat(0.5 * (one.getVelocityX() + other.getVelocityX())).isCloseTo(0.1, within(1e-12));
        assertThat(0.5 * (one.getVelocityY() + other.getVelocityY())).isCloseTo(0.35 - G, within(1e-11));
    }

    /** It hangs in equilibrium, where accelerations are rounding errors; then it is pushed. */
    @Test
    void aBarOnThreeCranksThatHangsDoesNotStickThere() {
        engine.setTimeStep(1e-3);
        engine.add(new Gravity(0, -G));
        Body bar = rod(0, -1, 2, -1);
        Body[] cranks = new Body[3];
        for (int k = 0; k < 3; k++) {
            cranks[k] = rod(k, 0, k, -1);
            cranks[k].setMass(1, 0.1);
            engine.add(new PinJoint(cranks[k], k, 0));
            engine.add(new PinJoint(cranks[k], bar, k, -1));
        }
        for (int k = 0; k < 100; k++) {
            engine.step();
        }
        bar.addForce(10, 0);
        engine.step();
        for (int k = 0; k < 100; k++) {
            engine.step();
        }
        assertThat(bar.getX()).isGreaterThan(1 + 1e-4);
    }

    /** A knee that is nearly straight presses with 1 / (2 tan α) times its load. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-2, 1e-4, 5e-6, 5e-7})
    void aToggleMultipliesItsLoad(double alpha) {
        engine.setTimeStep(1e-3);
        double cos = StrictMath.cos(alpha);
        double sin = StrictMath.sin(alpha);
        Body left = engine.add(new Body(new Rectangle(1, 0.02)).at(0.5 * cos, 0.5 * sin, alpha));
        Body right = engine.add(new Body(new Rectangle(1, 0.02)).at(1.5 * cos, 0.5 * sin, -alpha));
        engine.add(new PinJoint(left, -0.5, 0, null, 0, 0));
        engine.add(new PinJoint(left, 0.5, 0, right, -0.5, 0));
        PinJoint end = engine.add(new PinJoint(right, 0.5, 0, null, 2 * cos, 0));
        engine.add(new Load(left));
        engine.step();
        Reaction pressed = engine.getReaction(end);
        double exact = 0.5 * cos / sin;
        assertThat(Math.abs(pressed.forceX())).isCloseTo(exact, within(1e-8 * exact));
    }

    private static double inertia(double angle) {
        double sin = StrictMath.sin(angle);
        return 1.0 / 3 + 1.0 / 12 + 0.25 + 2 * sin * sin + 4 * sin * sin;
    }

    /** Crank and rod of one length: at a quarter turn the rod lies on the crank, and the slider could stay where it is. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-2, 1e-3, 1e-4})
    void aSliderCrankThatFoldsGoesOnByItsInertia(double step) {
        engine.setTimeStep(step);
        double start = 0.6;
        double sin = StrictMath.sin(start);
        double cos = StrictMath.cos(start);
        Body crank = rod(0, 0, cos, sin).moving(-0.5 * sin, 0.5 * cos, 1);
        Body rod = rod(cos, sin, 2 * cos, 0).moving(-1.5 * sin, 0.5 * cos, -1);
        Body slider = engine.add(new Body(new Circle(0.1)).at(2 * cos, 0).moving(-2 * sin, 0));
        slider.setMass(1);
        slider.setCollisionGroup(1, 0);
        engine.add(new PinJoint(crank, 0, 0));
        engine.add(new PinJoint(crank, rod, cos, sin));
        engine.add(new PinJoint(rod, slider, 2 * cos, 0));
        engine.add(new SliderJoint(slider, null, 2 * cos, 0, 1, 0));
        for (int k = 0; k < Math.round(10 / step); k++) {
            engine.step();
            assertThat(slider.getX()).isCloseTo(2 * StrictMath.cos(crank.getAngle()), within(1e-9));
        }
        // the time that the crank takes, by Simpson's rule
        double end = crank.getAngle();
        int n = 20_000;
        double time = 0;
        for (int k = 0; k <= n; k++) {
            double weight = k == 0 || k == n ? 1 : k % 2 == 1 ? 4 : 2;
            time += weight * StrictMath.sqrt(inertia(start + (end - start) * k / n) / inertia(start));
        }
        time *= (end - start) / (3 * n);
        assertThat(end).isGreaterThan(2 * StrictMath.PI);
        assertThat(time).isCloseTo(engine.getTime(), within(1e-10 + 20 * StrictMath.pow(step, 4)));
    }
}
