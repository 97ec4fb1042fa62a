// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.KinematicBody;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Rectangle;

/** What crashes, or is put, deep into walls that join others comes out again, under time stepping: it fell through them, as nothing held it any more. */
class PressedIntoWallsTest {
    private enum Room {
        /** A floor and two walls that stand on it. */
        BODIES,
        /** The same as one body. */
        COMPOUND,
        /** A floor of tiles. */
        TILES
    }

    private static PhysicsEngine room(Room room) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        engine.add(new Gravity(0, -Stepped.G));
        if (room == Room.COMPOUND) {
            Stepped.rough(engine.add(new KinematicBody(walls(2, 0.5))));
            return engine;
        }
        for (int side = -1; side <= 1; side += 2) {
            Stepped.rough(engine.add(Body.fixed(new Rectangle(0.5, 4)).at(2.25 * side, 0)));
        }
        int tiles = room == Room.TILES ? 5 : 1;
        for (int k = 0; k < tiles; k++) {
            Stepped.rough(engine.add(Body.fixed(new Rectangle(5.0 / tiles, 0.5)).at(-2.5 + 5 * (k + 0.5) / tiles, -2.25)));
        }
        return engine;
    }

    /** Four walls around a square. */
    private static Compound walls(double half, double thick) {
        double way = half + thick / 2;
        double length = 2 * (half + thick);
        return new Compound(
                Compound.box(0, -way, length, thick),
                Compound.box(0, way, length, thick),
                Compound.box(-way, 0, thick, 2 * half),
                Compound.box(way, 0, thick, 2 * half));
    }

    /** Deeper than half the size of the body, but less than half its height; and a disc whose middle is in the floor. */
    @ParameterizedTest
    @EnumSource(Room.class)
    void whatIsDeepInTheFloorComesOut(Room room) {
        for (int k = 0; k <= 32; k++) {
            double x = 0.05 * k;
            requireOut(room, new Body(new Rectangle(0.4, 0.3)).at(x, -2 + 0.15 - 0.14), 0.15);
            requireOut(room, new Body(new Circle(0.2)).at(x, -2 + 0.2 - 0.32), 0.2);
        }
    }

    private static void requireOut(Room room, Body body, double height) {
        PhysicsEngine engine = room(room);
        double x = body.getX();
        Stepped.rough(engine.add(body));
        Stepped.run(engine, 120);
        assertThat(body.getY()).as("%s, put at %s", body, x).isCloseTo(-2 + height, within(1e-3));
    }

    /** A block of 100 bodies that falls onto the floor of a drum, which turns: what was lowest was pressed through walls that are thicker than it. */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.5, 3})
    void nothingLeavesADrum(double spin) {
        PhysicsEngine engine = drum(spin);
        engine.setTimeStepping(4);
        for (int k = 0; k < 180; k++) {
            engine.step();
        }
        requireInside(engine);
    }

    /** By events, steps that cost too much are relieved, and so there. */
    @ParameterizedTest
    @ValueSource(longs = {1000, 100_000})
    void nothingLeavesADrumWhoseStepsAreRelieved(long limit) {
        PhysicsEngine engine = drum(3);
        engine.setWorkLimit(limit);
        for (int k = 0; k < 180; k++) {
            engine.step();
        }
        assertThat(engine.getRelievedSteps()).isPositive();
        requireInside(engine);
    }

    private static void requireInside(PhysicsEngine engine) {
        Body drum = engine.bodies().get(0);
        for (Body body : engine.bodies()) {
            if (body != drum) {
                double x = drum.localX(body.getX(), body.getY());
                double y = drum.localY(body.getX(), body.getY());
                assertThat(Math.max(Math.abs(x), Math.abs(y))).as(body.toString()).isLessThan(5);
            }
        }
    }

    private static PhysicsEngine drum(double spin) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.add(new Gravity(0, -9.81));
        KinematicBody drum = engine.add(new KinematicBody(walls(5, 0.5)));
        drum.moving(0, 0, spin);
        drum.setTargetVelocity(0, 0, spin);
        drum.setFriction(0.4);
        for (int k = 0; k < 100; k++) {
            Body body = new Body(k % 2 == 0 ? new Circle(0.2) : new Rectangle(0.4, 0.3)).at(0.5 * (k % 10) - 2.25, 0.5 * (k / 10) - 2.25);
            body.setFriction(0.4);
            body.setRestitution(0.1);
            engine.add(body);
        }
        return engine;
    }
}
