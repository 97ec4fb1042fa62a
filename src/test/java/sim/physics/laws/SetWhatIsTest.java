// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SlotJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.KinematicBody;
import sim.physics.motion.Spring;
import sim.physics.motion.SurfaceFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Controllers set bodies in each step, often to what these are: that changes nothing, and what changes little changes little. */
class SetWhatIsTest {
    private static final int STEPS = 90;

    private static Body rough(Body body, double friction) {
        body.setRestitution(0);
        body.setFriction(friction);
        return body;
    }

    private static Body box(PhysicsEngine engine, double x, double y) {
        return rough(engine.add(new Body(new Rectangle(1, 1)).at(x, y)), 0.5);
    }

    private static PhysicsEngine scene(String name, int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.setTimeStepping(substeps);
        if (name.equals("plane")) {
            engine.add(new SurfaceFriction(9.81));
            for (int k = 0; k < 8; k++) {
                Body robot = rough(engine.add(new Body(new Rectangle(1, 0.6)).at(1.3 * (k % 4), 1.3 * (k / 4))), 0.3);
                robot.moving(2 * Math.sin(k), Math.cos(k), 1).setSurfaceFriction(0.05);
            }
            return engine;
        }
        engine.add(new Gravity(0, -9.81));
        Body ground = rough(engine.add(Body.fixed(new Rectangle(400, 2)).at(0, -1)), 0.6);
        switch (name) {
            case "car" -> car(engine);
            case "walker" -> walker(engine);
            case "stack" -> List.of(0, 1, 2, 3).forEach(k -> box(engine, 0.02 * (k % 2), 0.5 + k));
            case "pile" -> pile(engine);
            case "chain" -> chain(engine);
            case "lift" -> {
                rough(engine.add(new KinematicBody(new Rectangle(4, 0.4))), 0.6).at(0, 1).moving(0.3, 0.2);
                box(engine, 0, 1.7).moving(0.3, 0.2);
            }
            default -> {
                ground.setBeltSpeed(-2);
                box(engine, 0, 0.5);
                box(engine, 3, 0.5);
            }
        }
        return engine;
    }

    private static void car(PhysicsEngine engine) {
        rough(engine.add(Body.fixed(new Rectangle(0.5, 0.1)).at(2.5, 0.05)), 0.6);
        Body chassis = rough(engine.add(new Body(new Rectangle(3, 0.5)).at(0, 0.9)), 0.6);
        for (int x = -1; x <= 1; x += 2) {
            Body wheel = rough(engine.add(new Body(new Circle(0.4)).at(x, 0.4)), 0.8);
            engine.add(new SlotJoint(wheel, chassis, x, 0.4, 0, 1));
            engine.add(new Spring(wheel, 0, 0, chassis, x, 0, 0.5, 400, 20));
            engine.add(Motor.turning(wheel, chassis, -6, 10));
        }
    }

    private static void walker(PhysicsEngine engine) {
        Body trunk = rough(engine.add(new Body(new Rectangle(0.8, 0.8)).at(0, 1.6)), 0.5);
        for (int side = -1; side <= 1; side += 2) {
            Body thigh = rough(engine.add(new Body(new Rectangle(0.15, 0.6)).at(0.1 * side, 0.9)), 0.5);
            Body shank = rough(engine.add(new Body(new Rectangle(0.15, 0.6)).at(0.1 * side, 0.3)), 0.8);
            thigh.setCollisionGroup(2, 1);
            shank.setCollisionGroup(2, 1);
            engine.add(new PinJoint(thigh, trunk, 0.1 * side, 1.2));
            engine.add(new PinJoint(shank, thigh, 0.1 * side, 0.6));
            engine.add(Motor.turning(thigh, trunk, -side, 20));
            engine.add(Motor.turning(shank, thigh, side, 15));
            engine.add(Limit.angle(thigh, trunk, -0.8, 0.8));
        }
    }

    private static void pile(PhysicsEngine engine) {
        for (int k = 0; k < 12; k++) {
            Body body = new Body(k % 3 == 0 ? new Rectangle(0.9, 0.6) : new Circle(0.4));
            rough(engine.add(body.at(1.1 * (k % 3), 0.6 + k / 3 * 1.1, 0.1 * k)), 0.4).setRestitution(0.2);
        }
    }

    private static void chain(PhysicsEngine engine) {
        Body last = null;
        for (int k = 0; k < 8; k++) {
            Body link = engine.add(new Body(new Rectangle(1, 0.1)).at(k + 0.5, 10));
            engine.add(last == null ? new PinJoint(link, 0, 10) : new PinJoint(link, last, k, 10));
            last = link;
        }
    }

    /** Sets all that there is to set to what it is. */
    private static void setAll(PhysicsEngine engine) {
        for (Body body : engine.bodies()) {
            body.setPosition(body.getX(), body.getY());
            body.setAngle(body.getAngle());
            body.setVelocity(body.getVelocityX(), body.getVelocityY());
            body.setAngularVelocity(body.getAngularVelocity());
            body.setShape(body.getShape());
            body.setSurfaceFriction(body.getSurfaceFriction(), body.getSurfaceStaticFriction());
            body.setCollisionGroup(body.getCategory(), body.getCollidesWith());
            if (body.isDynamic()) {
                body.setMass(body.getMass(), body.getInertia());
                body.addImpulse(0, 0);
            }
        }
    }

    private static double[] run(PhysicsEngine engine, Consumer<PhysicsEngine> setter) {
        for (int k = 0; k < STEPS; k++) {
            setter.accept(engine);
            engine.step();
        }
        return engine.bodies().stream().flatMapToDouble(b -> java.util.stream.DoubleStream.of(
                b.getX(), b.getY(), b.getAngle(), b.getVelocityX(), b.getVelocityY(), b.getAngularVelocity())).toArray();
    }

    /** What is set to what it is, in each step, goes the same way to the last bit, and costs the same. */
    @ParameterizedTest
    @CsvSource({"car, 0", "car, 4", "walker, 0", "walker, 4", "stack, 0", "stack, 4", "pile, 0", "pile, 4", "chain, 0", "chain, 4", "lift, 0", "lift, 4",
        "belt, 0", "belt, 4", "plane, 0", "plane, 4"})
    void whatIsSetToWhatItIsGoesOn(String name, int substeps) {
        PhysicsEngine alone = scene(name, substeps);
        PhysicsEngine engine = scene(name, substeps);
        assertThat(run(engine, SetWhatIsTest::setAll)).isEqualTo(run(alone, e -> { }));
        assertThat(engine.getWork()).isEqualTo(alone.getWork());
    }

    /** Sets all bodies, or none, when two collide. */
    private static final class Setter implements CollisionListener {
        private static final long serialVersionUID = 1L;
        private final PhysicsEngine engine;
        private final boolean sets;
        private int told;

        Setter(PhysicsEngine engine, boolean sets) {
            this.engine = engine;
            this.sets = sets;
        }

        @Override
        public Decision colliding(Contact contact) {
            if (sets) {
                setAll(engine);
            }
            return Decision.BOUNCE;
        }

        @Override
        public void collided(Contact contact) {
            told++;
            colliding(contact);
        }
    }

    /** Nor does it matter if a listener does so, within the step: what it reads is what holds then. */
    @ParameterizedTest
    @CsvSource({"car, 0", "car, 4", "walker, 0", "pile, 0", "pile, 4", "lift, 0", "plane, 0"})
    void norDoesItMatterWithinAStep(String name, int substeps) {
        double[][] ends = new double[2][];
        int told = 0;
        for (int k = 0; k < 2; k++) {
            PhysicsEngine engine = scene(name, substeps);
            Setter setter = new Setter(engine, k == 1);
            engine.addListener(setter);
            ends[k] = run(engine, e -> { });
            told = setter.told;
        }
        assertThat(told).isGreaterThan(0);
        assertThat(ends[1]).isEqualTo(ends[0]);
    }

    private static double farthest(double[] one, double[] other) {
        double most = 0;
        for (int k = 0; k < one.length; k++) {
            most = Math.max(most, k % 6 < 3 ? Math.abs(one[k] - other[k]) : 0);
        }
        return most;
    }

    /** By time stepping, joints are not closed for a velocity that is set: a car was off by 3 mm, and a walker by 0.3 m, however little was set. */
    @ParameterizedTest
    @ValueSource(strings = {"car", "walker", "chain"})
    void aVelocityThatChangesLittleChangesLittle(String name) {
        double[] alone = run(scene(name, 4), e -> { });
        for (double by : new double[] {1e-9, 1e-6}) {
            double[] set = run(scene(name, 4), engine -> engine.bodies().stream().filter(Body::isDynamic).forEach(body -> {
                body.setVelocity(body.getVelocityX() + by, body.getVelocityY() - by);
                body.setAngularVelocity(body.getAngularVelocity() + by);
            }));
            assertThat(farthest(set, alone)).isBetween(1e-2 * by, 1e3 * by);
        }
    }

    /** By events, what lies and is put elsewhere by less than contacts may be deep goes on to lie: it fell anew, at ten times the cost and more. */
    @ParameterizedTest
    @ValueSource(strings = {"car", "stack", "pile"})
    void aPlaceThatChangesLittleChangesLittle(String name) {
        PhysicsEngine alone = scene(name, 0);
        run(alone, e -> { });
        PhysicsEngine engine = scene(name, 0);
        int[] step = {0};
        run(engine, e -> e.bodies().stream().filter(Body::isDynamic).forEach(body -> body.setPosition(body.getX(), body.getY() + 1e-10 * (step[0]++ % 2))));
        for (int k = 0; k < engine.bodies().size(); k++) {
            double off = Math.hypot(engine.bodies().get(k).getX() - alone.bodies().get(k).getX(), engine.bodies().get(k).getY() - alone.bodies().get(k).getY());
            assertThat(off).isLessThan(name.equals("pile") ? 0.01 : 1e-6);
        }
        assertThat((double) engine.getWork()).isLessThan(name.equals("stack") ? Double.MAX_VALUE : 2 * alone.getWork());
    }

    /** What a rod on a pin is told of its centre turns it by angular momentum about the pin: 3 v / 2 L. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 4})
    void aRodOnAPinTurnsAsItsCentreIsTold(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.setTimeStepping(substeps);
        Body rod = engine.add(new Body(new Rectangle(2, 0.1)).at(1, 0));
        rod.setMass(3, 3 * 2 * 2 / 12.0);
        engine.add(new PinJoint(rod, 0, 0));
        engine.step();
        rod.setVelocity(0, 2);
        rod.setAngularVelocity(0);
        for (int k = 0; k < 10; k++) {
            engine.step();
            assertThat(rod.getAngularVelocity()).isCloseTo(1.5, within(5e-4));
            assertThat(Math.hypot(rod.worldX(-1, 0), rod.worldY(-1, 0))).isLessThan(3e-4);
        }
    }

    /** What a joint is set to, or a body is put to, still closes joints at once by time stepping. */
    @Test
    void whatIsPutElsewhereTakesTheOthersAlong() {
        PhysicsEngine engine = scene("car", 4);
        run(engine, e -> { });
        Body chassis = engine.bodies().get(2);
        Body wheel = engine.bodies().get(3);
        double from = chassis.localX(wheel.getX(), wheel.getY());
        chassis.setPosition(chassis.getX() + 5, chassis.getY() + 3);
        engine.step();
        assertThat(chassis.localX(wheel.getX(), wheel.getY())).isCloseTo(from, within(5e-3));
    }

    /** A velocity that a kinematic body has already ends what it was to reach. */
    @Test
    void theVelocityThatItHasEndsACourse() {
        for (int substeps : new int[] {0, 4}) {
            PhysicsEngine engine = scene("lift", substeps);
            KinematicBody lift = (KinematicBody) engine.bodies().get(1);
            lift.setTargetVelocity(0, 0, 0);
            lift.setVelocity(0.3, 0.2);
            run(engine, e -> { });
            assertThat(lift.getX()).isCloseTo(0.3 * STEPS / 60, within(1e-9));
            lift.setTargetVelocity(0, 0, 0);
            engine.step();
            double x = lift.getX();
            run(engine, e -> lift.setVelocity(0, 0));
            assertThat(lift.getX()).isEqualTo(x);
        }
    }
}
