// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors

import sim.engine.SimState;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** A ball on a table: the smallest model that uses the engine. */
public class Billiards extends SimState {
    private static final long serialVersionUID = 1L;

    public PhysicsEngine physics;
    public Body ball;

    public Billiards(long seed) {
        super(seed);
    }

    @Override
    public void start() {
        super.start();
        physics = new PhysicsEngine();
        physics.add(Body.fixed(new Rectangle(200, 6)).at(100, 0));
        physics.add(Body.fixed(new Rectangle(200, 6)).at(100, 100));
        physics.add(Body.fixed(new Rectangle(6, 100)).at(0, 50));
        physics.add(Body.fixed(new Rectangle(6, 100)).at(200, 50));
        ball = physics.add(new Body(new Circle(5)).at(50, 50).moving(3, 2));
        physics.scheduleOn(schedule);
    }

    public static void main(String[] args) {
        Billiards game = new Billiards(1);
        game.start();
        double energy = game.physics.kineticEnergy();
        while (game.schedule.getSteps() < 1000) {
            game.schedule.step(game);
        }
        System.out.println(game.ball + " after " + game.physics.getImpacts() + " impacts; energy "
                + game.physics.kineticEnergy() / energy + " of the start");
        game.finish();
    }
}
