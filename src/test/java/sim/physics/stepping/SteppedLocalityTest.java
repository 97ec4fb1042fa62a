// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What is far away changes nothing: a bin of bodies is the same to the last bit with another one a kilometre off, whose bodies were added before or after. */
class SteppedLocalityTest {
    private static final int STEPS = 120;
    private static final int SEEDS = 4;

    /** What the bins are about. */
    enum Kind {
        PLASTIC,
        BOUNCING,
        TIED,
        UNLIKE,
        ON_A_BELT
    }

    private static void surface(Body body, double restitution) {
        body.setFriction(0.5);
        body.setRestitution(restitution);
    }

    private static List<Body> bin(PhysicsEngine engine, Kind kind, double x, int count, SplittableRandom random) {
        List<Body> bodies = new ArrayList<>();
        double restitution = kind == Kind.BOUNCING ? 0.3 + 0.5 * random.nextDouble() : 0;
        Body floor = engine.add(Body.fixed(new Rectangle(12, 1)).at(x, -0.5));
        surface(floor, restitution);
        floor.setBeltSpeed(kind == Kind.ON_A_BELT ? 1 : 0);
        for (int side = -1; side <= 1; side += 2) {
            surface(engine.add(Body.fixed(new Rectangle(1, 20)).at(x + 5 * side, 9)), restitution);
        }
        for (int k = 0; k < count; k++) {
            double width = 0.4 + 0.6 * random.nextDouble();
            double height = 0.4 + 0.6 * random.nextDouble();
            Body body = new Body(random.nextInt(3) == 0 ? new Circle(0.5 * width) : new Rectangle(width, height));
            body.at(x - 3.5 + 7 * random.nextDouble(), 1 + 1.2 * (k / 4) + 0.3 * random.nextDouble(), 6 * random.nextDouble());
            engine.add(body.moving(2 * random.nextDouble() - 1, -3 * random.nextDouble(), 0));
            double mass = StrictMath.pow(10, 2 * random.nextDouble());
            if (kind == Kind.UNLIKE) {
                body.setMass(mass, mass * (width * width + height * height) / 12);
            }
            surface(body, restitution);
            if (kind == Kind.TIED && k % 3 > 0) {
                Body other = bodies.get(k - 1);
                double length = Math.hypot(body.getX() - other.getX(), body.getY() - other.getY());
                engine.add(new RodJoint(other, 0, 0, body, 0, 0, length));
            }
            bodies.add(body);
        }
        return bodies;
    }

    /** Places and velocities in each step of a bin at 0: alone, with another one that was added before it, or after it; or with things that come and go. */
    private static double[] run(Kind kind, int seed, int far, boolean areBorn) {
        SplittableRandom random = new SplittableRandom(seed);
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        engine.add(new Gravity(0, -Stepped.G));
        int count = 5 + random.nextInt(35);
        int farCount = 5 + random.nextInt(70);
        if (far < 0) {
            bin(engine, kind, -1000, farCount, new SplittableRandom(seed + SEEDS));
        }
        List<Body> bodies = bin(engine, kind, 0, count, random);
        if (far > 0) {
            bin(engine, kind, 1000, farCount, new SplittableRandom(seed + SEEDS));
        }
        double[] all = new double[6 * count * STEPS];
        int o = 0;
        for (int k = 0; k < STEPS; k++) {
            if (areBorn) {
                bear(engine, k);
            }
            engine.step();
            for (Body body : bodies) {
                all[o++] = body.getX();
                all[o++] = body.getY();
                all[o++] = body.getAngle();
                all[o++] = body.getVelocityX();
                all[o++] = body.getVelocityY();
                all[o++] = body.getAngularVelocity();
            }
        }
        return all;
    }

    /** Adds a body far away, in every second step one that hangs from a pin or a stiff spring, and removes the one before. */
    private static void bear(PhysicsEngine engine, int k) {
        List<Body> bodies = engine.bodies();
        if (k > 0) {
            engine.remove(bodies.get(bodies.size() - 1));
        }
        Body body = engine.add(new Body(new Circle(0.3)).at(500, k % 7));
        surface(body, 0.5);
        if (k % 4 == 1) {
            engine.add(new PinJoint(body, null, body.getX() + 1, body.getY()));
        } else if (k % 4 == 3) {
            engine.add(new Spring(body, 0, 0, null, body.getX() + 1, body.getY(), 0.5, 1e5, 10));
        }
    }

    @ParameterizedTest
    @EnumSource
    void whatIsFarAwayChangesNoBit(Kind kind) {
        for (int seed = 0; seed < SEEDS; seed++) {
            double[] alone = run(kind, seed, 0, false);
            assertThat(run(kind, seed, -1, false)).as("seed %d, far bodies first", seed).isEqualTo(alone);
            assertThat(run(kind, seed, 1, false)).as("seed %d, far bodies last", seed).isEqualTo(alone);
        }
    }

    /** What is new is solved more often, and that of bounces is solved otherwise where there are joints: both only where that is. */
    @ParameterizedTest
    @EnumSource
    void whatComesAndGoesFarAwayChangesNoBit(Kind kind) {
        for (int seed = 0; seed < SEEDS; seed++) {
            assertThat(run(kind, seed, 0, true)).as("seed %d", seed).isEqualTo(run(kind, seed, 0, false));
        }
    }
}
