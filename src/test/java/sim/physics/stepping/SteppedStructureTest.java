// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sim.physics.stepping.Frames.G;
import static sim.physics.stepping.Frames.falling;
import static sim.physics.stepping.Frames.pin;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping: structures bear what lies on them, stands on them or drives over them. In turns they gave way to it, and lifts and beams fell down. */
class SteppedStructureTest {
    private static final long BEARING = 2;
    private static final long LOAD = 4;

    private static Body load(PhysicsEngine engine, double mass, double x, double y) {
        Body load = Stepped.rough(new Body(new Rectangle(0.5, 0.5)));
        load.setMass(mass);
        return engine.add(load.at(x, y));
    }

    @ParameterizedTest
    @ValueSource(doubles = {2, 22})
    void aLiftBearsABox(double mass) {
        PhysicsEngine engine = falling();
        Body platform = Frames.lift(engine, 3, 2);
        double height = platform.getY();
        Body box = load(engine, mass, platform.getX(), height + 0.3);
        Stepped.run(engine, 600);
        assertThat(platform.getY()).isCloseTo(height, within(1e-4));
        assertThat(box.getY()).isCloseTo(height + 0.3, within(1e-3));
        assertThat(engine.contacts(box).stream().mapToDouble(LastingContact::normalForce).sum()).isCloseTo(mass * G, within(5e-3 * mass * G));
        Body other = load(engine, mass, platform.getX() - 0.6, height + 0.31);
        Stepped.run(engine, 600);
        assertThat(platform.getY()).isCloseTo(height, within(1e-4));
        assertThat(other.getY()).isCloseTo(height + 0.3, within(1e-3));
    }

    /** A beam of twelve welded boxes between two walls, along which balls of five times their mass bounce: it sags by what shows in the first step, and no more. */
    @ParameterizedTest
    @ValueSource(ints = {1, 5})
    void aBeamBearsBallsThatBounce(int balls) {
        PhysicsEngine engine = falling();
        double side = 0.2;
        int count = 14;
        List<Body> beam = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            boolean isEnd = k == 0 || k == count - 1;
            Body box = isEnd ? Body.fixed(new Rectangle(side, side)) : new Body(new Rectangle(side, side));
            if (!isEnd) {
                box.setMass(1);
            }
            box.setRestitution(0);
            box.setCollisionGroup(BEARING, LOAD);
            beam.add(engine.add(box.at(k * side, 0)));
            if (k > 0) {
                engine.add(new WeldJoint(beam.get(k - 1), box, (k - 0.5) * side, 0));
            }
        }
        engine.add(Body.fixed(new Rectangle(side, 2)).at(-side, 0));
        engine.add(Body.fixed(new Rectangle(side, 2)).at(count * side, 0));
        for (int k = 0; k < balls; k++) {
            Body ball = new Body(new Circle(0.1));
            ball.setMass(5);
            ball.setRestitution(0.8);
            ball.setFriction(0.1);
            ball.setCollisionGroup(LOAD, -1);
            ball.setVelocity(1 - 0.4 * k, 0);
            engine.add(ball.at(0.3 + 0.5 * k, 0.21));
        }
        for (int n = 0; n < 1200; n++) {
            engine.step();
            for (int k = 0; k < count; k++) {
                assertThat(Math.hypot(beam.get(k).getX() - k * side, beam.get(k).getY())).isLessThan(3e-3);
            }
        }
    }

    /** What falls, comes to rest and goes far away changes no bit of it, though what hangs together is found anew. */
    @Test
    void whatIsFarAwayChangesNothing() {
        List<Body> alone = new ArrayList<>();
        List<Body> among = new ArrayList<>();
        for (List<Body> those : List.of(alone, among)) {
            PhysicsEngine engine = falling();
            List<Body> others = new ArrayList<>();
            for (int k = 0; those == among && k < 5; k++) {
                Body other = engine.add(new Body(new Circle(0.3)).at(100 + k, 3 + k));
                others.add(other);
                if (k > 0) {
                    pin(engine, other, others.get(k - 1), 99.5 + k, 2.5 + k);
                }
            }
            engine.add(Body.fixed(new Rectangle(20, 1)).at(100, -1));
            Body platform = Frames.lift(engine, 3, 2);
            those.add(platform);
            those.add(load(engine, 15, platform.getX(), platform.getY() + 0.4));
            for (int k = 0; k < 300; k++) {
                if (k == 100 && those == among) {
                    engine.remove(others.get(2));
                }
                engine.step();
            }
        }
        for (int k = 0; k < 2; k++) {
            assertThat(among.get(k).getX()).isEqualTo(alone.get(k).getX());
            assertThat(among.get(k).getY()).isEqualTo(alone.get(k).getY());
            assertThat(among.get(k).getAngle()).isEqualTo(alone.get(k).getAngle());
        }
    }

    /** A beam of welded boxes, held at one end, with a box on the other. */
    @Test
    void aBeamBearsABox() {
        PhysicsEngine engine = falling();
        Body last = null;
        for (int k = 0; k < 10; k++) {
            Body box = Stepped.rough(engine.add(new Body(new Rectangle(1, 0.5)).at(k + 0.5, 0)));
            engine.add(new WeldJoint(box, last, k, 0));
            last = box;
        }
        Body box = load(engine, 0.5, 9.5, 0.5);
        Stepped.run(engine, 600);
        assertThat(last.getY()).isCloseTo(0, within(1e-4));
        assertThat(box.getX()).isCloseTo(9.5, within(0.01));
        assertThat(box.getY()).isCloseTo(0.5, within(1e-3));
    }

    /** A girder of triangles, under a car of as much as seven and forty of its bars. In turns it sagged by a half and more of its height. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 6})
    void aCarDrivesOverAGirder(double mass) {
        PhysicsEngine engine = falling();
        List<Body> deck = Frames.girder(engine);
        for (Body chord : deck) {
            chord.setCollisionGroup(BEARING, LOAD);
        }
        for (int side = -1; side <= 1; side += 2) {
            Body bank = Stepped.rough(engine.add(Body.fixed(new Rectangle(6, 1)).at(4 + 7 * side, -0.45)));
            bank.setCollisionGroup(BEARING, LOAD);
        }
        Body chassis = new Body(new Rectangle(1.2, 0.3));
        chassis.setMass(4 * mass);
        chassis.setCollisionGroup(1, 0);
        engine.add(chassis.at(-2, 0.35));
        for (double x : new double[] {-2.4, -1.6}) {
            Body wheel = Stepped.rough(new Body(new Circle(0.2)));
            wheel.setMass(mass);
            wheel.setCollisionGroup(LOAD, BEARING);
            engine.add(wheel.at(x, 0.25));
            pin(engine, chassis, wheel, x, 0.25);
            engine.add(Motor.turning(wheel, chassis, -8, 20 * mass));
        }
        double lowest = 0;
        for (int k = 0; k < 600; k++) {
            engine.step();
            for (Body chord : deck) {
                lowest = Math.min(lowest, chord.getY());
            }
        }
        assertThat(chassis.getX()).isGreaterThan(10);
        assertThat(lowest).isGreaterThan(-0.01);
    }
}
