// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import sim.physics.scenes.SceneData;

/**
 * A scene in JBox2D 2.2.1.1.
 *
 * <p>Settings: 8 velocity and 3 position iterations, no sleeping, friction 0, no body is a bullet. Restitution of a pair
 * is the larger one, so 1. Not settable there: single precision, restitution threshold 1 m/s, at most 2 m and a
 * quarter-turn per step (see {@link Units}).
 */
final class JBox2DRunner implements Runner {
    private static final int VELOCITY_ITERATIONS = 8;
    private static final int POSITION_ITERATIONS = 3;

    private final World world = new World(new Vec2(0, 0));
    private final Body[] bodies;
    private final float dt;

    JBox2DRunner(SceneData scene, boolean ccd) {
        Units units = Units.of(scene);
        dt = (float) (scene.dt() * units.seconds());
        world.setAllowSleep(false);
        world.setContinuousPhysics(ccd);
        for (SceneData.Box wall : scene.walls()) {
            BodyDef def = at(BodyType.STATIC, wall.x() * units.metres(), wall.y() * units.metres());
            add(def, box(wall.width() * units.metres(), wall.height() * units.metres()), 0, scene.restitution());
        }
        bodies = new Body[scene.size()];
        for (int i = 0; i < bodies.length; i++) {
            BodyDef def = at(BodyType.DYNAMIC, scene.x()[i] * units.metres(), scene.y()[i] * units.metres());
            def.angle = (float) scene.theta()[i];
            def.linearVelocity.set((float) (scene.vx()[i] * units.speed()), (float) (scene.vy()[i] * units.speed()));
            def.angularVelocity = (float) (scene.omega()[i] / units.seconds());
            double density = scene.mass()[i] / scene.area(i);
            bodies[i] = add(def, shape(scene, i, units.metres()), density, scene.restitution());
        }
    }

    private static BodyDef at(BodyType type, double x, double y) {
        BodyDef def = new BodyDef();
        def.type = type;
        def.position.set((float) x, (float) y);
        def.allowSleep = false;
        return def;
    }

    private Body add(BodyDef def, Shape shape, double density, double restitution) {
        FixtureDef fixture = new FixtureDef();
        fixture.shape = shape;
        fixture.density = (float) density;
        fixture.friction = 0;
        fixture.restitution = (float) restitution;
        Body body = world.createBody(def);
        body.createFixture(fixture);
        return body;
    }

    private static Shape shape(SceneData scene, int i, double metres) {
        double a = scene.sizeA()[i] * metres;
        return switch (scene.kind()[i]) {
            case CIRCLE -> {
                CircleShape circle = new CircleShape();
                circle.m_radius = (float) a;
                yield circle;
            }
            case RECTANGLE -> box(a, scene.sizeB()[i] * metres);
            case POLYGON -> {
                double[] xy = scene.outline(i);
                Vec2[] vertices = new Vec2[xy.length / 2];
                for (int k = 0; k < vertices.length; k++) {
                    vertices[k] = new Vec2((float) (xy[2 * k] * metres), (float) (xy[2 * k + 1] * metres));
                }
                PolygonShape polygon = new PolygonShape();
                polygon.set(vertices, vertices.length);
                yield polygon;
            }
        };
    }

    private static PolygonShape box(double width, double height) {
        PolygonShape box = new PolygonShape();
        box.setAsBox((float) (width / 2), (float) (height / 2));
        return box;
    }

    @Override
    public void step() {
        world.step(dt, VELOCITY_ITERATIONS, POSITION_ITERATIONS);
    }

    @Override
    public double kineticEnergy() {
        double sum = 0;
        for (Body body : bodies) {
            Vec2 v = body.getLinearVelocity();
            double spin = body.getAngularVelocity();
            sum += 0.5 * body.getMass() * ((double) v.x * v.x + (double) v.y * v.y) + 0.5 * body.getInertia() * spin * spin;
        }
        return sum;
    }

    @Override
    public long bodies() {
        return world.getBodyCount() - 4L;
    }

    @Override
    public double readPoses() {
        double sum = 0;
        for (Body body : bodies) {
            sum += body.getPosition().x + body.getPosition().y + body.getAngle();
        }
        return sum;
    }
}
