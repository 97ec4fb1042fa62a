// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.Arrays;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Euler;
import sim.physics.scenes.SceneData;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** A scene in this engine, in the scene's own units, as delivered (RK4), with Euler, or by time stepping where there are substeps. */
final class OwnRunner implements Runner {
    private final PhysicsEngine engine = new PhysicsEngine();
    private final Body[] bodies;

    OwnRunner(SceneData scene, boolean euler, int substeps) {
        engine.setTimeStep(scene.dt());
        engine.setTimeStepping(substeps);
        engine.setSleepAllowed(false); // nor do the peers
        if (euler) {
            engine.setIntegrator(new Euler());
        }
        Body[] all = bodies(scene);
        for (Body body : all) {
            engine.add(body);
        }
        bodies = Arrays.copyOfRange(all, all.length - scene.size(), all.length);
    }

    /** The walls and then the bodies of a scene, in no engine yet. */
    static Body[] bodies(SceneData scene) {
        Body[] all = new Body[scene.walls().size() + scene.size()];
        int count = 0;
        for (SceneData.Box wall : scene.walls()) {
            Body body = Body.fixed(new Rectangle(wall.width(), wall.height())).at(wall.x(), wall.y());
            body.setRestitution(scene.restitution());
            all[count++] = body;
        }
        for (int i = 0; i < scene.size(); i++) {
            Body body = new Body(shape(scene, i))
                    .at(scene.x()[i], scene.y()[i], scene.theta()[i])
                    .moving(scene.vx()[i], scene.vy()[i], scene.omega()[i]);
            body.setMass(scene.mass()[i], scene.inertia(i));
            body.setRestitution(scene.restitution());
            all[count++] = body;
        }
        return all;
    }

    PhysicsEngine engine() {
        return engine;
    }

    private static Shape shape(SceneData scene, int i) {
        return switch (scene.kind()[i]) {
            case CIRCLE -> new Circle(scene.sizeA()[i]);
            case RECTANGLE -> new Rectangle(scene.sizeA()[i], scene.sizeB()[i]);
            case POLYGON -> new Polygon(scene.outline(i));
        };
    }

    @Override
    public void step() {
        engine.step();
    }

    @Override
    public double kineticEnergy() {
        return engine.kineticEnergy();
    }

    @Override
    public long bodies() {
        return bodies.length;
    }

    @Override
    public double readPoses() {
        double sum = 0;
        for (Body body : bodies) {
            sum += body.getX() + body.getY() + body.getAngle();
        }
        return sum;
    }
}
