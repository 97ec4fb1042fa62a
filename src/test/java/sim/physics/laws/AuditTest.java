// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.StepReport;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.Euler;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.Rattle;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.Spring;
import sim.physics.motion.SurfaceFriction;
import sim.physics.motion.SymplecticEuler;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** The audit's books balance, its errors are those of the method, and it changes nothing. */
class AuditTest {
    private static final double G = 9.81;

    private static Integrator method(String name) {
        return switch (name) {
            case "Euler" -> new Euler();
            case "Symplectic" -> new SymplecticEuler();
            case "Rattle" -> new Rattle(4);
            case "DOP853" -> new DormandPrince853(1e-6);
            case "GBS" -> new GraggBulirschStoer(1e-6);
            case "Radau" -> new RadauIIA(1e-6);
            case "Automatic" -> new Automatic(1e-6);
            case "rough DOP853" -> new DormandPrince853(1e-2);
            case "rough GBS" -> new GraggBulirschStoer(1e-2);
            case "rough Radau" -> new RadauIIA(1e-2);
            case "rough Automatic" -> new Automatic(1e-2);
            default -> new RungeKutta4();
        };
    }

    private static PhysicsEngine empty(String method, double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.setIntegrator(method(method));
        return engine;
    }

    private static Body rods(PhysicsEngine engine, int count) {
        engine.add(new Gravity(0, -G));
        return Scenes.rods(engine, count, -1);
    }

    private static Body bob(PhysicsEngine engine, double stiffness, double damping) {
        Body bob = engine.add(new Body(new Circle(0.1)).at(1.5, 0));
        bob.setMass(1, 1);
        engine.add(new Spring(bob, 0, 0, null, 0, 0, 1, stiffness, damping));
        return bob;
    }

    private static Body puck(PhysicsEngine engine, double spin) {
        engine.add(new SurfaceFriction(G));
        Body puck = engine.add(new Body(new Circle(0.1)).moving(1, 0));
        puck.setAngularVelocity(spin);
        puck.setMass(1, 0.005);
        puck.setSurfaceFriction(0.3, 0.3);
        return puck;
    }

    private static void run(PhysicsEngine engine, int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    private static PhysicsEngine scene(String name, String method) {
        PhysicsEngine engine = empty(method, 0.01);
        switch (name) {
            case "rods" -> rods(engine, 3);
            case "springs" -> {
                Body a = bob(engine, 100, 0.5);
                Body b = engine.add(new Body(new Circle(0.1)).at(3, 0.3));
                engine.add(new Spring(a, 0, 0.1, b, 0, 0, 1, 50, 0));
            }
            case "puck" -> puck(engine, 7);
            case "motor" -> {
                Body last = rods(engine, 2);
                engine.add(Motor.turning(last, null, 2, 3));
                engine.add(Limit.angle(engine.bodies().get(0), null, -1, 2));
            }
            case "wall" -> {
                rods(engine, 2);
                engine.add(Body.fixed(new Rectangle(0.2, 4)).at(-0.5, 0));
                engine.bodies().get(1).setCollisionGroup(1, 0);
            }
            case "stack" -> {
                engine.add(new Gravity(0, -G));
                engine.add(Body.fixed(new Rectangle(20, 1)).at(0, -0.5));
                for (int k = 0; k < 3; k++) {
                    Body box = engine.add(new Body(new Rectangle(1, 1)).at(0.1 * k, 0.5 + 1.05 * k));
                    box.setRestitution(0.3);
                    box.setFriction(0.5);
                }
            }
            default -> {
                engine = Scenes.gas(Scenes.Kind.POLYGONS, 24, 12);
                engine.add(new SurfaceFriction(0.1));
                engine.bodies().forEach(body -> body.setSurfaceFriction(0.02));
            }
        }
        return engine;
    }

    /** Not only do the bodies move the same way: nothing at all in the engine is different. */
    @ParameterizedTest
    @CsvSource({
        "rods, RK4", "rods, Euler", "rods, Symplectic", "rods, Rattle", "rods, DOP853", "rods, GBS", "rods, Radau",
        "rods, Automatic",
        "springs, RK4", "springs, Automatic", "puck, RK4", "puck, DOP853", "motor, RK4", "motor, DOP853", "motor, Radau",
        "wall, RK4", "wall, GBS", "stack, RK4", "gas, RK4"
    })
    void itChangesNoBit(String name, String method) {
        PhysicsEngine plain = scene(name, method);
        PhysicsEngine audited = scene(name, method);
        audited.setAudited(true);
        run(plain, 120);
        run(audited, 120);
        assertThat(Scenes.hash(audited)).isEqualTo(Scenes.hash(plain));
        audited.setAudited(false);
        if (!name.equals("gas")) { // where polygons keep what they computed last under friction
            assertThat(Arrays.equals(Checkpoint.bytes(audited), Checkpoint.bytes(plain))).isTrue();
        }
    }

    @ParameterizedTest
    @CsvSource({"rods, DOP853", "motor, RK4", "gas, RK4"})
    void aRestoredAuditGoesOnAsItWas(String name, String method) {
        PhysicsEngine engine = scene(name, method);
        engine.setAudited(true);
        run(engine, 50);
        PhysicsEngine restored = Checkpoint.copy(engine);
        run(engine, 50);
        run(restored, 50);
        assertThat(restored.getRunReport()).isEqualTo(engine.getRunReport());
    }

    /** After one step from an analytic state the error is known: the estimate is within 2 %. */
    @ParameterizedTest
    @CsvSource({
        "Euler, 0.01", "Symplectic, 0.01", "RK4, 0.02", "Rattle, 0.02", "rough DOP853, 0.2", "rough GBS, 0.2", "rough Radau, 0.05",
        "rough Automatic, 0.2"
    })
    void theErrorOfAStepIsWhatItIs(String method, double step) {
        PhysicsEngine engine = empty(method, step);
        Body bob = bob(engine, 100, 0);
        bob.at(1, 0).moving(5, 0);
        engine.setAudited(true);
        engine.step();
        double error = Math.abs(bob.getX() - (1 + 0.5 * StrictMath.sin(10 * step)));
        assertThat(engine.getStepReport().placeError() / error).isBetween(0.98, 1.02);
    }

    /** Along a whole run the errors of its steps add up to that of the end, but for what the motion makes of them. */
    @ParameterizedTest
    @ValueSource(strings = {"RK4", "DOP853", "GBS", "Radau"})
    void theErrorsOfARunAddUp(String method) {
        PhysicsEngine engine = empty(method, 0.01);
        Body bob = bob(engine, 100, 0);
        engine.setAudited(true);
        run(engine, 100);
        double error = StrictMath.hypot(
                bob.getX() - (1 + 0.5 * StrictMath.cos(10)), (bob.getVelocityX() + 5 * StrictMath.sin(10)) / 10);
        assertThat(error / engine.getRunReport().placeError()).isBetween(0.1, 10.0);
    }

    @ParameterizedTest
    @CsvSource({"Euler, 2", "Symplectic, 2", "RK4, 6"})
    void theDriftIsOfTheMethodsOrder(String method, int order) {
        double[] drift = new double[2];
        for (int k = 0; k < 2; k++) {
            PhysicsEngine engine = empty(method, k == 0 ? 0.01 : 0.005);
            bob(engine, 100, 0.1).moving(0.3, 1);
            engine.setAudited(true);
            engine.step();
            drift[k] = engine.getStepReport().drift();
        }
        assertThat(StrictMath.log(drift[0] / drift[1]) / StrictMath.log(2)).isBetween(order - 0.3, order + 0.7);
    }

    @Test
    void aPendulumsEnergyDriftsAsItDoes() {
        PhysicsEngine engine = empty("RK4", 0.02);
        rods(engine, 2);
        engine.setAudited(true);
        run(engine, 100);
        StepReport report = engine.getRunReport();
        assertThat(report.energyBefore()).isZero();
        assertThat(report.work()).isCloseTo(0, within(1e-12));
        assertThat(report.drift()).isCloseTo(report.energyAfter(), within(1e-12)).isNotCloseTo(0, within(1e-9));
    }

    /** A damper takes what the closed form says that is missing. */
    @ParameterizedTest
    @CsvSource({"RK4, 0.005", "DOP853, 0.1"})
    void aDampersWorkIsExact(String method, double step) {
        PhysicsEngine engine = empty(method, step);
        bob(engine, 100, 2);
        engine.setAudited(true);
        run(engine, (int) Math.round(1 / step));
        double w = Math.sqrt(99);
        double x = 0.5 * StrictMath.exp(-1) * (StrictMath.cos(w) + StrictMath.sin(w) / w);
        double v = -0.5 * StrictMath.exp(-1) * (100 / w) * StrictMath.sin(w);
        double left = 0.5 * v * v + 50 * x * x;
        StepReport report = engine.getRunReport();
        assertThat(report.work() + report.drift()).isCloseTo(left - 12.5, within(1e-4));
        assertThat(report.work()).isCloseTo(left - 12.5, within(1e-5));
        assertThat(report.energyAfter()).isCloseTo(12.5 + report.work() + report.drift(), within(1e-12));
    }

    @ParameterizedTest
    @CsvSource({"0, RK4", "5, RK4", "5, DOP853"})
    void frictionTakesAllOfAPucksEnergy(double spin, String method) {
        PhysicsEngine engine = empty(method, 0.01);
        puck(engine, spin);
        engine.setAudited(true);
        run(engine, 60);
        StepReport report = engine.getRunReport();
        assertThat(engine.kineticEnergy()).isZero();
        double all = 0.5 + 0.5 * 0.005 * spin * spin;
        assertThat(report.work()).isCloseTo(-all, within(spin == 0 ? 1e-12 : 1e-5));
        assertThat(report.drift()).isCloseTo(0, within(spin == 0 ? 1e-12 : 1e-5));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void anImpactTakesWhatNewtonsLawSays(double restitution) {
        PhysicsEngine engine = empty("RK4", 0.01);
        engine.add(new Gravity(0, -G));
        Body ball = engine.add(new Body(new Circle(0.1)).at(0, 1.1));
        ball.setMass(2, 0.01);
        ball.setRestitution(restitution);
        engine.add(Body.fixed(new Rectangle(10, 1)).at(0, -0.5)).setRestitution(1);
        engine.setAudited(true);
        run(engine, 50);
        StepReport report = engine.getRunReport();
        assertThat(engine.getImpacts()).isEqualTo(1);
        assertThat(report.impacts()).isCloseTo(-2 * G * (1 - restitution * restitution), within(1e-12));
        assertThat(report.work()).isCloseTo(0, within(1e-12));
        assertThat(report.drift()).isCloseTo(0, within(1e-12));
    }

    /** A flywheel of inertia 2 is brought to 3 rad/s by 0.7 N m, in a time that is no multiple of the step. */
    @ParameterizedTest
    @ValueSource(strings = {"RK4", "DOP853", "Radau", "Euler"})
    void aMotorsWorkIsWhatItsFlywheelHas(String method) {
        PhysicsEngine engine = empty(method, 0.1);
        Body wheel = engine.add(new Body(new Circle(1)));
        wheel.setMass(1, 2);
        engine.add(new PinJoint(wheel, 0, 0));
        engine.add(Motor.turning(wheel, null, 3, 0.7));
        engine.setAudited(true);
        run(engine, 100);
        StepReport report = engine.getRunReport();
        assertThat(wheel.getAngularVelocity()).isCloseTo(3, within(1e-11));
        assertThat(report.work()).isCloseTo(9, within(1e-10));
        assertThat(report.drift()).isCloseTo(0, within(1e-10));
    }

    /** A step is divided where a motor begins to yield, so RK4 keeps its order: if not, it is off by 2.8e-5 J. */
    @Test
    void aMotorThatYieldsWithinAStepCostsNoEnergy() {
        double[] speed = new double[2];
        double drift = 0;
        for (int k = 0; k < 2; k++) {
            PhysicsEngine engine = empty("RK4", 0.01);
            engine.setIntegrator(k == 0 ? new RungeKutta4() : new DormandPrince853(1e-12));
            Body rod = rods(engine, 1);
            engine.add(Motor.turning(rod, null, 3, 2));
            engine.setAudited(k == 0);
            run(engine, 139);
            speed[k] = rod.getAngularVelocity();
            drift = k == 0 ? engine.getStepReport().drift() : drift;
        }
        double missing = (speed[0] * speed[0] - speed[1] * speed[1]) / 6;
        assertThat(missing).isCloseTo(0, within(1e-9));
        assertThat(drift).isCloseTo(missing, within(1e-9));
    }

    @Test
    void anAppliedForcesWorkIsForceTimesWay() {
        PhysicsEngine engine = empty("RK4", 0.1);
        engine.add(new Gravity(0, -G));
        Body body = engine.add(new Body(new Circle(1)).moving(1, 2));
        body.setMass(2, 1);
        engine.setAudited(true);
        double way = 0;
        for (int k = 0; k < 5; k++) {
            double from = body.getX();
            body.addForce(3, 0);
            engine.step();
            way += body.getX() - from;
        }
        run(engine, 5);
        assertThat(engine.getRunReport().work()).isCloseTo(3 * way, within(1e-12));
        assertThat(engine.getRunReport().drift()).isCloseTo(0, within(1e-12));
    }

    @Test
    void whatAuthorsDoIsTheirs() {
        PhysicsEngine engine = empty("RK4", 0.1);
        Body body = engine.add(new Body(new Circle(1)).moving(1, 2));
        body.setMass(2, 1);
        engine.setAudited(true);
        run(engine, 3);
        body.setVelocity(5, 0);
        run(engine, 3);
        assertThat(engine.getRunReport().authored()).isCloseTo(20, within(1e-13));
        Body other = engine.add(new Body(new Circle(1)).at(50, 0).moving(0, 3));
        other.setMass(4, 1);
        engine.step();
        assertThat(engine.getStepReport().authored()).isCloseTo(18, within(1e-13));
        engine.remove(body);
        engine.step();
        assertThat(engine.getStepReport().authored()).isCloseTo(-25, within(1e-13));
        assertThat(engine.getRunReport().drift()).isCloseTo(0, within(1e-12));
    }

    /** A crowd of everything: whatever happens in a step is in some book. */
    @ParameterizedTest
    @CsvSource({"gas, 1e-7", "stack, 1e-10", "wall, 1e-4", "motor, 2e-5"})
    void theBooksBalance(String name, double part) {
        PhysicsEngine engine = scene(name, "RK4");
        engine.setAudited(true);
        run(engine, 200);
        StepReport report = engine.getRunReport();
        double most = Math.abs(report.work()) + Math.abs(report.impacts()) + engine.kineticEnergy();
        assertThat(most).isGreaterThan(1);
        assertThat(Math.abs(report.drift())).isLessThan(part * most);
        assertThat(report.unresolved()).isZero();
    }

    /** Counts its evaluations, which a generator should not do. */
    private static final class Counting implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private long count;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            count++;
            forces.add(body, -body.getX(), 0);
        }
    }

    @Test
    void whenItIsOffItCostsNothing() {
        PhysicsEngine engine = empty("RK4", 0.01);
        Counting counting = new Counting();
        engine.add(counting);
        engine.add(new Body(new Circle(1)).at(1, 0));
        engine.setAudited(true);
        engine.step();
        assertThat(counting.count).isGreaterThan(4);
        engine.setAudited(false);
        run(engine, 60_000);
        counting.count = 0;
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        long before = threads.getThreadAllocatedBytes(id);
        run(engine, 2_000);
        assertThat(threads.getThreadAllocatedBytes(id) - before).isLessThan(2_000);
        assertThat(counting.count).isEqualTo(8_000);
    }

    @Test
    void aReportIsAskedForOnlyIfThereIsAnAudit() {
        PhysicsEngine engine = new PhysicsEngine();
        assertThatThrownBy(engine::getStepReport).isInstanceOf(IllegalStateException.class);
        engine.setAudited(true);
        assertThat(engine.getRunReport().energyAfter()).isZero();
        engine.setAudited(false);
        assertThatThrownBy(engine::getRunReport).isInstanceOf(IllegalStateException.class);
    }

    /** Hard case J13: two discs whose centres are pinned keep the momentum and lose the energy of their relative velocity. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.01, 0.5, 30})
    void theEnergyThatAssemblingCostsIsReported(double open) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        engine.add(new Gravity(0, -9.81));
        Body light = engine.add(new Body(new Circle(1)).at(0, 0).moving(3, 4));
        Body heavy = engine.add(new Body(new Circle(1)).at(open, 0).moving(-1, 1));
        light.setMass(2, 5);
        heavy.setMass(6, 5);
        light.setCollisionGroup(1, 0);
        engine.setAudited(true);
        engine.step();
        engine.assemble(new PinJoint(light, 0, 0, heavy, 0, 0));
        assertThat(light.getX()).isCloseTo(heavy.getX(), within(1e-13));
        engine.step();
        assertThat(engine.getStepReport().authored()).isCloseTo(-0.5 * (2 * 6 / 8.0) * (4 * 4 + 3 * 3), within(1e-11));
    }
}
