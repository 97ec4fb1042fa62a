// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.dynamics.ContinuousDetectionMode;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.PhysicsWorld;
import org.dyn4j.world.World;
import sim.physics.scenes.SceneData;

/**
 * A scene in dyn4j 6.0.0.
 *
 * <p>Settings: 6 velocity and 2 position iterations, as delivered; no sleeping; friction 0; the largest translation and
 * rotation per step (2 m and a half-turn as delivered, which slows fast bodies down) raised out of reach. Restitution of
 * a pair is the larger one (dyn4j's own rule), so 1. The broad phase is the tree, as delivered; the other one, Sap, throws
 * "Cannot insert multiple of the same value" within seconds of the S3 gas.
 */
final class Dyn4jRunner implements Runner {
    /**
     * What differs between the runs.
     *
     * @param ccd whether all bodies are swept against static ones, as delivered
     * @param restitutionVelocity slower approaches do not bounce; 1 m/s as delivered
     */
    record Setup(boolean ccd, double restitutionVelocity) {
        /** As delivered. */
        static final Setup DEFAULT = new Setup(true, 1);
        /** Without continuous collision detection: the fastest on these scenes. */
        static final Setup NO_CCD = new Setup(false, 1);
        /** Slow approaches bounce as well: the most accurate at small time steps. */
        static final Setup NO_CCD_NO_THRESHOLD = new Setup(false, 0);
    }

    private final World<Body> world = new World<>();
    private final Body[] bodies;
    private final double dt;

    Dyn4jRunner(SceneData scene, Setup setup) {
        Units units = Units.of(scene);
        dt = scene.dt() * units.seconds();
        world.setGravity(PhysicsWorld.ZERO_GRAVITY);
        world.getSettings().setStepFrequency(dt);
        world.getSettings().setAtRestDetectionEnabled(false);
        world.getSettings().setMaximumTranslation(1e6);
        world.getSettings().setMaximumRotation(1e6);
        world.getSettings()
                .setContinuousDetectionMode(setup.ccd ? ContinuousDetectionMode.ALL : ContinuousDetectionMode.NONE);
        for (SceneData.Box wall : scene.walls()) {
            Convex shape = Geometry.createRectangle(wall.width() * units.metres(), wall.height() * units.metres());
            add(shape, 1, setup, scene.restitution())
                    .translate(wall.x() * units.metres(), wall.y() * units.metres());
        }
        bodies = new Body[scene.size()];
        for (int i = 0; i < bodies.length; i++) {
            Body body = add(shape(scene, i, units.metres()), scene.mass()[i] / scene.area(i), setup, scene.restitution());
            body.setMass(MassType.NORMAL);
            body.rotate(scene.theta()[i]);
            body.translate(scene.x()[i] * units.metres(), scene.y()[i] * units.metres());
            body.setLinearVelocity(scene.vx()[i] * units.speed(), scene.vy()[i] * units.speed());
            body.setAngularVelocity(scene.omega()[i] / units.seconds());
            bodies[i] = body;
        }
    }

    private Body add(Convex shape, double density, Setup setup, double restitution) {
        BodyFixture fixture = new BodyFixture(shape);
        fixture.setDensity(density);
        fixture.setFriction(0);
        fixture.setRestitution(restitution);
        fixture.setRestitutionVelocity(setup.restitutionVelocity);
        Body body = new Body();
        body.addFixture(fixture);
        body.setMass(MassType.INFINITE);
        body.setLinearDamping(0);
        body.setAngularDamping(0);
        world.addBody(body);
        return body;
    }

    private static Convex shape(SceneData scene, int i, double metres) {
        double a = scene.sizeA()[i] * metres;
        return switch (scene.kind()[i]) {
            case CIRCLE -> Geometry.createCircle(a);
            case RECTANGLE -> Geometry.createRectangle(a, scene.sizeB()[i] * metres);
            case POLYGON -> {
                double[] xy = scene.outline(i);
                Vector2[] vertices = new Vector2[xy.length / 2];
                for (int k = 0; k < vertices.length; k++) {
                    vertices[k] = new Vector2(xy[2 * k] * metres, xy[2 * k + 1] * metres);
                }
                yield Geometry.createPolygon(vertices);
            }
        };
    }

    @Override
    public void step() {
        world.step(1, dt);
    }

    @Override
    public double kineticEnergy() {
        double sum = 0;
        for (Body body : bodies) {
            double spin = body.getAngularVelocity();
            sum += 0.5 * body.getMass().getMass() * body.getLinearVelocity().getMagnitudeSquared()
                    + 0.5 * body.getMass().getInertia() * spin * spin;
        }
        return sum;
    }

    @Override
    public long bodies() {
        return bodies.length;
    }

    @Override
    public double readPoses() {
        double sum = 0;
        for (Body body : bodies) {
            sum += body.getTransform().getTranslationX() + body.getTransform().getTranslationY()
                    + body.getTransform().getRotationAngle();
        }
        return sum;
    }
}
