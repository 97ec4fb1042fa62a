// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import sim.physics.PhysicsEngine;
import sim.physics.collision.narrow.Distance;
import sim.physics.motion.Body;
import sim.physics.motion.Euler;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.SurfaceFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Anything that a model may do to an engine, drawn from a seed: bodies, forces, coefficients, steps, and changes. */
final class RandomScene {
    /** A force to the origin and one against the motion. */
    private static final class Pull implements ForceGenerator {
        private static final long serialVersionUID = 1L;
        private final double stiffness;
        private final double drag;

        Pull(double stiffness, double drag) {
            this.stiffness = stiffness;
            this.drag = drag;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            double m = body.getMass();
            forces.add(
                    body,
                    -m * (stiffness * body.getX() + drag * body.getVelocityX()),
                    -m * (stiffness * body.getY() + drag * body.getVelocityY()));
            forces.addTorque(body, -drag * body.getInertia() * body.getAngularVelocity());
        }
    }

    /** Counts, and now and then removes a body or adds one in the middle of a step. */
    private final class Meddler implements CollisionListener {
        private static final long serialVersionUID = 1L;
        private final boolean meddles;

        Meddler(boolean meddles) {
            this.meddles = meddles;
        }

        @Override
        public void collided(Contact contact) {
            impactsInStep++;
            if (impactsInStep > LIMIT) {
                throw new IllegalStateException("impacts in one step: " + impactsInStep + " between " + contact);
            }
            if (meddles && random.nextInt(40) == 0) {
                change(contact.a().isFixed() ? contact.b() : contact.a());
            }
        }
    }

    /** From here on a step is as good as endless. */
    static final int LIMIT = 1_000_000;

    final PhysicsEngine engine = new PhysicsEngine();

    /** Whether no force does work on the bodies, so that their energy can only fall. */
    final boolean passive;

    int impactsInStep;
    private final SplittableRandom random;
    private final double half;
    private final boolean changes;
    final double restitution;
    private final double friction;
    private final boolean hasCompounds;

    /**
     * Draws a scene.
     *
     * @param mayDrive whether there may be forces for which bodies need the integrator
     */
    RandomScene(long seed, boolean mayDrive) {
        this(seed, mayDrive, false);
    }

    /** One in which some bodies may have several parts. */
    RandomScene(long seed, boolean mayDrive, boolean hasCompounds) {
        this.hasCompounds = hasCompounds;
        random = new SplittableRandom(seed);
        engine.setTimeStep(1 / (1 + 239 * random.nextDouble() * random.nextDouble()));
        if (random.nextBoolean()) {
            engine.setIntegrator(new Euler());
        }
        restitution = random.nextInt(3) == 0 ? 1 : random.nextInt(3) == 0 ? 0 : random.nextDouble();
        friction = random.nextBoolean() ? 0 : random.nextDouble();
        changes = random.nextInt(3) == 0;
        int bodies = 2 + random.nextInt(24);
        half = 3 * Math.sqrt(bodies) * (1 + random.nextDouble());
        for (int side = -1; side <= 1; side += 2) {
            engine.add(Body.fixed(new Rectangle(2 * half + 4, 2)).at(0, side * (half + 1)));
            engine.add(Body.fixed(new Rectangle(2, 2 * half + 4)).at(side * (half + 1), 0));
        }
        passive = !addForces(mayDrive);
        for (int k = 0; k < bodies; k++) {
            place();
        }
        engine.addListener(new Meddler(changes));
    }

    /** Adds forces; returns whether one may do work. */
    private boolean addForces(boolean mayDrive) {
        boolean work = false;
        if (mayDrive && random.nextInt(2) == 0) {
            engine.add(new SurfaceFriction(0.5 + random.nextDouble()));
        }
        if (random.nextInt(2) == 0) {
            engine.add(new Gravity(5 * signed(), -10 * random.nextDouble()));
            work = true;
        }
        if (mayDrive && random.nextInt(2) == 0) {
            engine.add(new Pull(0.3 * random.nextDouble(), 0.3 * random.nextDouble()));
            work = true;
        }
        return work;
    }

    private double signed() {
        return 2 * random.nextDouble() - 1;
    }

    /** Tries to put a body where it touches nothing. */
    private void place() {
        Shape shape = shape();
        Body body = random.nextInt(8) == 0 ? Body.fixed(shape) : new Body(shape);
        for (int tries = 0; tries < 50; tries++) {
            body.at(half * signed(), half * signed(), 3 * signed());
            if (isFree(engine, body, 1e-3)) {
                if (!body.isFixed()) {
                    body.moving(5 * signed(), 5 * signed(), 3 * signed());
                    body.setMass(shape.area() * StrictMath.pow(10, signed()));
                }
                body.setRestitution(restitution);
                body.setFriction(friction);
                body.setSurfaceFriction(0.3 * random.nextDouble());
                engine.add(body);
                return;
            }
        }
    }

    /** Whether a body is farther than a gap from all of an engine's. */
    static boolean isFree(PhysicsEngine engine, Body body, double gap) {
        Distance distance = new Distance();
        return engine.bodies().stream().allMatch(other -> distance.between(body, other) > gap);
    }

    private Shape shape() {
        double size = 0.3 + 1.2 * random.nextDouble();
        int kind = random.nextInt(hasCompounds ? 8 : 4);
        if (kind >= 4) {
            return compound(kind, size);
        }
        if (kind == 0) {
            return new Circle(size);
        }
        if (kind == 1) {
            return new Rectangle(2 * size, size * (0.2 + 2 * random.nextDouble()));
        }
        int n = 3 + random.nextInt(8);
        double height = size * (0.3 + 0.7 * random.nextDouble());
        double[] angles = new double[n];
        Arrays.setAll(angles, k -> 2 * Math.PI * (k + 0.7 * random.nextDouble()) / n);
        double[] xy = new double[2 * n];
        Arrays.setAll(xy, k -> k % 2 == 0 ? size * StrictMath.cos(angles[k / 2]) : height * StrictMath.sin(angles[k / 2]));
        return new Polygon(xy);
    }

    /** A hook, a cup, a disc with arms, or a star that is cut. */
    private Shape compound(int kind, double size) {
        double thick = size * (0.2 + 0.5 * random.nextDouble());
        double high = size * (0.3 + random.nextDouble());
        if (kind == 4) {
            return Compound.outline(0, 0, 2 * size, 0, 2 * size, thick, thick, thick, thick, thick + high, 0, thick + high);
        }
        if (kind == 5) {
            double leg = size - 0.25 * thick;
            double up = 0.5 * (thick + high);
            return new Compound(
                    Compound.box(0, 0, 2 * size, thick), Compound.box(-leg, up, 0.5 * thick, high), Compound.box(leg, up, 0.5 * thick, high));
        }
        if (kind == 6) {
            return new Compound(
                    Compound.disc(0, 0, size), Compound.box(size + high / 2, size / 2, high, thick / 4), Compound.disc(-size - thick / 2, 0, thick / 2));
        }
        double[] xy = new double[10 + 2 * random.nextInt(6)];
        for (int k = 0; k < xy.length; k += 2) {
            double angle = 2 * Math.PI * (k + random.nextDouble()) / xy.length;
            double radius = size * (k % 4 == 0 ? 1 : 0.4 + 0.4 * random.nextDouble());
            xy[k] = radius * StrictMath.cos(angle);
            xy[k + 1] = radius * StrictMath.sin(angle);
        }
        return Compound.outline(xy);
    }

    private void change(Body body) {
        if (body.isFixed()) {
            return;
        }
        switch (random.nextInt(3)) {
            case 0 -> engine.remove(body);
            case 1 -> body.setVelocity(0.5 * body.getVelocityX(), 0.5 * body.getVelocityY());
            default -> body.setCollisionGroup(2, ~2L);
        }
    }

    /** In some scenes bodies come, go and change between steps. */
    void change() {
        if (changes && random.nextInt(20) == 0) {
            place();
            List<Body> all = new ArrayList<>(engine.bodies());
            change(all.get(random.nextInt(all.size())));
        }
    }

    void step() {
        impactsInStep = 0;
        engine.step();
    }
}
