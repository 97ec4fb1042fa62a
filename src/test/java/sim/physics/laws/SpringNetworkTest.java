// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.hipparchus.ode.ODEState;
import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.hipparchus.ode.nonstiff.DormandPrince853Integrator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.Spring;
import sim.physics.motion.SurfaceFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Nets of springs: their laws, what is coupled by them and what is not, and what they cost. */
class SpringNetworkTest {
    private static final double STIFFNESS = 40;

    /** Masses and the pairs of them that springs of their first distance connect, the work of the tests' own integration. */
    private static final class Net implements OrdinaryDifferentialEquation {
        final List<double[]> masses = new ArrayList<>();
        final List<int[]> springs = new ArrayList<>();
        final List<Double> lengths = new ArrayList<>();
        final List<Spring> made = new ArrayList<>();

        static Net random(int n, long seed) {
            Net net = new Net();
            SplittableRandom random = new SplittableRandom(seed);
            for (int k = 0; k < n; k++) {
                double x = 1.1 * (k % 4) + 0.2 * random.nextDouble();
                double y = 1.1 * (k / 4) + 0.2 * random.nextDouble();
                net.masses.add(new double[] {
                    0.5 + random.nextDouble(), x, y, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1
                });
                if (k > 0) {
                    net.connect(random.nextInt(k), k);
                }
                if (k > 4) {
                    net.connect(k, k - 4);
                }
            }
            return net;
        }

        void connect(int a, int b) {
            springs.add(new int[] {a, b});
            double[] p = masses.get(a);
            double[] q = masses.get(b);
            lengths.add(0.9 * StrictMath.hypot(p[1] - q[1], p[2] - q[2]));
        }

        List<Body> into(PhysicsEngine engine, double dx) {
            List<Body> bodies = new ArrayList<>();
            for (double[] m : masses) {
                Body body = engine.add(new Body(new Circle(0.01)).at(m[1] + dx, m[2]).moving(m[3], m[4]));
                body.setMass(m[0]);
                body.setCollisionGroup(2, 0);
                bodies.add(body);
            }
            made.clear();
            for (int k = 0; k < springs.size(); k++) {
                made.add(spring(bodies, k));
                engine.add(made.get(k));
            }
            return bodies;
        }

        Spring spring(List<Body> bodies, int k) {
            int[] s = springs.get(k);
            return new Spring(bodies.get(s[0]), 0, 0, bodies.get(s[1]), 0, 0, lengths.get(k), STIFFNESS, 0);
        }

        @Override
        public int getDimension() {
            return 4 * masses.size();
        }

        @Override
        public double[] computeDerivatives(double t, double[] y) {
            double[] rate = new double[y.length];
            for (int k = 0; k < masses.size(); k++) {
                rate[4 * k] = y[4 * k + 2];
                rate[4 * k + 1] = y[4 * k + 3];
            }
            for (int k = 0; k < springs.size(); k++) {
                int a = springs.get(k)[0];
                int b = springs.get(k)[1];
                double dx = y[4 * b] - y[4 * a];
                double dy = y[4 * b + 1] - y[4 * a + 1];
                double d = Math.sqrt(dx * dx + dy * dy);
                double f = STIFFNESS * (d - lengths.get(k)) / d;
                rate[4 * a + 2] += f * dx / masses.get(a)[0];
                rate[4 * a + 3] += f * dy / masses.get(a)[0];
                rate[4 * b + 2] -= f * dx / masses.get(b)[0];
                rate[4 * b + 3] -= f * dy / masses.get(b)[0];
            }
            return rate;
        }

        double[] start() {
            double[] y = new double[getDimension()];
            for (int k = 0; k < masses.size(); k++) {
                System.arraycopy(masses.get(k), 1, y, 4 * k, 4);
            }
            return y;
        }

        double[] after(double[] start, double time) {
            return new DormandPrince853Integrator(1e-9, 1, 1e-13, 1e-13)
                    .integrate(this, new ODEState(0, start), time)
                    .getPrimaryState();
        }

        /** How far bodies are from where this has masses. */
        static double off(List<Body> bodies, double[] y) {
            double most = 0;
            for (int k = 0; k < bodies.size(); k++) {
                Body body = bodies.get(k);
                if (body != null) {
                    most = Math.max(most, StrictMath.hypot(body.getX() - y[4 * k], body.getY() - y[4 * k + 1]));
                    most = Math.max(most, 0.1 * StrictMath.hypot(body.getVelocityX() - y[4 * k + 2], body.getVelocityY() - y[4 * k + 3]));
                }
            }
            return most;
        }
    }

    private static double[] momentum(List<Body> bodies) {
        double[] sum = new double[3];
        for (Body b : bodies) {
            sum[0] += b.getMass() * b.getVelocityX();
            sum[1] += b.getMass() * b.getVelocityY();
            sum[2] += b.getMass() * (b.getX() * b.getVelocityY() - b.getY() * b.getVelocityX())
                    + b.getInertia() * b.getAngularVelocity();
        }
        return sum;
    }

    private static double energy(PhysicsEngine engine, List<Spring> springs) {
        double sum = 0;
        for (Body b : engine.bodies()) {
            if (!b.isFixed()) {
                sum += 0.5 * b.getMass() * (b.getVelocityX() * b.getVelocityX() + b.getVelocityY() * b.getVelocityY());
                sum += 0.5 * b.getInertia() * b.getAngularVelocity() * b.getAngularVelocity();
            }
        }
        for (Spring g : springs) {
            sum += g.energy();
        }
        return sum;
    }

    private static void run(PhysicsEngine engine, double time) {
        while (engine.getTime() < time - 1e-9) {
            engine.step();
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 7, 16, 40})
    void movesAsAnIndependentIntegrationSays(int n) {
        Net net = Net.random(n, n);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1e-3);
        List<Body> bodies = net.into(engine, 0);
        double[] before = momentum(bodies);
        double energy = energy(engine, net.made);
        run(engine, 1);
        assertThat(Net.off(bodies, net.after(net.start(), 1))).isLessThan(1e-8);
        assertThat(energy(engine, net.made)).isCloseTo(energy, within(1e-9 * energy));
        for (int k = 0; k < 3; k++) {
            assertThat(momentum(bodies)[k]).isCloseTo(before[k], within(1e-11 * n));
        }
    }

    @Test
    void itsEnergyIsOfTheMethodsOrder() {
        double[] drift = new double[2];
        for (int k = 0; k < 2; k++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(0.02 / (1 << k));
            Net net = Net.random(12, 3);
            net.into(engine, 0);
            double before = energy(engine, net.made);
            run(engine, 2);
            drift[k] = Math.abs(energy(engine, net.made) - before);
        }
        assertThat(drift[0] / drift[1]).isBetween(20.0, 45.0); // RK4 loses energy at the fifth order of the step
    }

    /** Nets that nothing connects are integrated each by itself: to the bit as if each were alone. */
    @Test
    void netsThatAreApartDoNotFeelOneAnother() {
        for (Integrator method : new Integrator[] {new RungeKutta4(), new DormandPrince853(1e-6)}) {
            PhysicsEngine both = new PhysicsEngine();
            PhysicsEngine first = new PhysicsEngine();
            PhysicsEngine second = new PhysicsEngine();
            for (PhysicsEngine engine : List.of(both, first, second)) {
                engine.setTimeStep(0.05);
                engine.setIntegrator(method);
            }
            List<Body> mixed = new ArrayList<>(Net.random(5, 1).into(both, 0));
            mixed.addAll(Net.random(6, 2).into(both, 100));
            List<Body> alone = new ArrayList<>(Net.random(5, 1).into(first, 0));
            alone.addAll(Net.random(6, 2).into(second, 100));
            for (PhysicsEngine engine : List.of(both, first, second)) {
                run(engine, 2);
            }
            for (int k = 0; k < mixed.size(); k++) {
                assertThat(mixed.get(k).getX()).isEqualTo(alone.get(k).getX());
                assertThat(mixed.get(k).getVelocityY()).isEqualTo(alone.get(k).getVelocityY());
            }
        }
    }

    /** Acts on the bodies that it names and counts how often it is asked. */
    private static class Counting implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final List<Body> bodies;
        private final boolean names;
        private long asked;
        private long evaluations;

        Counting(boolean names, Body... bodies) {
            this.names = names;
            this.bodies = List.of(bodies);
        }

        @Override
        public List<Body> getBodies() {
            return names ? bodies : null;
        }

        @Override
        public boolean isCoupled() {
            return bodies.size() > 1;
        }

        @Override
        public boolean actsOn(Body body) {
            asked++;
            return bodies.contains(body);
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            evaluations++;
            assertThat(bodies).contains(body);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {10, 100, 1000})
    void forcesCostAsMuchAsThereAre(int n) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        List<Counting> all = new ArrayList<>();
        Body last = null;
        for (int k = 0; k < n; k++) {
            Body body = engine.add(new Body(new Circle(0.1)).at(k, 0).moving(0, 0.1));
            Counting force = last == null ? new Counting(true, body) : new Counting(true, last, body);
            engine.add(force);
            all.add(force);
            last = body;
        }
        engine.step();
        long asked = all.stream().mapToLong(g -> g.asked).sum();
        assertThat(asked).isEqualTo(2L * n - 1);
        long evaluations = all.stream().mapToLong(g -> g.evaluations).sum();
        assertThat(evaluations).isEqualTo(4 * (2L * n - 1));
        for (int k = 0; k < 9; k++) {
            engine.step();
        }
        assertThat(all.stream().mapToLong(g -> g.asked).sum()).isEqualTo(asked);
        assertThat(all.stream().mapToLong(g -> g.evaluations).sum()).isEqualTo(10 * evaluations);
    }

    /** Those that do not name their bodies are asked about each once, when it comes. */
    @Test
    void whoDoesNotNameItsBodiesIsAskedOnceAboutEach() {
        PhysicsEngine engine = new PhysicsEngine();
        Body one = engine.add(new Body(new Circle(0.1)));
        Counting force = new Counting(false, one);
        engine.add(force);
        for (int k = 0; k < 10; k++) {
            engine.add(new Body(new Circle(0.1)).at(k + 1, 0));
        }
        for (int k = 0; k < 10; k++) {
            engine.step();
        }
        assertThat(force.asked).isEqualTo(11);
        one.setSurfaceFriction(0.3); // a property has been set
        engine.step();
        assertThat(force.asked).isEqualTo(12);
        assertThat(force.evaluations).isEqualTo(4 * 11);
    }

    /** Notes in which order forces are asked for. */
    private static final class Noting extends Counting {
        private static final long serialVersionUID = 1L;

        private final transient List<Object> calls;

        Noting(List<Object> calls, boolean names, Body body) {
            super(names, body);
            this.calls = calls;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            calls.add(this);
        }
    }

    /** Sums of forces are taken in the order in which these were added, whatever came, went and came again. */
    @Test
    void forcesAddUpInTheOrderOfAdding() {
        PhysicsEngine engine = new PhysicsEngine();
        Body body = engine.add(new Body(new Circle(0.1)));
        List<Object> calls = new ArrayList<>();
        List<Noting> all = new ArrayList<>();
        for (int k = 0; k < 7; k++) {
            all.add(new Noting(calls, k % 3 != 1, body));
            engine.add(all.get(k));
        }
        engine.step();
        assertThat(calls.subList(0, 7)).isEqualTo(all);
        for (int k : new int[] {5, 1, 0}) {
            engine.remove(all.get(k));
            engine.step();
            engine.add(all.get(k));
            all.add(all.remove(k));
            calls.clear();
            engine.step();
            assertThat(calls.subList(0, 7)).isEqualTo(all);
        }
    }

    /** Two balls that meet at 0.6, and what is done then. */
    private static PhysicsEngine meeting(double step, Runnable then) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.add(new Body(new Circle(1)).at(50, 0).moving(1, 0));
        engine.add(new Body(new Circle(1)).at(52.6, 0));
        engine.addListener(new CollisionListener() {
            @Override
            public void collided(Contact contact) {
                then.run();
            }
        });
        return engine;
    }

    /** A mass leaves in the middle of a step; the others go on from there, its spring's other end staying where it was. */
    @ParameterizedTest
    @ValueSource(ints = {0, 3, 5})
    void aMassLeavesWithinAStep(int leaver) {
        Net net = Net.random(6, 9);
        PhysicsEngine[] engine = new PhysicsEngine[1];
        List<Body> bodies = new ArrayList<>();
        engine[0] = meeting(0.0064, () -> {
            net.made.stream().filter(g -> g.actsOn(bodies.get(leaver))).forEach(engine[0]::remove);
            engine[0].remove(bodies.get(leaver));
        });
        bodies.addAll(net.into(engine[0], 0));
        run(engine[0], 0.7);
        double[] y = net.after(net.start(), 0.6);
        for (int k = net.springs.size() - 1; k >= 0; k--) {
            if (net.springs.get(k)[0] == leaver || net.springs.get(k)[1] == leaver) {
                net.springs.remove(k);
                net.lengths.remove(k);
            }
        }
        y = net.after(y, engine[0].getTime() - 0.6);
        bodies.set(leaver, null);
        assertThat(Net.off(bodies, y)).isLessThan(3e-6);
    }

    /** The same without its springs, which hold on to where it was: only momentum beside them is left to compare. */
    @Test
    void whatACoupledBodyLeavesBehindGoesOn() {
        double[] end = new double[2];
        for (int k = 0; k < 2; k++) {
            PhysicsEngine[] engine = new PhysicsEngine[1];
            List<Body> bodies = new ArrayList<>();
            engine[0] = meeting(k == 0 ? 0.0096 : 0.00048, () -> engine[0].remove(bodies.get(2)));
            Net net = new Net();
            for (int m = 0; m < 3; m++) {
                net.masses.add(new double[] {1, 1.2 * m, 0.1 * m * m, 0.3 * m, -0.2 * m});
            }
            net.connect(0, 1);
            net.connect(1, 2);
            bodies.addAll(net.into(engine[0], 0));
            run(engine[0], 1.2);
            end[k] = bodies.get(0).getX();
        }
        assertThat(end[0]).isCloseTo(end[1], within(1e-7));
    }

    /** A spring that is added in the middle of a step connects two nets from there on. */
    @Test
    void aSpringConnectsTwoNetsWithinAStep() {
        Net net = Net.random(4, 5);
        Net other = Net.random(5, 6);
        for (double[] m : other.masses) {
            m[1] += 6;
        }
        int n = net.masses.size();
        net.masses.addAll(other.masses);
        for (int[] s : other.springs) {
            net.connect(s[0] + n, s[1] + n);
        }
        List<Body> bodies = new ArrayList<>();
        PhysicsEngine[] engine = new PhysicsEngine[1];
        engine[0] = meeting(0.0032, () -> {
            net.connect(1, n + 2);
            engine[0].add(net.spring(bodies, net.springs.size() - 1));
        });
        bodies.addAll(net.into(engine[0], 0));
        double[] before = momentum(bodies);
        double[] y = net.after(net.start(), 0.6);
        run(engine[0], 1);
        y = net.after(y, engine[0].getTime() - 0.6);
        assertThat(Net.off(bodies, y)).isLessThan(3e-6);
        assertThat(momentum(bodies)[0]).isCloseTo(before[0], within(1e-6)); // what is written in a step starts from its path
        assertThat(momentum(bodies)[2]).isCloseTo(before[2], within(1e-6));
    }

    /** A generator that couples from some time on only. */
    private static final class Later implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final Body a;
        private final Body b;
        private boolean on;

        Later(Body a, Body b) {
            this.a = a;
            this.b = b;
        }

        @Override
        public boolean isCoupled() {
            return on;
        }

        @Override
        public boolean actsOn(Body body) {
            return body == a || body == b;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            if (on) {
                double f = 30 * (a.getX() - b.getX());
                forces.add(body, body == a ? -f : f, 0);
            }
        }
    }

    @Test
    void whetherAForceCouplesIsAskedInEachStep() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        Body a = engine.add(new Body(new Circle(0.1)).at(0, 0));
        Body b = engine.add(new Body(new Circle(0.1)).at(1, 1));
        a.setMass(1);
        b.setMass(1);
        Later force = new Later(a, b);
        engine.add(force);
        engine.step();
        force.on = true;
        run(engine, 1.01);
        double x = 0.5 - 0.5 * StrictMath.cos(Math.sqrt(60));
        assertThat(a.getX()).isCloseTo(x, within(2e-6));
        assertThat(b.getX()).isCloseTo(1 - x, within(2e-6));
    }

    /** Mechanisms that springs connect move together, and no others; pins stay closed, and momentum is kept. */
    @Test
    void springsConnectMechanisms() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.001);
        List<Body> rods = new ArrayList<>();
        List<PinJoint> pins = new ArrayList<>();
        for (int m = 0; m < 3; m++) {
            for (int k = 0; k < 3; k++) {
                Body rod = engine.add(new Body(new Rectangle(1, 0.02)).at(k, 2.0 * m).moving(0.2 * k, 0.3 * m - 0.1 * k));
                rod.setMass(1, 0.1);
                rod.setCollisionGroup(1, 0);
                rods.add(rod);
                if (k > 0) {
                    pins.add(engine.add(new PinJoint(rods.get(3 * m + k - 1), rod, k - 0.5, 2.0 * m)));
                }
            }
        }
        Body ball = engine.add(new Body(new Circle(0.1)).at(0, -2));
        ball.setCollisionGroup(1, 0);
        List<Spring> springs = List.of(
                new Spring(rods.get(0), 0.3, 0, rods.get(4), 0, 0.1, 1, 30, 0),
                new Spring(rods.get(1), 0, 0, ball, 0.05, 0, 1.5, 30, 0));
        springs.forEach(engine::add);
        rods.add(ball);
        engine.step();
        double[] before = momentum(rods);
        double energy = energy(engine, springs);
        double[] third = momentum(rods.subList(6, 9));
        run(engine, 3);
        for (int k = 0; k < 3; k++) {
            assertThat(momentum(rods)[k]).isCloseTo(before[k], within(1e-7));
            assertThat(momentum(rods.subList(6, 9))[k]).isCloseTo(third[k], within(1e-8));
        }
        assertThat(energy(engine, springs)).isCloseTo(energy, within(1e-6 * energy));
        for (PinJoint pin : pins) {
            assertThat(gap(pin)).isLessThan(1e-9);
        }
    }

    private static double gap(PinJoint pin) {
        double[] at = new double[2];
        for (Body body : List.of(pin.getBodyA(), pin.getBodyB())) {
            boolean first = body == pin.getBodyA();
            double x = first ? pin.getAnchorAX() : pin.getAnchorBX();
            double y = first ? pin.getAnchorAY() : pin.getAnchorBY();
            double cos = StrictMath.cos(body.getAngle());
            double sin = StrictMath.sin(body.getAngle());
            at[0] += (first ? 1 : -1) * (body.getX() + cos * x - sin * y);
            at[1] += (first ? 1 : -1) * (body.getY() + sin * x + cos * y);
        }
        return StrictMath.hypot(at[0], at[1]);
    }

    /** A box that the ground holds, far from any spring, is not driven; nor does it matter to one that slides to its stop. */
    @Test
    void theGroundHoldsWhatNoSpringPulls() {
        double[] way = new double[2];
        for (int with = 0; with < 2; with++) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(0.01);
            engine.add(new SurfaceFriction(9.81));
            Body box = engine.add(new Body(new Rectangle(0.6, 0.4)).moving(2, 0.5));
            box.setSurfaceFriction(0.4);
            Body a = engine.add(new Body(new Circle(0.1)).at(10, 0));
            Body b = engine.add(new Body(new Circle(0.1)).at(12, 0));
            if (with == 1) {
                engine.add(new Spring(a, 0, 0, b, 0, 0, 1, 10, 0));
            }
            run(engine, 2);
            assertThat(box.getVelocityX()).isZero();
            assertThat(a.getVelocityX() != 0).isEqualTo(with == 1);
            way[with] = box.getX();
        }
        assertThat(way[1]).isEqualTo(way[0]);
    }

    /** A restored engine goes on as it was, and takes and gives back springs. */
    @Test
    void aCheckpointKeepsWhatIsCoupled() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        engine.add(new Gravity(0, -1));
        Net net = Net.random(9, 4);
        net.into(engine, 0);
        Net.random(5, 8).into(engine, 20);
        run(engine, 0.5);
        Object[] restored = Checkpoint.copy(new Object[] {engine, net.made.get(2)});
        for (Object[] pair : new Object[][] {{engine, net.made.get(2)}, restored}) {
            PhysicsEngine one = (PhysicsEngine) pair[0];
            run(one, 1);
            one.add(new Spring(one.bodies().get(3), 0, 0, one.bodies().get(11), 0, 0, 10, STIFFNESS, 0));
            run(one, 1.5);
            one.remove((Spring) pair[1]);
            one.remove(one.bodies().get(10));
            run(one, 2);
        }
        assertThat(Scenes.hash((PhysicsEngine) restored[0])).isEqualTo(Scenes.hash(engine));
    }
}
