// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sim.physics.laws.Methods.method;

import java.io.Serializable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.Witness;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Methods that choose their steps go on beyond the engine's, which then neither costs nor makes right, and nobody notices. */
class StrideTest {
    private static final double G = 9.81;
    private static final int OUTPUTS = 8;

    /** The pull of a sun, which counts how often it is asked. */
    private static final class Sun implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private long calls;

        @Override
        public boolean isAutonomous() {
            return true;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            calls++;
            double r = Math.sqrt(body.getX() * body.getX() + body.getY() * body.getY());
            double pull = -body.getMass() / (r * r * r);
            forces.add(body, pull * body.getX(), pull * body.getY());
        }
    }

    /** A scene, its body, and what counts its evaluations. */
    private record Setup(PhysicsEngine engine, Body body, ForceGenerator counter) implements Serializable {
        /** A planet on an ellipse, or the lower one of two rods. */
        static Setup of(String name, Integrator method, double step) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setIntegrator(method);
            engine.setTimeStep(step);
            boolean isOrbit = name.equals("orbit");
            Body body = isOrbit
                    ? engine.add(new Body(new Circle(0.1)).at(0.7, 0).moving(0, Math.sqrt(1.3 / 0.7)))
                    : Scenes.rods(engine, 2, 0);
            ForceGenerator counter = isOrbit ? new Sun() : new Witness(body, true);
            engine.add(counter);
            if (!isOrbit) {
                engine.add(new Gravity(0, -G));
            }
            return new Setup(engine, body, counter);
        }

        long calls() {
            return counter instanceof Sun sun ? sun.calls : ((Witness) counter).calls();
        }
    }

    /** A run: places at some instants, a kick along the velocity before one of them, and the number of evaluations. */
    private static double[] run(String name, Integrator method, double time, int steps, int kicked, double kick) {
        Setup setup = Setup.of(name, method, time / (OUTPUTS * steps));
        Body body = setup.body();
        double[] places = new double[2 * OUTPUTS + 1];
        for (int k = 0; k < OUTPUTS; k++) {
            if (k == kicked) {
                double longer = 1 + kick / Math.max(1e-3, Math.hypot(body.getVelocityX(), body.getVelocityY()));
                body.setVelocity(longer * body.getVelocityX(), longer * body.getVelocityY());
            }
            for (int i = 0; i < steps; i++) {
                setup.engine().step();
            }
            places[2 * k] = body.getX();
            places[2 * k + 1] = body.getY();
        }
        places[2 * OUTPUTS] = setup.calls();
        return places;
    }

    private static double distance(double[] a, double[] b) {
        double most = 0;
        for (int k = 0; k < 2 * OUTPUTS; k += 2) {
            most = Math.max(most, Math.hypot(a[k] - b[k], a[k + 1] - b[k + 1]));
        }
        return most;
    }

    /** What becomes of errors of one unit of length in every unit of the scene's time, at random. */
    private static double amplification(String name, double time, double unit, double[] exact) {
        double sum = 0;
        for (int k = 1; k < OUTPUTS; k++) {
            double[] kicked = run(name, new DormandPrince853(1e-13), time, 1, k, 1e-6 / unit);
            double grown = distance(kicked, exact) / 1e-6;
            sum += grown * grown;
        }
        return Math.sqrt(time / unit * sum / (OUTPUTS - 1));
    }

    /**
     * From steps of the engine about as long as the method's to ones far shorter: the error is that of the tolerance, and the
     * cost hardly changes.
     */
    @ParameterizedTest
    @CsvSource({
        "orbit, DOP853, 1e-4", "orbit, DOP853, 1e-8", "orbit, DOP853, 1e-12", "orbit, GBS, 1e-4", "orbit, GBS, 1e-8",
        "orbit, Radau, 1e-4", "orbit, Radau, 1e-7", "orbit, Automatic, 1e-6",
        "rods, DOP853, 1e-4", "rods, DOP853, 1e-8", "rods, DOP853, 1e-11", "rods, GBS, 1e-4", "rods, GBS, 1e-8",
        "rods, Radau, 1e-4", "rods, Radau, 1e-7", "rods, Automatic, 1e-6"
    })
    void errorAndCostAreNotOfTheEnginesStep(String name, String method, double tolerance) {
        double time = name.equals("orbit") ? 16 : 3;
        double[] exact = run(name, new DormandPrince853(1e-14), time, 1, -1, 0);
        double amplification = amplification(name, time, name.equals("orbit") ? 1 : 0.3, exact);
        double[] calls = new double[4];
        int[] steps = {1, 64, 256, 1024};
        double mean = 0;
        for (int k = 0; k < steps.length; k++) {
            double[] places = run(name, method(method, tolerance), time, steps[k], -1, 0);
            calls[k] = places[2 * OUTPUTS];
            double ratio = distance(places, exact) / (tolerance * amplification);
            assertThat(ratio).as("%d steps", steps[k]).isBetween(0.03, 10.0); // errors may happen to cancel
            mean += StrictMath.log10(ratio) / steps.length;
        }
        assertThat(mean).isBetween(-1.0, 1.0);
        assertThat(calls[2]).isLessThan(2.5 * calls[0]);
        assertThat(calls[3]).isLessThan(1.3 * calls[2]);
    }

    /** A step in the middle of a stride asks for no force, and yet its joints are closed. */
    @ParameterizedTest
    @ValueSource(strings = {"DOP853", "GBS", "Radau", "Automatic"})
    void jointsAreClosedAtEveryStep(String method) {
        Setup setup = Setup.of("rods", method(method, 1e-4), 1e-3);
        PhysicsEngine engine = setup.engine();
        Body lower = setup.body();
        Body upper = engine.bodies().get(0);
        int still = 0;
        for (int k = 0; k < 2000; k++) {
            long before = setup.calls();
            engine.step();
            still += setup.calls() == before ? 1 : 0;
            double c = StrictMath.cos(upper.getAngle());
            double s = StrictMath.sin(upper.getAngle());
            double cl = StrictMath.cos(lower.getAngle());
            double sl = StrictMath.sin(lower.getAngle());
            double dx = upper.getX() + 0.5 * c - lower.getX() + 0.5 * cl;
            double dy = upper.getY() + 0.5 * s - lower.getY() + 0.5 * sl;
            assertThat(Math.hypot(dx, dy)).isLessThan(100 * 0x1p-52);
            double ux = upper.getVelocityX() - 0.5 * s * upper.getAngularVelocity()
                    - lower.getVelocityX() - 0.5 * sl * lower.getAngularVelocity();
            double uy = upper.getVelocityY() + 0.5 * c * upper.getAngularVelocity()
                    - lower.getVelocityY() + 0.5 * cl * lower.getAngularVelocity();
            assertThat(Math.hypot(ux, uy)).isLessThan(1e-11);
        }
        assertThat(still).isGreaterThan(1700);
    }

    /** What is done to a scene between steps. */
    private static void write(PhysicsEngine engine, Body bob, Body peg, Spring spring, int k) {
        switch (k) {
            case 100 -> bob.setVelocity(-1, 0.5);
            case 203, 204 -> bob.addForce(0, 40);
            case 310 -> bob.setMass(3);
            case 417 -> peg.setPosition(0.3, 0.2);
            case 530 -> bob.setPosition(bob.getX() + 0.1, bob.getY());
            case 641 -> engine.remove(spring);
            case 700 -> engine.add(spring);
            case 803 -> engine.setTimeStep(2 * engine.getTimeStep());
            default -> { }
        }
    }

    /** The same as with RK4, whose steps end with the engine's, after every step. */
    @ParameterizedTest
    @ValueSource(strings = {"DOP853", "GBS", "Radau", "Automatic"})
    void whatIsWrittenActsAtOnce(String method) {
        PhysicsEngine[] engines = new PhysicsEngine[2];
        Body[] bobs = new Body[2];
        Body[] pegs = new Body[2];
        Spring[] springs = new Spring[2];
        for (int e = 0; e < 2; e++) {
            engines[e] = new PhysicsEngine();
            engines[e].setTimeStep(1.0 / 512);
            engines[e].setIntegrator(e == 0 ? method(method, 1e-10) : new RungeKutta4());
            engines[e].add(new Gravity(0, -1));
            pegs[e] = engines[e].add(Body.fixed(new Circle(0.1)));
            pegs[e].setCollisionGroup(1, 0);
            bobs[e] = engines[e].add(new Body(new Circle(0.1)).at(1, 0));
            bobs[e].setMass(2, 0.01);
            springs[e] = new Spring(bobs[e], 0, 0, pegs[e], 0, 0, 0.8, 8, 0.3);
            engines[e].add(springs[e]);
        }
        Witness witness = new Witness(bobs[0], true);
        engines[0].add(witness);
        int still = 0;
        for (int k = 0; k < 1000; k++) {
            long before = witness.calls();
            for (int e = 0; e < 2; e++) {
                write(engines[e], bobs[e], pegs[e], springs[e], k);
                engines[e].step();
            }
            still += witness.calls() == before ? 1 : 0;
            assertThat(bobs[0].getX()).as("step %d", k).isCloseTo(bobs[1].getX(), within(1e-8));
            assertThat(bobs[0].getY()).as("step %d", k).isCloseTo(bobs[1].getY(), within(1e-8));
            assertThat(bobs[0].getVelocityY()).as("step %d", k).isCloseTo(bobs[1].getVelocityY(), within(1e-7));
        }
        assertThat(still).isGreaterThan(600);
    }

    /** Joints that are cut between steps hold no longer. */
    @Test
    void aJointThatIsCutLetsGoAtOnce() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setIntegrator(new DormandPrince853(1e-6));
        engine.setTimeStep(1e-3);
        engine.add(new Gravity(0, -G));
        Body rod = engine.add(new Body(new Rectangle(1, 0.1)).at(0.5, 0));
        PinJoint pin = new PinJoint(rod, null, 0, 0);
        engine.add(pin);
        for (int k = 0; k < 333; k++) {
            engine.step();
        }
        engine.remove(pin);
        double x = rod.getX();
        double y = rod.getY();
        double vx = rod.getVelocityX();
        double vy = rod.getVelocityY();
        for (int k = 1; k < 50; k++) {
            engine.step();
            assertThat(rod.getX()).isCloseTo(x + 1e-3 * k * vx, within(1e-13));
            assertThat(rod.getY()).isCloseTo(y + 1e-3 * k * vy - 0.5 * G * 1e-6 * k * k, within(1e-13));
        }
    }

    /** An author's forces that may depend on the time are asked for within each step, and not beyond it. */
    @ParameterizedTest
    @ValueSource(strings = {"DOP853", "GBS", "Radau", "Automatic"})
    void forcesOfTheTimeAreNotFollowedBeyondTheStep(String method) {
        for (boolean autonomous : new boolean[] {false, true}) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setIntegrator(method(method, 1e-4));
            engine.setTimeStep(1e-3);
            Body bob = engine.add(new Body(new Circle(0.1)).at(1, 0));
            engine.add(new Spring(bob, 0, 0, null, 0, 0, 0.5, 10, 0));
            Witness witness = new Witness(bob, autonomous);
            engine.add(witness);
            double beyond = 0;
            for (int k = 0; k < 500; k++) {
                long before = witness.calls();
                engine.step();
                assertThat(autonomous || witness.calls() > before).isTrue();
                beyond = Math.max(beyond, witness.last() - engine.getTime());
            }
            assertThat(beyond > 1e-12).isEqualTo(autonomous);
        }
    }

    /** A checkpoint in the middle of a stride goes on bit for bit. */
    @ParameterizedTest
    @CsvSource({"orbit, DOP853", "orbit, GBS", "orbit, Radau", "orbit, Automatic", "rods, DOP853", "rods, GBS", "rods, Radau"})
    void aCheckpointInTheMiddleGoesOn(String name, String method) {
        Setup setup = Setup.of(name, method(method, 1e-6), 1e-3);
        PhysicsEngine engine = setup.engine();
        for (int k = 0; k < 700; k++) {
            engine.step();
        }
        long before;
        do {
            before = setup.calls();
            engine.step();
        } while (setup.calls() != before);
        Setup restored = Checkpoint.copy(setup);
        for (int k = 0; k < 1000; k++) {
            engine.step();
            restored.engine().step();
            assertThat(Scenes.hash(restored.engine())).isEqualTo(Scenes.hash(engine));
        }
        assertThat(restored.calls()).isEqualTo(setup.calls());
    }

    /** A bob on a spring that is reflected at a wall on its way: x = cos t until there, and the same again. */
    @ParameterizedTest
    @CsvSource({"DOP853, 1e-6", "DOP853, 1e-10", "GBS, 1e-8", "Radau, 1e-7", "Automatic, 1e-8"})
    void impactsAreFoundOnStrides(String method, double tolerance) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setIntegrator(method(method, tolerance));
        engine.setTimeStep(1.0 / 64);
        Body bob = engine.add(new Body(new Circle(0.1)).at(1, 0));
        bob.setMass(1, 0.01);
        bob.setRestitution(1);
        engine.add(new Spring(bob, 0, 0, null, 10, 0, 10, 1, 0));
        Body wall = engine.add(Body.fixed(new Rectangle(1, 10)).at(-1.1, 0));
        wall.setRestitution(1);
        double half = StrictMath.acos(-0.5);
        for (int k = 1; k <= 64 * 30; k++) {
            engine.step();
            double t = engine.getTime() % (2 * half);
            double phase = t < half ? t : 2 * half - t;
            assertThat(bob.getX()).isCloseTo(StrictMath.cos(phase), within(10 * tolerance * (1 + engine.getTime())));
        }
        assertThat(engine.getImpacts()).isEqualTo(7);
    }

    /** What comes, goes and is pushed elsewhere changes no bit. */
    @Test
    void otherBodiesDoNotMatter() {
        long[] hashes = new long[2];
        for (int e = 0; e < 2; e++) {
            Setup setup = Setup.of("rods", new DormandPrince853(1e-6), 1e-3);
            Body other = null;
            for (int k = 0; k < 500; k++) {
                if (e == 1 && k == 100) {
                    other = setup.engine().add(new Body(new Circle(1)).at(50, 0));
                } else if (e == 1 && k > 200 && k < 300) {
                    other.addForce(1, 0);
                } else if (e == 1 && k == 400) {
                    setup.engine().remove(other);
                }
                setup.engine().step();
            }
            hashes[e] = Scenes.hash(setup.engine());
        }
        assertThat(hashes[1]).isEqualTo(hashes[0]);
    }

    /** A spring to a body that is moved outside the engine, which nobody is told of. */
    @Test
    void aSpringFollowsWhatIsInNoEngine() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setIntegrator(new DormandPrince853(1e-8));
        engine.setTimeStep(1e-3);
        Body bob = engine.add(new Body(new Circle(0.1)));
        Body hand = new Body(new Circle(0.1));
        engine.add(new Spring(bob, 0, 0, hand, 0, 0, 0, bob.getMass(), 0));
        for (int k = 0; k < 100; k++) {
            engine.step();
        }
        assertThat(bob.getX()).isZero();
        hand.setPosition(1, 0);
        engine.step();
        assertThat(bob.getVelocityX()).isCloseTo(1e-3, within(1e-8));
    }

    /** Who is steered in every step is not followed beyond it: no evaluation is wasted on what will not be. */
    @ParameterizedTest
    @ValueSource(strings = {"velocity", "force"})
    void whoIsSteeredInEveryStepIsNotFollowedBeyondIt(String by) {
        Setup setup = Setup.of("orbit", new DormandPrince853(1e-6), 1e-3);
        for (int k = 0; k < 200; k++) {
            if (by.equals("velocity")) {
                setup.body().setVelocity(setup.body().getVelocityX(), setup.body().getVelocityY());
            } else {
                setup.body().addForce(1e-3, 0);
            }
            setup.engine().step();
        }
        assertThat(setup.calls()).isLessThanOrEqualTo(200 * 12 + 30);
    }
}
